#include "isolaw/campaign/observed_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/wording/finding_json.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::campaign {
namespace {

void add_loop(data::TestRecord const& record, std::vector<data::Cycle const*> const& counted, int reference_cycle,
              ObservedBlock& block) {
  auto const* drawn = counted.front();
  for (auto const* cycle : counted)
    if (cycle->number <= reference_cycle) drawn = cycle;
  constexpr std::size_t most_points = 120;
  auto const first = static_cast<std::size_t>(std::lround(drawn->first));
  auto const last = std::min(static_cast<std::size_t>(std::lround(drawn->last)), record.disp_mm.size() - 1);
  auto const intervals = std::min(last - first, most_points - 1);
  for (std::size_t i = 0; i <= intervals; ++i) {
    auto const sample = first + i * (last - first) / intervals;
    block.loop_mm.push_back(record.disp_mm[sample]);
    block.loop_kN.push_back(record.force_kN[sample]);
  }
}

ObservedBlock observed(data::TestRecord const& record, data::Block const& block, int reference_cycle) {
  ObservedBlock seen{.number = block.number,
                     .amplitude_mm = block.amplitude_mm,
                     .frequency_Hz = block.frequency_Hz,
                     .fault = block.fault};
  auto const counted = block.counted();
  for (auto const* cycle : counted)
    seen.cycles.push_back({.number = cycle->number,
                           .K_eff_kN_per_mm = cycle->K_eff_kN_per_mm,
                           .damping_percent = cycle->damping().value_or(0.0),
                           .energy_kN_mm = cycle->energy_kN_mm,
                           .Q_d_kN = cycle->Q_d_kN,
                           .K_d_kN_per_mm = cycle->K_d_kN_per_mm,
                           .load_kN = cycle->N_mean_kN});
  if (!counted.empty()) add_loop(record, counted, reference_cycle, seen);
  return seen;
}

class Observer {
 public:
  explicit Observer(Lot const& lot) : lot_(lot) {}

  ObservedTests operator()() {
    ObservedTests all{.stated = *lot_.conditions};
    for (auto const& device : lot_.devices) {
      std::optional<double> ended_h;  // time at which the previous test ended
      for (auto const& test : device.history) {
        index_ = all.tests.size();
        all.tests.push_back(observe(device, test, ended_h));
      }
    }
    refuse_same_records(all.tests);
    return all;
  }

 private:
  // If several tests have the same record, nobody knows to which of them it belongs, so none of them can use it.
  void refuse_same_records(std::vector<ObservedTest>& tests) const {
    for (auto const& [record, same] : of_record_)
      for (auto const index : same) {
        if (same.size() == 1) break;
        auto const& other = tests[index == same.front() ? same[1] : same.front()];
        tests[index].refusal = fmt::format(
            "the record of this test is also that of the test {} of {}; each test needs a record of its own, and a lot file names each record once",
            printable(other.test), printable(other.device));
        tests[index].blocks.clear();
      }
  }

  // Identifies a record by the hash of its file and the options that choose a part of the file.
  static std::string identity(data::TestRecord const& record, data::ReadOptions const& read) {
    auto parts = Json{record.sha256};
    for (auto const& option : data::reading_table())
      for (std::string_view const chooses : {"columns", "sheet", "test", "rows", "from", "to"})
        if (option.option() == chooses) parts.push_back(option.get(read));
    return parts.dump();
  }

