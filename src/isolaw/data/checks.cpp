#include "isolaw/data/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/record_parts.hpp"
#include "isolaw/data/channels/time_gaps.hpp"
#include "isolaw/data/files/time_stamp.hpp"
#include "isolaw/data/properties/error_budget.hpp"
#include "isolaw/data/signals/signal_faults.hpp"

namespace isolaw::data {
namespace {

struct Loop {
  double energy_kN_mm = 0.0;
  double slope_kN_per_mm = 0.0;
  double correlation = 0.0;
  double equivalent_damping = 0.0;  // energy / area of ellipses; see measure_loop()
};

Loop measure_loop(TestRecord const& record, std::vector<Cycle const*> const& cycles) {
  Loop loop;
  for (auto const* cycle : cycles) loop.energy_kN_mm += cycle->energy_kN_mm;
  auto const first = static_cast<std::size_t>(cycles.front()->first);
  auto const end = std::min(record.size(), static_cast<std::size_t>(cycles.back()->last) + 1);
  auto const count = static_cast<double>(end - first);
  double mean_x = 0.0;
  double mean_F = 0.0;
  for (auto i = first; i < end; ++i) {
    mean_x += record.disp_mm[i] / count;
    mean_F += record.force_kN[i] / count;
  }
  double xx = 0.0;
  double xF = 0.0;
  double FF = 0.0;
  for (auto i = first; i < end; ++i) {
    double const x = record.disp_mm[i] - mean_x;
    double const F = record.force_kN[i] - mean_F;
    xx += x * x;
    xF += x * F;
    FF += F * F;
  }
  loop.slope_kN_per_mm = xF / xx;
  loop.correlation = xF / std::sqrt(xx * FF);
  // equivalent_damping divides the energy by the area of ellipses, one for each cycle, that have the record's standard
  // deviations of x and F. The widest such ellipse is taken, in which x and F are uncorrelated: 2 pi sigma_x sigma_F.
  double const fullest = 2.0 * std::numbers::pi * std::sqrt(xx * FF) / count * static_cast<double>(cycles.size());
  loop.equivalent_damping = loop.energy_kN_mm / fullest;
  return loop;
}

// Warns if the stiffness is far outside the range of isolators, as for a steel bar or a rubber band, or if the travel
// is metres long. A unit is then probably wrong.
void warn_about_magnitude(TestRecord& record) {
  constexpr double stiffest_kN_per_mm = 100.0;
  constexpr double softest_kN_per_mm = 0.001;
  auto const [least_x, largest_x] = std::ranges::minmax(record.disp_mm);
  auto const [least_F, largest_F] = std::ranges::minmax(record.force_kN);
  double const stiffness = (largest_F - least_F) / (largest_x - least_x);
  constexpr double widest_mm = 4000.0;
  bool const plausible = stiffness >= softest_kN_per_mm && stiffness <= stiffest_kN_per_mm;
  if (plausible && largest_x - least_x <= widest_mm) return;
  auto const unit = [&](Channel channel) {
    auto const found = record.layout.units.find(channel);
    if (found != record.layout.units.end()) return found->second;
    return std::string(channel == Channel::disp ? "mm" : "kN");  // values that did not come from a file
  };
  record.warnings.push_back({.kind = FindingKind::units_implausible,
                             .numbers = {{"force_kN", largest_F - least_F},
                                         {"way_mm", largest_x - least_x},
                                         {"stiffness_kN_per_mm", stiffness}},
                             .words = {{"disp_unit", unit(Channel::disp)},
                                       {"force_unit", unit(Channel::force)},
                                       {"than_any", plausible                        ? "longer"
                                                    : stiffness > stiffest_kN_per_mm ? "stiffer"
                                                                                     : "softer"}}});
}

// Warns of a motion that hardly any rig of a laboratory makes, and of a horizontal force too large for the vertical
// load. The limits leave room for fast rigs, because a wrong unit makes a motion ten times as large or more.
void warn_about_rig(TestRecord& record, Properties const& properties) {
  constexpr double farthest_mm = 1300.0, fastest_mm_s = 3000.0, most_of_load = 2.0;
  double amplitude_mm = 0.0, speed_mm_s = 0.0;
  for (auto const& block : properties.blocks) {
    amplitude_mm = std::max(amplitude_mm, block.amplitude_mm);
    speed_mm_s = std::max(speed_mm_s, block.v_max_mm_s.value_or(0.0));
  }
  if (amplitude_mm > farthest_mm || speed_mm_s > fastest_mm_s) {
    auto const given = record.layout.units.find(Channel::disp);
    auto const unit = given == record.layout.units.end() ? std::string("mm") : given->second;
    Finding finding{.kind = FindingKind::motion_implausible,
                    .numbers = {{"amplitude_mm", amplitude_mm}},
                    .words = {{"disp_unit", unit}, {"likely", unit == "mm" ? "" : "mm"}}};
    if (speed_mm_s > 0.0) finding.numbers.push_back({"speed_mm_s", speed_mm_s});
    record.warnings.push_back(std::move(finding));
  }
  if (record.load_kN.empty()) return;
  double load_kN = 0.0, force_kN = 0.0;
  for (double const load : record.load_kN) load_kN += std::abs(load) / static_cast<double>(record.load_kN.size());
  for (double const force : record.force_kN) force_kN = std::max(force_kN, std::abs(force));
  if (load_kN > 0.0 && force_kN > most_of_load * load_kN)
    record.warnings.push_back(
        {.kind = FindingKind::force_beyond_load,
         .numbers = {{"force_kN", force_kN}, {"ratio", force_kN / load_kN}, {"load_kN", load_kN}}});
}

// Warns of gaps in time that last longer than the device needed to cross them at its speed (Gap::taken_s). There is no
// warning if the device stands still on both sides of a gap, because the logger then only skipped a rest.
void warn_of_gaps(TestRecord& record) {
  auto gaps = time_gaps(record.disp_mm, record.time_s);
  std::erase_if(gaps, [](Gap const& gap) { return gap.taken_s >= gap.length_s; });
  if (gaps.empty()) return;
  auto const& gap = *std::ranges::max_element(gaps, {}, &Gap::length_s);
  record.warnings.push_back({.kind = FindingKind::time_jumps,
                             .numbers = {{"count", static_cast<double>(gaps.size())},
                                         {"length_s", gap.length_s},
                                         {"sample", static_cast<double>(gap.last_before + 1)},
                                         {"time_s", record.time_s[gap.last_before]},
                                         {"taken_s", gap.taken_s}}});
}

// Warns if times read as seconds look like a spreadsheet's days: large numbers that grow by less than 1 in the test.
void warn_of_days(TestRecord& record) {
  if (record.time_s.empty() || !may_be_serial(record.time_s.front()) || !may_be_serial(record.time_s.back())) return;
  constexpr double fastest_Hz =
      1000.0;  // a test of less than 1 s rarely has a higher rate; such times are taken as days
  double const length = record.time_s.back() - record.time_s.front();
  double const rate = static_cast<double>(record.time_s.size() - 1) / length;
  if (length > 1.0 || rate < fastest_Hz) return;
  record.warnings.push_back(
      {.kind = FindingKind::time_in_days,
       .numbers = {{"first_s", record.time_s.front()}, {"last_s", record.time_s.back()}, {"rate_Hz", rate}}});
}

}  // namespace

void check_physics(TestRecord const& record, Properties const& properties, std::string const& exchange_advice) {
  auto const cycles = properties.complete();
  if (cycles.empty() || !properties.faults.empty()) return;  // a faulty signal is already reported
  auto const loop = measure_loop(record, cycles);
  // If the force is recorded late, the energy of a nearly elastic device may come out slightly negative. Such a record
  // is still read.
  constexpr double significant_energy = 0.02;
  constexpr double significant_correlation = 0.2;
  if (loop.equivalent_damping > -significant_energy) return;
  auto const values = fmt::format("energy per cycle {:.4g} kN mm, stiffness {:.4g} kN/mm",
                                  loop.energy_kN_mm / static_cast<double>(cycles.size()), loop.slope_kN_per_mm);
  std::string const flip = record.layout.flip_force ? "leave --flip-force out" : "--flip-force";
  std::string const allowed = "a device that dissipates energy and resists displacement: both positive";
  if (loop.correlation > significant_correlation)
    throw Error({record.file, "force and displacement seem swapped: " + values, allowed, exchange_advice});
  if (loop.correlation < -significant_correlation)
    throw Error({record.file, "the force's sign is flipped: " + values, allowed, flip});
  throw Error({record.file, "the force's sign is flipped, or force and displacement are swapped: " + values, allowed,
               flip + " or " + exchange_advice});
}

void find_faults(TestRecord& record) {
  record.faults.clear();
  for (auto const& test : test_ranges(record.starts, record.size()))
    for (auto& fault :
         signal_faults(test.slice(record.disp_mm), test.slice(record.force_kN), test.slice(record.time_s))) {
      for (auto& sample : fault.samples) sample += test.first;
      record.faults.push_back(std::move(fault));
    }
}

void add_warnings(TestRecord& record, Properties const& properties) {
  auto& warnings = record.warnings;
  warn_about_magnitude(record);
  // If no block is sound, the other warnings are computed from faulty signals and may be wrong, so they are left out.
  if (properties.refusal_is_of_fault && !properties.faults.empty()) return append(warnings, properties.refusal);
  append(warnings, properties.block_faults);
  for (auto const& fault : properties.faults)
    if (fault.is_outside()) warnings.push_back(fault.finding);
  if (properties.failure) warnings.push_back(*properties.failure);
  auto const [least, largest] = std::ranges::minmax(record.disp_mm);
  double const half_range = (largest - least) / 2.0, start = record.disp_mm.front();
  if (std::abs(start) > 0.05 * half_range)
    warnings.push_back(
        {.kind = FindingKind::starts_off_zero,
         .numbers = {
             {"disp_mm", start}, {"percent", 100.0 * std::abs(start) / half_range}, {"half_range_mm", half_range}}});
  warn_about_rig(record, properties);
  warn_of_gaps(record);
  warn_of_days(record);
  if (properties.reported && !properties.reported->damping() && !properties.viscous)
    warnings.push_back({.kind = FindingKind::damping_undefined});
  append(warnings, error_budget(record, properties).warnings);
  append(warnings, properties.refusal);
}

}  // namespace isolaw::data
