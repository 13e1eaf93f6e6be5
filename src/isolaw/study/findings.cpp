#include "isolaw/study/findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "isolaw/data/signals/copies.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/analysis_findings.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/ranges.hpp"

namespace isolaw::study {
namespace {

bool ranked(LawResult const& law) {
  return law.objective.mean && law.beta;
}

bool dominates(LawResult const& a, LawResult const& b) {
  bool const no_worse = *a.objective.mean <= *b.objective.mean && *a.beta <= *b.beta;
  return no_worse && (*a.objective.mean < *b.objective.mean || *a.beta < *b.beta);
}

// Adds warnings about a law that is offered as a choice: the search box decides its beta (pinned()), or its prediction
// of the blocks left out of the fit is worse than fair.
void add_cautions(std::vector<Finding>& findings, Summary const& summary, LawResult const& law) {
  if (auto const held = pinned(law); held.decides()) findings.push_back(held.finding(law.id));
  if (!law.prediction_holds()) findings.push_back(prediction_of(summary, law));
}

// True for a law that was identified and is adequate. Only such laws are compared or recommended.
bool describes(LawResult const& law) {
  return law.objective.mean && is_adequate(law);
}

std::string among(Summary const& summary) {
  return std::ranges::all_of(summary.laws, is_adequate) ? "all" : "adequate";
}

Finding beside_others(Summary const& summary, FindingKind kind, LawResult const& law) {
  Finding finding{.kind = kind, .law = law.id, .words = {{"among", among(summary)}}};
  if (law.objective.mean) finding.numbers.push_back({"misfit", *law.objective.mean});
  if (law.beta) finding.numbers.push_back({"beta", *law.beta});
  return finding;
}

// The front among the adequate laws. An inadequate law is never offered, even if it beats others.
std::vector<bool> front_among_adequate(Summary const& summary) {
  return front_of(
      summary.laws, [](auto const& law) { return describes(law) ? law.beta : std::nullopt; },
      [](auto const& law) { return law.objective.mean; });
}

std::vector<bool> converged_among_adequate(Summary const& summary) {
  return front_of(
      summary.laws, [](auto const& law) { return describes(law) ? law.beta_converged : std::nullopt; },
      [](auto const& law) { return law.objective_converged; });
}

// `front` goes from the most accurate to the most robust law. Returns the last index in `front` whose law has a beta
// that the search box does not decide, or 0 if there is none.
std::size_t robust_end(Summary const& summary, std::vector<std::size_t> const& front) {
  for (std::size_t place = front.size(); place-- > 1;)
    if (!pinned(summary.laws[front[place]]).decides()) return place;
  return 0;
}

// Finds the law between the two ends of `front` that is nearest to the point of least objective and least beta, both
// scaled to differ by 1 between the ends. Returns its index in `front`, or front.size() if there is none. The law must
// predict well, and the search box must not decide its beta. If there are analyses, it must also be on the front of
// their results, which are free of the optimiser's noise.
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
  bool const held = pinned(law).decides();
  LawVerdict verdict{front[place], Role::between, {}, {}};
  auto finding = beside_others(summary, FindingKind::role_alone, law);
  if (place > 0 && held) {
    verdict.role = Role::held_by_box;
  } else if (front.size() == 1 && !held) {
    verdict.role = Role::best_of_both;
    finding.kind = FindingKind::role_best_of_both;
  } else if (place == 0) {
    verdict.role = Role::most_accurate;
  } else if (place == robust_end(summary, front)) {
    auto const& accurate = laws[front.front()];
    verdict.role = Role::most_robust;
    finding.kind = FindingKind::role_most_robust;
    finding.other_laws = {accurate.id};
    finding.numbers.push_back({"other_misfit", *accurate.objective.mean});
    finding.words = {{"least", place + 1 < front.size() ? "unboxed" : among(summary)}};
  } else {
    auto const &accurate = laws[front[place - 1]], &robust = laws[front[place + 1]];
    if (place == compromise(summary, front)) verdict.role = Role::compromise;
    finding.kind = FindingKind::role_between;
    finding.words = {{"accurate", accurate.id}, {"robust", robust.id}};
    finding.numbers.push_back({"accurate_beta", *accurate.beta});
    finding.numbers.push_back({"robust_misfit", *robust.objective.mean});
  }
  verdict.findings.push_back(std::move(finding));
  add_cautions(verdict.findings, summary, law);
  return verdict;
}

LawVerdict dominated_verdict(Summary const& summary, std::vector<std::size_t> const& front, std::size_t index) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::dominated, {}, {}};
  for (std::size_t const other : front)
    if (dominates(summary.laws[other], law)) verdict.dominated_by.push_back(summary.laws[other].id);
  auto const kind = verdict.dominated_by.empty() ? FindingKind::role_not_on_front : FindingKind::role_dominated;
  verdict.findings.push_back(beside_others(summary, kind, law));
  verdict.findings.back().other_laws = verdict.dominated_by;
  return verdict;
}

