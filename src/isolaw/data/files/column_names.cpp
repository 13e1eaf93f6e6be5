#include "isolaw/data/files/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/unit_text.hpp"

namespace isolaw::data {
namespace {

using Words = std::vector<std::string>;
using Lexicon = std::span<std::string_view const>;

// Words that mean a channel or a quantity, in English, Italian, German, French, Spanish, Portuguese and
// Turkish, in lower case.
constexpr std::string_view time_words[]{"time",     "tempo", "zeit", "temps",   "tiempo",
                                        "messzeit", "zaman", "sure", "prufzeit"};
constexpr std::string_view calendar_words[]{"datetime", "datenum", "date", "datum", "data", "fecha", "tarih"};
constexpr std::string_view disp_words[]{"disp",        "weg",       "stroke",   "corsa",       "extension",   "hub",
                                        "scorrimento", "deplasman", "otelenme", "standardweg", "traversenweg"};
constexpr std::string_view disp_stems[]{"displ",     "spost",     "verschieb",           "deplac",
                                        "desplaz",   "desloc",    "horizontalverschieb", "horizontalweg",
                                        "kolbenweg", "degistirme"};
constexpr std::string_view force_words[]{"force",    "forces",          "forza",     "taglio",        "shear",
                                         "kraft",    "fuerza",          "forca",     "esforco",       "effort",
                                         "cortante", "horizontalkraft", "querkraft", "schubkraft",    "scherkraft",
                                         "kuvvet",   "kuvveti",         "kesme",     "standardkraft", "prufkraft"};
constexpr std::string_view load_words[]{"load", "carico", "last", "carga", "charge", "yuk", "yuku"};
constexpr std::string_view vertical_force_words[]{"vertikalkraft", "vertikallast", "axialkraft",
                                                  "axiallast",     "normalkraft",  "auflast"};
constexpr std::string_view vertical_disp_words[]{"vertikalweg", "vertikalverschiebung"};
constexpr std::string_view vertical_words[]{
    "vertical", "verticale",   "vert",         "vertikal",    "axial", "axiale", "assiale", "normal",
    "normale",  "compression", "compressione", "kompression", "z",     "dusey",  "eksenel", "basinc"};
constexpr std::string_view horizontal_words[]{"horizontal", "horizontale", "orizzontale", "orizz",  "horiz", "hor",
                                              "lateral",    "laterale",    "shear",       "taglio", "yatay", "kesme"};
constexpr std::string_view velocity_words[]{"velocity",        "velocita", "vel",       "speed",
                                            "geschwindigkeit", "vitesse",  "velocidad", "velocidade"};
// A name with one of these words means no channel, even if "displacement" is also in it.
constexpr std::string_view other_quantities[]{
    "command",   "comando",        "cmd",         "setpoint",    "target",       "demand",
    "soll",      "sollwert",       "sollweg",     "consigne",    "consigna",     "reference",
    "ref",       "riferimento",    "aceleracao",  "aceleracion", "acceleration", "accelerazione",
    "acc",       "beschleunigung", "error",       "errore",      "fehler",       "strain",
    "stress",    "modulus",        "temperature", "temperatura", "temperatur",   "pressure",
    "pressione", "rate",           "status",      "hiz",         "hizi",         "ivme",
    "sicaklik",  "komut",          "hedef"};
constexpr std::string_view disp_symbols[]{"x", "u", "d", "ux", "dx", "uh", "dh"};
constexpr std::string_view force_symbols[]{"f", "h", "fx", "fh"};
constexpr std::string_view load_symbols[]{"v", "fv", "fz", "p"};
constexpr std::string_view vertical_letters[]{"v", "n"};  // mean "vertical" only beside another word: "Force V"
constexpr std::string_view counter_words[]{"sample", "samples",  "index", "idx",     "no",    "nr",
                                           "num",    "number",   "count", "counter", "point", "points",
                                           "scan",   "campione", "row",   "record",  "id"};

bool is_in(Lexicon lexicon, std::string_view word) {
  return std::ranges::find(lexicon, word) != std::ranges::end(lexicon);
}

bool any_in(Lexicon lexicon, Words const& words) {
  return std::ranges::any_of(words, [&](auto const& word) { return is_in(lexicon, word); });
}

bool any_starts(Lexicon stems, Words const& words) {
  return std::ranges::any_of(words, [&](auto const& word) {
    return std::ranges::any_of(stems, [&](auto stem) { return word.starts_with(stem); });
  });
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

struct Translation {
  std::string_view text, words;
};
// translated() replaces the texts in this order, so a longer text comes before the shorter texts that it contains.
constexpr Translation translations[]{{"加速度", "acceleration"},
                                     {"試験年月日", "test date"},
                                     {"試験体番号", "specimen no"},
                                     {"試験体名", "specimen name"},
                                     {"製造番号", "serial no"},
                                     {"製品番号", "serial no"},
                                     {"シリアル", "serial"},
                                     {"試験体", "specimen"},
                                     {"番号", "no"},
                                     {"試験日", "test date"},
                                     {"日付", "date"},
                                     {"日時", "date time"},
                                     {"ロット", "lot"},
                                     {"試験温度", "test temperature"},
                                     {"室温", "room temperature"},
                                     {"温度", "temperature"},
                                     {"ゴム総厚さ", "total rubber thickness"},
                                     {"ゴム総厚", "total rubber thickness"},
                                     {"ゴム厚", "rubber thickness"},
                                     {"ゴム面積", "rubber area"},
                                     {"経過時間", "time"},
                                     {"時間", "time"},
                                     {"時刻", "time"},
                                     {"変位", "displacement"},
                                     {"変形", "displacement"},
                                     {"水平", "horizontal"},
                                     {"鉛直", "vertical"},
                                     {"垂直", "vertical"},
                                     {"軸力", "axial force"},
                                     {"せん断", "shear"},
                                     {"荷重", "load"},
                                     {"速度", "velocity"},
                                     {"圧力", "pressure"},
                                     {"面圧", "pressure"},
                                     {"応力", "stress"},
                                     {"ひずみ", "strain"},
                                     {"歪", "strain"},
                                     {"目標", "target"},
                                     {"指令", "command"},
                                     {"位移", "displacement"},
                                     {"变形", "displacement"},
                                     {"时间", "time"},
                                     {"竖向", "vertical"},
                                     {"豎向", "vertical"},
                                     {"轴力", "axial force"},
                                     {"剪力", "shear force"},
                                     {"剪切", "shear"},
                                     {"载荷", "load"},
                                     {"荷载", "load"},
                                     {"荷載", "load"},
                                     {"压力", "pressure"},
                                     {"应力", "stress"},
                                     {"应变", "strain"},
                                     {"序号", "no"},
                                     {"가속도", "acceleration"},
                                     {"속도", "velocity"},
                                     {"시간", "time"},
                                     {"변위", "displacement"},
                                     {"변형률", "strain"},
                                     {"변형", "displacement"},
                                     {"수평", "horizontal"},
                                     {"수직", "vertical"},
                                     {"연직", "vertical"},
                                     {"축력", "axial force"},
                                     {"전단력", "shear force"},
                                     {"전단", "shear"},
                                     {"하중", "load"},
                                     {"온도", "temperature"},
                                     {"압력", "pressure"},
                                     {"응력", "stress"},
                                     {"힘", "force"},
                                     {"번호", "no"},
                                     // Russian words without their first letter, which may be a capital, and without
                                     // their ending, which varies by grammar.
                                     {"еремещени", "displacement"},
                                     {"мещени", "displacement"},
                                     {"ремя", "time"},
                                     {"силие", "force"},
                                     {"силия", "force"},
                                     {"Сила", "force"},
                                     {"сила", "force"},
                                     {"агрузк", "load"},
                                     {"оризонтальн", "horizontal"},
                                     {"ертикальн", "vertical"},
                                     {"Осев", "axial"},
                                     {"осев", "axial"},
                                     {"двиг", "shear"},
                                     {"скорени", "acceleration"},
                                     {"корость", "velocity"},
                                     {"емператур", "temperature"},
                                     {"апряжени", "stress"},
                                     {"力", "force"},
                                     {"（", " ("},
                                     {"）", ") "},
                                     {"［", " ["},
                                     {"］", "] "},
                                     {"㎜", "mm"},
                                     {"㎝", "cm"},
                                     {"　", " "}};

std::string narrow(std::string_view text) {
  std::string narrowed;
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto const byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    if (i + 2 < text.size() && byte(i) == 0xEF && (byte(i + 1) == 0xBC || byte(i + 1) == 0xBD)) {
      unsigned const code = (byte(i + 1) - 0xBCu) * 64u + (byte(i + 2) & 0x3Fu);  // offset from U+FF00
      if (code >= 1 && code <= 0x5E) {
        narrowed += static_cast<char>(0x20 + code);
        i += 2;
        continue;
      }
    }
    narrowed += text[i];
  }
  return narrowed;
}

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string translated(std::string_view text, bool words) {
  if (is_ascii(text)) return std::string(text);
  auto result = narrow(text);
  for (auto const& [from, to] : translations) {
    bool const word = to.front() >= 'a' && to != "mm" && to != "cm";
    if (word && !words) continue;
    for (auto at = result.find(from); at != std::string::npos; at = result.find(from, at))
      result.replace(at, from.size(), word ? fmt::format(" {} ", to) : std::string(to));
  }
  return result;
}

Words words_of(std::string_view name) {
  auto const text = without_accents(translated(name, true));
  Words words;
  char previous = ' ';
  for (char const c : text) {
    bool const part = is_letter(c) || is_digit(c);
    bool const joined = (is_letter(previous) && is_letter(c) && !(is_capital(c) && !is_capital(previous))) ||
                        (is_digit(previous) && is_digit(c));
    if (part && !joined) words.emplace_back();
    if (part) words.back() += c;
    previous = c;
  }
  for (auto& word : words) word = lower(word);
  return words;
}

// True for "Cycle", "cycle no" or "cycle_count": a word for a cycle, alone or with one word for a number.
bool is_cycle_number(Words const& words) {
  constexpr std::string_view cycle_words[]{"cycle", "cycles", "zyklus", "zyklen", "ciclo", "cicli", "ciclos", "cyc"};
  return words.size() <= 2 && any_in(cycle_words, words) && (words.size() == 1 || any_in(counter_words, words));
}

Meaning meaning_of_words(Words const& words) {
  auto const word = [](Channel channel) { return Meaning{.channel = channel, .certainty = Certainty::word}; };
  if ((any_in(other_quantities, words) || any_in(velocity_words, words))) return {};
  bool const single_letter_vertical = words.size() > 1 && any_in(vertical_letters, words);
  bool const vertical = any_in(vertical_words, words) || single_letter_vertical;
  bool const disp = any_in(disp_words, words) || any_starts(disp_stems, words);
  if (any_in(vertical_force_words, words)) return word(Channel::load);
  if (any_in(vertical_disp_words, words)) return {.channel = {}, .vertical_disp = true};
  if (disp) return vertical ? Meaning{.channel = {}, .vertical_disp = true} : word(Channel::disp);
  if (is_cycle_number(words)) return word(Channel::cycle);
  if (any_in(time_words, words)) return word(Channel::time);
  bool const load = any_in(load_words, words);
  if (any_in(force_words, words)) return word(vertical ? Channel::load : Channel::force);
  if (vertical) return word(Channel::load);
  if (load && any_in(horizontal_words, words)) return word(Channel::force);
  if (load) return {.channel = Channel::load, .certainty = Certainty::word, .plain_load = true};
  return {};
}

Meaning meaning_of_symbol(std::string_view base, std::optional<Unit> unit) {
  std::string symbol;
  for (char const c : without_accents(base))
    if (is_letter(c) || is_digit(c)) symbol += c;
  auto const meant = [&](Channel channel) {
    bool const other_dimension = unit && unit->dimension != dimension(channel);
    return other_dimension ? Meaning{} : Meaning{.channel = channel, .certainty = Certainty::symbol};
  };
  if (symbol == "t") return meant(Channel::time);
  if (symbol == "T" && unit) return meant(Channel::time);  // without a unit, T may be a temperature
  if (symbol == "N") return meant(Channel::load);          // in lower case, n counts samples
  auto const small = lower(symbol);
  if (small == "xvalue") return meant(Channel::time);  // LabVIEW's name of the time
  if (is_in(disp_symbols, small)) return meant(Channel::disp);
  if (is_in(force_symbols, small)) return meant(Channel::force);
  if (is_in(load_symbols, small)) return meant(Channel::load);
  return {};
}

// Splits "Displacement [mm] horizontal" into the name "Displacement horizontal" and the unit "mm". If there are several
// brackets, prefers a plain unit to a unit with a factor.
std::optional<ColumnName> split_brackets(std::string_view name) {
  constexpr std::array<std::pair<char, char>, 3> brackets{{{'[', ']'}, {'(', ')'}, {'{', '}'}}};
  std::optional<ColumnName> scaled, unknown;
  for (auto const& [open, close] : brackets) {
    auto const first = name.find(open);
    auto const last = name.find(close, first == std::string_view::npos ? 0 : first);
    if (first == std::string_view::npos || last == std::string_view::npos) continue;
    auto const inside = trimmed(name.substr(first + 1, last - first - 1));
    ColumnName parts{.base = std::string(name.substr(0, first)) + ' ' + std::string(name.substr(last + 1)),
                     .unit = std::string(inside)};
    parts.base = trimmed(parts.base);
    if (parse_unit(inside)) return parts;
    if (parse_unit_text(inside)) scaled = parts;
    constexpr std::size_t longest_unit = 8;
    bool const remark = meaning_of_words(words_of(inside)).channel || any_in(horizontal_words, words_of(inside)) ||
                        inside.size() > longest_unit || inside.empty() || (open == '(' && is_digit(inside.front()));
    if ((!remark || is_other_quantity(inside)) && !unknown) unknown = parts;
  }
  return scaled ? scaled : unknown;
}

// Splits names that end in their unit: "displacement_cm", "Force, kN", "Kraft in kN", "F / kN", "Force x10 kN".
std::optional<ColumnName> split_last_word(std::string_view name) {
  constexpr std::string_view separators = " _/,;:-";
  auto at = name.find_last_of(separators);
  if (at == std::string_view::npos || at == 0 || !parse_unit(name.substr(at + 1))) return std::nullopt;
  // In "Force min" and "x_t" the last word is no unit, although "min" and "t" can be units.
  auto const last = lower(name.substr(at + 1));
  auto const before = trimmed(name.substr(0, at + 1));
  bool const set_apart = before.ends_with(',') || before.ends_with('/') || before.ends_with(" in");
  if ((last == "t" || last == "min") && !set_apart) return std::nullopt;
  if (auto const blank = name.find_last_of(' ', at - 1); blank != std::string_view::npos && name[at] == ' ') {
    auto const scaled = parse_unit_text(name.substr(blank + 1));
    if (scaled && scaled->is_certain && scaled->factor != 1.0) at = blank;
  }
  auto base = name.substr(0, at);
  auto const tail = base.find_last_not_of(separators);
  if (tail == std::string_view::npos) return std::nullopt;
  base = base.substr(0, tail + 1);
  if (base.ends_with(" in")) base.remove_suffix(3);
  return ColumnName{.base = std::string(base), .unit = std::string(name.substr(at + 1))};
}

}  // namespace

Meaning meaning_of(std::string_view name) {
  auto const parts = dissect_name(name);
  auto const meaning = meaning_of_words(words_of(parts.base));
  if (meaning.channel || meaning.vertical_disp) return meaning;
  auto const unit = parse_unit_text(parts.unit);
  return meaning_of_symbol(parts.base, unit ? std::optional(unit->unit) : std::nullopt);
}

bool is_counter(std::string_view name) {
  auto const words = words_of(dissect_name(name).base);
  if (words.empty()) return trimmed(name) == "#";
  bool const symbol = words.front() == "n" && trimmed(name).front() == 'n';
  return words.size() == 1 && (symbol || is_in(counter_words, words.front()));
}

std::vector<std::string> name_words(std::string_view name) {
  return words_of(name);
}

bool is_translated(std::string_view name) {
  return std::ranges::any_of(translations, [&](auto const& each) {
    return each.words.front() >= 'a' && name.find(each.text) != std::string_view::npos;
  });
}

ColumnName dissect_name(std::string_view written) {
  auto const ordinary = without_sensitivity(translated(written, false));
  auto const name = trimmed(ordinary);
  if (auto const parts = split_brackets(name)) return *parts;
  if (auto const parts = split_last_word(name)) return *parts;
  return {.base = std::string(name), .unit = {}};
}

bool names_a_calendar(std::string_view name) {
  return any_in(calendar_words, words_of(dissect_name(name).base));
}

bool names_a_velocity(std::string_view name) {
  return any_in(velocity_words, words_of(dissect_name(name).base));
}

bool names_a_channel(std::string_view cell) {
  return meaning_of(cell).channel.has_value();
}

}  // namespace isolaw::data
