#include "isolaw/data/properties/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "isolaw/data/channels/time_gaps.hpp"
#include "isolaw/data/properties/device_kind.hpp"
#include "isolaw/data/properties/failure.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// With fewer samples per cycle, the trapezoidal rule loses over 1.6 % of the energy, and the samples miss over 1.2 % of
// the peak.
constexpr double least_samples_per_cycle = 20.0;
constexpr std::size_t reported_cycle = 3;
constexpr double rounding_of_energy = 1e-9;  // times K_eff D^2; a negative energy no larger than this may be rounding
constexpr double noise_of_energy = 5.0;      // standard deviations; a negative energy within them may be noise
constexpr double least_sweep = 1.2;          // in a sweep, first and last period differ by more than this factor
constexpr double most_steps = 0.8;           // at least this fraction of a sweep's periods change in its direction
constexpr double same_shape = 0.05;  // two motions of one shape differ by at most this rms difference / amplitude

// The samples [begin, end) that lie strictly between a cycle's fractional start and end.
struct Inside {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Inside inside(Cycle const& cycle, std::size_t size) {
  Inside samples{.begin = static_cast<std::size_t>(std::floor(cycle.first)) + 1,
                 .end = std::min(static_cast<std::size_t>(std::ceil(cycle.last)), size)};
  samples.begin = std::min(samples.begin, samples.end);
  return samples;
}
struct Peaks {
  double least, F_at_least, at_least;
  double largest, F_at_largest, at_largest;
};

Peaks follow(Cycle& cycle, std::span<double const> x, std::span<double const> F) {
  double const start_x = value_at(x, cycle.first);
  double const start_F = value_at(F, cycle.first);
  Peaks peaks{start_x, start_F, cycle.first, start_x, start_F, cycle.first};
  double at_x = start_x;
  double at_F = start_F;
  double energy = 0.0;
  auto const go_to = [&](double next_x, double next_F, double index) {
    energy += (at_F + next_F) / 2.0 * (next_x - at_x);
    at_x = next_x;
    at_F = next_F;
    if (at_x < peaks.least) peaks.least = at_x, peaks.F_at_least = at_F, peaks.at_least = index;
    if (at_x > peaks.largest) peaks.largest = at_x, peaks.F_at_largest = at_F, peaks.at_largest = index;
  };
  auto const samples = inside(cycle, x.size());
  for (auto i = samples.begin; i < samples.end; ++i) go_to(x[i], F[i], static_cast<double>(i));
  double const end_x = value_at(x, cycle.last);
  double const end_F = value_at(F, cycle.last);
  go_to(end_x, end_F, cycle.last);
  cycle.closure_mm = end_x - start_x;
  cycle.closure_kN = end_F - start_F;
  go_to(start_x, start_F, cycle.last);
  cycle.energy_kN_mm = cycle.half ? 2.0 * energy : energy;
  return peaks;
}

// The value of F where x first crosses `level` between two sample indices.
std::optional<double> at_level(std::span<double const> x, std::span<double const> F, double from, double to,
                               double level) {
  auto const stop = std::min(static_cast<std::size_t>(std::ceil(to)), x.size() - 1);
  for (auto i = static_cast<std::size_t>(std::floor(from)) + 1; i <= stop; ++i) {
    double const before = x[i - 1] - level;
    double const after = x[i] - level;
    if ((before < 0.0) == (after < 0.0)) continue;
    return F[i - 1] + before / (before - after) * (F[i] - F[i - 1]);
  }
  return std::nullopt;
}

// Returns half the loop's height at the displacement where the cycle starts and ends. Does not use a start or end at
// which the device rests or turns, because the force there is not on the loop.
double strength(Cycle const& cycle, Peaks const& peaks, std::span<double const> x, std::span<double const> F) {
  if (cycle.half) {  // the force halfway between the turns, minus the chord that joins the turns
    auto const halfway = at_level(x, F, cycle.first, cycle.last, (peaks.largest + peaks.least) / 2.0);
    return halfway ? std::abs(*halfway - (peaks.F_at_largest + peaks.F_at_least) / 2.0) : 0.0;
  }
  if (cycle.one_sided) {  // taken halfway between the turns, because the loop is closed at them
    double const start = value_at(x, cycle.first);
    double const tip = peaks.largest - start > start - peaks.least ? peaks.at_largest : peaks.at_least;
    auto const out = at_level(x, F, cycle.first, tip, (peaks.largest + peaks.least) / 2.0);
    auto const back = at_level(x, F, tip, cycle.last, (peaks.largest + peaks.least) / 2.0);
    return out && back ? std::abs(*out - *back) / 2.0 : 0.0;
  }
  bool const rises = peaks.at_largest < peaks.at_least;
  bool const starts_in_motion = cycle.first > 0.0 && !cycle.turns_at_start;
  bool const ends_in_motion = cycle.last < static_cast<double>(x.size() - 1) && !cycle.turns_at_end;
  double const start = value_at(F, cycle.first);
  double const end = value_at(F, cycle.last);
  double const outer = starts_in_motion == ends_in_motion ? (starts_in_motion ? (start + end) / 2.0 : end)
                       : starts_in_motion                 ? start
                                                          : end;
  double const level = value_at(x, starts_in_motion || !ends_in_motion ? cycle.first : cycle.last);
  auto const inner =
      at_level(x, F, std::min(peaks.at_largest, peaks.at_least), std::max(peaks.at_largest, peaks.at_least), level);
  if (!inner) return 0.0;
  double const height = rises ? outer - *inner : *inner - outer;
  constexpr double rounding = 1e-12;  // times the sum of the two forces: the rounding error of their difference
  return std::abs(height) <= rounding * (std::abs(outer) + std::abs(*inner)) ? 0.0 : height / 2.0;
}

void add_residuals(Cycle& cycle, Peaks const& peaks, std::span<double const> x, std::span<double const> F) {
  double const middle = std::max(peaks.at_largest, peaks.at_least);
  auto const after = [&](double peak) { return at_level(F, x, peak, peak < middle ? middle : cycle.last, 0.0); };
  cycle.residual_plus_mm = after(peaks.at_largest);
  cycle.residual_minus_mm = after(peaks.at_least);
}

// A cycle that hardly leaves zero on one side has no stiffness there.
constexpr double least_excursion = 0.01;  // fraction of the amplitude

void derive(Cycle& cycle, Peaks const& peaks) {
  cycle.d_plus_mm = peaks.largest;
  cycle.d_minus_mm = peaks.least;
  cycle.F_plus_kN = peaks.F_at_largest;
  cycle.F_minus_kN = peaks.F_at_least;
  cycle.amplitude_mm = (peaks.largest - peaks.least) / 2.0;
  cycle.K_eff_kN_per_mm = (peaks.F_at_largest - peaks.F_at_least) / (peaks.largest - peaks.least);
  double const least = least_excursion * cycle.amplitude_mm;
  cycle.K_plus_kN_per_mm = cycle.d_plus_mm > least ? cycle.F_plus_kN / cycle.d_plus_mm : 0.0;
  cycle.K_minus_kN_per_mm = cycle.d_minus_mm < -least ? cycle.F_minus_kN / cycle.d_minus_mm : 0.0;
  double const elastic = cycle.K_eff_kN_per_mm * cycle.amplitude_mm * cycle.amplitude_mm;
  cycle.damping_percent = elastic != 0.0 ? 100.0 * cycle.energy_kN_mm / (2.0 * std::numbers::pi * elastic)
                                         : std::numeric_limits<double>::quiet_NaN();
}

void idealise(Cycle& cycle) {
  cycle.K_d_kN_per_mm = cycle.K_eff_kN_per_mm - (cycle.amplitude_mm != 0.0 ? cycle.Q_d_kN / cycle.amplitude_mm : 0.0);
  cycle.D_y_mm.reset();
  cycle.K_1_kN_per_mm.reset();
  double const yield = cycle.amplitude_mm - cycle.energy_kN_mm / (4.0 * cycle.Q_d_kN);
  if (!(cycle.Q_d_kN > 0.0 && yield > 0.0 && yield < cycle.amplitude_mm)) return;
  cycle.D_y_mm = yield;
  cycle.K_1_kN_per_mm = cycle.K_d_kN_per_mm + cycle.Q_d_kN / yield;
}

// Computes velocities over 1/25 of a cycle, which are 0.3 % too low for a sine. Velocities from one sample to the next
// would be worse: at 1 kHz, noise of 0.02 mm adds 30 mm/s.
double largest_slope(Cycle const& cycle, CycleView const& view) {
  auto const peaks = peak_positions(view.disp_mm, cycle.first, cycle.last);
  auto const reach =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(std::abs(peaks.largest - peaks.smallest) / 25.0)));
  auto const begin = static_cast<std::size_t>(std::floor(cycle.first));
  auto const end = std::min(static_cast<std::size_t>(std::ceil(cycle.last)) + 1, view.disp_mm.size());
  double largest = 0.0;
  for (auto i = begin; i + 2 * reach < end; ++i) {
    auto const j = i + 2 * reach;
    largest = std::max(largest, std::abs((view.disp_mm[j] - view.disp_mm[i]) / (view.time_s[j] - view.time_s[i])));
  }
  return largest;
}

