// A swing is the way of a motion from one turning point to the next. In an irregular record, samples can be weighted by
// their swing. A large, rare swing then counts more than the small motion that fills most of the time.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace isolaw::data {

struct Swing {
  std::size_t first = 0, last = 0;  // samples at its two turning points
  double half_range_mm = 0.0;
  double duration = 0.0;  // without rests, in s; in samples if the record has no time
};

// A sample is a turning point if the motion comes back from it by 5 % of half its range. If several equal samples form
// the extreme, the first is the turning point. The first and the last sample of a record are never turning points. A
// motion with fewer than two turning points has no swings. The motion rests while it stays within 1 % of its range for
// longer than the median swing lasts. A rest is left out of Swing::duration if it takes more than a quarter of the
// swing. time_s may be empty.
std::vector<Swing> swings(std::span<double const> disp_mm, std::span<double const> time_s);

// Whether half ranges and durations of the swings differ by at most 10 %. Weights by swing then resemble weights by
// time.
bool are_alike(std::span<Swing const> swings);

// How much the samples of a record count in the misfit of a law.
//   time    the time around the sample, as in Eq. (27) of Cucuzza et al. 2025
//   swing   the time around it, without rest, times half range / duration of its swing; 0 outside all swings
//   travel  the distance moved around the sample
enum class Weighting { time, swing, travel };
std::string_view name(Weighting weighting);

// The weights of a record's samples, to an arbitrary scale. If there are no swings, Weighting::swing gives the weights
// of Weighting::time.
std::vector<double> sample_weights(std::span<double const> disp_mm, std::span<double const> time_s,
                                   Weighting weighting);
// The weights that sample_weights() gives if only the intervals within the swings `some` count.
std::vector<double> weights_within(std::span<Swing const> some, std::span<double const> disp_mm,
                                   std::span<double const> time_s, Weighting weighting);

}  // namespace isolaw::data
