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
  std::optional<double> error;    // as the purpose measures it
  std::optional<Finding> reason;  // why it is ruled out
};

struct Recommendation {
  Purpose purpose = Purpose::untested_device;
  std::string title;                // "For a device not tested"
  std::optional<std::size_t> law;   // index into Summary::laws; empty: none can be recommended
  Sure sure = Sure::weak;           // a choice with a weakness is weak even if it ties
  std::optional<double> error;      // error of that law, as the purpose measures it; 0 is perfect
  std::string measure;              // where that error was found: "fitted to each device"
  std::vector<std::size_t> ties;    // the other laws whose errors do not differ enough from it, best first
  std::vector<Standing> standings;  // every law, best first, those ruled out last
  Finding answer;                   // recommends this law, or none
  std::vector<Finding> why;
  std::vector<Finding> weak;        // why the choice is not sure
  std::vector<Finding> surer;       // what would make it surer; empty if nothing is open
  std::optional<double> valid_mm;   // largest_displacement() of the law
  std::optional<Finding> programs;  // how to use the law in analysis programs that lack it
};

bool compares_laws(Summary const& summary);
// One for each purpose, in the order of Purpose; none for an inspection.
std::vector<Recommendation> recommendations(Summary const& summary);
// The answer that the page and the terminal open with; none for an inspection.
std::optional<Finding> verdict(std::vector<Recommendation> const& recommendations);
// Two laws tie if the mean difference of their errors over the devices is within this many of its standard errors. With
// a single device they tie if their errors differ by at most this share of the smaller one.
inline constexpr double tie_errors = 2.0, tie_share = 0.15;
// The simplest law's error may exceed the best law's error by this share of it or by this much, whichever is larger.
inline constexpr double simple_share = 0.5, simple_error = 0.02;
// A choice is weak if less than this share of the law's runs ends near the least objective.
inline constexpr double found_share = 0.5;
// A choice is weak if the tests leave more than this share of the parameters open and no blocks were predicted.
inline constexpr double open_share = 0.5;

}  // namespace isolaw::study
