#include "isolaw/campaign/contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <tuple>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/signals/copies.hpp"

namespace isolaw::campaign {
namespace {

using Key = std::tuple<std::size_t, std::string_view>;

}  // namespace

fit::SearchBox box_of(Search const& search, Run const& run) {
  auto box = search.first_box;
  for (std::size_t i = 0; 2 * i + 1 < run.box.size() && i < box.parameters.size(); ++i) {
    box.parameters[i].lower = run.box[2 * i];
    box.parameters[i].upper = run.box[2 * i + 1];
  }
  return box;
}

Part parse_part(std::string_view text) {
  auto const slash = text.find('/');
  auto const number = number_in<int>(text.substr(0, slash));
  auto const of = slash == std::string_view::npos ? std::nullopt : number_in<int>(text.substr(slash + 1));
  if (!number || !of || *number < 1 || *number > *of || *of > most_parts)
    throw Error({.where = "--part",
                 .found = in_quotes(std::string(text)),
                 .allowed = fmt::format("K/N, part K of N: K from 1 to N, N up to {}", most_parts),
                 .advice = "--part 1/4 to --part 4/4, for four machines"});
  return {*number, *of};
}

std::string text(Part const& part) {
  return fmt::format("{}/{}", part.number, part.total);
}

std::string_view name(Outcome outcome) {
  static constexpr std::array<std::string_view, 6> names{"confirmed", "budget_spent",    "all_generations",
                                                         "stagnated", "no_finite_value", "interrupted"};
  return names.at(static_cast<std::size_t>(outcome));
}

std::size_t Contents::expected_runs() const {
  std::size_t expected = 0;
  for (auto const& search : searches) expected += search.refusal.empty() ? static_cast<std::size_t>(settings.runs) : 0;
  return expected;
}

std::size_t Contents::expected_here() const {
  auto const all = expected_runs();
  if (!part) return all;
  // The parts get the runs in turn (part_assignment.hpp), so the first parts may have one run more.
  auto const number = static_cast<std::size_t>(part->number), total = static_cast<std::size_t>(part->total);
  return all < number ? 0 : (all - number) / total + 1;
}

std::size_t Contents::expected_analyses() const {
  if (!settings.analysis) return 0;
  std::size_t expected = 0;
  std::map<std::string_view, std::size_t> counting;
  for (auto const& search : searches) {
    if (best_run(search.device, search.law) == nullptr) continue;
    ++expected;
    if (devices[search.device].counts()) ++counting[search.law];
  }
  for (auto const& [law, count] : counting) expected += count > 1 ? 1 + count : 0;
  return expected;
}

Run const* Contents::best_run(std::size_t device, std::string_view law) const {
  Run const* best = nullptr;
  auto const [first, last] = std::ranges::equal_range(runs, Key(device, law), {}, by_device_and_law);
  for (auto run = first; run != last; ++run)
    if (run->usable() && (best == nullptr || run->objective < best->objective)) best = &*run;
  return best;
}

void Contents::take_boxes_of_best_runs() {
  for (auto& search : searches) {
    auto const* best = best_run(search.device, search.law);
    search.box = best != nullptr ? box_of(search, *best) : search.first_box;
  }
}

void Contents::find_copies() {
  std::vector<data::TestRecord const*> records;
  for (auto& device : devices) {
    device.copy_of.clear();
    records.push_back(&device.raw);
  }
  for (auto const& group : data::groups_of_copies(records)) {
    auto const first = [&](auto const& is_preferred) {
      auto const found =
          std::ranges::find_if(group, [&](std::size_t d) { return devices[d].usable() && is_preferred(devices[d]); });
      return found == group.end() ? std::nullopt : std::optional(*found);
    };
    auto counting =
        first([](Device const& device) { return data::cyclic_properties(device.raw).reported.has_value(); });
    if (!counting) counting = first([](Device const&) { return true; });
    for (auto const d : group)
      if (d != counting.value_or(group.front())) devices[d].copy_of = devices[counting.value_or(group.front())].name;
  }
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
