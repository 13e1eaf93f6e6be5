// The vertical stiffness of a device from its compression test: K_v = F_v/d_v (NTC 2018, 11.9.7), as the secant of one
// loading between two loads. The settling of joints below the lower load and the zero of the displacement then do not
// count. A test loads three times and the third loading counts, from 30 % to 100 % of its largest load, as EN 15129 and
// ISO 22762-1 are commonly applied (neither text was at hand). `loads` gives another range, such as 0.7 to 1.3 of the
// design load.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/read.hpp"

namespace isolaw::data {

struct LoadRange {
  double low_kN = 0.0, high_kN = 0.0;
  bool operator==(LoadRange const&) const = default;
};
// Parses "300:1000", in kN; throws Error on anything else.
LoadRange parse_loads(std::string_view text);
std::string loads_text(LoadRange const& range);

// A record, or the stiffness alone.
struct VerticalTest {
  std::string file, sha256;
  std::vector<double> disp_mm = {}, load_kN = {};  // as recorded, whatever their signs
  std::optional<LoadRange> loads = {};             // the loads between which the stiffness is taken
  std::optional<double> stated_kN_per_mm = {};     // the stiffness alone, without a record
  std::vector<Finding> recognised = {};            // each decision in reading
  std::string refusal = {};                        // why the record gives no stiffness, or empty
  // The stiffness when the record was read, and the hash of both signals: a store is checked against them.
  std::optional<double> found_kN_per_mm = {};
  std::string curve_sha256 = {};

  bool given() const { return !file.empty() || stated_kN_per_mm; }
  bool operator==(VerticalTest const&) const = default;
};

struct VerticalStiffness {
  double K_v_kN_per_mm = 0.0;
  std::string how;  // in one sentence
  // Only with a record.
  std::optional<LoadRange> loads = {};                        // the range, as positive compression
  std::optional<double> disp_low_mm = {}, disp_high_mm = {};  // displacement at these loads
  std::optional<int> loading = {};                            // which loading counts, from 1
  std::vector<double> loadings_kN_per_mm = {};                // every loading that reaches the largest load
  std::vector<std::string> turned = {};                       // signals read with the other sign
  std::vector<Finding> warnings = {};
};

VerticalTest read_vertical(std::filesystem::path const& file, ReadOptions const& options,
                           std::optional<LoadRange> const& loads);
std::string curve_hash(VerticalTest const& test);

// Throws Error if a signal is faulty, no loading holds both loads, or displacement does not follow the load.
VerticalStiffness vertical_stiffness(VerticalTest const& test);

}  // namespace isolaw::data
