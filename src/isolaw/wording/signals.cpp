// Sentences about the signals of records: faults that leave no cyclic properties, and effects of the measurement. One
// sentence for several devices gives magnitudes as a range, but names the device of each sample, time or cycle.
#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

constexpr char const* of_no_use =
    "Whatever is computed from such a signal is wrong: test again, or give a channel that was not disturbed.";

// Finds a number whose name ends with the unit of its channel: "level_mm".
double in_unit(Finding const& finding, std::string_view name) {
  return finding.number(fmt::format("{}_{}", name, finding.word("unit")));
}
std::string signed_text(double value) {
  return (value < 0.0 ? "" : "+") + number_text(value, 3);
}

// "1.5 s (sample 151) and 4.2 s (sample 421)", or "sample 151 and sample 421" if the record has no time.
std::string places(Finding const& finding) {
  std::vector<std::string> all;
  for (int k = 1;; ++k) {
    auto const which = k == 1 ? std::string() : fmt::format("_{}", k);
    if (!finding.has_number("sample" + which)) break;
    auto const sample = fmt::format("sample {}", finding.number("sample" + which));
    all.push_back(finding.has_number("time_s" + which)
                      ? fmt::format("{} s ({})", number_text(finding.number("time_s" + which), 6), sample)
                      : sample);
  }
  if (auto const left = finding.number("count") - static_cast<double>(all.size()); left > 0.0)
    all.push_back(fmt::format("{} more", left));
  return enumerate(all, all.size());
}

// Describes a channel whose value stands still: "at 95 mm for up to 12 samples from 3.2 s (sample 161)".
std::string standing(Group group, std::string_view how) {
  auto const& f = group.front();
  auto const stretch = [](Finding const& finding) {
    return fmt::format("at {} {} for up to {} samples from {}", number_text(in_unit(finding, "level"), 5),
                       finding.word("unit"), finding.number("longest_samples"), places(finding));
  };
  return fmt::format("the {} is {} {}, while the {} goes on. {}", f.word("channel"), how, each(group, stretch),
                     f.word("channel") == "force" ? "motion" : "force", of_no_use);
}

std::string reversal(Group group) {
  auto const unit = group.front().word("unit");
  return fmt::format("force reverses {} {} (+- {} {}, {} reversals)", range(group, fmt::format("by_{}", unit)), unit,
                     range(group, fmt::format("uncertainty_{}", unit), 2), unit, range(group, "reversals"));
}
std::string_view without_jump(Group group) {
  return group.front().word("without_jump") == "yes" ? ", after its jump is subtracted" : "";
}

}  // namespace

std::string signal_clipped(Group group) {
  return standing(group, "clipped");
}

std::string signal_stuck(Group group) {
  return standing(group, "stuck");
}

std::string signal_without_sign(Group group) {
  bool const force = group.front().word("channel") == "force";
  return fmt::format("the {} is recorded without its sign: {} ({}). {}", group.front().word("channel"),
                     force ? "the device moves to both sides, but the force has one sign at all peaks"
                           : "it stays on one side of zero, but the force at its peaks has both signs",
                     each(group, places), of_no_use);
}

std::string signal_interrupted(Group group) {
  auto const gap = [](Finding const& f) {
    return fmt::format("{} {} for {} samples between {} and {} {}, from {}", number_text(in_unit(f, "level"), 5),
                       f.word("unit"), f.number("longest_samples"), number_text(in_unit(f, "before"), 5),
                       number_text(in_unit(f, "after"), 5), f.word("unit"), places(f));
  };
  return fmt::format("the {} drops out: {}. {}", group.front().word("channel"), each(group, gap), of_no_use);
}

