#include "isolaw/data/signals/clipping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// A plateau is a run of samples at the top (or bottom) of a channel that keep one level. The depth of a plateau is the
// height that clipping would have cut off the peak. The half range of a channel is half the difference between its
// largest and smallest value. The limits below say which plateaus count as clipping.

// Limits for clipped displacement:
constexpr std::size_t least_plateau = 3;   // fewest samples of a plateau of displacement; a plateau of force has more
constexpr std::size_t least_evidence = 9;  // fewest samples, in all plateaus together at one end of the range
// The depth of a plateau exceeds this fraction of the half range of displacement.
constexpr double least_depth = 0.001;
// The depth exceeds this many steps of the digitiser, because rounding to these steps makes a plateau of a smooth peak.
constexpr double depth_quanta = 2.5;
// The samples of a plateau lie at most this many standard deviations of the noise below the channel's highest sample.
constexpr double noise_width = 7.0;
// The hump (see Plateau) of a noisy plateau is below least_flatness times the hump of a smooth peak. The hump of a
// smooth peak is flat_thirds times the depth.
constexpr double least_flatness = 0.5;
constexpr double flat_thirds = 0.197;
// The device moves on beyond the plateau's level, so its force turns: Plateau::turn exceeds this fraction of the
// stiffness times the depth.
constexpr double least_turn = 0.08;
// A sine slows down before its peak: just before a plateau its speed is below this fraction of the fastest speed within
// the last half cycle.
constexpr double slower = 0.85;
// The plateau lasts less than this fraction of half a cycle. A longer one may be a hold of the rig.
constexpr double short_plateau = 0.24;

// Limit for clipped force:
// The force stays level although displacement comes back from its peak by more than this fraction of the half range of
// displacement.
constexpr double past_the_tip = 0.006;

// Limits for clipped force in noise. All plateaus have one level in common, at which the force was clipped.
// A sample of a plateau lies at most this many standard deviations of the noise off the level.
constexpr double top_deviations = 4.0;
// The way of displacement from a plateau's start to its peak is cut into thirds. All plateaus together have at least
// this many samples in each third.
constexpr double least_third = 4.0;
// The slope of force over displacement is taken in two adjacent windows of displacement before a plateau. A window's
// length is at most most_window, and more than least_window, times the half range of displacement.
constexpr double most_window = 0.2;
constexpr double least_window = 0.01;
// The depth exceeds this fraction of the half range of force.
constexpr double least_cut = 0.01;
// The mean forces in the three thirds (see least_third) differ by less than this fraction of the depth.
constexpr double most_uneven = 0.15;
// The mean force of a plateau is off the level by at most this fraction of the level, beyond what noise explains.
constexpr double same_level = 0.002;
// A clipped force stays level until displacement has come back from its peak by the depth divided by the slope after
// the plateau. During the plateaus, displacement comes back, on average, by more than this fraction of that distance.
constexpr double least_return = 0.12;
// The force rises evenly up to a plateau: the slope in the far window is at most this many times the slope in the
// window next to the plateau. While a device yields, the slope falls.
constexpr double most_bend = 1.5;
// A plateau begins at a corner. There are three slopes: `before` in the far window, `near` in the window next to the
// plateau and `flat` on the plateau. At a corner, near^2 / (before * flat) exceeds this number. Without a corner the
// slopes fall by equal factors, and this ratio is 1.
constexpr double least_corner = 5.0;

// For clipped_force(): while the force stays level, displacement comes back by more than this fraction of its way from
// the plateau's start to its peak. If it comes back by less, the force is not clipped but recorded a little late.
constexpr double least_back = 0.1;

class Clipping {
 public:
  explicit Clipping(SignalPair const& pair) : pair_(pair) {}

  std::vector<SignalFault> find() {
    for (double const sign : {1.0, -1.0}) clipped_displacement(sign);
    for (double const sign : {1.0, -1.0})
      if (!clipped_force(sign)) clipped_force_in_noise(sign);
    return std::move(found_);
  }

