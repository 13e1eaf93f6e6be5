// Chooses the parameters of bearings: LawSource holds a law's parameters for the lot and its devices, and Devices makes
// the bearings of each analysis from it. A device's parameters are never mixed with another's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/lot/population.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::building {

// The lists of parameters (`lot`, `devices`, `median`) are in the law's order and units.
struct LawSource {
  std::string law;
  std::vector<double> lot;                             // the one set of parameters for all devices of the lot
  std::map<std::string, std::vector<double>> devices;  // the parameters of each tested device, by its name
  lot::Population population;                          // bearings are drawn from it, if it has a covariance
  // For each parameter its index in the population; nullopt if all devices have the parameter's value in `median`.
  std::vector<std::optional<std::size_t>> place;
  std::vector<double> median;
  std::vector<lot::Limits> limits;  // physical limits of each parameter of the population
  double tested_mm = 0.0;           // largest displacement in the tests; 0 if it is not known
  std::vector<LawSource> springs;   // the law as it was fitted as springs around a circle; empty without such a fit
  // Factors on the law's forces that give the bounds over the design conditions of the lot. Empty if the building file
  // states factors of its own.
  std::optional<PartFactors> lower = {}, upper = {};
  std::vector<Finding> doubts = {};  // for reports: doubts about the law's calibration and its bounds
};

// Which bearings an analysis has. A bearing that is not drawn at random has the same parameters in all kinds of
// analysis, but `lower`, `upper` and `factor` multiply its forces too.
enum class CaseKind {
  nominal,   // bearings that would be drawn at random have the population's median parameters
  lower,     // as nominal, with all forces times Settings::lower
  upper,     // as nominal, with all forces times Settings::upper
  factor,    // as nominal, with all forces times grid_factor(draw)
  draw,      // each bearing to be drawn has parameters of its own, drawn from the population
  uncertain  // as draw, but from a population estimated again (population_again)
};
struct Case {
  CaseKind kind = CaseKind::nominal;
  std::uint32_t population = 0, draw = 0;
  bool operator==(Case const&) const = default;
};
// The factors of CaseKind::factor: from 0.60 to 1.40 in steps of 0.02, grid_half on each side of 1.
inline constexpr std::uint32_t grid_steps_to_1 = 50, grid_half = 20;
inline constexpr double grid_step = 1.0 / grid_steps_to_1;
inline double grid_factor(std::uint32_t i) {
  return static_cast<double>(grid_steps_to_1 - grid_half + i) / grid_steps_to_1;
}

// The name of a case: "nominal", "factor 0.60", "draw 7", "population 2 draw 7". The numbers count from 1.
std::string text(Case const& which);
// All analyses of a law under one motion, in the order in which the store counts them.
std::vector<Case> cases_of(Settings const& settings);
// How the law acts in the plane under a motion. Coupling::coupled if all its parameter sets have a coupled form. If
// not, Coupling::separate under a motion along x alone and for a law that springs do not reproduce
// (laws::springs_follow), else Coupling::springs. The choice depends on the law and on this motion only, so the
// response to the motion does not depend on the other motions of the study.
Coupling coupling_under(Motion const& motion, LawSource const& source);

// The bearings of one law under one motion. A random number depends on (seed, law, population, draw, bearing) only.
class Devices {
 public:
  // Throws Error if a bearing is to be drawn but the law has no population with a covariance, or for an unknown device.
  Devices(LawSource const& source, BuildingFile const& file, Motion const& motion);

  LawSource const& source() const { return source_; }
  Coupling coupling() const { return coupling_; }  // how the law acts in the plane, the same for all bearings
  std::vector<std::unique_ptr<Bearing>> bearings(std::vector<double> const& values) const;
  // The parameters of all bearings in a case, those of the first bearing first.
  std::vector<double> parameters_of(Case const& which) const;

 private:
  // The populations of CaseKind::uncertain (population_again()). All copies of a Devices object share them, and the
  // first copy that needs them computes them.
  struct ReestimatedPopulations {
    std::once_flag once;
    std::vector<lot::Population> populations;
  };
  lot::Population const& reestimated(std::size_t population) const;
  std::vector<double> all_parameters(std::vector<double> const& of_population) const;

  Coupling coupling_;
  LawSource source_;
  std::vector<BearingPlace> places_;
  Settings settings_;
  num::Stream stream_;
  std::shared_ptr<ReestimatedPopulations> reestimated_ = std::make_shared<ReestimatedPopulations>();
};

// Parametric bootstrap: estimates the population again from as many devices as were tested, drawn from N(mu, S), the
// distribution of the fitted values. Each drawn device gets the mean uncertainty of the real fits.
lot::Population population_again(lot::Population const& population, num::Stream const& stream,
                                 std::vector<lot::Limits> const& limits);

}  // namespace isolaw::building
