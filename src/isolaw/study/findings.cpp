#include "isolaw/study/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/analysis_findings.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/energy_fall.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

// Objectives differ in their third digit, so they keep one decimal.
std::string error_percent(LawResult const& law) {
  return with_decimals(100.0 * *law.objective.mean, 1) + " %";
}

bool ranked(LawResult const& law) {
  return law.objective.mean && law.beta;
}

bool dominates(LawResult const& a, LawResult const& b) {
  bool const no_worse = *a.objective.mean <= *b.objective.mean && *a.beta <= *b.beta;
  return no_worse && (*a.objective.mean < *b.objective.mean || *a.beta < *b.beta);
}

// What beta says of a law, in words; miss_text() is what the objective says.
std::string scatter(LawResult const& law) {
  return fmt::format("parameters lie up to {} from the lot's mean, averaged over the parameters", percent(*law.beta));
}

// Whoever is told to take a law must know that it holds only where it was fitted.
std::string caution(LawResult const& law) {
  std::string text;
  if (auto const held = pinned(law); held.decides())
    text += fmt::format(" {}: there the box keeps them together, not the devices.", held.text());
  if (!law.prediction_holds())
    text += fmt::format(" Its prediction is {}: only for the blocks it was fitted to.", name(*law.prediction_grade));
  return text;
}

// Whether a law may be taken at all, and is compared with the others: identified, and near enough to the devices.
bool describes(LawResult const& law) {
  return law.objective.mean && inadequacy(law).empty();
}

// What "the most accurate law" and the like are said of, where others are no choice.
std::string_view among(Summary const& summary) {
  bool const all = std::ranges::all_of(summary.laws, [](auto const& law) { return inadequacy(law).empty(); });
  return all ? "" : " of those that describe the devices";
}

// The front of the laws that describe the devices: one that does not is no choice, whatever it beats.
std::vector<bool> front_among_adequate(Summary const& summary) {
  return front_of(
      summary.laws, [](auto const& law) { return describes(law) ? law.beta : std::nullopt; },
      [](auto const& law) { return law.objective.mean; });
}

// The same without the optimiser's noise.
std::vector<bool> converged_among_adequate(Summary const& summary) {
  return front_of(
      summary.laws, [](auto const& law) { return describes(law) ? law.beta_converged : std::nullopt; },
      [](auto const& law) { return law.objective_converged; });
}

// The place of the front's robust end: its last law that is not held together by its box. Where all but the most
// accurate one are, that one's, and the front has no robust end.
std::size_t robust_end(Summary const& summary, std::vector<std::size_t> const& front) {
  for (std::size_t place = front.size(); place-- > 1;)
    if (!pinned(summary.laws[front[place]]).decides()) return place;
  return 0;
}

// Of the laws between the ends of the front, the place of the one nearest to having the best of both, each measured by
// the front's extent; the front's size where there is none. No compromise is a law whose prediction does not hold, that
// its box holds together, or that leaves the front with the optimiser's noise.
std::size_t compromise(Summary const& summary, std::vector<std::size_t> const& front) {
  auto const& laws = summary.laws;
  bool const analysed = std::ranges::any_of(laws, &LawResult::on_front_converged);
  auto const without_noise = converged_among_adequate(summary);
  auto best = front.size();
  double least = std::numeric_limits<double>::infinity();
  auto const end = robust_end(summary, front);
  for (std::size_t place = 1; place < end; ++place) {
    auto const &law = laws[front[place]], &accurate = laws[front.front()], &robust = laws[front[end]];
    double const error =
        (*law.objective.mean - *accurate.objective.mean) / (*robust.objective.mean - *accurate.objective.mean);
    double const scatter = (*law.beta - *robust.beta) / (*accurate.beta - *robust.beta);
    double const distance = std::hypot(error, scatter);
    bool const leaves = analysed && !law.on_front_converged && !without_noise[front[place]];
    if (pinned(law).decides() || !law.prediction_holds() || leaves || !(distance < least)) continue;
    least = distance;
    best = place;
  }
  return best;
}

