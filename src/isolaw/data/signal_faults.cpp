#include "isolaw/data/signal_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "isolaw/data/cycles.hpp"
#include "isolaw/data/spikes.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// --- plateaus and stretches -----------------------------------------------------------------------------------------

constexpr double same_value = 1e-9;        // of the range
constexpr std::size_t least_plateau = 3;   // samples
constexpr std::size_t least_evidence = 9;  // samples on all plateaus of one side
constexpr double least_depth = 0.001;      // of the half range, that a plateau cuts off
constexpr double depth_quanta = 2.5;
constexpr double noise_width = 7.0;       // standard deviations, from top to bottom of a noisy plateau
constexpr double least_flatness = 0.5;    // of the hump that a parabola of the flanks would have on a noisy plateau
constexpr double flat_thirds = 0.197;     // that hump: middle less outer thirds of two thirds of it, of the depth
constexpr double least_turn = 0.08;       // of the force that the depth stands for: its turn within a plateau
constexpr double short_plateau = 0.24;    // of half a cycle: no hold is as short
constexpr std::size_t least_stretch = 4;  // samples
constexpr double least_missed = 0.02;     // of the half range
constexpr double missed_quanta = 4.0;
constexpr double least_jump = 2.0;      // times what the motion makes of a sampling interval
constexpr double least_advance = 0.1;   // of what the motion missed would make of the force
constexpr double most_of_force = 0.6;   // of its range, that no hold relaxes by
constexpr double most_stretches = 0.3;  // of the samples: more are how a slow channel is written
constexpr double past_the_tip = 0.006;  // of the amplitude: clipped force lasts beyond the reversal
constexpr double top_deviations = 4.0;  // of the noise: no sample of a plateau in noise is farther from its level
constexpr double least_third = 4.0;     // samples in each third of all plateaus in noise
constexpr double most_window = 0.2;     // of the half range: the way before a plateau in noise that is looked at
constexpr double least_window = 0.01;
constexpr double least_cut = 0.01;     // of the half range of force, that a plateau in noise cuts off
constexpr double most_uneven = 0.15;   // of that, from third to third of it
constexpr double same_level = 0.002;   // of the level
constexpr double least_return = 0.12;  // of what the way out says that displacement comes back by on the plateau
constexpr double most_bend = 1.5;      // of the slope before such a plateau, from window to window
constexpr double least_corner = 5.0;   // slopes that fall by one factor from window to window come to 1
constexpr double least_back = 0.1;     // of the way to the tip: less is force recorded late
constexpr double force_stands = 0.05;  // of the half range of displacement
constexpr double one_signed = 0.02;    // of the range: a channel without its sign hardly leaves zero
constexpr double clear_force = 0.3;    // of the largest, at a peak

struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t size() const { return last - first + 1; }
};

double half_range_of(std::span<double const> x) {
  auto const [least, largest] = std::ranges::minmax(x);
  return largest / 2.0 - least / 2.0;
}

// --- one record -----------------------------------------------------------------------------------------------------

struct Signal {
  std::vector<double> x;
  double half_range = 0.0;
  double quantum = 0.0;
  double noise = 0.0;
};

Signal signal_of(std::span<double const> values, std::vector<Spike> const& off) {
  Signal made{.x = {values.begin(), values.end()}};
  for (auto const& spike : off) made.x[spike.at] = spike.expected;
  made.half_range = half_range_of(made.x);
  made.quantum = smallest_step(made.x, 2.0 * made.half_range);
  made.noise = noise_deviation(made.x);
  return made;
}

double mean_of(std::span<double const> x, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (auto i = begin; i < end; ++i) sum += x[i];
  return sum / static_cast<double>(end - begin);
}

class Record {
 public:
  Record(std::span<double const> disp, std::span<double const> force, std::span<double const> time)
      : raw_disp_(disp), raw_force_(force), time_(time) {}

  std::vector<SignalFault> find() {
    std::size_t constexpr fewest = 16;
    if (raw_disp_.size() < fewest) return {};
    auto const of_disp = spikes(raw_disp_);
    auto of_force = spikes(raw_force_);
    disp_ = signal_of(raw_disp_, of_disp);
    force_ = signal_of(raw_force_, of_force);
    if (!(disp_.half_range > 0.0 && force_.half_range > 0.0) || !std::isfinite(disp_.half_range + force_.half_range))
      return {};
    auto const turns = reversals(disp_.x).at;
    turns_ = turns;
    half_cycle_ = turns.size() < 3 ? disp_.x.size() : median_distance(turns);
    if (!time_.empty()) {
      std::vector<double> intervals;
      for (std::size_t i = 1; i < time_.size(); ++i) intervals.push_back(time_[i] - time_[i - 1]);
      interval_ = num::median(intervals);
    }
    rectified();
    clipped_displacement(1.0);
    clipped_displacement(-1.0);
    for (double const sign : {1.0, -1.0})
      if (!clipped_force(sign)) clipped_force_in_noise(sign);
    stuck_displacement();
    stuck_force();
    std::erase_if(of_force, [&](Spike const& spike) { return is_of_every_turn(spike, of_force, raw_force_, turns_); });
    name_spikes("displacement", "mm", of_disp);
    name_spikes("force", "kN", of_force);
    return std::move(found_);
  }