LawVerdict unranked_verdict(Summary const& summary, std::size_t index, LawResult const& best) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::unranked, {}, {}};
  auto finding = beside_others(summary, FindingKind::role_behind, law);
  bool const is_best = &law == &best;
  if (!law.objective.mean) {
    finding.kind = FindingKind::role_not_identified;
  } else if (is_best) {
    finding.kind = FindingKind::role_least_error;
    if (compares_laws(summary)) finding.words = {{"least", among(summary)}};
  } else {
    finding.other_laws = {best.id};
    finding.numbers.push_back({"times", *law.objective.mean / *best.objective.mean});
  }
  verdict.findings.push_back(std::move(finding));
  if (is_best && law.objective.mean) add_cautions(verdict.findings, summary, law);
  return verdict;
}

// `best` is the index of the most accurate adequate law, or the number of laws if there is none.
std::vector<Finding> headline(Summary const& summary, std::vector<std::size_t> const& front, std::size_t best) {
  auto const& laws = summary.laws;
  auto const about = [&](FindingKind kind, std::size_t index) {
    std::vector<Finding> findings{beside_others(summary, kind, laws[index])};
    add_cautions(findings, summary, laws[index]);
    return findings;
  };
  if (best < laws.size() && !compares_laws(summary)) return about(FindingKind::headline_only_law, best);
  if (front.size() == 1)
    return about(
        pinned(laws[front[0]]).decides() ? FindingKind::headline_most_accurate : FindingKind::headline_best_of_both,
        front[0]);
  if (front.size() > 1) {
    auto const middle = compromise(summary, front), end = robust_end(summary, front);
    if (end == 0) return about(FindingKind::headline_scatter_by_box, front[0]);
    auto const held = std::ranges::count_if(
        front, [&](std::size_t law) { return law != front[0] && law != front[end] && pinned(laws[law]).decides(); });
    auto findings = about(FindingKind::headline_choice, front[0]);
    auto& choice = findings.front();
    bool const between = middle < front.size();
    choice.words.push_back({"robust", laws[front[end]].id});
    if (between) choice.words.push_back({"compromise", laws[front[middle]].id});
    choice.words.push_back({"none_between", !between && end > 1 ? "yes" : "no"});
    choice.numbers.push_back({"considered", static_cast<double>(front.size()) - static_cast<double>(held)});
    choice.numbers.push_back({"compared", static_cast<double>(laws.size())});
    add_cautions(findings, summary, laws[front[end]]);
    return findings;
  }
  if (best < laws.size()) return about(FindingKind::headline_most_accurate, best);
  auto const ranking = by_objective(summary);
  if (ranking.empty() || !laws[ranking.front()].objective.mean) return {{.kind = FindingKind::none_identified}};
  auto const& nearest = laws[ranking.front()];
  return {beside_others(summary, FindingKind::headline_nearest, nearest), *inadequacy(nearest)};
}

// Groups the devices for which counts() is true. A device joins a group if same() is true for the group's first device
// and this one. Groups of one device are dropped.
template <class Counts, class Same>
std::vector<std::vector<DeviceResult const*>> groups_of_devices(Summary const& summary, Counts counts, Same same) {
  std::vector<std::vector<DeviceResult const*>> groups;
  for (auto const& device : summary.devices) {
    if (!counts(device)) continue;
    auto found = std::ranges::find_if(groups, [&](auto const& group) { return same(*group.front(), device); });
    if (found == groups.end()) found = groups.insert(groups.end(), {{}});
    found->push_back(&device);
  }
  std::erase_if(groups, [](auto const& group) { return group.size() < 2; });
  return groups;
}

