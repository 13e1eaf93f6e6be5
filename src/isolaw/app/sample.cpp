#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/lot/population.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::app {

int sample(SampleArguments const& a) {
  constexpr int most = 10'000'000;
  if (a.count < 1 || a.count > most)
    throw Error({.where = "--count", .found = fmt::format("{}", a.count), .allowed = fmt::format("1 to {}", most)});
  auto const& entry = laws::find_law(a.law);
  auto const contents = campaign::Store::read(a.directory / "campaign.sqlite");
  auto const summary = study::build_summary(contents);
  auto const law = std::ranges::find(summary.laws, a.law, &study::LawResult::id);
  auto const where = fmt::format("{}, law {}", a.directory.string(), a.law);
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
  std::vector<lot::Limits> limits;
  for (auto const& name : population.names) {
    auto const& physical = entry.parameters[entry.index_of(name)].physical;
    limits.push_back({physical.lower, physical.upper});
  }
  auto settings = contents.settings;
  campaign::apply(a.seed, settings);
  num::Stream const stream(settings.seed);
  auto const drawn = lot::sample(population, static_cast<std::size_t>(a.count),
                                 stream.split(stable_hash("population")).split(stable_hash(a.law)), limits);

  auto const& parameters = study::parameters_of(*law);
  auto const place = [&](std::string const& name) {
    return static_cast<std::size_t>(std::ranges::find(population.names, name) - population.names.begin());
  };
  std::string text = "device";
  for (auto const& p : parameters) text += "," + render::csv_cell(fmt::format("{} [{}]", p.name, p.unit));
  text += '\n';
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    text += fmt::format("{}", i + 1);
    for (auto const& p : parameters) {
      auto const source = p.tied_to.empty() ? p.name : p.tied_to;
      auto const at = place(source);
      text += fmt::format(",{}", at < population.names.size()                ? drawn.values[i][at]
                                 : law->reduced && source == entry.redundant ? entry.redundant_value
                                                                             : *p.value.best);
    }
    text += '\n';
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  say("{} devices of a population estimated from {}; {} of {} directions have scatter\n", a.count, population.devices,
      population.directions, population.names.size());
  if (drawn.rejected > 0)
    say("{} draws outside the physical limits were drawn again, {} pulled back to the median: the limits shape the "
        "sample\n",
        drawn.rejected, drawn.pulled_back);
  if (!population.note.empty()) say("{}\n", population.note);
  return exit_done;
}

}  // namespace isolaw::app