// Sets the vertical loads of a cycle. Leaves out a rest before its first motion, in which a rig may change the load.
void add_load(Cycle& cycle, CycleView const& view) {
  auto const& load = view.load_kN;
  auto samples = inside(cycle, load.size());
  double from = cycle.first;
  if (cycle.still_samples > 0.0) {
    constexpr double at_rest = 0.02;  // times the amplitude
    double const zero = value_at(view.disp_mm, cycle.first);
    auto const rests = [&](std::size_t i) { return std::abs(view.disp_mm[i] - zero) <= at_rest * cycle.amplitude_mm; };
    while (samples.begin + 1 < samples.end && rests(samples.begin)) from = static_cast<double>(samples.begin++);
  }
  double const start = value_at(load, from);
  double least = start, largest = start, sum = start;
  for (auto i = samples.begin; i < samples.end; ++i) {
    least = std::min(least, load[i]);
    largest = std::max(largest, load[i]);
    sum += load[i];
  }
  cycle.N_mean_kN = sum / static_cast<double>(samples.end - samples.begin + 1);
  cycle.N_min_kN = least;
  cycle.N_max_kN = largest;
}

// For each sample, the work of the force since the first sample. From the last sample of a test to the first sample of
// the next test it does not change.
std::vector<double> work(CycleView const& view) {
  std::vector<double> sums(view.disp_mm.size());
  for (auto const& test : test_ranges(view.starts, view.disp_mm.size())) {
    if (test.first > 0) sums[test.first] = sums[test.first - 1];
    for (auto i = test.first + 1; i < test.end; ++i)
      sums[i] = sums[i - 1] + 0.5 * (view.force_kN[i - 1] + view.force_kN[i]) * (view.disp_mm[i] - view.disp_mm[i - 1]);
  }
  return sums;
}

