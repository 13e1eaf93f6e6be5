// Chooses among the parts of a file (sheets, keys, structs) that each hold a table of their own.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

inline constexpr std::string_view accepted_formats = "delimited text, .xlsx, .mat or JSON";

// Text for messages, such as "sheets 'Test 1', 'Test 2'". Lists at most thirty names.
std::string sheet_list(std::vector<std::string> const& names, std::string_view what);

// Returns the index of the part that the user wants. `wanted` is a number from 1 or a name. Upper and lower case matter
// only if two names differ in nothing else. Messages call a part `what`. Throws Error if no part fits.
std::size_t choose_sheet(std::string const& wanted, std::vector<std::string> const& names, std::string const& file,
                         std::string_view what);

// The part's name if it is printable and unique, else its number.
std::string sheet_key(std::vector<std::string> const& names, std::size_t index);

}  // namespace isolaw::data
