#include "isolaw/app/lot_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <set>

#include "isolaw/api/calibrate.hpp"
#include "isolaw/api/conditions.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::app {
namespace {

bool is_lot_file(std::filesystem::path const& path) {
  return path.extension() == ".toml";
}

// Throws Error for a lot with too many devices or runs, because the program lists all runs before the first one starts.
void refuse_endless(campaign::Lot const& lot) {
  constexpr std::size_t most_runs = 10'000'000;
  auto const runs = static_cast<std::size_t>(lot.settings.runs) * lot.settings.laws.size() * lot.devices.size();
  if (lot.devices.size() > campaign::most_devices)
    throw Error({.where = "lot",
                 .found = fmt::format("{} devices", lot.devices.size()),
                 .allowed = fmt::format("{} or fewer", campaign::most_devices),
                 .advice = "a campaign of its own for each production lot"});
  if (runs > most_runs)
    throw Error({.where = "--runs",
                 .found = fmt::format("{} runs of {} laws on {} devices are {} runs in all", lot.settings.runs,
                                      lot.settings.laws.size(), lot.devices.size(), runs),
                 .allowed = fmt::format("{} in all", most_runs),
                 .advice = "fewer runs, 20 are usual"});
}

// Returns the name of a folder. The path is made canonical first, because paths such as "." and "records/" do not end
// in the name.
std::string folder_name(std::filesystem::path const& directory) {
  auto const path = std::filesystem::weakly_canonical(directory);
  return path.filename().string();
}

// Returns a name for the lot: that of the lot file's folder, of the only input, or of the folder that all inputs share.
// Otherwise it is a text such as "12 records".
std::string name_of(std::vector<std::filesystem::path> const& inputs, std::size_t devices) {
  auto const& first = inputs.front();
  auto const folder = [](std::filesystem::path const& file) {
    return folder_name(std::filesystem::absolute(file).parent_path());
  };
  if (is_lot_file(first)) return folder(first);
  if (inputs.size() == 1) return std::filesystem::is_directory(first) ? folder_name(first) : first.stem().string();
  auto const parent = [](auto const& input) {
    return std::filesystem::absolute(input).lexically_normal().parent_path();
  };
  bool const together = std::ranges::all_of(inputs, [&](auto const& input) {
    return !std::filesystem::is_directory(input) && parent(input) == parent(first);
  });
  auto const shared = together ? folder(first) : std::string();
  return shared.empty() ? fmt::format("{} records", devices) : shared;
}

}  // namespace