  ObservedTest observe(DeviceInput const& device, TestInput const& input, std::optional<double>& ended_h) {
    ObservedTest test{.device = device.name,
                      .test = input.name,
                      .file = input.shown_file,
                      .place = input.place,
                      .of_device = device.stated,
                      .rubber_thickness_mm = device.info.rubber_thickness_mm,
                      .rubber_area_mm2 = device.info.rubber_area_mm2,
                      .stated = input.stated};
    auto const started = start_h(input.stated.started);
    auto const between_h = started && ended_h ? std::optional(*started - *ended_h) : std::nullopt;
    ended_h.reset();
    try {
      if (between_h) take_rest(*between_h, test.stated);
      auto const record = read_history(input);
      auto const duration_s = record.time_s.empty() ? 0.0 : record.time_s.back() - record.time_s.front();
      constexpr double seconds_per_h = 3600.0;
      if (started) ended_h = *started + duration_s / seconds_per_h;
      if (!record.sha256.empty()) of_record_[identity(record, input.read)].push_back(index_);
      examine(record, test);
    } catch (Error const& error) {
      test.refusal = with_shown_files(to_string(error.complaints().front()), device.directory);
    }
    return test;
  }

  // Sets or checks the stated time at rest. `between_h` is the time from the end of the previous test to the start of
  // this one.
  static void take_rest(double between_h, StatedTest& stated) {
    constexpr double tolerance_h = 0.25, tolerance = 0.1;
    if (between_h < -tolerance_h)
      throw Error(
          {.where = "started",
           .found = fmt::format("{} lies {:.3g} h before the end of the test before", stated.started, -between_h),
           .allowed = "a start after that test had ended"});
    auto const& rest_h = stated.rest_h;
    if (rest_h && std::abs(*rest_h - between_h) > std::max(tolerance_h, tolerance * between_h))
      throw Error({.where = "rest-h",
                   .found = fmt::format("{:.4g} h, and the starts of the tests give {:.4g} h", *rest_h, between_h),
                   .allowed = "rest-h and started that agree, or one of them"});
    if (!rest_h) stated.rest_h = std::max(0.0, between_h);
  }

  void examine(data::TestRecord const& record, ObservedTest& test) {
    test.sha256 = record.sha256;
    auto const properties = data::cyclic_properties(record);
    test.doubts = record.warnings;
    test.farthest_mm = 0.0;
    for (double const d : record.disp_mm)
      test.farthest_mm = std::max(*test.farthest_mm, std::abs(d - properties.centre_mm));
    if (!properties.refusal.empty())
      test.refusal = wording::reasons(properties.refusal);
    else if (properties.failure)
      test.refusal = wording::reasons({*properties.failure});
    if (!test.refusal.empty()) return;
    for (auto const& block : properties.blocks)
      test.blocks.push_back(observed(record, block, lot_.conditions->reference.last_cycle));
  }

