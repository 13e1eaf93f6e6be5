#include "isolaw/study/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/analysis_findings.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/ranges.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

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
                                   error_percent(law), error_percent(accurate), called(accurate));
  } else {
    auto const& accurate = laws[front[place - 1]];
    auto const& robust = laws[front[place + 1]];
    if (place == compromise(summary, front)) verdict.role = Role::compromise;
    verdict.sentence = fmt::format("Scatters less than {} ({} against {}) and errs less than {} ({} against {}).",
                                   called(accurate), percent(*law.beta), percent(*accurate.beta), called(robust),
                                   error_percent(law), error_percent(robust));
  }
  verdict.sentence += caution(law);
  return verdict;
}

LawVerdict dominated_verdict(Summary const& summary, std::vector<std::size_t> const& front, std::size_t index) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::dominated, {}, {}};
  std::vector<std::string> dominating;
  for (std::size_t const other : front)
    if (dominates(summary.laws[other], law)) {
      verdict.dominated_by.push_back(summary.laws[other].id);
      dominating.push_back(called(summary.laws[other]));
    }
  auto const numbers = fmt::format("error {}, scatter {}", error_percent(law), percent(*law.beta));
  verdict.sentence = verdict.dominated_by.empty()
                         ? fmt::format("is not on the front ({}).", numbers)
                         : fmt::format("is dominated by {} ({}).", enumerate(dominating), numbers);
  return verdict;
}

LawVerdict unranked_verdict(Summary const& summary, std::size_t index, LawResult const& best) {
  auto const& law = summary.laws[index];
  LawVerdict verdict{index, Role::unranked, {}, {}};
  if (!law.objective.mean) {
    verdict.sentence = "was not identified on any device.";
  } else if (&law == &best && !compares_laws(summary)) {
    verdict.sentence = fmt::format("{}.{}", miss_text(law), caution(law));
  } else if (&law == &best) {
    verdict.sentence = fmt::format("{}, the least {}.{}", miss_text(law),
                                   among(summary).empty() ? "of all" : among(summary).substr(1), caution(law));
  } else {
    verdict.sentence = fmt::format("has a mean error of {}, {} times that of {}.", error_percent(law),
                                   with_decimals(*law.objective.mean / *best.objective.mean, 2), called(best));
  }
  return verdict;
}

// `best`: the most accurate law that describes the devices; the laws' number where there is none.
std::string headline(Summary const& summary, std::vector<std::size_t> const& front, std::size_t best) {
  auto const& laws = summary.laws;
  auto const flagged = [&](std::size_t index) {
    auto const& law = laws[index];
    return called(law) +
           (law.prediction_holds() ? "" : fmt::format(", whose prediction is {}", name(*law.prediction_grade))) +
           (pinned(law).decides() ? ", which its box holds together" : "");
  };
  if (best < laws.size() && !compares_laws(summary))
    return fmt::format("{} is the only law that was identified.{}", called(laws[best]), caution(laws[best]));
  if (front.size() == 1 && pinned(laws[front[0]]).decides())
    return fmt::format("{} is the most accurate law{}; how robust it is cannot be said.{}", called(laws[front[0]]),
                       among(summary), caution(laws[front[0]]));
  if (front.size() == 1)
    return fmt::format("{} is both the most accurate and the most robust law{}.{}", called(laws[front[0]]),
                       among(summary), caution(laws[front[0]]));
  if (front.size() > 1) {
    auto const middle = compromise(summary, front), end = robust_end(summary, front);
    if (end == 0)
      return fmt::format("{} is the most accurate law{}; what scatters less is held together by its box.{}",
                         called(laws[front[0]]), among(summary), caution(laws[front[0]]));
    auto const held = std::ranges::count_if(
        front, [&](std::size_t law) { return law != front[0] && law != front[end] && pinned(laws[law]).decides(); });
    return fmt::format(
        "{} of {} laws are worth considering: the choice lies between accuracy ({}) and robustness ({}){}.",
        front.size() - static_cast<std::size_t>(held), laws.size(), flagged(front.front()), flagged(front[end]),
        middle < front.size() ? fmt::format("; the best compromise is {}", called(laws[front[middle]]))
        : end > 1
            ? "; none between them holds up (off the front without the optimiser's noise, held by its box, or its prediction does not hold)"
            : "");
  }
  if (best < laws.size())
    return fmt::format("{} is the most accurate law{}; how robust it is cannot be said.{}", called(laws[best]),
                       among(summary), caution(laws[best]));
  auto const ranking = by_objective(summary);
  if (ranking.empty() || !laws[ranking.front()].objective.mean) return "No law could be identified.";
  auto const& nearest = laws[ranking.front()];
  return fmt::format("No law describes these devices: {}, the nearest, {}.", called(nearest), inadequacy(nearest));
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
  std::vector<std::vector<DeviceResult const*>> groups;
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
  std::erase_if(groups, [](auto const& group) { return group.size() < 2; });
  return groups;
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
