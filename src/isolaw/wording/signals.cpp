// What is said of the signals of records: faults that leave no cyclic properties, and what the measurement does to them.
// Where several devices have the same, magnitudes stand as a range; a sample, a time or a cycle stands with its device.
#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/number_text.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

constexpr char const* of_no_use =
    "Whatever is computed from such a signal is wrong: test again, or give a channel that was not disturbed.";

// A number that is named with the unit of its channel: "level_mm".
double in_unit(Finding const& finding, std::string_view name) {
  return finding.number(fmt::format("{}_{}", name, finding.word("unit")));
}
std::string signed_text(double value) {
  return (value < 0.0 ? "" : "+") + number_text(value, 3);
}
std::string percents(Group group, std::string_view name) {
  return range(group, name, [](double value) { return number_text(value, 2); }) + " %";
}
std::string cycle_of(Finding const& finding) {
  return fmt::format("cycle {} of block {}", finding.number("cycle"),
                     finding.blocks.empty() ? 0 : finding.blocks.front());
}

// "1.5 s (sample 151) and 4.2 s (sample 421)", or "sample 151 and sample 421" of a record without time.
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

// A channel that keeps a level: "at 95 mm for up to 12 samples from 3.2 s (sample 161)".
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
  return group.front().word("without_jump") == "yes" ? ", its jump there taken off" : "";
}

std::string per_cycle(Group group) {
  return fmt::format("{} samples per cycle: energy comes out {} too small, and a peak up to {}.",
                     range(group, "samples", [](double value) { return with_decimals(value, 1); }),
                     percents(group, "energy_percent"), percents(group, "peak_percent"));
}

std::string jump(Group group) {
  auto const friction = range(group, "friction_kN");
  return fmt::format(
      "force drops by {} kN at once where motion reverses, as friction of {} kN does. If that is the rig's friction, it adds {} points of damping; --rig-friction{} takes it off.",
      range(group, "jump_kN"), friction, range(group, "damping_points", 2), group.size() == 1 ? " " + friction : "");
}

std::string speed(Group group) {
  auto const& f = group.front();
  return fmt::format(
      "the largest speed is {}; a {} of this amplitude and frequency has {} mm/s ({} f D). {}.",
      each(group,
           [](Finding const& finding) {
             return fmt::format("{} mm/s in block {}, {} % off", number_text(finding.number("v_max_mm_s")),
                                finding.blocks.front(), signed_text(finding.number("percent")));
           }),
      f.word("of"), range(group, "expected_mm_s", 4), f.word("of") == "triangle" ? "4" : "2 pi",
      f.word("waveform") == "other" ? "The motion is neither a sine nor a triangle" : "The motion has that form");
}

std::string average(Group group) {
  return fmt::format(
      "the moving average over {} samples, of {} in a cycle, takes {} from the motion at the test's frequency and {} from its third harmonic. That concerns the laws; properties are computed from raw values.",
      range(group, "window_samples"), range(group, "samples_per_cycle"), percents(group, "percent"),
      percents(group, "third_harmonic_percent"));
}

}  // namespace

std::string no_cyclic_properties(Group group) {
  return fmt::format("no cyclic properties: {}", group.front().word("reason"));
}

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
    return fmt::format("{}{} {}, to {} {}", f.number("count") > 1.0 ? "up to " : "", off, f.word("unit"),
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
      "the {} has {}{}. Nothing is computed from it as it is; --repair spikes replaces such samples by what their neighbours say.",
      first.word("channel"), spikes, where);
}

std::string cycle_gives_energy(Group group) {
  return fmt::format("{}, and no device does that. Is a channel late, without its sign, or exchanged with the other?",
                     each(group, [](Finding const& f) {
                       return fmt::format("{} gives back {} kN mm of energy", cycle_of(f),
                                          number_text(f.number("energy_kN_mm")));
                     }));
}

std::string cycle_not_stiff(Group group) {
  return fmt::format(
      "{}, and no device does that. Does the force wrap around, or is it late, exchanged or of the other sign?",
      each(group, [](Finding const& f) {
        return fmt::format("{} has an effective stiffness of {} kN/mm", cycle_of(f),
                           number_text(f.number("K_eff_kN_per_mm")));
      }));
}