Cycle measure(CycleCut const& cut, CycleView const& view) {
  Cycle plain;
  static_cast<CycleCut&>(plain) = cut;
  auto cycle = properties_on(plain, view.disp_mm, view.force_kN);
  if (!view.time_s.empty()) {
    cycle.still_s = cut.still_time;
    cycle.period_s = (cut.half ? 2.0 : 1.0) *
                     (value_at(view.time_s, cycle.last) - value_at(view.time_s, cycle.first) - cut.still_time);
    cycle.v_max_mm_s = largest_slope(cycle, view);
  }
  if (!view.load_kN.empty()) add_load(cycle, view);
  return cycle;
}

// Compares the displacement from one peak to the other with half a cosine ("sine") and with a straight line
// ("triangle"). A cycle that spends more than twice a sine's time near its extremes is neither a sine nor a triangle.
std::string waveform(Cycle const& cycle, CycleView const& view) {
  auto peaks = peak_positions(view.disp_mm, cycle.first, cycle.last);
  if (cycle.half)  // compares the whole half cycle
    peaks = value_at(view.disp_mm, cycle.first) < value_at(view.disp_mm, cycle.last)
                ? PeakPositions{.largest = cycle.last, .smallest = cycle.first}
                : PeakPositions{.largest = cycle.first, .smallest = cycle.last};
  else if (cycle.one_sided)  // compares the way out, which begins at the turn where the cycle starts
    (value_at(view.disp_mm, cycle.first) < (cycle.d_plus_mm + cycle.d_minus_mm) / 2.0 ? peaks.smallest
                                                                                      : peaks.largest) = cycle.first;
  bool const falls = peaks.largest < peaks.smallest;
  double const from = value_at(view.time_s, std::min(peaks.largest, peaks.smallest));
  double const to = value_at(view.time_s, std::max(peaks.largest, peaks.smallest));
  double const centre = (cycle.d_plus_mm + cycle.d_minus_mm) / 2.0;
  constexpr double near = 0.995;  // a sample beyond this fraction of the amplitude is near an extreme
  double const lingers = 2.0 * std::acos(near) / std::numbers::pi;
  double from_sine = 0.0, from_triangle = 0.0, count = 0.0, all = 0.0, at_extremes = 0.0;
  auto const samples = inside(cycle, view.disp_mm.size());
  for (auto i = samples.begin; i < samples.end; ++i) {
    double const y = (falls ? 1.0 : -1.0) * (view.disp_mm[i] - centre) / cycle.amplitude_mm;
    all += 1.0;
    at_extremes += std::abs(y) > near ? 1.0 : 0.0;
    double const part = (view.time_s[i] - from) / (to - from);
    if (!(part >= 0.0 && part <= 1.0)) continue;
    from_sine += std::pow(y - std::cos(std::numbers::pi * part), 2.0);
    from_triangle += std::pow(y - (1.0 - 2.0 * part), 2.0);
    count += 1.0;
  }
  constexpr double margin = 4.0;  // samples at the extremes that may come from rounding
  if (at_extremes > 2.0 * lingers * all + margin) return "other";
  double const limit = same_shape * same_shape * count;
  if (count > 0.0 && from_sine <= std::min(limit, from_triangle)) return "sine";
  return count > 0.0 && from_triangle <= limit ? "triangle" : "other";
}

