#include "isolaw/campaign/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/analyse.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::campaign {
namespace {

// Two objectives are close if their difference is at most evaluation_tolerance times the larger of them, or times
// smallest_objective if both are smaller. Objectives that small arise if the law itself computed the record, and may
// consist of rounding errors.
constexpr double smallest_objective = 1e-3;
bool close_objectives(double a, double b) {
  return std::abs(a - b) <= fit::evaluation_tolerance * std::max({std::abs(a), std::abs(b), smallest_objective});
}

bool close(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= fit::evaluation_tolerance * std::max(std::abs(a), std::abs(b));
}

// Two series are close if no pair of values differs by more than evaluation_tolerance times the largest magnitude in
// the first series. A tolerance relative to each value would be too strict where a value is near zero.
bool close(std::vector<double> const& a, std::vector<double> const& b) {
  double size = 0.0;
  for (double const value : a) size = std::max(size, std::abs(value));
  return std::ranges::equal(
      a, b, [size](double x, double y) { return x == y || std::abs(x - y) <= fit::evaluation_tolerance * size; });
}

void check_record(Device const& device, Settings const& settings, std::vector<std::string>& faults) {
  try {
    auto const again = data::clean(device.raw, settings.clean);
    auto const& stored = device.record;
    if (!close(again.time_s, stored.time_s) || !close(again.disp_mm, stored.disp_mm) ||
        !close(again.vel_mm_s, stored.vel_mm_s) || !close(again.force_kN, stored.force_kN) ||
        again.starts != stored.starts || again.scored != stored.scored || again.block != stored.block ||
        !close(again.weights, stored.weights) || !close(again.dead_band_mm, stored.dead_band_mm))
      faults.push_back(fmt::format("{}: the record the laws saw is not the one its raw record gives", device.name));
  } catch (Error const& error) {
    faults.push_back(fmt::format("{}: its raw record cannot be cleaned again: {}", device.name, error.what()));
  }
}

// It is a fault if the stored curve does not have the stored hash. A stiffness that differs from the stored one goes to
// `found` instead, since perhaps only another build computed it.
void check_vertical(Device const& device, std::vector<std::string>& faults, std::vector<std::string>& found) {
  auto const& test = device.vertical;
  if (!test.curve_sha256.empty() && test.curve_sha256 != data::curve_hash(test))
    faults.push_back(fmt::format("{}: the curve of its compression test is not the one that was read", device.name));
  if (!test.found_kN_per_mm) return;
  try {
    double const again = data::vertical_stiffness(test).K_v_kN_per_mm;
    if (!close(again, *test.found_kN_per_mm))
      found.push_back(fmt::format("{}: its compression test gives K_v = {} kN/mm, stored is {}", device.name, again,
                                  *test.found_kN_per_mm));
  } catch (Error const& error) {
    found.push_back(fmt::format("{}: its compression test gives no K_v, stored is {} kN/mm: {}", device.name,
                                *test.found_kN_per_mm, error.what()));
  }
}

void check_box(Device const& device, Search const& search, Settings const& settings, std::vector<std::string>& faults) {
  auto const& law = laws::find_law(search.law);
  auto const box = search_box(law, device.record, settings).parameters;
  bool const same = std::ranges::equal(box, search.first_box.parameters, [](auto const& a, auto const& b) {
    return a.free == b.free && a.scale == b.scale && a.tied_to == b.tied_to && close(a.value, b.value) &&
           close(a.lower, b.lower) && close(a.upper, b.upper);
  });
  if (!same)
    faults.push_back(fmt::format("{} on {}: the search box is not that of its record", search.law, device.name));
}

class Checker {
 public:
  Checker(Contents const& contents, Check& result, std::vector<std::string>& found)
      : contents_(contents), result_(result), found_(found) {}