 private:
  static std::size_t median_distance(std::vector<std::size_t> const& turns) {
    std::vector<double> distances;
    for (std::size_t k = 1; k < turns.size(); ++k) distances.push_back(static_cast<double>(turns[k] - turns[k - 1]));
    return std::max<std::size_t>(4, static_cast<std::size_t>(num::median(distances)));
  }
  std::size_t size() const { return disp_.x.size(); }
  double stiffness() const { return force_.half_range / disp_.half_range; }
  bool gap_after(std::size_t i) const {
    constexpr double longer = 3.0;
    return !time_.empty() && i + 1 < time_.size() && time_[i + 1] - time_[i] > longer * interval_;
  }
  void add(FaultKind kind, std::string channel, std::vector<std::size_t> samples, std::string sentence) {
    found_.push_back(
        {.kind = kind, .channel = std::move(channel), .samples = std::move(samples), .sentence = std::move(sentence)});
  }
  std::string at(std::vector<std::size_t> const& samples) const { return sample_text(samples, time_); }

  // Stretches of samples within `width` below the largest value of sign * x.
  static std::vector<Run> plateaus(Signal const& signal, double sign, double width) {
    std::vector<Run> runs;
    double level = -std::numeric_limits<double>::infinity();
    for (double const value : signal.x) level = std::max(level, sign * value);
    for (std::size_t i = 0; i < signal.x.size(); ++i) {
      if (sign * signal.x[i] < level - width) continue;
      if (runs.empty() || runs.back().last + 1 != i) runs.push_back({.first = i, .last = i});
      runs.back().last = i;
    }
    std::erase_if(runs, [](Run const& run) { return run.size() < least_plateau; });
    return runs;
  }

  // How much of a parabola a plateau cuts off, from the flanks as far away as it is long; of a triangle four times as
  // much.
  std::optional<double> depth_of(Signal const& signal, double sign, Run const& run) const {
    auto const reach = std::min(run.size(), std::max<std::size_t>(1, half_cycle_ / 4));
    double sum = 0.0, count = 0.0;
    double const level = mean_of(signal.x, run.first, run.last + 1);
    if (run.first >= reach) sum += sign * (level - signal.x[run.first - reach]), count += 1.0;
    if (run.last + reach < signal.x.size()) sum += sign * (level - signal.x[run.last + reach]), count += 1.0;
    return count > 0.0 ? std::optional(sum / count / 8.0) : std::nullopt;
  }

  void clipped_displacement(double sign) {
    if (!clipped_within(sign, same_value * 2.0 * disp_.half_range, true))
      clipped_within(sign, std::max(noise_width * disp_.noise, 2.2 * disp_.quantum), false);
  }

  // A plateau with what noise and steps of the digitiser break it up into.
  Run whole(double sign, Run run) const {
    double const low = sign * disp_.x[run.first] - std::max(noise_width * disp_.noise, 3.0 * disp_.quantum);
    while (run.first > 0 && sign * disp_.x[run.first - 1] >= low) --run.first;
    while (run.last + 1 < size() && sign * disp_.x[run.last + 1] >= low) ++run.last;
    return run;
  }

  // What is measured on a plateau, without its first and last sixth, which may still be motion: middle third less the
  // outer ones, of displacement and force, and the variance of that in white noise of one.
  struct Plateau {
    Run run;
    double depth = 0.0, hump = 0.0, turn = 0.0, range = 0.0, variance = 0.0;
  };

  Plateau measure(double sign, Run const& run, double depth) const {
    auto const inner = run.size() - 2 * (run.size() / 6);
    auto const third = std::max<std::size_t>(1, inner / 3);
    auto const begin = run.first + run.size() / 6, end = begin + inner;
    auto const bulge = [&](std::vector<double> const& x) {
      double const ends = (mean_of(x, begin, begin + third) + mean_of(x, end - third, end)) / 2.0;
      return sign * (mean_of(x, begin + third, end - third) - ends);
    };
    auto const [least, largest] = std::ranges::minmax(std::span(force_.x).subspan(begin, inner));
    return {.run = run,
            .depth = depth,
            .hump = bulge(disp_.x),
            .turn = bulge(force_.x),
            .range = largest - least,
            .variance = 1.0 / static_cast<double>(inner - 2 * third) + 0.5 / static_cast<double>(third)};
  }

