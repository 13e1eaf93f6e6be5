// Implements `isolaw inspect` and `isolaw init`, which show the contents of files before any law is fitted.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>
#include <string>

#include "isolaw/api/conditions.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/app/proposed_tests.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/render/terminal/inspection_text.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::app {
namespace {

bool refused(study::Summary const& summary) {
  return study::conditions_refused(summary) || std::ranges::any_of(summary.devices, [](auto const& device) {
           auto const& properties = device.properties;
           return device.status != "ok" || properties.refusal_is_of_fault || !properties.block_faults.empty() ||
                  !device.vertical_test.refusal.empty();
         });
}

}  // namespace

int inspect(InspectArguments const& arguments) {
  auto lot = lot_of_inputs(arguments.inputs, {.allow_outside = arguments.allow_outside, .other_out = true},
                           arguments.same_device);
  for (auto& device : lot.devices) apply(arguments.read, device);
  apply_vertical(arguments.vertical, lot);
  apply(arguments.acceptance, lot.acceptance);
  auto const contents = campaign::prepare_devices(lot);
  // If the only device cannot be used, its record is read again, because reading it throws an Error with every
  // complaint.
  if (contents.devices.size() == 1 && !contents.devices.front().usable()) {
    for (auto const& test : lot.devices.front().tests)
      for (auto const& file : test.files) data::read_record(file, test.read);
    throw Error({.where = printable(contents.devices.front().name), .found = contents.devices.front().refusal});
  }
  auto const summary = study::build_summary(contents);
  print(arguments.json ? render::inspection_json(summary) : render::inspection_text(summary, arguments.details));
  if (arguments.out) {
    render::write_inspection(summary, *arguments.out);
    say("written: {}\n", shown(*arguments.out / "inspection.html"));
  }
  if (std::ranges::none_of(contents.devices, &campaign::Device::usable)) {
    if (contents.devices.size() == 1)
      say("the record cannot be used\n");
    else
      say("none of {} records can be used\n", contents.devices.size());
    return exit_wrong_usage;
  }
  return refused(summary) || study::acceptance_failed(summary) ? exit_with_refusals : exit_done;
}

