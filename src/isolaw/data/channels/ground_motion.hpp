// Reads a ground acceleration history from a file of an agency (PEER, ESM, K-NET, CSMIP, SMC), or from text columns
// that name their units.
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
  std::optional<double> zero_mm_s2 = {};   // the mean that was subtracted from values as an instrument gave them
};

// Throws one Error with all problems: values, unequal time steps, not exactly one column of acceleration, missing
// samples. `step_s` gives the time step of a file without time; where the file states a step, it must be the same.
// A file of an agency may hold several components. `component`, from 1, chooses one of them; in a file's name it stands
// behind a #, as in FILE.V2#2.
GroundMotion read_ground_motion(std::filesystem::path const& file, std::optional<double> step_s = {});
GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name, std::optional<double> step_s = {},
                                     std::optional<std::size_t> component = {});

}  // namespace isolaw::data
