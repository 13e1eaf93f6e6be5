// Reads the name of a column in the languages of laboratories: its words, its unit, and the channel that it names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/files/channel.hpp"

namespace isolaw::data {

// The name "Forza orizzontale [kN]" has the base "Forza orizzontale" and the unit "kN".
struct ColumnName {
  std::string base;
  std::string unit;  // as written; empty if the name has no unit
};
ColumnName dissect_name(std::string_view name);

// The words of a name in lower case, without accents: "DispH_2" -> disp, h, 2. Words in Japanese, Chinese,
// Korean and Russian are translated.
std::vector<std::string> name_words(std::string_view name);
bool is_translated(std::string_view name);  // has words in Japanese, Chinese, Korean or Russian
bool names_a_channel(std::string_view cell);

enum class Certainty { none, symbol, word };

// `plain_load` marks a name with "load" but without "vertical" or "horizontal", which may mean the horizontal force or
// the vertical load.
struct Meaning {
  std::optional<Channel> channel;
  Certainty certainty = Certainty::none;
  bool plain_load = false;
  bool vertical_disp = false;  // the name means vertical displacement, which is no channel of a shear test
};
Meaning meaning_of(std::string_view name);

bool is_counter(std::string_view name);
bool names_a_calendar(std::string_view name);
bool names_a_velocity(std::string_view name);

}  // namespace isolaw::data
