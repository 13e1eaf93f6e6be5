// What the name of a column says of it, in the languages laboratories write: its words, its unit, the channel it means.
#pragma once

#include <optional>
#include <string_view>

#include "isolaw/data/columns.hpp"

namespace isolaw::data {

enum class Certainty { none, symbol, word };

// What a name says. `load` without "vertical" or "horizontal" beside it may be either force.
struct Meaning {
  std::optional<Channel> channel;
  Certainty certainty = Certainty::none;
  bool plain_load = false;
  bool vertical_disp = false;  // of which no channel of a shear test is
};
Meaning meaning_of(std::string_view name);

// Whether it counts samples.
bool is_counter(std::string_view name);
// Whether it may stand above dates.
bool names_a_date(std::string_view name);
bool names_a_velocity(std::string_view name);

}  // namespace isolaw::data
