// Where the isolators of a building stand and what each carries: a table of text with a header that names its units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::programs {

struct Place {
  std::string name;
  double x_mm = 0.0, y_mm = 0.0;
  double angle_deg = 0.0;  // from the axis x to the bearing's own first axis, in plan
  std::optional<double> load_kN, K_v_kN_per_mm;
};

inline constexpr std::size_t most_places = 2000;

// Throws one Error of all that is wrong: no rows, a column that is unknown, missing or without its unit, values that
// are no finite numbers, loads and stiffnesses that are not above zero, loads that are given for some bearings only,
// two bearings of one name or in one place.
std::vector<Place> read_layout(std::filesystem::path const& file);
std::vector<Place> read_layout_text(std::string_view bytes, std::string const& name);

// A number and what stands behind it, "2400 kN": nullopt where no finite number comes first.
std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text);
// One of this unit in kN/mm, "kN/m"; nullopt where it is none of a stiffness.
std::optional<double> parse_stiffness(std::string_view unit);

}  // namespace isolaw::programs
