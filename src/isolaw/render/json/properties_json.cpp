#include "isolaw/render/json/properties_json.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace isolaw::render {
namespace {

constexpr int digits = 9;

void number(JsonWriter& out, std::string_view key, std::optional<double> const& value) {
  out.key(key).rounded(value, digits);
}

void write_cycle(JsonWriter& out, DeviceResult const& device, data::Cycle const& c) {
  out.begin_object();
  out.member("number", c.number)
      .member("counts", c.counts())
      .member("partial", c.partial)
      .member("reason", c.not_counted);
  number(out, "first", c.first), number(out, "last", c.last);
  number(out, "amplitude_mm", c.amplitude_mm);
  number(out, "d_plus_mm", c.d_plus_mm), number(out, "d_minus_mm", c.d_minus_mm);
  number(out, "F_plus_kN", c.F_plus_kN), number(out, "F_minus_kN", c.F_minus_kN);
  number(out, "K_eff_kN_per_mm", c.K_eff_kN_per_mm);
  number(out, "K_plus_kN_per_mm", c.K_plus()), number(out, "K_minus_kN_per_mm", c.K_minus());
  number(out, "energy_kN_mm", c.energy_kN_mm), number(out, "damping_percent", c.damping_percent);
  number(out, "Q_d_kN", c.Q_d_kN), number(out, "K_d_kN_per_mm", c.K_d_kN_per_mm);
  number(out, "D_y_mm", c.D_y_mm), number(out, "K_1_kN_per_mm", c.K_1_kN_per_mm);
  number(out, "period_s", c.period_s), number(out, "v_max_mm_s", c.v_max_mm_s);
  number(out, "N_mean_kN", c.N_mean_kN), number(out, "N_min_kN", c.N_min_kN), number(out, "N_max_kN", c.N_max_kN);
  number(out, "closure_mm", c.closure_mm), number(out, "closure_kN", c.closure_kN);
  auto const strains = shear_strain(c, device.rubber_thickness_mm, device.rubber_area_mm2);
  number(out, "strain_percent", strains ? std::optional(strains->shear_strain_percent) : std::nullopt);
  number(out, "G_MPa", strains ? strains->G_MPa : std::nullopt);
  out.end_object();
}

void write_stability(JsonWriter& out, std::string_view key, data::Stability const& s) {
  out.key(key).begin_object();
  out.key("ratio_to_third").begin_array();
  for (double const ratio : s.ratio_to_third) out.rounded(ratio, digits);
  out.end_array();
  number(out, "min_2_10", s.min_2_10), number(out, "max_2_10", s.max_2_10);
  number(out, "min_1_10", s.min_1_10), number(out, "max_1_10", s.max_1_10);
  number(out, "least_to_largest_2_10", s.least_to_largest_2_10);
  number(out, "least_to_largest_1_10", s.least_to_largest_1_10);
  number(out, "first_to_third", s.first_to_third), number(out, "first_to_mean_1_3", s.first_to_mean_1_3);
  out.end_object();
}

void write_block(JsonWriter& out, DeviceResult const& device, data::Block const& block) {
  out.begin_object();
  out.member("number", block.number);
  number(out, "amplitude_mm", block.amplitude_mm), number(out, "frequency_Hz", block.frequency_Hz);
  out.member("waveform", block.waveform);
  number(out, "v_max_mm_s", block.v_max_mm_s);
  out.key("cycles").begin_array();
  for (auto const& cycle : block.cycles) write_cycle(out, device, cycle);
  out.end_array();
  out.key("stability").begin_object();
  write_stability(out, "K_eff", data::stability(block, &data::Cycle::K_eff_kN_per_mm));
  write_stability(out, "energy", data::stability(block, &data::Cycle::energy_kN_mm));
  write_stability(out, "damping", data::stability(block, &data::Cycle::damping_percent));
  out.end_object().end_object();
}

void write_assessment(JsonWriter& out, rules::Assessment const& a, std::optional<int> block) {
  out.begin_object();
  out.member("quantity", a.quantity);
  out.key("block");
  block ? out.value(*block) : out.null();
  out.member("clause", a.clause).member("formula", a.formula);
  number(out, "value", a.value);
  out.member("unit", a.unit);
  number(out, "nominal", a.nominal), number(out, "deviation_percent", a.deviation_percent);
  out.member("deviation", a.deviation)
      .member("limit", a.limit)
      .member("verdict", rules::name(a.verdict))
      .member("reason", a.reason);
  out.end_object();
}

void write_assessments(JsonWriter& out, std::string_view key, std::vector<rules::Assessment> const& assessments,
                       std::optional<int> block) {
  out.key(key).begin_array();
  for (auto const& assessment : assessments) write_assessment(out, assessment, block);
  out.end_array();
}

void write_rule_set(JsonWriter& out, LotAcceptance const& acceptance) {
  out.key("rule_set");
  if (!acceptance.has_rules()) {
    out.null();
    return;
  }
  auto const& rules = acceptance.rules;
  out.begin_object().member("id", rules.id).member("title", rules.title).member("edition", rules.edition);
  out.member("verified_by", rules.verified_by)
      .member("source", rules.source)
      .member("origin", std::filesystem::path(rules.origin).filename().string());  // no path of the machine
  out.end_object();
}

void write_design(JsonWriter& out, rules::Design const& design) {
  out.key("design").begin_array();
  for (auto const& value : design_values(design)) {
    out.begin_object().member("name", value.name);
    number(out, "value", value.value);
    out.member("unit", value.unit).end_object();
  }
  out.end_array();
}

// The set's limits of a quantity on every single device.
std::string limits_of_each(rules::RuleSet const& rules, rules::Quantity quantity) {
  std::string text;
  for (auto const& limit : rules.limits)
    if (limit.quantity == quantity && limit.scope == rules::Scope::each)
      text += (text.empty() ? "" : "; ") + rules::limit_text(limit.lower_percent, limit.upper_percent);
  return text;
}

void write_test_factors(JsonWriter& out, rules::LotQuantity const& q) {
  out.key("lambda_test");
  if (!q.test_factors) {
    out.null();
    return;
  }
  out.begin_object();
  number(out, "min", q.test_factors->min);
  out.member("min_cycle", q.test_factors->min_cycle).member("min_device", q.test_min_device);
  number(out, "max", q.test_factors->max);
  out.member("max_cycle", q.test_factors->max_cycle).member("max_device", q.test_max_device).end_object();
}

void write_quantity(JsonWriter& out, rules::RuleSet const& rules, rules::LotQuantity const& q) {
  out.begin_object();
  out.member("quantity", rules::name(q.quantity)).member("unit", q.unit).member("n", std::uint64_t{q.count});
  out.member("without", q.without);
  number(out, "mean", q.mean), number(out, "sd", q.std), number(out, "cov_percent", q.cov_percent);
  number(out, "min", q.min);
  out.member("min_device", q.min_device);
  number(out, "max", q.max);
  out.member("max_device", q.max_device);
  number(out, "nominal", q.nominal), number(out, "deviation_of_mean_percent", q.mean_deviation_percent);
  number(out, "worst_deviation_percent", q.worst_deviation_percent);
  out.member("worst_device", q.worst_device);
  number(out, "fractile_5", q.fractile_5), number(out, "fractile_95", q.fractile_95);
  number(out, "tolerance_k", q.tolerance_factor);
  number(out, "tolerance_lower", q.tolerance_low), number(out, "tolerance_upper", q.tolerance_high);
  out.member("no_lower_bound", q.no_lower);
  write_test_factors(out, q);
  out.member("limit_individual", limits_of_each(rules, q.quantity));
  write_assessments(out, "mean_limits", q.mean_limits, std::nullopt);
  out.member("outlier_note", q.outlier_note);
  out.end_object();
}

void write_outliers(JsonWriter& out, rules::LotView const& lot) {
  out.key("outliers").begin_array();
  for (auto const& quantity : lot.quantities)
    for (auto const& outlier : quantity.outliers) {
      out.begin_object().member("device", outlier.device).member("quantity", rules::name(quantity.quantity));
      number(out, "value", outlier.value);
      out.member("unit", quantity.unit).member("why", outlier.reason).end_object();
    }
  out.end_array();
}

void write_factors(JsonWriter& out, rules::LotView const& lot) {
  out.key("factors").begin_array();
  for (auto const& quantity : lot.quantities)
    for (auto const& bound : quantity.bounds) {
      out.begin_object().member("property", rules::name(quantity.quantity)).member("source", bound.source);
      number(out, "spec_min", bound.spec.min), number(out, "spec_max", bound.spec.max);
      number(out, "lambda_min", bound.combined.min), number(out, "lambda_max", bound.combined.max);
      number(out, "lower", bound.lower), number(out, "upper", bound.upper);
      out.member("unit", quantity.unit).member("note", bound.note).member("no_lower_bound", bound.no_lower);
      out.end_object();
    }
  out.end_array();
}

void write_lot(JsonWriter& out, LotAcceptance const& acceptance) {
  auto const& lot = acceptance.lot;
  out.key("lot").begin_object();
  out.key("size");
  lot.lot_size ? out.value(*lot.lot_size) : out.null();
  out.member("tested", std::uint64_t{lot.devices});
  out.key("required");
  lot.required ? out.value(*lot.required) : out.null();
  out.key("sample");
  write_assessment(out, lot.sample, std::nullopt);
  out.key("quantities").begin_array();
  for (auto const& quantity : lot.quantities) write_quantity(out, acceptance.rules, quantity);
  out.end_array();
  write_outliers(out, lot);
  write_factors(out, lot);
  auto const mean = mean_analysis(lot);
  out.key("mean_analysis").begin_object().key("permitted");
  mean.permitted ? out.value(*mean.permitted) : out.null();
  out.member("sentence", mean.sentence).end_object();
  out.member("note", lot.note);
  out.end_object();
}

}  // namespace

void write_properties(JsonWriter& out, DeviceResult const& device) {
  auto const& acceptance = device.acceptance;
  auto const& properties = device.properties;
  out.key("blocks").begin_array();
  for (auto const& block : properties.blocks) write_block(out, device, block);
  out.end_array();
  out.key("reported");
  if (properties.reported)
    out.begin_object()
        .member("block", properties.reported->block)
        .member("number", properties.reported->number)
        .end_object();
  else
    out.null();
  out.member("properties_refusal", properties.refusal);
  out.key("samples_per_cycle").rounded(properties.samples_per_cycle, 6);
  out.member("notes", device.notes).member("corrections", device.raw.corrections);
  out.key("counting_block");
  acceptance.block ? out.value(*acceptance.block) : out.null();
  out.member("counting_block_choice", acceptance.choice);
  write_assessments(out, "assessments", acceptance.assessments, acceptance.block);
}

void write_acceptance(JsonWriter& out, LotAcceptance const& acceptance) {
  out.begin_object();
  write_rule_set(out, acceptance);
  write_design(out, acceptance.design);
  write_lot(out, acceptance);
  out.end_object();
}

}  // namespace isolaw::render
