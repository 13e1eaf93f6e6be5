// Text of files that others wrote, before it reaches a terminal, a message or a table: control characters could move
// the cursor, forge lines or reorder what is read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isolaw {

// Length of the UTF-8 sequence at the start of `bytes`, which is not empty; 0 when it is none.
std::size_t utf8_length(std::string_view bytes);

// UTF-8 without control characters, line and paragraph separators, and marks that turn the direction of writing.
bool is_printable(std::string_view text);

// What is not printable is spelled out: \n, \x1b, \u202e. Printable text comes back as it is; `keep_lines` keeps \n
// too.
std::string printable(std::string_view text, bool keep_lines = false);

// The same of several lines that become one: "a; b".
std::string on_one_line(std::string_view text);

// 'text' for a message, cut to a readable length, control characters spelled out.
std::string in_quotes(std::string_view text);

}  // namespace isolaw
