// Implements `isolaw keywords`, which prints tables of options as keyword parameters of Python functions. `./isolaw.sh
// docs` copies the output into the stub file of the Python package.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "isolaw/app/commands.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/campaign/lot_conditions.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/programs/model.hpp"

namespace isolaw::app {
namespace {

std::string python_literal(Json const& value) {
  if (value.is_null()) return "None";
  if (value.is_boolean()) return value.get<bool>() ? "True" : "False";
  if (value.is_array() && value.empty()) return "()";
  return value.dump();
}

// Returns a parameter as Python text: "runs: int | None = None,". With `in_place` every default is None, which means
// that the value in a file, such as the building file, applies.
template <class Row>
std::string keyword(Row const& row, bool in_place = false) {
  auto value = in_place ? Json() : row.get({});
  // If the default is 0 although the limits forbid 0, other settings decide the value. The default in Python is then
  // None.
  if (row.limits && value == 0 && row.limits->least > 0.0) value = Json();
  auto type = row.python_type();
  if (value.is_null() && !type.ends_with(" | None")) type += " | None";
  return fmt::format("{}: {} = {},", row.python(), type, python_literal(value));
}

}  // namespace

int list_keywords(std::vector<std::string> const& which, std::vector<std::string> const& but) {
  auto const is_in = [](std::vector<std::string> const& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
  };
  std::vector<std::string> known{"settings", "acceptance", "reading", "motion", "building", "device-test", "export"},
      lines;
  auto const add = [&](auto const& row, bool asked) {
    known.push_back(row.python());
    if ((asked || is_in(which, known.back())) && !is_in(but, known.back())) lines.push_back(keyword(row));
  };
  for (auto const& row : campaign::setting_table())
    if (!row.stored_only) add(row, is_in(which, "settings"));
  for (auto const& row : campaign::acceptance_table()) add(row, is_in(which, "acceptance"));
  for (auto const& row : data::reading_table())
    add(row, is_in(which, "reading") || (!row.of_test && is_in(which, "motion")));
  auto const add_in_place = [&](auto const& rows, std::string_view group) {
    for (auto const& row : rows) {
      known.push_back(row.python());
      if (is_in(which, group) && !is_in(but, known.back())) lines.push_back(keyword(row, true));
    }
  };
  add_in_place(building::settings_table(), "building");
  add_in_place(building::stated_table(), "building");
  add_in_place(data::reading_table(), "device-test");
  add_in_place(campaign::test_table(), "device-test");
  add_in_place(campaign::acceptance_table(), "export");
  add_in_place(building::stated_table(), "export");
  add_in_place(programs::model_table(), "export");
  std::vector<Complaint> complaints;
  for (auto const* words : {&which, &but})
    for (auto const& word : *words)
      if (!is_in(known, word))
        complaints.push_back({.where = word, .found = "no such table or keyword", .allowed = joined(known)});
  if (!complaints.empty()) throw Error(std::move(complaints));
  for (auto const& line : lines) fmt::print("{}\n", line);
  return exit_done;
}

}  // namespace isolaw::app
