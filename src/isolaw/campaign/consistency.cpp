#include "isolaw/campaign/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"

namespace isolaw::campaign {
namespace {

[[noreturn]] void fail(std::string found) {
  throw Error({.found = std::move(found)});
}

bool all_finite(std::vector<double> const& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void require_device(Device const& d) {
  auto const same = [&](auto const& channel, std::size_t size) { return channel.empty() || channel.size() == size; };
  auto const& raw = d.raw;
  auto const& fit = d.record;
  bool const fits = same(raw.time_s, raw.size()) && raw.force_kN.size() == raw.size() &&
                    same(raw.load_kN, raw.size()) && same(raw.logged_cycle, raw.size()) &&
                    fit.time_s.size() == fit.size() && same(fit.vel_mm_s, fit.size()) &&
                    fit.force_kN.size() == fit.size() && same(fit.scored, fit.size()) &&
                    same(fit.weights, fit.size()) && same(fit.block, fit.size());
  auto const& vertical = d.vertical;
  if (vertical.load_kN.size() != vertical.disp_mm.size() || !all_finite(vertical.load_kN) ||
      !all_finite(vertical.disp_mm) || (vertical.stated_kN_per_mm && !(*vertical.stated_kN_per_mm > 0.0)))
    fail(fmt::format(
        "the vertical test of device '{}' has channels of different lengths, or values that are not finite", d.name));
  if (!fits) fail(fmt::format("the channels of device '{}' differ in length", d.name));
  if (!std::ranges::all_of(fit.scored, [](double value) { return value == 0.0 || value == 1.0; }))
    fail(fmt::format("what is scored of device '{}' is neither 0 nor 1", d.name));
  if (!std::ranges::all_of(fit.weights, [](double value) { return std::isfinite(value) && value >= 0.0; }))
    fail(fmt::format("the weights of the samples of device '{}' are no weights", d.name));
  auto const begin_in = [](std::vector<std::size_t> const& starts, std::size_t samples) {
    return starts.empty() ||
           (starts.front() == 0 && starts.back() < samples && std::ranges::is_sorted(starts, std::less_equal<>{}));
  };
  if (raw.starts.size() != raw.tests.size() || fit.starts.size() != raw.starts.size() ||
      !begin_in(raw.starts, raw.size()) || !begin_in(fit.starts, fit.size()))
    fail(fmt::format("the tests of device '{}' do not lie within its record", d.name));
  if (d.usable() && fit.size() == 0) fail(fmt::format("device '{}' has no record", d.name));
}

void require_search(Contents const& campaign, Search const& s) {
  auto const law =
      std::ranges::find(laws::catalogue(), std::string_view(s.law), [](auto const& l) { return l.info.id; });
  if (law == laws::catalogue().end()) fail(fmt::format("law '{}' is not known", s.law));
  if (!s.refusal.empty()) return;
  auto const& device = campaign.devices.at(s.device);
  if (!device.usable()) fail(fmt::format("{} was searched on '{}', which was refused", s.law, device.name));
  double counted = 0.0;
  for (std::size_t i = 0; i < device.record.weights.size(); ++i)
    if (device.record.is_scored(i)) counted += device.record.weights[i];
  if (!device.record.weights.empty() && !(counted > 0.0 && std::isfinite(counted)))
    fail(fmt::format("{} was searched on '{}', of which no sample counts by its weights", s.law, device.name));
  auto const& box = s.first_box.parameters;
  if (box.size() != law->parameters.size())
    fail(fmt::format("the box of {} has {} parameters instead of {}", s.law, box.size(), law->parameters.size()));
  for (std::size_t i = 0; i < box.size(); ++i) {
    auto const& p = box[i];
    if (p.name != law->parameters[i].name) fail(fmt::format("parameter {} of {} is called '{}'", i + 1, s.law, p.name));
    if (p.tied_to && (p.free || *p.tied_to >= box.size()))
      fail(fmt::format("parameter {} of {} is tied to none", p.name, s.law));
    if (!std::isfinite(p.free ? p.lower + p.upper : p.value))
      fail(fmt::format("the box of {} of {} is not finite", p.name, s.law));
  }
}

// Checks length and characters of the texts that identify a build, because isolaw prints them and writes them into
// input files of other programs.
void require_words(Maker const& maker) {
  constexpr std::size_t longest = 64;
  for (auto const& word : {maker.version, maker.build, maker.instruction_set})
    if (word.size() > longest || !is_printable(word)) fail("the isolaw that made it has no name that can be printed");
}

void require_maker(Contents const& campaign, std::size_t maker) {
  if (maker >= std::max<std::size_t>(1, campaign.makers.size())) fail(fmt::format("maker {}, who is not there", maker));
}

void require_refinement(int refinement) {
  if (refinement < 1 || refinement > finest_refinement) fail(fmt::format("{} steps per sample", refinement));
}

Search const* search_of(Contents const& campaign, std::size_t device, std::string_view law) {  // nullptr: not searched
  auto const [first, last] = std::ranges::equal_range(campaign.searches, device, {}, &Search::device);
  auto const found = std::find_if(first, last, [&](Search const& s) { return s.law == law && s.refusal.empty(); });
  return found == last ? nullptr : &*found;
}

Search const& searched(Contents const& campaign, std::size_t device, std::string const& law) {
  auto const* found = search_of(campaign, device, law);
  if (found == nullptr) fail(fmt::format("an analysis of {} on device {}, which was not searched", law, device));
  return *found;
}

void require_values(std::vector<double> const& parameters, Search const& search) {
  if (parameters.size() != search.box.parameters.size() || !all_finite(parameters))
    fail(fmt::format("an analysis of {} without its parameters", search.law));
}

}  // namespace

void require_consistent(Contents const& campaign, Run const& r) {
  auto const* search = search_of(campaign, r.device, r.law);
  if (search == nullptr) fail(fmt::format("a run of {} on device {}, which was not searched", r.law, r.device));
  if (r.number < 1 || r.number > campaign.settings.runs)
    fail(fmt::format("run {} of {}, of {} asked for", r.number, r.law, campaign.settings.runs));
  require_refinement(r.refinement);
  require_maker(campaign, r.maker);
  if (r.usable() && r.parameters.size() != search->box.parameters.size())
    fail(fmt::format("run {} of {} has {} parameters", r.number, r.law, r.parameters.size()));
  if (!r.box.empty() && r.box.size() != 2 * search->first_box.parameters.size())
    fail(fmt::format("run {} of {} has a box that does not fit its parameters", r.number, r.law));
  if (!all_finite(r.parameters)) fail(fmt::format("run {} of {} has a parameter that is not finite", r.number, r.law));
  if (r.usable() != r.failure.empty() || r.usable() != std::isfinite(r.objective))
    fail(fmt::format("run {} of {} is neither a result nor a failure", r.number, r.law));
}

void require_consistent(Contents const& campaign, DeviceAnalysis const& a) {
  auto const& search = searched(campaign, a.device, a.law);
  require_refinement(a.refinement);
  require_maker(campaign, a.maker);
  require_values(a.determination.optimum, search);
  if (a.springs) require_values(a.springs->parameters, search);
  if (a.larger_swings) require_values(a.larger_swings->parameters, search);
  auto const free = search.box.free_count();
  auto const is_free = [&](std::size_t i) { return i < search.box.parameters.size() && search.box.parameters[i].free; };
  auto const names = [&](auto const& items) {
    return items.size() == free && std::ranges::all_of(items, [&](auto const& p) { return is_free(p.parameter); });
  };
  bool fits = names(a.determination.parameters) && names(a.intervals.parameters) &&
              a.intervals.covariance.size() == free * free;
  for (auto const& p : a.determination.parameters) fits = fits && p.profile.value.size() == p.profile.objective.size();
  for (auto const& t : a.determination.trade_offs)
    fits = fits && t.change.size() == t.parameters.size() && std::ranges::all_of(t.parameters, is_free);
  if (!fits) fail(fmt::format("an analysis of {} that does not fit its parameters", a.law));
}

void require_consistent(Contents const& campaign, LotAnalysis const& a) {
  require_refinement(a.refinement);
  require_maker(campaign, a.maker);
  for (auto const device : a.devices) {
    auto const& search = searched(campaign, device, a.law);
    if (a.mean.parameters.empty()) continue;
    require_values(a.mean.parameters, search);
    require_values(a.worst.law.parameters, search);
    if (a.springs) require_values(a.springs->parameters, search);
  }
  if (!a.mean.parameters.empty() &&
      (a.mean.objectives.size() != a.devices.size() || a.worst.law.objectives.size() != a.devices.size()))
    fail(fmt::format("the law of the lot, {}, is not judged by every device", a.law));
}

void require_consistent(Contents const& campaign, LeftOutAnalysis const& a) {
  auto const& search = searched(campaign, a.device, a.law);
  require_maker(campaign, a.maker);
  if (!a.left_out.parameters.empty()) require_values(a.left_out.parameters, search);
}

void require_consistent(Contents const& contents) {
  for (auto const& maker : contents.makers) require_words(maker);
  for (auto const& device : contents.devices) require_device(device);
  for (auto const& search : contents.searches) require_search(contents, search);
  auto const require_all = [&](auto const& items) {
    for (auto const& item : items) require_consistent(contents, item);
  };
  require_all(contents.runs);
  require_all(contents.device_analyses);
  require_all(contents.lot_analyses);
  require_all(contents.left_out);
  for (auto const& lot : contents.lot_analyses)
    for (auto const device : lot.devices)
      if (contents.analysis_of(device, lot.law) == nullptr)
        fail(fmt::format("an analysis of {} on the lot, but none on device '{}'", lot.law,
                         contents.devices[device].name));
}

}  // namespace isolaw::campaign
