// Reads tables of numbers in JSON (RFC 8259): an object of arrays {"time": [..], "disp": [..]}, an array of objects
// [{"time": 0, "disp": 0}, ..], or an array of rows [[0, 0], ..], at the top or under a key. Column names are keys, a
// first row, or a list "columns": [..] beside the rows. Units are in the names, "units": {..} or "disp unit": "mm".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

// Whether the bytes begin like JSON. Returns false for "[Data]", with which text files may begin.
bool is_json(std::string_view bytes);

// `key` is a table's key or its number from 1. Without it, reads the first table and lists all tables in Tests::sheets.
// Throws Error.
Tests json_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& key);

}  // namespace isolaw::data
