// Writes a page of input values for programs that the authors could not run. Each value has the program's own symbol,
// and each law states its error. The force laws come from the programs' manuals:
//   SAP2000 and ETABS, Plastic (Wen): f = r k d + (1 - r) Fy z with dz = (k / Fy) dd (1 - |z|^exp) where dd z > 0,
//     otherwise dz = (k / Fy) dd; this is Bouc-Wen with beta = gamma
//   SAP2000 and ETABS, Rubber Isolator: the same law with exp = 2, in two coupled directions
//   MIDAS, Hysteretic System: Plastic (Wen) with free shares PA + PB = 1
//   SeismoStruct: the bearing of OpenSees
//   Abaqus: connector elasticity with linear kinematic hardening
//   SAP2000 and ETABS, High Damping Rubber Isolator: the vendor's public page lists control strains and strengths of
//     one or more hysteresis loops after Masaki et al. and Kasai et al. (isolaw's law history-integral), and an elastic
//     stiffness that degrades. The equations are in a technical note (S-TN-LNK-001) that could not be read.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "isolaw/base/words.hpp"
#include "isolaw/laws/history_integral.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/text.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::programs {
namespace {

using Wen = laws::BoucWenForm;
using Corner = laws::BilinearForm;

template <class Values>
struct Set {
  std::string how;      // "exact", or the fitted law and its error
  bool is_near = true;  // false if the fitted law is far off the exported law
  std::string off;      // how far off the fitted law is, in words
  RefitResponse response = {};
  Values nominal;
  std::optional<Values> lower, upper;
};

template <class Values>
Set<Values> with_bounds(Subject const& subject, Values const& nominal, std::string how, bool is_near = true) {
  Set<Values> variants{
      .how = std::move(how), .is_near = is_near, .off = {}, .nominal = nominal, .lower = {}, .upper = {}};
  if (subject.bounds.lower) variants.lower = scaled(nominal, *subject.bounds.lower);
  if (subject.bounds.upper) variants.upper = scaled(nominal, *subject.bounds.upper);
  return variants;
}

struct Errors {
  Deviation on_records;
  std::vector<OtherCycle> on_other_cycles;
  RefitResponse in_a_building;
};

Errors errors_of(Subject const& subject, BuildingOnLaw const& building, std::string_view link,
                 laws::LawEntry const& law, std::span<double const> parameters) {
  return {deviation_of_law(subject, law, parameters),
          other_cycles(subject, [&](History const& history) { return law_force(law, parameters, history); }),
          building.compare(link, law, parameters)};
}

template <class Values>
Set<Values> fitted_set(Subject const& subject, Values const& nominal, std::string_view what, Errors const& errors) {
  bool const far = far_off(errors.on_records) || far_off(errors.on_other_cycles);
  auto const off = fmt::format("{}; {}", deviation_text(errors.on_records), text(errors.on_other_cycles));
  auto variants = with_bounds(subject, nominal, fmt::format("{}{}: {}", far ? "FAR OFF, " : "", what, off), !far);
  variants.off = off;
  variants.response = errors.in_a_building;
  return variants;
}

std::vector<double> parameters_of(Wen const& v) {
  auto const& law = laws::find_law(smooth_law);
  std::vector<double> p(law.parameters.size());
  p[law.index_of("alpha")] = v.alpha;
  p[law.index_of("Ke")] = v.Ke;
  p[law.index_of("A")] = 1.0;
  p[law.index_of("beta")] = v.beta;
  p[law.index_of("n")] = v.n;
  p[law.index_of("gamma")] = v.gamma;
  return p;
}

constexpr double sharpest = 20.0;  // the largest exponent in Plastic (Wen); it makes the loop's corner nearly sharp

// Returns the Bouc-Wen values whose loop is nearly the bilinear loop `v`.
Wen sharp(Corner const& v) {
  double const half = 0.5 * std::pow(v.uy, -sharpest);
  return {.alpha = v.K2 / v.K1, .Ke = v.K1, .beta = half, .gamma = half, .n = sharpest};
}

std::optional<Wen> fitted_bouc_wen(Subject const& subject, BuildingOnLaw const& building, std::string_view link,
                                   std::vector<fit::Override> const& overrides, Errors& error) {
  auto const found = fit_substitute(subject, smooth_law, overrides);
  if (found.law == nullptr) return std::nullopt;
  error = errors_of(subject, building, link, *found.law, found.parameters);
  return bouc_wen_values(*found.law, found.parameters);
}

fit::Override set(std::string_view parameter, laws::Interval interval) {
  return {.law = std::string(smooth_law), .parameter = std::string(parameter), .interval = interval, .tied_to = {}};
}
fit::Override tie_gamma() {
  return {.law = std::string(smooth_law), .parameter = "gamma", .interval = std::nullopt, .tied_to = "beta"};
}

constexpr std::string_view plastic_wen_link = "Plastic (Wen)";

using WenSet = std::optional<Set<Wen>>;
using CornerSet = std::optional<Set<Corner>>;

struct Memories : laws::HistoryIntegral::Memories {};

Memories scaled(Memories v, BoundFactors const& factors) {
  for (double* const strength : {&v.slow_kN, &v.quick_kN}) *strength *= factors.strength;
  v.elastic_kN_per_mm *= factors.stiffness;
  return v;
}

// The values for Plastic (Wen), which is a Bouc-Wen law with beta = gamma and an exponent from 1 to 20.
WenSet plastic_wen(Subject const& subject, BuildingOnLaw const& building) {
  if (auto const v = bilinear_values(*subject.law, subject.parameters)) {
    auto const s = sharp(*v);
    auto const error = errors_of(subject, building, plastic_wen_link, laws::find_law(smooth_law), parameters_of(s));
    return fitted_set(subject, s, "the corner as an exponent of 20, from the law", error);
  }
  auto const v = bouc_wen_values(*subject.law, subject.parameters);
  if (v && std::abs(v->beta - v->gamma) <= 1e-9 * std::abs(v->beta + v->gamma) && v->n >= 1.0)
    return with_bounds(subject, *v, "exact: beta = gamma");
  Errors error;
  auto const found =
      fitted_bouc_wen(subject, building, plastic_wen_link, {tie_gamma(), set("n", {1.0, sharpest})}, error);
  if (!found) return std::nullopt;
  auto const what =
      v ? fmt::format(
              "re-fitted with beta = gamma and an exponent of 1 or more, since the law has beta = {}, gamma = {} of beta + gamma = 1 and n = {}; from the law",
              briefly(v->beta / (v->beta + v->gamma)), briefly(v->gamma / (v->beta + v->gamma)), briefly(v->n))
        : std::string("re-fitted; from the law");
  return fitted_set(subject, *found, what, error);
}

WenSet rubber_isolator(Subject const& subject, BuildingOnLaw const& building) {
  Errors error;
  auto const found = fitted_bouc_wen(subject, building, "Rubber Isolator", {tie_gamma(), set("n", {2.0, 2.0})}, error);
  if (!found) return std::nullopt;
  return fitted_set(subject, *found, "re-fitted with exponent 2 and beta = gamma; from the law", error);
}

WenSet free_bouc_wen(Subject const& subject, BuildingOnLaw const& building, WenSet const& wen) {
  if (bilinear_values(*subject.law, subject.parameters)) return wen;
  if (auto const v = bouc_wen_values(*subject.law, subject.parameters))
    return with_bounds(subject, *v, "the law's own equation; the program's integration comes on top");
  Errors error;
  auto const found = fitted_bouc_wen(subject, building, "Bouc-Wen (MIDAS, SeismoStruct)", {}, error);
  if (!found) return std::nullopt;
  return fitted_set(subject, *found, "re-fitted; from the law", error);
}

CornerSet bilinear(Subject const& subject, BuildingOnLaw const& building) {
  if (auto const v = bilinear_values(*subject.law, subject.parameters)) return with_bounds(subject, *v, "exact");
  auto const found = fit_substitute(subject, corner_law);
  if (found.law == nullptr) return std::nullopt;
  auto const error = errors_of(subject, building, "the bilinear model", *found.law, found.parameters);
  return fitted_set(subject, *bilinear_values(*found.law, found.parameters), "re-fitted; from the law", error);
}

std::optional<Set<Memories>> memories(Subject const& subject) {
  using Law = laws::HistoryIntegral;
  if (subject.law->info.id != Law::info.id) return std::nullopt;
  auto const parameters = laws::unpack<Law, double>(std::span<double const>(subject.parameters));
  return with_bounds(subject, Memories{Law::memories(parameters, subject.tested.disp_mm)}, "the law's own");
}

class Page {
 public:
  Page(Subject const& subject, UnitSystem const& units) : subject_(subject), units_(units) {}

