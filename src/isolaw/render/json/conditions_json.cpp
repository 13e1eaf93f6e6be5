#include "isolaw/render/json/conditions_json.hpp"

#include <cmath>

#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/conditions_findings.hpp"
#include "isolaw/study/conditions_results.hpp"

namespace isolaw::render {
namespace {

constexpr int conditions_schema = 1;

void write_interval(JsonWriter& out, std::string_view key, std::optional<conditions::Interval> const& interval) {
  out.key(key);
  if (!interval)
    out.null();
  else
    out.object([&] { write_members(out, "low", interval->low, "high", interval->high); });
}

void write_factor(JsonWriter& out, conditions::Factor const& factor, std::optional<int> installed) {
  study::ConditionFactor const of{factor, installed};
  out.object([&] {
    for (auto const& row : study::conditions_factor_results) {
      auto const value = row.value(of);
      if (auto const* ends = std::get_if<study::Ends>(&value))
        write_interval(out, row.key,
                       ends->lower ? std::optional(conditions::Interval{*ends->lower, *ends->upper}) : std::nullopt);
      else
        write_value(out.key(row.key), value, shown_digits);
    }
  });
}

std::vector<std::string> names_of(std::vector<conditions::Effect> const& effects) {
  std::vector<std::string> texts;
  for (auto const effect : effects) texts.emplace_back(name(effect));
  return texts;
}

void write_combined(JsonWriter& out, conditions::Combined const& all) {
  out.object([&] {
    write_members(out, "factor", all.factor, "complete", all.complete(), "status", all.status, "share_shown",
                  all.share_shown);
    write_interval(out, "interval", all.interval);
    out.member("not_covered", names_of(all.not_covered));
    out.member("assumed", names_of(all.assumed));
    out.member("without_interval", names_of(all.without_interval));
  });
}

// Writes the design conditions. A range becomes an array of its two ends.
void write_design(JsonWriter& out, campaign::StatedConditions const& stated) {
  auto const& design = stated.design;
  auto const range = [&](std::string_view key, std::optional<campaign::ConditionRange> const& of) {
    write_value(out.key(key), of ? Value(study::Ends{of->low, of->high}) : Value(), shown_digits);
  };
  out.key("design_conditions").object([&] {
    range("temperature_C", design.temperature_C);
    range("frequency_Hz", design.frequency_Hz);
    range("load_kN", design.load_kN);
    write_members(out, "full_rest", design.full_rest, "rest_h", design.rest_h, "cycles", design.cycles);
    out.key("aged");
    if (design.aged)
      out.object([&] { write_members(out, "days", design.aged->days, "at_C", design.aged->at_C); });
    else
      out.null();
    write_members(out, "years", design.years, "service_temperature_C", design.service_temperature_C);
  });
}

void write_members_of(JsonWriter& out, study::ConditionsResult const& result) {
  auto const& reference = result.stated.reference;
  out.key("reference").object([&] {
    write_members(out, "temperature_C", reference.temperature_C, "frequency_Hz", reference.frequency_Hz, "load_kN",
                  reference.load_kN, "strain_percent", reference.strain_percent, "disp_mm", reference.disp_mm,
                  "first_cycle", reference.first_cycle, "last_cycle", reference.last_cycle);
  });
  write_design(out, result.stated);
  out.key("tests").objects(result.tests, [&](study::ConditionsTest const& test) {
    write_results(out, study::conditions_test_results, test, Digits::shown);
    write_rows(out.key("cycles"), study::conditions_cycle_results, test.cycles, Digits::shown);
    constexpr int digits = 4;
    out.key("loop_mm").line(test.loop_mm, digits);
    out.key("loop_kN").line(test.loop_kN, digits);
  });
  out.key("refused").objects(result.refused, [&](study::RefusedTest const& test) {
    write_members(out, "device", test.device, "test", test.test, "reason", test.reason);
  });
  out.key("levels").objects(result.levels, [&](study::LevelRow const& row) {
    write_results(out, study::conditions_level_results, row, Digits::shown);
    out.key("ratios").objects(row.ratios, [&](conditions::DeviceRatio const& ratio) {
      write_members(out, "device", ratio.device, "lambda", std::exp(ratio.ln));
    });
    write_factor(out.key("factor"), row.factor, result.installed);
  });
  out.key("ends").objects(result.ends, [&](study::EndRow const& row) {
    write_members(out, "quantity", row.quantity, "effect", row.effect, "at", row.at, "unit",
                  study::unit_of(row.effect));
    write_factor(out.key("factor"), row.factor, result.installed);
  });
  out.key("design").objects(result.design, [&](study::DesignRow const& row) {
    write_members(out, "quantity", row.quantity, "effect", row.effect);
    write_factor(out.key("max"), row.max, result.installed);
    write_factor(out.key("min"), row.min, result.installed);
    if (auto const& from = row.assumed)
      out.key("assumed").object(
          [&] { write_members(out, "rules", from->rules, "clause", from->clause, "verified", from->verified); });
  });
  out.key("dependence").objects(result.dependence, [&](study::DependenceRow const& row) {
    auto const& limit = row.limit;
    write_members(out, "effect", limit.effect, "quantity", limit.quantity, "within_percent", limit.within_percent,
                  "clause", limit.clause, "load_variation", row.is_load_variation, "verdict", row.verdict());
    out.key("devices").objects(row.devices, [&](conditions::DeviceDependence const& device) {
      write_members(out, "device", device.device, "at", device.at, "ratio",
                    device.ratio ? std::optional(device.ratio->lambda()) : std::nullopt, "verdict", device.verdict,
                    "reason", device.reason ? std::optional(name(*device.reason)) : std::nullopt);
    });
  });
  if (auto const& mean = result.mean_properties)
    out.key("mean_properties").object([&] {
      write_members(out, "permitted", mean->permitted, "quantity", mean->quantity, "farthest_percent",
                    mean->farthest_percent, "within_percent", mean->rule.within_percent, "clause", mean->rule.clause);
    });
  auto const& how = result.combination;
  out.key("combination").object([&] {
    write_members(out, "form", name(how.form), "adjust", how.adjust, "margin", how.margin, "rules", how.rules, "clause",
                  how.clause, "verified", how.verified);
  });
  out.key("bounds").objects(result.bounds, [&](study::BoundRow const& row) {
    write_members(out, "quantity", row.quantity, "unit", rules::unit(row.quantity), "value_at_reference",
                  row.value_at_reference, "devices", row.devices);
    write_combined(out.key("max"), row.max);
    write_combined(out.key("min"), row.min);
  });
  out.key("recovery").objects(result.recovery, [&](study::RecoveryRow const& row) {
    write_members(out, "rest_h", row.rest_h, "share", row.share, "devices", row.devices);
  });
  out.key("curves").objects(result.curves, [&](study::CurveRow const& row) {
    write_members(out, "quantity", row.quantity, "effect", row.effect, "device", row.device, "parameter", row.parameter,
                  "value", row.value, "unit", row.unit);
  });
  out.key("at_reference").objects(result.at_reference, [&](study::AtReferenceRow const& row) {
    write_results(out, study::at_reference_results, row, Digits::shown);
    write_rows(out.key("factors"), study::converting_factor_results, row.factors, Digits::shown);
  });
  write_rows(out.key("plan"), study::planned_test_results, result.plan.tests, Digits::shown);
  out.key("not_in_plan").objects(result.plan.unplanned, [&](study::Unplanned const& row) {
    write_members(out, "effect", row.effect, "reason", name(row.why));
  });
  out.member("drift_not_checked", names_of(result.drift_not_checked));
  out.member("straightness_not_checked", names_of(result.straightness_not_checked));
  out.member("ageing_stands_for_years", result.ageing_stands_for_years);
  write_findings(out, "findings", study::conditions_findings(result));
}

void write_bound_laws(JsonWriter& out, study::Summary const& summary) {
  constexpr int digits = 4;
  out.key("bound_laws").objects(study::law_bounds(summary), [&](study::LawBounds const& of) {
    auto const& law = laws::find_law(of.law);
    auto const text = [&](std::string_view key, std::string const& content) {
      out.key(key);
      content.empty() ? out.null() : out.value(content);
    };
    out.member("law", of.law);
    text("device", of.device);
    text("obstacle", of.bounds.obstacle ? wording::remark(*of.bounds.obstacle) : std::string());
    out.key("disp_mm").line(of.reference.disp_mm, digits);
    out.key("force_kN").line(of.reference.force_kN, digits);
    auto const write = [&](std::string_view which, std::optional<study::DesignBound> const& bound,
                           std::vector<double> const& force_kN) {
      out.key(which);
      if (!bound) return void(out.null());
      out.object([&] {
        write_results(out, study::bound_law_results, *bound, Digits::shown);
        out.key("parameters").object([&] {
          for (std::size_t i = 0; i < law.parameters.size(); ++i)
            write_value(out.key(law.parameters[i].name), bound->law.parameters[i], shown_digits);
        });
        out.key("force_kN").line(force_kN, digits);
      });
    };
    write("lower", of.bounds.lower, of.lower_kN);
    write("upper", of.bounds.upper, of.upper_kN);
  });
}

}  // namespace

std::string conditions_json(study::ConditionsResult const& result) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.object([&] {
    write_members(out, "schema", conditions_schema, "title", result.title);
    write_members_of(out, result);
  });
  return out.take() + '\n';
}

void write_conditions(JsonWriter& out, study::Summary const& summary) {
  if (summary.conditions)
    out.key("conditions").object([&] {
      write_members_of(out, *summary.conditions);
      write_bound_laws(out, summary);
    });
  if (!summary.no_conditions.empty()) out.member("no_conditions", summary.no_conditions);
}

}  // namespace isolaw::render