std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs) {
  std::vector<std::filesystem::path> files;
  for (auto const& input : inputs) {
    std::error_code none;
    if (!std::filesystem::is_directory(input, none)) {  // a missing file is reported later, when it is read
      files.push_back(input);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    std::vector<std::string> passed_over;
    for (auto const& entry : std::filesystem::directory_iterator(input)) {
      auto const name = entry.path().filename().string();
      // Keeps a symbolic link that leads nowhere or in a circle. The user then gets an error when the program reads it.
      bool const is_dead_link = entry.is_symlink(none) && !entry.exists(none);
      if ((!entry.is_regular_file(none) && !is_dead_link) || name.starts_with('.')) continue;
      if (data::is_record_name(name))
        inside.push_back(entry.path());
      else
        passed_over.push_back(printable(name));
    }
    std::ranges::sort(passed_over);
    if (!inside.empty() && !passed_over.empty())
      say("note: {}: not read, because their names are not those of test records: {}\n", shown(input),
          shortened(passed_over, 6));
    if (inside.empty())
      throw Error({.where = input.string(),
                   .found = "a directory without test records",
                   .allowed = fmt::format(
                       "files ending in {} or {}",
                       joined(data::record_extensions | std::views::take(data::record_extensions.size() - 1)),
                       data::record_extensions.back()),
                   .advice = "name the files themselves"});
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

namespace {

// Returns the values of an option that may be repeated, such as --set. The values from the command line are added to
// those of the lot file. A value replaces the lot file's value for the same parameter.
Json added(Json const& there, Json const& given) {
  auto const parameter = [](std::string const& text) { return text.substr(0, text.find('=')); };
  auto const words = given.get<std::vector<std::string>>();
  auto texts = there.get<std::vector<std::string>>();
  for (auto const& text : words)
    std::erase_if(texts, [&](auto const& other) { return parameter(other) == parameter(text); });
  texts.insert(texts.end(), words.begin(), words.end());
  return texts;
}

void lay_over(Values given, campaign::Settings& settings) {
  for (auto& [key, value] : given)
    if (auto const& setting = *campaign::find_setting(key); setting.kind == Kind::repeated)
      value = added(setting.get(settings), value);
  campaign::apply(given, settings);
}

}  // namespace

void apply(Values const& given, data::ReadOptions& options) {
  lay_over(data::reading_table(), given, options);
  options.corrections.validate();
}

void apply(Values const& given, campaign::DeviceInput& device) {
  for (auto& test : device.tests) apply(given, test.read);
  for (auto& test : device.history) apply(given, test.read);
}

void apply(Values const& given, campaign::Acceptance& acceptance) {
  lay_over(campaign::acceptance_table(), given, acceptance);
  complete_acceptance(acceptance);
  for (auto const& remark : remarks_on_design(acceptance)) say("{}\n", to_string(remark));
}

void apply_vertical(std::vector<std::string> const& given, campaign::Lot& lot) {
  std::vector<Complaint> complaints;
  std::set<std::string> named;
  for (auto const& text : given) {
    // The name of a device may contain "=". So if several names fit, the longest one is taken.
    campaign::DeviceInput* found = nullptr;
    for (auto& device : lot.devices)
      if (text.starts_with(device.name + "=") && (found == nullptr || device.name.size() > found->name.size()))
        found = &device;
    std::vector<std::string> names;
    for (auto const& device : lot.devices) names.push_back(in_quotes(device.name));
    auto const file = found == nullptr ? std::string() : text.substr(found->name.size() + 1);
    if (file.empty())
      complaints.push_back({"--vertical", in_quotes(text) + (found == nullptr ? ": no such device" : ": no file"),
                            "DEVICE=FILE, where DEVICE is " + wording::enumerate(names),
                            fmt::format("--vertical {}=FILE", lot.devices.front().name)});
    else if (!named.insert(found->name).second)
      complaints.push_back({"--vertical", in_quotes(found->name) + " is given twice", "one test for a device", {}});
    else
      found->vertical = {.file = file, .shown_file = printable(std::filesystem::path(file).filename().string())};
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
}

campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options,
                            bool same_device) {
  bool const from_file = inputs.size() == 1 && is_lot_file(inputs.front());
  if (from_file && same_device)
    throw Error({.where = "--same-device",
                 .found = fmt::format("{} is a lot file", inputs.front().string()),
                 .allowed = "records, or a directory of them",
                 .advice = "a [[device.test]] table for each test of a device in the lot file"});
  for (auto const& input : inputs)
    if (!from_file && is_lot_file(input))
      throw Error({.where = input.string(),
                   .found = "a lot file together with other inputs",
                   .allowed = "one lot file alone, or records",
                   .advice = "name the records in the lot file"});
  for (auto const& input : inputs) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(input / "lot.toml", unknown))
      say("{} holds a lot file, which is not used: its records are read as they are; try: {}\n", shown(input),
          shown(input / "lot.toml"));
  }
  auto lot = from_file ? read_lot(inputs.front(), options) : campaign::lot_of_files(records_of(inputs));
  if (lot.title.empty()) lot.title = printable(name_of(inputs, lot.devices.size()));
  // The records are not read yet, so the facts that they state are not compared here.
  if (same_device) campaign::make_one_device(lot);
  return lot;
}

campaign::Lot lot_of(CalibrateArguments const& a) {
  campaign::Settings unused;
  lay_over(a.settings, unused);  // reports wrong usage before files are read
  auto lot = lot_of_inputs(a.inputs, {.allow_outside = a.allow_outside, .other_out = a.out.has_value()}, a.same_device);
  auto& s = lot.settings;
  lay_over(a.settings, s);
  s.complete();
  if (a.out) lot.out = a.out;
  if (a.jobs) lot.jobs = a.jobs;
  for (auto& device : lot.devices) apply(a.read, device);
  apply_vertical(a.vertical, lot);
  apply(a.acceptance, lot.acceptance);
  if (s.laws.empty()) s.laws = campaign::parse_laws(campaign::usual_laws);
  s.validate();
  refuse_endless(lot);
  return lot;
}

bool is_of_lot_file(CalibrateArguments const& a) {
  return a.inputs.size() == 1 && is_lot_file(a.inputs.front());
}

std::filesystem::path output_directory(CalibrateArguments const& a, campaign::Lot const& lot) {
  if (lot.out) return *lot.out;
  return std::filesystem::path("out") / name_of(a.inputs, lot.devices.size());
}

}  // namespace isolaw::app
