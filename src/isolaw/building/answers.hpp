// Computes the answers of a building study from its stored runs. The response of a drawn building is its mean over the
// motions, as in design. The distributions under each single motion are kept too.
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
  std::string_view uncovered = {};  // why the bound analyses cannot cover the quantity; empty if they can
};
std::span<Quantity const> quantities();
Quantity const& quantity(std::string_view key);

inline constexpr std::array shares{0.16, 0.50, 0.84, 0.95};  // the fractiles that the answers give

// Bins of equal width from the smallest value to the largest. There is one bin if all values are equal.
struct Histogram {
  double from = 0.0, width = 0.0;
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::vector<double> const& values);

struct Distribution {
  double nominal = 0.0, lower = 0.0, upper = 0.0;  // the three analyses without draws, means over the motions
  std::array<double, 4> fractiles{};               // at `shares`, of the draws' means over the motions
  double motion_std_ln = 0.0, lot_std_ln = 0.0;    // spread of ln(response) in two parts, by the law of total variance
  double lot_share = 0.0;                          // share of the lot in the variance of ln(response)
  std::optional<double> uncertain_std_ln;          // standard deviation of ln(median) over the re-estimated populations
  std::vector<std::array<double, 4>> by_motion;    // [motion] fractiles of the draws
  std::vector<double> nominal_by_motion;
  Histogram histogram = {};  // of the draws' means over the motions
};

// The bounds suffice if the responses of the two bound analyses enclose this share of the drawn buildings.
inline constexpr double wanted_share = 0.95;

struct Coverage {
  std::string_view quantity;                       // Quantity::key
  double inside = 0.0;                             // share of the draws between both bound analyses
  double interval_low = 0.0, interval_high = 0.0;  // 95 % interval of `inside`, Clopper and Pearson 1934
  double below = 0.0, above = 0.0;                 // shares of the draws below and above both bound analyses
  // The factors 1 - a and 1 + a of the smallest a for which the analyses with factors between them (grid_factor)
  // enclose `wanted_share` of the draws. nullopt if all factors of the grid enclose less.
  std::optional<double> factor_low, factor_high;
  // FindingKind::bounds_not_monotonic if the nominal building is not between the bound analyses; empty otherwise.
  std::optional<Finding> monotony = {};
  std::string not_monotonic;
};
Finding covering_factors(Coverage const& coverage);
// Codes let a design use the mean response only with at least this number of motions (EN 1998-1, 4.3.3.4.3; ASCE 7-16,
// 17.3.3; chapter 16 of ASCE 7-16 asks for eleven).
inline constexpr std::size_t motions_for_a_mean = 7;
// The nominal building under one motion by implicit integration, and the errors of two other methods against it.
struct Checked {
  std::string outcome;
  double isolator_mm = 0.0, balance = 0.0, step_s = 0.0;
  double missed_mm = 0.0;                                      // step error of isolator_mm, by richardson()
  double draws_error_percent = 0.0;                            // error of isolator_mm by the integrator of the draws
  double equivalent_mm = 0.0, equivalent_error_percent = 0.0;  // equivalent linear analysis: displacement of the centre
  double equivalent_period_s = 0.0, equivalent_damping = 0.0;
};

// The nominal building by implicit integration, in at most most_of_history samples: displacement of the base's centre
// of mass relative to the ground, and the sum of the bearings' forces, positive along the displacement.
inline constexpr std::size_t most_of_history = 2000;
struct NominalHistory {
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, shear_x_kN, shear_y_kN;
};

// Force-displacement loops of every bearing under the motion that moves the nominal building most, by implicit
// integration, in at most most_of_loops samples. They are those of the first drawn building if bearings are drawn.
inline constexpr std::size_t most_of_loops = 500;
struct BearingLoops {
  std::size_t motion = 0;
  bool drawn = false;
  double step_s = 0.0;
  std::vector<double> x_mm, y_mm, rotation_rad;             // motion of the base's centre of mass
  std::vector<std::vector<double>> force_x_kN, force_y_kN;  // [bearing][sample]
};

// Floor spectra: the largest pseudo-acceleration in plan of linear oscillators with these periods and 5 % damping along
// x and y, on a diaphragm of the nominal building. The spectra are means over the motions.
inline constexpr double spectrum_damping = 0.05;
std::vector<double> const& spectrum_periods_s();

struct LawAnswer {
  std::string law;
  Coupling coupling = Coupling::coupled;
  bool fitted_as_springs = false;           // parameters fitted as springs around the circle
  std::size_t draws = 0, failed = 0;        // `failed`: runs whose numbers are not finite
  double worst_balance = 0.0;               // largest error of the energy balance over all runs
  std::vector<Distribution> distributions;  // [quantity] in the order of quantities()
  std::vector<Coverage> coverage;           // for each quantity whose `uncovered` is empty
  std::vector<Finding> doubts;              // about the law's calibration
  // For all laws but the first: share of the draws whose bearing displacement lies between the first law's bounds.
  std::optional<double> by_first_bounds;
  std::vector<Checked> checked;
  std::vector<NominalHistory> histories;  // [motion]
  // [bearing] means over draws and motions of the largest displacement, and of the share of the work on all bearings.
  std::vector<double> bearing_mm, bearing_energy_share;
  BearingLoops loops = {};
  std::vector<std::vector<double>> floor_spectra_g = {};  // [diaphragm, the base first][period]
};

// The Coupling in a word. Springs whose parameters were fitted in one direction are "springs as given".
std::string_view form(LawAnswer const& law);

struct Answers {
  std::vector<LawAnswer> laws;
  double weight_kN = 0.0;
  std::vector<double> fixed_periods_s;
  // Standard deviation over the laws of ln(median bearing displacement), comparable with Distribution::lot_std_ln.
  std::optional<double> law_std_ln;
  std::vector<Finding> verdict;
  std::optional<bool> bounds_are_enough;  // nullopt: no bearing is drawn, or too few draws to tell
  std::vector<Finding> warnings;          // about the analyses of the building
  std::vector<Finding> calibration;       // doubts about the laws' calibration, each once
  std::vector<std::string> assumed;       // the assumptions, a sentence each
  std::vector<Point> corners;             // of the slab, where displacements are measured
};
Answers answer(Study const& study, RunStore const& store);
// Clopper and Pearson's confidence interval of the share found / trials. It is 0 to 1 without trials.
std::array<double, 2> binomial_interval(std::size_t found, std::size_t trials, double level = 0.95);

// Effective stiffness and damping ratio of a bearing in its third sine cycle of this amplitude along x, at 1 Hz. A law
// that is not used in its coupled form is given zero velocity, so its viscous forces do not count.
struct Effective {
  double stiffness_kN_mm = 0.0, damping = 0.0;
};
Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, Coupling coupling);

// Puts a device of known stiffness on each place. Exchanges pairs of devices until no exchange brings the centre of
// stiffness nearer to `centre`, which may miss the best arrangement. Needs as many devices as places, or more.
struct Arrangement {
  std::vector<std::size_t> device;                  // [place]
  double eccentricity_mm = 0.0, in_order_mm = 0.0;  // as arranged here, and with the devices in order
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

Response nominal_run(Study const& study, LawSource const& source, Motion const& motion);
// A run as CSV: displacement and velocity of the base relative to the ground, force on the bearings, and absolute
// acceleration of every diaphragm, along x and, if the motion has it, y. A failed run ends where it failed.
std::string history_csv(Response const& run, Motion const& motion);
}  // namespace isolaw::building
