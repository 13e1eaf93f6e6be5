#include "isolaw/study/recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

// What is known of a law for a purpose: its error, and the error on every device.
struct Known {
  double error = 0.0;
  std::vector<std::pair<std::string_view, double>> of_devices;
};

template <class Of>
Known over_devices(LawResult const& law, double error, Of of) {
  Known known{.error = error, .of_devices = {}};
  for (auto const& fit : law.devices)
    if (auto const value = of(fit)) known.of_devices.emplace_back(fit.device, *value);
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

// The worse of what is known: on blocks and on devices that the law was not fitted to.
std::optional<Known> known_for_untested(LawResult const& law) {
  auto const& loo = law.loo_objective;
  auto const& predicted = law.predicted_objective;
  if (!loo && !predicted) return std::nullopt;
  if (predicted && (!loo || *predicted >= *loo)) return over_devices(law, *predicted, predicted_of);
  return over_devices(law, *loo, [](DeviceFit const& fit) { return fit.left_out_objective; });
}

// Without the optimiser's noise where there is an analysis.
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

std::size_t calibrated(LawResult const& law) {
  auto const& parameters = parameters_of(law);
  return static_cast<std::size_t>(std::ranges::count_if(parameters, &ParameterFit::free));
}

// Of the parameters that were examined on the devices, those that the tests do not determine; empty without analysis.
std::optional<double> share_open(LawResult const& law) {
  int examined = 0, open = 0;
  for (auto const& fit : law.devices)
    for (auto const& parameter : fit.parameters) {
      if (!parameter.analysis) continue;
      ++examined;
      open += parameter.analysis->identifiability == "undetermined" ? 1 : 0;
    }
  return examined > 0 ? std::optional(static_cast<double>(open) / examined) : std::nullopt;
}

struct Candidate {
  std::size_t index = 0;
  LawResult const* law = nullptr;
  Known known;
  std::size_t parameters = 0;
  Names weak = {};  // why a choice of it is not a sure one
};

// A law that may be taken at all, on every device that takes part.
bool may_be_taken(Summary const& summary, LawResult const& law) {
  auto const usable = device_names(summary).size();
  auto const identified = static_cast<std::size_t>(
      std::ranges::count_if(law.devices, [](auto const& fit) { return fit_status(fit) == "ok"; }));
  return law.objective.mean && identified == usable && inadequacy(law).empty() && law.prediction_holds();
}

// Means differ by no more than chance makes of the devices.
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

Names weaknesses(Summary const& summary, Candidate const& candidate, Purpose purpose) {
  auto const& law = *candidate.law;
  Names found;
  auto const grade = graded(candidate.known.error, candidate.known.error, candidate.known.error);
  if (law.prediction_grade == PredictionGrade::fair)
    found.push_back("its prediction of blocks it was not fitted to is fair");
  else if (grade > PredictionGrade::good)
    found.push_back(fmt::format("an error of {} is no more than {}", percent(candidate.known.error), name(grade)));
  if (!compares_laws(summary)) found.emplace_back("no other law was identified to compare it with");
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) found.emplace_back("the campaign is not complete");
  if (law.success_share && *law.success_share < found_share)
    found.push_back(fmt::format("{} of its searches ended near its least objective", percent(*law.success_share)));
  if (auto const held = pinned(law); held.decides()) found.push_back(held.text());
  // A prediction that holds has shown that what the tests leave open does not matter there.
  if (purpose == Purpose::untested_device && !law.prediction_grade)
    if (auto const share = share_open(law); share && *share > open_share)
      found.push_back(fmt::format("the tests do not determine {} of its parameters", percent(*share)));
  return found;
}

// Of laws that tie: what nothing speaks against, then fewer parameters, then a material in analysis programs.
bool preferred(Candidate const& a, Candidate const& b) {
  if (a.weak.empty() != b.weak.empty()) return a.weak.empty();
  if (a.parameters != b.parameters) return a.parameters < b.parameters;
  if (a.law->in_programs != b.law->in_programs) return a.law->in_programs;
  return a.known.error < b.known.error;
}

bool predicts_blocks(Summary const& summary) {
  return std::ranges::any_of(summary.laws, [](auto const& law) { return law.predicted_objective.has_value(); });
}