 private:
  void add(std::string const& channel, std::string_view unit, std::vector<std::size_t> const& first, double level,
           std::size_t longest) {
    found_.push_back(standing_fault(FaultKind::clipped, channel, unit, first, pair_.time, level, longest));
  }
  static std::vector<SampleRange> plateaus(Signal const& signal, double sign, double width) {
    std::vector<SampleRange> runs;
    double level = -std::numeric_limits<double>::infinity();
    for (double const value : signal.x) level = std::max(level, sign * value);
    for (std::size_t i = 0; i < signal.x.size(); ++i) {
      if (sign * signal.x[i] < level - width) continue;
      if (runs.empty() || runs.back().last + 1 != i) runs.push_back({.first = i, .last = i});
      runs.back().last = i;
    }
    std::erase_if(runs, [](SampleRange const& run) { return run.size() < least_plateau; });
    return runs;
  }

  // Estimates the height that a plateau cuts off a peak. For a parabola it is an eighth of the fall within one
  // plateau's length beside the plateau. For a triangle the true height is four times this estimate.
  std::optional<double> depth_of(Signal const& signal, double sign, SampleRange const& run) const {
    auto const reach = std::min(run.size(), std::max<std::size_t>(1, pair_.half_cycle / 4));
    double sum = 0.0, count = 0.0;
    double const level = mean_of(signal.x, run.first, run.last + 1);
    if (run.first >= reach) sum += sign * (level - signal.x[run.first - reach]), count += 1.0;
    if (run.last + reach < signal.x.size()) sum += sign * (level - signal.x[run.last + reach]), count += 1.0;
    return count > 0.0 ? std::optional(sum / count / 8.0) : std::nullopt;
  }

  void clipped_displacement(double sign) {
    if (!clipped_within(sign, same_value * 2.0 * pair_.disp.half_range, true))
      clipped_within(sign, std::max(noise_width * pair_.disp.noise, 2.2 * pair_.disp.quantum), false);
  }

  SampleRange whole(double sign, SampleRange run) const {
    double const low =
        sign * pair_.disp.x[run.first] - std::max(noise_width * pair_.disp.noise, 3.0 * pair_.disp.quantum);
    while (run.first > 0 && sign * pair_.disp.x[run.first - 1] >= low) --run.first;
    while (run.last + 1 < pair_.size() && sign * pair_.disp.x[run.last + 1] >= low) ++run.last;
    return run;
  }

  // A plateau of displacement, measured without its first and last sixth, in which the device may still move. `hump` is
  // the mean displacement of the middle third minus the mean of the outer thirds, and `turn` is this difference for the
  // force. White noise of variance 1 in a channel gives the difference the variance `variance`.
  struct Plateau {
    SampleRange run;
    double depth = 0.0, hump = 0.0, turn = 0.0, range = 0.0, variance = 0.0;
  };

  Plateau measure(double sign, SampleRange const& run, double depth) const {
    auto const inner = run.size() - 2 * (run.size() / 6);
    auto const third = std::max<std::size_t>(1, inner / 3);
    auto const begin = run.first + run.size() / 6, end = begin + inner;
    auto const bulge = [&](std::vector<double> const& x) {
      double const ends = (mean_of(x, begin, begin + third) + mean_of(x, end - third, end)) / 2.0;
      return sign * (mean_of(x, begin + third, end - third) - ends);
    };
    auto const [least, largest] = std::ranges::minmax(std::span(pair_.force.x).subspan(begin, inner));
    return {.run = run,
            .depth = depth,
            .hump = bulge(pair_.disp.x),
            .turn = bulge(pair_.force.x),
            .range = largest - least,
            .variance = 1.0 / static_cast<double>(inner - 2 * third) + 0.5 / static_cast<double>(third)};
  }

