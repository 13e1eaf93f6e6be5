// The vertical stiffness of a device from its compression test: K_v = F_v/d_v (NTC 2018, 11.9.7). It is the slope of
// the secant between two loads of one loading, so the settling of joints below the lower load and the zero of
// displacement have no effect. A test loads three times. The third loading is used, from 30 % to 100 % of its largest
// load, as EN 15129 and ISO 22762-1 are commonly applied (neither text was at hand). VerticalTest::loads can give
// another range, such as 0.7 to 1.3 times the design load.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"

namespace isolaw::data {

struct LoadRange {
  double low_kN = 0.0, high_kN = 0.0;
  bool operator==(LoadRange const&) const = default;
};
// Parses a range of loads in kN, such as "300:1000". Throws Error on anything else.
LoadRange parse_loads(std::string_view text);
std::string loads_text(LoadRange const& range);

// A compression test: its record, or only its stiffness as stated by the user.
struct VerticalTest {
  std::string file, sha256;
  std::vector<double> disp_mm = {}, load_kN = {};  // as recorded; the sign is arbitrary
  std::optional<LoadRange> loads = {};             // range for the stiffness; nullopt: the usual one
  std::optional<double> stated_kN_per_mm = {};     // stiffness stated by the user, without a record
  std::vector<Finding> recognised = {};            // choices made when the record was read
  std::string refusal = {};                        // why the record gives no stiffness; empty if it does
  // The stiffness found when the record was read, and the hash of both signals. A check of a stored campaign computes
  // both again and compares.
  std::optional<double> found_kN_per_mm = {};
  std::string curve_sha256 = {};

  bool is_given() const { return !file.empty() || stated_kN_per_mm; }
  bool operator==(VerticalTest const&) const = default;
};

struct VerticalStiffness {
  double K_v_kN_per_mm = 0.0;
  std::string description;  // how K_v was found, in one sentence
  // The members below are only set if there is a record.
  std::optional<LoadRange> loads = {};                        // the range used, positive in compression
  std::optional<double> disp_low_mm = {}, disp_high_mm = {};  // displacement at the ends of the range
  std::optional<int> loading = {};                            // the loading used, from 1
  std::vector<double> loadings_kN_per_mm = {};                // K_v of every loading that reaches the largest load
  std::vector<std::string> reversed_signals = {};             // signals whose sign was turned
  std::vector<Finding> warnings = {};
};

std::string curve_hash(VerticalTest const& test);

// Throws Error if a signal is faulty, no loading covers the range, or displacement does not follow the load.
VerticalStiffness vertical_stiffness(VerticalTest const& test);

}  // namespace isolaw::data