// What an error is of.
std::string measure_of(bool untested, LawResult const& law) {
  if (!untested) return "fitted to each device";
  bool const of_blocks =
      law.predicted_objective && (!law.loo_objective || *law.predicted_objective >= *law.loo_objective);
  return of_blocks ? "on blocks it was not fitted to" : "on a device left out";
}

// The tests that would tell more.
std::string test_that_decides(Summary const& summary, Purpose purpose, bool open) {
  constexpr std::size_t few = 5;
  auto const devices = device_names(summary).size();
  Names tests;
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0)
    tests.emplace_back("the rest of the campaign, which the same command computes");
  if (open && !compares_laws(summary)) tests.emplace_back("--laws, others to compare it with");
  bool const elsewhere = purpose != Purpose::these_tests;
  if (elsewhere && !predicts_blocks(summary) && (open || purpose == Purpose::untested_device)) {
    bool const several = std::ranges::any_of(summary.devices, [](auto const& device) {
      return device.status == "ok" && device.properties.blocks.size() > 1;
    });
    tests.emplace_back(several ? "--fit-blocks, an amplitude or rate kept from the fit"
                               : "another amplitude or rate, kept from the fit");
  }
  if (elsewhere && open && predicts_blocks(summary))
    tests.emplace_back("a further test, kept from a fit to every block");
  if (elsewhere && devices == 1)
    tests.emplace_back("more devices");
  else if (elsewhere && open && devices < few)
    tests.push_back(fmt::format("more than these {} devices", devices));
  if (open && tests.empty()) tests.emplace_back("an amplitude between those there");
  return joined(tests, "; ");
}

// What was not tested and is judged: nobody knows of the rest.
std::string title_of(Summary const& summary, Purpose purpose) {
  if (purpose == Purpose::these_tests) return "For these tests";
  if (purpose == Purpose::simplest) return "Simplest that serves";
  bool const devices = std::ranges::any_of(summary.laws, [](auto const& law) { return law.loo_objective.has_value(); });
  if (predicts_blocks(summary)) return devices ? "For devices and blocks not tested" : "For blocks not tested";
  return devices ? "For a device not tested" : "For what was not tested";
}

std::string_view object_of(Purpose purpose) {
  constexpr std::string_view names[]{"devices and amplitudes that were not tested", "these tests", "simplicity"};
  return names[static_cast<std::size_t>(purpose)];
}

Recommendation none(Summary const& summary, Purpose purpose, std::string why) {
  Recommendation made;
  made.purpose = purpose;
  made.why = capitalised(std::move(why)) + ".";
  made.answer = fmt::format("No law can be recommended for {}.", object_of(purpose));
  made.would_decide = test_that_decides(summary, purpose, true);
  return made;
}

// Why no law is left, as a person asks.
std::string why_none(Summary const& summary, Purpose purpose) {
  auto const identified =
      std::ranges::count_if(summary.laws, [](auto const& law) { return law.objective.mean.has_value(); });
  if (identified == 0) return "no law could be identified";
  Names far, failing, partial;
  for (auto const& law : summary.laws) {
    if (!law.objective.mean) continue;
    if (!inadequacy(law).empty())
      far.push_back(called(law));
    else if (!law.prediction_holds())
      failing.push_back(fmt::format("{} ({})", called(law), name(*law.prediction_grade)));
    else if (!may_be_taken(summary, law))
      partial.push_back(called(law));
  }
  Names parts;
  if (!far.empty())
    parts.push_back(fmt::format("{} {} not describe the devices", enumerate(far), far.size() == 1 ? "does" : "do"));
  if (!failing.empty()) parts.push_back(fmt::format("the prediction of {} does not hold", enumerate(failing)));
  if (!partial.empty()) parts.push_back(fmt::format("{} was not identified on every device", enumerate(partial)));
  if (!parts.empty()) return joined(parts, "; ");
  if (purpose != Purpose::untested_device) return "no law has an error to compare";
  return device_names(summary).size() > 1
             ? "every block was fitted, and no device was left out of the lot's law (--analysis full does that)"
             : "one device was tested and every block fitted: nothing says how a law holds elsewhere";
}

