#include "isolaw/building/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane/in_plane.hpp"

namespace isolaw::building {
std::string text(Case const& which) {
  switch (which.kind) {
    case CaseKind::nominal:
      return "nominal";
    case CaseKind::lower:
      return "lower";
    case CaseKind::upper:
      return "upper";
    case CaseKind::factor:
      return fmt::format("factor {:.2f}", grid_factor(which.draw));
    case CaseKind::draw:
      return fmt::format("draw {}", which.draw + 1);
    case CaseKind::uncertain:
      return fmt::format("population {} draw {}", which.population + 1, which.draw + 1);
  }
  return {};
}

std::vector<Case> cases_of(Settings const& settings) {
  std::vector<Case> cases{{.kind = CaseKind::nominal}, {.kind = CaseKind::lower}, {.kind = CaseKind::upper}};
  for (std::uint32_t i = 0; i <= 2 * grid_half; ++i) cases.push_back({.kind = CaseKind::factor, .draw = i});
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.draws); ++i)
    cases.push_back({.kind = CaseKind::draw, .draw = i});
  for (std::uint32_t p = 0; p < static_cast<std::uint32_t>(settings.populations); ++p)
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.draws_of_each); ++i)
      cases.push_back({.kind = CaseKind::uncertain, .population = p, .draw = i});
  return cases;
}

lot::Population population_again(lot::Population const& population, num::Stream const& stream,
                                 std::vector<lot::Limits> const& limits) {
  auto of_estimates = population;
  of_estimates.covariance = population.estimates;
  auto const drawn = lot::sample(of_estimates, population.devices, stream, limits);
  std::vector<lot::DeviceEstimate> estimates;
  for (auto const& values : drawn.values) {
    lot::DeviceEstimate estimate{.values = values, .covariance = population.uncertainty};
    auto const unit = [&](std::size_t i) {
      return population.transforms[i] == lot::Transform::logarithm ? values[i] : 1.0;
    };
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < values.size(); ++j) estimate.covariance[i][j] *= unit(i) * unit(j);
    estimates.push_back(std::move(estimate));
  }
  // A parameter that no test determined has the standard deviation 0 in `population`. The new estimate must give it no
  // scatter either.
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < population.std.size(); ++i)
    if (population.std[i] == 0.0) without.push_back(i);
  return lot::estimate_population(population.names, estimates, without);
}

Coupling coupling_under(Motion const& motion, LawSource const& source) {
  bool springs = false;
  for (auto const* values : {&source.lot, &source.median})
    springs = springs || coupling_of(source.law, *values) == Coupling::springs;
  for (auto const& [name, values] : source.devices)
    springs = springs || coupling_of(source.law, values) == Coupling::springs;
  if (!springs) return Coupling::coupled;
  return motion.y_mm_s2.empty() || !laws::springs_follow(source.law) ? Coupling::separate : Coupling::springs;
}

Devices::Devices(LawSource const& source, BuildingFile const& file, Motion const& motion)
    : coupling_(coupling_under(motion, source)),
      source_(coupling_ == Coupling::springs && !source.springs.empty() ? source.springs.front() : source),
      places_(file.bearings),
      settings_(file.settings),
      stream_(num::Stream(static_cast<std::uint64_t>(settings_.seed))
                  .split(stable_hash("building"))
                  .split(stable_hash(source_.law))) {
  auto const where = fmt::format("law {}", source_.law);
  bool const drawn = std::ranges::any_of(places_, [](auto const& p) { return p.kind == BearingKind::draw; });
  if (drawn && !source_.population.has_covariance())
    throw Error({.where = where,
                 .found = source_.population.note.empty() ? "no population, and bearings that are draws of it"
                                                          : source_.population.note,
                 .allowed = "a law that was analysed on two devices or more",
                 .advice = "isolaw calibrate ... --analysis full, or bearings that are \"lot\""});
  for (auto const& p : places_)
    if (p.kind == BearingKind::device && !source_.devices.contains(p.device)) {
      std::vector<std::string> names{"draw", "lot", "lower", "upper"};
      for (auto const& [name, values] : source_.devices) names.push_back(name);
      throw Error({.where = where, .found = fmt::format("no device '{}'", p.device), .allowed = joined(names)});
    }
}

lot::Population const& Devices::reestimated(std::size_t population) const {
  std::call_once(reestimated_->once, [&] {
    for (int p = 0; p < settings_.populations; ++p)
      reestimated_->populations.push_back(population_again(
          source_.population, stream_.split(stable_hash("uncertain")).split(static_cast<std::uint64_t>(p)),
          source_.limits));
  });
  return reestimated_->populations.at(population);
}

std::vector<std::unique_ptr<Bearing>> Devices::bearings(std::vector<double> const& values) const {
  std::vector<std::unique_ptr<Bearing>> devices;
  auto const each = source_.lot.size();
  for (std::size_t j = 0; j * each < values.size(); ++j)
    devices.push_back(make_bearing(source_.law, std::span(values).subspan(j * each, each), coupling_));
  return devices;
}

std::vector<double> Devices::all_parameters(std::vector<double> const& of_population) const {
  auto values = source_.median;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (source_.place[i]) values[i] = of_population[*source_.place[i]];
  return values;
}

std::vector<double> Devices::parameters_of(Case const& which) const {
  auto const draws = static_cast<std::size_t>(std::ranges::count(places_, BearingKind::draw, &BearingPlace::kind));
  std::vector<std::vector<double>> drawn(draws, source_.median);
  auto const draw = [&](lot::Population const& population, num::Stream const& stream) {
    // A re-estimated population may have no scatter. All devices drawn from it then have the median parameters.
    if (draws == 0) return;
    if (!population.has_covariance()) {
      std::ranges::fill(drawn, all_parameters(population.medians));
      return;
    }
    auto const sample = lot::sample(population, draws, stream.split(which.draw), source_.limits);
    for (std::size_t j = 0; j < draws; ++j) drawn[j] = all_parameters(sample.values[j]);
  };
  if (which.kind == CaseKind::draw) draw(source_.population, stream_.split(stable_hash("draw")));
  if (which.kind == CaseKind::uncertain && draws > 0)
    draw(reestimated(which.population), stream_.split(stable_hash("uncertain draw")).split(which.population));
  auto const lower = settings_.lower ? *settings_.lower : source_.lower.value();
  auto const upper = settings_.upper ? *settings_.upper : source_.upper.value();
  PartFactors factors;
  if (which.kind == CaseKind::lower) factors = lower;
  if (which.kind == CaseKind::upper) factors = upper;
  if (which.kind == CaseKind::factor) factors = whole(grid_factor(which.draw));

  std::vector<double> parameters;
  std::size_t next = 0;
  for (auto const& place : places_) {
    auto values = place.kind == BearingKind::draw     ? drawn[next++]
                  : place.kind == BearingKind::device ? source_.devices.at(place.device)
                                                      : source_.lot;
    auto own = factors;
    auto const multiply = [&](PartFactors const& by) { own.elastic *= by.elastic, own.hysteretic *= by.hysteretic; };
    if (place.kind == BearingKind::lower) multiply(lower);
    if (place.kind == BearingKind::upper) multiply(upper);
    if (own.elastic != 1.0 || own.hysteretic != 1.0)
      laws::find_law(source_.law).with_factors(values, own.elastic, own.hysteretic);
    parameters.insert(parameters.end(), values.begin(), values.end());
  }
  return parameters;
}

}  // namespace isolaw::building
