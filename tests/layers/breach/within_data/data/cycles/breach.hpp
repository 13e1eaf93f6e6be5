#include "isolaw/data/signals/spikes.hpp"  // direction.cmake must refuse this: cycles must not include the signals
