// Which column is which channel, and in which unit: by the user's word, else by the names of the header in the
// languages laboratories write. What is not certain is asked for, with the option to type.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/data/header.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

inline constexpr Channel all_channels[] = {Channel::time, Channel::disp, Channel::force, Channel::load};

Dimension dimension(Channel channel);

// A column's name taken apart: "Forza orizzontale [kN]" -> "Forza orizzontale" and "kN".
struct ColumnName {
  std::string base;
  std::string unit;  // as written; empty when the name holds none
};
ColumnName dissect_name(std::string_view name);

// Whether a header cell looks like a time, displacement or force of any kind: tells a row of names from other lines.
bool names_a_channel(std::string_view cell);

struct Column {
  std::size_t index = 0;     // from 0
  std::optional<Unit> unit;  // empty when it is missing or wrong, which is among the complaints
};

struct Columns {
  std::map<Channel, Column> channels;
  std::vector<Complaint> complaints;
  std::vector<std::string> recognised;
  std::vector<std::string> warnings;
};

// `where` is the file as given. Never throws: problems are collected.
Columns recognise_columns(std::string const& where, Header const& header, Dialect const& dialect,
                          ReadOptions const& options);

// "column 2 'Force [kN]'"
std::string column_text(std::size_t index, Header const& header);

}  // namespace isolaw::data
