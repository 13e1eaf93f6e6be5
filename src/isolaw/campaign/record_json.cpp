#include "isolaw/campaign/record_json.hpp"

#include <algorithm>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/wording/finding_json.hpp"

namespace isolaw::campaign {
namespace {

Json json_of(std::vector<Finding> const& findings) {
  return Json::parse(wording::findings_json(findings));
}

std::vector<Finding> findings_in(Json const& json) {
  return wording::findings_of(json.dump());
}

}  // namespace

Json fault_json(data::SignalFault const& fault) {
  return {{"samples", fault.samples}, {"finding", json_of({fault.finding})}};
}

data::SignalFault fault_of(Json const& json, std::size_t samples) {
  auto found = json.at("samples").get<std::vector<std::size_t>>();
  auto const findings = findings_in(json.at("finding"));
  auto const kind = findings.size() == 1 ? data::fault_kind(findings.front().kind) : std::nullopt;
  if (!kind || found.empty() || std::ranges::max(found) >= samples)
    throw Error({.found = "a fault that lies in no signal of the campaign"});
  return {.kind = *kind,
          .channel = std::string(findings.front().word("channel")),
          .samples = std::move(found),
          .finding = findings.front()};
}

std::string facts_json(data::TestRecord const& record) {
  auto json = Json::object({{"file", record.file}, {"sha256", record.sha256}});
  auto& layout = json["layout"] = Json::object();
  for (auto const& option : data::reading_table())
    if (auto const value = option.get(record.layout); value != option.get({})) layout[std::string(option.key)] = value;
  json["checks_physics"] = record.layout.checks_physics;
  json["device_facts"] = record.device_facts;
  json["recognised"] = json_of(record.recognised);
  json["corrections"] = json_of(record.corrections);
  json["warnings"] = json_of(record.warnings);
  auto& faults = json["faults"] = Json::array();
  for (auto const& fault : record.faults) faults.push_back(fault_json(fault));
  auto& tests = json["tests"] = Json::array();
  for (auto const& test : record.tests) tests.push_back({test.name, test.file, test.sha256});
  json["starts"] = record.starts;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void take_facts(std::string const& text, data::TestRecord& record) {
  auto const json = Json::parse(text);
  record.file = json.at("file").get<std::string>();
  record.sha256 = json.at("sha256").get<std::string>();
  lay_over(data::reading_table(), json.at("layout").get<Values>(), record.layout);
  record.layout.checks_physics = json.at("checks_physics").get<bool>();
  record.device_facts = json.at("device_facts").get<std::vector<std::pair<std::string, std::string>>>();
  record.recognised = findings_in(json.at("recognised"));
  record.corrections = findings_in(json.at("corrections"));
  record.warnings = findings_in(json.at("warnings"));
  for (auto const& fault : json.at("faults")) record.faults.push_back(fault_of(fault, record.size()));
  for (auto const& test : json.at("tests"))
    record.tests.push_back({.name = test.at(0).get<std::string>(),
                            .file = test.at(1).get<std::string>(),
                            .sha256 = test.at(2).get<std::string>()});
  record.starts = json.at("starts").get<std::vector<std::size_t>>();
}

}  // namespace isolaw::campaign