namespace {

// Copies the settings, rules and reading options of another lot file to `lot`. If that file has no common reading
// options, those of its first device are copied. An option that takes a column from a separate file is dropped, because
// that file belongs to the other lot.
void take_over(std::filesystem::path const& file, campaign::Lot& lot) {
  auto const other = read_lot(file, {.allow_outside = true, .other_out = true});
  lot.settings = other.settings;
  lot.acceptance = other.acceptance;
  lot.rules_are_file = other.rules_are_file;
  auto read = other.read == data::ReadOptions{} ? other.devices.front().tests.front().read : other.read;
  std::erase_if(read.columns, [&](auto const& entry) {
    auto const& [channel, column] = entry;
    bool const is_file = data::file_column(column).has_value();
    if (is_file)
      say("columns {} = {} of {} not taken over: the file belongs to that lot; for a file of this lot: --columns {}=FILE:COLUMN\n",
          name(channel), in_quotes(printable(column)), shown(file), name(channel));
    return is_file;
  });
  for (auto& device : lot.devices) device.tests.front().read = read;
}

// Makes a device for each test of each file. If a file holds several tests, sheet and number of the test are added to
// the names of these devices.
campaign::Lot lot_of_tests(InitArguments const& arguments) {
  auto lot = campaign::lot_of_files(records_of(arguments.files));
  if (arguments.like) take_over(*arguments.like, lot);
  std::vector<campaign::DeviceInput> devices;
  for (auto& device : lot.devices) {
    apply(arguments.read, device);
    auto const& input = device.tests.front();
    std::vector<data::TestChoice> tests;
    try {
      tests = data::list_tests(input.files.front(), input.read);
    } catch (Error const&) {
      tests.resize(1, {.sheet = input.read.sheet, .test = input.read.test, .place = {}});
    }
    if (auto const& other = tests.front().passed_over; !other.empty())
      say("{}: {} {} no time, displacement or force, passed over\n", device.shown_file(),
          data::sheet_list(other, other.size() == 1 ? "sheet" : "sheets"), other.size() == 1 ? "names" : "name");
    bool const several = tests.size() > 1;
    bool const sheets = several && tests.front().sheet != tests.back().sheet;
    for (auto const& test : tests) {
      auto one = device;
      if (sheets && test.sheet) one.name += " " + printable(*test.sheet);
      if (several && test.test) one.name += " test " + *test.test;
      one.name = std::string(trimmed(one.name));
      auto& read = one.tests.front().read;
      if (test.sheet) read.sheet = test.sheet;
      if (test.test) read.test = test.test;
      devices.push_back(std::move(one));
    }
  }
  lot.devices = std::move(devices);
  return lot;
}

Complaint about_sheets(std::filesystem::path const& file, campaign::Lot const& lot) {
  std::vector<std::string> sheets;
  for (auto const& device : lot.devices) {
    auto const& test = device.tests.front();
    if (test.files.front() == file && test.read.sheet && std::ranges::find(sheets, *test.read.sheet) == sheets.end())
      sheets.push_back(*test.read.sheet);
  }
  return {.where = file.generic_string(),
          .found = fmt::format("{} taken for {}", data::sheet_list(sheets, "tables"),
                               sheets.size() == 1 ? "a test" : "tests"),
          .allowed = "displacement and force in each of them",
          .advice = "--sheet NAME for the one that is the test"};
}

struct Recognition {
  std::vector<campaign::DeviceInput> devices = {};
  std::vector<RecognisedTest> tests = {};  // one for each device
  campaign::LotFileRemarks remarks = {};
  std::vector<Complaint> complaints = {};  // about files that cannot be read
};

// Reads a test and prints what was recognised in it. Writes the recognised layout, and the facts that the file states
// about the device, into `device`. Then it adds `device` to found.devices.
void recognise(campaign::DeviceInput& device, Recognition& found) {
  auto& test = device.tests.front();
  auto const& file = test.files.front();
  if (!is_printable(file.string()))
    throw Error({.where = file.string(),
                 .found = "a file name that no lot file can hold: it has control characters, marks that turn the "
                          "direction of writing, or bytes that are not UTF-8",
                 .allowed = "printable text in UTF-8",
                 .advice = "rename the file, or calibrate it without a lot file"});
  auto const record = data::read_record(file, test.read);
  test.read = record.layout;
  found.remarks.stated.push_back(campaign::take_device_facts(record.device_facts, device.info));
  found.devices.push_back(device);
  fmt::print("{}: {}\n", device.name == campaign::name_of_file(file) ? test.shown_file : device.name,
             counted(record.size(), "sample"));
  for (auto const& line : wording::remarks(record.recognised)) fmt::print("  {}\n", line);
  auto const properties = data::cyclic_properties(record);
  found.tests.push_back({.condition = {.temperature_C = device.info.temperature_C}});
  if (auto const block = std::ranges::max_element(properties.blocks, {}, &data::Block::amplitude_mm);
      block != properties.blocks.end()) {
    auto& seen = found.tests.back();
    seen.amplitude_mm = block->amplitude_mm;
    seen.cycles = static_cast<int>(block->counted().size());
    seen.condition.frequency_Hz = block->frequency_Hz;
    seen.condition.load_kN = study::mean_load_kN(*block);
  }
  if (properties.refusal_is_of_fault)
    say("{}: isolaw calibrate will leave it out: {}\n", printable(device.name), wording::reasons(properties.refusal));
  else if (!properties.block_faults.empty()) {
    std::vector<std::string> blocks;
    for (auto const& block : properties.blocks)
      if (!block.fault.empty()) blocks.push_back(fmt::to_string(block.number));
    say("{}: isolaw calibrate will not fit laws to block{} {}: {}\n", printable(device.name),
        blocks.size() == 1 ? "" : "s", joined(blocks), wording::reasons(properties.block_faults));
  }
}

// Recognises the tests of all devices. Throws Error if no test can be read.
Recognition recognise_tests(campaign::Lot& lot, bool sheet_given) {
  Recognition found;
  found.remarks.open_keys = true;
  std::set<std::filesystem::path> of_sheets;  // workbooks with an unreadable sheet, if the user chose no sheet
  for (auto& device : lot.devices) {
    auto const& file = device.tests.front().files.front();
    try {
      recognise(device, found);
    } catch (Error const& error) {
      found.complaints.insert(found.complaints.end(), error.complaints().begin(), error.complaints().end());
      found.remarks.left_out.emplace_back(file, to_string(error.complaints().front()));
      if (!sheet_given && device.tests.front().read.sheet) of_sheets.insert(file);
    }
  }
  for (auto const& file : of_sheets) found.complaints.push_back(about_sheets(file, lot));
  if (found.devices.empty()) throw Error(std::move(found.complaints));
  return found;
}

// --like has copied the lot size of another lot. Drops it if this lot has more devices, and otherwise tells the user
// that it was taken over.
void review_lot_size(campaign::Lot& lot, InitArguments const& arguments) {
  auto& size = lot.acceptance.lot_size;
  if (size && static_cast<std::size_t>(*size) < lot.devices.size()) {
    say("lot-size = {} of {} left out: there are {} devices here\n", *size, shown(*arguments.like), lot.devices.size());
    size.reset();
  } else if (size) {
    say("lot-size = {} taken over from {}: change it if this lot has another size\n", *size, shown(*arguments.like));
  }
}

void tell_of_files_outside(std::filesystem::path const& folder, campaign::Lot const& lot,
                           std::filesystem::path const& out) {
  std::vector<std::filesystem::path> outside;
  auto const note_if_outside = [&](std::filesystem::path const& file) {
    if (leads_outside(file, folder)) outside.push_back(file);
  };
  if (lot.rules_are_file) note_if_outside(lot.acceptance.rules_file);
  for (auto const& device : lot.devices) std::ranges::for_each(campaign::files_of(device), note_if_outside);
  if (outside.empty()) return;
  auto const others = outside.size() > 1 ? fmt::format(" and {} more", outside.size() - 1) : std::string();
  say("{}{}: not in the folder of {} or below it: isolaw calibrate will need --allow-outside\n", shown(outside.front()),
      others, shown(out));
}

}  // namespace

