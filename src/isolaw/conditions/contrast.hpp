// How much one condition changes a property. If a device was tested under reference conditions and under another
// condition, its value under that condition is divided by its value at reference. Then the mean of these ratios over
// the devices is computed, with its interval. All values are logarithms (ln), since factors multiply.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/conditions/condition.hpp"

namespace isolaw::conditions {

struct Sample {  // the value of one test of one device
  std::string device;
  Condition condition;
  double ln = 0.0;  // natural logarithm of the property
};

struct DeviceRatio {
  std::string device;
  double ln = 0.0;  // mean over the device's tests at the level minus mean over its reference tests
};

struct Level {
  double at = 0.0;  // mean value of the condition in its tests; 0 for ageing, which is not a single number
  std::optional<Ageing> ageing = {};
  bool reference = false;
  std::vector<DeviceRatio> ratios = {};
  // Standard error and degrees of freedom from repeated tests, if a single device was tested here. Empty if these tests
  // do not differ at all: they then show no scatter.
  std::optional<double> replicate_se = {}, replicate_df = {};
  // Set if no device with a reference test was tested here: the index of the level's factor in
  // Response::unpaired_factors_.
  std::optional<std::size_t> unpaired_factor = {};
  int tests = 0;

  std::vector<double> lns() const;  // DeviceRatio::ln of each device
  double mean() const;
  double std() const;  // standard deviation over the devices; 0 for a single device
};

// How sure a factor is, from the strongest status to the weakest. shown: devices were tested at the condition;
// unpaired: only devices without a reference test were tested; scaled: only scaled specimens were tested; assumed: the
// factor is a default of the rule set.
enum class Status { shown, interpolated, extrapolated, unpaired, scaled, assumed, not_covered };
std::string_view name(Status status);

// Why a factor is not covered.
enum class Lack {
  no_test,          // no test shows the effect at all
  no_design,        // a rule set asks for the effect, but the design states no range of its condition
  too_far,          // the condition is too far beyond the tests
  no_level,         // no test has this ageing
  no_energy,        // the design states a life in years, but no activation energy is stated
  too_long,         // the life is more than twice the life that a test stands for
  no_new_device,    // no reference test has the first cycle of a new device
  no_rest,          // no test after this rest, nor tests after both a shorter and a longer one
  no_cycle,         // no reference test has as many cycles as the design asks for
  unknown_scatter,  // only devices without a reference test were tested, and reference tests do not show the scatter
};

std::string_view name(Lack lack);

// The factor lambda = exp(ln) of an effect at one condition.
struct Factor {
  double at = 0.0;
  double ln = 0.0;
  Status status = Status::shown;
  int devices = 0;
  double std = 0.0;                        // standard deviation of ln over the devices
  std::optional<double> se = {}, df = {};  // standard error of ln and its degrees of freedom; empty: no interval
  double line_error = 0.0;                 // error in ln of the straight line between two levels; 0 at a level
  double drift = 0.0;                      // drift of the devices between tests, in ln: Response::drift()
  std::optional<Lack> lack = {};           // the reason, if the factor is not covered

  double lambda() const;
  static Factor not_covered(Lack lack) { return {.status = Status::not_covered, .lack = lack}; }
};

// The value that an interval is meant to contain.
enum class About {
  mean,        // the mean factor; for a factor from repeated tests of a single device, the factor of this device
  device,      // the factor of one further device
  system,      // the mean factor of the installed devices, which include the tested ones
  prototypes,  // the mean factor of the installed devices, which do not include the tested ones
};
std::string_view name(About about);
struct Interval {
  double low = 0.0, high = 0.0;
};
// The 95 % interval of lambda. Empty if the factor has no standard error. Also empty if it comes from a single device
// and the interval is about other devices. `installed` is the number of installed devices.
std::optional<Interval> interval(Factor const& factor, About about, int installed = 0);
std::optional<double> half_width(Factor const& factor, About about, int installed = 0);  // of interval() above, in ln

// How a property changes with the condition of one effect: the levels at which devices were tested. Between two levels
// of a device, ln is taken as a straight line over the temperature, the logarithm of the frequency, or the square of
// the load.
class Response {
 public:
  // `reference` are the tests under reference conditions, and `others` those that differ from them in this effect
  // alone. At a level where no device with a reference test was tested, the factor comes from other devices
  // (unpaired_factor()). No factor gets a stronger status than `strongest`.
  Response(Effect effect, std::span<Sample const> reference, std::span<Sample const> others,
           Condition const& reference_condition, Tolerance const& tolerance, Status strongest = Status::shown);