std::string signal_spike(Group group) {
  auto const& first = group.front();
  auto const size = [](Finding const& f) {
    auto const off = signed_text(in_unit(f, "value") - in_unit(f, "expected"));
    return fmt::format("{}{} {} (to {} {})", f.number("count") > 1.0 ? "up to " : "", off, f.word("unit"),
                       number_text(in_unit(f, "value")), f.word("unit"));
  };
  double const count = group.size() == 1 ? first.number("count") : 2.0;
  auto const spikes = count == 1.0        ? std::string("a single-sample spike")
                      : group.size() == 1 ? fmt::format("{} single-sample spikes", count)
                                          : std::string("single-sample spikes");
  auto const where = group.size() == 1
                         ? fmt::format(" at {}: {}", places(first), size(first))
                         : ": " + each(group, [&](Finding const& f) { return size(f) + " at " + places(f); });
  return fmt::format(
      "the {} has {}{}. No properties are computed from such a record; --repair spikes replaces the samples by interpolation between their neighbours.",
      first.word("channel"), spikes, where);
}

std::string no_complete_cycle(Group group) {
  auto const& f = group.front();
  if (!f.has_number("least_mm")) return "there are no samples.";
  bool const at_zero = std::ranges::all_of(group, [](Finding const& each) { return each.number("centre_mm") == 0.0; });
  return fmt::format(
      "less than one complete cycle: displacement goes from {} to {} mm. A cycle needs 2 crossings of {} in the direction of the first motion, with a swing to each side between them; there are {}. Swings of less than {} mm count as noise.",
      range(group, "least_mm", 4), range(group, "largest_mm", 4),
      at_zero ? std::string("zero") : fmt::format("its centre at {} mm", range(group, "centre_mm", 4)),
      range(group, "crossings"), range(group, "noise_mm"));
}

std::string force_late(Group group) {
  auto const late = fmt::format("by_{}", group.front().word("unit"));
  return fmt::format(
      "{} after displacement{}. No device does that: a channel is late, and damping comes out about {} points too small (pi f dt).{}",
      reversal(group), without_jump(group), range(group, "damping_points", 2),
      group.front().word("unit") != "ms" ? std::string()
      : group.size() == 1                ? fmt::format(" --skew-ms {} corrects it.", range(group, late))
                                         : " --skew-ms corrects each device by its own time.");
}

std::string force_early(Group group) {
  return fmt::format(
      "{} before displacement{}: viscosity of the device, or an early channel{}. If it is the channel, damping comes out about {} points too large (pi f dt).",
      reversal(group), without_jump(group),
      without_jump(group).empty() ? ", or friction too small to be recognised" : "", range(group, "damping_points", 2));
}

std::string jump_of_force(Group group) {
  auto const friction = range(group, "friction_kN");
  return fmt::format(
      "force drops by {} kN at once where motion reverses, as friction of {} kN does. If that is the rig's friction, it adds {} points of damping; --rig-friction{} subtracts it.",
      range(group, "jump_kN"), friction, range(group, "damping_points", 2), group.size() == 1 ? " " + friction : "");
}

std::string largest_speed(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "the largest speed of a cycle is {}; a {} of this amplitude and frequency has {} mm/s ({} f D). {}.",
      each(group,
           [](Finding const& finding) {
             return fmt::format("{} mm/s in block {} (the median of its cycles), {} % off",
                                number_text(finding.number("v_max_mm_s")), finding.blocks.front(),
                                signed_text(finding.number("percent")));
           }),
      f.word("of"), range(group, "expected_mm_s", 4), f.word("of") == "triangle" ? "4" : "2 pi",
      f.word("waveform") == "other" ? "The motion is neither a sine nor a triangle" : "The motion has that form");
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
  return fmt::format("{} of {} repaired by interpolation: {}",
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

std::string all_samples_kept(Group group) {
  auto const& f = group.front();
  if (!f.word("option").empty()) return "all samples kept, as asked for";
  if (!f.has_number("wanted"))
    return "all samples kept: the record has no cycles, so samples per cycle are not defined";
  return fmt::format("all samples kept: {} per cycle is less than twice the {} asked for",
                     with_decimals(f.number("samples_per_cycle"), 1), f.number("wanted"));
}

}  // namespace isolaw::wording
