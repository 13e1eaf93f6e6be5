// What the analyses of a building say: whether bounds cover its draws, and what weakens that answer.
#include <fmt/format.h>

#include <string>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

// "1,000"
std::string with_commas(double count) {
  auto text = fmt::format("{:.0f}", count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

// "factors of 0.94 and 1.06 would cover 95 %"; factors within a step of the grid of 1 are no more than its accuracy.
std::string factors(Finding const& f) {
  auto const would = fmt::format("would cover {:.0f} %", 100.0 * f.number("enough"));
  if (!f.has_number("factor_low"))
    return fmt::format("no factors up to {:.2f} and {:.2f} {}", f.number("grid_low"), f.number("grid_high"), would);
  constexpr double rounding = 1e-9;
  if (f.number("factor_low") > 1.0 - f.number("grid_step") - rounding)
    return fmt::format("factors within {:.0f} % of 1, the accuracy, {}", 100.0 * f.number("grid_step"), would);
  return fmt::format("factors of {:.2f} and {:.2f} {}", f.number("factor_low"), f.number("factor_high"), would);
}

}  // namespace

std::string building_bounds_cover(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "{}: with {} the bounds cover {:.0f} % of {} buildings ({:.0f} to {:.0f} %) in the largest displacement of a bearing{}; {}.",
      f.word("answer"), law_name(f), 100.0 * f.number("inside"), with_commas(f.number("draws")),
      100.0 * f.number("interval_low"), 100.0 * f.number("interval_high"),
      f.word("nominal_outside") == "yes" ? ", since the nominal building itself is outside them" : "", factors(f));
}

std::string covering_factors(Group group) {
  return factors(group.front());
}

std::string building_bounds_cover_with(Group group) {
  auto const& f = group.front();
  return fmt::format("With {} the same bounds cover {:.0f} %.", law_name(f), 100.0 * f.number("inside"));
}

std::string building_law_or_lot(Group group) {
  return group.front().number("law_std_ln") > group.front().number("lot_std_ln")
             ? "The choice of the law matters more than the scatter of the lot."
             : "The scatter of the lot matters more than the choice of the law.";
}

std::string building_no_draws(Group) {
  return "No bearing is a draw of the lot: there is no scatter that bounds could cover.";
}

std::string displacement_beyond_tests(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "bearings move up to {:.0f} mm (95 % of the draws, under the strongest motion), but the tests went to {:.0f} mm. Beyond that the law is extrapolated.",
      f.number("most_mm"), f.number("tested_mm"));
}

std::string bounds_not_monotonic(Group group) {
  auto const& f = group.front();
  auto const unit = f.word("unit") == "-" ? std::string() : " " + std::string(f.word("unit"));
  bool const above = f.number("lower") > f.number("nominal");
  auto const why =
      fmt::format("both bound analyses ({:.4g} and {:.4g}{}) are {} the nominal building ({:.4g}{})", f.number("lower"),
                  f.number("upper"), unit, above ? "above" : "below", f.number("nominal"), unit);
  return f.has_number("inside")
             ? fmt::format("ignore the {:.0f} % for {}: {}.", 100.0 * f.number("inside"), f.word("quantity"), why)
             : fmt::format("for {} {}", f.word("quantity"), why);
}

std::string bounds_cover_less(Group group) {
  std::vector<std::string> parts;
  for (auto const& f : group)
    parts.push_back(fmt::format("{} {:.0f} %", f.word("quantity"), 100.0 * f.number("inside")));
  return fmt::format("less than {:.0f} % of the draws lie between the bounds in {}.",
                     100.0 * group.front().number("enough"), enumerate(parts, 20));
}

std::string springs_as_given(Group) {
  return "it has no coupled form, and its springs have the parameters of the law along one direction: they round its knee and dissipate less. isolaw calibrate --bidirectional springs fits them.";
}

std::string building_runs_failed(Group group) {
  return fmt::format("{} runs gave no finite numbers and are left out.", group.front().number("failed"));
}

std::string draws_too_few(Group group) {
  auto const& f = group.front();
  return fmt::format("{} draws are too few to show a share of {:.0f} %: no answer yet.", f.number("draws"),
                     100.0 * f.number("enough"));
}

std::string motions_too_few(Group group) {
  auto const& f = group.front();
  return fmt::format("{} motion{}: codes take the mean over {} or more as the design's, some over eleven.",
                     f.number("motions"), f.number("motions") == 1.0 ? "" : "s", f.number("wanted"));
}

}  // namespace isolaw::wording
