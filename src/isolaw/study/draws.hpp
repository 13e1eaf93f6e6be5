// Devices of a lot's population, drawn whole: what `isolaw sample` prints, and a model of several bearings is made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Draws {
  std::vector<ParameterFit> const* parameters = nullptr;  // names and units of the columns, of the summary
  std::vector<std::vector<double>> values;                // [device][parameter], in the law's order
  lot::Population const* population = nullptr;
  std::size_t rejected = 0, pulled_back = 0;  // as lot::Sample
};

// Of each parameter of the law where its value comes from: a place in the population, or a value that holds for all.
struct Column {
  std::optional<std::size_t> place;
  double value = 0.0;
};
// Of a law with a population.
std::vector<Column> columns_of(LawResult const& law, laws::LawEntry const& entry);
// What the population's parameters may be.
std::vector<lot::Limits> limits_of(lot::Population const& population, laws::LawEntry const& entry);

// `count` devices; number i depends on seed, law and i alone. `where` begins the messages. Throws Error: the law is not
// of this campaign, or has no population.
Draws draw_devices(campaign::Contents const& contents, Summary const& summary, std::string_view law, std::size_t count,
                   std::uint64_t seed, std::string_view where);

// What is to be said of how they were drawn.
std::vector<std::string> sentences(Draws const& draws);

}  // namespace isolaw::study
