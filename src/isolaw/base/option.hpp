// Each option of the program is a row of a table: its name, the allowed values, and where the value is kept. The
// command line, a lot file, the store and Python make a JSON value of what they were given, and the row checks it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw {

using Json = nlohmann::ordered_json;

// On the command line a list is "a,b", assignments are "a=1,b=2", and a repeated option is given once for each value.
enum class Kind { flag, whole, real, text, list, repeated, assignments };

// The headings of options in help and docs/cli.md, in the order in which they appear there.
enum class Heading { everyday, reading, corrections, search, plane, analysis, acceptance, model, running };
std::string_view title(Heading heading);

struct Limits {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::string words = {};  // describes the limits in messages and help instead of "least to most"
  int step = 1;            // allowed whole numbers are `least` plus multiples of this step
  bool or_zero = false;    // zero is allowed too and stands for "none"

  bool allow(double value) const;
  std::string text() const;
};

struct OptionInfo {
  std::string_view key;  // the name in the store and in reports
  Kind kind = Kind::text;
  std::string help = {};
  std::optional<Limits> limits = {};
  std::vector<std::string_view> words = {};  // the allowed words, if the option takes one of a few
  std::string_view keyword = {};             // the name in Python; empty: the key with underscores
  std::string_view type = {};                // the type in Python; empty: kind and words decide it
  Heading heading = Heading::search;         // most settings belong here

  std::string option() const;  // the name in a lot file and, after two dashes, on the command line
  std::string python() const;
  std::string python_type() const;  // as written in the package's stub: float, Literal["best", "ga"]
  std::string where() const { return "--" + option(); }  // names the option in a complaint
};

template <class Target>
struct Option : OptionInfo {
  std::function<Json(Target const&)> get;         // returns null if the option was not given
  std::function<void(Target&, Json const&)> set;  // throws Error without a place, which the caller adds

  Option under(Heading chosen) && {
    this->heading = chosen;
    return std::move(*this);
  }
};

using Values = std::map<std::string, Json, std::less<>>;  // the keys of options with their values

// Makes a value from words of the command line. Text that is not a number stays text, even if the kind is a number.
Json value_of(Kind kind, std::vector<std::string> const& words);
// Writes the value as on the command line. The items of a list are joined by commas.
std::string text_of(Json const& value);
// The words of the command line that set the option to `value`. There are none for null and false.
std::vector<std::string> words_of(OptionInfo const& option, Json const& value);
std::string shown(Json const& value);  // for messages: 'text', 12, true
// Calls judge(). If it throws an Error, appends the complaints of this Error to `complaints`. If the place of a
// complaint is an option, it stays. Any other place is put in front of the complaint's text, and `where` becomes the
// place.
void about(std::string const& where, std::vector<Complaint>& complaints, std::function<void()> const& judge);

// Calls judge(row) for every row of a table and throws one Error with all complaints.
template <class Rows, class Judge>
void judge_each(Rows const& rows, Judge const& judge) {
  std::vector<Complaint> complaints;
  for (auto const& row : rows) about(row.where(), complaints, [&] { judge(row); });
  if (!complaints.empty()) throw Error(std::move(complaints));
}

template <class Rows, class Target>
void lay_over(Rows const& rows, Values const& given, Target& target) {
  judge_each(rows, [&](auto const& row) {
    if (auto const found = given.find(row.key); found != given.end()) row.set(target, found->second);
  });
}

// The first four functions convert a value from JSON. If the value is not allowed, they throw an Error that names no
// place (Complaint::where), which the caller adds. refuse() only throws this Error.
int whole_of(Json const& value, Limits const& limits);
double real_of(Json const& value, Limits const& limits);
bool flag_of(Json const& value);
std::string text_in(Json const& value);
[[noreturn]] void refuse(Json const& value, std::string allowed);
constexpr auto at(auto... path) {  // at(&A::b, &B::c) is a function that returns a.b.c for an object a of type A
  return [=](auto& from) -> auto& {
    return (from.*....*path);
  };
}

template <class T>
Json or_null(T const& value) {
  return value;
}
template <class T>
Json or_null(std::optional<T> const& value) {
  return value ? Json(*value) : Json();
}

// Joins the parts of an option's help text: "help, limits (default usual)".
std::string help_of(std::string help, std::string const& limits, std::string const& usual);

// Makes an option whose value is an int, a double or an optional of one of these.
template <class Target, class Access>
Option<Target> number(std::string_view key, std::string help, Access place, Limits limits = {},
                      std::string usual = {}) {
  using Value = std::remove_cvref_t<decltype(place(std::declval<Target&>()))>;
  constexpr bool whole = std::is_same_v<Value, int> || std::is_same_v<Value, std::optional<int>>;
  auto const get = [place](Target const& from) { return or_null(place(from)); };
  auto const set = [place, limits](Target& to, Json const& value) {
    if constexpr (whole)
      place(to) = whole_of(value, limits);
    else
      place(to) = real_of(value, limits);
  };
  help = help_of(std::move(help), limits.text(), usual.empty() ? text_of(get({})) : usual);
  return {{.key = key, .kind = whole ? Kind::whole : Kind::real, .help = help, .limits = limits}, get, set};
}

template <class Target, class Access>
Option<Target> flag(std::string_view key, std::string help, Access place) {
  return {{.key = key, .kind = Kind::flag, .help = std::move(help)},
          [place](Target const& from) -> Json { return place(from); },
          [place](Target& to, Json const& value) { place(to) = flag_of(value); }};
}

// Makes an option that takes one of several words. Each word stands for a value of type T. If T is bool, the option
// takes true and false too.
template <class Target, class Access, class T, std::size_t N>
Option<Target> word(std::string_view key, std::string help, Access place,
                    std::pair<std::string_view, T> const (&words)[N]) {
  std::vector<std::pair<std::string_view, T>> const all(std::begin(words), std::end(words));
  Option<Target> row{{.key = key, .help = std::move(help)}, {}, {}};
  for (auto const& [text, meant] : all) row.words.push_back(text);
  if (std::is_same_v<T, bool>) row.type = "bool";
  row.get = [=](Target const& from) -> Json {
    return std::ranges::find(all, place(from), [](auto& w) { return w.second; })->first;
  };
  row.set = [=, allowed = joined(row.words)](Target& to, Json const& value) {
    for (auto const& [text, meant] : all) {
      if (value == Json(text)) return void(place(to) = meant);
      if constexpr (std::is_same_v<T, bool>)
        if (value == Json(meant)) return void(place(to) = meant);
    }
    refuse(value, allowed);
  };
  return row;
}

}  // namespace isolaw
