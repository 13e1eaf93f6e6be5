// Writes as JSON all that exports for programs contain: the law, its commands in OpenSees, errors and expected forces.
#include "isolaw/base/json.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/self_check.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

void write(JsonWriter& out, std::string_view key, Deviation const& d) {
  out.key(key).begin_object();
  out.member("largest_percent_of_peak", d.largest).member("at_s", d.at_s);
  out.member("at_sample", std::uint64_t{d.at_sample}).member("rms_percent_of_peak", d.rms);
  out.member("K_eff_percent", d.K_eff).member("energy_percent", d.energy).end_object();
}

void write(JsonWriter& out, std::string_view key, std::vector<double> const& values) {
  out.key(key).begin_array();
  for (double const v : values) out.value(v);
  out.end_array();
}

void write_parameters(JsonWriter& out, std::string_view key, laws::LawEntry const& law,
                      std::span<double const> parameters) {
  out.key(key).begin_array();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    auto const& p = law.parameters[i];
    out.begin_object().member("name", p.name).member("value", parameters[i]).member("unit", p.unit);
    out.member("meaning", p.meaning).end_object();
  }
  out.end_array();
}

void write_commands(JsonWriter& out, std::string_view key, Form const& form, UnitSystem const& units) {
  auto const commands = in_units(form, units);
  out.key(key).begin_array();
  for (std::size_t c = 0; c < commands.size(); ++c) {
    out.begin_object().member("name", commands[c].name).key("arguments").begin_array();
    for (std::size_t i = 0; i < commands[c].arguments.size(); ++i) {
      auto const& a = form.commands[c].arguments[i];
      out.begin_object().member("name", a.name).member("value", commands[c].arguments[i]);
      out.member("force_power", a.force_power).member("length_power", a.length_power).end_object();
    }
    out.end_array().end_object();
  }
  out.end_array();
}

void write_factors(JsonWriter& out, std::string_view key, Subject const& subject,
                   std::optional<BoundFactors> const& factors) {
  out.key(key);
  if (!factors) {
    out.null();
    return;
  }
  out.begin_object().member("stiffness", factors->stiffness).member("strength", factors->strength);
  out.member("force", factors->overall).member("separate", factors->separate);
  if (!factors->parameters.empty()) write_parameters(out, "parameters", *subject.law, factors->parameters);
  out.end_object();
}

void write_validity(JsonWriter& out, Subject const& subject) {
  auto const& f = subject.fitted;
  out.key("fitted").begin_object().member("part", f.part).member("disp_mm", f.disp_mm);
  out.member("velocity_mm_s", f.vel_mm_s).end_object();
  auto const& t = subject.tested;
  out.key("tested").begin_object();
  out.member("disp_mm", t.disp_mm).member("shear_strain_percent", t.strain_percent);
  out.member("lowest_frequency_Hz", t.lowest_Hz).member("highest_frequency_Hz", t.highest_Hz);
  out.member("velocity_mm_s", t.vel_mm_s).member("load_min_kN", t.load_min_kN).member("load_max_kN", t.load_max_kN);
  out.member("temperature_min_C", t.temperature_min_C).member("temperature_max_C", t.temperature_max_C).end_object();
}

void write(JsonWriter& out, std::string_view key, RefitResponse const& response, UnitSystem const& units) {
  out.key(key).begin_object().member("mass_t", response.mass_Mg).member("mass_from", response.mass_from);
  out.member("period_s", response.period_s).member("why_not", response.why_not).key("motions").begin_array();
  for (auto const& each : response.motions) {
    out.begin_object().member("motion", each.motion);
    out.member("law_displacement", units.from_mm(each.law_disp_mm))
        .member("law_shear", units.from_kN(each.law_shear_kN));
    out.member("displacement", units.from_mm(each.refit_disp_mm)).member("shear", units.from_kN(each.refit_shear_kN));
    out.end_object();
  }
  out.end_array();
  if (auto const& finding = response.finding) {
    out.member("displacement_percent", finding->number("disp_percent"));
    out.member("shear_percent", finding->number("shear_percent"));
    out.member("off", finding->kind == FindingKind::refit_response_off);
  }
  out.end_object();
}

