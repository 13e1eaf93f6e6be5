#include "isolaw/wording/words.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/base/number_text.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::wording {

std::string enumerate(std::vector<std::string> const& names, std::size_t most) {
  std::string text;
  std::size_t const shown = names.size() <= most ? names.size() : std::max<std::size_t>(most, 2) - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

std::string with_decimals(double value, int decimals) {
  constexpr double largest = 1e6;
  return std::abs(value) < largest ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.3g}", value);
}

std::string percent(double fraction) {
  double const value = 100.0 * fraction;
  return with_decimals(value, std::abs(value) < 9.95 ? 1 : 0) + " %";
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 32);
  return text;
}

std::string law_name(Finding const& finding) {
  return finding.law.empty() ? std::string() : std::string(laws::display_name(finding.law));
}

std::string range(Group group, std::string_view name, int digits) {
  return range(group, name, [&](double value) { return number_text(value, digits); });
}

}  // namespace isolaw::wording
