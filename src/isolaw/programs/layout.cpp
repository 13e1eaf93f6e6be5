#include "isolaw/programs/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::programs {
namespace {

struct LayoutColumn {
  std::vector<std::string_view> names;  // accepted headings; messages use the first one
  std::string units;                    // accepted units; "" if the column holds texts
  std::optional<double> (*in_ours)(std::string_view unit);
  void (*set)(LayoutRow& place, double value);
  bool required = false, above_zero = false;
};

std::optional<double> of(Dimension dimension, std::string_view text) {
  auto const unit = parse_unit(text);
  return unit && unit->dimension == dimension ? std::optional(unit->in_record_units) : std::nullopt;
}
std::optional<double> angle_in_deg(std::string_view text) {
  auto const small = lower(trimmed(text));
  if (small == "deg" || small == "degrees" || small == "\xC2\xB0") return 1.0;
  return small == "rad" ? std::optional(180.0 / std::numbers::pi) : std::nullopt;
}

std::vector<LayoutColumn> const& layout_columns() {
  static std::vector<LayoutColumn> const known{
      {.names = {"name", "bearing", "isolator", "id"}, .units = {}, .in_ours = nullptr, .set = nullptr},
      {.names = {"x"},
       .units = known_units(Dimension::length),
       .in_ours = length_in_mm,
       .set = [](LayoutRow& place, double value) { place.x_mm = value; },
       .required = true},
      {.names = {"y"},
       .units = known_units(Dimension::length),
       .in_ours = length_in_mm,
       .set = [](LayoutRow& place, double value) { place.y_mm = value; },
       .required = true},
      {.names = {"load", "vertical load", "weight", "n"},
       .units = known_units(Dimension::force),
       .in_ours = force_in_kN,
       .set = [](LayoutRow& place, double value) { place.load_kN = value; },
       .above_zero = true},
      {.names = {"K_v", "kv", "axial"},
       .units = "kN/mm, kN/m, N/m and the like",
       .in_ours = parse_stiffness,
       .set = [](LayoutRow& place, double value) { place.K_v_kN_per_mm = value; },
       .above_zero = true},
      {.names = {"angle", "orientation"},
       .units = "deg, rad",
       .in_ours = angle_in_deg,
       .set = [](LayoutRow& place, double value) { place.angle_deg = value; }}};
  return known;
}

// Splits a heading such as "load [kN]" or "load (kN)" into "load" and "kN".
std::pair<std::string_view, std::string_view> name_and_unit(std::string_view cell) {
  auto const open = cell.find_first_of("[(");
  if (open == std::string_view::npos) return {trimmed(cell), {}};
  auto const inside = cell.substr(open + 1);
  return {trimmed(cell.substr(0, open)), trimmed(inside.substr(0, inside.find_first_of("])")))};
}

std::string const columns_text =
    "columns x and y, and where they are known name, load, K_v and angle, with their units: 'name, x [m], y [m], load [kN]'";

struct FoundColumn {
  LayoutColumn const* column = nullptr;
  double unit = 1.0;
};

std::vector<FoundColumn> found_columns(std::vector<std::string_view> const& header, std::string const& where,
                                       std::vector<Complaint>& complaints) {
  std::vector<FoundColumn> columns;
  for (auto const cell : header) {
    auto const [base, unit] = name_and_unit(cell);
    auto const named = [wanted = lower(base)](LayoutColumn const& column) {
      return std::ranges::any_of(column.names, [&](auto name) { return lower(name) == wanted; });
    };
    auto const& known = layout_columns();
    auto const column = std::ranges::find_if(known, named);
    if (column == known.end()) {
      complaints.push_back(
          {.where = where, .found = fmt::format("column {}", data::in_quotes(cell)), .allowed = columns_text});
      columns.push_back({});
      continue;
    }
    if (std::ranges::find(columns, &*column, &FoundColumn::column) != columns.end())
      complaints.push_back(
          {.where = where, .found = fmt::format("column {} twice", column->names.front()), .allowed = "one of them"});
    FoundColumn one{.column = &*column};
    if (column->in_ours != nullptr) {
      auto const size = column->in_ours(unit);
      if (!size)
        complaints.push_back(
            {.where = where,
             .found = unit.empty() ? fmt::format("column {} has no unit", data::in_quotes(cell))
                                   : fmt::format("column {} is in {}", data::in_quotes(base), data::in_quotes(unit)),
             .allowed = fmt::format("'{} [UNIT]', the unit one of {}", column->names.front(), column->units)});
      one.unit = size.value_or(1.0);
    }
    columns.push_back(one);
  }
  for (auto const& column : layout_columns())
    if (column.required && std::ranges::find(columns, &column, &FoundColumn::column) == columns.end())
      complaints.push_back(
          {.where = where, .found = fmt::format("no column {}", column.names.front()), .allowed = columns_text});
  return columns;
}

// How the cells of a layout are written, and where its header is.
struct LayoutForm {
  std::size_t header = 0;  // index of the header among the lines
  char delimiter = ',', decimal = '.';
};

Error no_bearings(std::string const& name) {
  return Error({.where = name, .found = "no bearings", .allowed = "a row for each, under " + columns_text});
}

LayoutForm form_of(std::vector<std::string_view> const& lines, std::string const& name) {
  auto const says_something = [](auto line) { return !data::is_comment(line) && !trimmed(line).empty(); };
  auto const header = std::ranges::find_if(lines, says_something);
  if (header == lines.end() || std::ranges::none_of(header + 1, lines.end(), says_something)) throw no_bearings(name);
  // Recognises the delimiter from the header alone, since a table may have only one or two rows.
  auto const has = [&](char c) { return header->find(c) != std::string_view::npos; };
  char const delimiter = has(';') ? ';' : has('\t') ? '\t' : has(',') ? ',' : ' ';
  auto const dialect = data::recognise_dialect(lines);
  char const decimal = delimiter != ',' && dialect && dialect->decimal == ',' ? ',' : '.';
  return {static_cast<std::size_t>(header - lines.begin()), delimiter, decimal};
}

void read_place(std::vector<std::string_view> const& cells, std::vector<FoundColumn> const& columns, char decimal,
                std::string const& where, LayoutRow& place, std::vector<Complaint>& complaints) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    auto const& [column, unit] = columns[k];
    if (column->in_ours == nullptr) {
      if (!cells[k].empty()) place.name = data::to_utf8(cells[k]);
      continue;
    }
    auto const cell = data::parse_cell(cells[k], data::NumberFormat(decimal));
    bool const number = cell.kind == data::CellKind::number && std::isfinite(cell.value);
    if (number && !(column->above_zero && !(cell.value > 0.0)))
      column->set(place, cell.value * unit);
    else
      complaints.push_back({.where = where,
                            .found = fmt::format("{} is {}", column->names.front(),
                                                 cells[k].empty() ? std::string("missing") : data::in_quotes(cells[k])),
                            .allowed = column->above_zero ? "a number above 0" : "a finite number"});
  }
}

