// The rows of study/results.hpp as members of a JSON object.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/results.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {

// all: numbers read back as the same doubles; shown: what is drawn, with the digits of the row.
enum class Digits { all, shown };

inline constexpr int shown_digits = 9;

void write_value(JsonWriter& out, Value const& value, std::optional<int> digits);
// Without digits: all of them.
void write_values(JsonWriter& out, std::span<double const> values, std::optional<int> digits = std::nullopt);

// Members of the open object, key after key, as they are shown: numbers with nine digits, null for what is undefined.
template <class T, class... Rest>
void write_members(JsonWriter& out, std::string_view key, T const& value, Rest const&... rest) {
  write_value(out.key(key), study::value_of(value), shown_digits);
  if constexpr (sizeof...(rest) > 0) write_members(out, rest...);
}

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

// Members of the open object for rows of which none is nested.
template <class Of, std::size_t count>
void write_results(JsonWriter& out, Result<Of> const (&rows)[count], Of const& of, Digits digits) {
  write_results(out, rows, of, digits, [](std::string_view) {});
}

void write_profile(JsonWriter& out, ParameterAnalysis const& analysis, std::optional<int> digits = std::nullopt);
void write_intervals(JsonWriter& out, DeviceFit const& fit);
void write_blocks(JsonWriter& out, std::vector<BlockScore> const& blocks, Digits digits);
void write_outliers(JsonWriter& out, std::vector<OutlyingDevice> const& outliers, Digits digits);

// "recommendations": of every purpose, laws by id.
void write_recommendations(JsonWriter& out, study::Summary const& summary,
                           std::vector<study::Recommendation> const& made);

// "published": the campaign beside the published study; null where too few of its laws are there.
void write_published(JsonWriter& out, study::Summary const& summary, Digits digits);

// An array under this key: one object for each sentence of the table (wording/table.hpp) with its kind, topic, severity,
// action, law, devices, parameters and blocks; `each` holds the fields of every finding that the sentence joins.
void write_findings(JsonWriter& out, std::string_view key, std::vector<Finding> const& findings,
                    unsigned place = wording::in_report);

}  // namespace isolaw::render
