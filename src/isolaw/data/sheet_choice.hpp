// Chooses among the parts of a file that each hold a table of their own (sheets, keys, structs).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

// The formats that a reader accepts, for messages.
inline constexpr std::string_view accepted_formats = "delimited text, .xlsx, .mat or JSON";

// "sheets 'Test 1', 'Test 2'", the first thirty of them
std::string sheet_list(std::vector<std::string> const& names, std::string_view what);

// The position of the part that `wanted` names (in any case, if that is unique) or counts from 1. Throws Error. `what`
// is the word for a part: "sheet".
std::size_t choose_sheet(std::string const& wanted, std::vector<std::string> const& names, std::string const& file,
                         std::string_view what);

// The text by which --sheet and a lot file choose that part: its name if printable and unique, else its number.
std::string sheet_key(std::vector<std::string> const& names, std::size_t index);

}  // namespace isolaw::data