void write_forms(JsonWriter& out, Realisation const& realisation, SelfCheck const& check, UnitSystem const& units) {
  out.key("forms").begin_array();
  for (std::size_t i = 0; i < realisation.forms.size(); ++i) {
    auto const& form = realisation.forms[i];
    out.begin_object().member("id", form.nominal.id).member("title", form.nominal.title);
    out.member("exact_at_every_step", form.nominal.exactness == Exactness::every_step);
    out.member("condition", form.nominal.condition);
    out.member("longest_travel", form.nominal.longest_travel_mm
                                     ? std::optional(units.from_mm(*form.nominal.longest_travel_mm))
                                     : std::nullopt);
    out.member("longest_swing", form.nominal.longest_swing_mm
                                    ? std::optional(units.from_mm(*form.nominal.longest_swing_mm))
                                    : std::nullopt);
    out.member("longest_step_of_the_records", units.from_mm(form.longest_step_mm));
    out.member("longest_step_of_the_replay", units.from_mm(form.replayed_step_mm));
    write_commands(out, "nominal", form.nominal, units);
    if (form.lower) write_commands(out, "lower", *form.lower, units);
    if (form.upper) write_commands(out, "upper", *form.upper, units);
    write(out, "from_law", form.from_law);
    out.member("far_off", far_off(form.from_law) || far_off(form.other_cycles));
    if (form.finer) write(out, "from_law_in_finer_steps", *form.finer);
    out.key("other_cycles").begin_array();
    for (auto const& c : form.other_cycles) {
      out.begin_object().member("amplitude_share", c.amplitude_share).member("rate_share", c.rate_share);
      out.member("energy_percent", c.energy).member("peak_percent", c.peak).end_object();
    }
    out.end_array();
    out.key("steps_needed");
    if (form.steps)
      out.begin_object()
          .member("per_cycle", form.steps->per_cycle)
          .member("energy_percent", form.steps->energy)
          .end_object();
    else
      out.null();
    if (form.from_measured) write(out, "from_measured", *form.from_measured);
    out.key("expected").begin_object().member("tolerance_of_peak", check_tolerance);
    for (auto const& variant : check.forms[i].variants) write(out, variant.name, variant.force);
    out.end_object().end_object();
  }
  out.end_array();
}

}  // namespace

std::string export_json(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const check = self_check(subject, realisation, units);
  auto const& law = subject.law->info;
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object().member("isolaw", subject.version).member("calibrated_by", "isolaw " + subject.makers);
  out.member("lot", subject.title);
  out.member("device", subject.device).member("of_the_lot", subject.lot);
  out.key("law").begin_object().member("id", law.id).member("title", law.title).member("source", law.source);
  out.member("force_unit", law.force.symbol).member("length_unit", law.length.symbol).end_object();
  write_parameters(out, "parameters", *subject.law, subject.parameters);
  out.member("objective", subject.objective);
  out.key("units").begin_object().member("id", units.id).member("force", units.force.symbol);
  out.member("length", units.length.symbol).member("time", "s").end_object();
  out.member("fidelity", name(realisation.fidelity)).member("explanation", realisation.explanation);
  out.member("refused", realisation.refused).member("substitute", realisation.substitute);
  if (!realisation.substitute.empty())
    write_parameters(out, "substitute_parameters", laws::find_law(realisation.substitute),
                     realisation.substitute_parameters);
  if (!realisation.substitute.empty()) write(out, "in_a_building", realisation.response, units);
  write_validity(out, subject);
  auto const& doubts = subject.doubts;
  out.member("prediction", wording::remark(doubts.prediction));
  out.member("objection", doubts.objection ? wording::remark(*doubts.objection) : std::string());
  out.member("warnings", wording::sentences(doubts.findings, wording::with_law));
  out.member("beyond_the_tests", subject.beyond_tests);
  out.key("bounds").begin_object();
  write_factors(out, "lower", subject, subject.bounds.lower);
  write_factors(out, "upper", subject, subject.bounds.upper);
  auto const share = subject.bounds.tolerance_factor ? std::optional(95.0) : std::nullopt;
  out.member("coverage_percent", share).member("confidence_percent", share);
  out.member("tolerance_k", subject.bounds.tolerance_factor).member("source", subject.bounds.source).end_object();
  out.member("finer_steps", finer_steps);
  write_forms(out, realisation, check, units);
  out.key("self_check").begin_object();
  out.member("frequency_Hz", subject.frequency_Hz);
  write(out, "disp", check.disp);
  write(out, "law_force", check.law);
  out.end_object().member("notes", subject.notes).end_object();
  return out.take() + "\n";
}

}  // namespace isolaw::programs
