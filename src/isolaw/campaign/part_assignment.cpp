#include "isolaw/campaign/part_assignment.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::campaign {
namespace {

using Costs = std::vector<std::tuple<std::uint64_t, std::size_t>>;

Costs in_order(Costs costs) {  // costliest first
  std::ranges::stable_sort(costs, [](auto const& a, auto const& b) { return std::get<0>(a) > std::get<0>(b); });
  return costs;
}

Costs dearest_first(Contents const& contents) {  // costs of the searches that were not refused, the costliest first
  Costs searches;
  for (std::size_t s = 0; s < contents.searches.size(); ++s)
    if (contents.searches[s].refusal.empty()) searches.emplace_back(relative_cost(contents, contents.searches[s]), s);
  return in_order(std::move(searches));
}

// Assigns each item, from 0 to count - 1, to the part with the least load so far. An item that is not in `costs` gets 0
// instead of a part's number.
std::vector<int> even_by_cost(Costs const& costs, std::size_t count, int parts) {
  std::vector<int> part(count, 0);
  std::vector<std::uint64_t> load(static_cast<std::size_t>(parts), 0);
  for (auto const& [cost, i] : costs) {
    auto const least = std::ranges::min_element(load);
    *least += cost;
    part[i] = static_cast<int>(least - load.begin()) + 1;
  }
  return part;
}

}  // namespace

std::uint64_t relative_cost(Contents const& contents, Search const& search) {
  auto const& settings = contents.settings;
  auto const free = std::max<std::uint64_t>(search.box.free_count(), 1);
  // With the genetic algorithm every law takes the same number of evaluations. With descents the number grows with the
  // square of the number of free parameters (see estimate.cpp).
  auto const evaluations = settings.method == Method::genetic ? 1 : free * free;
  return laws::find_law(search.law).info.step_cost * evaluations * contents.devices[search.device].record.size();
}

RunAssignment::RunAssignment(Contents const& contents, int parts)
    : runs_(static_cast<std::size_t>(contents.settings.runs)) {
  part_.resize(contents.searches.size() * runs_);
  int next = 0;
  for (auto const& [cost, search] : dearest_first(contents))
    for (std::size_t run = 0; run < runs_; ++run) {
      part_[search * runs_ + run] = next + 1;
      next = (next + 1) % parts;
    }
}

std::vector<int> assign_analyses(Contents const& contents, int parts) {
  return even_by_cost(dearest_first(contents), contents.searches.size(), parts);
}

std::vector<int> assign_laws(Contents const& contents, int parts) {
  auto const& laws = contents.settings.laws;
  Costs costs;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    std::uint64_t cost = 0;
    for (auto const& search : contents.searches)
      if (search.law == laws[i] && search.refusal.empty()) cost += relative_cost(contents, search);
    costs.emplace_back(cost, i);
  }
  return even_by_cost(in_order(std::move(costs)), laws.size(), parts);
}

}  // namespace isolaw::campaign
