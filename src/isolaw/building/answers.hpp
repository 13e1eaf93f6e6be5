// Computes the answers of a building study from its stored runs. A draw's response is its mean over the motions, as in
// design; distributions under single motions are kept too.
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
  std::string_view uncovered = {};  // why the bound analyses cannot cover it; empty if they can
};
std::span<Quantity const> quantities();
Quantity const& quantity(std::string_view key);

inline constexpr std::array shares{0.16, 0.50, 0.84, 0.95};  // the fractiles of the answers

// Equal bins from the smallest value to the largest; a single bin if all values are equal.
struct Histogram {
  double from = 0.0, width = 0.0;
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::vector<double> const& values);

struct Distribution {
  double nominal = 0.0, lower = 0.0, upper = 0.0;  // responses of the analyses without draws, means over motions
  std::array<double, 4> fractiles{};               // at `shares`, of the draws' means over motions
  double motion_std_ln = 0.0, lot_std_ln = 0.0;    // spread of ln(response) in two parts, by the law of total variance
  double lot_share = 0.0;                          // the lot's part of that variance
  std::optional<double> uncertain_std_ln;          // standard deviation of ln(median) over the re-estimated populations
  std::vector<std::array<double, 4>> by_motion;    // [motion] fractiles of the draws
  std::vector<double> nominal_by_motion;
  Histogram histogram = {};  // the draws' means over motions
};

// The bounds are judged enough if they cover this share of the drawn buildings.
inline constexpr double wanted_share = 0.95;

struct Coverage {
  std::string_view quantity;                       // key
  double inside = 0.0;                             // share of the draws between both bound analyses
  double interval_low = 0.0, interval_high = 0.0;  // 95 %, Clopper and Pearson 1934
  double below = 0.0, above = 0.0;                 // shares of the draws below and above both bound analyses
  // Smallest factors 1 - a and 1 + a on the grid (grid_factor) such that the responses of the analyses from one to the
  // other span `wanted_share` of the draws; nullopt if even the whole grid does not.
  std::optional<double> factor_low, factor_high;
  // FindingKind::bounds_not_monotonic if the nominal building is not between the bound analyses; empty otherwise.
  std::optional<Finding> monotony = {};
  std::string not_monotonic;
};
Finding covering_factors(Coverage const& coverage);
// Codes let a design use the mean response only with at least this number of motions (EN 1998-1, 4.3.3.4.3; ASCE 7-16,
// 17.3.3; its chapter 16 asks for eleven).
inline constexpr std::size_t motions_for_a_mean = 7;
// The nominal building under one motion by the implicit path, and the errors of other methods.
struct Checked {
  std::string outcome;
  double isolator_mm = 0.0, balance = 0.0, step_s = 0.0;
  double missed_mm = 0.0;                                      // step error of isolator_mm, by richardson()
  double draws_error_percent = 0.0;                            // error of isolator_mm with the draws' integrator
  double equivalent_mm = 0.0, equivalent_error_percent = 0.0;  // equivalent linear analysis: displacement of the centre
  double equivalent_period_s = 0.0, equivalent_damping = 0.0;
};

// The nominal building by the implicit path, thinned to most_of_history samples: displacement of the base's centre of
// mass relative to the ground, and the sum of the bearings' forces, positive along the displacement.
inline constexpr std::size_t most_of_history = 2000;
struct NominalHistory {
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, shear_x_kN, shear_y_kN;
};

// The loops of every bearing under the motion that moves the nominal building most, by the implicit path, in at most
// most_of_loops samples. If bearings are drawn, it is the first drawn building, whose drawn bearings differ.
inline constexpr std::size_t most_of_loops = 500;
struct BearingLoops {
  std::size_t motion = 0;
  bool drawn = false;
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, rotation_rad;             // motion of the base's centre of mass
  std::vector<std::vector<double>> force_x_kN, force_y_kN;  // [bearing][sample]
};

// Floor spectra: the pseudo-acceleration of linear oscillators with these periods and 5 % damping on a diaphragm of the
// nominal building, along x, and along y if the motion has a y component; means over the motions.
inline constexpr double spectrum_damping = 0.05;
std::vector<double> const& spectrum_periods_s();

struct LawAnswer {
  std::string law;
  Coupling coupling = Coupling::coupled;
  bool fitted_as_springs = false;           // the parameters were fitted as springs
  std::size_t draws = 0, failed = 0;        // runs whose numbers are not finite
  double worst_balance = 0.0;               // largest error of the energy balance over all runs
  std::vector<Distribution> distributions;  // [quantity], as quantities()
  std::vector<Coverage> coverage;           // for each quantity whose `uncovered` is empty
  std::vector<Finding> doubts;              // about the law's calibration
  // For every law but the first: share of its draws whose bearing displacement is between the first law's bounds.
  std::optional<double> by_first_bounds;
  std::vector<Checked> checked;
  std::vector<NominalHistory> histories;  // [motion]
  // [bearing], means over draws and motions: largest displacement, and share of the work done on all bearings.
  std::vector<double> bearing_mm, bearing_energy_share;
  BearingLoops loops = {};
  std::vector<std::vector<double>> floor_spectra_g = {};  // [diaphragm, the base first][period]
};

// "coupled", "separate", "springs" or, with parameters fitted in one direction, "springs as given".
std::string_view form(LawAnswer const& law);

struct Answers {
  std::vector<LawAnswer> laws;
  double weight_kN = 0.0;
  std::vector<double> fixed_periods_s;
  // Standard deviation over the laws of ln(median bearing displacement), to be compared with the lot's lot_std_ln.
  std::optional<double> law_std_ln;
  std::vector<Finding> verdict;
  std::optional<bool> bounds_are_enough;  // nullopt: nothing to cover, or too few draws to tell
  std::vector<Finding> warnings;          // about the analyses of the building
  std::vector<Finding> calibration;       // doubts about the laws, without repetitions
  std::vector<std::string> assumed;       // the assumptions, a sentence each
  std::vector<Point> corners;             // the slab's, where displacements were measured
};
Answers answer(Study const& study, RunStore const& store);
// Clopper and Pearson's confidence interval of the share found / trials; 0 to 1 without trials.
std::array<double, 2> binomial_interval(std::size_t found, std::size_t trials, double level = 0.95);

// Effective stiffness and damping ratio of a bearing in its third sine cycle of this amplitude along x, at 1 Hz. Forms
// other than coupled ones get the velocity 0, so viscous forces of their laws do not count.
struct Effective {
  double stiffness_kN_mm = 0.0, damping = 0.0;
};
Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, Coupling coupling);

// Chooses a tested device for each place by its stiffness at the design displacement. Exchanges pairs until no exchange
// brings the centre of stiffness nearer to `centre`; others may be better. Needs a device for each place.
struct Arrangement {
  std::vector<std::size_t> device;                  // [place]
  double eccentricity_mm = 0.0, in_order_mm = 0.0;  // with this arrangement, and with the devices in order
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

Response nominal_run(Study const& study, LawSource const& source, Motion const& motion);
// A run as CSV: the base's displacement and velocity relative to the ground, the force on the bearings, every
// diaphragm's acceleration in space; along x, and y if the motion has y. A run that failed ends where it failed.
std::string history_csv(Response const& run, Motion const& motion);
}  // namespace isolaw::building
