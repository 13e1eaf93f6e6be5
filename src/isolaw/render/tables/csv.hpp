// One table as CSV, cell by cell: RFC 4180, numbers with six significant digits.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/base/json.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::render {

class CsvTable {
 public:
  CsvTable& cell(std::string_view text) { return put(csv_cell(text)); }
  CsvTable& cell(std::optional<double> const& number) { return put(to_text(number, 6)); }
  CsvTable& cell(double number) { return cell(std::optional(number)); }
  CsvTable& cell(std::integral auto number) { return put(std::to_string(number)); }
  CsvTable& yes_no(bool flag) { return put(flag ? "yes" : "no"); }
  CsvTable& value(Value const& value);  // a statistic takes three cells, the ends of a range two
  // The headings of rows of study/results.hpp, and an object's cells under them.
  template <class Of, std::size_t count>
  CsvTable& head(std::array<Result<Of>, count> const& columns) {
    for (auto const& column : columns) {
      if constexpr (std::default_initializable<Of>)
        head(column.heading, column.unit, column.of(Of{}));
      else
        head(column.heading, column.unit, {});
    }
    return *this;
  }
  template <class Of, std::size_t count>
  CsvTable& cells(std::array<Result<Of>, count> const& columns, Of const& of) {
    for (auto const& column : columns) value(column.of(of));
    return *this;
  }
  CsvTable& empty(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) put("");
    return *this;
  }
  void end_row() {
    text_ += "\r\n";
    at_start_ = true;
  }
  std::string take() { return std::move(text_); }

 private:
  void head(std::string_view heading, std::string_view unit, Value const& of_kind);
  CsvTable& put(std::string_view cell) {
    if (!at_start_) text_ += ',';
    at_start_ = false;
    text_ += cell;
    return *this;
  }

  std::string text_;
  bool at_start_ = true;
};

}  // namespace isolaw::render