  bool clipped_within(double sign, double width, bool exact) {
    std::vector<Plateau> runs;
    std::size_t longest = 0;
    double const deep = std::max(least_depth * disp_.half_range, depth_quanta * disp_.quantum);
    for (auto const& run : plateaus(disp_, sign, width)) {
      auto const depth = depth_of(disp_, sign, run);
      if (!depth || !(*depth > deep) || (!runs.empty() && runs.back().run.last >= run.last)) continue;
      auto const found = measure(sign, whole(sign, run), *depth);
      if (found.run.first == 0 || found.run.last + 1 == size()) continue;  // a rest at one end of the record
      double const humped = least_flatness / 2.0 * flat_thirds * *depth;
      if (!exact && found.hump - 2.0 * disp_.noise * std::sqrt(found.variance) > humped) continue;
      longest = std::max(longest, run.size());
      runs.push_back(found);
    }
    std::size_t samples = 0;
    for (auto const& plateau : runs) samples += plateau.run.size();
    if (samples < least_evidence) return false;
    // Above its ends the force is in the middle of plateaus on which it turned.
    auto const count = static_cast<double>(runs.size());
    auto const mean = [&](auto member) {
      double sum = 0.0;
      for (auto const& plateau : runs) sum += std::invoke(member, plateau);
      return sum / count;
    };
    double const shared = std::sqrt(mean(&Plateau::variance) / count), depth = num::median_over(runs, &Plateau::depth);
    double const hump = mean(&Plateau::hump), turn = mean(&Plateau::turn);
    if (!exact && hump + 3.0 * disp_.noise * shared > least_flatness * flat_thirds * depth) return false;
    double const wanted = least_turn * stiffness() * depth;
    bool const clear = 3.0 * force_.noise * shared < wanted;
    double const length = mean([](Plateau const& plateau) { return static_cast<double>(plateau.run.size()); });
    bool const no_hold = length + 1.0 < short_plateau * static_cast<double>(half_cycle_);
    bool const reversed = num::median_over(runs, &Plateau::range) > most_of_force * 2.0 * force_.half_range;
    if (!(reversed || (clear ? turn > wanted : no_hold))) return false;
    std::vector<std::size_t> first;
    for (auto const& plateau : runs) first.push_back(plateau.run.first);
    auto const& shown = runs.front().run;
    add(FaultKind::clipped, "displacement", first,
        fmt::format("displacement is clipped at {:.5g} mm: it stays there for up to {} samples, from {}, while the "
                    "force goes on",
                    num::median({disp_.x.begin() + static_cast<std::ptrdiff_t>(shown.first),
                                 disp_.x.begin() + static_cast<std::ptrdiff_t>(shown.last) + 1}),
                    longest, at(first)));
    return true;
  }

  // A channel with noise does not repeat itself to the last digit. What a smooth signal leaves in the measure of noise
  // is none.
  bool has_noise(Signal const& signal) const {
    double const smooth = 4.0 * std::pow(std::numbers::pi / static_cast<double>(half_cycle_), 4.0) * signal.half_range;
    return signal.noise > std::max(3.0 * signal.quantum, smooth);
  }

  // The force runs into its plateaus much less steeply than it leaves them: a device that yields does both alike.
  bool is_cut_off(std::vector<Run> const& runs) const {
    auto const beside = std::max<std::size_t>(3, half_cycle_ / 24);
    std::vector<double> ratios, into;
    for (auto const& run : runs) {
      if (run.size() <= least_plateau || run.first < beside || run.last + beside >= size()) continue;
      auto const slope = [&](std::size_t from, std::size_t to) {
        return std::abs(force_.x[to] - force_.x[from]) /
               std::max(std::abs(disp_.x[to] - disp_.x[from]), 1e-6 * disp_.half_range);
      };
      // Within one sample a device that yields may be there; what is cut off is not steeper there than before.
      into.push_back(std::max(slope(run.first - beside, run.first - 1), slope(run.first - 1, run.first)));
      ratios.push_back(into.back() / std::max(slope(run.last, run.last + beside), 1e-12));
      double const clear = std::max(3.0 * force_.quantum, 6.0 * force_.noise);
      if (std::abs(force_.x[run.first - 1] - force_.x[run.first - beside]) < clear) into.back() = 0.0;
    }
    return !ratios.empty() && num::median(into) > 0.1 * stiffness() && num::median(ratios) < 0.4;
  }

