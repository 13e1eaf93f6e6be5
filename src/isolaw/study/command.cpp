#include "isolaw/study/command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "isolaw/base/shell.hpp"

namespace isolaw::study {
namespace {

// Settings that are options of the same name; the others belong to a method and have no option.
constexpr std::string_view options[] = {
    "laws",       "method",      "integration",  "turning-points", "runs",
    "population", "generations", "box",          "smooth",         "samples-per-cycle",
    "fit-blocks", "fit-cycles",  "score-blocks", "analysis",       "replicates"};

std::string text_of(nlohmann::json const& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string joined;
  for (auto const& item : value) joined += (joined.empty() ? "" : ",") + text_of(item);
  return joined;
}

void add_setting(std::vector<std::string>& words, std::string const& key, nlohmann::json const& value) {
  if (key == "set") {
    for (auto const& change : value) words.insert(words.end(), {"--set", text_of(change)});
  } else if (key == "center") {
    if (value == true) words.push_back("--center");
  } else if (key == "stagnation_tolerance") {
    words.insert(words.end(), {"--stagnation-tolerance", text_of(value)});
  } else if (std::ranges::find(options, key) != std::end(options)) {
    bool const usual = key == "score-blocks" && value == "all";  // the option stands beside --fit-blocks alone
    if (!usual) words.insert(words.end(), {"--" + key, text_of(value)});
  }
}

// As a device is named without a lot file; its name is part of its seed.
bool is_named_by_its_file(DeviceResult const& device) {
  return device.name == std::filesystem::path(device.file).stem().string();
}

}  // namespace

std::string command_again(Summary const& summary) {
  if (summary.laws.empty()) return {};
  std::vector<std::string> words{"isolaw", "calibrate"};
  if (std::ranges::all_of(summary.devices, is_named_by_its_file)) {
    for (auto const& device : summary.devices) words.push_back(device.file);
  } else {
    words.push_back("LOT.toml");
  }
  for (auto const& setting : summary.settings) {
    auto const value = nlohmann::json::parse(setting.json, nullptr, false);
    if (!value.is_discarded()) add_setting(words, setting.key, value);
  }
  words.insert(words.end(), {"--seed", std::to_string(summary.seed)});
  auto const& asked = summary.asked;
  if (!asked.rules_file.empty()) words.insert(words.end(), {"--rules", asked.rules_file});
  if (!asked.design.empty()) words.insert(words.end(), {"--design", asked.design});
  if (asked.lot_size) words.insert(words.end(), {"--lot-size", std::to_string(*asked.lot_size)});
  return shell_quoted(words);
}

}  // namespace isolaw::study
