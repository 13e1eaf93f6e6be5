// The least objectives known of named problems, over every method ever tried: best_known.toml. A search is judged by
// them where its own runs might all have ended in the same wrong valley.
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
  std::string key;  // of the problem
  double objective = 0.0;
  std::vector<double> parameters;  // all of the law's, in its order
  std::string found_by;            // "isolaw best", "SciPy differential evolution"
};

// What decides the least objective, as a SHA-256: law, integration, turning points, cleaned record, and between which
// values each parameter is free. Not the scale it is searched on, which every method may choose, nor how it is
// searched. Numbers count to nine digits, those of a channel to nine of its largest, so that the same record cleaned by
// another compiler's program has the same key.
std::string problem_key(laws::LawEntry const& law, laws::Integration integration, laws::TurningPoints turning_points,
                        data::FitRecord const& record, fit::SearchBox const& box);

// Throws one Error with every mistake of the text and its line; `file` is its name in messages.
std::vector<BestKnown> read_best_known(std::string_view text, std::string const& file);
std::vector<BestKnown> load_best_known(std::string const& file);
// The text that reads back as `entries`.
std::string best_known_text(std::span<BestKnown const> entries);

// An objective counts as lower when it is by more than this, relative: less is rounding and the last digits of a
// search.
inline constexpr double least_lowering = 1e-6;

// Takes what was found into `entries`, which it never raises. `redefined`: there was an entry of that record, law and
// settings, but of another key; the problem it belonged to is no more, so the new one takes its place.
enum class Change { none, added, lowered, redefined };
Change lower(std::vector<BestKnown>& entries, BestKnown const& found);

}  // namespace isolaw::bench
