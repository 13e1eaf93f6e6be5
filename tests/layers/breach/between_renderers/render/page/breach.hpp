#include "isolaw/render/tables/csv.hpp"  // the page must not know the tables: direction.cmake has to refuse this
