#include "isolaw/render/tables/csv.hpp"

#include "isolaw/base/words.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

struct Cells {
  CsvTable& table;

  void operator()(std::monostate) const { table.empty(1); }
  void operator()(bool flag) const { table.yes_no(flag); }
  void operator()(std::vector<std::string> const* texts) const { table.cell(enumerate(*texts, 99)); }
  void operator()(Statistic const& of) const { table.cell(of.mean).cell(of.std).cell(of.best); }
  void operator()(Ends const& of) const { table.cell(of.lower).cell(of.upper); }
  void operator()(study::Nested) const {}
  void operator()(auto const& value) const { table.cell(value); }
};

}  // namespace

std::string csv_cell(std::string_view text) {
  std::string cell;
  bool const starts_formula =
      text.size() > 1 && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  if (starts_formula && !number_in<double>(text)) cell += '\'';
  cell += text;
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (char const c : cell) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

CsvTable& CsvTable::value(Value const& value) {
  std::visit(Cells{*this}, value);
  return *this;
}

void CsvTable::head(std::string_view heading, std::string_view unit, Value const& of_kind) {
  auto const name = std::string(heading);
  auto const in_unit = unit.empty() || unit == own_unit ? std::string() : " [" + std::string(unit) + "]";
  if (std::holds_alternative<Statistic>(of_kind))
    for (auto const* what : {"mean ", "std ", "best "}) cell(what + name + in_unit);
  else if (std::holds_alternative<Ends>(of_kind))
    for (auto const* which : {" lower", " upper"}) cell(name + which + in_unit);
  else
    cell(name + in_unit);
}

}  // namespace isolaw::render
