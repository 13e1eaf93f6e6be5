// Draws whole devices from a lot's population, for `isolaw sample` and for exported models of several bearings.
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
  std::vector<ParameterFit> const* parameters = nullptr;  // names and units; points into the summary
  std::vector<std::vector<double>> values;                // [device][parameter], in the law's order
  lot::Population const* population = nullptr;
  std::size_t rejected = 0, pulled_back = 0;  // draws thrown away, and devices moved into the limits (lot::Sample)
};

// Where a parameter of the drawn devices comes from. `place` is its index in the population from which it is drawn. If
// `place` is empty, all devices have the same `value`.
struct Column {
  std::optional<std::size_t> place;
  double value = 0.0;
};
std::vector<Column> columns_of(LawResult const& law, laws::LawEntry const& entry);
std::vector<lot::Limits> limits_of(lot::Population const& population, laws::LawEntry const& entry);
void require_draws(int count);  // throws Error about --count unless it is a number of devices that can be drawn
// Draws `count` devices. Device i depends only on the seed, the law and i. Throws Error, with a message that begins
// with `where`, if the law is not in this campaign or has no population.
Draws draw_devices(campaign::Contents const& contents, Summary const& summary, std::string_view law, std::size_t count,
                   std::uint64_t seed, std::string_view where);
std::vector<std::string> warnings(Draws const& draws);   // given if limits or too few tested devices restrict the draws
std::vector<std::string> sentences(Draws const& draws);  // what was drawn, and the warnings

}  // namespace isolaw::study