  bool clipped_force(double sign) {
    auto const runs = plateaus(force_, sign, same_value * 2.0 * force_.half_range);
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    double const least =
        std::max({past_the_tip * disp_.half_range, depth_quanta * force_.quantum / stiffness(), 8.0 * disp_.noise});
    bool const noisy = has_noise(force_);
    bool const cut = is_cut_off(runs);
    for (auto const& run : runs) {
      if (run.size() <= least_plateau) continue;
      auto const begin = disp_.x.begin() + static_cast<std::ptrdiff_t>(run.first);
      auto const end = disp_.x.begin() + static_cast<std::ptrdiff_t>(run.last) + 1;
      auto const tip = sign > 0.0 ? std::max_element(begin, end) : std::min_element(begin, end);
      double const back = sign * (*tip - disp_.x[run.last]), way = sign * (*tip - disp_.x[run.first]);
      bool const returns = back > std::max(least, least_back * way) && end - tip > 2;
      bool const moves = *std::max_element(begin, end) - *std::min_element(begin, end) > least;
      bool const repeats = noisy && run.size() > least_plateau + 1 && moves;
      // The top of a smooth peak on a coarse digitiser is no plateau.
      bool const deep = depth_of(force_, sign, run).value_or(0.0) > depth_quanta * force_.quantum;
      if (!repeats && !(deep && ((cut && moves) || (returns && tip != begin)))) continue;
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    }
    if (first.empty()) return false;
    name_clipped_force(force_.x[first.front()], longest, first);
    return true;
  }

  void name_clipped_force(double level, std::size_t longest, std::vector<std::size_t> const& first) {
    add(FaultKind::clipped, "force", first,
        fmt::format("force is clipped at {:.5g} kN: it stays there for up to {} samples, from {}, while the device "
                    "moves",
                    level, longest, at(first)));
  }

  // Where a plateau of force in noise lies, and what the force does before and after it, added up over the plateaus.
  struct Tops {
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    double way = 0.0, returned = 0.0;                    // into the plateau to the tip, and back from it
    double rise_before = 0.0, rise = 0.0, window = 0.0;  // in two windows of displacement before it, of one width
    double rise_last = 0.0, last_way = 0.0;              // within its first sample
    std::array<double, 4> drop{}, drop_way{};  // right after it, within 1, 2, 4 samples and a 24th of half a cycle
    std::array<double, 3> third{};             // sums above the level: of its way to the tip
    std::array<double, 3> samples{};
    double off_level = 0.0;  // plateaus that are not at the level of the others
  };

  // The level that most of the highest samples share.
  double top_level(double sign, double noise) const {
    double level = -std::numeric_limits<double>::infinity();
    for (double const value : force_.x) level = std::max(level, sign * value);
    level -= top_deviations * noise;
    for (int pass = 0; pass < 4; ++pass) {
      std::vector<double> members;
      for (double const value : force_.x)
        if (sign * value >= level - top_deviations * noise) members.push_back(sign * value);
      level = num::median(std::move(members));
    }
    return level;
  }

  // Of samples that noise throws out of the band now and then.
  std::vector<Run> tops_of(double sign, double low) const {
    constexpr std::size_t bridged = 2;
    std::vector<Run> runs;
    for (std::size_t i = 0; i < size(); ++i) {
      if (sign * force_.x[i] < low) continue;
      if (runs.empty() || i - runs.back().last > bridged + 1) runs.push_back({.first = i, .last = i});
      runs.back().last = i;
    }
    std::erase_if(runs, [](Run const& run) { return run.size() <= least_plateau; });
    return runs;
  }

