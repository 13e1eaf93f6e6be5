#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/render/json/conditions_json.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/read.hpp"
#include "isolaw/render/json/properties_json.hpp"
#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

constexpr int inspection_schema = 1;

// Writes what isolaw decided when it read the file (columns, units and so on), for a program that lets the user change
// these decisions. The member `recognised` has a sentence for each decision.
void write_decisions(JsonWriter& out, data::TestRecord const& raw) {
  out.key("decisions").objects(raw.recognised, [&](Finding const& finding) {
    out.member("kind", wording::row(finding.kind).key);
    for (std::string_view const name : {"option", "channel", "column_by", "stated_unit"})
      if (auto const word = finding.word(name); !word.empty()) out.member(name, word);
  });
}

// Writes the first samples and the range of each channel, so that a user can compare them with the file.
void write_values_read(JsonWriter& out, data::TestRecord const& raw) {
  auto const write = [&](std::string_view key, std::vector<double> const& values) {
    if (values.empty()) return;
    out.key(key).object([&] {
      write_values(out.key("first"), std::span(values).first(std::min<std::size_t>(4, values.size())), shown_digits);
      write_members(out, "least", std::ranges::min(values), "largest", std::ranges::max(values));
    });
  };
  out.key("values").object([&] {
    write("time_s", raw.time_s);
    write("disp_mm", raw.disp_mm);
    write("force_kN", raw.force_kN);
    write("load_kN", raw.load_kN);
  });
}

void write_device(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device,
                  std::vector<Finding> const& findings) {
  write_members(out, "name", device.name, "file", device.file, "sha256", device.sha256, "status", device.status,
                "message", device.message, "samples", device.raw.size());
  write_tests(out, device);
  write_complaints(out.key("complaints"), device.complaints);
  auto const write_channels = [&](std::string_view key, auto const& of) {
    out.key(key).object([&] {
      for (auto const& [channel, text] : of) out.member(data::name(channel), text);
    });
  };
  write_channels("columns", device.raw.layout.columns);
  write_channels("units", device.raw.layout.units);
  // A file with a single sheet has null for `sheet`, and a file with a single test has null for `test`.
  write_members(out, "sheet", device.raw.layout.sheet, "test", device.raw.layout.test, "recognised",
                wording::remarks(device.raw.recognised), "warnings", wording::remarks(findings));
  write_decisions(out, device.raw);
  write_values_read(out, device.raw);
  write_findings(out, "findings", findings, wording::anywhere);
  write_properties(out, lot, device);
  write_rows(out.key("effects"), effect_results, device.effects, Digits::shown);
}

}  // namespace

std::string inspection_json(Summary const& summary) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.member("schema", inspection_schema).member("isolaw", summary.version);
  write_verdict(out, overall_verdict(summary));
  auto const device_findings = device_warnings(summary);
  std::size_t place = 0;
  if (summary.devices.size() == 1) {
    auto findings = device_findings.front();
    if (summary.without_corrections) findings.push_back(*summary.without_corrections);
    write_device(out, summary.acceptance, summary.devices.front(), findings);
  } else {
    out.member("title", summary.title).key("devices").objects(summary.devices, [&](auto const& device) {
      write_device(out, summary.acceptance, device, device_findings[place++]);
    });
    write_findings(out, "warnings", warnings(summary));
  }
  out.key("assessment");
  write_acceptance(out, summary.acceptance);
  write_conditions(out, summary);
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