  bool slows_before(std::vector<Plateau> const& runs) const {
    auto const lag = std::max<std::size_t>(2, pair_.half_cycle / 24);
    std::vector<double> ratios;
    for (auto const& plateau : runs) {
      auto const first = plateau.run.first;
      if (first < 2 * lag + 1) continue;
      auto const way = [&](std::size_t i) { return std::abs(pair_.disp.x[i] - pair_.disp.x[i - lag]); };
      double fastest = 0.0;
      for (auto i = std::max(lag, first - std::min(first, pair_.half_cycle)); i < first; ++i)
        fastest = std::max(fastest, way(i));
      // Uses only samples before the plateau, because clipping may shorten the step to the plateau's first sample.
      ratios.push_back(way(first - 1) / fastest);
    }
    return !ratios.empty() && num::median(std::move(ratios)) < slower;
  }

  bool clipped_within(double sign, double width, bool exact) {
    std::vector<Plateau> runs;
    std::size_t longest = 0;
    double const deep = std::max(least_depth * pair_.disp.half_range, depth_quanta * pair_.disp.quantum);
    for (auto const& run : plateaus(pair_.disp, sign, width)) {
      auto const depth = depth_of(pair_.disp, sign, run);
      if (!depth || !(*depth > deep) || (!runs.empty() && runs.back().run.last >= run.last)) continue;
      auto const found = measure(sign, whole(sign, run), *depth);
      // A plateau at an end of the record is left out, because the device may rest there.
      if (found.run.first == 0 || found.run.last + 1 == pair_.size()) continue;
      double const humped = least_flatness / 2.0 * flat_thirds * *depth;
      if (!exact && found.hump - 2.0 * pair_.disp.noise * std::sqrt(found.variance) > humped) continue;
      longest = std::max(longest, run.size());
      runs.push_back(found);
    }
    std::size_t samples = 0;
    for (auto const& plateau : runs) samples += plateau.run.size();
    if (samples < least_evidence) return false;
    auto const count = static_cast<double>(runs.size());
    auto const mean = [&](auto member) {
      double sum = 0.0;
      for (auto const& plateau : runs) sum += std::invoke(member, plateau);
      return sum / count;
    };
    double const shared = std::sqrt(mean(&Plateau::variance) / count), depth = num::median_over(runs, &Plateau::depth);
    double const hump = mean(&Plateau::hump), turn = mean(&Plateau::turn);
    if (!exact && hump + 3.0 * pair_.disp.noise * shared > least_flatness * flat_thirds * depth) return false;
    double const wanted = least_turn * pair_.stiffness() * depth;
    bool const clear = 3.0 * pair_.force.noise * shared < wanted;
    double const length = mean([](Plateau const& plateau) { return static_cast<double>(plateau.run.size()); });
    bool const no_hold = length + 1.0 < short_plateau * static_cast<double>(pair_.half_cycle);
    bool const reversed = num::median_over(runs, &Plateau::range) > most_of_force * 2.0 * pair_.force.half_range;
    // If noise hides a turn of the force, a short plateau still counts as clipped in two cases: if the motion slows
    // down before it, as in a sine, or if a noisy displacement becomes exactly constant. After a straight ramp, the
    // plateau may be a hold.
    bool const cut = no_hold && (slows_before(runs) || (exact && pair_.has_noise(pair_.disp)));
    if (!(reversed || (clear ? turn > wanted : cut))) return false;
    std::vector<std::size_t> first;
    for (auto const& plateau : runs) first.push_back(plateau.run.first);
    auto const& shown = runs.front().run;
    add("displacement", "mm", first,
        num::median(std::span(pair_.disp.x).subspan(shown.first, shown.last + 1 - shown.first)), longest);
    return true;
  }

  // Whether force leaves a plateau because the motion turns. A clipped force would have gone on rising with the slope
  // `into` until the motion turns. It would come back to the level of the plateau, with the slope `leaves`, only after
  // displacement has returned by `expected`. If displacement has not done so six samples after the turn, but the force
  // has left the plateau, the force is not clipped.
  bool turns_with_motion(double sign, SampleRange const& run, double into, double leaves) const {
    auto const x = [&](std::size_t i) { return sign * pair_.disp.x[i]; };
    auto tip = run.first;
    for (auto i = run.first; i <= run.last; ++i)
      if (x(i) > x(tip)) tip = i;
    double const expected = into * (x(tip) - x(run.first)) / leaves;
    bool const told = expected > std::max(32.0 * pair_.disp.noise, 3.0 * pair_.disp.quantum);
    auto const later = std::min(tip + 6, pair_.size() - 1);
    // False if displacement goes on rising after the plateau: the motion has not turned yet. This may be the force of a
    // viscous device, which falls before the motion turns.
    bool const is_turn = x(run.last + 1) <= x(tip);
    return told && is_turn && run.last <= tip + 1 && x(tip) - x(later) < expected;
  }