// Why a law may not be taken; empty where it may.
std::string ruled_out(Summary const& summary, LawResult const& law, bool known, double error) {
  if (!law.objective.mean) return "was not identified";
  if (!inadequacy(law).empty()) return "does not describe the devices";
  if (!law.prediction_holds()) return fmt::format("its prediction is {}", name(*law.prediction_grade));
  if (!may_be_taken(summary, law)) return "was not identified on every device";
  if (!known) return "nothing shows how it holds elsewhere";
  return error > fair_prediction ? fmt::format("its error is {}", name(graded(error, error, error))) : std::string();
}

// Of every law, the chosen ones first, in their order.
std::vector<Standing> standings_of(Summary const& summary, bool untested, std::vector<Candidate> const& chosen) {
  std::vector<Standing> made, out;
  for (auto const& c : chosen) made.push_back({c.index, made.empty() ? Place::taken : Place::tied, c.known.error, {}});
  auto const first_behind = static_cast<std::ptrdiff_t>(made.size());
  for (std::size_t i = 0; i < summary.laws.size(); ++i) {
    if (std::ranges::find(chosen, i, &Candidate::index) != chosen.end()) continue;
    auto const& law = summary.laws[i];
    auto const known = untested ? known_for_untested(law) : known_of_tests(law);
    auto const error = known ? std::optional(known->error) : std::nullopt;
    auto reason = ruled_out(summary, law, known.has_value(), error.value_or(0.0));
    auto& to = reason.empty() ? made : out;
    to.push_back({i, reason.empty() ? Place::behind : Place::ruled_out, error, std::move(reason)});
  }
  auto const by_error = [](Standing const& s) { return s.error.value_or(std::numeric_limits<double>::infinity()); };
  std::ranges::stable_sort(made.begin() + first_behind, made.end(), {}, by_error);
  std::ranges::stable_sort(out, {}, by_error);
  made.insert(made.end(), out.begin(), out.end());
  return made;
}

// A law that follows the tests more closely and may not be taken is asked after.
std::string closer_but_refused(Summary const& summary, Candidate const& taken, Purpose purpose) {
  if (purpose != Purpose::these_tests) return {};
  LawResult const* closest = nullptr;
  double least = taken.known.error;
  for (auto const& law : summary.laws) {
    auto const known = known_of_tests(law);
    if (!known || known->error >= least || law.prediction_holds() || !inadequacy(law).empty()) continue;
    closest = &law;
    least = known->error;
  }
  return closest == nullptr ? std::string()
                            : fmt::format("; {} is nearer ({}), but its prediction is {}", called(*closest),
                                          percent(least), name(*closest->prediction_grade));
}

