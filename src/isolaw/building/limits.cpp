#include "isolaw/building/limits.hpp"

#include <algorithm>
#include <cmath>
#include "isolaw/building/coverage.hpp"

namespace isolaw::building {
namespace {

// The response for design (see LimitCheck) in each case. NaN if the building collapsed under a motion.
std::vector<double> for_design(Responses const& responses) {
  if (responses.by_motion.size() >= motions_for_a_mean) return responses.mean;
  auto most = responses.by_motion.front();
  for (auto const& motion : responses.by_motion)
    for (std::size_t c = 0; c < most.size(); ++c)
      if (!(motion[c] <= most[c])) most[c] = std::isnan(most[c]) ? most[c] : motion[c];
  return most;
}

}  // namespace

std::string_view name(LimitKept keeps) {
  return keeps == LimitKept::yes ? "yes" : keeps == LimitKept::no ? "no" : "open";
}

LimitCheck check_limit(std::string_view limit, std::string_view quantity, double allowed, Responses const& responses,
                       CasePlaces const* places, bool has_draws) {
  auto const values = for_design(responses);
  LimitCheck found{.limit = limit,
                   .quantity = quantity,
                   .allowed = allowed,
                   .nominal = values[0],
                   .bound = {},
                   .p95 = {},
                   .share_kept = {},
                   .share_kept_low = {},
                   .share_kept_high = {}};
  if (places)
    found.bound = std::isnan(values[1])   ? values[1]
                  : std::isnan(values[2]) ? values[2]
                                          : std::max(values[1], values[2]);
  if (!(found.nominal <= allowed))
    found.broken_by = std::isnan(found.nominal) ? "nominal failed" : "nominal";
  else if (found.bound && !(*found.bound <= allowed))
    found.broken_by = std::isnan(*found.bound) ? "bounds failed" : "bounds";
  found.limit_kept = found.broken_by.empty() ? LimitKept::yes : LimitKept::no;
  if (!places || !has_draws) return found;
  auto const draws = part_of(values, places->first_draw, places->draws);
  found.p95 = fractiles(draws).back();
  auto const kept =
      static_cast<std::size_t>(std::ranges::count_if(draws, [&](double value) { return value <= allowed; }));
  auto const [low, high] = binomial_interval(kept, draws.size());
  found.share_kept = static_cast<double>(kept) / static_cast<double>(draws.size());
  found.share_kept_low = low, found.share_kept_high = high;
  if (!found.broken_by.empty()) return found;
  found.limit_kept = *found.share_kept < wanted_share ? LimitKept::no
                     : low >= wanted_share            ? LimitKept::yes
                                                      : LimitKept::open;
  if (found.limit_kept == LimitKept::no) found.broken_by = "draws";
  if (found.limit_kept == LimitKept::open) found.draws_wanted = draws_that_tell(kept, draws.size());
  return found;
}

}  // namespace isolaw::building
