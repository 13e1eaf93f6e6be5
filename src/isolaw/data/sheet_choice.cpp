#include "isolaw/data/sheet_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/text.hpp"

namespace isolaw::data {

std::string sheet_list(std::vector<std::string> const& names, std::string_view what) {
  constexpr std::size_t shown = 30;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) texts.push_back(in_quotes(names[i]));
  if (names.size() > shown) texts.push_back(fmt::format("and {} more", names.size() - shown));
  return names.empty() ? fmt::format("no {}", what) : fmt::format("{} {}", what, fmt::join(texts, ", "));
}

std::size_t choose_sheet(std::string const& wanted, std::vector<std::string> const& names, std::string const& file,
                         std::string_view what) {
  auto const position = [&](auto matches) {
    auto const found = std::ranges::find_if(names, matches);
    return static_cast<std::size_t>(found - names.begin());
  };
  if (auto const exact = position([&](auto const& name) { return name == wanted; }); exact < names.size()) return exact;
  auto const small = lower(trimmed(wanted));
  auto const alike = [&](auto const& name) { return lower(trimmed(name)) == small; };
  if (std::ranges::count_if(names, alike) == 1) return position(alike);
  auto const number = number_in<std::size_t>(wanted);
  if (number && *number >= 1 && *number <= names.size()) return *number - 1;
  throw Error(Complaint{.where = file,
                        .found = fmt::format("no {} {}", what, in_quotes(wanted)),
                        .allowed = sheet_list(names, fmt::format("{}s", what)),
                        .advice = "--sheet NAME, or its number"});
}

std::string sheet_key(std::vector<std::string> const& names, std::size_t index) {
  constexpr std::size_t longest = 200;
  auto const& name = names[index];
  bool const plain = is_printable(name) && !name.empty() && name.size() <= longest;
  return plain && std::ranges::count(names, name) == 1 ? name : std::to_string(index + 1);
}

}  // namespace isolaw::data
