#include "isolaw/data/files/device_facts.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

struct Label {
  std::string_view key, words;  // in lower case, without accents, with one blank between words
};
// Labels in Japanese are not listed, because name_words() translates them into the English labels.
constexpr std::array labels{Label{"serial", "serial"},
                            Label{"serial", "serial no"},
                            Label{"serial", "serial number"},
                            Label{"serial", "serial nr"},
                            Label{"serial", "s n"},
                            Label{"serial", "sn"},
                            Label{"serial", "device"},
                            Label{"serial", "device id"},
                            Label{"serial", "device no"},
                            Label{"serial", "bearing"},
                            Label{"serial", "bearing no"},
                            Label{"serial", "bearing id"},
                            Label{"serial", "isolator"},
                            Label{"serial", "isolator no"},
                            Label{"serial", "isolator id"},
                            Label{"serial", "specimen"},
                            Label{"serial", "specimen id"},
                            Label{"serial", "specimen no"},
                            Label{"serial", "specimen name"},
                            Label{"serial", "sample id"},
                            Label{"serial", "sample name"},
                            Label{"serial", "seriennummer"},
                            Label{"serial", "serien nr"},
                            Label{"serial", "serien nummer"},
                            Label{"serial", "pruefling"},
                            Label{"serial", "prufling"},
                            Label{"serial", "prufling nr"},
                            Label{"serial", "probe"},
                            Label{"serial", "proben nr"},
                            Label{"serial", "matricola"},
                            Label{"serial", "numero di serie"},
                            Label{"serial", "n serie"},
                            Label{"serial", "provino"},
                            Label{"serial", "campione"},
                            Label{"serial", "dispositivo"},
                            Label{"serial", "isolatore"},
                            Label{"serial", "numero de serie"},
                            Label{"serial", "no de serie"},
                            Label{"serial", "seri no"},
                            Label{"serial", "numune"},
                            Label{"serial", "numune no"},
                            Label{"serial", "izolator"},
                            Label{"serial", "izolator no"},
                            Label{"lot", "lot"},
                            Label{"lot", "lot no"},
                            Label{"lot", "lot number"},
                            Label{"lot", "batch"},
                            Label{"lot", "batch no"},
                            Label{"lot", "los"},
                            Label{"lot", "los nr"},
                            Label{"lot", "chargennummer"},
                            Label{"lot", "lotto"},
                            Label{"lot", "lotto n"},
                            Label{"lot", "partita"},
                            Label{"lot", "lote"},
                            Label{"lot", "parti"},
                            Label{"lot", "parti no"},
                            Label{"test-date", "date"},
                            Label{"test-date", "test date"},
                            Label{"test-date", "date of test"},
                            Label{"test-date", "datum"},
                            Label{"test-date", "prufdatum"},
                            Label{"test-date", "pruefdatum"},
                            Label{"test-date", "data"},
                            Label{"test-date", "data prova"},
                            Label{"test-date", "data di prova"},
                            Label{"test-date", "data della prova"},
                            Label{"test-date", "fecha"},
                            Label{"test-date", "tarih"},
                            Label{"test-date", "deney tarihi"},
                            Label{"test-date", "test tarihi"},
                            Label{"temperature-C", "temperature"},
                            Label{"temperature-C", "temp"},
                            Label{"temperature-C", "test temperature"},
                            Label{"temperature-C", "ambient temperature"},
                            Label{"temperature-C", "room temperature"},
                            Label{"temperature-C", "temperatur"},
                            Label{"temperature-C", "pruftemperatur"},
                            Label{"temperature-C", "prueftemperatur"},
                            Label{"temperature-C", "raumtemperatur"},
                            Label{"temperature-C", "temperatura"},
                            Label{"temperature-C", "temperatura di prova"},
                            Label{"temperature-C", "temperatura ambiente"},
                            Label{"temperature-C", "sicaklik"},
                            Label{"temperature-C", "deney sicakligi"},
                            Label{"temperature-C", "ortam sicakligi"},
                            Label{"rubber-thickness-mm", "rubber thickness"},
                            Label{"rubber-thickness-mm", "total rubber thickness"},
                            Label{"rubber-thickness-mm", "t r"},
                            Label{"rubber-thickness-mm", "tr"},
                            Label{"rubber-thickness-mm", "gummidicke"},
                            Label{"rubber-thickness-mm", "gesamtgummidicke"},
                            Label{"rubber-thickness-mm", "gesamte gummidicke"},
                            Label{"rubber-thickness-mm", "spessore gomma"},
                            Label{"rubber-thickness-mm", "spessore totale gomma"},
                            Label{"rubber-thickness-mm", "spessore della gomma"},
                            Label{"rubber-thickness-mm", "kaucuk kalinligi"},
                            Label{"rubber-thickness-mm", "toplam kaucuk kalinligi"},
                            Label{"rubber-area-mm2", "rubber area"},
                            Label{"rubber-area-mm2", "gummiflache"},
                            Label{"rubber-area-mm2", "gummiflaeche"},
                            Label{"rubber-area-mm2", "area gomma"},
                            Label{"rubber-area-mm2", "area della gomma"},
                            Label{"rubber-area-mm2", "a r"},
                            Label{"rubber-area-mm2", "ar"},
                            Label{"rubber-area-mm2", "kaucuk alani"}};

