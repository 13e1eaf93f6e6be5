// Writes results as members of a JSON object. For each result a row in study/results.hpp says its key, its unit and how
// its value is obtained.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/results.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {

// Says how many digits numbers get. `all`: so many that reading them gives the same double again. `shown`: as many as
// the row of the result in study/results.hpp says, which is enough for plots.
enum class Digits { all, shown };

inline constexpr int shown_digits = 9;

void write_value(JsonWriter& out, Value const& value, std::optional<int> digits);
// Writes numbers with `digits` significant digits, or with all digits if `digits` is empty.
void write_values(JsonWriter& out, std::span<double const> values, std::optional<int> digits = std::nullopt);

// Writes pairs of key and value into the open object. Numbers get nine digits, undefined values become null.
template <class T, class... Rest>
void write_members(JsonWriter& out, std::string_view key, T const& value, Rest const&... rest) {
  write_value(out.key(key), study::value_of(value), shown_digits);
  if constexpr (sizeof...(rest) > 0) write_members(out, rest...);
}

// Writes the key and the value of every row. If the value is itself an object or an array, the function `nested` writes
// it.
template <class Object, std::size_t count, class Nested>
void write_results(JsonWriter& out, Result<Object> const (&rows)[count], Object const& object, Digits digits,
                   Nested const& nested) {
  for (auto const& row : rows) {
    out.key(row.key);
    auto const value = row.value(object);
    if (std::holds_alternative<study::Nested>(value))
      nested(row.key);
    else
      write_value(out, value, digits == Digits::all ? std::nullopt : std::optional(row.digits));
  }
}

template <class Object, std::size_t count>
void write_results(JsonWriter& out, Result<Object> const (&rows)[count], Object const& object, Digits digits) {
  write_results(out, rows, object, digits, [](std::string_view) {});
}

// Writes an array with an object for each item. This object has one member for each row.
template <class Object, std::size_t count, class Items>
void write_rows(JsonWriter& out, Result<Object> const (&rows)[count], Items const& items, Digits digits) {
  out.objects(items, [&](Object const& item) { write_results(out, rows, item, digits); });
}

void write_profile(JsonWriter& out, ParameterAnalysis const& analysis, std::optional<int> digits = std::nullopt);
void write_settings(JsonWriter& out, study::Summary const& summary);

// JSON files hold sentences in kN and mm. The page's data hold them in every system of units, since the page offers the
// reader all of them.
using UnitSystems = std::span<UnitSystem const>;
inline constexpr UnitSystems stored_units(unit_systems.data(), 1);
// Writes a text that may depend on the units. `say` returns the text for a system of units. If all texts are equal, it
// writes one text, otherwise {"said": [...]} with a text for each system.
template <class Say>
void write_said(JsonWriter& out, UnitSystems systems, Say const& say) {
  std::vector<std::string> texts;
  for (auto const& units : systems) texts.push_back(say(units));
  if (std::ranges::adjacent_find(texts, std::not_equal_to()) == texts.end())
    out.value(texts.front());
  else
    out.object([&] { out.member("said", texts); });
}
// Writes an array with one text for each finding.
void write_remarks(JsonWriter& out, std::vector<Finding> const& findings, UnitSystems systems = stored_units);

void write_recommendation(JsonWriter& out, study::Summary const& summary,
                          std::optional<study::Recommendation> const& recommendation,
                          UnitSystems systems = stored_units);
// Writes the member "published", which compares the campaign with the published study. It is null if the campaign has
// too few of the study's laws.
void write_published(JsonWriter& out, study::Summary const& summary, Digits digits);
// Writes an array with one object for each sentence. One sentence may join several findings of a kind. The object has
// the sentence, its kind, topic, severity and action, whether it is on the certificate, and its laws, devices,
// parameters and blocks. Its array `each` has one object for each joined finding, with the devices, parameters, blocks
// and numbers of that finding.
void write_findings(JsonWriter& out, std::string_view key, std::vector<Finding> const& findings,
                    unsigned place = wording::in_report, UnitSystems systems = stored_units);

}  // namespace isolaw::render