  void add_top(double sign, double level, double noise, Run const& run, Tops& tops) const {
    auto const next = std::ranges::lower_bound(turns_, run.first);
    if (next == turns_.begin() || next == turns_.end() || *next > run.last + 1) return;
    auto const before = *(next - 1), tip = std::min(*next, run.last);
    auto const beside = std::max<std::size_t>(3, half_cycle_ / 24);
    if (run.last + beside >= size()) return;
    auto const x = [&](std::size_t i) { return sign * disp_.x[i]; };
    auto const y = [&](std::size_t i) { return sign * force_.x[i]; };
    double const way = x(tip) - x(run.first);
    double const window = std::min({way / 2.0, most_window * disp_.half_range, (x(run.first) - x(before)) / 2.0});
    if (!(window > std::max(least_window * disp_.half_range, 8.0 * disp_.noise))) return;
    auto near = run.first, far = run.first;
    while (near > before && (x(near) > x(run.first) - window || run.first - near < 2)) --near;
    far = near;
    while (far > before && (x(far) > x(near) - window || near - far < 2)) --far;
    if (far == before) return;
    tops.first.push_back(run.first);
    tops.longest = std::max(tops.longest, run.size());
    tops.way += way;
    tops.returned += std::max(0.0, x(tip) - x(run.last));
    // Of one width, however coarse the samples are.
    double const corner = (x(run.first) + x(run.first - 1)) / 2.0;
    tops.rise += (level - top_deviations * noise - y(near)) / std::max(corner - x(near), window / 4.0) * window;
    tops.rise_before += (y(near) - y(far)) / (x(near) - x(far)) * window;
    tops.window += window;
    tops.rise_last += y(run.first) - y(run.first - 1);
    tops.last_way += x(run.first) - x(run.first - 1);
    std::array<std::size_t, 4> const lags{1, 2, 4, beside};
    for (std::size_t k = 0; k < lags.size(); ++k) {
      auto const after = std::min(run.last + lags[k], size() - 1);
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

  // Force that goes up on its way, meets a level at a corner, keeps it to the reversal and beyond, and leaves it
  // steeply. A device that yields comes to its level as steeply as it leaves it, or ever more slowly.
  void clipped_force_in_noise(double sign) {
    for (double const wider : {1.0, 3.0}) {
      double const noise = wider * std::hypot(force_.noise, 0.3 * force_.quantum);
      double const level = top_level(sign, noise);
      Tops tops;
      for (auto const& run : tops_of(sign, level - top_deviations * noise)) add_top(sign, level, noise, run, tops);
      if (!is_clipped(tops, noise)) continue;
      name_clipped_force(sign * level, tops.longest, tops.first);
      return;
    }
  }

  bool is_clipped(Tops const& tops, double noise) const {
    auto const count = static_cast<double>(tops.first.size());
    if (count == 0.0 || *std::ranges::min_element(tops.samples) < least_third) return false;
    if (tops.off_level > count / 4.0) return false;
    double slope = tops.rise / tops.window, slope_before = tops.rise_before / tops.window;
    double leaves = 0.0;
    double const unsure = 4.0 * disp_.noise * std::sqrt(2.0 * count) + 1e-3 * disp_.half_range * count;
    for (std::size_t k = 0; k < tops.drop.size(); ++k)
      if (tops.drop[k] > 2.0 * top_deviations * noise * count)
        leaves = std::max(leaves, tops.drop[k] / std::max(tops.drop_way[k], unsure));
    // What the plateau cuts off at the tip.
    double const depth = slope * tops.way / count;
    auto const [lowest, highest] = std::ranges::minmax(
        std::array{tops.third[0] / tops.samples[0], tops.third[1] / tops.samples[1], tops.third[2] / tops.samples[2]});
    double const uneven = highest - lowest + 2.0 * noise * std::sqrt(2.0 / *std::ranges::min_element(tops.samples));
    if (!(depth > std::max(least_cut * force_.half_range, 4.0 * noise) && uneven < most_uneven * depth)) return false;
    double const flat = uneven / (tops.way / count);
    bool const corner = slope > 0.1 * stiffness() && slope_before > 0.3 * slope && slope_before < most_bend * slope &&
                        slope * slope > least_corner * slope_before * flat;
    if (!corner) return false;
    double const back = tops.returned / tops.way;
    if (back > 0.25 && tops.way < 0.6 * disp_.half_range * count) return true;
    double const last = (tops.rise_last - top_deviations * noise * std::sqrt(2.0 * count)) /
                        std::max(tops.last_way, 1e-3 * disp_.half_range * count);
    if (!(std::max({slope, slope_before, last}) < 0.4 * leaves)) return false;
    // Where the samples tell it, the force comes back to the level later than displacement to its peak.
    double const expected = depth / leaves;
    double const told = std::max(8.0 * disp_.noise, past_the_tip * disp_.half_range);
    return expected < 2.0 * told || tops.returned / count > least_return * expected;
  }

  std::vector<Run> stretches(Signal const& signal) const {
    std::vector<Run> runs;
    double const width = same_value * 2.0 * signal.half_range;
    for (std::size_t first = 0, i = 1; i <= signal.x.size(); ++i) {
      if (i < signal.x.size() && std::abs(signal.x[i] - signal.x[first]) <= width) continue;
      if (i - first >= least_stretch) runs.push_back({.first = first, .last = i - 1});
      first = i;
    }
    return runs;
  }

  // Mean speed before and after a stretch, over as many samples as it has, signed.
  std::pair<double, double> speeds(Signal const& signal, Run const& run) const {
    auto const reach = std::clamp<std::size_t>(run.size(), 3, std::max<std::size_t>(3, half_cycle_ / 4));
    auto const back = std::min(reach, run.first);
    auto const after = run.last + 1;
    auto const ahead = after < size() ? std::min(reach, size() - 1 - after) : 0;
    double const before =
        back > 0 ? (signal.x[run.first] - signal.x[run.first - back]) / static_cast<double>(back) : 0.0;
    double const next = ahead > 0 ? (signal.x[after + ahead] - signal.x[after]) / static_cast<double>(ahead) : 0.0;
    return {before, next};
  }

  bool is_clipped(std::string_view channel) const {
    return std::ranges::any_of(
        found_, [&](SignalFault const& fault) { return fault.channel == channel && fault.kind == FaultKind::clipped; });
  }

  // Whether the force went on while displacement stood, or displacement was elsewhere when it moved again.
  bool is_stuck(Run const& run) const {
    auto const [before, after] = speeds(disp_, run);
    double const speed = std::max(std::abs(before), std::abs(after));
    double const missed = speed * static_cast<double>(run.size() - 1);
    if (!(missed > std::max(least_missed * disp_.half_range, missed_quanta * disp_.quantum))) return false;
    auto const begin = force_.x.begin() + static_cast<std::ptrdiff_t>(run.first);
    auto const [least, largest] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(run.size()));
    double const floor = std::max({0.01 * force_.half_range, 6.0 * force_.noise, 3.0 * force_.quantum});
    if (!(*largest - *least > floor)) return false;
    double advance = 0.0;
    // A rest that the record ends with may begin a little earlier in displacement.
    auto const late = run.last + 1 == size() ? std::min(run.size() - 1, std::max<std::size_t>(2, half_cycle_ / 12)) : 0;
    auto const way = std::min(run.first, std::clamp<std::size_t>(half_cycle_ / 16, 2, 8));
    double const going = disp_.x[run.first] - disp_.x[run.first - way];
    auto const from = begin + static_cast<std::ptrdiff_t>(late);
    for (auto i = from; i != begin + static_cast<std::ptrdiff_t>(run.size()); ++i)
      advance = std::max(advance, std::copysign(1.0, going) * (*i - *from));
    auto const [lower, upper] = std::minmax_element(from, begin + static_cast<std::ptrdiff_t>(run.size()));
    if (*upper - *lower > most_of_force * 2.0 * force_.half_range) return true;
    double const missed_before =
        std::abs(going) / static_cast<double>(std::max<std::size_t>(1, way)) * static_cast<double>(run.size() - 1);
    bool const went = missed_before > std::max(least_missed * disp_.half_range, missed_quanta * disp_.quantum);
    if (went && run.size() > least_stretch &&
        advance > std::max(2.0 * floor, least_advance * stiffness() * std::min(missed_before, disp_.half_range / 2.0)))
      return true;
    if (run.last + 1 >= size() || gap_after(run.last)) return false;
    double const jump = std::abs(disp_.x[run.last + 1] - disp_.x[run.last]);
    return jump > std::max({least_missed * disp_.half_range, least_jump * speed + missed_quanta * disp_.quantum,
                            6.0 * disp_.noise}) &&
           *largest - *least > 2.0 * floor;
  }

  // Stretches that noise alone moves.
  static std::vector<Run> quiet_stretches(Signal const& signal, double band, std::size_t least) {
    std::vector<Run> runs;
    double sum = 0.0;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= signal.x.size(); ++i) {
      auto const count = static_cast<double>(i - first);
      if (i < signal.x.size() && (i == first || std::abs(signal.x[i] - sum / count) <= band)) {
        sum += signal.x[i];
        continue;
      }
      if (i - first >= least) runs.push_back({.first = first, .last = i - 1});
      if (i == signal.x.size()) break;
      first = i;
      sum = signal.x[i];
    }
    return runs;
  }

