// Removes movements within a dead band, such as the noise of a displacement channel, from a motion.
#pragma once

#include "isolaw/laws/online/numbers.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// Follows x without its noise, which is taken to stay within +-dead_band. After a turn of x the result rests until x
// has moved by two bands. It then moves one and a half times as fast as x, and equals x again after four more bands.
template <class X>
struct Followed {
  // `pulled` is a point that x pulls along, never farther from x than dead_band. `lead` is the result minus this point.
  X pulled = 0.0, lead = 0.0;

  X move(X const& x, double dead_band) {
    X const before = pulled;
    pulled = max(x - dead_band, min(x + dead_band, pulled));
    X const most = 0.5 * abs(pulled - before);
    lead += max(-most, min(most, (pulled > before ? dead_band : -dead_band) - lead));
    // Without a dead band the sum would have the value of x, but at rest a wrong derivative.
    return dead_band > 0.0 ? pulled + lead : x;
  }
  template <class Each>
  void members(Each& each) {
    each(pulled, lead);
  }
};
// [end]

}  // namespace isolaw::laws
