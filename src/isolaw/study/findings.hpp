// Turns a campaign's numbers into findings: which law to take and why, how the laws compare, and the warnings. Every
// renderer prints these findings; wording/table.hpp makes the sentences.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/recommendation.hpp"
#include "isolaw/study/summary.hpp"
#include "isolaw/study/warnings.hpp"

namespace isolaw::study {

enum class Role {
  best_of_both,   // the only law on the front
  most_accurate,  // the law of smallest objective on the front
  most_robust,    // the law of smallest beta on the front, among laws whose beta the search box does not decide
  compromise,     // on the front between the two laws above, and nearest to the least objective and the least beta
  between,        // on the front, and none of the roles above
  held_by_box,    // on the front, but only because its parameters lie at bounds of the box
  dominated,
  inadequate,  // does not describe the devices (adequacy.hpp), so it is not compared
  unranked     // has no beta, or was never identified
};

std::string_view name(Role role);  // "most accurate", "dominated", ...

struct LawVerdict {
  std::size_t law = 0;  // index into Summary::laws
  Role role = Role::unranked;
  std::vector<Finding> findings;          // each gives a sentence, in this order
  std::vector<std::string> dominated_by;  // ids of the laws on the front that beat this law
};

struct Findings {
  std::optional<Recommendation> recommendation;  // the law that isolaw recommends; empty for an inspection
  std::vector<Finding> headline;                 // whether to choose an accurate or a robust law
  std::vector<LawVerdict> verdicts;  // the front from accurate to robust, then dominated, inadequate, unranked laws
  std::vector<Finding> warnings;     // most serious first
  std::vector<Finding> converged;    // what the analyses found, from converged_findings()
  std::string beta_note;             // why no law has a beta; "" if one has
};

Findings findings(Summary const& summary);
// Whether a warning is shown beside the recommendation `answer`: not if it is about a law that is not recommended, and
// not if it repeats a doubt that the recommendation states.
bool concerns_answer(Summary const& summary, Recommendation const& answer, Finding const& warning);
// Delta_n: a parameter's largest relative difference from the lot's mean. Empty if fixed or undefined.
std::optional<double> largest_difference(LawResult const& law, std::size_t parameter);
std::optional<double> mean_magnitude(LawResult const& law, std::optional<double> DeviceFit::*error);
// The largest displacement in mm at which a law was shown to hold: that of the whole tests if its prediction is fair or
// better, otherwise that of the part to which it was fitted. nullopt if the law was identified on no device.
std::optional<double> largest_displacement(Summary const& summary, LawResult const& law);
// Groups of two or more devices with the same record. All but one of them are copies (DeviceResult::copy_of).
std::vector<std::vector<DeviceResult const*>> devices_of_one_record(Summary const& summary);
std::vector<std::vector<DeviceResult const*>> devices_of_one_compression(Summary const& summary);
// Indices of the laws by rising mean objective. Laws without an objective come last, in the order of the summary.
std::vector<std::size_t> by_objective(Summary const& summary);
std::vector<std::string> device_names(Summary const& summary);
// Returns nullptr if the law was not tried on the device.
DeviceFit const* fit_of(LawResult const& law, std::string_view device);
// A law's parameters as they are listed for the first device on which the law was identified; empty if there is none.
std::vector<ParameterFit> const& parameters_of(LawResult const& law);
// The index of a parameter in the vectors of a population, which is not its index in the law. Returns nullopt for a
// parameter that is fixed or tied to another, and for a redundant parameter that the population leaves out.
std::optional<std::size_t> place_of(lot::Population const& population, std::string_view parameter);

}  // namespace isolaw::study
