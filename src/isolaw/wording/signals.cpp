// Sentences about the signals of records: faults because of which no cyclic properties are computed, and effects of the
// measurement. A sentence about several devices gives magnitudes as a range, but names the device of each sample, time
// or cycle.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

constexpr std::string_view outside_text =
    "It lies outside the blocks: their cycles count, and no law is fitted to its samples.";

bool is_outside(Group group) {
  return !group.front().word("outside").empty();
}

// Says what a fault of the signal means for the results. If a single finding states the blocks in which the fault lies,
// the text adds that no cycle of these blocks counts.
std::string of_no_use(Group group) {
  if (is_outside(group)) return std::string(outside_text);
  auto const& blocks = group.front().blocks;
  std::string const taken =
      group.size() > 1 || blocks.empty()
          ? ""
          : fmt::format(" No cycle of block{} {} counts.", blocks.size() == 1 ? "" : "s", fmt::join(blocks, ", "));
  return "Whatever is computed from such a signal is wrong: test again, or give a channel that was not disturbed." +
         taken;
}

// The range of the numbers `name`, in the reader's units. `name` ends with the unit; the returned text has none.
std::string range_in(UnitSystem const& units, Group group, std::string_view name, int digits = 3) {
  auto const factor = shown_unit(unit_of_name(name), units).factor;
  return range(group, name, [&](double value) { return number_text(factor * value, digits); });
}

// Reads numbers whose names end with the unit of their channel ("level_mm"), in the reader's units.
struct Channel {
  Finding const& finding;
  ShownUnit shown;

  Channel(Finding const& of, UnitSystem const& units) : finding(of), shown(shown_unit(of.word("unit"), units)) {}
  double operator()(std::string_view name, std::string_view which = {}) const {
    return shown.factor * finding.number(fmt::format("{}_{}{}", name, finding.word("unit"), which));
  }
};

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
std::string standing(Group group, UnitSystem const& units, std::string_view how) {
  auto const& f = group.front();
  auto const stretch = [&](Finding const& finding) {
    Channel const channel(finding, units);
    return fmt::format("at {} {} for up to {} samples from {}", number_text(channel("level"), 5), channel.shown.unit,
                       finding.number("longest_samples"), places(finding));
  };
  return fmt::format("the {} is {} {}, while the {} goes on. {}", f.word("channel"), how, each(group, stretch),
                     f.word("channel") == "force" ? "motion" : "force", of_no_use(group));
}

std::string reversal(Group group, UnitSystem const& units) {
  auto const unit = group.front().word("unit");
  auto const shown = shown_unit(unit, units).unit;
  return fmt::format("force reverses {} {} (+- {} {}, {} reversals)",
                     range_in(units, group, fmt::format("by_{}", unit)), shown,
                     range_in(units, group, fmt::format("uncertainty_{}", unit), 2), shown, range(group, "reversals"));
}
std::string_view without_jump(Group group) {
  return group.front().word("without_jump") == "yes" ? ", after its jump is subtracted" : "";
}

}  // namespace

std::string signal_clipped(Group group, UnitSystem const& units) {
  return standing(group, units, "clipped");
}

std::string signal_stuck(Group group, UnitSystem const& units) {
  return standing(group, units, "stuck");
}

std::string signal_without_sign(Group group, UnitSystem const&) {
  bool const force = group.front().word("channel") == "force";
  return fmt::format("the {} is recorded without its sign: {} ({}). {}", group.front().word("channel"),
                     force ? "the device moves to both sides, but the force has one sign at all peaks"
                           : "it stays on one side of zero, but the force at its peaks has both signs",
                     each(group, places), of_no_use(group));
}

std::string signal_wraps(Group group, UnitSystem const& units) {
  auto const jump = [&](Finding const& f) {
    Channel const channel(f, units);
    return fmt::format("by {} {} in one sample, while the motion goes on, at {}", number_text(channel("jump"), 4),
                       channel.shown.unit, places(f));
  };
  return fmt::format("the {} wraps around at the end of its range: it jumps {}. {}", group.front().word("channel"),
                     each(group, jump), of_no_use(group));
}

std::string signal_interrupted(Group group, UnitSystem const& units) {
  auto const gap = [&](Finding const& f) {
    Channel const channel(f, units);
    return fmt::format("{} {} for {} samples between {} and {} {}, from {}", number_text(channel("level"), 5),
                       channel.shown.unit, f.number("longest_samples"), number_text(channel("before"), 5),
                       number_text(channel("after"), 5), channel.shown.unit, places(f));
  };
  return fmt::format("the {} drops out: {}. {}", group.front().word("channel"), each(group, gap), of_no_use(group));
}

std::string signal_spike(Group group, UnitSystem const& units) {
  auto const& first = group.front();
  auto const size = [&](Finding const& f) {
    Channel const channel(f, units);
    return fmt::format("{}{} {} (to {} {})", f.number("count") > 1.0 ? "up to " : "",
                       signed_text(channel("value") - channel("expected")), channel.shown.unit,
                       number_text(channel("value")), channel.shown.unit);
  };
  double const count = group.size() == 1 ? first.number("count") : 2.0;
  auto const spikes = count == 1.0        ? std::string("a single-sample spike")
                      : group.size() == 1 ? fmt::format("{} single-sample spikes", count)
                                          : std::string("single-sample spikes");
  auto const where = group.size() == 1
                         ? fmt::format(" at {}: {}", places(first), size(first))
                         : ": " + each(group, [&](Finding const& f) { return size(f) + " at " + places(f); });
  if (is_outside(group)) return fmt::format("the {} has {}{}. {}", first.word("channel"), spikes, where, outside_text);
  return fmt::format(
      "the {} has {}{}. No properties are computed from such a {}; --repair spikes replaces the samples by interpolation between their neighbours.",
      first.word("channel"), spikes, where,
      group.size() > 1 || first.blocks.empty()
          ? "record"
          : fmt::format("block, here block{} {}", first.blocks.size() == 1 ? "" : "s", fmt::join(first.blocks, ", ")));
}

