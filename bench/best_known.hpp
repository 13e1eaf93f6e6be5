// best_known.toml holds the smallest objectives known for named problems, over every method ever tried. They judge a
// search even if all its own runs ended in the same wrong valley.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::bench {

struct BestKnown {
  std::string record;    // "example lot, D03"
  std::string settings;  // "box published, integration converged"
  std::string law;
  std::string key;  // problem_key()
  double objective = 0.0;
  std::vector<double> parameters;  // all of the law's, in its order
  std::string found_by;            // "isolaw best", "SciPy differential evolution"
};

// SHA-256 of everything that decides the smallest objective: law, integration, turning points, cleaned record, and the
// values between which each parameter is free. It does not contain the scales of the parameters or the kind of search,
// which a method may choose. Numbers count to nine digits, and those of a channel to nine digits of the largest, so
// that the same record has the same key if another compiler's program cleaned it.
std::string problem_key(laws::LawEntry const& law, laws::Integration integration, laws::TurningPoints turning_points,
                        data::FitRecord const& record, fit::SearchBox const& box);

// Throws one Error that lists every mistake of the text with its line. Messages use `file` as the name of the text.
std::vector<BestKnown> read_best_known(std::string_view text, std::string const& file);
std::vector<BestKnown> load_best_known(std::string const& file);
std::string best_known_text(std::span<BestKnown const> entries);

// An objective counts as lower if it is lower by this relative difference; less is rounding or the last digits of a
// search.
inline constexpr double least_lowering = 1e-6;

// Puts a result into `entries`, and never raises an objective of theirs. `redefined`: an entry with the same record,
// law and settings had another key. Its problem no longer exists, so the new entry replaces it.
enum class Change { none, added, lowered, redefined };
Change lower(std::vector<BestKnown>& entries, BestKnown const& found);

}  // namespace isolaw::bench
