#include "isolaw/study/recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

struct Known {
  double error = 0.0;
  std::vector<std::pair<std::string_view, double>> of_devices = {};
};

template <class ErrorOn>
Known over_devices(LawResult const& law, double error, ErrorOn error_on) {
  Known known{.error = error};
  for (auto const& fit : law.devices)
    if (auto const value = error_on(fit)) known.of_devices.emplace_back(fit.device, *value);
  return known;
}

std::optional<double> predicted_of(DeviceFit const& fit) {
  double sum = 0.0;
  int count = 0;
  for (auto const& block : fit.blocks) {
    if (block.fitted) continue;
    sum += block.objective;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

// The mean error on blocks that the law was not fitted to or on devices left out, whichever error is larger.
std::optional<Known> known_for_untested(LawResult const& law) {
  auto const& loo = law.loo_objective;
  auto const& predicted = law.predicted_objective;
  if (!loo && !predicted) return std::nullopt;
  if (predicted && (!loo || *predicted >= *loo)) return over_devices(law, *predicted, predicted_of);
  return over_devices(law, *loo, [](DeviceFit const& fit) { return fit.left_out_objective; });
}

std::optional<Known> known_of_tests(LawResult const& law) {
  if (law.objective_converged)
    return over_devices(law, *law.objective_converged, [](DeviceFit const& fit) { return fit.optimum; });
  if (!law.objective.mean) return std::nullopt;
  double sum = 0.0;
  int count = 0;
  for (auto const& fit : law.devices)
    if (fit.objective.best) sum += *fit.objective.best, ++count;
  if (count == 0) return std::nullopt;
  return over_devices(law, sum / count, [](DeviceFit const& fit) { return fit.objective.best; });
}

std::optional<Known> known_for(bool untested, LawResult const& law) {
  return untested ? known_for_untested(law) : known_of_tests(law);
}

std::size_t calibrated(LawResult const& law) {
  auto const& parameters = parameters_of(law);
  return static_cast<std::size_t>(std::ranges::count_if(parameters, &ParameterFit::free));
}

std::optional<double> share_open(LawResult const& law) {
  int examined = 0, open = 0;
  for (auto const& fit : law.devices)
    for (auto const& parameter : fit.parameters) {
      if (!parameter.analysis) continue;
      ++examined;
      open += parameter.analysis->identifiability == analysis::Verdict::undetermined ? 1 : 0;
    }
  return examined > 0 ? std::optional(static_cast<double>(open) / examined) : std::nullopt;
}

struct Candidate {
  std::size_t index = 0;
  LawResult const* law = nullptr;
  Known known;
  std::size_t parameters = 0;
  std::vector<Finding> weak = {};  // why the choice is uncertain
};

bool may_be_taken(Summary const& summary, LawResult const& law) {
  auto const usable = device_names(summary).size();
  auto const identified = static_cast<std::size_t>(
      std::ranges::count_if(law.devices, [](auto const& fit) { return fit_status(fit) == "ok"; }));
  return law.objective.mean && identified == usable && is_adequate(law) && law.prediction_holds();
}

bool tie(Known const& best, Known const& other) {
  std::vector<double> differences;
  for (auto const& [device, error] : best.of_devices) {
    auto const found = std::ranges::find(other.of_devices, device, &std::pair<std::string_view, double>::first);
    if (found != other.of_devices.end()) differences.push_back(found->second - error);
  }
  if (differences.size() < 2) return other.error - best.error <= tie_share * best.error;
  auto const count = static_cast<double>(differences.size());
  double mean = 0.0, squares = 0.0;
  for (double const d : differences) mean += d / count;
  for (double const d : differences) squares += (d - mean) * (d - mean);
  return mean <= tie_errors * std::sqrt(squares / (count - 1.0) / count);
}

std::string grade_of_error(double error) {
  return std::string(name(graded(error, error, error)));
}

std::vector<Finding> weaknesses(Summary const& summary, Candidate const& candidate, Purpose purpose) {
  auto const& law = *candidate.law;
  double const error = candidate.known.error;
  std::vector<Finding> found;
  if (law.prediction_grade == PredictionGrade::fair)
    found.push_back({.kind = FindingKind::weak_prediction_fair, .law = law.id});
  else if (graded(error, error, error) > PredictionGrade::good)
    found.push_back({.kind = FindingKind::weak_error,
                     .law = law.id,
                     .numbers = {{"error", error}},
                     .words = {{"grade", grade_of_error(error)}}});
  if (!compares_laws(summary)) found.push_back({.kind = FindingKind::weak_only_law, .law = law.id});
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0)
    found.push_back({.kind = FindingKind::weak_incomplete});
  if (law.success_share && *law.success_share < found_share)
    found.push_back({.kind = FindingKind::weak_search, .law = law.id, .numbers = {{"share", *law.success_share}}});
  if (auto const held = pinned(law); held.decides()) {
    found.push_back(held.finding(law.id));
    found.back().kind = FindingKind::weak_bounds;
  }
  // If the law predicted blocks, the parameters that the tests leave undetermined have already proved harmless.
  if (purpose == Purpose::untested_device && !law.prediction_grade)
    if (auto const share = share_open(law); share && *share > open_share)
      found.push_back({.kind = FindingKind::weak_open, .law = law.id, .numbers = {{"share", *share}}});
  return found;
}

// Prefers a law without weaknesses, then one with fewer parameters, then one that analysis programs have.
bool preferred(Candidate const& a, Candidate const& b) {
  if (a.weak.empty() != b.weak.empty()) return a.weak.empty();
  if (a.parameters != b.parameters) return a.parameters < b.parameters;
  if (a.law->in_programs != b.law->in_programs) return a.law->in_programs;
  return a.known.error < b.known.error;
}

bool predicts_blocks(Summary const& summary) {
  return std::ranges::any_of(summary.laws, [](auto const& law) { return law.predicted_objective.has_value(); });
}

std::string measure_of(bool untested, LawResult const& law) {
  if (!untested) return "fitted to each device";
  bool const of_blocks =
      law.predicted_objective && (!law.loo_objective || *law.predicted_objective >= *law.loo_objective);
  return of_blocks ? "on blocks it was not fitted to" : "on a device it was not fitted to";
}

std::vector<Finding> what_would_decide(Summary const& summary, Purpose purpose, bool open) {
  constexpr std::size_t few = 5;
  auto const devices = device_names(summary).size();
  std::vector<Finding> steps;
  auto const add = [&](FindingKind kind) { steps.push_back({.kind = kind}); };
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) add(FindingKind::surer_finish);
  if (open && !compares_laws(summary)) add(FindingKind::surer_other_laws);
  bool const elsewhere = purpose != Purpose::these_tests;
  if (elsewhere && !predicts_blocks(summary) && (open || purpose == Purpose::untested_device)) {
    bool const several = std::ranges::any_of(summary.devices, [](auto const& device) {
      return device.status == "ok" && device.properties.blocks.size() > 1;
    });
    add(several ? FindingKind::surer_fit_blocks : FindingKind::surer_other_amplitude);
  }
  if (elsewhere && open && predicts_blocks(summary)) add(FindingKind::surer_further_test);
  if (elsewhere && (devices == 1 || (open && devices < few)))
    steps.push_back(
        {.kind = FindingKind::surer_more_devices, .numbers = {{"devices_tested", static_cast<double>(devices)}}});
  if (open && steps.empty()) add(FindingKind::surer_amplitude_between);
  return steps;
}

