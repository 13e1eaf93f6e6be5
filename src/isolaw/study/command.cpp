#include "isolaw/study/command.hpp"

#include <algorithm>
#include <vector>

#include "isolaw/base/shell.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::study {
namespace {

// True if the device has the name that it gets without a lot file. Its random numbers depend on this name.
bool is_named_by_its_file(DeviceResult const& device) {
  return device.name == campaign::name_of_file(device.file);
}

}  // namespace

bool takes_lot_file(Summary const& summary) {
  return !std::ranges::all_of(summary.devices, is_named_by_its_file);
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