  // A channel that noise alone moves while the other goes its way, and that is elsewhere from one sample to the next
  // without a jump of the other: a device that yields, rests or slips moves both.
  std::vector<Run> stuck_in_noise(Signal const& stands, Signal const& other, double least_part) const {
    double const noise = std::hypot(stands.noise, 0.3 * stands.quantum);
    if (!(noise > same_value * stands.half_range)) return {};
    constexpr std::size_t fewest = 8;
    std::vector<Run> found;
    for (auto const& run : quiet_stretches(stands, 5.0 * noise, std::max<std::size_t>(fewest, half_cycle_ / 10))) {
      auto const lag = std::max<std::size_t>(2, half_cycle_ / 48);
      if (run.first == 0 || run.last + 1 + lag >= size() || gap_after(run.last)) continue;
      auto const middle = run.first + run.size() / 2;
      double const level = mean_of(stands.x, run.first, run.last + 1);
      double const trend = mean_of(stands.x, middle, run.last + 1) - mean_of(stands.x, run.first, middle);
      if (std::abs(trend) > 8.0 * noise / std::sqrt(static_cast<double>(run.size()))) continue;
      double const jump = std::abs(stands.x[run.last + 1] - level) / stands.half_range;
      double const next = std::abs(stands.x[run.last + 2] - stands.x[run.last + 1]) / stands.half_range;
      if (!(jump > std::max(least_part, 12.0 * noise / stands.half_range) && jump > 3.0 * next)) continue;
      double const other_jump = std::abs(other.x[run.last + 1] - other.x[run.last]) / other.half_range;
      if (other_jump > 0.3 * jump) continue;
      // The other goes on in one way through it all.
      double const way = other.x[run.last] - other.x[run.last - lag],
                   after = other.x[run.last + lag] - other.x[run.last];
      double const clear = std::max(0.005 * other.half_range, 6.0 * other.noise);
      bool const went = std::abs(other.x[run.last] - other.x[run.first]) > least_part * other.half_range;
      if (went && way * after > 0.0 && std::min(std::abs(way), std::abs(after)) > clear) found.push_back(run);
    }
    return found;
  }

