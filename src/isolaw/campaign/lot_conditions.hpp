// The conditions under which devices were tested, as a lot file states them: the keys of [[device.test]] and the table
// [conditions]. The module `conditions` decides whether tests agree with a reference and what they show.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/base/option.hpp"
#include "isolaw/base/toml_reader.hpp"

namespace isolaw::campaign {

struct StatedAgeing {
  double days = 0.0, at_C = 0.0;
};
// Returns a table with a row for each key that the table `aged` of a lot file may have.
std::span<Option<StatedAgeing> const> aged_table();

// The compound and size that a lot file states for a device. Only devices of the same compound and size are compared
// with one another. An empty text counts as a compound or size of its own.
struct StatedDevice {
  std::string compound, size;

  bool operator==(StatedDevice const&) const = default;
};
std::span<Option<StatedDevice> const> compared_devices_table();

struct StatedTest {                                      // what a lot file states about one test of a device
  std::optional<int> order;                              // place of the test in the sequence of the device's tests
  std::string started;                                   // date and time, as in "2026-03-01T09:00:00"; or empty
  std::optional<double> temperature_C, load_kN, rest_h;  // rest_h: time since the end of the previous test
  std::string temperature_of;                            // "core", "surface" or "chamber"; empty if it is not stated
  std::optional<double> conditioned_h;                   // time in a chamber at the temperature, before the test
  std::optional<StatedAgeing> aged = {};
  bool is_acceptance = false;  // the campaign fits laws to this test; lot_file.cpp chooses it if the user does not
  bool takes_part_in_fit = false;
  bool is_scaled = false;  // the specimen is a scaled model of the device
  std::optional<double> scale = {};
};
// Returns a table with a row for each key of StatedTest except `aged`. A row also checks whether a value is allowed.
std::span<Option<StatedTest> const> test_table();
// Returns the start of a test in hours since 1970; nullopt for a text that is no date with a time of day.
std::optional<double> start_h(std::string_view started);
// Reads the table `aged`, which must state both the days and the temperature of the oven.
std::optional<StatedAgeing> read_aged(TomlTable& table, std::string const& file, std::vector<Complaint>& complaints);

struct ConditionRange {
  double low = 0.0, high = 0.0;
};

struct StatedConditions {           // the table [conditions]
  std::string text;                 // this table as TOML, from which read_conditions() makes the other members
  std::string rules;                // the rule set that says how effects combine; empty: Acceptance::rules, if given
  StatedDevice compared;            // compound and size of the devices to compare, if the lot mixes several kinds
  std::vector<std::string> assume;  // effects for which the rule set's default factors may replace missing tests
  struct {
    double temperature_C = 20.0;
    std::optional<double> frequency_Hz, load_kN, strain_percent, disp_mm;
    int first_cycle = 3, last_cycle = 3;
  } reference;
  struct {
    std::optional<ConditionRange> temperature_C, frequency_Hz, load_kN;
    bool full_rest = false;             // rest = "full": the device has rested until it is as new
    std::optional<double> rest_h = {};  // the time at rest since the last motion, if it is stated instead
    std::optional<int> cycles = {};
    std::optional<StatedAgeing> aged = {};
    std::optional<double> years = {}, service_temperature_C = {};
  } design;
  struct {
    double temperature_C = 2.0, frequency_percent = 10.0, load_percent = 10.0, strain_percent = 5.0;
  } tolerance;
  std::optional<double> activation_energy_kJ_per_mol;
  std::string activation_energy_source;
  double heat_capacity_MJ_per_m3K = 2.0;
};
// Complains about every key and value that is wrong, at its line.
StatedConditions read_conditions(toml::table const& table, std::string const& file, std::vector<Complaint>& complaints);

}  // namespace isolaw::campaign
