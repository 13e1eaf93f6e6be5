// Reads tables of numbers in JSON (RFC 8259): an object of arrays {"time": [..], "disp": [..]}, an array of objects
// [{"time": 0, "disp": 0}, ..], or an array of rows [[0, 0], ..]; at the top or under one key. Names may be in a first
// row or beside the rows ("columns": [..]), units in names or beside them ("units": {..}, "disp unit": "mm").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// False for "[Data]", which begins a text table.
bool is_json(std::string_view bytes);

// `key` is a name or a number from 1; without it the first table is read, and Tests::sheets names all. Throws Error.
Tests json_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& key);

}  // namespace isolaw::data