void summarise(Block& block, CycleView const& view) {
  auto const counted = block.counted();
  if (counted.empty()) return;
  block.amplitude_mm = num::median_over(counted, &Cycle::amplitude_mm);
  if (view.time_s.empty()) return;
  double const period = num::median_over(counted, [](Cycle const* c) { return *c->period_s; });
  if (period > 0.0) block.frequency_Hz = 1.0 / period;
  block.v_max_mm_s = num::median_over(counted, [](Cycle const* c) { return *c->v_max_mm_s; });
  // The waveform is that of the middle counted cycle without a hold or, if all have a hold, of the middle counted
  // cycle.
  std::vector<Cycle const*> unheld;
  std::ranges::copy_if(counted, std::back_inserter(unheld), [](Cycle const* c) { return c->still_samples == 0.0; });
  auto const& shown = unheld.empty() ? counted : unheld;
  block.waveform = waveform(*shown[shown.size() / 2], view);
}

// Whether the period changes in one direction from cycle to cycle. A test with steps of frequency is no sweep: most of
// its cycles have the same period as the cycle before.
bool is_sweep(std::span<Cycle const* const> cycles) {
  if (cycles.size() < 4 || !cycles.front()->period_s) return false;
  std::vector<double> steps;
  for (std::size_t k = 1; k < cycles.size(); ++k)
    steps.push_back(std::log(*cycles[k]->period_s / *cycles[k - 1]->period_s));
  auto const count = static_cast<double>(steps.size());
  double const total = std::log(*cycles.back()->period_s / *cycles.front()->period_s);
  if (!(std::abs(total) > std::log(least_sweep))) return false;
  double const least = std::max(0.25 * std::abs(num::median(steps)), 0.1 * std::abs(total) / count);
  auto const follows =
      std::ranges::count_if(steps, [&](double step) { return std::copysign(1.0, total) * step >= least; });
  return static_cast<double>(follows) >= most_steps * count;
}

// Finds blocks in which the frequency changes from cycle to cycle. Such a block gets sweep_Hz in place of frequency_Hz.
void find_sweeps(Properties& properties) {
  auto const mark = [&](std::vector<Cycle const*> const& cycles, auto const& is_in) {
    if (!is_sweep(cycles)) return false;
    for (auto& block : properties.blocks) {
      if (!block.frequency_Hz || !is_in(block)) continue;
      block.frequency_Hz.reset();
      block.sweep_Hz = {1.0 / *cycles.front()->period_s, 1.0 / *cycles.back()->period_s};
    }
    return true;
  };
  if (mark(properties.complete(), [](Block const&) { return true; })) return;
  for (auto const& block : properties.blocks)
    mark(block.counted(), [&](Block const& other) { return &other == &block; });
}