  void operator()(Search const& search, Run const& run) {
    auto const where = fmt::format("{} on {}, run {}", run.law, name_of(run.device), run.number);
    check_course(where, search, run);
    if (!std::ranges::is_sorted(run.history, std::ranges::greater())) complain(where, "its history rises");
    if (!run.usable()) return;
    if (run.history.empty() || (run.refinement == 1 && !close_objectives(run.history.back(), run.objective)))
      complain(where, "its history does not end at its objective");
    auto const box = box_of(search, run);
    for (std::size_t i = 0; i < run.parameters.size(); ++i) {
      auto const& p = box.parameters[i];
      auto const& first = search.first_box.parameters[i];
      if (p.lower > first.lower || p.upper < first.upper)
        complain(where, fmt::format("the box in which it ended does not hold the interval of {}", p.name));
      double const slack = fit::evaluation_tolerance * std::max(std::abs(p.lower), std::abs(p.upper));
      bool const inside = p.free ? run.parameters[i] >= p.lower - slack && run.parameters[i] <= p.upper + slack
                                 : close(run.parameters[i], p.tied_to ? run.parameters[*p.tied_to] : p.value);
      if (!inside) complain(where, fmt::format("{} = {} lies outside its box", p.name, run.parameters[i]));
    }
    hold(where, run.device, run.law, run.refinement, run.parameters, run.objective);
    // The shift is the difference of two objectives, so it gets twice the tolerance of one objective.
    double const shift =
        law_on_device(contents_, run.device, run.law, run.refinement).integration_shift(run.parameters);
    bool const same = shift == run.integration_shift ||
                      std::abs(shift - run.integration_shift) <=
                          2.0 * fit::evaluation_tolerance * std::max({run.objective, shift, smallest_objective});
    if (!same)
      complain(where,
               fmt::format("its parameters give the integration shift {}, stored is {}", shift, run.integration_shift));
  }
  void operator()(DeviceAnalysis const& a) {
    auto const& found = a.determination;
    auto const where = fmt::format("{} on {}", a.law, name_of(a.device));
    hold(where + ", its optimum", a.device, a.law, a.refinement, found.optimum, found.objective);
    auto const* best = contents_.best_run(a.device, a.law);
    if (best == nullptr || best->refinement != a.refinement)
      complain(where, "it was not examined as its runs ended");
    else if (found.objective > best->objective * (1.0 + fit::evaluation_tolerance))
      complain(where, "its optimum is worse than its best run");
    for (auto const& p : found.parameters) {
      bool const rises = std::ranges::is_sorted(p.profile.value);
      bool const above = std::ranges::all_of(
          p.profile.objective, [&](double value) { return value >= found.objective * (1.0 - 1e-3) - 1e-9; });
      if (!rises || !above) complain(where, "a profile is not in order, or falls below its optimum");
    }
    auto const models = law_on_swings(contents_, a.device, a.law, a.refinement);
    if (a.larger_swings && !models) complain(where, "it predicts larger swings, and its test has none that tell");
    if (!a.larger_swings || !models) return;
    auto const& larger = *a.larger_swings;
    compare(where + ", on small swings", analysis::mean_objective(models->small, larger.parameters), larger.fitted);
    compare(where + ", on large swings", analysis::mean_objective(models->large, larger.parameters), larger.predicted);
  }
  void operator()(LotAnalysis const& a) {
    for (std::size_t i = 0; i < a.devices.size() && !a.mean.parameters.empty(); ++i) {
      auto const where = fmt::format("{} for the lot, on {}", a.law, name_of(a.devices[i]));
      hold(where, a.devices[i], a.law, a.refinement, a.mean.parameters, a.mean.objectives[i]);
      hold(where + ", worst device", a.devices[i], a.law, a.refinement, a.worst.law.parameters,
           a.worst.law.objectives[i]);
    }
  }
  void operator()(LeftOutAnalysis const& a) {
    auto const lot = std::ranges::find(contents_.lot_analyses, a.law, &LotAnalysis::law);
    auto const where = fmt::format("{} without {}", a.law, name_of(a.device));
    if (lot == contents_.lot_analyses.end())
      complain(where, "there is no law of the lot");
    else if (!a.left_out.parameters.empty())
      hold(where, a.device, a.law, lot->refinement, a.left_out.parameters, a.left_out.objective);
  }

