// The tests of a lot's devices under several conditions, as they were measured: the cycles of each block with their
// properties. A campaign keeps them, so that a report needs no records. The module `study` compares them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/campaign/lot_conditions.hpp"

namespace isolaw::campaign {

struct Lot;

struct ObservedCycle {
  int number = 0;  // number of the cycle within its block, from 1
  // A value of 0 or less means that the property is not defined for this cycle.
  double K_eff_kN_per_mm = 0.0, damping_percent = 0.0, energy_kN_mm = 0.0, Q_d_kN = 0.0, K_d_kN_per_mm = 0.0;
  std::optional<double> load_kN = {};  // mean vertical load, if the record has a channel for it
};

struct ObservedBlock {
  int number = 0;
  double amplitude_mm = 0.0;
  std::optional<double> frequency_Hz = {};  // empty if it is not known or not the same in all cycles
  std::string fault = {};                   // why no cycle counts, if a signal is impossible; else empty
  std::vector<ObservedCycle> cycles = {};   // the counted cycles
  // For drawing: at most 120 points of the loop of one cycle, which is the last of the reference cycles (`reference` in
  // StatedConditions) or, if that is missing, the last counted cycle before it.
  std::vector<double> loop_mm = {}, loop_kN = {};
};

struct ObservedTest {
  std::string device, test, file = {}, sha256 = {};
  std::string place = {};  // its table in the lot file, such as "lot.toml:38"; empty for a store of an earlier build
  StatedDevice of_device = {};
  std::optional<double> rubber_thickness_mm = {}, rubber_area_mm2 = {};
  StatedTest stated = {};
  std::string refusal = {};                // why the record cannot be used; later tests of the device still count
  std::vector<Finding> doubts = {};        // doubts about the record, as the command `inspect` reports them
  std::optional<double> farthest_mm = {};  // largest displacement from the record's centre; empty if unreadable
  std::vector<ObservedBlock> blocks = {};
};

// All tests of all devices, in the order in which each device was tested, and the table [conditions] of the lot file.
struct ObservedTests {
  StatedConditions stated;
  std::vector<ObservedTest> tests = {};
};

// Reads the records of a lot with a table [conditions]. If a test cannot be used, its `refusal` says why.
ObservedTests observe_tests(Lot const& lot);

// text() makes the text that a campaign's store holds, and tests_of_text() reads it. tests_of_text() throws Error or
// nlohmann::json::exception for any other text.
std::string text(ObservedTests const& observed);
ObservedTests tests_of_text(std::string_view text);

}  // namespace isolaw::campaign
