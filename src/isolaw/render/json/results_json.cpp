#include "isolaw/render/json/results_json.hpp"

#include <array>
#include <cstdint>

#include "isolaw/base/number_text.hpp"
#include "isolaw/study/published_results.hpp"

namespace isolaw::render {
namespace {

struct Writer {
  JsonWriter& out;
  std::optional<int> digits;

  void number(std::optional<double> const& value) const { digits ? out.rounded(value, *digits) : out.value(value); }

  void operator()(std::monostate) const { out.null(); }
  void operator()(double value) const { number(value); }
  void operator()(std::vector<std::string> const* texts) const { out.value(*texts); }
  void operator()(Statistic const& statistic) const {
    out.begin_object().key("mean"), number(statistic.mean);
    out.key("std"), number(statistic.std);
    out.key("best"), number(statistic.best);
    out.end_object();
  }
  void operator()(Ends const& ends) const {
    out.begin_array(), number(ends.lower), number(ends.upper);
    out.end_array();
  }
  void operator()(study::Nested) const {}
  void operator()(auto const& value) const { out.value(value); }
};

}  // namespace

void write_value(JsonWriter& out, Value const& value, std::optional<int> digits) {
  std::visit(Writer{out, digits}, value);
}

void write_values(JsonWriter& out, std::span<double const> values, std::optional<int> digits) {
  out.array(values, [&](double value) { write_value(out, value, digits); });
}

void write_profile(JsonWriter& out, ParameterAnalysis const& analysis, std::optional<int> digits) {
  out.object([&] {
    write_values(out.key("value"), analysis.profile_value, digits);
    write_values(out.key("objective"), analysis.profile_objective, digits);
  });
}

void write_settings(JsonWriter& out, study::Summary const& summary) {
  out.key("settings").object([&] {
    for (auto const& setting : summary.settings) out.key(setting.key).json(setting.json);
  });
}

void write_recommendation(JsonWriter& out, study::Summary const& summary,
                          std::optional<study::Recommendation> const& recommendation, UnitSystems systems) {
  auto const said = [&](std::string_view key, auto const& say) { write_said(out.key(key), systems, say); };
  auto const write_reasons = [&](std::string_view key, std::vector<Finding> const& findings) {
    out.key(key).objects(findings, [&](Finding const& finding) {
      out.member("kind", wording::row(finding.kind).key);
      said("sentence", [&](auto const& units) { return wording::remark(finding, units); });
    });
  };
  out.key("recommendation");
  if (!recommendation) {
    out.null();
    return;
  }
  auto const& advice = *recommendation;
  out.begin_object().key("law");
  advice.law ? out.value(summary.laws[*advice.law].id) : out.null();
  said("headline", [&](auto const& units) { return wording::sentence(advice.answer.front(), units); });
  said("explanation", [&](auto const& units) {
    return wording::paragraph({advice.answer.begin() + 1, advice.answer.end()}, units);
  });
  said("answer", [&](auto const& units) { return wording::paragraph(advice.answer, units); });
  out.member("sure", study::name(advice.confidence));
  write_reasons("reasons", advice.reasons);
  write_reasons("weak", advice.law ? advice.doubts() : std::vector<Finding>());
  write_reasons("surer", advice.improvements);
  write_reasons("reach", advice.range_findings);
  out.member("valid_mm", advice.valid_mm);
  out.member("programs", advice.programs ? wording::sentence(*advice.programs) : std::string());
  out.member("export_command", study::export_command(summary, advice, "."));
  out.key("spread");
  if (auto const& spread = advice.spread)
    out.object([&] {
      out.member("laws", std::uint64_t{spread->count}).member("disp_mm", spread->disp_mm);
      write_values(out.key("K_kN_per_mm"), std::array{spread->K_low_kN_per_mm, spread->K_high_kN_per_mm}, {});
      write_values(out.key("energy_kN_mm"), std::array{spread->energy_low_kN_mm, spread->energy_high_kN_mm}, {});
    });
  else
    out.null();
  out.key("standings").objects(advice.standings, [&](study::Standing const& standing) {
    out.member("law", summary.laws[standing.law].id).member("place", study::name(standing.rank));
    out.member("error", standing.error).member("fits", standing.fits).member("new_device", standing.new_device);
    out.member("predicts", standing.predicts).member("parameters", std::uint64_t{standing.parameters});
    said("reason",
         [&](auto const& units) { return standing.reason ? wording::remark(*standing.reason, units) : std::string(); });
    out.member("reason_kind", standing.reason ? wording::row(standing.reason->kind).key : std::string_view());
    write_reasons("weak", standing.doubts);
  });
  out.end_object();
}

void write_published(JsonWriter& out, study::Summary const& summary, Digits digits) {
  out.key("published");
  auto const comparison = study::published(summary);
  if (!comparison) {
    out.null();
    return;
  }
  out.begin_object().member("source", comparison->source).member("verdict", comparison->verdict);
  write_rows(out.key("laws"), study::published_law_results, comparison->laws, digits);
  write_rows(out.key("statements"), study::published_statement_results, comparison->statements, digits);
  out.end_object();
}

void write_remarks(JsonWriter& out, std::vector<Finding> const& findings, UnitSystems systems) {
  out.array(findings, [&](Finding const& finding) {
    write_said(out, systems, [&](auto const& units) { return wording::remark(finding, units); });
  });
}

void write_findings(JsonWriter& out, std::string_view key, std::vector<Finding> const& findings, unsigned place,
                    UnitSystems systems) {
  auto const write_list = [&](std::string_view name, auto const& values) {
    if (!values.empty()) out.key(name).array(values, [&](auto const& value) { out.value(value); });
  };
  out.key(key).objects(wording::grouped(findings, place), [&](auto const& group) {
    auto const& row = wording::row(group.front().kind);
    out.member("kind", row.key).member("topic", row.topic);
    out.member("severity", wording::name(row.severity));
    write_said(out.key("sentence"), systems, [&](auto const& units) { return wording::sentence(group, units); });
    out.member("certificate", (row.appearance & wording::on_certificate) != 0)
        .member("action", row.action)
        .member("law", group.front().law);
    out.member("other_laws", group.front().other_laws);
    out.member("devices", wording::devices_of(group)).member("parameters", wording::parameters_of(group));
    out.key("blocks").array(wording::blocks_of(group), [&](int block) { out.value(block); });
    out.key("each").objects(group, [&](Finding const& finding) {
      write_list("devices", finding.devices);
      write_list("parameters", finding.parameters);
      write_list("blocks", finding.blocks);
      out.key("numbers").object([&] {
        for (auto const& number : finding.numbers) out.member(number.name, number.value);
      });
    });
  });
}

}  // namespace isolaw::render