Recommendation recommend(Summary const& summary, Purpose purpose) {
  bool const untested = purpose == Purpose::untested_device ||
                        (purpose == Purpose::simplest && std::ranges::any_of(summary.laws, [](auto const& law) {
                           return known_for_untested(law).has_value();
                         }));
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < summary.laws.size(); ++i) {
    auto const& law = summary.laws[i];
    if (!may_be_taken(summary, law)) continue;
    auto const known = untested ? known_for_untested(law) : known_of_tests(law);
    if (!known || known->error > fair_prediction) continue;
    candidates.push_back({.index = i, .law = &law, .known = *known, .parameters = calibrated(law)});
  }
  if (candidates.empty()) {
    auto made = none(summary, purpose, why_none(summary, purpose));
    made.standings = standings_of(summary, untested, {});
    return made;
  }
  std::ranges::stable_sort(candidates, {}, [](auto const& c) { return c.known.error; });
  auto const& best = candidates.front();

  std::vector<Candidate> chosen;  // that cannot be told apart for the purpose
  if (purpose == Purpose::simplest) {
    double const most = best.known.error + std::max(simple_share * best.known.error, simple_error);
    auto fewest = best.parameters;
    for (auto const& c : candidates)
      if (c.known.error <= most) fewest = std::min(fewest, c.parameters);
    std::vector<Candidate> serving;
    for (auto const& c : candidates)
      if (c.known.error <= most && c.parameters == fewest) serving.push_back(c);
    for (auto const& c : serving)
      if (&c == &serving.front() || tie(serving.front().known, c.known)) chosen.push_back(c);
  } else {
    for (auto const& c : candidates)
      if (&c == &best || tie(best.known, c.known)) chosen.push_back(c);
  }
  // A grade outranks an error: a law whose prediction is good comes before one whose is fair.
  auto const grade_of = [](Candidate const& c) { return c.law->prediction_grade.value_or(PredictionGrade::good); };
  auto const least_grade = std::ranges::min(chosen | std::views::transform(grade_of));
  std::erase_if(chosen, [&](auto const& c) { return grade_of(c) != least_grade; });
  for (auto& c : chosen) c.weak = weaknesses(summary, c, purpose);
  std::ranges::stable_sort(chosen, preferred);

  auto const& taken = chosen.front();
  Recommendation made;
  made.purpose = purpose;
  made.law = taken.index;
  made.error = taken.known.error;
  made.measure = measure_of(untested, *taken.law);
  made.standings = standings_of(summary, untested, chosen);
  Names tied;
  for (auto const& c : chosen | std::views::drop(1)) {
    made.ties.push_back(c.index);
    tied.push_back(called(*c.law));
  }
  auto const& weak = taken.weak;
  made.sure = !weak.empty() ? Sure::weak : !made.ties.empty() ? Sure::tie : Sure::clear;

  made.why = fmt::format("Errs by {} {}", percent(taken.known.error), made.measure);
  if (purpose == Purpose::simplest) made.why += fmt::format(", with {}", counted(taken.parameters, "parameter"));
  if (purpose == Purpose::simplest && taken.index != best.index)
    made.why += fmt::format("; {} by {}, with {}", called(*best.law), percent(best.known.error), best.parameters);
  if (!tied.empty())
    made.why +=
        fmt::format("; {} {} with it within {}", enumerate(tied), tied.size() == 1 ? "ties" : "tie",
                    device_names(summary).size() > 1 ? "the scatter over the devices" : "what one device can tell");
  else if (purpose != Purpose::simplest && candidates.size() > 1) {
    auto const& next = candidates[best.index == taken.index ? 1 : 0];
    made.why += fmt::format("; {} by {}", called(*next.law), percent(next.known.error));
  }
  made.why += closer_but_refused(summary, taken, purpose);
  made.why += ".";
  if (!weak.empty()) made.why += fmt::format(" Weak: {}.", joined(weak, "; "));
  auto laws = called(*taken.law);
  for (auto const& id : tied) laws += " or " + id;
  made.answer = fmt::format("Take {}{}{}: {} off {}.", laws, tied.empty() ? "" : ", which tie",
                            made.sure == Sure::weak ? ", with care" : "", percent(taken.known.error), made.measure);
  made.would_decide = test_that_decides(summary, purpose, made.sure != Sure::clear);
  if (auto const mm = largest_displacement(summary, *taken.law))
    made.valid = fmt::format("up to {} mm", number_text(*mm, 3));
  if (!taken.law->in_programs) made.programs = "Not in OpenSees: export --to opensees-cpp";
  return made;
}

}  // namespace

std::string_view name(Purpose purpose) {
  constexpr std::string_view names[]{"untested-device", "these-tests", "simplest"};
  return names[static_cast<std::size_t>(purpose)];
}

std::string_view name(Place place) {
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
  std::vector<Recommendation> made;
  if (summary.laws.empty()) return made;
  for (auto const purpose : {Purpose::untested_device, Purpose::these_tests, Purpose::simplest}) {
    made.push_back(recommend(summary, purpose));
    made.back().title = title_of(summary, purpose);
  }
  // What a law is not shown for stands in the sentence that names it.
  if (made.front().law) return made;
  for (auto& each : made | std::views::drop(1)) {
    if (!each.law) continue;
    if (each.purpose == Purpose::these_tests) each.answer = "For these tests t" + each.answer.substr(1);
    each.answer.pop_back();  // its full stop
    each.answer += "; for other devices or amplitudes no law can be recommended.";
  }
  return made;
}

std::string verdict_sentence(std::vector<Recommendation> const& made) {
  if (made.empty()) return {};
  auto const &design = made[0], &tests = made[1];
  if (design.law) return design.answer;
  return tests.law ? tests.answer : "No law can be recommended. " + tests.why;
}

}  // namespace isolaw::study
