// Reads and writes best_known.toml. For each named problem that file holds the smallest objective that any search ever
// found. The benchmark judges every search by this objective. In this way it notices if all runs of a search end in the
// same local minimum.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::bench {

struct BestKnown {
  std::string record;    // for example "example lot, D03"
  std::string settings;  // for example "box published, integration converged"
  std::string law;
  std::string key;  // result of problem_key()
  double objective = 0.0;
  std::vector<double> parameters;  // all parameters, fixed ones too, in the law's order
  std::string found_by;            // for example "isolaw best" or "SciPy differential evolution"
};

// SHA-256 of everything that decides the smallest objective: law, integration, turning points, cleaned record with its
// weights, and for each parameter the limits of its search or its fixed value. The key does not depend on the kind of
// search, nor on whether the search works with a parameter or its logarithm. All numbers are rounded before they are
// hashed: the channels of the record to nine digits of their largest value, other numbers to nine digits. Programs of
// different compilers thus get the same key for the same record.
std::string problem_key(laws::LawEntry const& law, laws::Integration integration, laws::TurningPoints turning_points,
                        data::FitRecord const& record, fit::SearchBox const& box);

// Reads the entries. Throws one Error that lists every mistake of the text with its line. Messages use `file` as the
// name of the text.
std::vector<BestKnown> read_best_known(std::string_view text, std::string const& file);
std::vector<BestKnown> load_best_known(std::string const& file);
std::string best_known_text(std::span<BestKnown const> entries);

// A new objective replaces an old one only if it is smaller by this relative difference. A smaller gain comes from
// rounding or from unfinished convergence.
inline constexpr double least_lowering = 1e-6;

// Adds `found` to `entries` or replaces an entry by it. An entry with the same key is replaced only by a smaller
// objective. If an entry with the same record, law and settings has another key, the problem itself has changed;
// `found` then replaces this entry, and the result is `redefined`.
enum class Change { none, added, lowered, redefined };
Change lower(std::vector<BestKnown>& entries, BestKnown const& found);

}  // namespace isolaw::bench