LawVerdict front_verdict(Summary const& summary, std::vector<std::size_t> const& front, std::size_t place) {
  auto const& laws = summary.laws;
  auto const& law = laws[front[place]];
  LawVerdict verdict{front[place], Role::between, {}, {}};
  if (place > 0 && pinned(law).decides()) {
    verdict.role = Role::held_by_box;
    verdict.sentence = fmt::format("{}; its {}.", capitalised(miss_text(law)), scatter(law));
  } else if (front.size() == 1 && !pinned(law).decides()) {
    verdict.role = Role::best_of_both;
    verdict.sentence = fmt::format("No law{} is more accurate and none is more robust: it {}, and its {}.",
                                   among(summary), miss_text(law), scatter(law));
  } else if (place == 0) {
    verdict.role = Role::most_accurate;
    verdict.sentence = fmt::format("{}; its {}.", capitalised(miss_text(law)), scatter(law));
  } else if (place == robust_end(summary, front)) {
    auto const& accurate = laws[front.front()];
    verdict.role = Role::most_robust;
    verdict.sentence = fmt::format("Its {}, the least {}; the price is an error of {} against {} for {}.", scatter(law),
                                   place + 1 < front.size() ? "that no box keeps so"
                                   : among(summary).empty() ? "of all"
                                                            : among(summary).substr(1),
                                   error_percent(law), error_percent(accurate), accurate.id);
  } else {
    auto const& accurate = laws[front[place - 1]];
    auto const& robust = laws[front[place + 1]];
    if (place == compromise(summary, front)) verdict.role = Role::compromise;
    verdict.sentence =
        fmt::format("Scatters less than {} ({} against {}) and errs less than {} ({} against {}).", accurate.id,
                    percent(*law.beta), percent(*accurate.beta), robust.id, error_percent(law), error_percent(robust));
  }
  verdict.sentence += caution(law);
  return verdict;
}

LawVerdict dominated_verdict(Summary const& summary, std::vector<std::size_t> const& front, std::size_t index) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::dominated, {}, {}};
  for (std::size_t const other : front)
    if (dominates(summary.laws[other], law)) verdict.dominated_by.push_back(summary.laws[other].id);
  auto const numbers = fmt::format("error {}, scatter {}", error_percent(law), percent(*law.beta));
  verdict.sentence = verdict.dominated_by.empty()
                         ? fmt::format("is not on the front ({}).", numbers)
                         : fmt::format("is dominated by {} ({}).", enumerate(verdict.dominated_by), numbers);
  return verdict;
}

LawVerdict unranked_verdict(Summary const& summary, std::size_t index, LawResult const& best) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::unranked, {}, {}};
  if (!law.objective.mean) {
    verdict.sentence = "was not identified on any device.";
  } else if (&law == &best) {
    verdict.sentence = fmt::format("{}, the least {}.{}", miss_text(law),
                                   among(summary).empty() ? "of all" : among(summary).substr(1), caution(law));
  } else {
    verdict.sentence = fmt::format("has a mean error of {}, {} times that of {}.", error_percent(law),
                                   with_decimals(*law.objective.mean / *best.objective.mean, 2), best.id);
  }
  return verdict;
}

// `best`: the most accurate law that describes the devices; the laws' number where there is none.
std::string headline(Summary const& summary, std::vector<std::size_t> const& front, std::size_t best) {
  auto const& laws = summary.laws;
  auto const flagged = [&](std::size_t index) {
    auto const& law = laws[index];
    return law.id +
           (law.prediction_holds() ? "" : fmt::format(", whose prediction is {}", name(*law.prediction_grade))) +
           (pinned(law).decides() ? ", which its box holds together" : "");
  };
  if (front.size() == 1 && pinned(laws[front[0]]).decides())
    return fmt::format("{} is the most accurate law{}; how robust it is cannot be said.{}", laws[front[0]].id,
                       among(summary), caution(laws[front[0]]));
  if (front.size() == 1)
    return fmt::format("{} is both the most accurate and the most robust law{}.{}", laws[front[0]].id, among(summary),
                       caution(laws[front[0]]));
  if (front.size() > 1) {
    auto const middle = compromise(summary, front), end = robust_end(summary, front);
    if (end == 0)
      return fmt::format("{} is the most accurate law{}; what scatters less is held together by its box.{}",
                         laws[front[0]].id, among(summary), caution(laws[front[0]]));
    auto const held = std::ranges::count_if(
        front, [&](std::size_t law) { return law != front[0] && law != front[end] && pinned(laws[law]).decides(); });
    return fmt::format(
        "{} of {} laws are worth considering: the choice lies between accuracy ({}) and robustness ({}){}.",
        front.size() - static_cast<std::size_t>(held), laws.size(), flagged(front.front()), flagged(front[end]),
        middle < front.size() ? fmt::format("; the best compromise is {}", laws[front[middle]].id)
        : end > 1
            ? "; none between them holds up (off the front without the optimiser's noise, held by its box, or its prediction does not hold)"
            : "");
  }
  if (best < laws.size())
    return fmt::format("{} is the most accurate law{}; how robust it is cannot be said.{}", laws[best].id,
                       among(summary), caution(laws[best]));
  auto const ranking = by_objective(summary);
  if (ranking.empty() || !laws[ranking.front()].objective.mean) return "No law could be identified.";
  auto const& nearest = laws[ranking.front()];
  return fmt::format("No law describes these devices: {}, the nearest, {}.", nearest.id, inadequacy(nearest));
}

