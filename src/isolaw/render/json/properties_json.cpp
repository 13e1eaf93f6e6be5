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

void write_block(JsonWriter& out, DeviceResult const& device, data::Block const& block) {
  write_results(out, block_results, block, Digits::shown, [&](std::string_view key) {
    if (key == "cycles")
      return void(out.objects(block.cycles, [&](data::Cycle const& cycle) {
        write_results(out, cycle_results, CycleOf{cycle, device}, Digits::shown);
      }));
    out.object([&] {
      for (auto const& [name, row, property] : followed_properties) {
        auto const stability = data::stability(block, property);
        out.key(name).object([&] {
          write_results(out, stability_results, stability, Digits::shown,
                        [&](std::string_view) { write_values(out, stability.ratio_to_third, shown_digits); });
        });
      }
    });
  });
}

void write_vertical(JsonWriter& out, DeviceResult const& device, UnitSystems systems) {
  out.key("vertical");
  if (!device.vertical_test.is_given()) return void(out.null());
  out.object([&] {
    write_results(out, vertical_results, device, Digits::shown, [&](std::string_view key) {
      if (key == "recognised")
        write_remarks(out, device.vertical_test.recognised, systems);
      else
        write_values(out, device.vertical ? device.vertical->loadings_kN_per_mm : std::vector<double>(), shown_digits);
    });
  });
}

void write_assessments(JsonWriter& out, std::vector<rules::Assessment> const& assessments, std::optional<int> block) {
  out.objects(assessments, [&](rules::Assessment const& assessment) {
    write_results(out, assessment_results, AssessmentOf{assessment, block}, Digits::shown);
  });
}

void write_quantity(JsonWriter& out, rules::LotQuantity const& quantity) {
  write_results(out, quantity_results, quantity, Digits::shown, [&](std::string_view key) {
    if (key != "lambda_test") return write_assessments(out, quantity.mean_limits, std::nullopt);
    if (!quantity.test_factors) return void(out.null());
    out.object([&] { write_results(out, test_factor_results, quantity, Digits::shown); });
  });
}

void write_lot(JsonWriter& out, LotAcceptance const& acceptance) {
  auto const& lot = acceptance.lot;
  std::vector<OutlierOf> outliers;
  std::vector<FactorOf> factors;
  for (auto const& quantity : lot.quantities) {
    for (auto const& outlier : quantity.outliers) outliers.push_back({quantity, outlier});
    for (auto const& bound : quantity.bounds) factors.push_back({quantity, bound});
  }
  write_members(out, "size", lot.lot_size, "tested", lot.devices, "required", lot.required);
  out.key("sample").object([&] {
    write_results(out, assessment_results, AssessmentOf{lot.sample, std::nullopt}, Digits::shown);
  });
  out.key("quantities").objects(lot.quantities, [&](auto const& quantity) { write_quantity(out, quantity); });
  write_rows(out.key("outliers"), lot_outlier_results, outliers, Digits::shown);
  write_rows(out.key("factors"), factor_results, factors, Digits::shown);
  auto const [permitted, sentence] = mean_analysis(acceptance);
  out.key("mean_analysis").begin_object();
  write_members(out, "permitted", permitted, "sentence", sentence);
  out.end_object().member("note", lot.note);
}

}  // namespace

void write_verdict(JsonWriter& out, OverallVerdict const& verdict) {
  out.key("result").object([&] {
    write_results(out, verdict_results, verdict, Digits::shown, [&](std::string_view key) {
      if (key == "requirements") return write_rows(out, requirement_results, verdict.requirements, Digits::shown);
      write_rows(out, remark_results, key == "failing" ? verdict.failing : verdict.not_assessed, Digits::shown);
    });
  });
}

void write_tests(JsonWriter& out, DeviceResult const& device) {
  out.key("tests").objects(device.raw.tests, [&](data::TestSource const& test) {
    write_members(out, "name", test.name, "file", test.file, "sha256", test.sha256);
  });
}

void write_properties(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device, UnitSystems systems) {
  auto const& acceptance = device.acceptance;
  auto const& properties = device.properties;
  out.key("blocks").objects(properties.blocks, [&](auto const& block) { write_block(out, device, block); });
  out.key("reported");
  if (auto const& reported = properties.reported)
    out.object([&] { out.member("block", reported->block).member("number", reported->number); });
  else
    out.null();
  write_said(out.key("properties_refusal"), systems,
             [&](auto const& units) { return wording::reasons(properties.refusal, units); });
  out.key("samples_per_cycle").rounded(properties.samples_per_cycle, 6);
  write_remarks(out.key("notes"), device.notes, systems);
  write_remarks(out.key("corrections"), device.raw.corrections, systems);
  write_members(out, "counting_block", acceptance.block, "counting_block_choice", acceptance.choice);
  write_rows(out.key("levels"), level_results, study::levels_of(device), Digits::shown);
  write_rows(out.key("skeleton"), skeleton_results, study::skeleton_of(device), Digits::shown);
  write_vertical(out, device, systems);
  auto const verdict = verdict_on(lot, device);
  auto const sentence = device_verdict(acceptance);
  write_members(out, "verdict", verdict, "verdict_brief", verdict ? sentence.brief() : std::string(), "verdict_text",
                verdict ? sentence.text() : std::string(), "as_corrected", sentence.as_corrected, "copy_of",
                acceptance.copy_of);
  write_rows(out.key("doubts"), doubt_results, value_doubts(device), Digits::shown);
  write_assessments(out.key("assessments"), acceptance.assessments, acceptance.block);
}

void write_acceptance(JsonWriter& out, LotAcceptance const& acceptance) {
  auto const& rules = acceptance.rules;
  out.begin_object().key("rule_set");
  if (acceptance.has_rules())
    out.object([&] {
      auto const file = std::filesystem::path(rules.origin).filename().string();
      write_members(out, "id", rules.id, "title", rules.title, "edition", rules.edition, "verified_by",
                    rules.verified_by, "source", rules.source, "origin", file);
    });
  else
    out.null();
  out.key("design").objects(design_values(acceptance.design), [&](auto const& design) {
    write_members(out, "name", design.name, "value", design.value, "unit", design.unit);
  });
  out.key("lot").object([&] { write_lot(out, acceptance); });
  out.end_object();
}

}  // namespace isolaw::render
