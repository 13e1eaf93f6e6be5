#include "isolaw/data/files/unit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>
#include <vector>

#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"

namespace isolaw::data {
namespace {

using Lexicon = std::span<std::string_view const>;

constexpr std::array<std::pair<std::string_view, std::string_view>, 17> signs{{{"×", "x"},
                                                                               {"✕", "x"},
                                                                               {"·", "*"},
                                                                               {"∙", "*"},
                                                                               {"⋅", "*"},
                                                                               {"⁻", "^-"},
                                                                               {"^-¹", "^-1"},
                                                                               {"^-²", "^-2"},
                                                                               {"^-³", "^-3"},
                                                                               {"²", "^2"},
                                                                               {"³", "^3"},
                                                                               {"⁴", "^4"},
                                                                               {"⁵", "^5"},
                                                                               {"⁶", "^6"},
                                                                               {"^-^", "^-"},
                                                                               {"**", "^"},
                                                                               {"∕", "/"}}};

// Writes signs of multiplication and powers in ASCII, decimal commas as points, and blanks in place of brackets.
std::string plain(std::string_view text) {
  std::string result(text);
  for (auto const& [sign, ascii] : signs)
    for (auto at = result.find(sign); at != std::string::npos; at = result.find(sign, at + ascii.size()))
      result.replace(at, sign.size(), ascii);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (std::string_view("[](){}\t").find(result[i]) != std::string_view::npos) result[i] = ' ';
    bool const between_digits = i > 0 && i + 1 < result.size() && is_digit(result[i - 1]) && is_digit(result[i + 1]);
    if (result[i] == ',' && between_digits) result[i] = '.';
  }
  return result;
}

bool take(std::string_view& text, std::string_view any_of) {
  auto const rest = trimmed(text);
  if (rest.empty() || any_of.find(rest.front()) == std::string_view::npos) return false;
  text = rest.substr(1);
  return true;
}

std::optional<double> take_number(std::string_view& text) {
  auto const rest = trimmed(text);
  if (rest.empty() || !(is_digit(rest.front()) || rest.front() == '-')) return std::nullopt;
  double value = 0.0;
  auto const [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc()) return std::nullopt;
  text = rest.substr(static_cast<std::size_t>(end - rest.data()));
  return value;
}

struct Factor {
  double value;
  bool is_certain;  // true for a power or a fraction, as nobody writes a sensor's range so
};
// Takes "10", "0.1", "10^3", "1e3" or "1/100" from the front of the text.
std::optional<Factor> take_factor(std::string_view& text) {
  auto rest = text;
  auto const before = trimmed(rest);
  auto const number = take_number(rest);
  if (!number) return std::nullopt;
  auto const written = before.substr(0, before.size() - rest.size());
  bool const has_exponent = written.find_first_of("eE") != std::string_view::npos;
  Factor factor{*number, has_exponent && written.front() == '1' && (written[1] == 'e' || written[1] == 'E')};
  auto after = rest;
  if (take(after, "^")) {
    auto const power = take_number(after);
    if (!power) return std::nullopt;
    factor = {std::pow(*number, *power), true};
    rest = after;
  } else if (take(after, "/")) {
    auto const denominator = take_number(after);
    if (denominator && *denominator > 0.0) {
      factor = {*number / *denominator, true};
      rest = after;
    }
  }
  if (!(std::isfinite(factor.value) && factor.value > 0.0)) return std::nullopt;
  text = rest;
  return factor;
}

constexpr std::string_view times_signs = "xX*";

constexpr std::string_view half_or_double[]{"half",    "halb",     "halbe",  "halber", "halfte", "meta",   "mezza",
                                            "mezzo",   "mitad",    "moitie", "demi",   "yarim",  "double", "doppel",
                                            "doppelt", "doppelte", "doppia", "doppio", "doble",  "twice",  "both"};
constexpr std::string_view average_words[]{"avg",   "average", "averaged",   "mean",     "media",
                                           "medio", "mittel",  "mittelwert", "mittlere", "gemittelt",
                                           "moyen", "moyenne", "promedio",   "ortalama"};
constexpr std::string_view per_words[]{"per", "pro", "par", "por", "je"};
constexpr std::string_view several_words[]{"two",   "three",  "four",    "zwei",   "drei",   "vier",
                                           "due",   "tre",    "dos",     "tres",   "cuatro", "deux",
                                           "trois", "quatro", "quattro", "quatre", "iki",    "dois"};
constexpr std::string_view device_words[]{"bearings",    "isolators",    "devices",    "specimens", "dampers",
                                          "lager",       "lagern",       "isolatoren", "isolatori", "appoggi",
                                          "dispositivi", "dispositivos", "aisladores", "apoyos",    "appuis",
                                          "appareils",   "isolateurs",   "isoladores", "mesnet",    "izolator"};
constexpr std::string_view pair_words[]{"pair", "paar", "coppia", "paire"};
constexpr std::string_view scaled_words[]{"scaled", "skaliert", "scalato", "scalata", "escalado", "escalada"};
constexpr std::string_view each_words[]{"each", "jeweils", "ognuno", "chacun", "cada"};

bool is_in(Lexicon words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool is_power_of_ten(double value) {
  double const power = std::log10(value);
  return value != 1.0 && std::abs(power - std::round(power)) < 1e-9;
}

// Finds a factor in a column's name, such as "/2", "*10", "x10", "2 x" or "1:2"; "" if there is none.
std::string factor_hint(std::string_view base) {
  auto const text = plain(base);
  // Finds a scale such as 1:2. Other ratios, such as 10:30, may be a time of day or a channel's place in a rack.
  if (auto const at = text.find(':'); at != std::string::npos && at == text.rfind(':')) {
    auto const from = text.find_last_of(" (", at) + 1;
    auto const ratio = text.substr(from, text.find_first_of(" )", at) - from);
    bool const starts_with_one = ratio.starts_with("1:") && ratio != "1:1";
    if (starts_with_one && ratio.size() > 2 && std::ranges::all_of(ratio.substr(2), is_digit)) return ratio;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string_view const from_here = std::string_view(text).substr(i);
    bool const begins = i == 0 || text[i - 1] == ' ';
    bool const division = text[i] == '/' || text[i] == '*';
    bool const letter = begins && (text[i] == 'x' || text[i] == 'X');
    if (division || letter) {
      auto rest = from_here.substr(1);
      auto const factor = take_factor(rest);
      // Outside brackets, "x2" may name the second displacement along x, so it is no factor there. "x10" is one,
      // because hardly any test has a tenth displacement.
      bool const in_brackets = base.find(fmt::format("({}", from_here.substr(0, 2))) != std::string_view::npos;
      bool const ends = rest.empty() || rest.front() == ' ' || rest.front() == ')';
      if (factor && ends && i > 0 && (division || in_brackets || is_power_of_ten(factor->value)))
        return std::string(trimmed(from_here.substr(0, from_here.size() - rest.size())));
    }
    if (begins && is_digit(text[i])) {
      auto rest = from_here;
      if (take_factor(rest) && take(rest, times_signs) && (rest.empty() || !is_digit(rest.front())))
        return std::string(trimmed(from_here.substr(0, from_here.size() - rest.size())));
    }
  }
  return {};
}

struct Sensitivity {
  double number;
  Unit unit;
  std::string volts;  // "v" or "mv"
  std::string text;   // as written: "25 mm/V"
};

std::optional<Sensitivity> find_sensitivity(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i]) || (i > 0 && (is_digit(text[i - 1]) || text[i - 1] == '.'))) continue;
    auto rest = text.substr(i);
    auto const number = take_number(rest);
    auto const slash = rest.find('/');
    if (!number || !(*number > 0.0) || slash == std::string_view::npos) continue;
    auto const unit = parse_unit(rest.substr(0, slash));
    auto const behind = trimmed(rest.substr(slash + 1));
    auto const volts = behind.substr(0, behind.find_first_of(" ,;"));
    if (!unit || (lower(volts) != "v" && lower(volts) != "mv")) continue;
    auto const end = static_cast<std::size_t>(volts.data() + volts.size() - text.data());
    return Sensitivity{*number, *unit, lower(volts), std::string(text.substr(i, end - i))};
  }
  return std::nullopt;
}

}  // namespace

