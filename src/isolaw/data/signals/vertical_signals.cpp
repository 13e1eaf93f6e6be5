#include "isolaw/data/signals/vertical_signals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// A plateau is a run of at least this many samples in which a channel (vertical displacement or load) hardly changes.
constexpr std::size_t fewest_standing = 4;
// The samples of a plateau may differ by a `width`: standing_noise standard deviations of the channel's noise or, if
// that is more, standing_quanta steps of its digitiser.
constexpr double standing_noise = 6.0;
constexpr double standing_quanta = 1.5;
// While one channel is clipped, the other rises and falls back by more than this fraction of its own range (largest
// minus smallest value).
constexpr double goes_beyond = 0.03;
// While one channel is stuck, the other moves by more than this fraction of its own range.
constexpr double goes_on = 0.1;
// If the channel with the plateau is noisy, both fractions above are raised to this many times its width / range.
constexpr double width_of_both = 4.0;
// The device is loaded if the load exceeds the least load of the record by this fraction of the load's range.
constexpr double carries = 0.1;
// A stuck load jumps at the end of the plateau by more than this fraction of its range.
constexpr double load_jump = 0.05;

struct VerticalChannel {
  std::string name, unit;
  std::span<double const> x;
  // In `unit`: the smallest value, largest minus smallest value, and the most by which samples of a plateau may differ.
  double least = 0.0, range = 0.0, width = 0.0;
};

VerticalChannel channel_of(std::string name, std::string unit, std::span<double const> x) {
  auto const [least, largest] = std::ranges::minmax(x);
  VerticalChannel channel{
      .name = std::move(name), .unit = std::move(unit), .x = x, .least = least, .range = largest - least};
  channel.width = std::max({same_value * channel.range, standing_noise * noise_deviation(x),
                            standing_quanta * smallest_step(x, channel.range)});
  return channel;
}

std::vector<SampleRange> plateaus(VerticalChannel const& channel) {
  std::vector<SampleRange> found;
  auto const& x = channel.x;
  for (std::size_t first = 0; first + fewest_standing <= x.size();) {
    double least = x[first], largest = x[first];
    auto last = first;
    while (last + 1 < x.size()) {
      double const next = x[last + 1];
      if (std::max(largest, next) - std::min(least, next) > channel.width) break;
      least = std::min(least, next);
      largest = std::max(largest, next);
      ++last;
    }
    if (last + 1 - first >= fewest_standing) found.push_back({.first = first, .last = last});
    first = last + 1;
  }
  return found;
}

struct Standing {
  std::vector<std::size_t> samples;  // first sample of each plateau
  std::size_t longest = 0;
  double level = 0.0;  // median of the longest plateau, in the channel's unit

  void add(SampleRange const& run, std::span<double const> x) {
    samples.push_back(run.first);
    if (run.size() <= longest) return;
    longest = run.size();
    level = num::median(std::vector<double>(x.begin() + static_cast<std::ptrdiff_t>(run.first),
                                            x.begin() + static_cast<std::ptrdiff_t>(run.last + 1)));
  }
};
struct StandingStill {
  Standing clipped, stuck;
};

class Plateaus {
 public:
  Plateaus(VerticalChannel const& stands, VerticalChannel const& other, bool is_load)
      : stands_(stands), other_(other), is_load_(is_load) {}

  StandingStill find() const {
    StandingStill found;
    for (auto const& run : plateaus(stands_)) {
      if (is_clipped(run))
        found.clipped.add(run, stands_.x);
      else if (is_load_ ? is_stuck_load(run) : is_stuck_displacement(run))
        found.stuck.add(run, stands_.x);
    }
    return found;
  }

 private:
  // Returns how far the other channel must go during a plateau, as a fraction of that channel's range: at least
  // `least`, and more if the plateau is noisy.
  double threshold(double least) const { return std::max(least, width_of_both * stands_.width / stands_.range); }

