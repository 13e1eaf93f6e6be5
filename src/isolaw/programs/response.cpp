#include "isolaw/programs/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "isolaw/building/answers.hpp"
#include "isolaw/building/integrate.hpp"
#include "isolaw/building/synthetic_motion.hpp"

namespace isolaw::programs {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Peaks {
  double disp_mm = 0.0, shear_kN = 0.0;
};

// Returns the differences of peak displacement and peak shear from `truth`, in percent of the values in `truth`.
std::array<double, 2> differences(Peaks const& value, Peaks const& truth) {
  return {100.0 * (value.disp_mm / truth.disp_mm - 1.0), 100.0 * (value.shear_kN / truth.shear_kN - 1.0)};
}

// A rigid mass on one bearing that moves along a line.
class MassOnBearing {
 public:
  MassOnBearing(double mass_Mg, laws::LawEntry const& law, std::span<double const> parameters,
                double dead_band_mm = 0.0, int refinement = 1)
      : model_(building::Structure({.base = {.mass_Mg = mass_Mg, .gyration_mm = 1e3}, .floors = {}}),
               {.bearings = {{}}}),
        virgin_(
            building::make_bearing(law.info.id, parameters, building::Coupling::separate, dead_band_mm, refinement)) {}

  // The peak responses. Empty if the integration did not reach the end of the motion.
  std::optional<Peaks> under(data::GroundMotion const& motion) const {
    std::vector<std::unique_ptr<building::Bearing>> bearing;
    bearing.push_back(virgin_->copy());
    auto const run = building::integrate(
        model_, bearing, {.name = motion.file, .step_s = motion.step_s, .x_mm_s2 = motion.acceleration_mm_s2});
    if (run.outcome != building::Outcome::completed) return std::nullopt;
    return Peaks{.disp_mm = run.value(building::Measure::isolator), .shear_kN = run.value(building::Measure::shear)};
  }

 private:
  building::Model model_;
  std::unique_ptr<building::Bearing> virgin_;
};

data::GroundMotion scaled(data::GroundMotion motion, double scale) {
  for (double& a : motion.acceleration_mm_s2) a *= scale;
  return motion;
}

struct Scaled {
  double scale = 1.0;
  data::GroundMotion motion;
  Peaks peaks;
};

// Scales a motion so that the peak displacement of the mass is `target_mm`, or up to 2 % less. The first factor tried
// is `scale`. Returns nullopt if none of 20 factors fits.
std::optional<Scaled> scaled_to(data::GroundMotion const& motion, MassOnBearing const& mass, double target_mm,
                                double scale) {
  constexpr double near = 0.98;
  constexpr int most = 20;
  double low = 0.0, high = 0.0;
  for (int i = 0; i < most; ++i) {
    auto tried = scaled(motion, scale);
    auto const peaks = mass.under(tried);
    bool const exceeds = !peaks || peaks->disp_mm > target_mm;
    (exceeds ? high : low) = scale;
    if (!exceeds && peaks->disp_mm >= near * target_mm) {
      tried.file = fmt::format("{:.3g} x {}", scale, motion.file);
      return Scaled{.scale = scale, .motion = std::move(tried), .peaks = *peaks};
    }
    // If the peak were proportional to the scale, multiplying the scale by `ratio` would reach the target. But the peak
    // may hardly change over a range of scales, or jump. Until the target lies between two tried scales, the scale is
    // therefore multiplied by ratio^2. From then on, every second step takes the geometric mean of these two scales.
    bool const between = low > 0.0 && high > 0.0;
    double const ratio = peaks ? 0.5 * (1.0 + near) * target_mm / peaks->disp_mm : 0.5;
    scale *= between ? ratio : ratio * ratio;
    if (between && (i % 2 == 1 || scale <= low || scale >= high)) scale = std::sqrt(low * high);
  }
  return std::nullopt;
}

// K_eff of the law in the second of two cycles, which has the tested amplitude.
double stiffness_of(Subject const& subject) {
  auto const force = tested_cycles(subject).law_kN;
  auto const [low, high] =
      std::minmax_element(force.begin() + static_cast<std::ptrdiff_t>(force.size() / 2), force.end());
  return (*high - *low) / (2.0 * subject.tested.disp_mm);
}

std::vector<data::GroundMotion> given_motions(Subject const& subject) {
  if (!subject.motions.empty() || !subject.model) return subject.motions;
  return {scaled(subject.model->motions.front(), subject.model->scale)};
}

}  // namespace