std::optional<UnitText> parse_unit_text(std::string_view text) {
  if (auto const unit = parse_unit(text)) return UnitText{.unit = *unit};
  auto const ascii = plain(text);
  std::string_view rest = trimmed(ascii);
  bool const times_first = take(rest, times_signs);
  if (auto const factor = take_factor(rest)) {
    bool const times_last = take(rest, times_signs);
    if (auto const unit = parse_unit(rest))
      return UnitText{*unit, factor->value, times_first || times_last || factor->is_certain || factor->value == 1.0};
    return std::nullopt;
  }
  auto const at = ascii.find_first_of("xX*/");
  if (at == std::string::npos) return std::nullopt;
  auto const unit = parse_unit(std::string_view(ascii).substr(0, at));
  auto behind = std::string_view(ascii).substr(at + 1);
  auto const factor = take_factor(behind);
  if (!unit || !factor || !trimmed(behind).empty()) return std::nullopt;
  return UnitText{*unit, ascii[at] == '/' ? 1.0 / factor->value : factor->value, false};
}

std::optional<UnitText> sensitivity_in(std::string_view name, std::string_view unit) {
  auto const volts = lower(trimmed(plain(unit)));
  auto const found = find_sensitivity(plain(name));
  if (!found || (volts != "v" && volts != "mv")) return std::nullopt;
  double const ratio = volts == found->volts ? 1.0 : volts == "mv" ? 1e-3 : 1e3;
  return UnitText{found->unit, found->number * ratio, true};
}

