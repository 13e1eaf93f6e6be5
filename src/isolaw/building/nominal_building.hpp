// The nominal building over time: its histories and the loops of its bearings, for pages and CSV.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include "isolaw/base/finding.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

// The history of the nominal building under one motion by implicit integration, in at most most_of_history samples. It
// has the displacement of the base's centre of mass relative to the ground, and the sum of the bearings' forces,
// positive along the displacement.
inline constexpr std::size_t most_of_history = 2000;
struct NominalHistory {
  double step_s = 0.0;
  std::vector<double> x_mm = {}, y_mm = {}, shear_x_kN = {}, shear_y_kN = {};
};

// Force-displacement loops of every bearing by implicit integration, in at most most_of_loops samples. The motion is
// the one that moves the nominal building most. The building is the first draw if bearings are drawn, else the nominal
// one.
inline constexpr std::size_t most_of_loops = 500;
struct BearingLoops {
  std::size_t motion = 0;
  bool drawn = false;
  double step_s = 0.0;
  std::vector<double> x_mm = {}, y_mm = {}, rotation_rad = {};        // displacement of the base's centre of mass
  std::vector<std::vector<double>> force_x_kN = {}, force_y_kN = {};  // of each bearing, [bearing][sample]
};

// The response of the nominal building to one motion by implicit integration, and how far two other methods differ from
// it: the integrator that is used for the draws, and equivalent linear analysis.
struct MotionCheck {
  std::string outcome;
  Coupling coupling = Coupling::coupled;
  double step_s = 0.0;
  // Empty if the analysis stopped before its end. `missed_mm` is the error of isolator_mm due to the length of the
  // step, by richardson(). `draws_error_percent` is how far the result of the draws' integrator is from isolator_mm.
  std::optional<double> isolator_mm = {}, balance = {}, missed_mm = {}, draws_error_percent = {};
  // Results of the equivalent linear analysis; `equivalent_mm` is the displacement of the centre. Empty if
  // equivalent_linear() has no result.
  std::optional<double> equivalent_mm = {}, equivalent_error_percent = {}, equivalent_period_s = {},
                        equivalent_damping = {};
  std::vector<Finding> doubts = {};  // about the accuracy of the analysis
};

// The results under one motion that the answers show for the nominal building.
struct NominalResult {
  MotionCheck checked = {};
  NominalHistory history = {};
  // Floor spectra under this motion, [diaphragm][period], divided by the number of motions: the sum over the motions is
  // then the mean.
  std::vector<std::vector<double>> spectra_g = {};
  double farthest_mm = 0.0;  // largest displacement of a bearing; if the run stopped early, the largest until then
};

// A study keeps these results in its store, so that nothing is integrated again if only the limits change. kept_text()
// makes a text that gives back the same numbers. The functions `..._of` read it, and throw nlohmann::json::exception or
// Error for any other text.
std::string kept_text(NominalResult const& result);
std::string kept_text(BearingLoops const& loops);
NominalResult nominal_result_of(std::string_view text);
BearingLoops loops_of(std::string_view text);

// Keeps every n-th sample, with n such that at most most_of_history remain. The last sample may be left out.
NominalHistory thinned(History const& history, double step_s);
// The loops under one motion, of the first drawn building if `drawn`, else of the nominal one.
BearingLoops loops_of(Model const& model, Devices const& devices, Study const& study, std::size_t motion, bool drawn,
                      Options options);

Response nominal_run(Study const& study, LawSource const& source, Motion const& motion);
// A run as CSV: displacement and velocity of the base relative to the ground, force on the bearings, and absolute
// acceleration of every diaphragm, along x and, if the motion has it, y. A failed run ends where it failed.
std::string history_csv(Response const& run, Motion const& motion);

}  // namespace isolaw::building