void warn_of_missing_runs(Summary const& summary, std::vector<Warning>& warnings) {
  if (summary.missing_runs() > 0)
    warnings.push_back(
        {"not complete",
         fmt::format("not complete: {} of {} runs are there; every number and the choice of a law may still change",
                     summary.runs, summary.expected_runs)});
  else if (summary.missing_analyses() > 0)
    warnings.push_back({"not complete", fmt::format("not complete: {} of {} analyses are there", summary.analyses,
                                                    summary.expected_analyses)});
}

// A record under two names counts twice, and makes parameters look less scattered than they are. Of a device that takes
// no part the file says so, of others the samples. Those that a device of `part` is among.
void warn_of_copies(Summary const& summary, Summary const& part, std::vector<Warning>& warnings) {
  std::vector<std::vector<DeviceResult const*>> groups;  // devices of one record each
  for (auto const& device : summary.devices) {
    if (device.raw.size() == 0 && device.sha256.empty()) continue;
    auto const same = [&](auto const& group) {
      auto const& other = *group.front();
      bool const samples =
          device.raw.size() > 0 && other.raw.disp_mm == device.raw.disp_mm && other.raw.force_kN == device.raw.force_kN;
      bool const refused = other.raw.size() == 0 && device.raw.size() == 0;
      return samples || (refused && other.sha256 == device.sha256);
    };
    auto found = std::ranges::find_if(groups, same);
    if (found == groups.end()) found = groups.insert(groups.end(), {{}});
    found->push_back(&device);
  }
  for (auto const& group : groups) {
    if (group.size() < 2) continue;
    Names names;
    for (auto const* device : group) names.push_back(device->name);
    if (std::ranges::none_of(part.devices,
                             [&](auto const& device) { return std::ranges::find(names, device.name) != names.end(); }))
      continue;
    warnings.push_back(
        {"copies", fmt::format("{} hold the same record{}", enumerate(names),
                               group.front()->raw.size() == 0
                                   ? std::string()
                                   : fmt::format(", which counts {} times in every mean and spread over the devices",
                                                 group.size()))});
  }
}

// One compression test cannot be that of two devices.
void warn_of_vertical_copies(Summary const& summary, Summary const& part, std::vector<Warning>& warnings) {
  std::vector<std::vector<DeviceResult const*>> groups;
  for (auto const& device : summary.devices) {
    auto const& test = device.vertical_test;
    if (test.load_kN.empty()) continue;
    auto const same = [&](auto const& group) {
      auto const& other = group.front()->vertical_test;
      return other.load_kN == test.load_kN && other.disp_mm == test.disp_mm;
    };
    auto found = std::ranges::find_if(groups, same);
    if (found == groups.end()) found = groups.insert(groups.end(), {{}});
    found->push_back(&device);
  }
  for (auto const& group : groups) {
    bool const concerned = std::ranges::any_of(group, [&](auto const* device) {
      return std::ranges::find(part.devices, device->name, &DeviceResult::name) != part.devices.end();
    });
    if (group.size() < 2 || !concerned) continue;
    Names names;
    for (auto const* device : group) names.push_back(device->name);
    warnings.push_back({"copies", fmt::format("{} hold the same compression test, whose K_v counts {} times",
                                              enumerate(names), group.size())});
  }
}

void warn_of_devices(Summary const& summary, std::vector<Warning>& warnings) {
  for (auto const& device : summary.devices)
    if (device.status != "ok")
      warnings.push_back({"refused", fmt::format("{} was refused: {}", device.name, on_one_line(device.message))});
}

// What is done already is no advice.
bool is_given(Summary const& summary, std::string_view setting) {
  auto const found = std::ranges::find(summary.settings, setting, &Setting::key);
  return found != summary.settings.end() && found->json != "\"all\"" && found->json != "\"\"";
}

