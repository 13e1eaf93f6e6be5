#include "isolaw/data/signals/corrections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/record_parts.hpp"
#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/data/signals/smoothing.hpp"
#include "isolaw/data/signals/spikes.hpp"

namespace isolaw::data {
namespace {

// The acceleration at a sample is computed from the displacement there and 1/40 of a cycle before and after.
constexpr double samples_to_average = 40.0;

void note(TestRecord& record, FindingKind kind, std::string option, std::vector<FindingNumber> numbers) {
  record.corrections.push_back({.kind = kind, .numbers = std::move(numbers), .words = {{"option", std::move(option)}}});
  record.recognised.push_back(record.corrections.back());
}

void repair_channel(TestRecord& record, std::vector<double>& values, std::string const& name, std::string_view unit) {
  auto mended = record.disp_mm;
  for (auto const& spike : spikes(mended)) mended[spike.at] = spike.expected;
  auto const found = spikes_in(values, small_stages(mended, record.time_s));
  std::vector<std::size_t> samples;
  for (auto const& spike : found) samples.push_back(spike.at);
  auto finding = finding_at(FindingKind::spikes_repaired, name, unit, samples, record.time_s);
  for (std::size_t k = 0; k < found.size(); ++k) {
    auto const which = k == 0 ? std::string() : fmt::format("_{}", k + 1);
    auto& value = values[found[k].at];
    if (finding.has_number("sample" + which)) {
      finding.numbers.push_back({fmt::format("from_{}{}", unit, which), value});
      finding.numbers.push_back({fmt::format("to_{}{}", unit, which), found[k].expected});
    }
    value = found[k].expected;
  }
  finding.words.push_back({"option", "--repair"});
  record.recognised.push_back(finding);
  record.corrections.push_back(std::move(finding));
}

void remove_skew(TestRecord& record, double skew_s) {
  auto const& time = record.time_s;
  auto const known = [&](double t) { return t >= time.front() && t <= time.back(); };
  std::vector<double> moved(record.size());
  std::size_t begin = record.size(), end = 0, after = 1;
  for (std::size_t i = 0; i < record.size(); ++i) {
    double const then = time[i] + skew_s;
    if (!known(then)) continue;
    begin = std::min(begin, i);
    end = i + 1;
    while (after + 1 < record.size() && time[after] < then) ++after;
    double const part = (then - time[after - 1]) / (time[after] - time[after - 1]);
    moved[i] = record.force_kN[after - 1] + part * (record.force_kN[after] - record.force_kN[after - 1]);
  }
  if (begin >= end || end - begin < 3)
    throw Error({"--skew-ms",
                 fmt::format("{:.6g} ms in a record of {:.6g} s", 1000.0 * skew_s, time.back() - time.front()),
                 "a skew much shorter than the record", "leave it out"});
  auto const dropped = record.size() - (end - begin);
  record.force_kN = std::move(moved);
  for (auto const channel : all_channels) keep({.first = begin, .count = end - begin}, values_of(record, channel));
  record.faults = faults_in({.first = begin, .end = end}, record.faults);
  note(record, FindingKind::skew_removed, "--skew-ms",
       {{"skew_ms", 1000.0 * skew_s}, {"dropped_samples", static_cast<double>(dropped)}});
}

// Friction changes its sign at sample `at`, near a peak of displacement. `there` is 1 if friction still has its old
// sign at this sample, and 0 if it is zero there.
struct Turn {
  std::size_t at;
  double there;
};

// The sample of the peak is uncertain, because displacement hardly changes near it. Friction is assumed to change its
// sign where the force without friction is then smoothest, or at the peak if no other sample is clearly better.
Turn turn_about(std::size_t peak, double approach, std::vector<double> const& force,
                std::vector<double> const& friction) {
  constexpr std::size_t reach = 2;
  Turn best{peak, 0.0};
  if (peak < reach + 2 || peak + reach + 2 >= force.size()) return best;
  auto const roughness = [&](Turn const& turn) {
    auto const rest = [&](std::size_t i) {
      double const way = i < turn.at ? 1.0 : i == turn.at ? turn.there : -1.0;
      return force[i] - way * approach * friction[i];
    };
    double sum = 0.0;
    for (auto i = peak - reach - 1; i <= peak + reach + 1; ++i) {
      double const bend = rest(i - 1) - 2.0 * rest(i) + rest(i + 1);
      sum += bend * bend;
    }
    return sum;
  };
  constexpr double clearly = 0.5;
  double least = clearly * roughness(best);
  for (auto at = peak - reach; at <= peak + reach; ++at)
    for (double const there : {0.0, 1.0}) {
      Turn const turn{at, there};
      if (double const found = roughness(turn); found < least) best = turn, least = found;
    }
  return best;
}

// The direction of motion at each sample, +1 or -1. It changes only at reversals, so that noise of displacement cannot
// change it. It is 0 while the record rests at its start or end, and may be 0 at the sample of a turn.
std::vector<double> directions(std::vector<double> const& x, std::vector<double> const& force,
                               std::vector<double> const& friction) {
  auto const sign = [](double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; };
  std::vector<double> found(x.size(), 0.0);
  auto const motion = reversals(x);
  if (motion.at.size() < 2) return found;
  std::vector<std::pair<Turn, double>> turns;  // each turn of the motion, with the direction (+1 or -1) before it
  for (std::size_t k = 1; k < motion.at.size(); ++k) {
    double const direction = sign(x[motion.at[k]] - x[motion.at[k - 1]]);
    for (auto i = motion.at[k - 1] + 1; i < motion.at[k]; ++i) found[i] = direction;
    auto const peak = motion.at[k];
    if (peak + 1 >= x.size()) continue;
    auto const turn = turn_about(peak, direction, force, friction);
    turns.push_back({turn, direction});
  }
  for (std::size_t k = 0; k < turns.size(); ++k) {
    auto const& [turn, approach] = turns[k];
    auto const peak = motion.at[k + 1];
    for (auto i = std::min(turn.at, peak); i <= std::max(turn.at, peak); ++i)
      found[i] = approach * (i < turn.at ? 1.0 : i == turn.at ? turn.there : -1.0);
  }
  // After its last extreme, displacement either rests within the noise or turns once more before the record ends. The
  // last sample gives the direction; the direction in a rest becomes 0 below.
  double const tail = sign(x.back() - x[motion.at.back()]);
  for (auto i = motion.at.back() + 1; i < x.size(); ++i) found[i] = tail;
  for (std::size_t i = 0; i < x.size() && std::abs(x[i] - x.front()) <= motion.band_mm; ++i) found[i] = 0.0;
  for (auto i = x.size(); i-- > 0 && std::abs(x[i] - x.back()) <= motion.band_mm;) found[i] = 0.0;
  return found;
}

void remove_friction(TestRecord& record, Corrections const& corrections) {
  bool const constant = corrections.friction_kN.has_value();
  double const factor = constant ? *corrections.friction_kN : *corrections.friction_coefficient;
  std::vector<double> friction(record.size(), factor);
  if (!constant)
    for (std::size_t i = 0; i < record.size(); ++i) friction[i] *= std::abs(record.load_kN[i]);
  auto const direction = directions(record.disp_mm, record.force_kN, friction);
  for (std::size_t i = 0; i < record.size(); ++i) record.force_kN[i] -= direction[i] * friction[i];
  note(record, FindingKind::friction_removed, constant ? "--rig-friction" : "--rig-friction-coefficient",
       {{constant ? "friction_kN" : "coefficient", factor}});
}

// Second derivative at sample i from the samples `reach` before and after it, at their recorded times.
double second_difference(std::vector<double> const& x, std::vector<double> const& t, std::size_t i, std::size_t reach) {
  auto const at = std::clamp(i, reach, x.size() - 1 - reach);
  double const before = t[at] - t[at - reach];
  double const after = t[at + reach] - t[at];
  return 2.0 * ((x[at + reach] - x[at]) / after - (x[at] - x[at - reach]) / before) / (before + after);
}

void remove_inertia(TestRecord& record, double mass_kg) {
  auto const motion = reversals(record.disp_mm);
  double const swings = std::max<double>(1.0, static_cast<double>(motion.at.size()) - 2.0);
  double const per_cycle = motion.at.size() < 3
                               ? static_cast<double>(record.size())
                               : 2.0 * static_cast<double>(motion.at[motion.at.size() - 2] - motion.at[0]) / swings;
  auto const most = (record.size() - 1) / 2;
  auto const reach = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(per_cycle / samples_to_average)), 1,
                                             std::max<std::size_t>(1, most));
  int const window = 2 * static_cast<int>(reach / 2) + 1;
  auto smooth = record.disp_mm;
  for (int pass = 0; pass < 3; ++pass) smooth = moving_average(smooth, window);
  constexpr double kN_per_kg_mm_s2 = 1e-6;
  std::vector<double> inertia(record.size());
  for (std::size_t i = 0; i < record.size(); ++i)
    inertia[i] = kN_per_kg_mm_s2 * mass_kg * second_difference(smooth, record.time_s, i, reach);
  for (std::size_t i = 0; i < record.size(); ++i) record.force_kN[i] -= inertia[i];
  auto const [least, largest] = std::ranges::minmax(inertia);
  note(record, FindingKind::inertia_removed, "--moving-mass",
       {{"mass_kg", mass_kg}, {"least_kN", least}, {"largest_kN", largest}, {"window_samples", window * 1.0}});
}

