#include "isolaw/data/files/sheet_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {

std::string sheet_list(std::vector<std::string> const& names, std::string_view what) {
  std::vector<std::string> texts;
  for (auto const& name : names) texts.push_back(in_quotes(name));
  return names.empty() ? fmt::format("no {}", what) : fmt::format("{} {}", what, shortened(std::move(texts), 30));
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
