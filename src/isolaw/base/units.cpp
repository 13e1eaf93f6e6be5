#include "isolaw/base/units.hpp"

#include <array>
#include <vector>

#include "isolaw/base/words.hpp"

namespace isolaw {
namespace {

// The sizes are exact by definition: 1 kgf = 9.80665 N, 1 lbf = 4.4482216152605 N, 1 in = 25.4 mm.
constexpr std::array known{
    kN,
    N,
    Unit{Dimension::force, "MN", 1e3},
    Unit{Dimension::force, "tonf", 9.80665},
    Unit{Dimension::force, "kgf", 9.80665e-3},
    Unit{Dimension::force, "daN", 1e-2},
    Unit{Dimension::force, "kip", 4.4482216152605},
    Unit{Dimension::force, "lbf", 4.4482216152605e-3},
    Unit{Dimension::force, "Mp", 9.80665},  // megapond, the same as a tonf
    mm,
    cm,
    m,
    Unit{Dimension::length, "in", 25.4},
    Unit{Dimension::length, "ft", 304.8},
    Unit{Dimension::length, "dm", 100.0},
    Unit{Dimension::length, "um", 1e-3},
    s,
    Unit{Dimension::time, "ms", 1e-3},
    Unit{Dimension::time, "min", 60.0},
    Unit{Dimension::time, "d", 86400.0},
};

struct Alias {
  std::string_view text;
  std::string_view symbol;
};
constexpr std::array aliases{
    Alias{"kips", "kip"},
    Alias{"lb", "lbf"},
    Alias{"lbs", "lbf"},
    Alias{"tf", "tonf"},
    Alias{"inch", "in"},
    Alias{"inches", "in"},
    Alias{"\"", "in"},
    Alias{"sec", "s"},
    Alias{"secs", "s"},
    Alias{"second", "s"},
    Alias{"seconds", "s"},
    Alias{"msec", "ms"},
    Alias{"kilonewton", "kN"},
    Alias{"newton", "N"},
    Alias{"kg", "kgf"},
    Alias{"in.", "in"},
    Alias{"t", "tonf"},
    Alias{"minute", "min"},
    Alias{"day", "d"},
    Alias{"days", "d"},
    Alias{"minutes", "min"},
    Alias{"sek", "s"},
    Alias{"sn", "s"},
    Alias{"saniye", "s"},
    Alias{"\xE7\xA7\x92", "s"},  // "second" in Chinese and Japanese
    Alias{"klbf", "kip"},
    Alias{"klb", "kip"},
    Alias{"kp", "kgf"},
    Alias{"\xC2\xB5m", "um"},
    Alias{"\xCE\xBCm", "um"},
    Alias{"micron", "um"},
    Alias{"microns", "um"},
    Alias{"feet", "ft"},
    Alias{"foot", "ft"},
    Alias{"\xD0\xBC\xD0\xBC", "mm"},  // from here Russian: mm, cm, m, kN, N, MN, tonf, kgf, s (two spellings)
    Alias{"\xD1\x81\xD0\xBC", "cm"},
    Alias{"\xD0\xBC", "m"},
    Alias{"\xD0\xBA\xD0\x9D", "kN"},
    Alias{"\xD0\x9D", "N"},
    Alias{"\xD0\x9C\xD0\x9D", "MN"},
    Alias{"\xD1\x82\xD1\x81", "tonf"},
    Alias{"\xD0\xBA\xD0\xB3\xD1\x81", "kgf"},
    Alias{"\xD1\x81", "s"},
    Alias{"\xD1\x81\xD0\xB5\xD0\xBA", "s"},
    Alias{"\xEC\xB4\x88", "s"},  // "second" in Korean
    Alias{"dk", "min"},
    Alias{"dakika", "min"},
    Alias{"\xE5\x88\x86", "min"},
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  constexpr std::string_view ignored = " \t[](){}";
  auto const first = text.find_first_not_of(ignored);
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(ignored) - first + 1);
  for (auto const& unit : known)
    if (unit.symbol == text) return unit;
  if (text == "mN") return std::nullopt;  // a millinewton must not be read as a meganewton
  auto const wanted = lower(text);
  for (auto const& alias : aliases)
    if (alias.text == wanted) return parse_unit(alias.symbol);
  for (auto const& unit : known)
    if (lower(unit.symbol) == wanted) return unit;
  return std::nullopt;
}

std::string known_units(Dimension dimension) {
  std::vector<std::string_view> symbols;
  for (auto const& unit : known)
    if (unit.dimension == dimension) symbols.push_back(unit.symbol);
  return joined(symbols);
}

std::string_view name(Dimension dimension) {
  if (dimension == Dimension::force) return "force";
  if (dimension == Dimension::count) return "number";
  return dimension == Dimension::length ? "length" : "time";
}

}  // namespace isolaw
