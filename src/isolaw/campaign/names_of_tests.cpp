#include "isolaw/campaign/names_of_tests.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

constexpr std::string_view separators = " _-.=,;";

bool is_in_word(char c) {
  return is_letter(c) || is_digit(c);
}

bool is_one_of(std::string_view word, auto const& words) {
  return std::ranges::find(words, word) != words.end();
}

// A number within a name, with the letters that touch it: "T-20C" has `before` = "t", `value` = -20 and `unit` = "c".
struct NumberInName {
  std::size_t from = 0, end = 0;       // where the letters before the number begin, and where its unit ends
  std::string before = {}, unit = {};  // in lower case
  double value = 0.0;
  bool has_sign = false;  // a dash or a plus sign stands before the number
  bool has_dash = false;  // a dash stands before the number: a minus sign or a separator of words
  bool is_minus = false;  // the dash can only be a minus sign
};

NumberInName number_at(std::string_view name, std::size_t first) {
  NumberInName found{.from = first, .end = first};
  auto const last_of = [&](std::size_t at, auto const& belongs) {
    while (at < name.size() && belongs(name[at])) ++at;
    return at;
  };
  found.end = last_of(first, is_digit);
  if (found.end + 1 < name.size() && name[found.end] == '.' && is_digit(name[found.end + 1]))
    found.end = last_of(found.end + 1, is_digit);
  found.value = number_in<double>(name.substr(first, found.end - first)).value_or(0.0);
  constexpr std::string_view degree = "°";
  if (name.substr(found.end).starts_with(degree)) found.end += degree.size();
  auto const unit = found.end;
  found.end = last_of(unit, is_letter);
  found.unit = lower(name.substr(unit, found.end - unit));
  found.has_sign = first > 0 && (name[first - 1] == '-' || name[first - 1] == '+');
  if (found.has_sign) --found.from;
  found.has_dash = name[found.from] == '-';
  auto const sign = found.from;
  while (found.from > 0 && is_letter(name[found.from - 1])) --found.from;
  found.before = lower(name.substr(found.from, sign - found.from));
  bool const after_word = sign > 0 && is_in_word(name[sign - 1]);
  found.is_minus = found.has_dash && (!after_word || found.before == "t" || found.before == "temp");
  // A dash as in "cold-20C" separates two words and is no minus sign.
  if (found.has_dash && !found.is_minus) {
    found.from = sign;
    found.before.clear();
  }
  return found;
}

struct ConditionsInName {
  ProposedTest test;
  std::size_t from = std::string_view::npos;  // where the first condition begins
};

std::size_t place_of(std::string_view word, std::string_view name) {
  auto const plain = lower(name);
  for (auto at = plain.find(word); at != std::string::npos; at = plain.find(word, at + 1)) {
    auto const end = at + word.size();
    if ((at == 0 || !is_in_word(plain[at - 1])) && (end == plain.size() || !is_letter(plain[end]))) return at;
  }
  return std::string_view::npos;
}

ConditionsInName conditions_in(std::string_view name, bool dash_separates) {
  constexpr std::array<std::string_view, 3> before_temperature{"", "t", "temp"};
  constexpr std::array<std::string_view, 3> degrees{"c", "degc", "deg"};
  constexpr std::array<std::string_view, 2> before_frequency{"", "f"};
  constexpr std::array<std::string_view, 4> before_load{"", "n", "p", "v"};
  ConditionsInName found;
  auto const aged = place_of("aged", name);
  found.test.is_aged = aged != std::string_view::npos;
  found.test.is_virgin = place_of("virgin", name) != std::string_view::npos;
  found.from = aged;
  int temperatures_found = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_digit(name[i])) continue;
    auto const number = number_at(name, i);
    i = number.end - 1;
    bool const ends = number.end == name.size() || !is_in_word(name[number.end]);
    // Without a unit, "T-20" is a temperature but "T1" is the name of a test.
    bool const is_temperature =
        number.unit.empty() ? number.has_sign && !number.before.empty() : is_one_of(number.unit, degrees);
    bool const is_frequency = number.unit == "hz" && is_one_of(number.before, before_frequency);
    bool const is_load = number.unit == "kn" && is_one_of(number.before, before_load);
    if (!ends || !((is_temperature && is_one_of(number.before, before_temperature)) || is_frequency || is_load))
      continue;
    found.from = std::min(found.from, number.from);
    if (is_load) found.test.load_kN = number.value;
    if (!is_temperature || aged < number.from) continue;
    bool const sign_is_known = !number.has_dash || number.is_minus || dash_separates;
    found.test.temperature_C.reset();
    if (++temperatures_found == 1 && sign_is_known)
      found.test.temperature_C = number.is_minus ? -number.value : number.value;
  }
  return found;
}

}  // namespace

std::vector<ProposedTest> propose_tests(std::span<std::string const> names) {
  // If one of the names has a double dash, as in "P1--20C", the single dash of "P1-20C" is not a minus sign.
  bool const dash_separates = std::ranges::any_of(names, [](std::string_view name) {
    auto const at = name.find("--");
    return at != std::string_view::npos && at + 2 < name.size() && is_digit(name[at + 2]);
  });
  std::vector<ProposedTest> all;
  std::vector<std::string> devices;  // the devices' names, from the names that state a condition
  for (auto const& name : names) {
    auto found = conditions_in(name, dash_separates);
    auto const last = std::string_view(name).substr(0, found.from).find_last_not_of(separators);
    if (found.from != std::string_view::npos && last != std::string_view::npos) {
      found.test.device = name.substr(0, last + 1);
      devices.push_back(found.test.device);
    }
    all.push_back(std::move(found.test));
  }
  std::ranges::sort(devices, std::greater(), &std::string::size);
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& device = all[i].device;
    if (!device.empty()) continue;
    auto const known = std::ranges::find_if(devices, [&](std::string const& other) {
      return names[i].starts_with(other) && (names[i].size() == other.size() || !is_in_word(names[i][other.size()]));
    });
    device = known != devices.end() ? *known : names[i];
  }
  return all;
}

}  // namespace isolaw::campaign