  bool is_clipped(SampleRange const& run) const {
    double const level = mean_of(stands_.x, run.first, run.last + 1);
    if (level < stands_.least + stands_.range - stands_.width) return false;
    auto const part = other_.x.subspan(run.first, run.size());
    double const beyond = std::ranges::max(part) - std::max(part.front(), part.back());
    return beyond > std::max(threshold(goes_beyond) * other_.range, 2.0 * other_.width);
  }
  bool other_goes_on(SampleRange const& run) const {
    double const way = std::abs(other_.x[run.last] - other_.x[run.first]);
    return way > std::max(threshold(goes_on) * other_.range, 2.0 * other_.width);
  }
  // Only a plateau in which the load rises is a fault. While the load falls, a device that dissipates energy may keep
  // its displacement.
  bool is_stuck_displacement(SampleRange const& run) const {
    return other_goes_on(run) && other_.x[run.last] > other_.x[run.first];
  }
  // A press may hold a constant load, or carry none once it has lifted off. Only a stuck load ends with a jump.
  bool is_stuck_load(SampleRange const& run) const {
    if (run.last + 2 >= stands_.x.size() || run.first == 0 || !other_goes_on(run)) return false;
    double const level = mean_of(stands_.x, run.first, run.last + 1);
    if (level < stands_.least + stands_.width) return false;
    auto const step = [](VerticalChannel const& channel, std::size_t i) {
      return std::abs(channel.x[i + 1] - channel.x[i]) / channel.range;
    };
    double const jump = step(stands_, run.last), next = step(stands_, run.last + 1);
    return jump > std::max({load_jump, 2.0 * stands_.width / stands_.range, 3.0 * next}) &&
           step(other_, run.last) < 0.3 * jump;
  }

  VerticalChannel const& stands_;
  VerticalChannel const& other_;
  bool is_load_;
};

void add_standing(VerticalChannel const& stands, StandingStill found, std::vector<SignalFault>& faults) {
  auto const add = [&](FaultKind kind, Standing still) {
    if (!still.samples.empty())
      faults.push_back(
          standing_fault(kind, stands.name, stands.unit, std::move(still.samples), {}, still.level, still.longest));
  };
  add(FaultKind::clipped, std::move(found.clipped));
  add(FaultKind::stuck, std::move(found.stuck));
}

// Returns the spikes that are faults. A spike in both channels is a real change of load, and a downward spike at low
// load may be the press lifting off.
std::vector<Spike> single(std::vector<Spike> found, std::vector<Spike> const& other_channel,
                          std::span<double const> load) {
  auto const [least, largest] = std::ranges::minmax(load);
  double const unloaded = least + carries * (largest - least);
  std::erase_if(found, [&](Spike const& spike) {
    bool const in_both = std::ranges::find(other_channel, spike.at, &Spike::at) != other_channel.end();
    bool const lifted = load[spike.at] < unloaded && spike.value < spike.expected;
    return in_both || lifted;
  });
  return found;
}

std::vector<double> without(std::vector<double> values, std::vector<Spike> const& off) {
  for (auto const& spike : off) values[spike.at] = spike.expected;
  return values;
}

}  // namespace

std::vector<SignalFault> vertical_faults(std::span<double const> disp_mm, std::span<double const> load_kN) {
  constexpr std::size_t fewest = 16;
  if (disp_mm.size() < fewest || disp_mm.size() != load_kN.size()) return {};
  auto const gone_disp = dropouts(disp_mm, load_kN, OtherChannel::may_stand),
             gone_load = dropouts(load_kN, disp_mm, OtherChannel::moves);
  auto disp = bridged(disp_mm, gone_disp), load = bridged(load_kN, gone_load);
  auto const all_disp = spikes(disp), all_load = spikes(load);
  auto const whole_load = without(load, all_load);
  auto const off_disp = single(all_disp, all_load, whole_load), off_load = single(all_load, all_disp, whole_load);
  disp = without(std::move(disp), off_disp);
  load = without(std::move(load), off_load);
  auto const of_disp = channel_of("vertical displacement", "mm", disp),
             of_load = channel_of("vertical load", "kN", load);
  std::vector<SignalFault> found;
  if (of_disp.range > 0.0 && of_load.range > 0.0 && std::isfinite(of_disp.range + of_load.range)) {
    add_standing(of_disp, Plateaus(of_disp, of_load, false).find(), found);
    add_standing(of_load, Plateaus(of_load, of_disp, true).find(), found);
  }
  auto const add = [&](std::vector<SignalFault> more) { std::ranges::move(more, std::back_inserter(found)); };
  add(dropout_faults(of_disp.name, of_disp.unit, gone_disp, {}));
  add(dropout_faults(of_load.name, of_load.unit, gone_load, {}));
  add(spike_faults(of_disp.name, of_disp.unit, off_disp, {}));
  add(spike_faults(of_load.name, of_load.unit, off_load, {}));
  return found;
}

}  // namespace isolaw::data
