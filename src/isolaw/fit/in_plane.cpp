#include "isolaw/fit/in_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace isolaw::fit {

using laws::Bidirectional;
using laws::plane::Softening;
using laws::plane::Vector;

laws::InPlane LawInPlane::form(Bidirectional how, Softening softening) const {
  auto const id = law->info.id;
  if (how == Bidirectional::coupled) return laws::InPlane::coupled(id, parameters, softening);
  return laws::InPlane::springs(
      laws::Online(id, parameters, dead_band_mm / law->info.length.in_record_units, refinement));
}

std::vector<Vector<double>> force_kN(laws::LawEntry const& law, laws::InPlane in_plane, PlaneMotion const& motion) {
  double const per_mm = 1.0 / law.info.length.in_record_units, to_kN = law.info.force.in_record_units;
  std::vector<Vector<double>> forces;
  forces.reserve(motion.disp_mm.size());
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i) {
    Vector<double> const v = motion.vel_mm_s.empty() ? Vector<double>{0.0, 0.0} : motion.vel_mm_s[i];
    double const dt = i > 0 && !motion.vel_mm_s.empty() ? motion.time_s[i] - motion.time_s[i - 1] : 0.0;
    forces.push_back(to_kN * in_plane.trial(per_mm * motion.disp_mm[i], per_mm * v, dt).force);
    in_plane.commit();
  }
  return forces;
}

std::vector<FigureOfEightResult> on_a_figure_of_eight(LawInPlane const& law, double size_mm, double duration_s) {
  constexpr int samples = 200, turns = 2;
  PlaneMotion motion;
  double const rate = 2.0 * std::numbers::pi / duration_s;
  for (int i = 0; i <= turns * samples; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples;
    motion.time_s.push_back(duration_s * i / samples);
    motion.disp_mm.push_back({size_mm * std::sin(phase), 0.5 * size_mm * std::sin(2.0 * phase)});
    motion.vel_mm_s.push_back({rate * size_mm * std::cos(phase), rate * size_mm * std::cos(2.0 * phase)});
  }
  std::vector<FigureOfEightResult> results;
  auto const add = [&](std::string_view rule, Bidirectional how, Softening softening) {
    auto const force = force_kN(*law.law, law.form(how, softening), motion);
    FigureOfEightResult result{rule, 0.0, 0.0};
    for (std::size_t i = (turns - 1) * samples + 1; i < force.size(); ++i) {
      result.peak_kN = std::max(result.peak_kN, std::hypot(force[i].x, force[i].y));
      result.work_kN_mm += 0.5 * laws::plane::dot(force[i] + force[i - 1], motion.disp_mm[i] - motion.disp_mm[i - 1]);
    }
    results.push_back(result);
  };
  if (!laws::no_coupled_form(law.law->info.id, law.parameters)) {
    bool const softens = laws::softens_with_the_peak(law.law->info.id);
    add(softens ? "coupled, softened by distance" : "coupled", Bidirectional::coupled, Softening::by_distance);
    if (softens) add("coupled, softened by axis", Bidirectional::coupled, Softening::by_axis);
  }
  add("springs", Bidirectional::springs, Softening::by_distance);
  return results;
}

double work_of_springs_on_a_line(LawInPlane const& law, double size_mm, double duration_s) {
  constexpr int samples = 200, cycles = 2;
  double const length = size_mm / law.law->info.length.in_record_units;
  laws::Online alone(law.law->info.id, law.parameters, law.dead_band_mm / law.law->info.length.in_record_units,
                     law.refinement);
  auto springs = law.form(Bidirectional::springs, Softening::by_distance);
  double of_law = 0.0, of_springs = 0.0, before_law = 0.0, before_springs = 0.0, x0 = 0.0;
  for (int i = 0; i <= cycles * samples; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples, rate = 2.0 * std::numbers::pi / duration_s;
    double const x = length * std::sin(phase), v = rate * length * std::cos(phase);
    double const f_law = alone.trial(x, v).force;
    double const f_springs = springs.trial({x, 0.0}, {v, 0.0}, duration_s / samples).force.x;
    alone.commit();
    springs.commit();
    if (i > (cycles - 1) * samples) {
      of_law += 0.5 * (f_law + before_law) * (x - x0);
      of_springs += 0.5 * (f_springs + before_springs) * (x - x0);
    }
    before_law = f_law;
    before_springs = f_springs;
    x0 = x;
  }
  return of_springs / of_law;
}

LargestDifference largest_difference_of(std::vector<FigureOfEightResult> const& rules) {
  LargestDifference difference;
  for (auto const& a : rules)
    for (auto const& b : rules) {
      difference.peak = std::max(difference.peak, (a.peak_kN - b.peak_kN) / std::abs(rules.front().peak_kN));
      difference.work = std::max(difference.work, (a.work_kN_mm - b.work_kN_mm) / std::abs(rules.front().work_kN_mm));
    }
  return difference;
}

}  // namespace isolaw::fit
