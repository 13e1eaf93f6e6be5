#include "isolaw/building/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "isolaw/building/linear_oscillator.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/laws/plane/in_plane.hpp"

namespace isolaw::building {
namespace {

struct Component {
  double peak_mm_s2 = 0.0, mean_mm_s2 = 0.0, largest_mm_s = 0.0, final_mm_s = 0.0;
};

Component of(std::vector<double> const& ground, double step_s) {
  Component found;
  double velocity = 0.0, before = 0.0;
  for (double const a : ground) {
    found.peak_mm_s2 = std::max(found.peak_mm_s2, std::abs(a));
    found.mean_mm_s2 += a / static_cast<double>(ground.size());
    velocity += 0.5 * step_s * (before + a);
    found.largest_mm_s = std::max(found.largest_mm_s, std::abs(velocity));
    before = a;
  }
  found.final_mm_s = velocity;
  return found;
}

}  // namespace

std::vector<Finding> motion_doubts(Motion const& motion) {
  auto doubts = motion.notes;
  for (auto const& [axis, ground] : {std::pair{"x", &motion.x_mm_s2}, {"y", &motion.y_mm_s2}}) {
    auto const found = of(*ground, motion.step_s);
    if (found.peak_mm_s2 == 0.0) continue;
    auto const doubt = [&, axis = axis](FindingKind kind, std::vector<FindingNumber> numbers) {
      doubts.push_back(
          {.kind = kind, .numbers = std::move(numbers), .words = {{"motion", motion.name}, {"axis", axis}}});
    };
    double const peak_g = found.peak_mm_s2 / data::gravity_mm_s2;
    double const mean = std::abs(found.mean_mm_s2) / found.peak_mm_s2;
    double const final = std::abs(found.final_mm_s) / found.largest_mm_s;
    if (peak_g > largest_ground_g)
      doubt(FindingKind::ground_too_strong, {{"peak_g", peak_g}, {"limit_g", largest_ground_g}});
    if (mean > largest_mean_share)
      doubt(FindingKind::ground_off_zero, {{"mean_percent", 100.0 * mean}});
    else if (final > largest_final_share)
      doubt(FindingKind::ground_keeps_moving, {{"final_mm_s", found.final_mm_s}, {"largest_mm_s", found.largest_mm_s}});
  }
  return doubts;
}

std::vector<Finding> study_doubts(Study const& study) {
  std::vector<Finding> doubts;
  for (auto const& motion : study.file.motions) std::ranges::move(motion_doubts(motion), std::back_inserter(doubts));
  double mass_Mg = study.file.frame.base.mass_Mg;
  for (auto const& floor : study.file.frame.floors) mass_Mg += floor.slab.mass_Mg;
  for (auto const& law : study.laws) {
    std::vector<Coupling> couplings;
    for (auto const& motion : study.file.motions) couplings.push_back(coupling_under(motion, law));
    auto const acts = [&](Coupling coupling) { return std::ranges::find(couplings, coupling) != couplings.end(); };
    if (acts(Coupling::springs) && law.springs.empty())
      doubts.push_back({.kind = FindingKind::springs_as_given, .law = law.law});
    if (acts(Coupling::separate) && !laws::springs_follow(law.law))
      doubts.push_back({.kind = FindingKind::unequal_sides, .law = law.law, .words = {{"how", "along axes"}}});
    Devices const devices(law, study.file, study.file.motions.front());
    double const amplitude_mm = law.tested_mm > 0.0 ? 0.5 * law.tested_mm : 100.0;
    // Laws that depend on velocity need a period for their effective stiffness: this is a usual one of isolated
    // buildings.
    constexpr double usual_s = 2.0;
    double const k = effective(devices, devices.parameters_of({}), amplitude_mm, usual_s).stiffness_kN_mm;
    double const period_s = 2.0 * std::numbers::pi * std::sqrt(Mg_in_mass * mass_Mg / k);
    if (period_s < least_period_s || period_s > most_period_s)
      doubts.push_back({.kind = FindingKind::period_implausible,
                        .law = law.law,
                        .numbers = {{"period_s", period_s},
                                    {"amplitude_mm", amplitude_mm},
                                    {"least_s", least_period_s},
                                    {"most_s", most_period_s}}});
  }
  return doubts;
}

std::vector<Finding> run_doubts(Response const& run, std::string const& law, std::string const& motion,
                                double largest_test_mm) {
  std::vector<Finding> doubts;
  auto const doubt = [&](FindingKind kind, std::vector<FindingNumber> numbers) {
    doubts.push_back({.kind = kind, .law = law, .numbers = std::move(numbers), .words = {{"motion", motion}}});
  };
  if (double const most = run.value(Measure::isolator); largest_test_mm > 0.0 && most > largest_test_mm)
    doubt(FindingKind::displacement_beyond_tests, {{"most_mm", most}, {"tested_mm", largest_test_mm}});
  if (double const error = std::abs(run.value(Measure::balance)); error > largest_energy_error) {
    doubt(FindingKind::energy_error_large, {{"error", error}, {"limit", largest_energy_error}});
    doubts.back().words.push_back({"whose", "the nominal building"});
  }
  if (double const rotation = run.value(Measure::rotation); rotation > largest_rotation_rad)
    doubt(FindingKind::rotation_large, {{"rotation_rad", rotation}, {"limit_rad", largest_rotation_rad}});
  return doubts;
}

}  // namespace isolaw::building
