// Which law to take, for what: one answer from everything that a campaign tells of its laws. docs/decision.md has the
// rule and what outranks what.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

enum class Purpose {
  untested_device,  // design of a building: devices and amplitudes that were not tested
  these_tests,      // description of what was measured
  simplest          // the fewest parameters that serve
};
std::string_view name(Purpose purpose);  // "untested-device", "these-tests", "simplest"

enum class Sure { clear, tie, weak };
std::string_view name(Sure sure);

// Where a law stands for a purpose.
enum class Place { taken, tied, behind, ruled_out };
std::string_view name(Place place);  // "taken", "ties", "behind", "ruled out"
struct Standing {
  std::size_t law = 0;  // index into Summary::laws
  Place place = Place::behind;
  std::optional<double> error;  // as the purpose measures it
  std::string reason;           // why it is ruled out, as the end of a sentence about it
};

struct Recommendation {
  Purpose purpose = Purpose::untested_device;
  std::string title;                // "For a device not tested": of what there is an error for
  std::optional<std::size_t> law;   // index into Summary::laws; empty: none can be recommended
  Sure sure = Sure::weak;           // what makes a choice weak outranks that it ties
  std::optional<double> error;      // of that law, as the purpose measures it; 0 is perfect
  std::string measure;              // what that error is of
  std::vector<std::size_t> ties;    // the laws that cannot be told from it, best first, without it
  std::vector<Standing> standings;  // of every law, best first, those ruled out last
  std::string answer;               // one sentence: take this law, or none
  std::string why;                  // one sentence or two
  std::string would_decide;         // the test that would; "" where nothing is open
  std::string valid;                // where it was shown to hold: "up to 230 mm"; "" without a law
  std::string programs;             // what an analysis takes it by where programs lack it; "" where they have it
};

// Two laws or more were identified: the only one was chosen from nothing.
bool compares_laws(Summary const& summary);

// Of every purpose, in their order; none for an inspection.
std::vector<Recommendation> recommendations(Summary const& summary);

// The answer in one sentence: what the page and the terminal open with.
std::string verdict_sentence(std::vector<Recommendation> const& made);

// Two laws tie where their mean difference over the devices is within this many standard errors of it, or, of one
// device, which has no scatter, within this share of the smaller error.
inline constexpr double tie_errors = 2.0, tie_share = 0.15;
// What the simplest law may lose against the best: this share of its error, or this much.
inline constexpr double simple_share = 0.5, simple_error = 0.02;
// A search of which fewer runs than this end near the least objective is no sure one.
inline constexpr double found_share = 0.5;
// And of a law the tests should leave no larger share of the parameters open, where nothing shows that it predicts.
inline constexpr double open_share = 0.5;

}  // namespace isolaw::study
