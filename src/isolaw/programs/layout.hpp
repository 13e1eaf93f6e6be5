// Reads a building's isolators, their places and loads, from a text table whose header names the units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::programs {

struct LayoutRow {
  std::string name;
  double x_mm = 0.0, y_mm = 0.0;
  double angle_deg = 0.0;  // in plan, from the axis x to the bearing's own first axis
  std::optional<double> load_kN, K_v_kN_per_mm;
};

inline constexpr std::size_t most_rows = 2000;

// Throws one Error that lists all faults: columns, units, values, loads for only some bearings, two bearings with the
// same name or at the same place.
std::vector<LayoutRow> read_layout(std::filesystem::path const& file);
std::vector<LayoutRow> read_layout_text(std::string_view bytes, std::string const& name);

// "2400 kN" gives 2400 and "kN"; nullopt if the text does not begin with a finite number.
std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text);
// "kN/m" gives 0.001 (in kN/mm).
std::optional<double> parse_stiffness(std::string_view unit);

}  // namespace isolaw::programs
