// Reads a ground acceleration history from a PEER database file (AT2), or from text columns that name their units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

inline constexpr double gravity_mm_s2 = 9806.65;

// The size in mm/s2 of the unit of acceleration that the text names: "g", "gal", "m/s2", "cm/s^2", "in/sec2". Brackets
// and blanks are ignored.
std::optional<double> parse_acceleration(std::string_view unit);
inline constexpr std::string_view known_accelerations = "g, gal, mm/s2, cm/s2, m/s2, in/s2";

struct GroundMotion {
  std::string file;
  double step_s = 0.0;
  std::vector<double> acceleration_mm_s2;  // the first value is at time 0
  std::string recognised;                  // one sentence on how the file was read
};

// Throws one Error with all problems: values, unequal time steps, not exactly one column of acceleration, missing
// samples. `step_s` gives the time step of a file without time; for a PEER file it must equal the file's step.
GroundMotion read_ground_motion(std::filesystem::path const& file, std::optional<double> step_s = {});
GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name,
                                     std::optional<double> step_s = {});

}  // namespace isolaw::data
