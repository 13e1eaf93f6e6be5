// What decides the numbers of a campaign. Two campaigns with equal settings, inputs and seed give equal results.
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

// best: descents from many starts, to the least objective there is. genetic: the paper's search.
enum class Method { best, genetic };

inline constexpr int most_jobs = 4096;  // threads that may be asked for, which decide no number

struct Settings {
  std::vector<std::string> laws;  // ids, in the order of reports; empty: the usual ones
  Method method = Method::best;
  laws::Integration integration = laws::Integration::converged;
  laws::TurningPoints turning_points = laws::TurningPoints::as_sampled;
  int runs = 0;                       // 0: as many as the method needs, see complete()
  opt::MultistartOptions multistart;  // of `best`
  opt::GeneticOptions genetic;        // of `genetic`
  std::uint64_t seed = 1;
  fit::BoxKind box = fit::BoxKind::scaled;
  std::vector<fit::Override> overrides;
  data::CleanOptions clean;
  bool analysis = true;  // what the tests determine, intervals, one law for the lot
  int replicates = 100;  // of the bootstrap
  bool springs = false;  // with the analyses: laws without a coupled form in the plane fitted as springs as well

  // What was left to the method: 3 runs of `best`, which differ by the last digits; 20 of the paper's.
  void complete();
  void validate() const;  // throws Error
};

// Every setting of the method with its value as JSON text, in a fixed order; and back. Throws Error: one that is
// missing, or not what it may be.
std::vector<std::pair<std::string, std::string>> to_pairs(Settings const& settings);
Settings settings_from_pairs(std::vector<std::pair<std::string, std::string>> const& pairs);

// What runs where no laws are asked for.
inline constexpr std::string_view usual_laws = laws::law_sets[1].first;

// "paper", "usual", "all" or ids, by commas: the ids of known laws without repetition. Throws Error that lists the
// laws.
std::vector<std::string> parse_laws(std::string_view text);
int parse_lot_size(std::string_view text);  // 1 to 10,000,000

}  // namespace isolaw::campaign
