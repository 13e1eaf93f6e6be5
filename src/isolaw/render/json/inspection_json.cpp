#include "isolaw/render/json/inspection_json.hpp"

#include <cstddef>
#include <string>
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
    write_device(out, summary.acceptance, summary.devices.front(), device_findings.front());
  } else {
    out.member("title", summary.title).key("devices").objects(summary.devices, [&](auto const& device) {
      write_device(out, summary.acceptance, device, device_findings[place++]);
    });
    write_findings(out, "warnings", warnings(summary));
  }
  out.key("assessment");
  write_acceptance(out, summary.acceptance);
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