// A device that loses energy from cycle to cycle while no law does: the laws hold for a mean of its cycles. Of a law
// alone that is said whatever others do.
void warn_of_degradation(Summary const& summary, std::vector<Warning>& warnings) {
  for (auto const& device : summary.devices) {
    EnergyFall const* nearest = nullptr;
    LawResult const* of = nullptr;
    bool followed = false;
    for (auto const& law : summary.laws) {
      auto const* fit = fit_of(law, device.name);
      if (fit == nullptr || !fit->energy_fall) continue;
      followed = followed || follows(*fit->energy_fall);
      if (nearest != nullptr && fit->energy_fall->percent <= nearest->percent) continue;
      nearest = &*fit->energy_fall;
      of = &law;
    }
    if (nearest == nullptr || followed) continue;
    auto const own = percent(std::max(0.0, nearest->percent) / 100.0);
    auto const who =
        summary.laws.size() == 1
            ? fmt::format("{} does not follow this degradation over cycles (its own falls by {}): it is right", of->id,
                          own)
            : fmt::format("no law follows this degradation over cycles ({} comes nearest, with {}): each is right",
                          of->id, own);
    warnings.push_back(
        {"degradation",
         fmt::format("{}: the energy of a cycle falls by {} from cycle {} to {} of block {}, and {} for "
                     "some cycles in between{}",
                     device.name, percent(nearest->measured_percent / 100.0), nearest->first_cycle, nearest->last_cycle,
                     nearest->block, who,
                     is_given(summary, "fit-cycles") ? "" : "; --fit-cycles fits to the first or to the last ones")});
  }
}

void warn_of_refused_laws(LawResult const& law, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, Names>> reasons;  // in order of first appearance
  for (auto const& fit : law.devices)
    if (!fit.refusal.empty()) beside(reasons, fit.refusal).push_back(fit.device);
  for (auto const& [reason, devices] : reasons) {
    auto text = fmt::format("{} was not identified on {}: {}", law.id, enumerate(devices), on_one_line(reason));
    if (law.objective.mean) text += fmt::format("; its mean and beta cover the other devices only");
    warnings.push_back({"law not identified", std::move(text)});
  }
}

void warn_of_failed_runs(LawResult const& law, std::vector<Warning>& warnings) {
  int failed = 0, runs = 0;
  std::string first;
  for (auto const& fit : law.devices) {
    runs += fit.runs;
    failed += fit.failed_runs;
    if (first.empty() && fit.failed_runs > 0) first = fmt::format("{}: {}", fit.device, fit.failure);
  }
  if (failed > 0)
    warnings.push_back(
        {"failed runs", fmt::format("{}: {} of {} runs failed, the first on {}", law.id, failed, runs, first)});
}

// What an optimiser tried in vain is no fault of the result, but it belongs to how the result was found.
void warn_of_failed_evaluations(LawResult const& law, std::vector<Warning>& warnings) {
  std::uint64_t failed = 0, evaluations = 0;
  for (auto const& fit : law.devices) {
    evaluations += fit.evaluations;
    failed += fit.failed_evaluations;
  }
  if (failed > 0)
    warnings.push_back(
        {"failed evaluations",
         fmt::format("{}: {} of {} parameter sets tried ({}) gave no finite force and were passed over", law.id, failed,
                     evaluations, percent(static_cast<double>(failed) / static_cast<double>(evaluations)))});
}

void warn_of_bounds(LawResult const& law, std::vector<Warning>& warnings) {
  std::size_t fitted = 0;
  std::vector<std::pair<std::pair<std::string, std::string>, Names>> at_bound;  // (parameter, side) and its devices
  for (auto const& fit : law.devices) {
    if (fit_status(fit) == "ok") ++fitted;
    for (auto const& parameter : fit.parameters)
      if (!parameter.at_bound.empty())
        beside(at_bound, std::pair(parameter.name, parameter.at_bound)).push_back(fit.device);
  }
  if (law.lot && !law.lot->at_bound.empty())
    warnings.push_back(
        {"at bound", fmt::format("{}: of the one law for all {}", law.id, enumerate(law.lot->at_bound, 6))});
  if (at_bound.empty()) return;
  Names parts;
  for (auto const& [edge, devices] : at_bound) {
    auto const where = devices.size() == fitted && fitted > 1 ? fmt::format("all {} devices", fitted)
                       : devices.size() > 3                   ? fmt::format("{} of {} devices", devices.size(), fitted)
                                                              : enumerate(devices);
    parts.push_back(fmt::format("{} at its {} bound on {}", edge.first, edge.second, where));
  }
  constexpr std::size_t most = 6;
  if (auto const more = parts.size(); more > most) {
    parts.resize(most);
    parts.push_back(fmt::format("and {} more", more - most));
  }
  warnings.push_back({"at bound", fmt::format("{}: {}", law.id, fmt::join(parts, "; "))});
}