// The title names the kinds of untested things for which errors are known: devices left out, blocks, or both.
std::string title_of(Summary const& summary, Purpose purpose) {
  if (purpose == Purpose::these_tests) return "For these tests";
  if (purpose == Purpose::simplest) return "Simplest that serves";
  bool const devices = std::ranges::any_of(summary.laws, [](auto const& law) { return law.loo_objective.has_value(); });
  if (predicts_blocks(summary)) return devices ? "For devices and blocks not tested" : "For blocks not tested";
  return devices ? "For a device not tested" : "For what was not tested";
}

std::vector<Finding> why_none(Summary const& summary, Purpose purpose) {
  auto const identified =
      std::ranges::count_if(summary.laws, [](auto const& law) { return law.objective.mean.has_value(); });
  if (identified == 0) return {{.kind = FindingKind::none_identified}};
  Names far, failing, partial;
  for (auto const& law : summary.laws) {
    if (!law.objective.mean) continue;
    if (!is_adequate(law))
      far.push_back(law.id);
    else if (!law.prediction_holds())
      failing.push_back(law.id);
    else if (!may_be_taken(summary, law))
      partial.push_back(law.id);
  }
  std::vector<Finding> reasons;
  auto const add = [&](FindingKind kind, Names laws) {
    if (!laws.empty()) reasons.push_back({.kind = kind, .other_laws = std::move(laws)});
  };
  add(FindingKind::none_describes, std::move(far));
  add(FindingKind::none_predicts, std::move(failing));
  add(FindingKind::none_on_every_device, std::move(partial));
  if (!reasons.empty()) return reasons;
  if (purpose != Purpose::untested_device) return {{.kind = FindingKind::none_has_error}};
  return {
      {.kind = device_names(summary).size() > 1 ? FindingKind::none_left_out : FindingKind::none_beside_one_device}};
}

