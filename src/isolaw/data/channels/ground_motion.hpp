// Reads a ground acceleration history from a file of an agency (PEER, ESM, K-NET, CSMIP, SMC), or from text columns
// that name their units.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/option.hpp"

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
  std::optional<double> zero_mm_s2 = {};   // mean of uncorrected values (the instrument's zero), which was subtracted
};

// The time step and the unit of acceleration that the user states for a file which does not state them. If the file
// states them too, both must agree.
struct StatedMotion {
  std::optional<double> step_s = {};
  std::optional<std::string> unit = {};
  // Texts for messages: the options or keys by which the user can state the step and the unit, and the place of these
  // keys, such as " in its [[motion]]". Empty if the user cannot state them.
  std::string_view how_step = {}, how_unit = {}, where = {};
};

// Makes the two options that set the time step and the unit. `place` returns the StatedMotion that a Target holds.
template <class Target, class Access>
std::array<Option<Target>, 2> stated_options(std::string_view step_key, std::string_view unit_key, Access place) {
  return {number<Target>(step_key, "time step in seconds, for motions whose files do not state it",
                         [place](auto& from) -> auto& { return place(from).step_s; }, {.least = 1e-6, .most = 10.0})
              .under(Heading::everyday),
          {{.key = unit_key,
            .help = "unit of the acceleration, for motions whose files do not state it: " +
                    std::string(known_accelerations),
            .heading = Heading::everyday},
           [place](Target const& from) { return or_null(place(from).unit); },
           [place](Target& to, Json const& value) {
             if (!parse_acceleration(text_in(value))) refuse(value, std::string(known_accelerations));
             place(to).unit = text_in(value);
           }}};
}

// Reads an acceleration history. A file of an agency may hold several components. `component`, from 1, chooses one of
// them; in a file's name it stands behind a #, as in FILE.V2#2. A file without a header may have two columns, time in s
// and acceleration, if `stated` has the unit. It may have one column of accelerations if `stated` has the step too. The
// first of two columns without a header is the time if its steps are equal or if `stated` has the step. Throws Error
// for values that are no numbers, unequal time steps, no or several columns of acceleration, or missing samples.
GroundMotion read_ground_motion(std::filesystem::path const& file, StatedMotion const& stated = {});
GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name, StatedMotion const& stated = {},
                                     std::optional<std::size_t> component = {});

}  // namespace isolaw::data
