#include "isolaw/fit/box.hpp"  // direction.cmake must refuse this: a law must not include the fit