std::optional<Finding> ruled_out(Summary const& summary, LawResult const& law, bool known, double error) {
  auto const because = [&](FindingKind kind, std::string_view grade = {}) {
    Finding reason{.kind = kind, .law = law.id};
    if (!grade.empty()) reason.words = {{"grade", std::string(grade)}};
    return std::optional(std::move(reason));
  };
  if (!law.objective.mean) return because(FindingKind::out_not_identified);
  if (!is_adequate(law)) return because(FindingKind::out_inadequate);
  if (!law.prediction_holds()) return because(FindingKind::out_prediction, name(*law.prediction_grade));
  if (!may_be_taken(summary, law)) return because(FindingKind::out_partial);
  if (!known) return because(FindingKind::out_unknown);
  return error > fair_prediction ? because(FindingKind::out_error, grade_of_error(error)) : std::nullopt;
}

std::vector<Standing> standings_of(Summary const& summary, bool untested, std::vector<Candidate> const& chosen) {
  std::vector<Standing> standings, out;
  for (auto const& c : chosen)
    standings.push_back({c.index, standings.empty() ? Rank::taken : Rank::tied, c.known.error, {}});
  auto const first_behind = static_cast<std::ptrdiff_t>(standings.size());
  for (std::size_t i = 0; i < summary.laws.size(); ++i) {
    if (std::ranges::find(chosen, i, &Candidate::index) != chosen.end()) continue;
    auto const& law = summary.laws[i];
    auto const known = known_for(untested, law);
    auto const error = known ? std::optional(known->error) : std::nullopt;
    auto reason = ruled_out(summary, law, known.has_value(), error.value_or(0.0));
    auto& list = reason ? out : standings;
    list.push_back({i, reason ? Rank::ruled_out : Rank::behind, error, std::move(reason)});
  }
  auto const by_error = [](Standing const& s) { return s.error.value_or(std::numeric_limits<double>::infinity()); };
  std::ranges::stable_sort(standings.begin() + first_behind, standings.end(), {}, by_error);
  std::ranges::stable_sort(out, {}, by_error);
  standings.insert(standings.end(), out.begin(), out.end());
  return standings;
}

Recommendation none(Summary const& summary, Purpose purpose, bool untested) {
  Recommendation answer;
  answer.purpose = purpose;
  answer.standings = standings_of(summary, untested, {});
  answer.why = why_none(summary, purpose);
  answer.answer = {.kind = FindingKind::no_law_recommended, .words = {{"purpose", std::string(name(purpose))}}};
  answer.surer = what_would_decide(summary, purpose, true);
  return answer;
}