  // Whether the force is nearer to what follows the stretch where the device is near its end in other cycles: a device
  // with play, or one that yields and stiffens again, stands in every cycle.
  bool is_elsewhere(Run const& run) const {
    auto const lag = std::max<std::size_t>(2, half_cycle_ / 48);
    double const at = disp_.x[run.last - lag], way = disp_.x[run.last] - at;
    double const level = mean_of(force_.x, run.first, run.last + 1), next = force_.x[run.last + 1];
    std::vector<double> there;
    for (std::size_t i = lag; i + lag < size(); ++i) {
      if (i + lag >= run.first && i <= run.last + lag) continue;
      if ((disp_.x[i] - at) * (disp_.x[i + 1] - at) <= 0.0 && (disp_.x[i + lag] - disp_.x[i - lag]) * way > 0.0)
        there.push_back((force_.x[i] - level) / (next - level));
    }
    return !there.empty() && num::median(std::move(there)) > 0.5;
  }

  void stuck_displacement() {
    if (is_clipped("displacement")) return;
    std::size_t covered = 0;
    std::vector<std::size_t> first;
    std::size_t longest = 0;
    auto const keep = [&](Run const& run) {
      covered += run.size();
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    };
    for (auto const& run : stretches(disp_))
      if (is_stuck(run)) keep(run);
    if (first.empty()) std::ranges::for_each(stuck_in_noise(disp_, force_, 0.1), keep);
    if (first.empty() || static_cast<double>(covered) > most_stretches * static_cast<double>(size())) return;
    add(FaultKind::stuck, "displacement", first,
        fmt::format("displacement is stuck at {:.5g} mm for {} samples, from {}, while the force goes on",
                    disp_.x[first.front()], longest, at(first)));
  }

  // No force at all, which it comes to at a reversal or without a jump: the device has play.
  bool is_backlash(Run const& run, std::size_t lag) const {
    double const noise = 5.0 * force_.noise + force_.quantum;
    if (std::abs(mean_of(force_.x, run.first, run.last + 1)) > noise) return false;
    if (run.first < 2) return true;
    auto const turn = std::ranges::upper_bound(turns_, run.first + 1);
    if (turn != turns_.begin()) {
      if (run.first <= *(turn - 1) + lag) return true;
      if (std::abs(disp_.x[run.first] - disp_.x[*(turn - 1)]) < force_stands * disp_.half_range) return true;
    }
    double const jump = std::abs(force_.x[run.first] - force_.x[run.first - 1]);
    return jump <= least_jump * std::abs(force_.x[run.first - 1] - force_.x[run.first - 2]) + 3.0 * noise;
  }

  void stuck_force() {
    if (is_clipped("force")) return;
    std::vector<std::size_t> first;
    std::size_t longest = 0, covered = 0;
    auto const keep = [&](Run const& run) {
      covered += run.size();
      first.push_back(run.first);
      longest = std::max(longest, run.size());
    };
    double const least =
        std::max({force_stands * disp_.half_range, 10.0 * force_.quantum / stiffness(), 8.0 * disp_.noise});
    bool const noisy = has_noise(force_);
    for (auto const& run : stretches(force_)) {
      auto const begin = disp_.x.begin() + static_cast<std::ptrdiff_t>(run.first);
      auto const end = begin + static_cast<std::ptrdiff_t>(run.size());
      auto const [low, high] = std::minmax_element(begin, end);
      if (!(*high - *low > least)) continue;
      // Beyond the farther of two turns within it: yielding would have ended there.
      double const there_and_back =
          std::max(std::min(*high - *begin, *high - *(end - 1)), std::min(*begin - *low, *(end - 1) - *low));
      auto const lag = std::max<std::size_t>(2, half_cycle_ / 48);
      if (is_backlash(run, lag)) continue;
      bool stuck = there_and_back > least || (noisy && run.size() >= 2 * least_stretch);
      if (!stuck && run.last + 1 + lag < size() && run.size() > lag && !gap_after(run.last)) {
        auto const [before, after] = speeds(force_, run);
        double const jump = std::abs(force_.x[run.last + 1] - force_.x[run.last]);
        double const way = disp_.x[run.last] - disp_.x[run.last - lag];
        double const next = disp_.x[run.last + 1 + lag] - disp_.x[run.last + 1];
        double const clear = std::max(0.005 * disp_.half_range, 6.0 * disp_.noise);
        bool const same_way = way * next > 0.0 && std::min(std::abs(way), std::abs(next)) > clear;
        stuck =
            same_way && jump > std::max({0.03 * force_.half_range, 6.0 * force_.noise, missed_quanta * force_.quantum,
                                         least_jump * std::max(std::abs(before), std::abs(after))});
      }
      // A rest at one end of the record may last a little longer in one channel than in the other.
      bool const at_an_end = run.first == 0 || run.last + 1 == size();
      if (stuck && !(at_an_end && *high - *low < disp_.half_range)) keep(run);
    }
    if (first.empty())
      for (auto const& run : stuck_in_noise(force_, disp_, 0.15))
        if (is_elsewhere(run) && !is_backlash(run, std::max<std::size_t>(2, half_cycle_ / 48))) keep(run);
    if (first.empty() || static_cast<double>(covered) > most_stretches * static_cast<double>(size())) return;
    add(FaultKind::stuck, "force", first,
        fmt::format("force is stuck at {:.5g} kN for {} samples, from {}, while the device moves",
                    force_.x[first.front()], longest, at(first)));
  }

