#include "isolaw/fit/box.hpp"  // a law must not know the fit: direction.cmake has to refuse this