std::string note_on_beta(Summary const& summary) {
  if (std::ranges::any_of(summary.laws, [](auto const& law) { return law.beta.has_value(); })) return {};
  for (auto const& law : summary.laws)
    if (!law.beta_note.empty()) return law.beta_note;
  return "no law has a robustness index";
}

bool says_the_same(FindingKind doubt, FindingKind warning) {
  using enum FindingKind;
  switch (doubt) {
    case weak_search:
      return warning == searches_disagree;
    case weak_bounds:
      return warning == held_by_box;
    case weak_open:
      return warning == not_determined;
    default:
      return false;
  }
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

bool concerns_answer(Summary const& summary, Recommendation const& answer, Finding const& warning) {
  if (!answer.law) return true;
  if (!warning.law.empty() && warning.law != summary.laws[*answer.law].id) return false;
  return std::ranges::none_of(answer.doubts(),
                              [&](auto const& doubt) { return says_the_same(doubt.kind, warning.kind); });
}

Findings findings(Summary const& summary) {
  auto const ranking = by_objective(summary);
  auto const on_front = front_among_adequate(summary);
  auto const adequate = std::ranges::find_if(ranking, [&](std::size_t law) { return describes(summary.laws[law]); });
  auto const best = adequate != ranking.end() ? *adequate : summary.laws.size();
  std::vector<std::size_t> front, dominated, inadequate, unranked;
  for (std::size_t const index : ranking) {
    auto const& law = summary.laws[index];
    (!is_adequate(law) ? inadequate : !ranked(law) ? unranked : on_front[index] ? front : dominated).push_back(index);
  }
  Findings all;
  all.recommendation = recommendation(summary);
  all.headline = headline(summary, front, best);
  for (std::size_t place = 0; place < front.size(); ++place)
    all.verdicts.push_back(front_verdict(summary, front, place));
  for (std::size_t const index : dominated) all.verdicts.push_back(dominated_verdict(summary, front, index));
  for (std::size_t const index : inadequate)
    all.verdicts.push_back({index, Role::inadequate, {*inadequacy(summary.laws[index])}, {}});
  for (std::size_t const index : unranked) {
    auto verdict = unranked_verdict(summary, index, summary.laws[best < summary.laws.size() ? best : ranking.front()]);
    auto const& note = summary.laws[index].beta_note;
    if (!front.empty() && !note.empty())
      verdict.findings.push_back(
          {.kind = FindingKind::role_no_beta, .law = summary.laws[index].id, .words = {{"note", note}}});
    all.verdicts.push_back(std::move(verdict));
  }
  all.converged = converged_findings(summary);
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
  for (auto const& fit : law.counting()) {
    if (!(fit.*error)) continue;
    sum += std::abs(*(fit.*error));
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<double> largest_displacement(Summary const& summary, LawResult const& law) {
  Ranges ranges;
  for (auto const& device : summary.devices) {
    auto const* fit = fit_of(law, device.name);
    if (fit != nullptr && fit->objective.mean && device.record.size() > 0) ranges.add(device.record);
  }
  double const mm = law.prediction_holds() ? ranges.tested.disp_mm : ranges.fitted.disp_mm;
  return mm > 0.0 ? std::optional(mm) : std::nullopt;
}

std::vector<std::vector<DeviceResult const*>> devices_of_one_record(Summary const& summary) {
  auto const counting = [](DeviceResult const& device) { return device.counts() ? device.name : device.copy_of; };
  return groups_of_devices(
      summary, [](DeviceResult const&) { return true; },
      [&](DeviceResult const& one, DeviceResult const& other) { return counting(one) == counting(other); });
}

std::vector<std::vector<DeviceResult const*>> devices_of_one_compression(Summary const& summary) {
  return groups_of_devices(
      summary, [](DeviceResult const& device) { return !device.vertical_test.load_kN.empty(); },
      [](DeviceResult const& one, DeviceResult const& other) {
        auto const &test = one.vertical_test, &other_test = other.vertical_test;
        return test.load_kN == other_test.load_kN && test.disp_mm == other_test.disp_mm;
      });
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

}  // namespace isolaw::study