void require_channels(TestRecord const& record, Corrections const& corrections) {
  std::vector<Complaint> complaints;
  auto const needs_time = [&](std::optional<double> const& value, std::string const& option) {
    if (value && !record.has_time())
      complaints.push_back({record.file, option + " for a record without time", "a record with time", "--dt SECONDS"});
  };
  needs_time(corrections.skew_s, "--skew-ms");
  needs_time(corrections.moving_mass_kg, "--moving-mass");
  if (corrections.friction_coefficient && record.load_kN.empty())
    complaints.push_back({record.file, "--rig-friction-coefficient for a record without a vertical load",
                          "a record with a vertical load",
                          "--columns load=NAME, or --rig-friction with the force in kN"});
  if (record.size() < 3) complaints.push_back({record.file, counted(record.size(), "sample"), "3 or more", {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

}  // namespace

void repair(TestRecord& record, Corrections const& corrections) {
  if (!corrections.repair_spikes) return;
  repair_channel(record, record.disp_mm, "displacement", "mm");
  repair_channel(record, record.force_kN, "force", "kN");
}

void correct(TestRecord& record, Corrections const& corrections) {
  corrections.validate();
  if (!corrections.any()) return;
  require_channels(record, corrections);
  if (corrections.skew_s && *corrections.skew_s != 0.0) remove_skew(record, *corrections.skew_s);
  if (corrections.friction_kN || corrections.friction_coefficient) remove_friction(record, corrections);
  if (corrections.moving_mass_kg) remove_inertia(record, *corrections.moving_mass_kg);
  if (!corrections.force_factor) return;
  for (double& force : record.force_kN) force *= *corrections.force_factor;
  note(record, FindingKind::force_multiplied, "--force-factor", {{"factor", *corrections.force_factor}});
}

}  // namespace isolaw::data
