#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/analysis/determination.hpp"

namespace isolaw::analysis {
namespace {

std::string listed(std::vector<std::string> const& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

std::string trade_off_sentence(std::vector<std::string> const& names, std::span<double const> change) {
  if (names.size() == 1) return fmt::format("{} does not act on this record", names[0]);
  if (names.size() == 2) {
    constexpr double equal = 0.1;
    double const sum = std::abs(change[0] + change[1]), difference = std::abs(change[0] - change[1]);
    if (sum < equal) return fmt::format("{} trade off: only their product shapes the loop", listed(names));
    if (difference < equal) return fmt::format("{} trade off: only their ratio shapes the loop", listed(names));
  }
  auto const largest = static_cast<std::size_t>(
      std::ranges::max_element(change, {}, [](double c) { return std::abs(c); }) - change.begin());
  std::vector<std::string> others;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != largest) others.push_back(fmt::format("{} {:+.2g} %", names[i], 10.0 * change[i] / change[largest]));
  return fmt::format("{} trade off: {} +10 % is undone by {}", listed(names), names[largest], listed(others));
}

}  // namespace isolaw::analysis
