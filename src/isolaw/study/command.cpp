#include "isolaw/study/command.hpp"

#include <algorithm>
#include <iterator>
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

// True if the device has the name that it gets without a lot file. Otherwise a command without a lot file would give
// other results, since the random numbers of its searches depend on the name.
bool is_named_by_its_files(DeviceResult const& device) {
  if (device.raw.tests.empty()) return device.name == campaign::name_of_file(device.file);
  return device.name == campaign::name_of_tests(device.raw.tests) &&
         std::ranges::all_of(device.raw.tests,
                             [](auto const& test) { return test.name == campaign::name_of_file(test.file); });
}

std::vector<std::string> files_of(DeviceResult const& device) {
  if (device.raw.tests.empty()) return {device.file};
  std::vector<std::string> files;
  for (auto const& test : device.raw.tests) files.push_back(test.file);
  return files;
}

// Returns, for each record, the options with which it was read, as a JSON object; empty if there were none. The first
// finding of a record holds this text.
std::vector<std::string_view> options_of(DeviceResult const& device) {
  auto const& recognised = device.raw.recognised;
  if (device.raw.tests.empty())
    return {recognised.empty() ? std::string_view() : recognised.front().word(campaign::given_options)};
  std::vector<std::string_view> options;
  for (auto const& test : device.raw.tests) {
    auto const first =
        std::ranges::find_if(recognised, [&](Finding const& finding) { return finding.word("part") == test.name; });
    options.push_back(first == recognised.end() ? std::string_view() : first->word(campaign::given_options));
  }
  return options;
}

// The options that all records were read with. nullopt if the records differ in them: no single command line can then
// replace the lot file. A device that was refused has no record and no options.
std::optional<std::string_view> shared_options(Summary const& summary) {
  std::optional<std::string_view> shared;
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    for (auto const options : options_of(device)) {
      if (shared && *shared != options) return std::nullopt;
      shared = options;
    }
  }
  return shared.value_or(std::string_view());
}

// Devices with several tests need a lot file, unless there is just one device: then the option --same-device says that
// all files are its tests.
bool is_one_device(Summary const& summary) {
  return summary.devices.size() == 1 && !summary.devices.front().raw.tests.empty();
}

}  // namespace

bool takes_lot_file(Summary const& summary) {
  bool const several_tests =
      std::ranges::any_of(summary.devices, [](DeviceResult const& device) { return !device.raw.tests.empty(); });
  return !std::ranges::all_of(summary.devices, is_named_by_its_files) || !shared_options(summary) ||
         (several_tests && !is_one_device(summary));
}

std::string command_again(Summary const& summary) {
  if (summary.laws.empty()) return {};
  std::vector<std::string> words{"isolaw", "calibrate"};
  if (takes_lot_file(summary))
    words.push_back("LOT.toml");
  else
    for (auto const& device : summary.devices) std::ranges::copy(files_of(device), std::back_inserter(words));
  auto const add = [&](OptionInfo const& option, Json const& value) {
    for (auto& word : words_of(option, value)) words.push_back(std::move(word));
  };
  if (!takes_lot_file(summary)) {
    if (is_one_device(summary)) words.emplace_back("--same-device");
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
