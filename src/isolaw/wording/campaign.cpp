// What is said of a campaign: its runs, its laws and their parameters, its devices beside one another.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

using Names = std::vector<std::string>;

// "misses the measured force by 42 % of its standard deviation on average, misses the effective stiffness by 20 %"
std::string misses(Finding const& finding) {
  Names parts;
  if (finding.has_number("misfit"))
    parts.push_back(fmt::format("misses the measured force by {} % of its standard deviation on average",
                                with_decimals(100.0 * finding.number("misfit"), 1)));
  auto const add = [&](std::string_view number, std::string_view of) {
    if (finding.has_number(number))
      parts.push_back(fmt::format("misses the {} by {}", of, percent(finding.number(number) / 100.0)));
  };
  add("K_eff_error_percent", "effective stiffness");
  add("energy_error_percent", "dissipated energy");
  return enumerate(parts);
}

std::string prediction(Finding const& finding, std::string_view grade) {
  return fmt::format(
      "its prediction is {}: objective {} on blocks it was not fitted to ({} at worst), {} on those it was", grade,
      number_text(finding.number("predicted_objective"), 3), number_text(finding.number("worst_predicted"), 3),
      number_text(finding.number("fitted_objective"), 3));
}

// The devices of a finding, or how many they are of all that the law was fitted to.
std::string where(Finding const& finding) {
  auto const fitted = static_cast<std::size_t>(finding.number("fitted_devices"));
  auto const count = finding.devices.size();
  if (count == fitted && fitted > 1) return fmt::format("all {} devices", fitted);
  if (count > 3) return fmt::format("{} of {} devices", count, fitted);
  return enumerate(finding.devices);
}

}  // namespace

std::string runs_missing(Group group) {
  auto const& f = group.front();
  auto const part = f.has_number("part") ? fmt::format("This is part {} of {}. ", f.number("part"), f.number("parts"))
                                         : std::string();
  return fmt::format("{}{} of {} runs are done: every number and the choice of a law may still change.", part,
                     f.number("runs"), f.number("expected_runs"));
}

std::string analyses_missing(Group group) {
  auto const& f = group.front();
  return fmt::format("{} of {} analyses are done: what they say of parameters and of other devices is not there yet.",
                     f.number("analyses"), f.number("expected_analyses"));
}

std::string device_refused(Group group) {
  auto const& f = group.front();
  return fmt::format("{} was refused: {}", enumerate(f.devices), on_one_line(f.word("reason")));
}

std::string rule_set_not_kept_by_device(Group group) {
  auto const& f = group.front();
  return fmt::format("{} fails {}: {}", printable(enumerate(f.devices)), f.word("rules"), f.word("failures"));
}

std::string rule_set_not_kept_by_lot(Group group) {
  return fmt::format("The lot does not keep its rule set: {}", group.front().word("verdict"));
}

std::string devices_not_in_lot_law(Group group) {
  auto const& f = group.front();
  return fmt::format("The lot's law says nothing of {} of its {} devices, which {} refused: {}.", f.devices.size(),
                     f.number("devices"), f.devices.size() == 1 ? "was" : "were", enumerate(f.devices));
}

std::string same_record(Group group) {
  auto const& f = group.front();
  if (f.word("refused") == "yes") return fmt::format("{} hold the same record.", enumerate(f.devices));
  return fmt::format("{} hold the same record, which counts {} times in every mean and spread over the devices.",
                     enumerate(f.devices), f.devices.size());
}

std::string same_compression_test(Group group) {
  auto const& f = group.front();
  return fmt::format("{} hold the same compression test: its K_v counts {} times.", enumerate(f.devices),
                     f.devices.size());
}

std::string energy_falls(Group group) {
  auto const& f = group.front();
  auto const own = percent(std::max(0.0, f.number("law_percent")) / 100.0);
  auto const follows =
      f.word("only_law") == "yes"
          ? fmt::format("{} does not follow that (its own energy falls by {}): it is right for some cycle in between.",
                        law_name(f), own)
          : fmt::format("No law follows that ({} comes nearest, with {}): each is right for some cycle in between.",
                        law_name(f), own);
  return fmt::format("the energy of a cycle falls by {} from cycle {} to cycle {} of block {}. {}{}",
                     percent(f.number("measured_percent") / 100.0), f.number("first_cycle"), f.number("last_cycle"),
                     f.blocks.front(), follows,
                     f.word("fit_cycles") == "given" ? "" : " To fit the first or the last cycles, use --fit-cycles.");
}

std::string law_refused(Group group) {
  auto const& f = group.front();
  return fmt::format("{} was not identified on {}: {}{}", law_name(f), enumerate(devices_of(group)),
                     on_one_line(f.word("reason")),
                     f.has_number("others") ? "; its mean and beta cover the other devices only" : "");
}

