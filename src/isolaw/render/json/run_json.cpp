#include "isolaw/render/json/run_json.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "isolaw/campaign/maker.hpp"

namespace isolaw::render {

std::string run_json(RunFacts const& facts) {
  utsname system{};
  uname(&system);
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
  json["threads"] = facts.jobs;
  json["host"] = system.nodename;
  json["system"] = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
  json["compiler"] = __VERSION__;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace isolaw::render
