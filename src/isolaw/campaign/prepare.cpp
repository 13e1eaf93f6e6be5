#include "isolaw/campaign/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/fit/joint_limits.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::campaign {

std::string with_shown_files(std::string text, std::filesystem::path const& directory) {
  auto const prefix = directory.empty() ? std::string() : (directory / "").generic_string();
  if (prefix.empty()) return text;
  for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

namespace {

void show_files(std::vector<Finding>& findings, std::filesystem::path const& directory) {
  for (auto& finding : findings)
    for (auto& word : finding.words) word.text = with_shown_files(std::move(word.text), directory);
}

// A hash of the readable files of a device that was refused, so that a later change of the files is noticed.
std::string hash_of_files(DeviceInput const& input) {
  std::string hashes;
  for (auto const& file : files_of(input)) {
    std::string bytes;
    try {
      bytes = data::load_text(file);
    } catch (Error const&) {
      continue;
    }
    auto const hash = sha256(bytes);
    hashes = hashes.empty() ? hash : sha256(hashes + hash);
  }
  return hashes;
}

void refuse_device(Device& device, std::string why) {  // keeps only the record's file name and hash
  device.refusal = std::move(why);
  data::TestRecord nothing;
  nothing.file = device.file;
  nothing.sha256 = device.raw.sha256;
  device.raw = std::move(nothing);
  device.uncorrected = {};
  device.record = {};
}

// Whether a device is refused if its record has an impossible signal. A campaign refuses it, since no law can be fitted
// to the record. An inspection shows it.
enum class FalseSignals { shown, refused };

void clean(Device& device, data::CleanOptions const& cleaning, FalseSignals false_signals) {
  auto const properties = data::cyclic_properties(device.raw);
  device.record = data::clean(device.raw, properties, cleaning);
  if (false_signals == FalseSignals::shown) return;
  auto const& scored = device.record.scored;
  if (properties.refusal_is_of_fault)
    refuse_device(device, wording::reasons(properties.refusal));
  else if (!scored.empty() && std::ranges::count(scored, 1.0) < 2)
    throw Error({.where = device.file,
                 .found = "what is to be fitted is faulty, or the device fails in it",
                 .allowed = "a sound block, before the device fails",
                 .advice = "isolaw inspect FILE, which says what is wrong in each block"});
}

// Notes the options with which the record was read, so that a report can state a command that reads it again. The first
// finding about how the record was read keeps them as JSON text, which its sentence does not show.
void note_options(TestInput const& input, std::vector<Finding>& recognised) {
  if (recognised.empty()) return;
  Json given = Json::object();
  for (auto const& option : data::reading_table())
    if (auto const value = option.get(input.read); value != option.get({})) given[std::string(option.key)] = value;
  if (!given.empty())
    recognised.front().words.push_back(
        {std::string(given_options), given.dump(-1, ' ', false, Json::error_handler_t::replace)});
}

data::TestRecord read_tests(DeviceInput const& input) {
  std::vector<data::NamedTest> tests;
  for (auto const& test : input.tests) {
    auto& read = tests.emplace_back(data::NamedTest{.name = test.name, .record = read_history(test)});
    note_options(test, read.record.recognised);
    read.record.file = test.shown_file;
  }
  return data::record_of_tests(std::move(tests));
}

// Reads the files of a device's tests a second time, without the corrections that the user asked for. Returns an empty
// record if this fails.
data::TestRecord read_uncorrected(DeviceInput input) {
  for (auto& test : input.tests)
    if (auto as_it_is = data::without_corrections(test.read)) test.read = *std::move(as_it_is);
  try {
    return read_tests(input);
  } catch (Error const&) {
    return {};  // reports then have FindingKind::uncorrected_not_known
  }
}

// Takes the temperature from the header of the record if the lot file gives none. The verdict on the lot requires one
// temperature for all devices, and must be the same whether the user gave a lot file or only the records.
void take_temperature(Device& device) {
  DeviceInfo stated;
  take_device_facts(device.raw.device_facts, stated);
  if (!device.info.temperature_C) device.info.temperature_C = stated.temperature_C;
}

Device prepare_device(DeviceInput const& input, data::CleanOptions const& cleaning, FalseSignals false_signals) {
  Device device{.name = input.name, .file = input.shown_file(), .info = input.info};
  try {
    device.raw = read_tests(input);
    take_temperature(device);
    if (data::is_corrected(device.raw)) device.uncorrected = read_uncorrected(input);
    clean(device, cleaning, false_signals);
    show_files(device.raw.recognised, input.directory);
    show_files(device.raw.warnings, input.directory);
  } catch (Error const& error) {
    device.refusal = with_shown_files(error.what(), input.directory);
    device.complaints = error.complaints();
    for (auto& complaint : device.complaints)
      for (auto* part : {&complaint.where, &complaint.found, &complaint.allowed, &complaint.advice})
        *part = with_shown_files(std::move(*part), input.directory);
    device.raw = device.uncorrected = {};
    device.raw.sha256 = hash_of_files(input);
  }
  device.raw.file = device.file;
  device.vertical = prepare_vertical(input.vertical, input.directory);
  return device;
}

Search prepare_search(std::size_t index, Device const& device, std::string const& law_id, Settings const& settings) {
  Search search{.device = index, .law = law_id};
  auto const& law = laws::find_law(law_id);
  try {
    fit::LawOnRecord const check(law, device.record, settings.integration, settings.turning_points);
    auto box = search_box(law, device.record, settings);
    fit::require_joint_limits(law, box, settings.overrides);
    search.first_box = search.box = std::move(box);
  } catch (Error const& error) {
    search.refusal = error.what();
  }
  return search;
}

Contents without_devices(std::string const& title, Acceptance const& acceptance, Settings const& settings) {
  Contents contents{.title = title, .acceptance = acceptance, .settings = settings};
  contents.settings.laws.clear();
  contents.settings.complete();
  contents.settings.validate();
  return contents;
}

void check_names(std::vector<NamedRecord> const& records) {
  std::vector<Complaint> complaints;
  std::set<std::string> seen;
  for (auto const& one : records) {
    auto const& name = one.name;
    auto const where = "device '" + printable(name) + "'";
    if (name.empty() || name.size() > longest_name || !is_printable(name))
      complaints.push_back({where, "is no name", fmt::format("printable text of at most {} bytes", longest_name), {}});
    else if (!seen.insert(name).second)
      complaints.push_back({where, "is there twice", "a name for each", {}});
  }
  if (records.empty()) complaints.push_back({"records", "there are none", "one or more", {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

Device cleaned(NamedRecord&& given, data::CleanOptions const& cleaning, FalseSignals false_signals) {
  Device device{.name = std::move(given.name),
                .file = given.record.file,
                .info = std::move(given.info),
                .raw = std::move(given.record),
                .uncorrected = std::move(given.uncorrected)};
  device.vertical = prepare_vertical(given.vertical, {});
  take_temperature(device);
  try {
    clean(device, cleaning, false_signals);
  } catch (Error const& error) {
    refuse_device(device, error.what());
  }
  return device;
}

Contents with_devices(Lot const& lot, FalseSignals false_signals) {
  auto contents = without_devices(lot.title, lot.acceptance, lot.settings);
  for (auto const& input : lot.devices)
    contents.devices.push_back(prepare_device(input, contents.settings.clean, false_signals));
  contents.find_copies();
  if (lot.conditions) contents.observed = observe_tests(lot);
  return contents;
}

Contents with_devices(std::vector<NamedRecord> records, std::string const& title, Acceptance const& acceptance,
                      Settings const& settings, FalseSignals false_signals) {
  check_names(records);
  auto contents = without_devices(title, acceptance, settings);
  for (auto& record : records)
    contents.devices.push_back(cleaned(std::move(record), contents.settings.clean, false_signals));
  contents.find_copies();
  return contents;
}

Contents with_searches(Contents contents, std::vector<std::string> const& laws) {
  contents.settings.laws = laws.empty() ? parse_laws(usual_laws) : laws;
  contents.settings.validate();
  // Settings::validate() does not check joint limits, which are conditions between several parameters, so that stores
  // that break them can still be read.
  for (auto const& id : contents.settings.laws)
    fit::require_joint_limits(laws::find_law(id), contents.settings.overrides);
  if (std::ranges::none_of(contents.devices, &Device::usable)) {
    std::vector<Complaint> complaints{
        {.where = "lot",
         .found = contents.devices.size() == 1
                      ? std::string("its one device is not usable")
                      : fmt::format("none of its {} devices is usable", contents.devices.size())}};
    for (auto const& device : contents.devices) {
      // A refusal mostly begins with the name of the file. If this is the device's name too, it is not said twice.
      bool const named = device.refusal.starts_with(device.name + ":");
      complaints.push_back({.where = named ? "" : device.name, .found = device.refusal});
    }
    throw Error(complaints);
  }
  for (std::size_t d = 0; d < contents.devices.size(); ++d) {
    if (!contents.devices[d].usable()) continue;
    for (auto const& law : contents.settings.laws)
      contents.searches.push_back(prepare_search(d, contents.devices[d], law, contents.settings));
  }
  return contents;
}

}  // namespace

// Joins the files of one test into one history. Between two files, time goes on by one sampling interval.
data::TestRecord read_history(TestInput const& input) {
  auto record = data::read_record(input.files.front(), input.read);
  for (std::size_t i = 1; i < input.files.size(); ++i)
    data::continue_with(record, data::read_record(input.files[i], input.read), input.files[i].filename().string());
  return record;
}

fit::SearchBox search_box(laws::LawEntry const& law, data::FitRecord const& record, Settings const& settings) {
  auto box = fit::make_box(law, settings.box, fit::scales_of(record, law.info), settings.overrides);
  return settings.method == Method::best ? fit::on_logarithmic_scales(std::move(box), law) : box;
}

// If the compression test cannot be read or gives no stiffness, the reason is kept in `refusal` and nothing is thrown,
// since laws can be fitted to the device without this test.
data::VerticalTest prepare_vertical(VerticalInput const& given, std::filesystem::path const& directory) {
  data::VerticalTest test;
  if (given.stated_kN_per_mm) test.stated_kN_per_mm = given.stated_kN_per_mm;
  if (given.file.empty()) return test;
  try {
    test = data::read_vertical(given.file, given.read, given.loads);
    test.curve_sha256 = data::curve_hash(test);
    test.found_kN_per_mm = data::vertical_stiffness(test).K_v_kN_per_mm;
  } catch (Error const& error) {
    std::vector<std::string> texts;
    for (auto const& complaint : error.complaints()) texts.push_back(to_string(complaint));
    test.refusal = with_shown_files(joined(texts, "; "), directory);
  }
  test.file = given.shown_file;
  show_files(test.recognised, directory);
  return test;
}

Contents prepare_devices(Lot const& lot) {
  return with_devices(lot, FalseSignals::shown);
}

Contents prepare(Lot const& lot) {
  return with_searches(with_devices(lot, FalseSignals::refused), lot.settings.laws);
}

Contents prepare_devices(std::vector<NamedRecord> records, Acceptance const& acceptance) {
  return with_devices(std::move(records), "", acceptance, {}, FalseSignals::shown);
}

Contents prepare(std::vector<NamedRecord> records, Settings const& settings, std::string const& title) {
  return with_searches(with_devices(std::move(records), title, {}, settings, FalseSignals::refused), settings.laws);
}

}  // namespace isolaw::campaign