  void line(std::string_view text) { text_ += std::string(text) + "\n"; }
  void heading(std::string_view text) { text_ += fmt::format("\n## {}\n\n", text); }

  void values_header() {
    text_ += "| symbol | unit |  nominal |";
    text_ +=
        std::string(subject_.bounds.lower ? " lower |" : "") + (subject_.bounds.upper ? " upper |" : "") + " note |\n";
    text_ += "|---|---|---:|";
    text_ += std::string(subject_.bounds.lower ? "---:|" : "") + (subject_.bounds.upper ? "---:|" : "") + "---|\n";
  }
  // Adds a row of the table: get(values) of the nominal, the lower and the upper values. These numbers have the unit
  // kN^force mm^length; the row shows them in the units of the page.
  template <class Values, class Get>
  void row(std::string_view symbol, double force, double length, Set<Values> const& set, Get&& get,
           std::string_view note = {}) {
    text_ += fmt::format("| {} | {} |", symbol, unit(force, length));
    auto const cell = [&](Values const& v) {
      text_ += fmt::format(" {:.6g} |", units_.convert(std::invoke(get, v), force, length));
    };
    cell(set.nominal);
    if (set.lower) cell(*set.lower);
    if (set.upper) cell(*set.upper);
    text_ += fmt::format(" {} |\n", note);
  }

