#include "isolaw/programs/mapping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "isolaw/base/words.hpp"

namespace isolaw::programs {
namespace {

Form steel01(laws::BilinearForm const& v) {
  return {.id = "material",
          .title = "uniaxialMaterial Steel01",
          .exactness = Exactness::every_step,
          .commands = {{"Steel01", {{"Fy", v.K1 * v.uy, 1, 0}, {"E0", v.K1, 1, -1}, {"b", v.K2 / v.K1, 0, 0}}}}};
}

Form bearing_plasticity(laws::BilinearForm const& v) {
  return {.id = "bearing",
          .title = "element elastomericBearingPlasticity",
          .exactness = Exactness::every_step,
          .commands = {{"elastomericBearingPlasticity",
                        {{"kInit", v.K1, 1, -1},
                         {"qd", (v.K1 - v.K2) * v.uy, 1, 0},
                         {"alpha1", v.K2 / v.K1, 0, 0},
                         {"alpha2", 0.0, 0, 0},
                         {"mu", 2.0, 0, 0}}}},
          .condition = "coupled in the bearing's plane; checked here along one axis"};
}

Form steel02(laws::MenegottoPintoForm const& v) {
  return {.id = "material",
          .title = "uniaxialMaterial Steel02",
          .exactness = Exactness::every_step,
          .commands = {{"Steel02",
                        {{"Fy", v.Fy, 1, 0},
                         {"E0", v.E, 1, -1},
                         {"b", v.b, 0, 0},
                         {"R0", v.R0, 0, 0},
                         {"cR1", v.cR1, 0, 0},
                         {"cR2", v.cR2, 0, 0}}}}};
}

// The command BoucWen takes gamma before beta. Its variable z is a length, so the unit of beta and gamma is 1/length^n.
Form bouc_wen(laws::BoucWenForm const& v) {
  return {.id = "material",
          .title = "uniaxialMaterial BoucWen",
          .exactness = Exactness::small_steps,
          .commands = {{"BoucWen",
                        {{"alpha", v.alpha, 0, 0},
                         {"ko", v.Ke, 1, -1},
                         {"n", v.n, 0, 0},
                         {"gamma", v.gamma, 0, -v.n},
                         {"beta", v.beta, 0, -v.n},
                         {"Ao", 1.0, 0, 0},
                         {"deltaA", 0.0, 0, 0},
                         {"deltaNu", 0.0, 0, 0},
                         {"deltaEta", 0.0, 0, 0},
                         {"tol", 1e-9 * v.z_max(), 0, 1},
                         {"maxIter", 100.0, 0, 0}}}}};
}

// The command BoucWenOriginal takes beta before gamma. Its variable z is that of BoucWen divided by uy.
Form bouc_wen_original(laws::BoucWenForm const& v) {
  double const uy = v.z_max(), scale = std::pow(uy, v.n);
  return {.id = "material_original",
          .title = "uniaxialMaterial BoucWenOriginal",
          .exactness = Exactness::small_steps,
          .commands = {{"BoucWenOriginal",
                        {{"E", v.Ke, 1, -1},
                         {"fy", v.Ke * uy, 1, 0},
                         {"alphaL", v.alpha, 0, 0},
                         {"alphaNL", 0.0, 0, 0},
                         {"mu", 2.0, 0, 0},
                         {"eta", v.n, 0, 0},
                         {"beta", v.beta * scale, 0, 0},
                         {"gamma", v.gamma * scale, 0, 0},
                         {"tol", 1e-9, 0, 0},
                         {"maxIter", 100.0, 0, 0}}}}};
}

Form bearing_bouc_wen(laws::BoucWenForm const& v) {
  double const uy = v.z_max(), scale = std::pow(uy, v.n);
  return {.id = "bearing",
          .title = "element elastomericBearingBoucWen",
          .exactness = Exactness::small_steps,
          .commands = {{"elastomericBearingBoucWen",
                        {{"kInit", v.Ke, 1, -1},
                         {"qd", (1.0 - v.alpha) * v.Ke * uy, 1, 0},
                         {"alpha1", v.alpha, 0, 0},
                         {"alpha2", 0.0, 0, 0},
                         {"mu", 2.0, 0, 0},
                         {"eta", v.n, 0, 0},
                         {"beta", v.beta * scale, 0, 0},
                         {"gamma", v.gamma * scale, 0, 0}}}},
          .condition = "coupled in the bearing's plane; checked here along one axis"};
}

std::vector<Form> bouc_wen_forms(laws::BoucWenForm const& v) {
  std::vector<Form> forms{bouc_wen(v), bouc_wen_original(v), bearing_bouc_wen(v)};
  // With n < 1, |z|^n has an infinite slope at z = 0, where OpenSees may fail to find z by Newton's iteration.
  if (v.n < 1.0)
    for (auto& form : forms)
      form.condition +=
          std::string(form.condition.empty() ? "" : "; ") +
          "where the program's iteration converges: with n below 1 it may fail as z passes 0, see the self-check";
  return forms;
}

// Returns the law as a member of its family (bilinear, Bouc-Wen, ...), with parameters in kN and mm.
laws::Canonical canonical(laws::LawEntry const& law, std::span<double const> parameters) {
  double const F = law.info.force.in_record_units, L = law.info.length.in_record_units;
  auto form = law.canonical(parameters);
  if (auto* corner = std::get_if<laws::BilinearForm>(&form)) {
    corner->K1 *= F / L;
    corner->K2 *= F / L;
    corner->uy *= L;
  } else if (auto* smooth = std::get_if<laws::BoucWenForm>(&form)) {
    smooth->Ke *= F / L;
    smooth->beta *= std::pow(L, -smooth->n);
    smooth->gamma *= std::pow(L, -smooth->n);
  } else if (auto* steel = std::get_if<laws::MenegottoPintoForm>(&form)) {
    steel->E *= F / L;
    steel->Fy *= F;
  } else if (auto* curves = std::get_if<laws::LimitCurvesForm>(&form)) {
    for (auto* curve : {&curves->loading, &curves->unloading})
      *curve = {.Kb = curve->Kb * F / L,
                .f0 = curve->f0 * F,
                .alpha = curve->alpha / L,
                .beta1 = curve->beta1 * F,
                .beta2 = curve->beta2 / L,
                .sigmoid = curve->sigmoid * F};
  }
  return form;
}

// Returns why no OpenSees material can follow a law whose force approaches these limit curves, or "" if one can.
std::string no_material_of(laws::LawEntry const& law, laws::LimitCurvesForm const& v) {
  auto const &up = v.loading, &down = v.unloading;
  if (up.sigmoid != 0.0 || down.sigmoid != 0.0)
    return "the sigmoid of the limit curves, which is not 0, is in no material of OpenSees";
  bool const no_hardening = up.beta1 == 0.0 && down.beta1 == 0.0;
  std::vector<std::string> differing;
  auto const compare = [&](std::string_view name, double loading, double unloading) {
    if (loading != unloading) differing.push_back(fmt::format("{} {:.5g} and {:.5g}", name, loading, unloading));
  };
  compare("Kb", up.Kb, down.Kb);
  compare("f0", up.f0, down.f0);
  compare("alpha", up.alpha, down.alpha);
  compare("beta1", up.beta1, down.beta1);
  if (!no_hardening) compare("beta2", up.beta2, down.beta2);
  if (!differing.empty())
    return fmt::format(
        "loading and unloading differ (in kN and mm: {}), and HystereticAsym has one set of limit curves; calibrated with --set {}.Kb-=Kb+, and likewise for f0, alpha, beta1 and beta2, the law has one set too",
        joined(differing), law.info.id);
  if (!(up.alpha > 0.0 && up.f0 > 0.0)) return "without hysteresis (alpha or f0 is 0) there is no such material";
  return {};
}

// After a long travel in one direction the force has nearly reached its limit curve: their distance is f0 exp(-alpha
// travel). Returns the travel from which on this distance may be smaller than the rounding error of the force. The
// error grows with the displacement, which is `reach` * travel: `reach` is 1 if the travel begins at rest, and 0.5 if
// it leads from one side to the other.
double longest_travel(laws::LimitCurve const& v, double reach) {
  constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();
  double travel = 0.0;
  for (double low = 0.0, high = 60.0 / v.alpha; high - low > 1e-4 * high;) {
    travel = 0.5 * (low + high);
    double const disp = reach * travel, hardening = std::abs(v.beta2) * disp;
    double const lost =
        roundings * (std::abs(v.Kb) * disp + v.f0 + std::abs(v.beta1) * (std::exp(hardening) + hardening));
    (v.f0 * std::exp(-v.alpha * travel) > lost ? low : high) = travel;
  }
  return travel;
}

// HystereticAsym allows no limit curve that softens (beta1 < 0) and no hysteretic force of 0. A law that softens is
// therefore written as the difference of two such materials. The first has 1.1 times the law's hysteretic force. The
// second, which is subtracted, has the surplus of 0.1 times this force and a limit curve that hardens.
constexpr double surplus = 0.1;

// In HystereticAsym the hardening term has the coefficient 1, whatever the unit of force. For a law that hardens,
// HystereticAsym therefore gives the force divided by beta1, and a Multiplier multiplies it by beta1.
Form hysteretic_asym(laws::LimitCurve const& v) {
  Form form{.id = "material",
            .title = "uniaxialMaterial HystereticAsym",
            .exactness = Exactness::every_step,
            .commands = {},
            .condition =
                "the force turns into no number (NaN) without a message on a longer travel in one direction from rest",
            .longest_travel_mm = longest_travel(v, 1.0),
            .longest_swing_mm = longest_travel(v, 0.5),
            .since = "3.5.0"};
  // Adds a HystereticAsym command. The force of its hardening curve is exp(b1 u) - 1 - b1 u.
  auto const part = [&](double kb, double f0, double b1, double force_power) {
    form.commands.push_back({"HystereticAsym",
                             {{"ka", kb + 2.0 * v.alpha * f0, force_power, -1},
                              {"kb", kb, force_power, -1},
                              {"fo", f0, force_power, 0},
                              {"b1", b1, 0, -1},
                              {"b2", 0.0, 0, 0},
                              {"gamma", 0.0, 0, -1}}});
  };
  double const curve = v.beta1, b1 = v.beta2, size = std::abs(curve);
  if (curve == 0.0) {
    part(v.Kb, v.f0, 0.0, 1.0);
  } else if (curve > 0.0) {
    part(v.Kb / size + b1, v.f0 / size, b1, 0.0);
    form.commands.push_back({"Multiplier", {{"factor", size, 1, 0}}});
    form.title += " in a Multiplier";
  } else {
    double const kb = v.Kb - size * b1, whole = 1.0 + surplus;
    part(whole * kb, whole * v.f0, 0.0, 1.0);
    part(surplus * kb / size, surplus * v.f0 / size, b1, 0.0);
    form.commands.push_back({"Multiplier", {{"factor", -size, 1, 0}}});
    form.commands.push_back({"Parallel", {}});
    form.title += ", two of them in Parallel, one in a Multiplier";
  }
  return form;
}

laws::BoucWenForm without_hardening(laws::LimitCurve const& v) {
  double const Ke = v.Kb + v.alpha * v.f0;
  return {.alpha = v.Kb / Ke, .Ke = Ke, .beta = v.alpha, .gamma = 0.0, .n = 1.0};
}

struct ToForms {
  laws::LawEntry const& law;
  BoundFactors const& scale;