  // Whether force leaves its plateaus much more steeply than it reaches them, and not where the motion turns. In a
  // yielding device both slopes agree, or the force turns with the motion.
  bool is_cut_off(double sign, std::vector<SampleRange> const& runs) const {
    auto const reach = std::max<std::size_t>(3, pair_.half_cycle / 24);
    std::vector<double> ratios, into;
    std::size_t turning = 0;
    for (auto const& run : runs) {
      if (run.size() <= least_plateau || run.first < reach || run.last + reach >= pair_.size()) continue;
      auto const slope = [&](std::size_t from, std::size_t to) {
        return std::abs(pair_.force.x[to] - pair_.force.x[from]) /
               std::max(std::abs(pair_.disp.x[to] - pair_.disp.x[from]), 1e-6 * pair_.disp.half_range);
      };
      // The steeper of two slopes before the plateau counts. One ends at the last sample before the plateau. The other
      // is the step from there to the plateau: a yielding device may rise to its plateau in this step, and clipping
      // never makes the step steeper.
      into.push_back(std::max(slope(run.first - reach, run.first - 1), slope(run.first - 1, run.first)));
      double const leaves = std::max(slope(run.last, run.last + reach), 1e-12);
      ratios.push_back(into.back() / leaves);
      if (turns_with_motion(sign, run, slope(run.first - reach, run.first - 1), leaves)) ++turning;
      double const clear = std::max(3.0 * pair_.force.quantum, 6.0 * pair_.force.noise);
      if (std::abs(pair_.force.x[run.first - 1] - pair_.force.x[run.first - reach]) < clear) into.back() = 0.0;
    }
    return ratios.size() > 2 * turning && num::median(into) > 0.1 * pair_.stiffness() && num::median(ratios) < 0.4;
  }

  bool clipped_force(double sign) {
    auto const runs = plateaus(pair_.force, sign, same_value * 2.0 * pair_.force.half_range);
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    double const least = std::max({past_the_tip * pair_.disp.half_range,
                                   depth_quanta * pair_.force.quantum / pair_.stiffness(), 8.0 * pair_.disp.noise});
    bool const noisy = pair_.has_noise(pair_.force);
    bool const cut = is_cut_off(sign, runs);
    for (auto const& run : runs) {
      if (run.size() <= least_plateau) continue;
      auto const begin = pair_.disp.x.begin() + static_cast<std::ptrdiff_t>(run.first);
      auto const end = pair_.disp.x.begin() + static_cast<std::ptrdiff_t>(run.last) + 1;
      auto const tip = sign > 0.0 ? std::max_element(begin, end) : std::min_element(begin, end);
      double const back = sign * (*tip - pair_.disp.x[run.last]), way = sign * (*tip - pair_.disp.x[run.first]);
      bool const returns = back > std::max(least, least_back * way) && end - tip > 2;
      bool const moves = *std::max_element(begin, end) - *std::min_element(begin, end) > least;
      bool const repeats = noisy && run.size() > least_plateau + 1 && moves;
      // A coarse digitiser makes a plateau of a smooth peak too, but cuts very little off the peak.
      bool const deep = depth_of(pair_.force, sign, run).value_or(0.0) > depth_quanta * pair_.force.quantum;
      if (!repeats && !(deep && ((cut && moves) || (returns && tip != begin)))) continue;
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    }
    if (first.empty()) return false;
    add("force", "kN", first, pair_.force.x[first.front()], longest);
    return true;
  }

