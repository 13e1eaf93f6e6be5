// One table as CSV, cell by cell: RFC 4180, numbers with six significant digits.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/base/json.hpp"
#include "isolaw/render/tables/tables.hpp"

namespace isolaw::render {

class CsvTable {
 public:
  CsvTable& cell(std::string_view text) { return put(csv_cell(text)); }
  CsvTable& cell(std::optional<double> const& number) { return put(to_text(number, 6)); }
  CsvTable& cell(double number) { return cell(std::optional(number)); }
  CsvTable& cell(std::integral auto number) { return put(std::to_string(number)); }
  CsvTable& yes_no(bool flag) { return put(flag ? "yes" : "no"); }
  CsvTable& empty(int count) {
    for (int i = 0; i < count; ++i) put("");
    return *this;
  }
  void end_row() {
    text_ += "\r\n";
    at_start_ = true;
  }
  std::string take() { return std::move(text_); }

 private:
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