  Lot const& lot_;
  std::size_t index_ = 0;                                      // index of the test that is being read
  std::map<std::string, std::vector<std::size_t>> of_record_;  // the tests by identity()
};

template <class Target>
Json values_of(std::span<Option<Target> const> table, Target const& from) {
  auto values = Json::object();
  for (auto const& option : table)
    if (auto const value = option.get(from); !value.is_null()) values[std::string(option.key)] = value;
  return values;
}
template <class Target>
void take_values(std::span<Option<Target> const> table, Json const& values, Target& to) {
  for (auto const& option : table)
    if (auto const found = values.find(option.key); found != values.end()) option.set(to, *found);
}

Json json_of(ObservedBlock const& block) {
  Json json{
      {"number", block.number}, {"amplitude_mm", block.amplitude_mm}, {"frequency_Hz", or_null(block.frequency_Hz)},
      {"fault", block.fault},   {"loop_mm", block.loop_mm},           {"loop_kN", block.loop_kN}};
  json["cycles"] = Json::array();
  for (auto const& cycle : block.cycles)
    json["cycles"].push_back({cycle.number, cycle.K_eff_kN_per_mm, cycle.damping_percent, cycle.energy_kN_mm,
                              cycle.Q_d_kN, cycle.K_d_kN_per_mm, or_null(cycle.load_kN)});
  return json;
}

std::optional<double> real_or_none(Json const& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

ObservedBlock block_of(Json const& json) {
  ObservedBlock block{.number = json.at("number").get<int>(),
                      .amplitude_mm = json.at("amplitude_mm").get<double>(),
                      .frequency_Hz = real_or_none(json.at("frequency_Hz")),
                      .fault = json.at("fault").get<std::string>(),
                      .loop_mm = json.at("loop_mm").get<std::vector<double>>(),
                      .loop_kN = json.at("loop_kN").get<std::vector<double>>()};
  for (auto const& cycle : json.at("cycles"))
    block.cycles.push_back({.number = cycle.at(0).get<int>(),
                            .K_eff_kN_per_mm = cycle.at(1).get<double>(),
                            .damping_percent = cycle.at(2).get<double>(),
                            .energy_kN_mm = cycle.at(3).get<double>(),
                            .Q_d_kN = cycle.at(4).get<double>(),
                            .K_d_kN_per_mm = cycle.at(5).get<double>(),
                            .load_kN = real_or_none(cycle.at(6))});
  return block;
}

Json json_of(ObservedTest const& test) {
  Json json{{"device", test.device},
            {"test", test.test},
            {"file", test.file},
            {"sha256", test.sha256},
            {"place", test.place},
            {"of_device", values_of(compared_devices_table(), test.of_device)},
            {"rubber_thickness_mm", or_null(test.rubber_thickness_mm)},
            {"rubber_area_mm2", or_null(test.rubber_area_mm2)},
            {"stated", values_of(test_table(), test.stated)},
            {"refusal", test.refusal},
            {"farthest_mm", or_null(test.farthest_mm)},
            {"doubts", wording::findings_json(test.doubts)},
            {"blocks", Json::array()}};
  if (auto const& aged = test.stated.aged) json["aged"] = {aged->days, aged->at_C};
  for (auto const& block : test.blocks) json["blocks"].push_back(json_of(block));
  return json;
}

ObservedTest test_of(Json const& json) {
  ObservedTest test{.device = json.at("device").get<std::string>(),
                    .test = json.at("test").get<std::string>(),
                    .file = json.at("file").get<std::string>(),
                    .sha256 = json.at("sha256").get<std::string>(),
                    .place = json.value("place", ""),
                    .rubber_thickness_mm = real_or_none(json.at("rubber_thickness_mm")),
                    .rubber_area_mm2 = real_or_none(json.at("rubber_area_mm2")),
                    .refusal = json.at("refusal").get<std::string>(),
                    .farthest_mm = real_or_none(json.at("farthest_mm"))};
  // The key "doubts" is missing in stores that an earlier build wrote.
  if (auto const doubts = json.find("doubts"); doubts != json.end())
    test.doubts = wording::findings_of(doubts->get<std::string>());
  take_values(compared_devices_table(), json.at("of_device"), test.of_device);
  take_values(test_table(), json.at("stated"), test.stated);
  if (auto const aged = json.find("aged"); aged != json.end())
    test.stated.aged = StatedAgeing{.days = aged->at(0).get<double>(), .at_C = aged->at(1).get<double>()};
  for (auto const& block : json.at("blocks")) test.blocks.push_back(block_of(block));
  return test;
}

}  // namespace

ObservedTests observe_tests(Lot const& lot) {
  return Observer(lot)();
}

std::string text(ObservedTests const& observed) {
  Json json{{"conditions", observed.stated.text}, {"tests", Json::array()}};
  for (auto const& test : observed.tests) json["tests"].push_back(json_of(test));
  return json.dump();
}

ObservedTests tests_of_text(std::string_view text) {
  auto const json = Json::parse(text);
  std::string const place = "the campaign's table [conditions]";
  std::vector<Complaint> complaints;
  auto const table = parse_toml(json.at("conditions").get<std::string>(), place, {.kind = "table", .advice = ""});
  ObservedTests observed{.stated = read_conditions(table, place, complaints)};
  throw_complaints(std::move(complaints), place);
  for (auto const& test : json.at("tests")) observed.tests.push_back(test_of(test));
  return observed;
}

}  // namespace isolaw::campaign
