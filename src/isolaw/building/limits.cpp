#include "isolaw/building/limits.hpp"

#include <algorithm>
#include <cmath>
#include "isolaw/building/coverage.hpp"

namespace isolaw::building {
namespace {

// [case] the response for design; NaN if the building collapsed under a motion.
std::vector<double> for_design(Responses const& responses) {
  if (responses.by_motion.size() >= motions_for_a_mean) return responses.mean;
  auto most = responses.by_motion.front();
  for (auto const& motion : responses.by_motion)
    for (std::size_t c = 0; c < most.size(); ++c)
      if (!(motion[c] <= most[c])) most[c] = std::isnan(most[c]) ? most[c] : motion[c];
  return most;
}

}  // namespace

std::string_view name(Keeps keeps) {
  return keeps == Keeps::yes ? "yes" : keeps == Keeps::no ? "no" : "open";
}

Judged judged(std::string_view limit, std::string_view quantity, double allowed, Responses const& responses,
              CasePlaces const& places, bool has_draws) {
  auto const values = for_design(responses);
  Judged found{.limit = limit,
               .quantity = quantity,
               .allowed = allowed,
               .nominal = values[0],
               .bound = std::max(values[1], values[2]),
               .p95 = {},
               .kept = {},
               .kept_low = {},
               .kept_high = {}};
  bool const holds_without_draws = values[0] <= allowed && values[1] <= allowed && values[2] <= allowed;
  found.keeps = holds_without_draws ? Keeps::yes : Keeps::no;
  if (!has_draws) return found;
  auto const draws = finite_part(values, places.first_draw, places.draws);
  found.p95 = fractiles(draws).back();
  auto const kept =
      static_cast<std::size_t>(std::ranges::count_if(draws, [&](double value) { return value <= allowed; }));
  auto const [low, high] = binomial_interval(kept, places.draws);
  found.kept = static_cast<double>(kept) / static_cast<double>(places.draws);
  found.kept_low = low, found.kept_high = high;
  if (holds_without_draws)
    found.keeps = *found.kept < wanted_share ? Keeps::no : low >= wanted_share ? Keeps::yes : Keeps::open;
  return found;
}

}  // namespace isolaw::building