std::optional<std::string_view> key_of(std::string_view label, std::string& unit) {
  std::string base(label);
  if (auto const open = base.find_first_of("[("); open != std::string::npos) {
    auto const close = base.find_first_of("])", open);
    unit = base.substr(open + 1, close == std::string::npos ? close : close - open - 1);
    base.resize(open);
  }
  auto const words = joined(name_words(base), " ");
  auto const found = std::ranges::find(labels, words, &Label::words);
  return found == labels.end() ? std::nullopt : std::optional(found->key);
}

void add(std::string_view key, std::string_view value, std::string const& unit, DeviceFacts& found) {
  constexpr std::size_t longest = 100;
  value = trimmed(value);
  bool const empty = value.find_first_not_of("-_. ") == std::string_view::npos;
  if (empty || value.size() > longest || std::ranges::find(found, key, &DeviceFacts::value_type::first) != found.end())
    return;
  // Leaves out a value with a semicolon, or a colon before a blank, because it is probably several values.
  if (value.find(';') != std::string_view::npos || value.find(": ") != std::string_view::npos) return;
  auto text = std::string(value);
  constexpr std::size_t shortest_date = 6;
  if (key == "test-date" && (text.size() < shortest_date || text.find_first_of("0123456789") == std::string::npos))
    return;
  bool const bare = text.find_first_not_of("0123456789.,+-") == std::string::npos;
  if (bare && !unit.empty()) text += " " + unit;
  found.emplace_back(key, std::move(text));
}

}  // namespace

void take_device_facts(std::string_view line, char delimiter, DeviceFacts& found) {
  constexpr std::size_t longest_line_of_one = 1000;
  line = trimmed(line);
  while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '"'))
    line = trimmed(line.substr(1));
  if (line.empty() || line.size() > longest_line_of_one) return;
  std::vector<std::string_view> cells;
  // If blanks separate the cells, a line about the specimen cannot be split, because its words have blanks between them
  // too.
  if (delimiter == ' ')
    cells.push_back(line);
  else
    split_cells(line, delimiter, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string const cell = to_utf8(cells[i]);
    std::string unit;
    auto colon = cell.find_first_of(":=");
    std::size_t width = 1;
    if (auto const wide = cell.find("\xEF\xBC\x9A"); wide != std::string::npos && wide < colon) {  // a Japanese colon
      colon = wide;
      width = 3;
    }
    auto const key = key_of(trimmed(std::string_view(cell).substr(0, colon)), unit);
    if (!key) continue;
    if (colon != std::string::npos && !trimmed(std::string_view(cell).substr(colon + width)).empty()) {
      auto value = std::string(trimmed(std::string_view(cell).substr(colon + width)));
      // Where commas separate the cells, a decimal comma has split the value into two cells, which are joined here.
      if (delimiter == ',' && is_digit(value.back()) && i + 1 < cells.size() && !cells[i + 1].empty() &&
          is_digit(cells[i + 1].front()))
        value += "," + to_utf8(cells[i + 1]);
      add(*key, value, unit, found);
      continue;
    }
    auto next = i + 1;
    while (next < cells.size() && cells[next].empty()) ++next;
    if (next >= cells.size()) continue;
    auto value = to_utf8(cells[next]);
    if (next + 1 < cells.size() && unit.empty()) unit = to_utf8(cells[next + 1]);
    if (unit.size() > 5) unit.clear();
    add(*key, value, unit, found);
    i = next;
  }
}

}  // namespace isolaw::data