struct Noise {
  double disp_mm = 0.0, force_kN = 0.0;
};

// Standard deviation that noise gives to a cycle's energy. An error of a sample's force is multiplied by half the
// displacement between its two neighbours, and an error of its displacement by half the difference of their forces.
double noise_of_area(Cycle const& cycle, CycleView const& view, Noise const& noise) {
  double ways = 0.0, forces = 0.0;
  auto const samples = inside(cycle, view.disp_mm.size());
  for (auto i = std::max<std::size_t>(1, samples.begin); i + 1 < std::min(samples.end + 1, view.disp_mm.size()); ++i) {
    ways += std::pow((view.disp_mm[i + 1] - view.disp_mm[i - 1]) / 2.0, 2.0);
    forces += std::pow((view.force_kN[i + 1] - view.force_kN[i - 1]) / 2.0, 2.0);
  }
  return std::sqrt(noise.force_kN * noise.force_kN * ways + noise.disp_mm * noise.disp_mm * forces);
}

Finding of_cycle(FindingKind kind, Cycle const& cycle, FindingNumber number) {
  return {.kind = kind,
          .blocks = {cycle.block},
          .numbers = {{"cycle", static_cast<double>(cycle.number)}, std::move(number)}};
}

// Says why no device can have the loop of this cycle. Empty if a device can.
std::vector<Finding> impossible(Cycle const& cycle, CycleView const& view, Noise const& noise, bool viscous) {
  double const size = std::abs(cycle.K_eff_kN_per_mm) * cycle.amplitude_mm * cycle.amplitude_mm;
  double const least = rounding_of_energy * size + noise_of_energy * noise_of_area(cycle, view, noise);
  if (cycle.energy_kN_mm < -least)
    return {of_cycle(FindingKind::cycle_gives_energy, cycle, {"energy_kN_mm", -cycle.energy_kN_mm})};
  if (!viscous && !(cycle.K_eff_kN_per_mm > 0.0))
    return {of_cycle(FindingKind::cycle_not_stiff, cycle, {"K_eff_kN_per_mm", cycle.K_eff_kN_per_mm})};
  return {};
}

void discount(Block& block, std::string const& why) {
  block.fault = why;
  block.frequency_Hz.reset();
  block.sweep_Hz.reset();
  block.v_max_mm_s.reset();
  block.waveform.clear();
  for (auto& cycle : block.cycles) {
    cycle.number = 0;
    cycle.not_counted = why;
  }
}

// Lists cycles with an impossible loop in properties.block_faults. If other blocks are sound, no cycle counts any more
// in the blocks with such a loop. Returns whether there are such loops and no block is sound.
bool take_out_impossible(Properties& properties, CycleView const& view) {
  constexpr std::size_t most_said = 5;
  Noise const noise{.disp_mm = noise_deviation(view.disp_mm), .force_kN = noise_deviation(view.force_kN)};
  std::vector<std::pair<Block*, int>> taken;  // each block with the number of its impossible cycle
  bool any_sound = false;
  for (auto& block : properties.blocks) {
    auto const counted = block.counted();
    std::vector<Finding> why;
    for (auto at = counted.begin(); at != counted.end() && why.empty(); ++at) {
      // A half cycle may truly have a negative area: a force that bends upwards lies below its chord on the way out.
      if ((*at)->half) continue;
      why = impossible(**at, view, noise, properties.viscous.has_value());
      if (why.empty()) continue;
      taken.emplace_back(&block, (*at)->number);
      if (properties.block_faults.size() < most_said) properties.block_faults.push_back(std::move(why.front()));
    }
    any_sound = any_sound || (!counted.empty() && (taken.empty() || taken.back().first != &block));
  }
  if (any_sound)
    for (auto const& [block, number] : taken)
      discount(*block, fmt::format("cycle {} of the block cannot be true", number));
  else if (properties.block_faults.size() > 1)
    properties.block_faults.resize(1);
  return !taken.empty() && !any_sound;
}

