// Reads the isolators of a building, with positions and loads, from a text table whose header gives the units.
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
  double angle_deg = 0.0;  // in plan, from the x axis to the first axis of the bearing
  std::optional<double> load_kN, K_v_kN_per_mm;
};

inline constexpr std::size_t most_rows = 2000;

// Reads the table. Throws one Error that lists all wrong columns and units. If these are right, it lists all wrong or
// missing values, and if these are right too, all bearings that share a name or stand less than 1 mm apart.
std::vector<LayoutRow> read_layout(std::filesystem::path const& file);
std::vector<LayoutRow> read_layout_text(std::string_view bytes, std::string const& name);

// Splits "2400 kN" into 2400 and "kN". Returns nullopt if the text does not begin with a finite number.
std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text);
// Return how many mm, kN or kN/mm a unit of length, force or stiffness is; for "kN/m" this is 0.001. nullopt for any
// other text.
std::optional<double> length_in_mm(std::string_view unit);
std::optional<double> force_in_kN(std::string_view unit);
std::optional<double> parse_stiffness(std::string_view unit);

}  // namespace isolaw::programs