  struct Tops {
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    // All numbers below are sums over the plateaus. Displacement is in mm and force in kN, both positive towards the
    // plateaus. Way of displacement from a plateau's start to its peak, and from there back to the plateau's end.
    double way = 0.0, returned = 0.0;
    // Two windows, each about `window` mm of displacement wide, lie one after the other before a plateau. The force rises
    // by `rise` in the window that ends at the plateau and by `rise_before` in the earlier one, both scaled to `window`.
    double rise_before = 0.0, rise = 0.0, window = 0.0;
    // Rise of force, and way of displacement, over the step to a plateau's first sample.
    double rise_last = 0.0, last_way = 0.0;
    // Fall of force below the level, and way back of displacement, within 1, 2, 4 and half_cycle / 24 samples after a
    // plateau.
    std::array<double, 4> drop{}, drop_way{};
    // For each third of `way`: force minus level, added over the samples there, and the number of these samples.
    std::array<double, 3> third{};
    std::array<double, 3> samples{};
    double off_level = 0.0;  // number of plateaus whose mean force differs from the level of all plateaus
  };

  double top_level(double sign, double noise) const {
    double level = -std::numeric_limits<double>::infinity();
    for (double const value : pair_.force.x) level = std::max(level, sign * value);
    level -= top_deviations * noise;
    for (int pass = 0; pass < 4; ++pass) {
      std::vector<double> members;
      for (double const value : pair_.force.x)
        if (sign * value >= level - top_deviations * noise) members.push_back(sign * value);
      level = num::median(std::move(members));
    }
    return level;
  }

  // Returns the plateaus in which the force is above `low`. One or two samples below `low` may be noise and do not end
  // a plateau.
  std::vector<SampleRange> tops_of(double sign, double low) const {
    constexpr std::size_t bridged = 2;
    std::vector<SampleRange> runs;
    for (std::size_t i = 0; i < pair_.size(); ++i) {
      if (sign * pair_.force.x[i] < low) continue;
      if (runs.empty() || i - runs.back().last > bridged + 1) runs.push_back({.first = i, .last = i});
      runs.back().last = i;
    }
    std::erase_if(runs, [](SampleRange const& run) { return run.size() <= least_plateau; });
    return runs;
  }

  void add_top(double sign, double level, double noise, SampleRange const& run, Tops& tops) const {
    auto const next = std::ranges::lower_bound(pair_.turns, run.first);
    if (next == pair_.turns.begin() || next == pair_.turns.end() || *next > run.last + 1) return;
    auto const before = *(next - 1), tip = std::min(*next, run.last);
    auto const reach = std::max<std::size_t>(3, pair_.half_cycle / 24);
    if (run.last + reach >= pair_.size()) return;
    auto const x = [&](std::size_t i) { return sign * pair_.disp.x[i]; };
    auto const y = [&](std::size_t i) { return sign * pair_.force.x[i]; };
    double const way = x(tip) - x(run.first);
    double const window = std::min({way / 2.0, most_window * pair_.disp.half_range, (x(run.first) - x(before)) / 2.0});
    if (!(window > std::max(least_window * pair_.disp.half_range, 8.0 * pair_.disp.noise))) return;
    auto near = run.first, far = run.first;
    while (near > before && (x(near) > x(run.first) - window || run.first - near < 2)) --near;
    far = near;
    while (far > before && (x(far) > x(near) - window || near - far < 2)) --far;
    if (far == before) return;
    tops.first.push_back(run.first);
    tops.longest = std::max(tops.longest, run.size());
    tops.way += way;
    tops.returned += std::max(0.0, x(tip) - x(run.last));
    // Assumes the corner halfway between two samples, so that coarse sampling does not bias the slope before a plateau.
    double const corner = (x(run.first) + x(run.first - 1)) / 2.0;
    tops.rise += (level - top_deviations * noise - y(near)) / std::max(corner - x(near), window / 4.0) * window;
    tops.rise_before += (y(near) - y(far)) / (x(near) - x(far)) * window;
    tops.window += window;
    tops.rise_last += y(run.first) - y(run.first - 1);
    tops.last_way += x(run.first) - x(run.first - 1);
    std::array<std::size_t, 4> const lags{1, 2, 4, reach};
    for (std::size_t k = 0; k < lags.size(); ++k) {
      auto const after = std::min(run.last + lags[k], pair_.size() - 1);
      tops.drop[k] += level - y(after);
      tops.drop_way[k] += x(run.last) - x(after);
    }
    double sum = 0.0;
    for (auto i = run.first + 1; i <= tip; ++i) {
      auto const part = static_cast<std::size_t>(std::clamp(3.0 * (x(i) - x(run.first)) / way, 0.0, 2.0));
      tops.third[part] += y(i) - level;
      tops.samples[part] += 1.0;
      sum += y(i) - level;
    }
    auto const count = static_cast<double>(tip - run.first);
    if (std::abs(sum) > top_deviations * noise * std::sqrt(count) + same_level * level * count) tops.off_level += 1.0;
  }