// Names the law that fits the tests best if it was refused for its prediction: readers ask why it was not taken.
std::optional<Finding> closer_but_refused(Summary const& summary, Candidate const& taken, Purpose purpose) {
  if (purpose != Purpose::these_tests) return std::nullopt;
  LawResult const* closest = nullptr;
  double least = taken.known.error;
  for (auto const& law : summary.laws) {
    auto const known = known_of_tests(law);
    if (!known || known->error >= least || law.prediction_holds() || !is_adequate(law)) continue;
    closest = &law;
    least = known->error;
  }
  if (closest == nullptr) return std::nullopt;
  return Finding{.kind = FindingKind::why_closer_refused,
                 .law = closest->id,
                 .numbers = {{"error", least}},
                 .words = {{"grade", std::string(name(*closest->prediction_grade))}}};
}

bool asks_about_untested(Summary const& summary, Purpose purpose) {
  if (purpose != Purpose::simplest) return purpose == Purpose::untested_device;
  return std::ranges::any_of(summary.laws, [](auto const& law) { return known_for_untested(law).has_value(); });
}

// The laws that may be recommended, that of the least error first.
std::vector<Candidate> candidates_among(Summary const& summary, bool untested) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < summary.laws.size(); ++i) {
    auto const& law = summary.laws[i];
    if (!may_be_taken(summary, law)) continue;
    auto const known = known_for(untested, law);
    if (!known || known->error > fair_prediction) continue;
    candidates.push_back({.index = i, .law = &law, .known = *known, .parameters = calibrated(law)});
  }
  std::ranges::stable_sort(candidates, {}, [](auto const& c) { return c.known.error; });
  return candidates;
}

// The laws with the fewest parameters among those whose error is near the least.
std::vector<Candidate> simplest_of(std::vector<Candidate> candidates) {
  double const least = candidates.front().known.error;
  double const most = least + std::max(simple_share * least, simple_error);
  std::erase_if(candidates, [&](auto const& c) { return c.known.error > most; });
  auto const fewest = std::ranges::min_element(candidates, {}, &Candidate::parameters)->parameters;
  std::erase_if(candidates, [&](auto const& c) { return c.parameters != fewest; });
  return candidates;
}

// The laws that are equally good for the purpose, the preferred one first.
std::vector<Candidate> equally_good(Summary const& summary, Purpose purpose, std::vector<Candidate> const& candidates) {
  auto chosen = purpose == Purpose::simplest ? simplest_of(candidates) : candidates;
  std::erase_if(
      chosen, [least = chosen.front()](auto const& c) { return c.index != least.index && !tie(least.known, c.known); });
  // A grade comes before an error: a law of grade good is taken before a law of grade fair.
  auto const grade_of = [](Candidate const& c) { return c.law->prediction_grade.value_or(PredictionGrade::good); };
  auto const least_grade = std::ranges::min(chosen | std::views::transform(grade_of));
  std::erase_if(chosen, [&](auto const& c) { return grade_of(c) != least_grade; });
  for (auto& c : chosen) c.weak = weaknesses(summary, c, purpose);
  std::ranges::stable_sort(chosen, preferred);
  return chosen;
}

std::vector<Finding> why_taken(Summary const& summary, Recommendation const& advice,
                               std::vector<Candidate> const& candidates, Candidate const& taken, Names const& tied) {
  auto const& best = candidates.front();
  bool const simplest = advice.purpose == Purpose::simplest;
  std::vector<Finding> why{{.kind = FindingKind::why_error,
                            .law = taken.law->id,
                            .numbers = {{"error", taken.known.error}},
                            .words = {{"measure", advice.measure}}}};
  if (simplest) why.front().numbers.push_back({"parameters", static_cast<double>(taken.parameters)});
  if (simplest && taken.index != best.index)
    why.push_back({.kind = FindingKind::why_simpler,
                   .law = best.law->id,
                   .numbers = {{"error", best.known.error}, {"parameters", static_cast<double>(best.parameters)}}});
  if (!tied.empty()) {
    why.push_back({.kind = FindingKind::why_ties,
                   .law = taken.law->id,
                   .other_laws = tied,
                   .words = {{"tie", device_names(summary).size() > 1 ? "lot" : "device"}}});
  } else if (!simplest && candidates.size() > 1) {
    auto const& next = candidates[best.index == taken.index ? 1 : 0];
    why.push_back({.kind = FindingKind::why_next, .law = next.law->id, .numbers = {{"error", next.known.error}}});
  }
  if (auto closer = closer_but_refused(summary, taken, advice.purpose)) why.push_back(std::move(*closer));
  return why;
}

