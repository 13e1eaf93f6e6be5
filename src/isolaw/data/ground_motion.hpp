// Reads the ground's acceleration over time, the load of an analysis: from a file of the PEER database (AT2), or from
// columns of text that name their units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

inline constexpr double gravity_mm_s2 = 9806.65;

// One of this unit in mm/s2: "g", "gal", "m/s2", "cm/s^2", "in/sec2"; brackets and blanks ignored. nullopt when
// unknown.
std::optional<double> parse_acceleration(std::string_view unit);
inline constexpr std::string_view known_accelerations = "g, gal, mm/s2, cm/s2, m/s2, in/s2";

struct GroundMotion {
  std::string file;
  double step_s = 0.0;
  std::vector<double> acceleration_mm_s2;  // the first at time 0
  std::string recognised;                  // in one sentence, how it was read
};

// Throws one Error with all that is wrong: values that are no numbers, times that are not equally spaced, no column
// with a unit of acceleration or several, fewer samples than the file says. `step_s` is for a file without time, and
// must not contradict the file.
GroundMotion read_ground_motion(std::filesystem::path const& file, std::optional<double> step_s = {});
// The same for a file's bytes; messages call the file `name`.
GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name,
                                     std::optional<double> step_s = {});

}  // namespace isolaw::data