std::string not_cyclic(Group group) {
  return fmt::format(
      "the motion is not cyclic: {} of {} swings to and fro repeat an amplitude or are symmetric within 5 %, which is {} % of the travel; a cyclic test has {} % or more. Amplitudes go from {} to {} mm.",
      range(group, "regular_swings"), range(group, "swings"), range(group, "travel_percent", 2),
      range(group, "needed_percent"), range(group, "least_mm"), range(group, "largest_mm"));
}

std::string no_complete_cycle(Group group) {
  auto const& f = group.front();
  if (!f.has_number("least_mm")) return "there are no samples.";
  bool const at_zero = std::ranges::all_of(group, [](Finding const& each) { return each.number("centre_mm") == 0.0; });
  return fmt::format(
      "less than one complete cycle: displacement goes from {} to {} mm. A cycle takes 2 crossings of {} in the direction of the first motion, with a swing to each side between them; found: {}. Swings of less than {} mm count as noise.",
      range(group, "least_mm", 4), range(group, "largest_mm", 4),
      at_zero ? std::string("zero") : fmt::format("its centre at {} mm", range(group, "centre_mm", 4)),
      range(group, "crossings"), range(group, "noise_mm"));
}

std::string no_cycle_counts(Group) {
  return "no cycle counts: none has the amplitude and period of its block.";
}

std::string samples_too_few(Group group) {
  return fmt::format("{} samples per cycle, fewer than the {} that stiffness and energy need.",
                     range(group, "samples", [](double value) { return with_decimals(value, 1); }),
                     range(group, "needed"));
}

std::string cycle_unlike_neighbours(Group group) {
  return fmt::format(
      "the force at a peak is {} that of the cycles beside it. A channel may have dropped out or changed its range there, and the values of that cycle are wrong.",
      each(group, [](Finding const& f) {
        return fmt::format("in {} {} % of", cycle_of(f), number_text(f.number("percent"), 3));
      }));
}

std::string force_late(Group group) {
  auto const late = fmt::format("by_{}", group.front().word("unit"));
  return fmt::format(
      "{} after displacement{}. No device does that: a channel is late, and damping comes out about {} points too small (pi f dt).{}",
      reversal(group), without_jump(group), range(group, "damping_points", 2),
      group.front().word("unit") != "ms" ? std::string()
      : group.size() == 1                ? fmt::format(" --skew-ms {} moves the force back.", range(group, late))
                                         : " --skew-ms moves the force of each back by its own time.");
}

std::string force_early(Group group) {
  return fmt::format(
      "{} before displacement{}: viscosity of the device, or an early channel{}. If it is the channel, damping comes out about {} points too large (pi f dt).",
      reversal(group), without_jump(group),
      without_jump(group).empty() ? ", or friction too small to be told from it" : "",
      range(group, "damping_points", 2));
}

std::string friction_in_force(Group group) {
  return jump(group);
}
std::string jump_of_force(Group group) {
  return jump(group);
}

std::string samples_few(Group group) {
  return per_cycle(group) + fmt::format(" {} or more are wanted.", range(group, "wanted"));
}
std::string samples_per_cycle(Group group) {
  return per_cycle(group);
}

std::string time_uneven(Group group) {
  double least = group.front().number("least_s"), largest = group.front().number("largest_s");
  for (auto const& f : group) {
    least = std::min(least, f.number("least_s"));
    largest = std::max(largest, f.number("largest_s"));
  }
  return fmt::format("sampling is not uniform: intervals from {} to {} s, {} s on average.", number_text(least, 6),
                     number_text(largest, 6), range(group, "mean_s", 6));
}

std::string time_jumps(Group group) {
  auto const jump = [](Finding const& f) {
    auto const count = f.number("count");
    return fmt::format("{}{} s after sample {} ({} s), of which {} s are taken for the motion",
                       count == 1.0 ? "by " : fmt::format("{} times, most by ", count),
                       number_text(f.number("length_s")), f.number("sample"), number_text(f.number("time_s"), 6),
                       number_text(f.number("taken_s")));
  };
  return fmt::format(
      "time jumps {}. How long the motion took is estimated from its speed before and after; periods and frequency leave out the rest.",
      each(group, jump));
}

