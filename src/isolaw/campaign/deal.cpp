#include "isolaw/campaign/deal.hpp"

#include <algorithm>
#include <tuple>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::campaign {

std::uint64_t relative_cost(Contents const& contents, Search const& search) {
  auto const& settings = contents.settings;
  auto const free = std::max<std::uint64_t>(search.box.free_count(), 1);
  // Populations are of one size, descents take evaluations by the square of the free parameters (see estimate.hpp).
  auto const evaluations = settings.method == Method::genetic ? 1 : free * free;
  return laws::find_law(search.law).info.step_cost * evaluations * contents.devices[search.device].record.size();
}

Deal::Deal(Contents const& contents, int parts) : runs_(static_cast<std::size_t>(contents.settings.runs)) {
  std::vector<std::tuple<std::uint64_t, std::size_t>> searches;  // by cost, the dearest first
  for (std::size_t s = 0; s < contents.searches.size(); ++s)
    if (contents.searches[s].refusal.empty()) searches.emplace_back(relative_cost(contents, contents.searches[s]), s);
  std::ranges::stable_sort(searches, [](auto const& a, auto const& b) { return std::get<0>(a) > std::get<0>(b); });
  part_.resize(contents.searches.size() * runs_);
  int next = 0;
  for (auto const& [cost, search] : searches)
    for (std::size_t run = 0; run < runs_; ++run) {
      part_[search * runs_ + run] = next + 1;
      next = (next + 1) % parts;
    }
}

}  // namespace isolaw::campaign