std::string without_sensitivity(std::string_view name) {
  auto const found = find_sensitivity(plain(name));
  if (!found) return std::string(name);
  // Looks for the whole text, such as "25 mm/V", because the number 25 alone may occur more than once in the name.
  auto rest = std::string(name);
  auto const from = rest.find(found->text);
  return from == std::string::npos ? rest : rest.erase(from, found->text.size());
}

bool is_other_quantity(std::string_view unit) {
  constexpr std::string_view others[]{"%",     "v",    "mv",    "deg",  "°",   "rad",  "mrad",  "c",     "°c",
                                      "a",     "ma",   "pa",    "kpa",  "mpa", "bar",  "psi",   "ksi",   "g",
                                      "mm/s",  "m/s",  "cm/s",  "in/s", "hz",  "m/s2", "m/s^2", "n/mm2", "n/mm^2",
                                      "n/mm²", "m/s²", "mm/mm", "µε",   "με",  "ue"};
  auto const text = plain(unit);
  return is_in(others, lower(trimmed(unit))) || is_in(others, lower(trimmed(text)));
}

std::string scale_hint(std::string_view base, Dimension dimension) {
  if (auto hint = factor_hint(base); !hint.empty()) return hint;
  auto const words = name_words(base);
  auto const is_several = [](std::string const& word) {
    return is_in(several_words, word) || number_in<int>(word).value_or(0) > 1;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_in(half_or_double, words[i]) || is_in(scaled_words, words[i])) return words[i];
    if (dimension != Dimension::force) continue;
    if (is_in(average_words, words[i]) || is_in(each_words, words[i]) || is_in(pair_words, words[i])) return words[i];
    if (i + 1 < words.size() &&
        (is_in(per_words, words[i]) || (is_several(words[i]) && is_in(device_words, words[i + 1]))))
      return words[i] + " " + words[i + 1];
  }
  return {};
}

std::string other_unit_in(std::string_view base, Unit const& unit) {
  auto const words = name_words(base);
  for (std::size_t i = 0; i < words.size(); ++i) {
    bool const is_range = i > 0 && number_in<double>(words[i - 1]);  // as in "cell of 100 kN"
    if (words[i].size() < 2 || words[i] == "in" || is_range) continue;
    auto const other = parse_unit(words[i]);
    if (other && other->dimension == unit.dimension && other->symbol != unit.symbol) return std::string(other->symbol);
  }
  return {};
}

}  // namespace isolaw::data