  Effect effect() const { return effect_; }
  std::vector<Level> const& levels() const { return levels_; }  // by rising condition; the reference is one of them
  std::vector<Level const*> paired_levels() const;  // levels() at which a device with a reference test was tested
  // How far a level lies from the straight line between its neighbours, in ln: the mean over the devices that were
  // tested at all three, and the largest such mean of all levels. Empty if there are no such devices, because it is
  // then unknown how straight the response is.
  std::optional<double> line_error() const { return line_error_; }
  // Half the change of ln from a device's first reference test to its last, the largest of all devices. Empty if no
  // device has two reference tests.
  std::optional<double> drift() const { return drift_; }
  std::vector<std::string> const& unpaired() const { return unpaired_; }  // devices without a reference test

  // Converts a condition to the scale over which ln is a straight line between two levels.
  double abscissa(double condition) const;
  Factor factor_of(Level const& level) const;
  bool is_at(Level const& level, Condition const& test) const;  // whether a test with this condition is at the level
  // The factor at a temperature in degrees, a frequency in Hz or a load in kN. Between levels it is the mean over the
  // devices that were tested on both sides, each by the straight line through its own values. It is extrapolated from
  // the outermost level by at most 10 K, a factor of 2 in frequency, or 20 % of the load. Beyond that, it is not
  // covered.
  Factor at(double condition) const;
  Factor at(Ageing const& ageing) const;  // the factor of the level that agrees with it; if none does, not covered
  // The factor at the value that this effect's condition has in a test. Only devices with a reference test count: the
  // test of a device without one would otherwise be compared with itself.
  Factor paired_at(Condition const& test) const;
  Level const* paired_level_at(Condition const& test) const;  // the level that agrees with the test, or nullptr
  struct Line {                                               // a straight line through two levels of one device
    std::string_view device;
    Level const *first, *second;
    double ln;    // value of the line at the condition
    bool beyond;  // the condition is not between the two levels
  };
  // For a condition between tests: the lines of the devices that were tested on both sides of it. For a condition
  // beyond all tests, but near enough for at(): the lines of the devices that were tested at the outermost level.
  std::vector<Line> lines_at(double condition) const;
  // The levels that paired_at() uses for a device: the level that agrees with the test, or the two levels through which
  // the device's line goes.
  std::vector<Level const*> behind(std::string_view device, Condition const& test) const;
  // The largest and the smallest factor in a range of the condition, among those of the reference, of the two ends and
  // of the levels within the range. If an end is not covered, both factors count as not covered; their values are then
  // the largest and the smallest that are known.
  struct Extremes {
    Factor max, min;
  };
  Extremes over(double low, double high) const;
  bool is_reference(double condition) const;  // whether the condition agrees with the reference
  // The response of one device by itself: the levels at which it was tested, with its own ratios. The error of the
  // straight line and the drift stay those of all devices.
  Response of_device(std::string_view device) const;

 private:
  // The line through a device's own levels next to the condition. `left_out` is not used as a level. nullopt if fewer
  // than two levels remain.
  std::optional<Line> line_of(std::string_view device, double condition, Level const* left_out) const;
  Level const* level_at(double condition, bool only_paired) const;
  Factor at(double condition, bool only_paired) const;

  Effect effect_;
  Tolerance tolerance_;
  Status strongest_;
  std::vector<Level> levels_;
  std::vector<Factor> unpaired_factors_;
  std::optional<double> line_error_, drift_;
  std::vector<std::string> unpaired_;
};

// Returns the factor of a level at which other devices were tested than at reference. Its logarithm is the mean of
// ln(value) at the level minus the mean at reference. `lot_std` is the standard deviation of ln(value) over
// `lot_devices` devices at reference. With fewer than two such devices the scatter of devices is unknown, and the
// status is not_covered.
Factor unpaired_factor(std::span<Sample const> level, std::span<Sample const> reference, double lot_std,
                       int lot_devices);

}  // namespace isolaw::conditions
