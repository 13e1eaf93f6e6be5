// The conditions under which devices were tested, as a lot file states them: the keys of [[device.test]] and the table
// [conditions]. Whether tests agree with a reference, and what they show, is the business of the module `conditions`.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "isolaw/base/option.hpp"
#include "isolaw/base/toml_reader.hpp"

namespace isolaw::campaign {

struct StatedAgeing {
  double days = 0.0, at_C = 0.0;
};

struct StatedTest {                                      // about one test of a device
  std::optional<int> order;                              // place among all tests of the device
  std::optional<double> temperature_C, load_kN, rest_h;  // rest_h: since the motion of the test before
  std::string temperature_of;                            // core, surface or chamber; empty if it is not stated
  std::optional<StatedAgeing> aged = {};
  bool is_acceptance = false;  // its record stands for the device everywhere else
};
// The rows for these keys, but for `aged`. A row alone judges a value.
std::span<Option<StatedTest> const> test_table();
// Reads the table `aged`, which must state both the days and the temperature of the oven.
std::optional<StatedAgeing> read_aged(TomlTable& table, std::string const& file, std::vector<Complaint>& complaints);

struct ConditionRange {
  double low = 0.0, high = 0.0;
};

struct StatedConditions {  // the table [conditions]
  struct {
    double temperature_C = 20.0;
    std::optional<double> frequency_Hz, load_kN, strain_percent, disp_mm;
    int first_cycle = 3, last_cycle = 3;
  } reference;
  struct {
    std::optional<ConditionRange> temperature_C, frequency_Hz, load_kN;
    bool full_rest = false;             // rest = "full": the device is as new
    std::optional<double> rest_h = {};  // or so many hours after the last motion
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
