// Builds the text of a CSV table (RFC 4180) cell by cell. Numbers have six significant digits. Columns that are made
// from rows of results show their values in the units of the table.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::render {

class CsvTable {
 public:
  explicit CsvTable(UnitSystem const& units = record_units) : units_(units) {}
  // Adds the cells of each value: a Statistic has three (mean, std, best), Ends has two (lower, upper), any other value
  // one. The cell of an undefined value is empty.
  template <class... Of>
  CsvTable& add(Of const&... cells) {
    (put(study::value_of(cells)), ...);
    return *this;
  }
  template <class... Of>
  void row(Of const&... cells) {
    add(cells...).end_row();
  }
  template <class Of, std::size_t count>
  CsvTable& head(std::array<Result<Of>, count> const& columns) {
    for (auto const& column : columns)
      for (auto heading : study::headings(column)) {
        heading.unit = shown_unit(heading.unit, units_).unit;
        add(heading.text());
      }
    return *this;
  }
  // Adds the cells of an object, one or more for each column. `unit` is the unit of this row in columns whose unit
  // differs from row to row.
  template <class Of, std::size_t count>
  CsvTable& cells(std::array<Result<Of>, count> const& columns, Of const& object, std::string_view unit = {}) {
    for (auto const& column : columns) {
      auto const shown = shown_unit(column.unit == study::own_unit ? unit : column.unit, units_);
      if (column.key == "unit")
        put(shown_unit(unit, units_).unit);
      else
        put(column.value(object), shown.factor);
    }
    return *this;
  }
  CsvTable& empty(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) put(Value());
    return *this;
  }
  void end_row() {
    text_ += "\r\n";
    at_start_ = true;
  }
  std::string take() { return std::move(text_); }

 private:
  void put(Value const& value, double factor = 1.0);

  UnitSystem const& units_;
  std::string text_;
  bool at_start_ = true;
};

}  // namespace isolaw::render