std::vector<Finding> refusal_of(std::optional<Finding> const& not_cut, Properties const& properties) {
  if (not_cut) return {*not_cut};
  if (!properties.samples_per_cycle) return {{.kind = FindingKind::no_cycle_counts}};
  if (*properties.samples_per_cycle < least_samples_per_cycle * (1.0 - 1e-9))
    return {{.kind = FindingKind::samples_too_few,
             .numbers = {{"samples", *properties.samples_per_cycle}, {"needed", least_samples_per_cycle}}}};
  return {};
}

// The third counted cycle of the block of largest amplitude. The block in which the force is lost is taken only if no
// other block has counted cycles.
Cycle const* cycle_to_report(Properties const& properties) {
  Block const* largest = nullptr;
  auto const fails = [&](Block const& block) {
    return properties.failure && properties.failure->blocks.front() == block.number;
  };
  for (auto const& block : properties.blocks)
    if (!block.counted().empty() &&
        (largest == nullptr || fails(*largest) ||
         (!fails(block) && block.amplitude_mm > (1.0 + same_nominal) * largest->amplitude_mm)))
      largest = &block;
  if (largest == nullptr) return nullptr;
  auto const counted = largest->counted();
  return counted[std::min(counted.size(), reported_cycle) - 1];
}

// Sets the properties that follow from the counted cycles: samples per cycle, a refusal, the reported cycle.
void conclude(Properties& properties, std::optional<Finding> const& not_cut, bool none_is_sound) {
  std::vector<double> lengths;
  for (auto const* cycle : properties.counted())
    lengths.push_back((cycle->half ? 2.0 : 1.0) * (cycle->last - cycle->first - cycle->still_samples));
  properties.samples_per_cycle = lengths.empty() ? std::nullopt : std::optional(num::median(lengths));
  properties.reported.reset();
  properties.refusal_is_of_fault = !properties.block_faults.empty() && (lengths.empty() || none_is_sound);
  properties.refusal =
      properties.refusal_is_of_fault ? std::exchange(properties.block_faults, {}) : refusal_of(not_cut, properties);
  if (auto const* reported = cycle_to_report(properties); reported != nullptr && properties.refusal.empty())
    properties.reported = *reported;
}

// Returns the blocks that a fault makes unusable, usually those in which it lies. All blocks of the test are unusable
// if a channel has lost its sign, or if a faulty displacement may have led to wrong blocks.
std::vector<int> blocks_of(SignalFault const& fault, Properties const& properties, TestRange const& test) {
  std::vector<int> blocks;
  auto const longest = fault.longest();
  bool const everywhere =
      fault.kind == FaultKind::rectified || (fault.channel == "displacement" && fault.kind != FaultKind::clipped);
  auto const touches = [&](Block const& block) {
    return std::ranges::any_of(fault.samples, [&](std::size_t sample) {
      return static_cast<double>(sample) <= block.cycles.back().last &&
             static_cast<double>(sample + longest - 1) >= block.cycles.front().first;
    });
  };
  auto const is_in_test = [&](Block const& block) {
    auto const first = static_cast<std::size_t>(block.cycles.front().first);
    return first >= test.first && first < test.end;
  };
  for (auto const& block : properties.blocks)
    if (everywhere ? is_in_test(block) : touches(block)) blocks.push_back(block.number);
  return blocks;
}

// Whether no cycle of a later block counts because the force is lost there, and not because a signal is faulty.
bool fails_in_a_later_block(Properties const& properties) {
  auto const is_lost = [&](Cycle const& cycle) {
    return std::ranges::any_of(properties.samples_without_force, [&](auto const& samples) {
      return samples.first <= cycle.first && cycle.last <= samples.second;
    });
  };
  return std::ranges::any_of(properties.blocks, [&](Block const& block) {
    return block.number > properties.failure->blocks.front() && block.fault.empty() && block.counted().empty() &&
           std::ranges::any_of(block.cycles, is_lost);
  });
}