  Mapping operator()(laws::BilinearForm const& v) const {
    if (!(v.K1 > v.K2 && v.uy > 0.0))
      return {{}, "without yielding (K1 <= K2 or xy = 0) there is no bilinear material to export"};
    auto const s = scaled(v, scale);
    return {{steel01(s), bearing_plasticity(s)}, {}};
  }
  Mapping operator()(laws::BoucWenForm const& v) const {
    if (!(v.beta + v.gamma > 0.0)) return {{}, "beta + gamma is not positive: no bounded force"};
    return {bouc_wen_forms(scaled(v, scale)), {}};
  }
  Mapping operator()(laws::MenegottoPintoForm const& v) const {
    if (!(v.E > 0.0 && v.Fy > 0.0 && v.b < 1.0))
      return {{}, "without yielding (E or Fy is 0, or b is 1) there is no such material to export"};
    return {{steel02(scaled(v, scale))}, {}};
  }
  Mapping operator()(laws::LimitCurvesForm const& curves) const {
    if (auto why = no_material_of(law, curves); !why.empty()) return {{}, std::move(why)};
    auto v = curves.loading;
    v.Kb *= scale.stiffness;
    v.f0 *= scale.strength;
    v.beta1 *= scale.stiffness;
    Mapping mapping{.forms = {hysteretic_asym(v)}, .reason = {}};
    if (v.beta1 != 0.0) return mapping;
    // Without hardening, the law is Bouc-Wen with n = 1, beta = alpha and gamma = 0, whose force never becomes NaN.
    for (auto& form : bouc_wen_forms(without_hardening(v))) {
      if (form.id == "material") form.id = "material_bouc_wen";
      mapping.forms.push_back(std::move(form));
    }
    return mapping;
  }
  Mapping operator()(laws::NoForm const& none) const {
    if (!law.info.traits.rate_independent)
      return {{}, "no material of OpenSees has a force that depends on displacement and velocity in this way"};
    return {{},
            none.lacking.empty() ? std::string("no material of OpenSees is known to be this law")
                                 : fmt::format("no material of OpenSees has this law's {}", none.lacking)};
  }
};

}  // namespace

laws::BilinearForm scaled(laws::BilinearForm v, BoundFactors const& scale) {
  double const z = scale.strength * (v.K1 - v.K2);
  return {.K1 = scale.stiffness * v.K2 + z, .K2 = scale.stiffness * v.K2, .uy = v.uy};
}

laws::BoucWenForm scaled(laws::BoucWenForm v, BoundFactors const& scale) {
  double const spring = scale.stiffness * v.alpha * v.Ke, hysteretic = scale.strength * (1.0 - v.alpha) * v.Ke;
  v.Ke = spring + hysteretic;
  v.alpha = spring / v.Ke;
  return v;
}

laws::MenegottoPintoForm scaled(laws::MenegottoPintoForm v, BoundFactors const& scale) {
  double const spring = scale.stiffness * v.b * v.E, E = spring + scale.strength * (1.0 - v.b) * v.E;
  return {.E = E, .Fy = v.Fy * E / v.E, .b = spring / E, .R0 = v.R0, .cR1 = v.cR1, .cR2 = v.cR2};
}

std::vector<Command> in_units(Form const& form, UnitSystem const& units) {
  std::vector<Command> commands;
  for (auto const& command : form.commands) {
    auto& converted = commands.emplace_back(Command{.name = command.name, .arguments = {}});
    for (auto const& a : command.arguments)
      converted.arguments.push_back(units.convert(a.value, a.force_power, a.length_power));
  }
  return commands;
}

std::optional<laws::BilinearForm> bilinear_values(laws::LawEntry const& law, std::span<double const> parameters) {
  auto const form = canonical(law, parameters);
  auto const* v = std::get_if<laws::BilinearForm>(&form);
  return v != nullptr ? std::optional(*v) : std::nullopt;
}

std::optional<laws::BoucWenForm> bouc_wen_values(laws::LawEntry const& law, std::span<double const> parameters) {
  auto const form = canonical(law, parameters);
  if (auto const* v = std::get_if<laws::BoucWenForm>(&form)) return *v;
  auto const* curves = std::get_if<laws::LimitCurvesForm>(&form);
  if (curves == nullptr || !no_material_of(law, *curves).empty() || curves->loading.beta1 != 0.0) return std::nullopt;
  return without_hardening(curves->loading);
}

Mapping map_law(laws::LawEntry const& law, std::span<double const> parameters, BoundFactors const& scale) {
  return std::visit(ToForms{law, scale}, canonical(law, parameters));
}

}  // namespace isolaw::programs
