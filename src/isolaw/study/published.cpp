#include "isolaw/study/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "isolaw/base/words.hpp"
#include "isolaw/lot/robustness.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/opt/pareto.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"
#include "isolaw/study/table_a5.hpp"

namespace isolaw::study {
namespace {

constexpr std::size_t study_laws = table_a5::laws.size();
using Compared = std::optional<double> PublishedNumbers::*;
using Numbers = std::vector<int>;

struct Named {
  std::string law;
  PublishedNumbers numbers;
};
using ByNumber = std::array<Named, study_laws>;  // index 0 is law 1

Named const& law_of(ByNumber const& laws, int number) {
  return laws[static_cast<std::size_t>(number - 1)];
}
bool has_number(ByNumber const& laws, int number, Compared quantity) {
  return (law_of(laws, number).numbers.*quantity).has_value();
}
double number_of(ByNumber const& laws, int number, Compared quantity) {
  return *(law_of(laws, number).numbers.*quantity);
}

PublishedNumbers numbers_of(std::vector<double> const& device_means, std::vector<double> const& run_stds,
                            std::optional<double> const& beta) {
  PublishedNumbers numbers;
  auto const means = num::moments(device_means);
  if (means.count > 0) numbers.objective = means.mean;
  if (means.count > 1) numbers.std_over_devices = means.std;
  if (!run_stds.empty()) numbers.std_over_runs = num::moments(run_stds).mean;
  numbers.beta = beta;
  return numbers;
}

template <class Values>
std::vector<double> listed(Values const& values) {
  return {values.begin(), values.end()};
}

PublishedNumbers printed_numbers(table_a5::Law const& law) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> means;
  for (auto const& parameter : law.parameters) {
    names.emplace_back(parameter.name);
    means.push_back(listed(parameter.mean));
  }
  return numbers_of(listed(law.objective_mean), listed(law.objective_std), lot::robustness_index(names, means).beta);
}

PublishedNumbers numbers_here(LawResult const& law) {
  std::vector<double> means, stds;
  for (auto const& fit : law.counting()) {
    if (fit.objective.mean) means.push_back(*fit.objective.mean);
    if (fit.objective.std) stds.push_back(*fit.objective.std);
  }
  return numbers_of(means, stds, law.beta);
}

void mark_front_of(ByNumber& laws) {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> objectives, betas;
  for (auto const& law : laws) {
    objectives.push_back(law.numbers.objective.value_or(none));
    betas.push_back(law.numbers.beta.value_or(none));
  }
  auto const front = opt::non_dominated(objectives, betas);
  for (std::size_t i = 0; i < laws.size(); ++i) laws[i].numbers.on_front = front[i];
}

struct Judged {
  std::optional<bool> holds;
  std::string found;
};

std::string values_text(ByNumber const& laws, int number, Compared quantity) {
  double const shown = number_of(laws, number, quantity);
  return quantity == &PublishedNumbers::beta ? fmt::format("{:.3f}", shown) : fmt::format("{:.3g}", shown);
}

std::string ordered(ByNumber const& laws, Numbers numbers, Compared quantity) {
  std::ranges::stable_sort(numbers, {}, [&](int number) { return number_of(laws, number, quantity); });
  std::vector<std::string> texts;
  for (int const number : numbers)
    texts.push_back(std::string(laws::display_name(law_of(laws, number).law)) + " " +
                    values_text(laws, number, quantity));
  return joined(texts);
}

Numbers lacking(ByNumber const& laws, Numbers const& numbers, Compared quantity) {
  Numbers missing;
  for (int const number : numbers)
    if (!has_number(laws, number, quantity)) missing.push_back(number);
  return missing;
}

std::optional<Judged> not_judged(ByNumber const& laws, Numbers const& numbers,
                                 std::vector<Compared> const& quantities) {
  for (auto const quantity : quantities) {
    auto missing = lacking(laws, numbers, quantity);
    if (missing.empty()) continue;
    std::ranges::sort(missing);
    return Judged{std::nullopt, fmt::format("no {} of law{} {}",
                                            quantity == &PublishedNumbers::beta            ? "beta"
                                            : quantity == &PublishedNumbers::objective     ? "objective"
                                            : quantity == &PublishedNumbers::std_over_runs ? "scatter over the runs"
                                                                                           : "scatter over the devices",
                                            missing.size() == 1 ? "" : "s", fmt::join(missing, ", "))};
  }
  return std::nullopt;
}

Numbers all_numbers() {
  Numbers numbers;
  for (auto const& law : table_a5::laws) numbers.push_back(law.number);
  return numbers;
}

bool is_rising(ByNumber const& laws, Numbers const& numbers, Compared quantity) {
  return std::ranges::adjacent_find(numbers, [&](int a, int b) {
           return number_of(laws, a, quantity) >= number_of(laws, b, quantity);
         }) == numbers.end();
}

// Judges whether the laws with the numbers `first` in the study have smaller values than every other law. There is no
// verdict if one of these laws has no value, or if no other law has one.
Judged have_smallest(ByNumber const& laws, Numbers const& first, Compared quantity) {
  if (auto const open = not_judged(laws, first, {quantity})) return *open;
  Numbers there;
  double largest = 0.0, least_other = std::numeric_limits<double>::infinity();
  for (int const number : all_numbers()) {
    if (!has_number(laws, number, quantity)) continue;
    there.push_back(number);
    if (std::ranges::find(first, number) != first.end())
      largest = std::max(largest, number_of(laws, number, quantity));
    else
      least_other = std::min(least_other, number_of(laws, number, quantity));
  }
  auto const found = ordered(laws, there, quantity);
  if (there.size() == first.size()) return {std::nullopt, "no other law: " + found};
  return {largest < least_other, found};
}

Judged rising(ByNumber const& laws, Numbers const& numbers, Compared quantity) {
  if (auto const open = not_judged(laws, numbers, {quantity})) return *open;
  return {is_rising(laws, numbers, quantity), ordered(laws, numbers, quantity)};
}

constexpr Compared of_accuracy = &PublishedNumbers::objective, of_beta = &PublishedNumbers::beta;

// If all runs of each law reach the same objective, the scatter of the runs is only rounding. The statement that law 3
// scatters least is then not judged.
Judged law_3_scatters_least(ByNumber const& laws) {
  auto const ends_at_one_place = [](Named const& law) {
    auto const& numbers = law.numbers;
    return !numbers.std_over_runs || *numbers.std_over_runs <= found_within * numbers.objective.value_or(0.0);
  };
  auto judged = have_smallest(laws, {3}, &PublishedNumbers::std_over_runs);
  if (judged.holds && std::ranges::all_of(laws, ends_at_one_place))
    return {std::nullopt, "the runs of each law end at one place"};
  return judged;
}

std::string both_numbers(ByNumber const& laws, Numbers const& numbers) {
  return fmt::format("objective {}; beta {}", ordered(laws, numbers, of_accuracy), ordered(laws, numbers, of_beta));
}

Judged algebraic_trade(ByNumber const& laws) {
  Numbers const accurate{2, 3, 1}, robust{1, 3, 2};
  if (auto const open = not_judged(laws, robust, {of_accuracy, of_beta})) return *open;
  return {is_rising(laws, accurate, of_accuracy) && is_rising(laws, robust, of_beta), both_numbers(laws, robust)};
}

Judged law_5_beats_4_and_6(ByNumber const& laws) {
  Numbers const numbers{4, 5, 6};
  if (auto const open = not_judged(laws, numbers, {of_accuracy, of_beta})) return *open;
  bool const beats = std::ranges::all_of(Numbers{4, 6}, [&](int other) {
    return number_of(laws, 5, of_accuracy) <= number_of(laws, other, of_accuracy) &&
           number_of(laws, 5, of_beta) <= number_of(laws, other, of_beta);
  });
  return {beats, both_numbers(laws, numbers)};
}

Judged published_front(ByNumber const& laws) {
  auto const all = all_numbers();
  if (auto const open = not_judged(laws, all, {of_accuracy, of_beta})) return *open;
  Numbers const expected{1, 2, 3, 5};
  Numbers front;
  std::vector<std::string> names;
  for (int const number : all) {
    if (!law_of(laws, number).numbers.on_front) continue;
    front.push_back(number);
    names.emplace_back(laws::display_name(law_of(laws, number).law));
  }
  return {front == expected, "not dominated: " + enumerate(names, study_laws)};
}

Judged below_a_tenth(ByNumber const& laws) {
  Numbers const all{2, 3, 4, 5, 6};
  if (auto const open = not_judged(laws, all, {of_accuracy})) return *open;
  constexpr double tenth = 0.10;
  bool const so = std::ranges::all_of(all, [&](int number) { return number_of(laws, number, of_accuracy) < tenth; });
  return {so, ordered(laws, all, of_accuracy)};
}

struct Statement {
  std::string_view where, text;
  Judged (*judge)(ByNumber const&);
};

constexpr Statement stated[]{
    {"Section 5", "Laws 2 to 6 have mean objectives below 0.10.", below_a_tenth},
    {"Section 6", "Laws 2 and 5 have the smallest mean objectives.",
     [](ByNumber const& laws) {
       return have_smallest(laws, {2, 5}, of_accuracy);
     }},
    {"Section 6", "Law 3 scatters least over the runs.", law_3_scatters_least},
    {"Section 6", "Laws 3 and 4 scatter least over the devices.",
     [](ByNumber const& laws) {
       return have_smallest(laws, {3, 4}, &PublishedNumbers::std_over_devices);
     }},
    {"Section 6", "Of the differential laws 5 is the most accurate, then 4, then 6.",
     [](ByNumber const& laws) {
       return rising(laws, {5, 4, 6}, of_accuracy);
     }},
    {"Section 6", "Of the differential laws 4 is the most robust, then 5, then 6.",
     [](ByNumber const& laws) {
       return rising(laws, {4, 5, 6}, of_beta);
     }},
    {"Section 8", "Law 1 is the most robust of all.",
     [](ByNumber const& laws) { return have_smallest(laws, {1}, of_beta); }},
    {"Section 8", "From law 1 over law 3 to law 2 accuracy grows and robustness falls.", algebraic_trade},
    {"Section 8", "Law 5 is both more accurate and more robust than laws 4 and 6.", law_5_beats_4_and_6},
    {"Fig. 14", "Laws 1, 2, 3 and 5 are not dominated, laws 4 and 6 are.", published_front},
};

std::string verdict_of(std::vector<PublishedStatement> const& statements) {
  auto const count = [&](std::optional<bool> here) {
    return std::ranges::count(statements, here, &PublishedStatement::holds_here);
  };
  auto const holds = count(true), fails = count(false), open = count(std::nullopt);
  auto text = fmt::format("{} of {} statements of the published study hold here, {} do{} not", holds, statements.size(),
                          fails, fails == 1 ? "es" : "");
  if (open > 0) text += fmt::format(", {} cannot be judged", open);
  auto const in_table = std::ranges::count(statements, true, &PublishedStatement::holds_in_table);
  return text + fmt::format("; {} hold in its own Table A.5.", in_table);
}

std::vector<std::string> readings(table_a5::Law const& law) {
  std::vector<std::string> ids{std::string(law.id)};
  if (!law.other_reading.empty()) ids.emplace_back(law.other_reading);
  return ids;
}

}  // namespace