// Stops counting the cycles of the blocks in which a signal is faulty.
void take_out_faulty(Properties& properties, CycleView const& view) {
  if (properties.faults.empty()) return;
  auto const tests = test_ranges(view.starts, view.disp_mm.size());
  std::vector<Finding> found, outside;
  for (auto& fault : properties.faults) {
    auto const test =
        std::ranges::find_if(tests, [&](TestRange const& range) { return fault.samples.front() < range.end; });
    auto const blocks = blocks_of(fault, properties, *test);
    if (properties.blocks.size() > 1) fault.finding.blocks = blocks;
    for (int const number : blocks)
      discount(properties.blocks[static_cast<std::size_t>(number) - 1],
               fmt::format("the {} is {}", fault.channel, said_of(fault.kind)));
    (blocks.empty() ? outside : found).push_back(fault.finding);
  }
  if (properties.counted().empty())
    found.insert(found.end(), outside.begin(), outside.end());
  else
    for (auto& fault : properties.faults)
      if (std::ranges::find(outside, fault.finding) != outside.end()) fault.finding.words.push_back({"outside", "yes"});
  // If a signal is faulty in a block, other impossible values there follow from it and are not reported.
  for (auto& finding : properties.block_faults)
    if (properties.blocks.size() > 1 && !finding.blocks.empty() &&
        std::ranges::none_of(found, [&](Finding const& fault) {
          return std::ranges::find(fault.blocks, finding.blocks.front()) != fault.blocks.end();
        }))
      found.push_back(std::move(finding));
  properties.block_faults = std::move(found);
  auto const is_faulty = [&](int number) {
    return !properties.blocks[static_cast<std::size_t>(number) - 1].fault.empty();
  };
  if (properties.failure && is_faulty(properties.failure->blocks.front()) && !fails_in_a_later_block(properties)) {
    properties.failure.reset();
    properties.samples_without_force.clear();
  }
}

Properties properties_of(CycleView const& given, std::vector<SignalFault> const& faults) {
  auto view = given;
  assert(view.disp_mm.size() == view.force_kN.size());
  assert(view.time_s.empty() || view.time_s.size() == view.disp_mm.size());
  assert(view.load_kN.empty() || view.load_kN.size() == view.disp_mm.size());
  Properties properties{.faults = faults};
  auto const moving = without_gaps(view.time_s, time_gaps(view.disp_mm, view.time_s, view.starts));
  if (!moving.empty()) view.time_s = moving;
  auto const cut =
      segment(view.disp_mm, given.time_s, view.starts,
              {.load_kN = view.load_kN, .logged_cycle = view.logged_cycle, .half_cycles = view.half_cycles});
  properties.centre_mm = cut.centre_mm;
  auto const done = work(view);
  for (auto const& piece : cut.cycles) {
    if (properties.blocks.empty() || properties.blocks.back().number != piece.block) {
      properties.blocks.emplace_back();
      properties.blocks.back().number = piece.block;
    }
    properties.blocks.back().cycles.push_back(measure(piece, view));
    properties.blocks.back().cycles.back().work_kN_mm = value_at(done, piece.last);
  }
  for (auto& block : properties.blocks) summarise(block, view);
  find_sweeps(properties);
  find_failure(properties, given.time_s);
  auto const find_kind = [&] {
    auto const* cycle = cycle_to_report(properties);
    if (cycle == nullptr) return;
    properties.viscous = viscous_law(view, *cycle);
    properties.slider = slider(*cycle);
  };
  find_kind();
  bool const none_is_sound = take_out_impossible(properties, view);
  take_out_faulty(properties, view);
  find_kind();  // without the faulty blocks, the device may look like another kind
  conclude(properties, cut.refusal, none_is_sound);
  return properties;
}

}  // namespace

std::vector<Cycle const*> Block::counted() const {
  std::vector<Cycle const*> found;
  for (auto const& cycle : cycles)
    if (cycle.counts()) found.push_back(&cycle);
  return found;
}

Cycle const* Properties::find(int block, int number) const {
  for (auto const* cycle : counted())
    if (cycle->block == block && cycle->number == number) return cycle;
  return nullptr;
}

std::vector<Cycle const*> Properties::counted() const {
  std::vector<Cycle const*> found;
  for (auto const& block : blocks)
    for (auto const* cycle : block.counted()) found.push_back(cycle);
  return found;
}

std::vector<Cycle const*> Block::whole() const {
  auto found = counted();
  if (found.empty())
    for (auto const& cycle : cycles)
      if (!cycle.partial) found.push_back(&cycle);
  return found;
}

std::vector<Cycle const*> Properties::complete() const {
  std::vector<Cycle const*> found;
  for (auto const& block : blocks)
    for (auto const& cycle : block.cycles)
      if (!cycle.partial) found.push_back(&cycle);
  return found;
}

