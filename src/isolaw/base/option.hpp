// An option of the program as one row of a table: what it is called, what it may be, where it is kept. A way in (command
// line, lot file, store, Python) makes a JSON value of what it was given; the row alone judges it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"

namespace isolaw {

using Json = nlohmann::ordered_json;

// list: "a,b" on the command line. repeated: the option once for each. assignments: "a=1,b=2", or a table.
enum class Kind { flag, whole, real, text, list, repeated, assignments };

// What a number may be.
struct Limits {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::string words = {};  // for messages and help, where "least to most" is not what to say
  int step = 1;            // of whole numbers, from the least
  bool or_zero = false;    // which then stands for none

  bool allow(double value) const;
  std::string text() const;
};

struct OptionInfo {
  std::string_view key;  // as stored and reported
  Kind kind = Kind::text;
  std::string help = {};
  std::optional<Limits> limits = {};
  std::vector<std::string_view> words = {};  // where it is one of these
  std::string_view keyword = {};             // in Python, where that is not the key with underscores

  std::string option() const;  // on the command line, without its dashes, and in a lot file
  std::string python() const;
};

template <class Target>
struct Option : OptionInfo {
  std::function<Json(Target const&)> get;         // null: not given
  std::function<void(Target&, Json const&)> set;  // throws Error, which leaves `where` to the way in
};

// --- ways in and out ---------------------------------------------------------------------------------------------------

// What the command line gives: a number where the words are one.
Json value_of(Kind kind, std::vector<std::string> const& words);
// As the command line takes it back.
std::string text_of(Json const& value);
// The words of the command line that give an option its value: none for null, false and a list of nothing.
std::vector<std::string> words_of(OptionInfo const& option, Json const& value);
// For messages: 'text', 12, true.
std::string shown(Json const& value);

// Calls judge() and says of its complaints that they are about `where`, if they do not name an option themselves.
void about(std::string const& where, std::vector<Complaint>& complaints, std::function<void()> const& judge);

// --- judges: throw Error -----------------------------------------------------------------------------------------------

int whole_of(Json const& value, Limits const& limits);
double real_of(Json const& value, Limits const& limits);
bool flag_of(Json const& value);
std::string text_in(Json const& value);
[[noreturn]] void refuse(Json const& value, std::string allowed, std::string advice = {});

// --- rows --------------------------------------------------------------------------------------------------------------

// "help, limits (usual)"
std::string help_of(std::string help, std::string const& limits, std::string const& usual);

// `member` gives the place in a Target, const or not: an int or a double, optional or not.
template <class Target, class Member>
Option<Target> number(std::string_view key, std::string help, Member member, Limits limits = {},
                      std::string usual = {}) {
  using Value = std::remove_cvref_t<decltype(member(std::declval<Target&>()))>;
  constexpr bool whole = std::is_same_v<Value, int> || std::is_same_v<Value, std::optional<int>>;
  Option<Target> made;
  made.key = key;
  made.kind = whole ? Kind::whole : Kind::real;
  made.get = [member](Target const& from) -> Json {
    if constexpr (std::is_arithmetic_v<Value>)
      return member(from);
    else
      return member(from) ? Json(*member(from)) : Json();
  };
  if (usual.empty()) usual = text_of(made.get(Target{}));
  made.help = help_of(std::move(help), limits.text(), usual);
  made.limits = limits;
  made.set = [member, limits](Target& to, Json const& value) {
    if constexpr (whole)
      member(to) = whole_of(value, limits);
    else
      member(to) = real_of(value, limits);
  };
  return made;
}

template <class Target, class Member>
Option<Target> flag(std::string_view key, std::string help, Member member) {
  Option<Target> made;
  made.key = key;
  made.kind = Kind::flag;
  made.help = std::move(help);
  made.get = [member](Target const& from) -> Json { return member(from); };
  made.set = [member](Target& to, Json const& value) { member(to) = flag_of(value); };
  return made;
}

// One of several words, and what it stands for.
template <class T>
struct Word {
  std::string_view text;
  T value;
};

template <class T>
std::string_view word_for(T value, std::span<Word<T> const> words) {
  return std::ranges::find(words, value, &Word<T>::value)->text;
}

template <class T>
T meant_by(Json const& value, std::span<Word<T> const> words) {
  std::string allowed;
  for (auto const& word : words) {
    if (value.is_string() && value.get_ref<std::string const&>() == word.text) return word.value;
    allowed += (allowed.empty() ? "" : ", ") + std::string(word.text);
  }
  if constexpr (std::is_same_v<T, bool>)
    if (value.is_boolean()) return value.get<bool>();
  refuse(value, allowed);
}

template <class Target, class Member, class T, std::size_t N>
Option<Target> word(std::string_view key, std::string help, Member member, Word<T> const (&words)[N]) {
  std::span<Word<T> const> const all(words);
  Option<Target> made;
  made.key = key;
  made.help = std::move(help);
  for (auto const& each : all) made.words.push_back(each.text);
  made.get = [member, all](Target const& from) -> Json { return word_for<T>(member(from), all); };
  made.set = [member, all](Target& to, Json const& value) { member(to) = meant_by<T>(value, all); };
  return made;
}

// What `write` puts into words and `read` takes from them.
template <class Target, class Write, class Read>
Option<Target> text(std::string_view key, Kind kind, std::string help, Write write, Read read) {
  Option<Target> made;
  made.key = key;
  made.kind = kind;
  made.help = std::move(help);
  made.get = write;
  made.set = read;
  return made;
}

}  // namespace isolaw