 private:
  // Checks the number of evaluations and the outcome of a run, as far as the settings and the history determine them.
  void check_course(std::string const& where, Search const& search, Run const& run) {
    bool const searched = search.box.free_count() > 0;
    auto const [evaluations, end] =
        contents_.settings.method == Method::best ? descents(searched, run) : generations(searched, run);
    bool const all_failed = run.failed_evaluations == run.evaluations;
    if (!evaluations || run.failed_evaluations < 0 || run.failed_evaluations > run.evaluations ||
        (run.usable() && all_failed))
      complain(where, "its count of evaluations is impossible");
    if (!end || run.usable() != (run.outcome != Outcome::no_finite_value))
      complain(where, "its history does not end as the settings and its outcome say");
  }
  struct Possible {
    bool evaluations, end;
  };
  Possible generations(bool searched, Run const& run) const {
    auto const& genetic = contents_.settings.genetic;
    auto const count = run.history.size();
    auto const evaluations = searched ? static_cast<std::size_t>(genetic.population) * count : std::size_t{1};
    return {.evaluations = std::cmp_equal(run.evaluations, evaluations) &&
                           (run.usable() || run.failed_evaluations == run.evaluations),
            .end = searched ? opt::outcome_of(run.history, genetic) == run.outcome
                            : count == 1 && run.outcome != Outcome::stagnated};
  }
  // With Method::best the history has one value for each start, one for the final refinement of a confirmed search, and
  // one for each wider box in which the run gained.
  Possible descents(bool searched, Run const& run) const {
    auto const& options = contents_.settings.multistart;
    auto const least = static_cast<std::size_t>(searched && run.usable() ? options.least_starts : 1);
    return {
        .evaluations = searched ? std::cmp_greater_equal(run.evaluations, run.history.size()) : run.evaluations == 1,
        .end = run.outcome == Outcome::confirmed      ? run.history.size() >= least
               : run.outcome == Outcome::budget_spent ? run.evaluations >= options.most_evaluations
                                                      : run.outcome == Outcome::no_finite_value};
  }
  void hold(std::string const& where, std::size_t device, std::string const& law, int refinement,
            std::vector<double> const& parameters, double stored) {
    compare(where, law_on_device(contents_, device, law, refinement).objective(parameters, work_), stored);
  }
  void compare(std::string const& where, double again, double stored) {
    bool const both_infinite = std::isnan(stored) && !std::isfinite(again);  // a stored NaN stands for no finite force
    double const difference =
        both_infinite || again == stored ? 0.0 : std::abs(again - stored) / std::max(stored, smallest_objective);
    result_.largest_difference = std::max(result_.largest_difference, difference);
    if (!(difference <= fit::evaluation_tolerance))
      complain(where, fmt::format("its parameters give the objective {}, stored is {}", again, stored));
  }
  void complain(std::string_view where, std::string_view what) { found_.push_back(fmt::format("{}: {}", where, what)); }
  std::string const& name_of(std::size_t device) const { return contents_.devices[device].name; }

  Contents const& contents_;
  Check& result_;
  std::vector<std::string>& found_;
  std::vector<double> work_;
};

}  // namespace

Check check(std::filesystem::path const& file) {
  Check result;
  auto const contents = Store::read(file);
  result.faults = sqlite::integrity(file);
  std::ranges::move(Store::foreign_rows(file, contents), std::back_inserter(result.faults));
  result.devices = contents.devices.size();
  result.searches = contents.searches.size();
  result.runs = contents.runs.size();
  result.expected_runs = contents.expected_here();
  auto const me = this_maker();
  result.of_another_build =
      !std::ranges::all_of(contents.makers, [&](auto const& maker) { return same_build(maker, me); });
  auto& found = result.of_another_build ? result.differences : result.faults;
  for (auto const& device : contents.devices)
    if (device.usable()) check_record(device, contents.settings, found);
  for (auto const& device : contents.devices) check_vertical(device, result.faults, found);
  std::map<std::pair<std::size_t, std::string_view>, Search const*> searches;
  for (auto const& search : contents.searches) {
    searches[{search.device, search.law}] = &search;
    if (search.refusal.empty()) check_box(contents.devices[search.device], search, contents.settings, found);
  }
  Checker checked(contents, result, found);
  for (auto const& run : contents.runs) checked(*searches.at({run.device, run.law}), run);
  std::ranges::for_each(contents.device_analyses, std::ref(checked));
  std::ranges::for_each(contents.lot_analyses, std::ref(checked));
  std::ranges::for_each(contents.left_out, std::ref(checked));
  result.analyses = contents.analyses();
  result.expected_analyses = contents.part ? 0 : contents.expected_analyses();
  return result;
}

}  // namespace isolaw::campaign