bool Properties::is_reported(Cycle const& cycle) const {
  return reported && cycle.counts() && reported->block == cycle.block && reported->number == cycle.number;
}

Cycle properties_on(Cycle const& cycle, std::span<double const> disp_mm, std::span<double const> force_kN) {
  assert(disp_mm.size() == force_kN.size());
  Cycle result = cycle;
  auto const peaks = follow(result, disp_mm, force_kN);
  derive(result, peaks);
  result.Q_d_kN = strength(result, peaks, disp_mm, force_kN);
  idealise(result);
  add_residuals(result, peaks, disp_mm, force_kN);
  return result;
}

CycleView view_of(TestRecord const& record) {
  return {record.disp_mm,
          record.force_kN,
          record.time_s,
          record.load_kN,
          record.starts,
          record.logged_cycle,
          record.counts_half_cycles()};
}

Properties cyclic_properties(CycleView const& view) {
  return properties_of(view, {});
}

Properties cyclic_properties(TestRecord const& record) {
  if (record.force_kN.size() != record.disp_mm.size())
    throw Error({.where = record.file, .found = "a motion without force", .allowed = "a record of a test"});
  return properties_of(view_of(record), record.faults);
}

Properties cyclic_properties(std::span<double const> disp_mm, std::span<double const> force_kN) {
  return cyclic_properties(CycleView{disp_mm, force_kN, {}, {}});
}

Stability stability(Block const& block, double Cycle::*property) {
  constexpr int most = 10;
  auto const counted = block.counted();
  auto const at = [&](int number) {
    auto const cycle = std::ranges::find(counted, number, &Cycle::number);
    return cycle == counted.end() ? std::nullopt : std::optional((*cycle)->*property);
  };
  auto const first = at(1), second = at(2), third = at(3);
  Stability found;
  found.cycles = static_cast<int>(counted.size());
  if (!third) return found;
  // A ratio to a value near zero means nothing, so a device without stiffness gets no ratios of stiffness or damping.
  constexpr double nearly_nothing = 1e-3;  // times the largest value
  double largest_size = 0.0;
  for (auto const* cycle : counted) largest_size = std::max(largest_size, std::abs(cycle->*property));
  bool const of_stiffness = property != &Cycle::energy_kN_mm;
  if (!(std::abs(*third) > nearly_nothing * largest_size) ||
      (of_stiffness &&
       std::ranges::any_of(counted, [](Cycle const* c) { return c->amplitude_mm > 0.0 && !c->damping(); })))
    return found;
  for (auto const* cycle : counted) found.ratio_to_third.push_back(cycle->*property / *third);
  if (first) found.first_to_third = *first / *third;
  if (first && second) {
    double const mean = (*first + *second + *third) / 3.0;
    found.first_to_mean_1_3 = *first / mean;
    found.last_to_mean_1_3 = counted.back()->*property / mean;
  }
  auto const upto =
      static_cast<std::size_t>(std::ranges::count_if(counted, [](Cycle const* c) { return c->number <= most; }));
  auto const from = first ? std::size_t{1} : std::size_t{0};
  if (upto < from + 1) return found;
  auto const ratios = std::span(found.ratio_to_third).first(upto);
  if (first) {
    auto const [least, largest] = std::ranges::minmax(ratios);
    found.min_1_10 = least;
    found.max_1_10 = largest;
    found.least_to_largest_1_10 = least / largest;
  }
  auto const [least_2, largest_2] = std::ranges::minmax(ratios.subspan(from));
  found.min_2_10 = least_2;
  found.max_2_10 = largest_2;
  found.least_to_largest_2_10 = least_2 / largest_2;
  return found;
}

Strains strains(Cycle const& cycle, double rubber_thickness_mm, double rubber_area_mm2) {
  assert(rubber_thickness_mm > 0.0 && rubber_area_mm2 > 0.0);
  constexpr double MPa_per_kN_mm2 = 1000.0;
  return {.shear_strain_percent = 100.0 * cycle.amplitude_mm / rubber_thickness_mm,
          .G_MPa = MPa_per_kN_mm2 * cycle.K_eff_kN_per_mm * rubber_thickness_mm / rubber_area_mm2};
}

}  // namespace isolaw::data