Recommendation recommend(Summary const& summary, Purpose purpose) {
  bool const untested = asks_about_untested(summary, purpose);
  auto const candidates = candidates_among(summary, untested);
  if (candidates.empty()) return none(summary, purpose, untested);
  auto const chosen = equally_good(summary, purpose, candidates);
  auto const& taken = chosen.front();
  Recommendation advice;
  advice.purpose = purpose;
  advice.law = taken.index;
  advice.error = taken.known.error;
  advice.measure = measure_of(untested, *taken.law);
  advice.standings = standings_of(summary, untested, chosen);
  Names tied;
  for (auto const& c : chosen | std::views::drop(1)) {
    advice.ties.push_back(c.index);
    tied.push_back(c.law->id);
  }
  advice.weak = taken.weak;
  advice.sure = !advice.weak.empty() ? Sure::weak : !advice.ties.empty() ? Sure::tie : Sure::clear;
  advice.why = why_taken(summary, advice, candidates, taken, tied);
  advice.answer = {
      .kind = FindingKind::law_recommended,
      .law = taken.law->id,
      .other_laws = tied,
      .numbers = {{"error", taken.known.error}},
      .words = {{"measure", advice.measure}, {"sure", std::string(name(advice.sure))}, {"elsewhere", "yes"}}};
  advice.surer = what_would_decide(summary, purpose, advice.sure != Sure::clear);
  advice.valid_mm = largest_displacement(summary, *taken.law);
  if (!taken.law->in_programs) advice.programs = Finding{.kind = FindingKind::not_in_opensees, .law = taken.law->id};
  return advice;
}

}  // namespace

std::string_view name(Purpose purpose) {
  constexpr std::string_view names[]{"untested-device", "these-tests", "simplest"};
  return names[static_cast<std::size_t>(purpose)];
}

std::string_view name(Rank place) {
  constexpr std::string_view names[]{"taken", "ties", "behind", "ruled out"};
  return names[static_cast<std::size_t>(place)];
}

std::string_view name(Sure sure) {
  constexpr std::string_view names[]{"clear", "tie", "weak"};
  return names[static_cast<std::size_t>(sure)];
}

bool compares_laws(Summary const& summary) {
  return std::ranges::count_if(summary.laws, [](auto const& law) { return law.objective.mean.has_value(); }) > 1;
}

std::vector<Recommendation> recommendations(Summary const& summary) {
  std::vector<Recommendation> answers;
  if (summary.laws.empty()) return answers;
  for (auto const purpose : {Purpose::untested_device, Purpose::these_tests, Purpose::simplest}) {
    answers.push_back(recommend(summary, purpose));
    answers.back().title = title_of(summary, purpose);
  }
  // If no law is recommended for untested devices, the other answers warn that their law may not hold elsewhere.
  if (answers.front().law) return answers;
  for (auto& each : answers | std::views::drop(1))
    if (each.law) {
      std::ranges::find(each.answer.words, "elsewhere", &FindingWord::name)->text = "no";
      each.answer.words.push_back({"others", "none"});
    }
  return answers;
}

std::optional<Finding> verdict(std::vector<Recommendation> const& recommendations) {
  if (recommendations.empty()) return std::nullopt;
  auto const &design = recommendations[0], &tests = recommendations[1];
  return design.law || !tests.law ? design.answer : tests.answer;
}

}  // namespace isolaw::study