  // Finds a clipped force if noise hides that its level is constant. A clipped force reaches its level at a corner,
  // keeps this level beyond the reversal of motion and then drops more steeply than the force of a yielding device.
  void clipped_force_in_noise(double sign) {
    for (double const wider : {1.0, 3.0}) {
      double const noise = wider * std::hypot(pair_.force.noise, 0.3 * pair_.force.quantum);
      double const level = top_level(sign, noise);
      Tops tops;
      for (auto const& run : tops_of(sign, level - top_deviations * noise)) add_top(sign, level, noise, run, tops);
      if (!is_clipped(tops, noise)) continue;
      add("force", "kN", tops.first, sign * level, tops.longest);
      return;
    }
  }

  bool is_clipped(Tops const& tops, double noise) const {
    auto const count = static_cast<double>(tops.first.size());
    if (count == 0.0 || *std::ranges::min_element(tops.samples) < least_third) return false;
    if (tops.off_level > count / 4.0) return false;
    double slope = tops.rise / tops.window, slope_before = tops.rise_before / tops.window;
    double leaves = 0.0;
    double const unsure = 4.0 * pair_.disp.noise * std::sqrt(2.0 * count) + 1e-3 * pair_.disp.half_range * count;
    for (std::size_t k = 0; k < tops.drop.size(); ++k)
      if (tops.drop[k] > 2.0 * top_deviations * noise * count)
        leaves = std::max(leaves, tops.drop[k] / std::max(tops.drop_way[k], unsure));
    double const depth = slope * tops.way / count;
    auto const [lowest, highest] = std::ranges::minmax(
        std::array{tops.third[0] / tops.samples[0], tops.third[1] / tops.samples[1], tops.third[2] / tops.samples[2]});
    double const uneven = highest - lowest + 2.0 * noise * std::sqrt(2.0 / *std::ranges::min_element(tops.samples));
    if (!(depth > std::max(least_cut * pair_.force.half_range, 4.0 * noise) && uneven < most_uneven * depth))
      return false;
    double const flat = uneven / (tops.way / count);
    bool const corner = slope > 0.1 * pair_.stiffness() && slope_before > 0.3 * slope &&
                        slope_before < most_bend * slope && slope * slope > least_corner * slope_before * flat;
    if (!corner) return false;
    double const back = tops.returned / tops.way;
    if (back > 0.25 && tops.way < 0.6 * pair_.disp.half_range * count) return true;
    double const last = (tops.rise_last - top_deviations * noise * std::sqrt(2.0 * count)) /
                        std::max(tops.last_way, 1e-3 * pair_.disp.half_range * count);
    if (!(std::max({slope, slope_before, last}) < 0.4 * leaves)) return false;
    // A force that is cut off by `depth` stays level until displacement has come back by `expected`. If `expected` is
    // so small that noise may hide the return, no return is required.
    double const expected = depth / leaves;
    double const told = std::max(8.0 * pair_.disp.noise, past_the_tip * pair_.disp.half_range);
    return expected < 2.0 * told || tops.returned / count > least_return * expected;
  }

  SignalPair const& pair_;
  std::vector<SignalFault> found_;
};

}  // namespace

std::vector<SignalFault> clipped_channels(SignalPair const& pair) {
  return Clipping(pair).find();
}

}  // namespace isolaw::data