BuildingOnLaw::BuildingOnLaw(Subject const& subject) : law_(subject.law->info.id) {
  auto& all = on_law_;
  double const stiffness = stiffness_of(subject);
  if (!(stiffness > 0.0)) {
    all.why_not = "the law has no stiffness at the tested amplitude";
    return;
  }
  std::optional<double> load_kN;
  if (subject.model) {
    load_kN = subject.model->weight_kN / static_cast<double>(subject.model->bearings.size());
    all.mass_from = "the mean load of the model's isolators";
  } else if (auto const load = subject.tested.load_mean_kN; load && *load > 0.0) {
    load_kN = load;
    all.mass_from = "the vertical load of the tests";
  }
  double const rate = 2.0 * std::numbers::pi / usual_period_s;
  double const mass = load_kN ? *load_kN / data::gravity_mm_s2 : stiffness / (rate * rate);
  if (!load_kN) all.mass_from = "no vertical load is known, so it follows from the period";
  all.mass_Mg = mass / building::Mg_in_mass;
  all.period_s = 2.0 * std::numbers::pi * std::sqrt(mass / stiffness);

  MassOnBearing const on_law(all.mass_Mg, *subject.law, subject.parameters, subject.dead_band_mm, subject.refinement);
  auto const add = [&](data::GroundMotion motion, Peaks const& peaks) {
    all.motions.push_back({.motion = motion.file, .law_disp_mm = peaks.disp_mm, .law_shear_kN = peaks.shear_kN});
    motions_.push_back(std::move(motion));
  };
  auto given = given_motions(subject);
  if (given.empty()) {
    all.motions_from =
        "the artificial motions of 'isolaw example DIR --building' along x, each with the factor at which "
        "the law moves to the tested displacement";
    double scale = 1.0;
    for (std::uint32_t i = 0; i < building::example_motions; ++i) {
      auto const motion = building::example_motion(i);
      auto const name = fmt::format("motion-{}-x", i + 1);
      auto found =
          scaled_to({.file = name, .step_s = motion.step_s, .acceleration_mm_s2 = motion.x_mm_s2, .recognised = {}},
                    on_law, subject.tested.disp_mm, scale);
      if (!found) {
        fail(fmt::format("no factor on {} moves the law to the tested displacement", name));
        return;
      }
      scale = found->scale;
      add(std::move(found->motion), found->peaks);
    }
  }
  for (auto& motion : given) {
    auto const peaks = on_law.under(motion);
    if (!peaks || !(peaks->disp_mm > 0.0)) {
      fail(peaks ? fmt::format("the law does not move under {}", motion.file)
                 : fmt::format("the integration with the law came to no end under {}", motion.file));
      return;
    }
    add(std::move(motion), *peaks);
  }
}

void BuildingOnLaw::fail(std::string why) {
  motions_.clear();
  on_law_.motions.clear();
  on_law_.why_not = std::move(why);
}

RefitResponse BuildingOnLaw::compare(std::string_view refit, laws::LawEntry const& law,
                                     std::span<double const> parameters) const {
  auto response = on_law_;
  if (motions_.empty()) return response;
  MassOnBearing const on_refit(response.mass_Mg, law, parameters);
  Peaks law_sum, refit_sum;
  double least[2]{unbounded, unbounded}, most[2]{-unbounded, -unbounded};
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    auto& each = response.motions[i];
    auto const peaks = on_refit.under(motions_[i]);
    if (!peaks) {
      response.why_not = fmt::format("the integration with {} came to no end under {}", refit, each.motion);
      response.motions.clear();
      return response;
    }
    Peaks const itself{.disp_mm = each.law_disp_mm, .shear_kN = each.law_shear_kN};
    each.refit_disp_mm = peaks->disp_mm, each.refit_shear_kN = peaks->shear_kN;
    law_sum.disp_mm += itself.disp_mm, law_sum.shear_kN += itself.shear_kN;
    refit_sum.disp_mm += peaks->disp_mm, refit_sum.shear_kN += peaks->shear_kN;
    auto const off = differences(*peaks, itself);
    for (std::size_t k = 0; k < 2; ++k) least[k] = std::min(least[k], off[k]), most[k] = std::max(most[k], off[k]);
  }
  auto const [disp, shear] = differences(refit_sum, law_sum);
  // Building codes use the mean over seven motions or more, and the most unfavourable result of fewer motions.
  double const off = motions_.size() >= building::motions_for_a_mean
                         ? std::max(std::abs(disp), std::abs(shear))
                         : std::max({-least[0], most[0], -least[1], most[1]});
  bool const one = motions_.size() == 1;
  response.finding =
      Finding{.kind = off <= response_off_percent ? FindingKind::refit_response : FindingKind::refit_response_off,
              .law = law_,
              .numbers = {{"disp_percent", disp}, {"shear_percent", shear}, {"allowed_percent", response_off_percent}},
              .words = {{"refit", std::string(refit)},
                        {"motions", one ? motions_.front().file
                                        : fmt::format("{} {}motions", motions_.size(),
                                                      response.motions_from.empty() ? "" : "artificial ")}}};
  if (!one)
    response.finding->numbers.insert(response.finding->numbers.end(), {{"disp_least_percent", least[0]},
                                                                       {"disp_most_percent", most[0]},
                                                                       {"shear_least_percent", least[1]},
                                                                       {"shear_most_percent", most[1]}});
  return response;
}

std::string building_text(Subject const& subject, RefitResponse const& response, UnitSystem const& units) {
  auto const length = [&](double mm) { return fmt::format("{:.4g} {}", units.from_mm(mm), units.length.symbol); };
  auto text = fmt::format(
      "a rigid mass of {:.4g} t on one bearing ({}), period {:.3g} s with the law's K_eff at {}, moved along a line",
      response.mass_Mg, response.mass_from, response.period_s, length(subject.tested.disp_mm));
  if (!response.motions_from.empty()) text += ". Motions: " + response.motions_from;
  text += ". Peaks of the law:";
  for (auto const& each : response.motions)
    text += fmt::format(" {} and {:.4g} {} under {};", length(each.law_disp_mm), units.from_kN(each.law_shear_kN),
                        units.force.symbol, each.motion);
  text.pop_back();
  return text;
}

}  // namespace isolaw::programs
