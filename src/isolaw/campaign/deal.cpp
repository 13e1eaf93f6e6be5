#include "isolaw/campaign/deal.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace isolaw::campaign {
namespace {

// One step of one candidate in blocks of residuals [0.01 ns], as `isolaw bench` measured it once with 512-bit lanes. It
// only puts runs in order, so that it need not follow the laws' code; and it must not follow a clock.
struct StepCost {
  std::string_view law;
  std::uint64_t cost;
};
constexpr StepCost step_costs[]{
    {"bilinear", 23},
    {"jankowski", 279},
    {"vaiana", 210},
    {"bouc-wen", 587},
    {"abe", 3615},
    {"abe-y0", 743},
    {"hwang-wu", 917},
    {"bwbn", 7042},
    {"gallardo", 777},
    {"history-integral", 134},
    {"kikuchi-aiken", 278},
    {"menegotto-pinto", 368},
    {"ozdemir", 782},
    {"power-masing", 243},
    {"power-masing-viscous", 247},
    {"power-masing-worn", 302},
    {"power-scragging", 214},
    {"ramberg-osgood", 1461},
};
constexpr std::uint64_t of_another_law = 500;

std::uint64_t step_cost(std::string_view law) {
  auto const* const found = std::ranges::find(step_costs, law, &StepCost::law);
  return found == std::end(step_costs) ? of_another_law : found->cost;
}

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
  return step_cost(search.law) * evaluations * contents.devices[search.device].record.size();
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
