#include "isolaw/study/command.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "isolaw/base/shell.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"

namespace isolaw::study {
namespace {

// True if the device has the name that it gets without a lot file. Its random numbers depend on this name.
bool is_named_by_its_file(DeviceResult const& device) {
  return device.name == campaign::name_of_file(device.file);
}

// The options of reading that a record was read with, as a JSON object; empty if there were none.
std::string_view options_of(DeviceResult const& device) {
  auto const& recognised = device.raw.recognised;
  return recognised.empty() ? std::string_view() : recognised.front().word(campaign::given_options);
}

// A command line gives all its records the same options. A device that was refused has no record and no options.
std::optional<std::string_view> shared_options(Summary const& summary) {
  std::optional<std::string_view> shared;
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    if (shared && *shared != options_of(device)) return std::nullopt;
    shared = options_of(device);
  }
  return shared.value_or(std::string_view());
}

}  // namespace

bool takes_lot_file(Summary const& summary) {
  return !std::ranges::all_of(summary.devices, is_named_by_its_file) || !shared_options(summary);
}

std::string command_again(Summary const& summary) {
  if (summary.laws.empty()) return {};
  std::vector<std::string> words{"isolaw", "calibrate"};
  if (takes_lot_file(summary))
    words.push_back("LOT.toml");
  else
    for (auto const& device : summary.devices) words.push_back(device.file);
  auto const add = [&](OptionInfo const& option, Json const& value) {
    for (auto& word : words_of(option, value)) words.push_back(std::move(word));
  };
  if (!takes_lot_file(summary)) {
    auto const given = Json::parse(*shared_options(summary), nullptr, false);
    for (auto const& option : data::reading_table())
      if (given.is_object() && given.contains(option.key)) add(option, given[std::string(option.key)]);
  }
  for (auto const& [key, json] : summary.settings) {
    auto const* setting = campaign::find_setting(key);
    auto const value = Json::parse(json, nullptr, false);
    if (setting != nullptr && !setting->stored_only && !value.is_discarded()) add(*setting, value);
  }
  add(*campaign::find_setting("seed"), summary.seed);
  for (auto const& option : campaign::acceptance_table()) add(option, option.get(summary.asked));
  return shell_quoted(words);
}

}  // namespace isolaw::study
