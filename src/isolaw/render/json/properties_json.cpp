#include "isolaw/render/json/properties_json.hpp"

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/acceptance_results.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/study/value_doubts.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

void write_cycle(JsonWriter& out, DeviceResult const& device, data::Cycle const& cycle) {
  out.begin_object();
  write_results(out, cycle_results, CycleOf{cycle, device}, Digits::shown);
  out.end_object();
}

void write_stability(JsonWriter& out, data::Stability const& stability) {
  out.begin_object();
  write_results(out, stability_results, stability, Digits::shown,
                [&](std::string_view) { write_values(out, stability.ratio_to_third, shown_digits); });
  out.end_object();
}

void write_block(JsonWriter& out, DeviceResult const& device, data::Block const& block) {
  out.begin_object();
  write_results(out, block_results, block, Digits::shown, [&](std::string_view key) {
    if (key == "cycles") {
      out.begin_array();
      for (auto const& cycle : block.cycles) write_cycle(out, device, cycle);
      out.end_array();
      return;
    }
    out.begin_object();
    for (auto const& [name, row, property] : followed_properties)
      write_stability(out.key(name), data::stability(block, property));
    out.end_object();
  });
  out.end_object();
}

void write_levels(JsonWriter& out, DeviceResult const& device) {
  out.key("levels").begin_array();
  for (auto const& level : study::levels_of(device)) {
    out.begin_object();
    write_results(out, level_results, level, Digits::shown);
    out.end_object();
  }
  out.end_array();
}

void write_vertical(JsonWriter& out, DeviceResult const& device) {
  out.key("vertical");
  if (!device.vertical_test.given()) {
    out.null();
    return;
  }
  out.begin_object();
  write_results(out, vertical_results, device, Digits::shown, [&](std::string_view key) {
    if (key == "recognised")
      out.value(wording::remarks(device.vertical_test.recognised));
    else
      write_values(out, device.vertical ? device.vertical->loadings_kN_per_mm : std::vector<double>(), shown_digits);
  });
  out.end_object();
}

void write_assessment(JsonWriter& out, rules::Assessment const& assessment, std::optional<int> block) {
  out.begin_object();
  write_results(out, assessment_results, AssessmentOf{assessment, block}, Digits::shown);
  out.end_object();
}

void write_assessments(JsonWriter& out, std::vector<rules::Assessment> const& assessments, std::optional<int> block) {
  out.begin_array();
  for (auto const& assessment : assessments) write_assessment(out, assessment, block);
  out.end_array();
}

void write_rule_set(JsonWriter& out, rules::RuleSet const& rules) {
  auto const file = std::filesystem::path(rules.origin).filename().string();  // without this machine's path
  out.begin_object();
  write_members(out, "id", rules.id, "title", rules.title, "edition", rules.edition, "verified_by", rules.verified_by,
                "source", rules.source, "origin", file);
  out.end_object();
}

void write_design(JsonWriter& out, rules::Design const& design) {
  out.key("design").begin_array();
  for (auto const& [name, value, unit] : design_values(design)) {
    out.begin_object();
    write_members(out, "name", name, "value", value, "unit", unit);
    out.end_object();
  }
  out.end_array();
}

void write_test_factors(JsonWriter& out, rules::LotQuantity const& quantity) {
  if (!quantity.test_factors) {
    out.null();
    return;
  }
  out.begin_object();
  write_results(out, test_factor_results, quantity, Digits::shown);
  out.end_object();
}

void write_quantity(JsonWriter& out, rules::LotQuantity const& quantity) {
  out.begin_object();
  write_results(out, quantity_results, quantity, Digits::shown, [&](std::string_view key) {
    if (key == "lambda_test")
      write_test_factors(out, quantity);
    else
      write_assessments(out, quantity.mean_limits, std::nullopt);
  });
  out.end_object();
}

void write_outliers(JsonWriter& out, rules::LotView const& lot) {
  out.key("outliers").begin_array();
  for (auto const& quantity : lot.quantities)
    for (auto const& outlier : quantity.outliers) {
      out.begin_object();
      write_results(out, lot_outlier_results, OutlierOf{quantity, outlier}, Digits::shown);
      out.end_object();
    }
  out.end_array();
}

void write_factors(JsonWriter& out, rules::LotView const& lot) {
  out.key("factors").begin_array();
  for (auto const& quantity : lot.quantities)
    for (auto const& bound : quantity.bounds) {
      out.begin_object();
      write_results(out, factor_results, FactorOf{quantity, bound}, Digits::shown);
      out.end_object();
    }
  out.end_array();
}

void write_lot(JsonWriter& out, LotAcceptance const& acceptance) {
  auto const& lot = acceptance.lot;
  out.key("lot").begin_object();
  write_members(out, "size", lot.lot_size, "tested", lot.devices, "required", lot.required);
  out.key("sample");
  write_assessment(out, lot.sample, std::nullopt);
  out.key("quantities").begin_array();
  for (auto const& quantity : lot.quantities) write_quantity(out, quantity);
  out.end_array();
  write_outliers(out, lot);
  write_factors(out, lot);
  auto const [permitted, sentence] = mean_analysis(lot);
  out.key("mean_analysis").begin_object();
  write_members(out, "permitted", permitted, "sentence", sentence);
  out.end_object().member("note", lot.note).end_object();
}

}  // namespace

void write_verdict(JsonWriter& out, OverallVerdict const& verdict) {
  out.key("result").begin_object();
  write_results(out, verdict_results, verdict, Digits::shown, [&](std::string_view key) {
    auto const write = [&](auto const& rows, auto const& all) {
      out.begin_array();
      for (auto const& object : all) {
        out.begin_object();
        write_results(out, rows, object, Digits::shown);
        out.end_object();
      }
      out.end_array();
    };
    if (key == "requirements")
      write(requirement_results, verdict.requirements);
    else
      write(remark_results, key == "failing" ? verdict.failing : verdict.not_assessed);
  });
  out.end_object();
}

void write_properties(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device) {
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
  out.member("properties_refusal", wording::reasons(properties.refusal));
  out.key("samples_per_cycle").rounded(properties.samples_per_cycle, 6);
  write_members(out, "notes", wording::remarks(device.notes), "corrections", wording::remarks(device.raw.corrections),
                "counting_block", acceptance.block, "counting_block_choice", acceptance.choice);
  write_levels(out, device);
  write_vertical(out, device);
  out.key("verdict");
  auto const verdict = verdict_on(lot, device);
  verdict ? out.value(rules::name(*verdict)) : out.null();
  auto const sentence = device_verdict(acceptance);
  write_members(out, "verdict_brief", verdict ? sentence.brief() : std::string(), "verdict_text",
                verdict ? sentence.text() : std::string(), "copy_of", acceptance.copy_of);
  out.key("doubts").begin_array();
  for (auto const& doubt : value_doubts(device)) {
    out.begin_object();
    write_results(out, doubt_results, doubt, Digits::shown);
    out.end_object();
  }
  out.end_array().key("assessments");
  write_assessments(out, acceptance.assessments, acceptance.block);
}

void write_acceptance(JsonWriter& out, LotAcceptance const& acceptance) {
  out.begin_object();
  out.key("rule_set");
  acceptance.has_rules() ? write_rule_set(out, acceptance.rules) : static_cast<void>(out.null());
  write_design(out, acceptance.design);
  write_lot(out, acceptance);
  out.end_object();
}

}  // namespace isolaw::render
