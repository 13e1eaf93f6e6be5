// What is said of how a record was read, and of what was done to it.
#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {

std::string vertical_test_refused(Group group) {
  return fmt::format("vertical test: {}", group.front().word("reason"));
}

std::string units_implausible(Group group) {
  auto const& f = group.front();
  auto const kind = f.word("than_any");
  auto const size = kind == "longer"
                        ? std::string("no isolator goes that far")
                        : fmt::format("{} kN/mm is {} than any isolator", range(group, "stiffness_kN_per_mm", 4), kind);
  return fmt::format(
      "{} kN over {} mm: {}. Are displacements really in {} and forces in {}? (--units disp=UNIT,force=UNIT)",
      range(group, "force_kN", 4), range(group, "way_mm", 4), size, f.word("disp_unit"), f.word("force_unit"));
}

std::string vertical_stiffness_implausible(Group group) {
  return fmt::format("vertical test: a vertical stiffness of {} kN/mm is {} than any isolator's. Are the units right?",
                     range(group, "K_v_kN_per_mm", 4), group.front().word("than_any"));
}

std::string vertical_softer_than_expected(Group group) {
  return fmt::format(
      "vertical test: {} kN/mm is less than {} times the horizontal stiffness. Is it a compression test, in the units that its file states?",
      range(group, "K_v_kN_per_mm", 4), range(group, "least_ratio"));
}

std::string time_in_days(Group group) {
  return fmt::format("time runs {}, {} samples a second. These look like days of a spreadsheet; try --units time=d.",
                     each(group,
                          [](Finding const& f) {
                            return fmt::format("from {:.10g} to {:.10g} s", f.number("first_s"), f.number("last_s"));
                          }),
                     range(group, "rate_Hz", 4));
}

std::string about_acceleration(Group group) {
  return fmt::format(
      "the file speaks of acceleration ('{}'), but what is read must be the displacement of the device, one face against the other, over time.",
      group.front().word("line"));
}

std::string shared_time_short(Group group) {
  return fmt::format("only {} of {} samples lie in the time of {} too.", range(group, "samples", 7),
                     range(group, "of", 7), group.front().word("file"));
}

std::string channel_interpolated(Group group) {
  auto const& f = group.front();
  return fmt::format("{} has a sample every {} s, {} every {} s: between them its values are interpolated.",
                     f.word("file"), range(group, "interval_s", 4), f.word("other_file"),
                     range(group, "other_interval_s", 4));
}

std::string axis_taken_for_channel(Group group) {
  auto const& f = group.front();
  return fmt::format("{} is named after the machine's axis and taken for the {}: nothing else in the file is one.",
                     f.word("column"), f.word("channel"));
}

std::string unit_overridden(Group group) {
  auto const& f = group.front();
  return fmt::format("{} says {}, and is read in {} as asked for by --units.", f.word("column"), f.word("stated"),
                     f.word("used"));
}

std::string loads_ambiguous(Group group) {
  auto const& f = group.front();
  return fmt::format("{} may each be the {}: none is read ({} says which).", f.word("columns"), f.word("channel"),
                     f.word("options"));
}

std::string load_unit_unclear(Group group) {
  auto const& f = group.front();
  return fmt::format("{}: the vertical load is not read ({} says its unit).", f.word("reason"), f.word("options"));
}

std::string velocity_unused(Group group) {
  return fmt::format("{} is not used: velocities are computed from displacement and time.",
                     group.front().word("column"));
}

std::string stated(Group group) {
  return std::string(group.front().word("text"));
}

std::string no_time_column(Group) {
  return "no time column: rate-dependent laws need --dt SECONDS, the sampling interval";
}

std::string force_flipped(Group) {
  return "the force is multiplied by -1, as asked for (--flip-force)";
}

