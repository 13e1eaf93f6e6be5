// The meaning of a campaign's numbers as findings: which law to take and why, how the laws compare, and the warnings.
// Every renderer prints these; wording/table.hpp makes the sentences.
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
  most_accurate,  // the front's end of smallest objective
  most_robust,    // the front's end of smallest beta
  compromise,     // between them, nearest to the best of both in terms of the front's extent
  between,        // also between them
  held_by_box,    // on the front, but its parameters lie at bounds: not robust by itself
  dominated,
  inadequate,  // does not describe the devices, however it compares: adequacy.hpp
  unranked     // without beta, or never identified
};

std::string_view name(Role role);  // "most accurate", "dominated", ...

struct LawVerdict {
  std::size_t law = 0;  // index into Summary::laws
  Role role = Role::unranked;
  std::vector<Finding> findings;          // one sentence each, in this order
  std::vector<std::string> dominated_by;  // ids of laws on the front
};

struct Findings {
  std::optional<Finding> verdict;  // the answer; none for an inspection
  std::vector<Recommendation> recommendations;
  std::vector<Finding> headline;     // the choice between accuracy and robustness
  std::vector<LawVerdict> verdicts;  // the front from accurate to robust, then dominated, inadequate, unranked laws
  std::vector<Finding> warnings;     // most serious first
  std::vector<Finding> converged;    // changes without the optimiser's noise, and errors on an untested device
  std::string beta_note;             // why no law has a beta; "" when one has
};

Findings findings(Summary const& summary);
// Delta_n of the law's n-th parameter over the devices, as a fraction; empty when undefined or not calibrated.
std::optional<double> largest_difference(LawResult const& law, std::size_t parameter);

// Mean over devices of the magnitude of an error, `error` being a member such as &DeviceFit::K_eff_error_percent.
std::optional<double> mean_magnitude(LawResult const& law, std::optional<double> DeviceFit::*error);

// The largest displacement at which a law was shown to hold: of what was fitted, and of what it predicts where it does.
// Empty where it was identified on no device.
std::optional<double> largest_displacement(Summary const& summary, LawResult const& law);

// Devices that hold the same record, by two or more. Of one that takes no part its file says so, of others the samples.
std::vector<std::vector<DeviceResult const*>> devices_of_one_record(Summary const& summary);
// Devices that hold the same compression test, by two or more.
std::vector<std::vector<DeviceResult const*>> devices_of_one_compression(Summary const& summary);

// Indices of the laws by rising mean objective; laws without one come last, in their order.
std::vector<std::size_t> by_objective(Summary const& summary);

// Devices that were read, in the order of the summary.
std::vector<std::string> device_names(Summary const& summary);

// nullptr where the law was not tried on the device.
DeviceFit const* fit_of(LawResult const& law, std::string_view device);

// A law's parameters as its first identified device lists them; empty when there is none.
std::vector<ParameterFit> const& parameters_of(LawResult const& law);

// Where a parameter stands in the vectors of a population; nullopt for one that it does not hold: fixed, tied, or
// redundant where it is of the form without it. A law's own order is another one.
std::optional<std::size_t> place_of(lot::Population const& population, std::string_view parameter);

}  // namespace isolaw::study
