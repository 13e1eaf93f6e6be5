#include "isolaw/campaign/deal.hpp"

#include <algorithm>
#include <tuple>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::campaign {
namespace {

// Searches that were not refused.
std::vector<std::tuple<std::uint64_t, std::size_t>> dearest_first(Contents const& contents) {
  std::vector<std::tuple<std::uint64_t, std::size_t>> searches;
  for (std::size_t s = 0; s < contents.searches.size(); ++s)
    if (contents.searches[s].refusal.empty()) searches.emplace_back(relative_cost(contents, contents.searches[s]), s);
  std::ranges::stable_sort(searches, [](auto const& a, auto const& b) { return std::get<0>(a) > std::get<0>(b); });
  return searches;
}

}  // namespace

std::uint64_t relative_cost(Contents const& contents, Search const& search) {
  auto const& settings = contents.settings;
  auto const free = std::max<std::uint64_t>(search.box.free_count(), 1);
  // Populations are of one size, descents take evaluations by the square of the free parameters (see estimate.hpp).
  auto const evaluations = settings.method == Method::genetic ? 1 : free * free;
  return laws::find_law(search.law).info.step_cost * evaluations * contents.devices[search.device].record.size();
}

Deal::Deal(Contents const& contents, int parts) : runs_(static_cast<std::size_t>(contents.settings.runs)) {
  part_.resize(contents.searches.size() * runs_);
  int next = 0;
  for (auto const& [cost, search] : dearest_first(contents))
    for (std::size_t run = 0; run < runs_; ++run) {
      part_[search * runs_ + run] = next + 1;
      next = (next + 1) % parts;
    }
}

std::vector<int> deal_of_analyses(Contents const& contents, int parts) {
  std::vector<int> part(contents.searches.size(), 0);
  std::vector<std::uint64_t> load(static_cast<std::size_t>(parts), 0);
  for (auto const& [cost, search] : dearest_first(contents)) {
    auto const least = std::ranges::min_element(load);
    *least += cost;
    part[search] = static_cast<int>(least - load.begin()) + 1;
  }
  return part;
}

}  // namespace isolaw::campaign
