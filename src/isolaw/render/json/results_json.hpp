// The rows of study/results.hpp as members of a JSON object.
#pragma once

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::render {

// all: numbers read back as the same doubles; shown: what is drawn, with the digits of the row.
enum class Digits { all, shown };

void write_value(JsonWriter& out, Value const& value, std::optional<int> digits);

// `nested` writes the objects and arrays that a row leaves to it; it is given the key, which is written already.
template <class Of, std::size_t count, class Nested>
void write_results(JsonWriter& out, Result<Of> const (&rows)[count], Of const& of, Digits digits,
                   Nested const& nested) {
  for (auto const& row : rows) {
    out.key(row.key);
    auto const value = row.of(of);
    if (std::holds_alternative<study::Nested>(value))
      nested(row.key);
    else
      write_value(out, value, digits == Digits::all ? std::nullopt : std::optional(row.digits));
  }
}

void write_intervals(JsonWriter& out, DeviceFit const& fit);
void write_blocks(JsonWriter& out, std::vector<BlockScore> const& blocks, Digits digits);

}  // namespace isolaw::render