std::string no_complete_cycle(Group group, UnitSystem const& units) {
  auto const& f = group.front();
  if (!f.has_number("least_mm")) return "there are no samples.";
  auto const length = units.length.symbol;
  bool const at_zero = std::ranges::all_of(group, [](Finding const& each) { return each.number("centre_mm") == 0.0; });
  return fmt::format(
      "less than one complete cycle: displacement goes from {} to {} {}. A cycle needs 2 crossings of {} in the direction of the first motion, with a swing to each side between them; there are {}. Swings of less than {} {} count as noise.",
      range_in(units, group, "least_mm", 4), range_in(units, group, "largest_mm", 4), length,
      at_zero ? std::string("zero")
              : fmt::format("its centre at {} {}", range_in(units, group, "centre_mm", 4), length),
      range(group, "crossings"), range_in(units, group, "noise_mm"), length);
}

std::string force_late(Group group, UnitSystem const& units) {
  auto const late = fmt::format("by_{}", group.front().word("unit"));
  return fmt::format(
      "{} after displacement{}. No device does that: a channel is late, and damping comes out about {} points too small (pi f dt).{}",
      reversal(group, units), without_jump(group), range(group, "damping_points", 2),
      group.front().word("unit") != "ms" ? std::string()
      : group.size() == 1                ? fmt::format(" --skew-ms {} corrects it.", range(group, late))
                                         : " --skew-ms corrects each device by its own time.");
}

std::string force_early(Group group, UnitSystem const& units) {
  return fmt::format(
      "{} before displacement{}: viscosity of the device, or an early channel{}. If it is the channel, damping comes out about {} points too large (pi f dt).",
      reversal(group, units), without_jump(group),
      without_jump(group).empty() ? ", or friction too small to be recognised" : "", range(group, "damping_points", 2));
}

std::string jump_of_force(Group group, UnitSystem const& units) {
  auto const force = units.force.symbol;
  return fmt::format(
      "force drops by {} {} at once where motion reverses, as friction of {} {} does. If that is the rig's friction, it adds {} points of damping; --rig-friction{} subtracts it.",
      range_in(units, group, "jump_kN"), force, range_in(units, group, "friction_kN"), force,
      range(group, "damping_points", 2), group.size() == 1 ? " " + range(group, "friction_kN") : "");
}

std::string largest_speed(Group group, UnitSystem const& units) {
  auto const& f = group.front();
  auto const speed = shown_unit("mm/s", units);
  return fmt::format(
      "the largest speed of a cycle is {}; a {} of this amplitude and frequency has {} {} ({} f D). {}.",
      each(group,
           [&](Finding const& finding) {
             return fmt::format("{} {} in block {} (the median of its cycles), {} % off",
                                number_text(speed.factor * finding.number("v_max_mm_s")), speed.unit,
                                finding.blocks.front(), signed_text(finding.number("percent")));
           }),
      f.word("of"), range_in(units, group, "expected_mm_s", 4), speed.unit, f.word("of") == "triangle" ? "4" : "2 pi",
      f.word("waveform") == "other" ? "The motion is neither a sine nor a triangle" : "The motion has that form");
}

std::string spikes_repaired(Group group, UnitSystem const& units) {
  auto const& f = group.front();
  Channel const of(f, units);
  auto const channel = f.word("channel");
  double const count = f.number("count");
  if (count == 0.0) return fmt::format("no spikes of {} to repair", channel);
  std::vector<std::string> samples;
  for (int k = 1; f.has_number(k == 1 ? "sample" : fmt::format("sample_{}", k)); ++k) {
    auto const which = k == 1 ? std::string() : fmt::format("_{}", k);
    samples.push_back(fmt::format(
        "sample {}{} from {} to {} {}", f.number("sample" + which),
        f.has_number("time_s" + which) ? fmt::format(" ({} s)", number_text(f.number("time_s" + which), 6)) : "",
        number_text(of("from", which), 5), number_text(of("to", which), 5), of.shown.unit));
  }
  auto const left = count - static_cast<double>(samples.size());
  if (left > 0.0) samples.push_back(fmt::format("and {} more", left));
  return fmt::format("{} of {} repaired by interpolation: {}",
                     count == 1.0 ? "a spike" : fmt::format("{} spikes", count), channel, joined(samples));
}

std::string skew_removed(Group group, UnitSystem const&) {
  auto const& f = group.front();
  bool const back = f.number("skew_ms") > 0.0;
  auto const dropped = f.number("dropped_samples");
  return fmt::format(
      "force moved {} by {} ms, between samples by interpolation; {} sample{} without a force dropped at the {}",
      back ? "back" : "forward", number_text(back ? f.number("skew_ms") : -f.number("skew_ms"), 6), dropped,
      dropped == 1.0 ? "" : "s", back ? "end" : "start");
}

std::string all_samples_kept(Group group, UnitSystem const&) {
  auto const& f = group.front();
  if (!f.word("option").empty()) return "all samples kept, as asked for";
  if (!f.has_number("wanted"))
    return "all samples kept: the record has no cycles, so samples per cycle are not defined";
  return fmt::format("all samples kept: {} per cycle is less than twice the {} asked for",
                     with_decimals(f.number("samples_per_cycle"), 1), f.number("wanted"));
}

}  // namespace isolaw::wording