  // A device that is at one place at every peak has one force there; forces of both signs belong to two places.
  void rectified() {
    if (turns_.size() < 4) return;
    auto const [least, largest] = std::ranges::minmax(disp_.x);
    auto const [least_F, largest_F] = std::ranges::minmax(force_.x);
    double const size_F = std::max(std::abs(least_F), std::abs(largest_F));
    double const margin = one_signed * (largest - least);
    bool const positive = least >= -margin, negative = largest <= margin;
    std::vector<std::size_t> peaks;
    std::size_t pushed = 0, pulled = 0, alike = 0;
    for (std::size_t k = 1; k + 1 < turns_.size(); ++k) {
      auto const i = turns_[k];
      bool const is_high = disp_.x[i] > disp_.x[turns_[k - 1]];
      double const F = force_.x[i - std::min(i, std::max<std::size_t>(2, half_cycle_ / 12))];  // it jumps at a reversal
      if (std::abs(F) > clear_force * size_F && F * (largest_F + least_F) > 0.0) ++alike;
      if (is_high == negative) continue;
      peaks.push_back(i);
      if (F > clear_force * size_F) ++pushed;
      if (F < -clear_force * size_F) ++pulled;
    }
    auto const inner = turns_.size() - 2;
    if ((positive || negative) && std::min(pushed, pulled) * 4 >= peaks.size() && std::min(pushed, pulled) > 0) {
      add(FaultKind::rectified, "displacement", peaks,
          fmt::format("displacement is recorded without its sign: it stays on one side of zero, and the force at its "
                      "peaks goes both ways, at {}",
                      at(peaks)));
      return;
    }
    bool const one_sign_F = std::min(std::abs(least_F), std::abs(largest_F)) <= one_signed * (largest_F - least_F);
    if (one_sign_F && !positive && !negative && alike == inner && largest * -least > 0.0 &&
        std::min(largest, -least) > 0.5 * disp_.half_range)
      add(FaultKind::rectified, "force", {turns_.begin() + 1, turns_.end() - 1},
          fmt::format("force is recorded without its sign: displacement goes both ways, the force at its peaks does "
                      "not, at {}",
                      at({turns_.begin() + 1, turns_.end() - 1})));
  }

  void name_spikes(std::string const& channel, std::string_view unit, std::vector<Spike> const& off) {
    if (off.empty()) return;
    std::vector<std::size_t> samples;
    auto const* largest = &off.front();
    for (auto const& spike : off) {
      samples.push_back(spike.at);
      if (std::abs(spike.value - spike.expected) > std::abs(largest->value - largest->expected)) largest = &spike;
    }
    add(FaultKind::spike, channel, samples,
        fmt::format("{} has {} of a single sample, at {}: {:.5g} {} where its neighbours say {:.5g}", channel,
                    off.size() == 1 ? "a spike" : fmt::format("{} spikes, each", off.size()), at(samples),
                    largest->value, unit, largest->expected));
  }

  std::span<double const> raw_disp_, raw_force_, time_;
  Signal disp_, force_;
  std::vector<std::size_t> turns_;
  std::size_t half_cycle_ = 0;
  double interval_ = 0.0;
  std::vector<SignalFault> found_;
};

}  // namespace

std::string_view said_of(FaultKind kind) {
  constexpr std::string_view names[]{"clipped", "stuck", "disturbed by spikes", "without its sign"};
  return names[static_cast<std::size_t>(kind)];
}

std::string sample_text(std::span<std::size_t const> samples, std::span<double const> time_s) {
  constexpr std::size_t most = 5;
  auto const one = [&](std::size_t i) {
    return time_s.empty() ? fmt::format("{}", i + 1) : fmt::format("{} ({:.6g} s)", i + 1, time_s[i]);
  };
  std::string text = samples.size() == 1 ? "sample " : "samples ";
  auto const shown = std::min(most, samples.size());
  for (std::size_t k = 0; k < shown; ++k)
    text += (k == 0 ? "" : k + 1 == samples.size() ? " and " : ", ") + one(samples[k]);
  if (samples.size() > shown) text += fmt::format(" and {} more", samples.size() - shown);
  return text;
}

std::vector<SignalFault> signal_faults(std::span<double const> disp_mm, std::span<double const> force_kN,
                                       std::span<double const> time_s) {
  return Record(disp_mm, force_kN, time_s).find();
}

}  // namespace isolaw::data
