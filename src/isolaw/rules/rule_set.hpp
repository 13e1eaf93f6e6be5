// A rule set: what a standard or a contract asks of cyclic shear tests, as data read from TOML. It states how and from
// which cycles properties are computed, the conditions of the tests, the limits, how many devices to test, the property
// modification factors, and how the effects of temperature, rate, load, ageing and history are limited and combined.
// isolaw's code contains no limit of a standard. `verified_by` names a person who has compared the set with the text of
// its standard. A set without such a name never leads to pass or fail (assess.hpp). docs/rules.md explains the file;
// rules/template.toml is a commented example.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/rules/effects.hpp"

namespace isolaw::rules {

enum class Quantity { K_eff, damping, energy, Q_d, K_d, K_v };  // K_v comes from a compression test
std::string_view name(Quantity quantity);                       // as rule files write it: "K_eff"
std::string_view unit(Quantity quantity);                       // "kN/mm", "%", "kN mm", "kN"
std::vector<Quantity> const& measured_quantities();             // all but K_v, in the order of reports

enum class Formula {  // the forces and displacements that give stiffness and damping
  peak_to_peak,       // (F+ - F-)/(d+ - d-); E/(2 pi K D^2) with this K and D = (d+ - d-)/2
  per_side,           // for each side by itself: F/d; E/(2 pi F d)
};

enum class Counting { one, mean, each };  // one cycle; the mean over a range of cycles; each cycle of a range
struct CountingCycles {
  Counting counting = Counting::one;
  int first = 3;
  int last = 3;
};

// Conditions of the test under which the limits hold. A missing condition is not checked. Tolerances are in percent.
struct TestConditions {
  std::string clause;
  std::vector<double> strains_percent;  // the test must have one of these
  std::optional<double> strain_tolerance_percent;
  std::vector<double> frequencies_Hz;  // the test must have one of these
  std::optional<double> frequency_tolerance_percent;
  std::optional<double> displacement_tolerance_percent;  // between amplitude and design displacement
  std::optional<double> load_tolerance_percent;          // between mean vertical load and design load
};

enum class Scope { each, mean };  // the limit is on every device by itself, or on the mean over the lot's devices

struct Limit {  // a limit on the deviation from the design value; a value equal to the limit passes
  Quantity quantity = Quantity::K_eff;
  Scope scope = Scope::each;
  std::optional<double> lower_percent, upper_percent;
  std::string clause;
};

enum class Measure {
  min_over_max,       // lowest value of the cycles / highest value
  change_from_first,  // largest |value/first - 1|
  loss_from_first,    // largest 1 - value/first
};

// Limit on how much a property changes over a range of cycles. For this limit, stiffness and damping are peak to peak.
struct StabilityLimit {
  Quantity quantity = Quantity::K_eff;
  Measure measure = Measure::min_over_max;
  int first = 1, last = 3;
  double bound = 0.0;  // least ratio for min_over_max, else the largest change or loss in percent
  std::string clause;
};

struct SampleRule {
  double share_percent = 100.0;
  int least = 1;
  std::string clause;
};

// Limit on the difference of a property between the largest and smallest vertical load, in percent of its design value.
struct LoadVariation {
  double largest_percent = 0.0;
  std::string clause;
};

// Factors on the design value of one property, from a standard's table or the contract.
struct PropertyFactors {
  Quantity quantity = Quantity::K_d;
  double environment_min = 1.0, environment_max = 1.0;  // lambda_ae for ageing, temperature, contamination
  std::optional<double> spec_min, spec_max;             // lambda_spec as the contract states it
};

struct FactorRule {            // see combine() in factors.hpp
  double system_factor = 1.0;  // fraction of (lambda_ae - 1) that is applied; f_a or psi in standards
  std::optional<double> max_not_below, min_not_above;
  std::string clause;
  std::vector<PropertyFactors> properties;
};

// How far the tests of a lot may differ from one another: temperature in K, earlier cycles as a number, the others in
// percent of the largest value.
struct SameCondition {
  std::optional<double> temperature_C, frequency_percent, load_percent, amplitude_percent, earlier_cycles;
  std::string clause;
};

struct MeanAnalysisRule {  // an analysis may use mean properties if no device is farther than this from the mean
  double within_percent = 0.0;
  std::string clause;
};

struct CombinationRule {  // how the factors of all effects are combined into one factor
  Form form = Form::product;
  double adjust = 1.0;  // the number f in the formula of `form`; Form::asce takes FactorRule::system_factor instead
  double margin = 1.0;  // the number `margin` in the formula of Form::sum
  std::string clause;
};

// An effect that a set asks for. If it states a quantity, it also has default factors that may replace tests.
struct EffectRule {
  Effect effect = Effect::temperature;
  std::optional<Group> group = {};  // the group that the set states, if any; see RuleSet::group_of()
  std::optional<Quantity> quantity = {};
  double default_max = 1.0, default_min = 1.0;
  std::string clause = {};
};

// Limit on how far a property under one condition may be from the same device's property under reference conditions.
struct DependenceLimit {
  Effect effect = Effect::temperature;  // temperature, rate, load or ageing
  Quantity quantity = Quantity::K_eff;
  double within_percent = 0.0;
  std::vector<double> levels = {};  // conditions at which the limit holds, in C, Hz or kN; empty: those of the design
  std::string clause = {};
};

struct RuleSet {
  std::string id, title, edition, source;
  std::string verified_by;  // who compared the limits with the standard; empty: nobody
  std::string origin;       // "built in", or the file that the set was read from
  Formula stiffness_formula = Formula::peak_to_peak;
  Formula damping_formula = Formula::peak_to_peak;
  CountingCycles cycles;
  TestConditions test;
  std::vector<Limit> limits;
  std::vector<StabilityLimit> stability;
  std::optional<SampleRule> sample;
  std::optional<LoadVariation> load_variation;
  SameCondition same_condition;
  std::optional<MeanAnalysisRule> mean_analysis;
  FactorRule factors;
  std::optional<CombinationRule> combination;  // if empty: Form::asce for a set with factors, else the product
  std::vector<EffectRule> effects;
  std::vector<DependenceLimit> dependence;

  bool verified() const { return !verified_by.empty(); }
  PropertyFactors const* factors_of(Quantity quantity) const;
  Group group_of(Effect effect) const;                                   // as the set states it, else usual_group()
  EffectRule const* default_of(Effect effect, Quantity quantity) const;  // nullptr if the set has no default factors
};

inline constexpr std::size_t largest_rule_file = 256 << 10;  // bytes
// Reads the text of a rule file. Messages and RuleSet::origin name the file as `file`. Throws one Error with every
// problem and its line: syntax, unknown or missing keys, wrong types, values out of range, contradicting limits.
RuleSet read_rule_text(std::string_view text, std::string const& file);
// The rule sets that come with the program, in alphabetical order, without the template.
std::span<RuleSet const> built_in_rule_sets();
std::vector<std::string> built_in_names();
// The unchecked text of a built-in set, or else of the file of this name. Throws Error if it is unreadable or empty.
std::string load_rule_text(std::string_view name_or_file);
// Reads a built-in set or a file. Throws Error as read_rule_text() does; if there is no such file, the message names
// the built-in sets.
RuleSet find_rule_set(std::string_view name_or_file);
// The text, with comments, of a built-in set or of "template". For other names throws Error, which lists the names.
std::string_view rule_set_text(std::string_view name);
// Number of devices to test in a lot of N = `lot_size`: min(N, max(least, ceil(share_percent N / 100))).
int required_sample(SampleRule const& rule, int lot_size);

}  // namespace isolaw::rules
