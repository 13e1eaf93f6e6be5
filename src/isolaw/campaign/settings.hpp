// The settings that a campaign's numbers depend on. Equal settings (with the seed) and equal inputs give equal results.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/data/clean.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/opt/genetic.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::campaign {

// best: descents from many starts look for the least objective. genetic: the genetic algorithm of Cucuzza et al. 2025.
enum class Method { best, genetic };

inline constexpr int most_jobs = 4096;  // the most threads; results do not depend on their number

struct Settings {
  std::vector<std::string> laws;  // ids, in the order of reports; empty: usual_laws
  Method method = Method::best;
  laws::Integration integration = laws::Integration::converged;
  laws::TurningPoints turning_points = laws::TurningPoints::as_sampled;
  int runs = 0;                       // per law and device; 0: as many as the method needs, see complete()
  opt::MultistartOptions multistart;  // used by Method::best
  opt::GeneticOptions genetic;        // used by Method::genetic
  std::uint64_t seed = 1;
  fit::BoxKind box = fit::BoxKind::scaled;
  std::vector<fit::Override> overrides;
  data::CleanOptions clean;
  bool analysis = true;  // also find which parameters the tests determine, their intervals, and laws of the whole lot
  int replicates = 100;  // bootstrap replicates of an analysis
  bool springs = false;  // the analyses also fit spring models for laws that have no coupled two-dimensional form
  // Chooses the settings that the user left open. The number of runs becomes 2 for `best`, whose runs differ only in
  // the last digits, and 20 for `genetic`. Samples get weights by time, as in Cucuzza et al. 2025, if the algorithm or
  // the boxes are those of that paper.
  void complete();
  void validate() const;  // throws Error
};

// to_pairs() returns every setting of the method with its value as JSON text, in a fixed order. settings_from_pairs()
// throws Error for a wrong value and for a missing setting that a store must have (Setting::value_if_absent).
std::vector<std::pair<std::string, std::string>> to_pairs(Settings const& settings);
Settings settings_from_pairs(std::vector<std::pair<std::string, std::string>> const& pairs);

inline constexpr std::string_view usual_laws = laws::law_sets[1].first;  // fitted if the user names no law
// Turns "paper,gallardo" into ids without repetition; "paper", "usual" and "all" name sets. Throws Error that lists the
// laws if a name is unknown.
std::vector<std::string> parse_laws(std::string_view text);
int parse_lot_size(std::string_view text);  // 1 to 10,000,000

}  // namespace isolaw::campaign
