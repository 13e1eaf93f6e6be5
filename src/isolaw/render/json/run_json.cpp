#include "isolaw/render/json/run_json.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "isolaw/base/json.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/campaign/maker.hpp"

namespace isolaw::render {

namespace {

double shown(double seconds) {
  return std::round(1e6 * seconds) / 1e6;
}

}  // namespace

std::string profile_json(campaign::Profile const& profile) {
  JsonWriter out;
  out.objects(campaign::phases, [&](auto phase) {
    auto const& cost = profile[phase];
    out.member("phase", campaign::name(phase)).member("cpu_seconds", shown(cost.cpu_s));
    out.member("wall_seconds", shown(cost.wall_s)).member("kernel_seconds", shown(cost.kernel_s));
    out.member("evaluations", cost.evaluations);
  });
  return out.take();
}

std::string run_json(RunFacts const& facts) {
  nlohmann::ordered_json json;
  auto const maker = campaign::this_maker();
  json["isolaw"] = maker.version;
  json["build"] = maker.build;
  json["instruction_set"] = maker.instruction_set;
  json["command"] = facts.command;
  json["directory"] = facts.directory;
  json["started"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(facts.started_at));
  json["search_seconds"] = facts.search_s;
  json["total_seconds"] = facts.total_s;
  json["figures_seconds"] = facts.figures_s;
  json["cpu_seconds"] = facts.cpu_s;
  json["profile"] = nlohmann::ordered_json::parse(facts.profile);
  json["threads"] = facts.jobs;
  json["host"] = host_name();
  json["system"] = system_name();
  json["compiler"] = __VERSION__;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace isolaw::render
