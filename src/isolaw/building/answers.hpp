// What the analyses of a building say, in numbers: distributions, variance, coverage of the bound analyses, law against
// law, and the hand method beside them. Each number is a row with its name, unit and meaning.
//
// A response of one draw is its mean over the motions, as designs take it; what single motions give stands beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

struct Quantity {
  std::string_view key, title, unit, meaning;
  double (*of)(Layout const& layout, std::span<double const> measured, double weight_kN);
  std::string_view uncovered = {};  // why the bound analyses say nothing of its draws; empty: they do
};
std::span<Quantity const> quantities();
Quantity const& quantity(std::string_view key);

inline constexpr std::array shares{0.16, 0.50, 0.84, 0.95};

// Equal bins from the least of the draws to the most; one bin where they are the same.
struct Histogram {
  double from = 0.0, width = 0.0;
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::vector<double> const& values);

struct Distribution {
  double nominal = 0.0, lower = 0.0, upper = 0.0;  // of the analyses without draws, means over motions
  std::array<double, 4> fractiles{};               // of the draws' means over motions, at `shares`
  double motion_std_ln = 0.0, lot_std_ln = 0.0;    // parts of the spread of ln(response): law of total variance
  double lot_share = 0.0;                          // of the variance
  std::optional<double> uncertain_std_ln;          // between populations, of ln of their medians
  std::vector<std::array<double, 4>> by_motion;    // fractiles over the draws under each motion
  std::vector<double> nominal_by_motion;
  Histogram histogram = {};  // of the draws' means over motions
};

// The share of buildings that bounds should cover.
inline constexpr double wanted_share = 0.95;

struct Coverage {
  std::string_view quantity;                       // its key
  double inside = 0.0;                             // share of the draws between the lower and upper bound analyses
  double interval_low = 0.0, interval_high = 0.0;  // Clopper and Pearson 1934, 95 %
  double below = 0.0, above = 0.0;
  // The least symmetric factors 1 -+ a, of a grid of analyses, between whose responses `enough` of the draws lie; none:
  // not within the grid.
  std::optional<double> factor_low, factor_high;
  // The nominal building is not between the two, so the response does not rise or fall with the forces:
  // FindingKind::bounds_not_monotonic, and its sentence; empty otherwise.
  std::optional<Finding> monotony = {};
  std::string not_monotonic;
};
// The factors that would cover `enough` of the draws, or that none on the grid do: FindingKind::covering_factors.
Finding covering_factors(Coverage const& coverage);

// Codes take the mean response over no fewer motions as the design's (EN 1998-1, 4.3.3.4.3; ASCE 7-16, 17.3.3; eleven
// in its chapter 16).
inline constexpr std::size_t motions_for_a_mean = 7;

struct Checked {  // the nominal building by the implicit path, under each motion
  std::string outcome;
  double isolator_mm = 0.0, balance = 0.0, step_s = 0.0;
  double missed_mm = 0.0;                                      // a third of the difference to half the step
  double draws_error_percent = 0.0;                            // the explicit path from it
  double equivalent_mm = 0.0, equivalent_error_percent = 0.0;  // equivalent linear analysis, of the centre
  double equivalent_period_s = 0.0, equivalent_damping = 0.0;
};

// The nominal building by the implicit path: the base's centre of mass relative to the ground, and the sum of the
// bearings' forces on it, every so many steps.
inline constexpr std::size_t most_of_history = 2000;
struct NominalHistory {
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, shear_x_kN, shear_y_kN;
};

// Every bearing under the motion that moves the nominal building most, by the implicit path: of the first draw where
// bearings are drawn, so that no two are alike.
inline constexpr std::size_t most_of_loops = 500;
struct BearingLoops {
  std::size_t motion = 0;
  bool drawn = false;
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, rotation_rad;             // of the base's centre of mass
  std::vector<std::vector<double>> force_x_kN, force_y_kN;  // [bearing]
};

// Of the nominal building, means over the motions: what a linear oscillator of one direction or two, 5 % damped, that
// stands on a diaphragm feels (pseudo-acceleration).
inline constexpr double spectrum_damping = 0.05;
std::vector<double> const& spectrum_periods_s();

struct LawAnswer {
  std::string law;
  Coupling coupling = Coupling::coupled;
  bool fitted_as_springs = false;           // of springs
  std::size_t draws = 0, failed = 0;        // runs whose numbers are not finite
  double worst_balance = 0.0;               // of the energy, of all runs
  std::vector<Distribution> distributions;  // of quantities()
  std::vector<Coverage> coverage;           // of each quantity that is not uncovered
  std::vector<Finding> doubts;              // about its calibration
  // Of a further law, the share of its draws whose displacement is between the bounds of the first law.
  std::optional<double> by_first_bounds;
  std::vector<Checked> checked;
  std::vector<NominalHistory> histories;  // of every motion
  // Of every bearing, means over draws and motions: its largest displacement, its share of the work on all.
  std::vector<double> bearing_mm, bearing_energy_share;
  BearingLoops loops = {};
  std::vector<std::vector<double>> floor_spectra_g = {};  // [diaphragm, the base first][period]
};

// How a law goes into the plane, in one word.
std::string_view form(LawAnswer const& law);

struct Answers {
  std::vector<LawAnswer> laws;
  double weight_kN = 0.0;
  std::vector<double> fixed_periods_s;
  // Between laws, standard deviation of ln of their median largest isolator displacement; beside the lot's own.
  std::optional<double> law_std_ln;
  std::vector<Finding> verdict;
  std::optional<bool> bounds_are_enough;  // none: nothing to cover, or too few draws to show it
  std::vector<Finding> warnings;          // about the analyses of the building
  std::vector<Finding> calibration;       // doubts about the laws, each once
  std::vector<std::string> assumed;       // what the numbers stand on, a sentence each
  std::vector<Point> corners;             // where the slab's corners were measured
};
Answers answer(Study const& study, RunStore const& store);

// Clopper and Pearson's interval of a share.
std::array<double, 2> binomial_interval(std::size_t found, std::size_t of, double level = 0.95);

// Effective stiffness and damping of a bearing in its third cycle of this amplitude, along x.
struct Effective {
  double stiffness_kN_mm = 0.0, damping = 0.0;
};
Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, Coupling coupling);

// Places for tested devices, given their stiffness at the design displacement: [place] -> device, so that the centre of
// stiffness is as near as it comes to the centre of mass by exchanges of two. As many devices as places, or more.
struct Arrangement {
  std::vector<std::size_t> device;
  double eccentricity_mm = 0.0, in_order_mm = 0.0;  // and of the devices as they came
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

// The nominal building under a motion, by the implicit path, with its history.
Response nominal_run(Study const& study, LawSource const& source, Motion const& motion);
// The same as CSV: the base's displacement and velocity relative to the ground, the bearings' force and every floor's
// acceleration in space; along x, and y where the motion has it. Where the run did not complete, up to there.
std::string history_csv(Response const& run, Motion const& motion);
}  // namespace isolaw::building
