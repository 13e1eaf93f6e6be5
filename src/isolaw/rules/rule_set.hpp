// A rule set: the requirements of a standard or a contract on cyclic shear tests, as data read from TOML. It says how
// properties are computed, at which cycles, under which conditions, within which limits, on how many devices, and with
// which property modification factors. The program itself contains no number of a standard.
// A person who has compared a set with the text of its standard signs in `verified_by`. A set that nobody signed never
// leads to a pass or a fail (assess.hpp). docs/rules.md explains the file, rules/template.toml is a commented example.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::rules {

enum class Quantity { K_eff, damping, energy, Q_d, K_d, K_v };  // K_v comes from a separate compression test
std::string_view name(Quantity quantity);                       // as in rule files: "K_eff"
std::string_view unit(Quantity quantity);                       // "kN/mm", "%", "kN mm", "kN"
std::vector<Quantity> const& measured_quantities();  // measured in every cycle, in the order of reports: all but K_v

enum class Formula {  // force and displacement that stiffness and damping are computed from
  peak_to_peak,       // (F+ - F-)/(d+ - d-); E/(2 pi K D^2) with that K and D = (d+ - d-)/2
  per_side,           // F/d of each side by itself; E/(2 pi F d)
};

enum class Counting { one, mean, each };  // one cycle; the mean of a range; every cycle of a range within the limits
struct CountingCycles {
  Counting counting = Counting::one;
  int first = 3;
  int last = 3;
};

// Conditions under which the limits hold. A condition that is not given is not checked. Tolerances are in percent.
struct TestConditions {
  std::vector<double> strains_percent;  // any of these is right
  std::optional<double> strain_tolerance_percent;
  std::vector<double> frequencies_Hz;  // any of these is right
  std::optional<double> frequency_tolerance_percent;
  std::optional<double> displacement_tolerance_percent;  // between the amplitude and the design displacement
  std::optional<double> load_tolerance_percent;          // between the mean vertical load and the design load
};

enum class Scope { each, mean };  // every device by itself; the mean over the devices of the lot

struct Limit {  // on the deviation from the design value; both ends pass; with one end only it is one-sided
  Quantity quantity = Quantity::K_eff;
  Scope scope = Scope::each;
  std::optional<double> lower_percent, upper_percent;
  std::string clause;
};

enum class Measure {
  min_over_max,       // lowest over highest value of the cycles
  change_from_first,  // largest |value/first - 1|
  loss_from_first,    // largest 1 - value/first
};

// Stability over a range of cycles. It compares cycles with each other, so stiffness and damping are peak to peak.
struct StabilityLimit {
  Quantity quantity = Quantity::K_eff;
  Measure measure = Measure::min_over_max;
  int first = 1, last = 3;
  double bound = 0.0;  // the smallest ratio allowed for min_over_max, else the largest percentage
  std::string clause;
};

struct SampleRule {
  double share_percent = 100.0;
  int least = 1;
  std::string clause;
};

// Limit on a property's difference between the largest and the smallest vertical load, in percent of its design value.
struct LoadVariation {
  double largest_percent = 0.0;
  std::string clause;
};

// Factors on the design value of one property, from a table or the contract; 1 if the set gives none.
struct PropertyFactors {
  Quantity quantity = Quantity::K_d;
  double environment_min = 1.0, environment_max = 1.0;  // lambda_ae: ageing, temperature, contamination
  std::optional<double> spec_min, spec_max;             // lambda_spec as agreed: the contract band
};

struct FactorRule {            // see combine() in factors.hpp
  double system_factor = 1.0;  // share of (lambda_ae - 1) that counts; f_a or psi in standards
  std::optional<double> max_not_below, min_not_above;
  std::string clause;
  std::vector<PropertyFactors> properties;
};

struct MeanAnalysisRule {  // mean properties suffice if the extremes differ from the mean by no more than this
  double within_percent = 0.0;
  std::string clause;
};

struct RuleSet {
  std::string id, title, edition, source;
  std::string verified_by;  // who compared the limits with the text; empty: nobody
  std::string origin;       // "built in", or the file it was read from
  Formula stiffness_formula = Formula::peak_to_peak;
  Formula damping_formula = Formula::peak_to_peak;
  CountingCycles cycles;
  TestConditions test;
  std::vector<Limit> limits;
  std::vector<StabilityLimit> stability;
  std::optional<SampleRule> sample;
  std::optional<LoadVariation> load_variation;
  std::optional<MeanAnalysisRule> mean_analysis;
  FactorRule factors;

  bool verified() const { return !verified_by.empty(); }
  PropertyFactors const* factors_of(Quantity quantity) const;
};

inline constexpr std::size_t largest_rule_file = 256 << 10;  // bytes
// Reads the text of a rule file; `file` names it in messages and RuleSet::origin. Throws one Error with every problem
// and its line: syntax, unknown or missing keys, wrong types, values out of range, contradicting limits.
RuleSet read_rule_text(std::string_view text, std::string const& file);
// The sets that come with the program, in alphabetical order, without the template.
std::span<RuleSet const> built_in_rule_sets();

bool is_built_in(std::string_view name);
// The text of the built-in set or else the file of this name; not checked. Throws Error if it is unreadable or empty.
std::string load_rule_text(std::string_view name_or_file);
// The same, read and checked. Throws Error as read_rule_text() does; for a missing file it names the built-in sets.
RuleSet find_rule_set(std::string_view name_or_file);
// The text of a built-in set or of "template", with comments. Throws Error with the allowed names.
std::string_view rule_set_text(std::string_view name);
// Number of devices to test in a lot of N = `lot_size`: min(N, max(least, ceil(share N))). 0 for an empty lot.
int required_sample(SampleRule const& rule, int lot_size);

}  // namespace isolaw::rules
