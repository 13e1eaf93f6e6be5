// How much one condition changes a property: the ratio of a device's value under another condition to its own value
// under reference conditions, for every device that was tested under both, then the mean over the devices with its
// interval. The logarithm is used throughout, so that factors multiply.
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
  double ln = 0.0;  // mean over the device's tests at the level less mean over its reference tests
};

struct Level {
  double at = 0.0;  // mean condition of its tests; 0 for ageing, whose levels have no order
  std::optional<Ageing> ageing = {};
  bool reference = false;
  std::vector<DeviceRatio> ratios = {};
  // Standard error and degrees of freedom from repeated tests, if a single device was tested here. Empty if these tests
  // do not differ at all: they then show no scatter.
  std::optional<double> replicate_se = {}, replicate_df = {};
  std::optional<std::size_t> unpaired = {};  // index of its factor in Response, if only other devices were tested here
  int tests = 0;

  std::vector<double> lns() const;  // of the devices
  double mean() const;
  double std() const;  // over the devices; 0 for a single one
};

// How sure a factor is. From the strongest to the weakest.
enum class Status { shown, interpolated, extrapolated, unpaired, scaled, assumed, not_covered };
std::string_view name(Status status);

// Why a factor is not covered.
enum class Lack {
  no_test,          // no test shows the effect at all
  no_design,        // a rule set asks for the effect, and the design states no range of its condition
  too_far,          // the condition is too far beyond the tests
  no_level,         // no test has this ageing
  no_energy,        // a life in years, and no activation energy is stated
  too_long,         // the life is more than twice that for which a test stands
  no_new_device,    // no reference test of a new device with its first cycle
  no_rest,          // no tests with a shorter and a longer rest, or with this one
  no_cycle,         // no reference test has so many cycles
  unknown_scatter,  // only other devices were tested, and too few reference tests show how devices differ
};

std::string_view name(Lack lack);

// The factor lambda = exp(ln) of an effect at one condition.
struct Factor {
  double at = 0.0;
  double ln = 0.0;
  Status status = Status::shown;
  int devices = 0;
  double std = 0.0;                        // over the devices, of ln
  std::optional<double> se = {}, df = {};  // standard error of ln and its degrees of freedom; empty: no interval
  double line_error = 0.0;                 // of the straight line between levels, in ln; 0 at a level
  double drift = 0.0;                      // of the reference tests of one device, in ln
  std::optional<Lack> lack = {};           // if it is not covered

  double lambda() const;
  static Factor without(Lack lack) { return {.status = Status::not_covered, .lack = lack}; }
};

// For which value an interval is.
enum class About {
  mean,        // the mean factor; for a factor from repeated tests of a single device, the factor of this device
  device,      // one further device
  system,      // the mean of the installed devices, of which the tested ones are some
  prototypes,  // the same, but the tested devices are not installed
};
std::string_view name(About about);
struct Interval {
  double low = 0.0, high = 0.0;
};
// The 95 % interval of lambda. Empty without a standard error, and for other devices than the tested ones if only one
// was tested. `installed` is the number of installed devices.
std::optional<Interval> interval(Factor const& factor, About about, int installed = 0);
std::optional<double> half_width(Factor const& factor, About about, int installed = 0);  // of this interval, in ln

// The levels of one effect, and for every device the straight lines in ln between its own levels: over the temperature,
// the logarithm of the frequency, or the square of the load.
class Response {
 public:
  // `reference` and `others` are the tests that agree with the reference, and those that differ from it in this effect
  // alone. Where no device with a reference test was tested, the factor is that of other devices (unpaired_factor()). No
  // status is stronger than `strongest`.
  Response(Effect effect, std::span<Sample const> reference, std::span<Sample const> others,
           Condition const& reference_condition, Tolerance const& tolerance, Status strongest = Status::shown);

  Effect effect() const { return effect_; }
  std::vector<Level> const& levels() const { return levels_; }  // by rising condition, with that of the reference
  std::vector<Level const*> paired_levels() const;  // levels() at which a device with a reference test was tested
  // The largest distance of a level from the lines that leave it out, in ln, as a mean over the devices that were tested
  // there and on both sides. Empty without such devices: nobody knows then how straight the response is.
  std::optional<double> line_error() const { return line_error_; }
  std::optional<double> drift() const { return drift_; }                  // empty if no device has two reference tests
  std::vector<std::string> const& unpaired() const { return unpaired_; }  // devices without a reference test

  // The condition on the scale over which ln changes in a straight line between two levels.
  double abscissa(double condition) const;
  Factor of(Level const& level) const;
  bool is_at(Level const& level, Condition const& test) const;  // whether a test with this condition is at the level
  // The factor at a temperature in degrees, a frequency in Hz or a load in kN. Between levels it is the mean over the
  // devices that were tested on both sides, each on its own line. It is extrapolated from the outermost level by at most
  // 10 K, a factor of 2 in frequency, or 20 % of the load. Beyond this it is not covered.
  Factor at(double condition) const;
  Factor at(Ageing const& ageing) const;  // a level that agrees with it, else not covered
  // The factor in the condition of a test that belongs to the effect, from devices with a reference test alone.
  // Otherwise a test of another device would be compared with itself.
  Factor paired_at(Condition const& test) const;
  Level const* paired_level_at(Condition const& test) const;  // that agrees with it; nullptr if none does
  struct Line {                                               // of one device, through two of its levels
    std::string_view device;
    Level const *first, *second;
    double ln;    // at the condition
    bool beyond;  // the condition is not between the two levels
  };
  // The lines of the devices that were tested on both sides of the condition. Beyond all tests, but near enough, the
  // lines of those that were tested at the outermost level.
  std::vector<Line> lines_at(double condition) const;
  // The levels of a device that show paired_at(): the one that agrees with the condition, or the two of its line.
  std::vector<Level const*> behind(std::string_view device, Condition const& test) const;
  // The factor of the largest and of the smallest value in a range of the condition: the reference, its two ends, or a
  // level within it. It is not covered if an end is not; its value is then the largest or smallest that is known.
  struct Extremes {
    Factor max, min;
  };
  Extremes over(double low, double high) const;
  bool is_reference(double condition) const;  // whether the condition agrees with the reference
  // The response of one device by itself: the levels at which it was tested, with its own ratios. The error of the
  // straight line and the drift stay those of all devices.
  Response of_device(std::string_view device) const;

 private:
  // The line through a device's own levels next to the condition; empty if it has fewer than two besides `left_out`.
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

// The factor from devices that were tested at the level alone and others tested at reference alone. `lot_std` is the
// standard deviation of ln over `lot_devices` devices at reference. Not covered with fewer than two of these.
Factor unpaired_factor(std::span<Sample const> level, std::span<Sample const> reference, double lot_std,
                       int lot_devices);

}  // namespace isolaw::conditions