std::string spikes_repaired(Group group) {
  auto const& f = group.front();
  auto const channel = f.word("channel"), unit = f.word("unit");
  double const count = f.number("count");
  if (count == 0.0) return fmt::format("no spikes of {} to repair", channel);
  std::vector<std::string> samples;
  for (int k = 1; f.has_number(k == 1 ? "sample" : fmt::format("sample_{}", k)); ++k) {
    auto const which = k == 1 ? std::string() : fmt::format("_{}", k);
    auto const of = [&](std::string_view name) { return f.number(fmt::format("{}_{}{}", name, unit, which)); };
    samples.push_back(fmt::format(
        "sample {}{} from {} to {} {}", f.number("sample" + which),
        f.has_number("time_s" + which) ? fmt::format(" ({} s)", number_text(f.number("time_s" + which), 6)) : "",
        number_text(of("from"), 5), number_text(of("to"), 5), unit));
  }
  auto const left = count - static_cast<double>(samples.size());
  if (left > 0.0) samples.push_back(fmt::format("and {} more", left));
  return fmt::format("{} of {} repaired by what the neighbours say: {}",
                     count == 1.0 ? "a spike" : fmt::format("{} spikes", count), channel, joined(samples));
}

std::string skew_removed(Group group) {
  auto const& f = group.front();
  bool const back = f.number("skew_ms") > 0.0;
  auto const dropped = f.number("dropped_samples");
  return fmt::format(
      "force moved {} by {} ms, between samples by interpolation; {} sample{} without a force dropped at the {}",
      back ? "back" : "forward", number_text(back ? f.number("skew_ms") : -f.number("skew_ms"), 6), dropped,
      dropped == 1.0 ? "" : "s", back ? "end" : "start");
}

std::string friction_removed(Group group) {
  auto const& f = group.front();
  return f.has_number("friction_kN")
             ? fmt::format("the rig's friction of {:.6g} kN taken off along the motion", f.number("friction_kN"))
             : fmt::format("the rig's friction of {:.6g} times the vertical load taken off along the motion",
                           f.number("coefficient"));
}

std::string inertia_removed(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "inertia of a moving mass of {} kg taken off: {} to {} kN, from displacement averaged three times over {} samples",
      number_text(f.number("mass_kg"), 6), number_text(f.number("least_kN"), 3), number_text(f.number("largest_kN"), 3),
      f.number("window_samples"));
}

std::string force_multiplied(Group group) {
  return fmt::format("force multiplied by {:.6g}", group.front().number("factor"));
}

std::string centred(Group group) {
  auto const& f = group.front();
  return fmt::format("centred: {} mm taken from displacement and {} kN from force, (max + min) / 2 over {}",
                     number_text(f.number("disp_mm")), number_text(f.number("force_kN")),
                     f.blocks.empty() ? std::string("the whole record, which has no cycle to report")
                                      : fmt::format("cycle {} of block {}", f.number("cycle"), f.blocks.front()));
}

std::string smoothed(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "displacement and force averaged over {} samples, fewer at the ends{}", f.number("window_samples"),
      f.has_number("percent")
          ? fmt::format(": takes {} % from a sine of the test's frequency, {} % from its third harmonic",
                        number_text(f.number("percent"), 2), number_text(f.number("third_harmonic_percent"), 2))
          : std::string());
}

std::string not_smoothed(Group) {
  return "no smoothing";
}

std::string scored_in_part(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "laws are judged by {} of {} samples (blocks {}, cycles {}); the rest of the history only acts on their state",
      f.number("samples"), f.number("of"), f.word("blocks"), f.word("cycles"));
}

std::string all_samples_kept(Group group) {
  auto const& f = group.front();
  if (!f.word("option").empty()) return "all samples kept, as asked for";
  if (!f.has_number("wanted")) return "all samples kept: without cycles there is nothing to thin by";
  return fmt::format("all samples kept: {} per cycle is less than twice the {} asked for",
                     with_decimals(f.number("samples_per_cycle"), 1), f.number("wanted"));
}

std::string velocity_computed(Group) {
  return "velocity by central differences of the averaged displacement at the true times";
}

std::string no_velocity(Group) {
  return "no velocity: the record has no time, which counts samples instead";
}

std::string samples_thinned(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "thinned from {} to {} samples per cycle: every {}th of {} samples kept ({}), each the average of {}",
      with_decimals(f.number("from_per_cycle"), 1), with_decimals(f.number("to_per_cycle"), 1), f.number("every"),
      f.number("of_samples"), f.number("samples"), f.number("window_samples"));
}

}  // namespace isolaw::wording
