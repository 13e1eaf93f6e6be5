// Removes movements within a dead band, such as the noise of a displacement channel, from a motion.
#pragma once

#include "isolaw/laws/online/numbers.hpp"

namespace isolaw::laws {

// [export]
// Follows x without its noise, which is taken to stay within +-dead_band. After a turn of x the result rests until x
// has moved by two bands. It then moves one and a half times as fast as x, and equals x again after four more bands.
template <class X>
struct Followed {
  X behind = 0.0, lead = 0.0;  // a point that x pulls along behind it, and the result's distance from that point

  X move(X const& x, double dead_band) {
    X const before = behind;
    behind = max(x - dead_band, min(x + dead_band, behind));
    X const most = 0.5 * abs(behind - before);
    lead += max(-most, min(most, (behind > before ? dead_band : -dead_band) - lead));
    return dead_band > 0.0 ? behind + lead : x;  // without a band the sum would be x, but with a wrong slope at rest
  }
  template <class Each>
  void members(Each& each) {
    each(behind, lead);
  }
};
// [end]

}  // namespace isolaw::laws