  std::string take() { return std::move(text_); }

 private:
  std::string unit(double force, double length) const {
    if (force == 0.0 && length == 0.0) return "1";
    if (force == 0.0) return std::string(units_.length.symbol);
    if (length == 0.0) return std::string(units_.force.symbol);
    return fmt::format("{}/{}", units_.force.symbol, units_.length.symbol);
  }

  Subject const& subject_;
  UnitSystem const& units_;
  std::string text_;
};

void wen_rows(Page& page, Set<Wen> const& set, std::string_view k, std::string_view Fy, std::string_view r,
              std::string_view exponent) {
  page.values_header();
  page.row(k, 1, -1, set, &Wen::Ke, "stiffness before yielding");
  page.row(
      Fy, 1, 0, set, [](auto const& v) { return v.Ke * v.z_max(); }, "yield force");
  page.row(r, 0, 0, set, &Wen::alpha, "stiffness after over before yielding");
  if (!exponent.empty()) page.row(exponent, 0, 0, set, &Wen::n, "sharpness of yielding");
}

double share_of_beta(Wen const& v) {
  return v.beta / (v.beta + v.gamma);
}

void csi(Page& page, Subject const& subject, WenSet const& wen, WenSet const& rubber, CornerSet const& corner,
         UnitSystem const& units) {
  page.heading("SAP2000, ETABS");
  if (subject.K_eff_kN_per_mm) {
    page.line(fmt::format(
        "Linear properties of every link, for modal and response spectrum analyses: TransKE = {:.5g} {}/{} (measured, {} at {:.4g} {}), TransCE = 0 in a non-linear run. Measured damping {:.3g} %.",
        units.convert(*subject.K_eff_kN_per_mm, 1, -1), units.force.symbol, units.length.symbol,
        subject.lot ? "mean of the lot" : "peak to peak", units.from_mm(subject.design_disp_mm), units.length.symbol,
        *subject.damping_percent));
    page.line("");
  }
  if (wen) {
    page.line(fmt::format(
        "**Plastic (Wen)**, one direction: {}. Its equation has beta = gamma: other loops are only approached.\n",
        wen->how));
    wen_rows(page, *wen, "TransK", "TransYield", "Ratio", "YieldExp");
  }
  if (rubber) {
    page.line(fmt::format("\n**Rubber Isolator**, coupled in its plane: {}.\n", rubber->how));
    wen_rows(page, *rubber, "TransK", "TransYield", "Ratio", "");
  }
  if (corner) {
    page.line(fmt::format(
        "\n**MultiLinear Plastic, kinematic**: {}. Points mirrored through zero; the last one lies on the line after yielding.\n",
        corner->how));
    page.values_header();
    double const far = 2.0 * subject.tested.disp_mm;
    page.row("Displ 1", 0, 1, *corner, &Corner::uy);
    page.row("Force 1", 1, 0, *corner, [](auto const& v) { return v.K1 * v.uy; });
    page.row(
        "Displ 2", 0, 1, *corner, [&](auto const&) { return far; }, "twice the tested displacement");
    page.row("Force 2", 1, 0, *corner, [&](auto const& v) { return v.K1 * v.uy + v.K2 * (far - v.uy); });
  }
  std::string_view const gap = wen || rubber || corner ? "\n" : "";
  if (auto const own = memories(subject)) {
    page.line(fmt::format(
        "{}**High Damping Rubber Isolator**: the law's own two hysteresis loops, each with the force S q and dq = (dx - q |dx|)/D. How the program degrades its resistance is in a technical note that could not be read, so only the hysteresis is given in full; run one cycle before use. Where a strain is asked for, divide D by the height of the rubber.\n",
        gap));
    page.values_header();
    page.row("Control strain D 1", 0, 1, *own, &Memories::slow_mm, "as a displacement");
    page.row("Control strength S 1", 1, 0, *own, &Memories::slow_kN, "as a force");
    page.row("Control strain D 2", 0, 1, *own, &Memories::quick_mm, "as a displacement");
    page.row("Control strength S 2", 1, 0, *own, &Memories::quick_kN, "as a force");
    page.row(
        "Resistance", 1, -1, *own, &Memories::elastic_kN_per_mm,
        fmt::format(
            "elastic stiffness after a peak of the tested displacement; it grows with the peak to the power {:.4g}",
            subject.parameters[subject.law->index_of("g")] - 1.0));
    return;
  }
  page.line(fmt::format(
      "{}**High Damping Rubber Isolator**: not available, because its hysteresis is that of history-integral alone{}.",
      gap, gap.empty() ? "" : "; use one of the links above"));
}

void others(Page& page, WenSet const& wen, CornerSet const& corner) {
  if (wen) {
    page.heading("MIDAS, general link, Hysteretic System");
    page.line(fmt::format(
        "{}. PA + PB = 1; which of the two multiplies the sign was not verified: where they differ, compare one loop before use, and see whether the program takes a negative one.\n",
        wording::capitalised(wen->how)));
    wen_rows(page, *wen, "STIFF", "YSTR", "PYS_RATIO", "YEXP");
    page.row("PA or PB", 0, 0, *wen, share_of_beta, "beta / (beta + gamma), the one with the sign");
    page.row(
        "PB or PA", 0, 0, *wen, [](auto const& v) { return 1.0 - share_of_beta(v); }, "gamma / (beta + gamma)");
    page.heading("SeismoStruct, elastomeric bearing (Bouc-Wen)");
    page.line(fmt::format("{}. Arguments as in OpenSees elastomericBearingBoucWen.\n", wording::capitalised(wen->how)));
    page.values_header();
    page.row("kInit", 1, -1, *wen, &Wen::Ke);
    page.row(
        "qd", 1, 0, *wen, [](auto const& v) { return (1.0 - v.alpha) * v.Ke * v.z_max(); }, "characteristic strength");
    page.row("alpha1", 0, 0, *wen, &Wen::alpha);
    page.row("alpha2", 0, 0, *wen, [](auto const&) { return 0.0; });
    page.row(
        "mu", 0, 0, *wen, [](auto const&) { return 2.0; }, "of no effect with alpha2 = 0");
    page.row("eta", 0, 0, *wen, &Wen::n);
    page.row("beta", 0, 0, *wen, share_of_beta, "multiplies the sign");
    page.row("gamma", 0, 0, *wen, [](auto const& v) { return 1.0 - share_of_beta(v); });
  }
  if (corner) {
    page.heading("Abaqus, connector elasticity and plasticity");
    page.line(fmt::format("{}. Kinematic hardening, linear: force at yield against plastic motion.\n",
                          wording::capitalised(corner->how)));
    page.values_header();
    page.row("elasticity", 1, -1, *corner, &Corner::K1);
    page.row("yield force at plastic motion 0", 1, 0, *corner, [](auto const& v) { return v.K1 * v.uy; });
    page.row(
        "hardening slope", 1, -1, *corner, [](auto const& v) { return v.K1 * v.K2 / (v.K1 - v.K2); },
        "yield force by plastic motion");
  }
}

}  // namespace