void warn_of_adequacy(LawResult const& law, std::vector<Warning>& warnings) {
  if (auto const why = inadequacy(law); !why.empty())
    warnings.push_back({"not adequate", fmt::format("{} does not describe the devices: it {}", law.id, why)});
}

void warn_of_held(LawResult const& law, std::vector<Warning>& warnings) {
  if (auto const held = pinned(law); held.decides())
    warnings.push_back({"at bound", fmt::format("{}: {}, so that its beta is no robustness", law.id, held.text())});
}

void warn_of_integration(LawResult const& law, std::vector<Warning>& warnings) {
  Names devices;
  double largest = 0.0;
  for (auto const& fit : law.devices) {
    if (std::abs(fit.integration_shift.value_or(0.0)) <= large_integration_shift) continue;
    devices.push_back(fit.device);
    largest = std::max(largest, std::abs(*fit.integration_shift));
  }
  if (!devices.empty())
    warnings.push_back(
        {"integration",
         std::isfinite(largest)
             ? fmt::format("{}: a finer integration step would move the objective by up to {:.2g} on {}", law.id,
                           largest, enumerate(devices))
             : fmt::format(
                   "{}: its force is not finite in finer integration steps on {}: the result is of the steps, not of the law",
                   law.id, enumerate(devices))});
}

// What several records have in common is said once.
void warn_of_records(Summary const& summary, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, Names>> said;  // in order of first appearance
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    bool told = false;  // reading the record may have said already that it has no cyclic properties
    for (auto const& warning : device.raw.warnings) {
      told = told || warning.starts_with("no cyclic properties");
      beside(said, warning).push_back(device.name);
    }
    if (!told && !device.properties.reported && !device.properties.refusal.empty())
      beside(said, fmt::format("no cyclic properties: {}", device.properties.refusal)).push_back(device.name);
  }
  for (auto const& [sentence, names] : said)
    warnings.push_back({"record", fmt::format("{}: {}", enumerate(names), sentence)});
}

std::string note_on_beta(Summary const& summary) {
  if (std::ranges::any_of(summary.laws, [](auto const& law) { return law.beta.has_value(); })) return {};
  for (auto const& law : summary.laws)
    if (!law.beta_note.empty()) return law.beta_note;
  return "no law has a robustness index";
}

}  // namespace

std::string_view name(Role role) {
  constexpr std::string_view names[]{"most accurate and most robust",
                                     "most accurate",
                                     "most robust",
                                     "best compromise",
                                     "in between",
                                     "held by its box",
                                     "dominated",
                                     "not adequate",
                                     "not ranked"};
  return names[static_cast<std::size_t>(role)];
}

std::string_view action(Warning const& warning) {
  struct Row {
    std::string_view topic, action;
  };
  static constexpr std::string_view records = "Look at the records", laws = "Do not lean on these laws",
                                    search = "Search longer or in finer steps",
                                    parameters = "Fix parameters, widen their boxes, or test more";
  static constexpr Row rows[]{{"not complete", "Continue the campaign"},
                              {"refused", records},
                              {"copies", records},
                              {"degradation", records},
                              {"record", records},
                              {"outlier", records},
                              {"law not identified", laws},
                              {"not adequate", laws},
                              {"prediction", laws},
                              {"failed runs", search},
                              {"failed evaluations", search},
                              {"search", search},
                              {"integration", search},
                              {"undetermined", parameters},
                              {"at bound", parameters}};
  auto const found = std::ranges::find(rows, warning.topic, &Row::topic);
  return found == std::end(rows) ? "Take care" : found->action;
}

