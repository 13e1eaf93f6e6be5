// Recommends one law for each purpose, from all results of a campaign. docs/decision.md explains the rule.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

enum class Purpose {
  untested_device,  // design of a building: devices and amplitudes that were not tested
  these_tests,      // description of what was measured
  simplest          // the fewest parameters that are accurate enough
};
std::string_view name(Purpose purpose);  // "untested-device", "these-tests", "simplest"

enum class Sure { clear, tie, weak };
std::string_view name(Sure sure);

enum class Rank { taken, tied, behind, ruled_out };
std::string_view name(Rank place);  // "taken", "ties", "behind", "ruled out"
struct Standing {
  std::size_t law = 0;  // index into Summary::laws
  Rank place = Rank::behind;
  std::optional<double> error;    // misfit on the tests or on what was left out of the fit, as the purpose asks
  std::optional<Finding> reason;  // why the law is ruled out
};

struct Recommendation {
  Purpose purpose = Purpose::untested_device;
  std::string title;                // "For a device not tested"
  std::optional<std::size_t> law;   // index into Summary::laws; empty: none can be recommended
  Sure sure = Sure::weak;           // weak if the law has a weakness, even if it ties with others
  std::optional<double> error;      // its misfit on the tests, or on what was left out; 0 is perfect
  std::string measure;              // what that error was computed on: "fitted to each device"
  std::vector<std::size_t> ties;    // other laws whose errors hardly differ from this law's, best first
  std::vector<Standing> standings;  // every law, best first, those ruled out last
  Finding answer;                   // recommends this law, or none
  std::vector<Finding> why;
  std::vector<Finding> weak;        // why the choice is uncertain
  std::vector<Finding> surer;       // tests that would make the choice surer; empty if there are none
  std::optional<double> valid_mm;   // largest_displacement() of the law
  std::optional<Finding> programs;  // how to use the law in analysis programs that lack it
};

bool compares_laws(Summary const& summary);
// One recommendation for each purpose, in the order of Purpose. An inspection has none.
std::vector<Recommendation> recommendations(Summary const& summary);
// The answer that the page and the terminal show first. An inspection has none.
std::optional<Finding> verdict(std::vector<Recommendation> const& recommendations);
// Two laws tie if the mean difference of their errors over the devices is at most tie_errors times its standard error.
// With a single device they tie if their errors differ by at most the share tie_share of the smaller error.
inline constexpr double tie_errors = 2.0, tie_share = 0.15;
// The error of the simplest law may exceed the least error by the share simple_share of it or by simple_error,
// whichever is larger.
inline constexpr double simple_share = 0.5, simple_error = 0.02;
// A choice is weak if less than this share of the law's runs ends near the least objective.
inline constexpr double found_share = 0.5;
// A choice is weak if the tests leave more than this share of the parameters undetermined and no blocks were predicted.
inline constexpr double open_share = 0.5;

}  // namespace isolaw::study