std::string runs_failed(Group group) {
  double failed = 0.0;
  for (auto const& finding : group) failed += finding.number("failed");
  auto const& f = group.front();
  return fmt::format("{} of {} runs failed, and its numbers are those of the others. The first failed on {}: {}",
                     failed, f.number("runs_of_law"), enumerate(f.devices), f.word("reason"));
}

std::string evaluations_failed(Group group) {
  auto const& f = group.front();
  return fmt::format("{} of {} parameter sets that were tried ({}) gave no finite force and were passed over.",
                     f.number("failed"), f.number("tried"), percent(f.number("failed") / f.number("tried")));
}

std::string law_inadequate(Group group) {
  auto const& f = group.front();
  return fmt::format("{} does not describe the devices: it {}.", law_name(f), misses(f));
}

std::string held_by_box(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "{} of its {} parameters lie at a bound on half of the devices or more. The search box keeps them together, so its beta is no robustness.",
      f.number("count"), f.number("calibrated"));
}

std::string prediction_poor(Group group) {
  return prediction(group.front(), "poor") + ".";
}

std::string prediction_unusable(Group group) {
  auto const& f = group.front();
  auto text = prediction(f, "unusable") + ".";
  if (f.word("collapse") == "constant")
    text += " It misses one of them by more than the force's standard deviation, as a constant force would.";
  else if (f.word("collapse") == "far" && f.number("fitted_objective") > 0.0)
    text += fmt::format(" It misses them {} times as far as those it was fitted to.",
                        with_decimals(f.number("predicted_objective") / f.number("fitted_objective"), 0));
  else if (f.word("collapse") == "far")
    text += " It misses them, but not those it was fitted to.";
  text += " Do not use it for other amplitudes or frequencies than those it was fitted to";
  if (f.has_number("fitted_to_mm")) text += fmt::format(", up to {} mm", number_text(f.number("fitted_to_mm"), 3));
  return text + ".";
}

std::string prediction_good(Group group) {
  return prediction(group.front(), "good") + ".";
}
std::string prediction_fair(Group group) {
  return prediction(group.front(), "fair") + ".";
}
std::string prediction_unknown(Group) {
  return "how well it predicts is not known: no block of the tests was kept from the fit.";
}

std::string searches_disagree(Group group) {
  double const share = group.front().number("share");
  return fmt::format("{} of the runs came within 0.1 % of the best fit of this campaign.",
                     share == 0.0 ? "none" : percent(share));
}

std::string not_determined(Group group) {
  Names parts;
  for (auto const& f : group) {
    auto const all = static_cast<std::size_t>(f.number("fitted_devices"));
    auto const name = enumerate(f.parameters);
    parts.push_back(f.devices.size() == all ? name : fmt::format("{} ({} of {} devices)", name, f.devices.size(), all));
  }
  auto text = fmt::format("the tests cannot fix {}.", enumerate(parts, 6));
  if (auto const form = group.front().word("reduced_form"); !form.empty())
    text += fmt::format(" {} searches a form with the same loops and without the redundant parameter.", form);
  return text;
}

std::string prediction_not_asked(Group) {
  return "The records hold several blocks, but every block was fitted: nothing shows whether a law fitted to some holds for the others. Use --fit-blocks with the numbers of some to predict the rest.";
}

std::string outlier(Group group) {
  Names parts;
  for (auto const& f : group) {
    auto const unit = f.word("unit");
    parts.push_back(fmt::format("{} {}{}{} ({:+.0f} % from the median)", f.word("property"),
                                number_text(f.number("value")), unit.empty() ? "" : " ", unit, f.number("percent")));
  }
  return fmt::format("{} stands apart from its lot: {}.", enumerate(group.front().devices), enumerate(parts, 4));
}

std::string at_bound(Group group) {
  Names parts;
  for (auto const& f : group)
    parts.push_back(fmt::format("{} at its {} bound on {}", enumerate(f.parameters), f.word("side"), where(f)));
  return shortened(std::move(parts), 6, "; ");
}

std::string lot_law_at_bound(Group group) {
  Names parts;
  for (auto const& f : group)
    parts.push_back(fmt::format("{} at its {} bound", enumerate(f.parameters), f.word("side")));
  return "in the one law for all devices, " + enumerate(parts, 6);
}

std::string integration_coarse(Group group) {
  double largest = 0.0;
  for (auto const& f : group) largest = std::max(largest, f.number("shift"));
  return fmt::format("a finer integration step would move the objective by up to {:.2g} on {}.", largest,
                     enumerate(devices_of(group)));
}

std::string integration_not_finite(Group group) {
  return fmt::format(
      "its force is not finite in finer integration steps on {}: the result comes from the step, not from the law.",
      enumerate(devices_of(group)));
}

}  // namespace isolaw::wording