std::vector<Warning> warnings(Summary const& whole, Summary const& summary) {
  std::vector<Warning> all;
  warn_of_missing_runs(summary, all);
  warn_of_devices(summary, all);
  warn_of_copies(whole, summary, all);
  warn_of_vertical_copies(whole, summary, all);
  warn_of_degradation(summary, all);
  for (auto const warn : {warn_of_refused_laws, warn_of_failed_runs, warn_of_failed_evaluations})
    for (auto const& law : summary.laws) warn(law, all);
  for (auto const& law : whole.laws)
    if (std::ranges::find(summary.laws, law.id, &LawResult::id) != summary.laws.end()) warn_of_adequacy(law, all);
  for (auto const& law : summary.laws) warn_of_held(law, all);
  warn_of_analysis(summary, all);
  for (auto const warn : {warn_of_bounds, warn_of_integration})
    for (auto const& law : summary.laws) warn(law, all);
  warn_of_records(summary, all);
  return all;
}

std::vector<Warning> warnings(Summary const& summary) {
  return warnings(summary, summary);
}

Findings findings(Summary const& summary) {
  auto const ranking = by_objective(summary);
  auto const on_front = front_among_adequate(summary);
  auto const adequate = std::ranges::find_if(ranking, [&](std::size_t law) { return describes(summary.laws[law]); });
  auto const best = adequate != ranking.end() ? *adequate : summary.laws.size();
  std::vector<std::size_t> front, dominated, inadequate, unranked;
  for (std::size_t const index : ranking) {
    auto const& law = summary.laws[index];
    (!inadequacy(law).empty() ? inadequate
     : !ranked(law)           ? unranked
     : on_front[index]        ? front
                              : dominated)
        .push_back(index);
  }
  Findings all;
  all.recommendations = recommendations(summary);
  all.verdict = verdict_sentence(all.recommendations);
  all.headline = headline(summary, front, best);
  for (std::size_t place = 0; place < front.size(); ++place)
    all.verdicts.push_back(front_verdict(summary, front, place));
  for (std::size_t const index : dominated) all.verdicts.push_back(dominated_verdict(summary, front, index));
  for (std::size_t const index : inadequate)
    all.verdicts.push_back({index, Role::inadequate, inadequacy(summary.laws[index]) + ".", {}});
  for (std::size_t const index : unranked) {
    auto verdict = unranked_verdict(summary, index, summary.laws[best < summary.laws.size() ? best : ranking.front()]);
    auto const& note = summary.laws[index].beta_note;
    if (!front.empty() && !note.empty()) verdict.sentence += fmt::format(" No beta: {}.", note);
    all.verdicts.push_back(std::move(verdict));
  }
  all.converged = converged_sentences(summary);
  all.warnings = warnings(summary);
  all.beta_note = note_on_beta(summary);
  return all;
}

std::optional<double> largest_difference(LawResult const& law, std::size_t parameter) {
  std::optional<double> largest;
  for (auto const& fit : law.devices) {
    if (parameter >= fit.parameters.size() || !fit.parameters[parameter].free) continue;
    if (auto const& percent_of_lot = fit.parameters[parameter].percent_of_lot)
      largest = std::max(largest.value_or(0.0), std::abs(*percent_of_lot) / 100.0);
  }
  return largest;
}

std::optional<double> mean_magnitude(LawResult const& law, std::optional<double> DeviceFit::*error) {
  double sum = 0.0;
  int count = 0;
  for (auto const& fit : law.devices) {
    if (!(fit.*error)) continue;
    sum += std::abs(*(fit.*error));
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::vector<std::size_t> by_objective(Summary const& summary) {
  std::vector<std::size_t> order(summary.laws.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t law) {
    return summary.laws[law].objective.mean.value_or(std::numeric_limits<double>::infinity());
  });
  return order;
}

std::vector<std::string> device_names(Summary const& summary) {
  std::vector<std::string> names;
  for (auto const& device : summary.devices)
    if (device.status == "ok") names.push_back(device.name);
  return names;
}

DeviceFit const* fit_of(LawResult const& law, std::string_view device) {
  auto const fit = std::ranges::find(law.devices, device, &DeviceFit::device);
  return fit == law.devices.end() ? nullptr : &*fit;
}

std::vector<ParameterFit> const& parameters_of(LawResult const& law) {
  static std::vector<ParameterFit> const none;
  for (auto const& fit : law.devices)
    if (!fit.parameters.empty()) return fit.parameters;
  return none;
}

std::optional<std::size_t> place_of(lot::Population const& population, std::string_view parameter) {
  auto const found = std::ranges::find(population.names, parameter);
  if (found == population.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - population.names.begin());
}

std::string enumerate(std::vector<std::string> const& names, std::size_t most) {
  std::string text;
  std::size_t const shown = names.size() <= most ? names.size() : std::max<std::size_t>(most, 2) - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

}  // namespace isolaw::study
