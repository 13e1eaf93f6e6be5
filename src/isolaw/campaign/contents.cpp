#include "isolaw/campaign/contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <tuple>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

using Key = std::tuple<std::size_t, std::string_view>;

}  // namespace

std::string_view name(Outcome outcome) {
  // In the order of Outcome.
  static constexpr std::array<std::string_view, 6> names{"confirmed", "budget_spent",    "all_generations",
                                                         "stagnated", "no_finite_value", "interrupted"};
  return names.at(static_cast<std::size_t>(outcome));
}

std::size_t Contents::expected_runs() const {
  std::size_t expected = 0;
  for (auto const& search : searches) expected += search.refusal.empty() ? static_cast<std::size_t>(settings.runs) : 0;
  return expected;
}

std::size_t Contents::expected_analyses() const {
  if (!settings.analysis) return 0;
  std::map<std::string_view, std::size_t> usable;
  for (auto const& search : searches)
    if (best_run(search.device, search.law) != nullptr) ++usable[search.law];
  std::size_t expected = 0;
  for (auto const& [law, count] : usable) expected += count + (count > 1 ? 1 + count : 0);
  return expected;
}

Run const* Contents::best_run(std::size_t device, std::string_view law) const {
  Run const* best = nullptr;
  auto const [first, last] = std::ranges::equal_range(runs, Key(device, law), {}, by_device_and_law);
  for (auto run = first; run != last; ++run)
    if (run->usable() && (best == nullptr || run->objective < best->objective)) best = &*run;
  return best;
}

DeviceAnalysis const* Contents::analysis_of(std::size_t device, std::string_view law) const {
  auto const found = std::ranges::lower_bound(device_analyses, Key(device, law), {}, by_device_and_law);
  return found != device_analyses.end() && by_device_and_law(*found) == Key(device, law) ? &*found : nullptr;
}

std::optional<std::size_t> Contents::device_or_lot(std::string_view name) const {
  if (auto const found = std::ranges::find(devices, name, &Device::name); found != devices.end())
    return static_cast<std::size_t>(found - devices.begin());
  if (name == whole_lot) return std::nullopt;
  constexpr std::size_t shown = 30;
  std::vector<std::string> names{std::string(whole_lot)};
  for (auto const& device : devices | std::views::take(shown)) names.push_back(device.name);
  throw Error(
      {.where = fmt::format("device '{}'", name),
       .found = "not in this campaign",
       .allowed = joined(names) + (devices.size() > shown ? fmt::format(" and {} more", devices.size() - shown) : "")});
}

}  // namespace isolaw::campaign
