// Where the parameters of bearings come from: for each law what its lot is (LawSource), and the sets of parameters that
// a building takes of it, each whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/lot/population.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::building {

// Parameters in the law's order and units.
struct LawSource {
  std::string law;
  std::vector<double> lot;                             // the law of the lot
  std::map<std::string, std::vector<double>> devices;  // tested ones, by name
  lot::Population population;                          // without medians: no bearing may be a draw
  // Of each parameter its place in the population; none: the value of `median` holds for all.
  std::vector<std::optional<std::size_t>> place;
  std::vector<double> median;
  std::vector<lot::Limits> limits;   // of the population's parameters
  double tested_mm = 0.0;            // largest displacement of the tests; 0: not known
  bool as_springs = false;           // all of them were fitted as springs around the circle
  std::vector<Finding> doubts = {};  // findings against it; numbers do not depend on them
};

// The same device, its forces `factor` times as large.
std::vector<double> with_force(std::string_view law, std::vector<double> parameters, double factor);

// What a building's bearings are in one analysis.
enum class CaseKind {
  nominal,  // draws are the population's median
  lower,    // the same, forces times the factors of the bound analyses
  upper,
  factor,    // the same, forces times one of factor_grid()
  draw,      // every bearing that is a draw a device of its own
  uncertain  // the same, of a population as uncertain as the tests leave it
};
struct Case {
  CaseKind kind = CaseKind::nominal;
  std::uint32_t population = 0, draw = 0;
  bool operator==(Case const&) const = default;
};
inline constexpr double grid_step = 0.02;
inline constexpr std::uint32_t grid_half = 20;
inline double grid_factor(std::uint32_t i) {
  return 1.0 + grid_step * (static_cast<double>(i) - static_cast<double>(grid_half));
}

std::string text(Case const& which);  // "nominal", "factor 0.60", "draw 7", "population 2 draw 7"; counted from 1

// All analyses of a law under one motion, in the order of stores.
std::vector<Case> cases_of(Settings const& settings);

// How a law goes into the plane in a building: coupled where all its sets of parameters have such a form.
Coupling coupling_in(BuildingFile const& file, LawSource const& source);

// Makes the sets of parameters of one law. A number depends on (seed, law, population, draw, bearing) alone.
class Devices {
 public:
  // Throws Error: a bearing is a draw of a law without population, or a device that was not tested. Under motions along x
  // alone a law that has no coupled form is itself, not springs around the circle.
  Devices(LawSource source, BuildingFile const& file);

  LawSource const& source() const { return source_; }
  Coupling coupling() const { return coupling_; }  // the same for all of them
  // The bearings of one analysis.
  std::vector<std::unique_ptr<Bearing>> bearings(std::vector<double> const& values) const;
  // [bearing][parameter]
  std::vector<double> of(Case const& which) const;

 private:
  std::vector<double> full(std::vector<double> const& of_population) const;

  LawSource source_;
  std::vector<BearingPlace> places_;
  Settings settings_;
  num::Stream stream_;
  Coupling coupling_ = Coupling::coupled;
  std::vector<lot::Population> uncertain_;
};

// Of as many devices as were tested, drawn from the estimates' own distribution N(mu, S) and estimated again with the
// same uncertainty: what another lot of tests of the same production might have said (a parametric bootstrap).
lot::Population population_again(lot::Population const& population, num::Stream const& stream,
                                 std::vector<lot::Limits> const& limits);

}  // namespace isolaw::building
