// Reads the name of a column in the languages of laboratories: its words, its unit, and the channel that it names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/files/channel.hpp"

namespace isolaw::data {

// "Forza orizzontale [kN]" -> "Forza orizzontale" and "kN".
struct ColumnName {
  std::string base;
  std::string unit;  // as written; empty when the name holds none
};
ColumnName dissect_name(std::string_view name);

// The words of a name in lower case, without accents: "DispH_2" -> disp, h, 2. Japanese words are translated.
std::vector<std::string> name_words(std::string_view name);
bool is_japanese(std::string_view name);
// Whether a cell of a table's header is the name of a channel.
bool names_a_channel(std::string_view cell);

enum class Certainty { none, symbol, word };

// plain_load: a name with "load", but without "vertical" or "horizontal"; it may be either force.
struct Meaning {
  std::optional<Channel> channel;
  Certainty certainty = Certainty::none;
  bool plain_load = false;
  bool vertical_disp = false;  // the name of a vertical displacement, which is no channel of a shear test
};
Meaning meaning_of(std::string_view name);

bool is_counter(std::string_view name);
bool names_a_calendar(std::string_view name);
bool names_a_velocity(std::string_view name);

}  // namespace isolaw::data
