#include "isolaw/study/range_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "isolaw/analysis/steady_cycle.hpp"
#include "isolaw/data/properties/swing_properties.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::study {
namespace {

using analysis::SteadyCycle;

// The displacements and velocities of the lot's tests that decide in which cycles a law is tried.
struct Tested {
  double disp_mm = 0.0;          // the largest displacement
  std::vector<double> vel_mm_s;  // the largest velocity in the largest swing of each test that has time
  double asked_mm = 0.0;         // the displacement of the design, at least disp_mm; if none is stated, twice disp_mm
};

Tested tested_by(Summary const& summary) {
  Tested tested;
  for (auto const& device : summary.devices) {
    auto const& record = device.record;
    for (double const x : record.disp_mm) tested.disp_mm = std::max(tested.disp_mm, std::abs(x));
    if (!record.has_time()) continue;
    for (auto const& test : data::tests_of(record)) {
      auto const swings = data::swings(test.disp_mm, test.time_s);
      if (swings.empty()) continue;
      auto const largest = std::ranges::max(swings, {}, &data::Swing::half_range_mm);
      double fastest = 0.0;
      for (auto i = largest.first; i <= largest.last; ++i) fastest = std::max(fastest, std::abs(test.vel_mm_s[i]));
      tested.vel_mm_s.push_back(fastest);
    }
  }
  auto const& asked = summary.acceptance.design.disp_mm;
  tested.asked_mm = asked ? std::max(*asked, tested.disp_mm) : 2.0 * tested.disp_mm;
  return tested;
}

// Returns `lot` with the device's own displacements if the device's tests reach less than 90 % of the lot's largest
// displacement, and nullopt for other devices. Tests say nothing about displacements far beyond them. Without a stated
// design displacement, the device's parameters are therefore tried only up to twice its own largest displacement.
std::optional<Tested> tested_less(DeviceResult const& device, Summary const& summary, Tested const& lot) {
  constexpr double as_far = 0.9;  // from this share of the lot's largest displacement, a device counts as tested as far
  auto own = lot;
  own.disp_mm = 0.0;
  for (double const x : device.record.disp_mm) own.disp_mm = std::max(own.disp_mm, std::abs(x));
  if (!(own.disp_mm > 0.0) || own.disp_mm >= as_far * lot.disp_mm) return std::nullopt;
  auto const& asked = summary.acceptance.design.disp_mm;
  own.asked_mm = asked ? std::max(*asked, own.disp_mm) : 2.0 * own.disp_mm;
  return own;
}

struct Measured {                      // what was measured on the device to which a law was fitted
  bool viscous = false;                // hardly any of the device's force comes from stiffness
  std::optional<double> damping = {};  // damping ratio in the device's largest cycles
};

Measured measured_on(DeviceResult const& device) {
  Measured measured{.viscous = device.properties.viscous ||
                               std::ranges::find(device.raw.warnings, FindingKind::damping_undefined, &Finding::kind) !=
                                   device.raw.warnings.end()};
  if (auto const swings = data::swing_properties(device.raw)) measured.damping = swings->damping_percent / 100.0;
  return measured;
}

// The cycles in which one set of parameters of a law is tried.
struct Cycles {
  SteadyCycle tested, asked;
  std::array<SteadyCycle, 4> inside;  // at inner_shares of the tested displacement
  // A cycle at the tested displacement with a tested speed. Set only for a law that depends on the velocity, and only
  // if the building's cycles are faster or slower than all tests.
  std::optional<SteadyCycle> at_tested_speed;
};
constexpr std::array inner_shares{0.10, 0.25, 0.50, 0.75};

Finding breach(std::string_view rule, double amplitude_mm, double value = 0.0) {
  return {.kind = FindingKind::law_runs_away,
          .numbers = {{"amplitude_mm", amplitude_mm}, {"value", value}, {"period_s", period_of_building_s}},
          .words = {{"rule", std::string(rule)}}};
}

bool outside(double value, double least, double most) {
  return !(value >= least && value <= most);
}

// Returns the first limit that this cycle exceeds, without comparing it with other cycles.
std::optional<Finding> breach_of(SteadyCycle const& cycle, double amplitude_mm) {
  constexpr double rounding = 1e-6;  // allowed negative energy / energy of a rectangular loop of this largest force
  if (!cycle.finite) return breach("not-finite", amplitude_mm);
  if (cycle.energy_kN_mm < -rounding * 4.0 * amplitude_mm * cycle.largest_kN)
    return breach("gives-energy", amplitude_mm);
  return std::nullopt;
}

// Calls check(cycle, amplitude in mm) for the cycles within the tested displacements until one call returns a finding.
// Returns that finding, or nullopt if there is none.
std::optional<Finding> first_inside(Cycles const& law, Tested const& tested, auto const& check) {
  auto found = check(law.tested, tested.disp_mm);
  for (std::size_t i = 0; i < inner_shares.size() && !found; ++i)
    found = check(law.inside[i], inner_shares[i] * tested.disp_mm);
  return found;
}

// Returns a finding about the first cycle within the tested displacements in which the force overshoots or jumps.
std::optional<Finding> fault_of_shape(Cycles const& law, Tested const& tested, Measured const& measured) {
  if (measured.viscous) return std::nullopt;
  return first_inside(law, tested, [](SteadyCycle const& cycle, double amplitude_mm) -> std::optional<Finding> {
    if (cycle.overshoot > most_overshoot) return breach("overshoots", amplitude_mm, cycle.overshoot);
    if (cycle.jump > most_jump) return breach("jumps", amplitude_mm, cycle.jump);
    return std::nullopt;
  });
}

// Returns a fault within the tested displacements, if there is one. Such a fault makes the law useless for any
// analysis, not only for a building.
std::optional<Finding> fault_inside(Cycles const& law, Tested const& tested, Measured const& measured) {
  auto found = first_inside(law, tested, [](SteadyCycle const& cycle, double mm) { return breach_of(cycle, mm); });
  return found ? found : fault_of_shape(law, tested, measured);
}

std::optional<Finding> breach_of(Cycles const& law, Tested const& tested, Measured const& measured) {
  auto const &here = law.tested, &there = law.asked;
  if (auto found = breach_of(here, tested.disp_mm)) return found;
  if (auto found = breach_of(there, tested.asked_mm)) return found;
  for (std::size_t i = 0; i < inner_shares.size(); ++i)
    if (auto found = breach_of(law.inside[i], inner_shares[i] * tested.disp_mm)) return found;
  if (!measured.viscous) {
    if (!(here.K_kN_per_mm > 0.0)) return breach("not-stiff", tested.disp_mm);
    if (!(there.K_kN_per_mm > 0.0)) return breach("not-stiff", tested.asked_mm);
    double const stiffness = there.K_kN_per_mm / here.K_kN_per_mm;
    if (outside(stiffness, least_stiffness_ratio, most_stiffness_ratio))
      return breach("stiffness", tested.asked_mm, stiffness);
    double const damping = there.damping / here.damping;
    if (here.damping > 0.0 && outside(damping, least_damping_ratio, most_damping_ratio))
      return breach("damping", tested.asked_mm, damping);
    auto const most = measured.damping
                          ? std::min(most_damping, most_times_measured * *measured.damping + damping_above_measured)
                          : most_damping;
    if (here.damping > most) {
      auto found = breach("overdamped", tested.disp_mm, here.damping);
      if (measured.damping) found.numbers.push_back({"measured", *measured.damping});
      return found;
    }
    if (law.at_tested_speed && law.at_tested_speed->damping > 0.0) {
      double const change = here.damping / law.at_tested_speed->damping;
      if (outside(change, 1.0 / most_change_with_speed, most_change_with_speed))
        return breach("speed", tested.disp_mm, change);
    }
  }
  return fault_of_shape(law, tested, measured);
}

// The building's cycles may be faster or slower than all tests. In this case, returns the period [s] with which cycles
// of the tested displacement reach the tested velocity that is nearest to the building's. nullopt if the building's
// velocity lies between those of the tests, or if no velocity is known.
std::optional<double> period_of_tested_speed_s(Tested const& tested) {
  double const asked = 2.0 * std::numbers::pi * tested.disp_mm / period_of_building_s;
  if (tested.vel_mm_s.empty()) return std::nullopt;
  auto const [slowest, fastest] = std::ranges::minmax(tested.vel_mm_s);
  if (asked >= slowest && asked <= fastest) return std::nullopt;
  double const nearest = asked > fastest ? fastest : slowest;
  return nearest > 0.0 ? std::optional(2.0 * std::numbers::pi * tested.disp_mm / nearest) : std::nullopt;
}

std::vector<Cycles> cycles_of(laws::LawEntry const& entry, std::vector<std::vector<double>> const& parameters,
                              Tested const& tested, laws::Integration integration) {
  std::vector<Cycles> all(parameters.size());
  auto const run = [&](double amplitude_mm, double period_s, auto const& keep) {
    auto const found = analysis::steady_cycles(entry, parameters, {amplitude_mm, period_s}, integration);
    for (std::size_t i = 0; i < found.size(); ++i) keep(all[i], found[i]);
  };
  run(tested.disp_mm, period_of_building_s, [](Cycles& to, SteadyCycle const& cycle) { to.tested = cycle; });
  run(tested.asked_mm, period_of_building_s, [](Cycles& to, SteadyCycle const& cycle) { to.asked = cycle; });
  for (std::size_t k = 0; k < inner_shares.size(); ++k)
    run(inner_shares[k] * tested.disp_mm, period_of_building_s,
        [&](Cycles& to, SteadyCycle const& cycle) { to.inside[k] = cycle; });
  if (auto const period = period_of_tested_speed_s(tested); period && !entry.info.traits.rate_independent)
    run(tested.disp_mm, *period, [](Cycles& to, SteadyCycle const& cycle) { to.at_tested_speed = cycle; });
  return all;
}

void test_range(LawResult& law, Summary const& summary, Tested const& tested, campaign::Contents const& contents) {
  std::vector<std::vector<double>> parameters;
  std::vector<DeviceResult const*> devices;  // nullptr: the law of the lot
  if (law.lot) {
    parameters.push_back(law.lot->parameters);
    devices.push_back(nullptr);
  }
  for (auto const& fit : law.devices) {
    auto const device = std::ranges::find(summary.devices, fit.device, &DeviceResult::name);
    auto const index = static_cast<std::size_t>(device - summary.devices.begin());
    auto const* run = contents.best_run(index, law.id);
    if (run == nullptr) continue;
    auto const* analysis = contents.analysis_of(index, law.id);
    parameters.push_back(analysis != nullptr ? analysis->determination.optimum : run->parameters);
    devices.push_back(&*device);
  }
  if (parameters.empty()) return;
  auto const& entry = laws::find_law(law.id);
  auto all = cycles_of(entry, parameters, tested, contents.settings.integration);
  std::vector<Tested> limits(all.size(), tested);
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto const own = devices[i] != nullptr ? tested_less(*devices[i], summary, tested) : std::nullopt;
    if (!own) continue;
    limits[i] = *own;
    all[i] = cycles_of(entry, {parameters[i]}, *own, contents.settings.integration).front();
  }
  auto const as_far = std::ranges::find(limits, tested.disp_mm, &Tested::disp_mm);
  if (as_far == limits.end()) return;
  auto const& shown = all[static_cast<std::size_t>(as_far - limits.begin())];
  law.beyond_tests = BeyondTests{.tested_mm = tested.disp_mm,
                                 .asked_mm = tested.asked_mm,
                                 .K_kN_per_mm = shown.asked.K_kN_per_mm,
                                 .energy_kN_mm = shown.asked.energy_kN_mm,
                                 .stiffness_ratio = shown.asked.K_kN_per_mm / shown.tested.K_kN_per_mm,
                                 .damping_ratio = shown.asked.damping / shown.tested.damping};
  Measured any_viscous;
  for (auto const* device : devices)
    if (device != nullptr && measured_on(*device).viscous) any_viscous.viscous = true;
  std::optional<Finding> of_lot, of_devices;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto const measured = devices[i] != nullptr ? measured_on(*devices[i]) : any_viscous;
    if (auto fault = fault_inside(all[i], limits[i], measured)) {
      fault->kind = FindingKind::law_faulty;
      fault->law = law.id;
      if (devices[i] != nullptr) fault->devices = {devices[i]->name};
      law.faults_inside.push_back(*std::move(fault));
    }
    auto found = breach_of(all[i], limits[i], measured);
    if (!found) continue;
    found->law = law.id;
    found->numbers.push_back({"tested_mm", limits[i].disp_mm});
    if (devices[i] == nullptr) {
      of_lot = std::move(found);
      continue;
    }
    ++refused;
    // The finding holds numbers of the first device that failed. It names another device only if that device was tried
    // at the same displacement.
    if (!of_devices)
      (of_devices = std::move(found))->devices = {devices[i]->name};
    else if (of_devices->number("tested_mm") == limits[i].disp_mm)
      of_devices->devices.push_back(devices[i]->name);
  }
  constexpr std::size_t many = 20;
  constexpr double most_share = 0.05;
  auto const count =
      static_cast<std::size_t>(std::ranges::count_if(devices, [](auto* device) { return device != nullptr; }));
  bool const decides =
      of_devices && (count < many || static_cast<double>(refused) > most_share * static_cast<double>(count));
  law.runs_away = decides ? std::move(of_devices) : std::move(of_lot);
  if (law.runs_away && count == 1) law.runs_away->devices.clear();  // the only device need not be named
}

}  // namespace

void add_range_tests(Summary& summary, campaign::Contents const& contents) {
  auto const tested = tested_by(summary);
  if (!(tested.disp_mm > 0.0)) return;
  for (auto& law : summary.laws) test_range(law, summary, tested, contents);
}

}  // namespace isolaw::study