void check_together(std::vector<LayoutRow> const& places, std::string const& file, std::vector<Complaint>& complaints) {
  constexpr double apart_mm = 1.0;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      auto const &a = places[j], &b = places[i];
      if (a.name == b.name)
        complaints.push_back(
            {.where = file, .found = fmt::format("two bearings called {}", data::in_quotes(a.name)), .allowed = "one"});
      if (std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm) < apart_mm)
        complaints.push_back(
            {.where = file,
             .found = fmt::format("bearings {} and {} stand in one place, x = {:.6g} mm, y = {:.6g} mm",
                                  data::in_quotes(a.name), data::in_quotes(b.name), b.x_mm, b.y_mm),
             .allowed = fmt::format("bearings {} mm apart or more", apart_mm)});
    }
}

}  // namespace

std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return std::pair(value, trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

std::optional<double> length_in_mm(std::string_view unit) {
  return of(Dimension::length, unit);
}

std::optional<double> force_in_kN(std::string_view unit) {
  return of(Dimension::force, unit);
}

std::optional<double> parse_stiffness(std::string_view unit) {
  auto const slash = unit.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  auto const force = force_in_kN(unit.substr(0, slash)), length = length_in_mm(unit.substr(slash + 1));
  return force && length ? std::optional(*force / *length) : std::nullopt;
}

std::vector<LayoutRow> read_layout(std::filesystem::path const& file) {
  return read_layout_text(data::load_text(file), file.generic_string());
}

std::vector<LayoutRow> read_layout_text(std::string_view bytes, std::string const& name) {
  data::check_text(name, bytes);
  auto const lines = data::split_lines(bytes).lines;
  auto const form = form_of(lines, name);
  auto const place_of_line = [&](std::size_t line) { return fmt::format("{}:{}", name, line + 1); };
  std::vector<std::string_view> cells;
  data::split_cells(lines[form.header], form.delimiter, cells);
  std::vector<Complaint> complaints;
  auto const columns = found_columns(cells, place_of_line(form.header), complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));
  std::vector<LayoutRow> places;
  for (auto i = form.header + 1; i < lines.size(); ++i) {
    if (data::is_comment(lines[i]) || data::is_blank(lines[i], form.delimiter)) continue;
    data::split_cells(lines[i], form.delimiter, cells);
    if (cells.size() != columns.size()) {
      complaints.push_back({.where = place_of_line(i),
                            .found = counted(cells.size(), "cell"),
                            .allowed = fmt::format("{}, as the header has", columns.size())});
      continue;
    }
    LayoutRow place;
    place.name = fmt::format("b{}", places.size() + 1);
    read_place(cells, columns, form.decimal, place_of_line(i), place, complaints);
    places.push_back(std::move(place));
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  if (places.empty()) throw no_bearings(name);
  if (places.size() > most_rows)
    throw Error(
        {.where = name, .found = counted(places.size(), "bearing"), .allowed = fmt::format("1 to {}", most_rows)});
  check_together(places, name, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));
  return places;
}

}  // namespace isolaw::programs
