// Chooses among the parts of a file that each hold a table of their own (sheets, keys, structs).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

inline constexpr std::string_view accepted_formats = "delimited text, .xlsx, .mat or JSON";

// "sheets 'Test 1', 'Test 2'", the first thirty of them
std::string sheet_list(std::vector<std::string> const& names, std::string_view what);

// `wanted` is a name (in any case, if that is unique) or counts from 1; `what` is the word for a part. Throws Error.
std::size_t choose_sheet(std::string const& wanted, std::vector<std::string> const& names, std::string const& file,
                         std::string_view what);

// Its name if printable and unique, else its number.
std::string sheet_key(std::vector<std::string> const& names, std::size_t index);

}  // namespace isolaw::data
