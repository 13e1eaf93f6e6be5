#include "isolaw/render/tables/csv.hpp"

#include <algorithm>

#include "isolaw/base/json.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::render {
namespace {

struct Cells {
  double factor;  // converts numbers to the table's units

  std::string number(std::optional<double> const& value) const {
    return to_text(value ? std::optional(factor * *value) : value, 6);
  }
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(bool flag) const { return flag ? "yes" : "no"; }
  std::string operator()(std::integral auto number) const { return std::to_string(number); }
  std::string operator()(double value) const { return number(value); }
  std::string operator()(std::string_view text) const { return csv_cell(text); }
  std::string operator()(std::vector<std::string> const* texts) const {
    return csv_cell(wording::enumerate(*texts, 99));
  }
  std::string operator()(Statistic const& statistic) const {
    return number(statistic.mean) + ',' + number(statistic.std) + ',' + number(statistic.best);
  }
  std::string operator()(Ends const& ends) const { return number(ends.lower) + ',' + number(ends.upper); }
  std::string operator()(study::Nested) const { return {}; }
};

}  // namespace

std::string csv_cell(std::string_view text) {
  std::string cell;
  bool const starts_formula =
      text.size() > 1 && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  // A text that is only a number, with or without a unit, is no formula, for example "-20 C".
  auto const unit = text.substr(std::min(text.find(' '), text.size()));
  bool const is_measure = number_in<double>(text.substr(0, text.size() - unit.size())).has_value() &&
                          std::ranges::all_of(unit, [](char c) { return c == ' ' || is_letter(c); });
  if (starts_formula && !is_measure) cell += '\'';
  cell += text;
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (char const c : cell) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

void CsvTable::put(Value const& value, double factor) {
  if (!at_start_) text_ += ',';
  at_start_ = false;
  text_ += std::visit(Cells{factor}, value);
}

}  // namespace isolaw::render
