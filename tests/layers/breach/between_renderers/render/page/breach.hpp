#include "isolaw/render/tables/csv.hpp"  // direction.cmake must refuse this: the page must not include the tables
