#include "isolaw/study/draws.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::study {

std::vector<Column> columns_of(LawResult const& law, laws::LawEntry const& entry) {
  std::vector<Column> columns;
  for (auto const& p : parameters_of(law)) {
    auto const source = p.tied_to.empty() ? p.name : p.tied_to;
    if (auto const at = place_of(*law.population, source))
      columns.push_back({.place = at});
    else
      columns.push_back(
          {.place = {}, .value = law.reduced && source == entry.redundant ? entry.redundant_value : *p.value.best});
  }
  return columns;
}

std::vector<lot::Limits> limits_of(lot::Population const& population, laws::LawEntry const& entry) {
  std::vector<lot::Limits> limits;
  for (auto const& name : population.names) {
    auto const& physical = entry.parameters[entry.index_of(name)].physical;
    limits.push_back({physical.lower, physical.upper});
  }
  return limits;
}

void require_draws(int count) {
  constexpr int most = 10'000'000;
  if (count < 1 || count > most)
    throw Error({.where = "--count", .found = fmt::format("{}", count), .allowed = fmt::format("1 to {}", most)});
}

Draws draw_devices(campaign::Contents const& contents, Summary const& summary, std::string_view law_id,
                   std::size_t count, std::uint64_t seed, std::string_view place) {
  auto const& entry = laws::find_law(law_id);
  auto const law = std::ranges::find(summary.laws, law_id, &LawResult::id);
  auto const where = fmt::format("{}, law {}", place, law_id);
  if (law == summary.laws.end())
    throw Error({.where = where, .found = "the law is not in this campaign", .allowed = "one of its laws"});
  if (!law->population || !law->population->has_covariance())
    throw Error({.where = where,
                 .found = law->population                    ? law->population->note
                          : contents.device_analyses.empty() ? std::string("no analysis was made")
                                                             : std::string("no parameter of the law is free"),
                 .allowed = "a law that was analysed on two devices or more",
                 .advice = "isolaw calibrate ... --analysis full"});
  auto const& population = *law->population;
  auto const limits = limits_of(population, entry);
  num::Stream const stream(seed);
  auto const drawn =
      lot::sample(population, count, stream.split(stable_hash("population")).split(stable_hash(law_id)), limits);
  Draws draws{.parameters = &parameters_of(*law),
              .values = {},
              .population = &population,
              .rejected = drawn.rejected,
              .pulled_back = drawn.pulled_back};
  auto const columns = columns_of(*law, entry);
  for (auto const& values : drawn.values) {
    auto& device = draws.values.emplace_back();
    for (auto const& column : columns) device.push_back(column.place ? values[*column.place] : column.value);
  }
  return draws;
}

std::vector<std::string> warnings(Draws const& draws) {
  std::vector<std::string> texts;
  if (draws.rejected > 0)
    texts.push_back(fmt::format(
        "{} draws outside the physical limits were drawn again, {} pulled back to the median: the limits shape the sample",
        draws.rejected, draws.pulled_back));
  if (!draws.population->note.empty()) texts.push_back(draws.population->note);
  return texts;
}

std::vector<std::string> sentences(Draws const& draws) {
  auto const& population = *draws.population;
  auto texts = warnings(draws);
  texts.insert(
      texts.begin(),
      fmt::format(
          "{} drawn from a population that was estimated from {} tested devices; their parameters vary in {} of {} independent combinations",
          counted(draws.values.size(), "device"), population.devices, population.directions, population.names.size()));
  return texts;
}

}  // namespace isolaw::study