std::optional<Published> published(Summary const& summary) {
  Published comparison;
  ByNumber printed, here;
  for (auto const& law : table_a5::laws) {
    auto const place = static_cast<std::size_t>(law.number - 1);
    printed[place] = {std::string(law.id), printed_numbers(law)};
    auto const names = readings(law);
    bool found = false;
    for (auto const& name : names) {
      auto const result = std::ranges::find(summary.laws, name, &LawResult::id);
      if (result == summary.laws.end() || !result->objective.mean) continue;
      comparison.laws.push_back({law.number, name, !found, {}, numbers_here(*result)});
      if (!found) here[place] = {name, comparison.laws.back().computed};
      found = true;
    }
    if (!found) comparison.laws.push_back({law.number, names.front(), false, {}, {}});
  }
  if (std::ranges::count(comparison.laws, true, &PublishedLaw::compared) < 2) return std::nullopt;

  mark_front_of(printed);
  mark_front_of(here);
  for (auto& law : comparison.laws) {
    auto const place = static_cast<std::size_t>(law.number - 1);
    law.printed = printed[place].numbers;
    if (law.compared) law.computed.on_front = here[place].numbers.on_front;
  }
  for (auto const& [where, text, judge] : stated) {
    auto const [holds, found] = judge(here);
    comparison.statements.push_back(
        {std::string(where), std::string(text), judge(printed).holds.value_or(false), holds, found});
  }
  comparison.source =
      "Cucuzza, Londono Lopez, Domaneschi, Greco, Marano: High Damping Rubber Bearings: Optimal models evaluation "
      "considering production variability. Structures 73 (2025) 108355";
  comparison.verdict = verdict_of(comparison.statements);
  return comparison;
}

}  // namespace isolaw::study
