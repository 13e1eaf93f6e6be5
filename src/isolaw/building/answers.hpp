// Computes the answers of a building study from its stored runs. A draw is a building with bearings drawn at random
// from the lot. Its response is the mean over the motions, as in design. The distributions under each motion are kept
// too.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/coverage.hpp"
#include "isolaw/building/distribution.hpp"
#include "isolaw/building/limits.hpp"
#include "isolaw/building/nominal_building.hpp"
#include "isolaw/building/quantities.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

struct LawAnswer {
  std::string law;
  // How the law acts in the plane. If this differs between the motions, `coupling` is springs and `mixed` is true; the
  // law then acts as `separate` under motions along x alone.
  Coupling coupling = Coupling::coupled;
  bool mixed = false;
  bool fitted_as_springs = false;           // true if the law acts as springs whose parameters were fitted for springs
  std::size_t draws = 0;                    // number of drawn buildings; 0 if no bearing is drawn
  std::size_t runs = 0, failed = 0;         // number of all runs, and of those whose numbers are not finite
  std::size_t collapsed = 0;                // number of draws with a failed run; they count as outside of all bounds
  double worst_balance = 0.0;               // largest relative error of a run's energy balance (plausibility.hpp)
  std::vector<Distribution> distributions;  // one for each quantity, in the order of quantities()
  std::vector<Coverage> coverage;  // one for each quantity that bound analyses can cover (Quantity); none without draws
  // The largest displacement of a bearing, taken over the motions as building codes do for design (see LimitCheck). Its
  // `allowed` is infinite.
  LimitCheck design_displacement = {};
  std::vector<LimitCheck> limit_checks;  // one for each limit of the building file, and one for the tested displacement
  std::vector<Finding> doubts;           // about the law's calibration
  // The share of this law's draws whose bearing displacement lies between the bounds of the study's first law with a
  // result. It says how well the bound analyses of another law would cover this law. Empty for that first law and
  // without draws.
  std::optional<double> by_first_bounds;
  std::vector<MotionCheck> checked;
  std::vector<NominalHistory> histories;  // of the nominal building under each motion
  // For each bearing its largest displacement, and its share of the work on all bearings. Both are means over draws and
  // motions or, without draws, means over the motions of the nominal building. NaN if fewer than least_finite_share of
  // these runs have finite numbers.
  std::vector<double> bearing_mm, bearing_energy_share;
  BearingLoops loops = {};
  // Floor spectra in g, [diaphragm, the base first][period of spectrum_periods_s()].
  std::vector<std::vector<double>> floor_spectra_g = {};
};

// Returns "coupled", "separate" or "springs".
std::string_view name(Coupling coupling);
// Says how the law acts in the plane: name(law.coupling), or "springs as given" if the springs have the parameters of
// the law in one direction because none were fitted for springs.
std::string_view form(LawAnswer const& law);
// has_result() says whether any run of the law gave finite numbers. If none did, why_without_result() returns the
// clause that says so, for example "none of its 364 analysis runs gave finite numbers".
bool has_result(LawAnswer const& law);
std::string why_without_result(LawAnswer const& law);

struct Answers {
  std::vector<LawAnswer> laws;
  double weight_kN = 0.0;
  std::vector<double> fixed_periods_s;
  // Standard deviation over the laws of ln(median bearing displacement), comparable with Distribution::lot_std_ln.
  std::optional<double> law_std_ln;
  std::vector<Finding> verdict;  // whether the building keeps its limits, how far it moves, and what this depends on
  // Whether the building keeps its limits. nullopt if the file sets no limit, if the draws are too few to tell, or if
  // bearings may move farther than in the tests.
  std::optional<bool> holds;
  std::vector<Finding> about_bounds;  // whether the bound analyses cover the draws
  // Whether the bound analyses cover enough of the draws. nullopt if no bearing is drawn or the draws are too few.
  std::optional<bool> bounds_are_enough;
  std::vector<Finding> warnings;     // about the analyses of the building
  std::vector<Finding> calibration;  // doubts about the laws' calibration, without repetitions
  std::vector<std::string> assumed;  // the assumptions of the study, one sentence for each
  std::vector<Point> corners;        // corners of the base slab; the largest displacement of a corner is measured there
};
// Integrates the nominal building of each law. Throws InterruptedRun once `interrupted` returns true.
Answers answer(Study const& study, RunStore const& store, std::function<bool()> const& interrupted = {});
// Judges the nominal buildings alone: fills in `verdict`, `holds`, and `limit_checks` of each law. `measured` holds the
// measures of their runs, [law][motion][measure]; a run that was not completed has none.
Answers answer_of_nominal(Study const& study, std::vector<std::vector<std::vector<double>>> const& measured);

}  // namespace isolaw::building