std::string noise(Group group) {
  return fmt::format(
      "noise of {} mm in displacement ({} of the amplitude) and of {} kN in force ({}). The extremes of a cycle lie about {} too far out and K_eff comes out at least as much too small; besides, K_eff of one cycle is uncertain by {} (one standard deviation).",
      range(group, "disp_mm", 2), percents(group, "disp_percent"), range(group, "force_kN", 2),
      percents(group, "force_percent"), percents(group, "beyond_percent"), percents(group, "scatter_percent"));
}

std::string drift(Group group) {
  auto const moved = [](Finding const& f) {
    return fmt::format("{} {} through block {}", number_text(in_unit(f, "drift"), 3), f.word("unit"), f.blocks.front());
  };
  return fmt::format("{} drifts: the middle of its cycles moves by {}, {} of the whole travel (limit {} %).",
                     group.front().word("channel"), each(group, moved), percents(group, "percent"),
                     range(group, "limit_percent"));
}

std::string loop_open(Group group) {
  return fmt::format("{}, {} of the whole travel (limit {} %). Energy may be wrong by the force times that, {} kN mm.",
                     each(group,
                          [](Finding const& f) {
                            return fmt::format("{} ends {} mm from where it starts", cycle_of(f),
                                               number_text(f.number("closure_mm"), 3));
                          }),
                     percents(group, "percent"), range(group, "limit_percent"), range(group, "energy_kN_mm"));
}

std::string speed_off(Group group) {
  return speed(group);
}
std::string largest_speed(Group group) {
  return speed(group);
}

std::string off_centre(Group group) {
  return fmt::format(
      "{} is off centre by {}, {} of its amplitude. Stiffness from peak to peak and energy do not feel that; F/d of one side and the laws do. `isolaw calibrate --center` takes it off.",
      group.front().word("channel"),
      each(group,
           [](Finding const& f) {
             return fmt::format("{} {} in {}", number_text(in_unit(f, "offset")), f.word("unit"), cycle_of(f));
           }),
      percents(group, "percent"));
}

std::string starts_off_zero(Group group) {
  return fmt::format("the first sample is at {} mm, {} of the half range of {} mm; laws start at rest at zero.",
                     range(group, "disp_mm", 4), percents(group, "percent"), range(group, "half_range_mm", 4));
}

std::string several_amplitudes(Group group) {
  double least = group.front().number("least_mm"), largest = group.front().number("largest_mm");
  for (auto const& f : group) {
    least = std::min(least, f.number("least_mm"));
    largest = std::max(largest, f.number("largest_mm"));
  }
  return fmt::format("cycles of several amplitudes, {} to {} mm: stiffness, energy and damping are those of {}.",
                     number_text(least), number_text(largest), each(group, [](Finding const& f) {
                       return fmt::format("{} at {} mm", cycle_of(f), number_text(f.number("amplitude_mm")));
                     }));
}

std::string damping_undefined(Group) {
  return "equivalent damping is not defined: it relates the loop's energy to an effective stiffness, and hardly any of this device's force is stiffness.";
}

std::string average_too_wide(Group group) {
  return average(group) + " A smaller --smooth takes less.";
}
std::string average_over_samples(Group group) {
  return average(group);
}

std::string rig_friction(Group group) {
  return fmt::format(
      "if the rig's friction were 0.5 % of the vertical load of {} kN, it would be {} kN and add {} points of damping (2 F_f / (pi K D)).",
      range(group, "load_kN", 4), range(group, "friction_kN"), range(group, "damping_points", 2));
}

std::string moving_mass(Group group) {
  return fmt::format(
      "each tonne that moves between the device and the load cell takes {} kN/mm from the stiffness at {} Hz, {} of it (m w^2).",
      range(group, "stiffness_kN_per_mm", 2), range(group, "frequency_Hz"), percents(group, "percent"));
}

std::string stands_still(Group group) {
  auto const rest = [](Finding const& f) {
    double const others = f.number("others");
    return fmt::format(
        "for {} s in {}, longer than its period{}", number_text(f.number("still_s"), 3), cycle_of(f),
        others > 0.0 ? fmt::format(", and so in {} more cycle{}", others, others == 1.0 ? "" : "s") : "");
  };
  return fmt::format(
      "the device stands still {}. Period, frequency and samples per cycle leave that out, but rubber recovers and cools meanwhile.",
      each(group, rest));
}

std::string cut_off_zero(Group group) {
  return fmt::format("cycles are cut where displacement passes {} mm, the centre of the motion.",
                     range(group, "centre_mm", 4));
}

}  // namespace isolaw::wording
