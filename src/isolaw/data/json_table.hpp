// Reads tables of numbers in JSON (RFC 8259): an object of arrays {"time": [..], "disp": [..]}, an array of objects
// [{"time": 0, "disp": 0}, ..], or an array of rows [[0, 0], ..]; at the top or under one key. Names may stand in a
// first row or beside the rows ("columns": [..]), units in names or beside them ("units": {..}, "disp unit": "mm").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Whether the bytes begin as such JSON does and as no text table would ("[Data]" is a line of text).
bool is_json(std::string_view bytes);

// The test under `key`, which is a name or a number from 1. Without `key` the first one that holds a table is read, and
// Tests::sheets names all that do. Throws Error: no JSON, nested deeper than 64, no table, no such key.
Tests json_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& key);

}  // namespace isolaw::data