int init(InitArguments const& arguments) {
  auto const& out = arguments.out;
  if (std::filesystem::exists(out) && !arguments.force)
    throw Error({.where = out.string(), .found = "exists already", .advice = "--force to overwrite it, or --out FILE"});
  auto lot = lot_of_tests(arguments);
  auto const folder = std::filesystem::absolute(out).parent_path();
  lot.title = printable(folder.filename().string());
  auto [devices, tests, remarks, complaints] = recognise_tests(lot, arguments.read.contains("sheet"));
  for (auto const& complaint : complaints) say("isolaw: {}\n", to_string(complaint));
  if (!remarks.left_out.empty())
    say("{} of {} left out, as comments at the end of {}\n", remarks.left_out.size(), lot.devices.size(), shown(out));
  lot.devices = std::move(devices);
  if (arguments.same_device) {
    auto stated = campaign::make_one_device(lot);
    for (auto const& [key, texts] : stated)
      say("{}: {}: the tests differ, so the device has no value for it; are they tests of one device?\n", key, texts);
    for (auto& of_test : remarks.stated) stated.merge(of_test);
    remarks.stated = {std::move(stated)};
  } else {
    propose_conditions(lot, std::move(tests), remarks);
    if (!remarks.tests.empty())
      say("the names of the records look like conditions of tests: {} ends with a proposal, as comments to be checked\n",
          shown(out));
  }
  review_lot_size(lot, arguments);
  std::vector<std::filesystem::path> inputs;
  for (auto const& device : lot.devices) std::ranges::copy(campaign::files_of(device), std::back_inserter(inputs));
  for (auto const& [file, reason] : remarks.left_out) inputs.push_back(file);
  write_output(out, campaign::lot_file_text(lot, folder, remarks), inputs);
  tell_of_files_outside(folder, lot, out);
  if (remarks.tests.empty())
    fmt::print("\nwritten: {}; next: isolaw calibrate {}\n", shown(out), shown(out));
  else
    fmt::print("\nwritten: {}; next: check the proposal at its end, then isolaw conditions {}\n", shown(out),
               shown(out));
  return remarks.left_out.empty() ? exit_done : exit_with_refusals;
}

}  // namespace isolaw::app