std::string value_sheet(Subject const& subject, UnitSystem const& units, Remarks& remarks) {
  Page page(subject, units);
  auto const& law = subject.law->info;
  page.line(fmt::format("# {}: values for analysis programs", harmless_markdown(subject.device)));
  page.line(fmt::format(
      "\nUnits {}, {}, s. Typed by hand, these values are not checked by the program: run one cycle at the tested amplitude and compare with the last table.\n",
      units.force.symbol, units.length.symbol));
  page.line("| | |\n|---|---|");
  auto const fact = [&](std::string_view label, std::string_view text) {
    page.line(fmt::format("| {} | {} |", label, harmless_markdown(text)));
  };
  fact("Law", fmt::format("{}: {} ({})", law.id, law.title, law.source));
  fact("Of", (subject.lot ? std::string("the lot: one law for all its devices") : "device " + subject.device) +
                 (subject.title.empty() ? "" : ", lot " + subject.title));
  fact("Parameters", parameter_text(*subject.law, subject.parameters));
  for (auto const& f : measured_facts(subject)) fact(f.label, f.text);
  for (auto const& [label, said] : prediction_facts(subject, units)) fact(label, said);
  for (auto const& warning : wording::sentences(subject.doubts.findings, wording::with_law, units))
    fact("Warning", warning);
  for (auto const& f : validity(subject, units)) fact(f.label, f.text);
  for (auto const& f : away_facts(subject, {})) fact(f.label, f.text);
  for (auto const& f : bound_facts(subject, false)) fact(f.label, f.text);
  BuildingOnLaw const building(subject);
  auto const wen = plastic_wen(subject, building);
  auto const corner = bilinear(subject, building);
  bool const fitted = wen || corner;
  auto const rubber = fitted ? rubber_isolator(subject, building) : std::nullopt;
  auto const free = free_bouc_wen(subject, building, wen);
  RefitResponse response;  // of the last set; only its facts about the building are used, which all sets share
  auto const compare = [&](auto const& set) {
    if (!set || set->response.mass_from.empty()) return;
    remarks.add(set->response, subject);
    if (set->response.why_not.empty()) response = set->response;
  };
  compare(wen);
  compare(rubber);
  compare(free);
  compare(corner);
  if (response.mass_from.empty() && remarks.cautions.empty()) remarks.add(response, subject);
  for (auto const& finding : remarks.responses) fact("In a building", wording::remark(finding, units));
  response.finding.reset();
  for (auto const& f : response_facts(subject, response, units)) fact(f.label, f.text);
  for (auto const& caution : remarks.cautions) fact("In a building", caution);
  if (fitted)
    fact(
        "Errors below",
        "of the model's exact force, in percent of the peak force, on the calibration records; a program's own integration error comes on top");
  else
    fact("Links", "none of these programs could be fitted in the law's place, so only a cycle of the law follows");
  fact("The law itself", "not here: --to abaqus and --to opensees-cpp write it, in C++ for those programs");
  fact("Text input",
       "none; written from values, because the syntax of .s2k and of LS-DYNA's cards could not be verified");
  fact("Licence", fmt::format("{}: {}", export_licence, export_licence_text));
  for (auto const& note : subject.notes) fact("Note", note);
  if (fitted && !law.traits.rate_independent)
    fact("Rate", "no model below depends on the rate; they hold for the frequency tested");
  page.line("\nEquations of the law:\n\n```");
  for (auto rest = law.formula; !rest.empty();) page.line(trimmed(take_part(rest, '\n')));
  page.line("```");

  auto const near = [](auto const& set) { return set && set->is_near; };
  if (!fitted)
    remarks.objections.emplace_back("no link of these programs could be fitted in the law's place");
  else if (!near(wen) && !near(corner))
    remarks.objections.push_back(fmt::format("the link that replaces the law in these programs is far off it: {}",
                                             wen ? wen->off : corner->off));
  csi(page, subject, wen, rubber, corner, units);
  others(page, free, corner);

  page.heading("To compare: one cycle of the law");
  page.line(fmt::format("Second cycle of two, the first at half the amplitude, {:.4g} Hz.\n", subject.frequency_Hz));
  page.line(fmt::format("| displacement, {} | force, {} |\n|---:|---:|", units.length.symbol, units.force.symbol));
  auto const cycle = tested_cycles(subject);
  auto const count = cycle.disp_mm.size();
  for (std::size_t i = (count - 1) / 2; i < count; i += 10)
    page.line(fmt::format("| {:.5g} | {:.5g} |", units.from_mm(cycle.disp_mm[i]), units.from_kN(cycle.law_kN[i])));
  page.line(fmt::format("\nisolaw {}; calibrated by isolaw {}", subject.version, subject.makers));
  return page.take();
}

}  // namespace isolaw::programs
