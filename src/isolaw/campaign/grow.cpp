#include "isolaw/campaign/grow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

bool among(std::vector<std::string> const& laws, std::string_view law) {
  return std::ranges::find(laws, law) != laws.end();
}

std::vector<std::string> overrides_of(std::vector<fit::Override> const& overrides,
                                      std::vector<std::string> const& laws) {
  std::vector<std::string> texts;
  for (auto const& override : overrides)
    if (among(laws, override.law)) texts.push_back(override.text());
  return texts;
}

// Returns `settings`, with the values of `asked` for settings in which a campaign may grow: laws, runs, analyses.
Settings grown(Settings settings, Settings const& asked) {
  if (asked.analysis) settings.analysis = true;
  if (asked.springs) settings.springs = true;
  if (overrides_of(settings.overrides, settings.laws) == overrides_of(asked.overrides, settings.laws))
    settings.overrides = asked.overrides;
  if (std::ranges::all_of(settings.laws, [&](auto const& law) { return among(asked.laws, law); }))
    settings.laws = asked.laws;
  settings.runs = std::max(settings.runs, asked.runs);
  return settings;
}

std::optional<std::size_t> place_of(Contents const& contents, std::string_view device) {
  auto const found = std::ranges::find(contents.devices, device, &Device::name);
  if (found == contents.devices.end()) return std::nullopt;
  return static_cast<std::size_t>(found - contents.devices.begin());
}

bool same_record(Device const& there, Device const& now) {
  // The hash alone is not enough. Several files that are joined to one history have the same hash as the same files
  // read as several tests, and only `starts` differs.
  return there.raw.sha256 == now.raw.sha256 && there.raw.starts == now.raw.starts && there.refusal == now.refusal;
}

// Says why a device's stored results cannot be used. A device that was refused has no results, so a change of its file
// is no obstacle.
std::string obstacle(Device const& there, Device const& now) {
  if (!there.usable()) return {};
  if (!now.usable()) return fmt::format("{}: refused now: {}", now.name, now.refusal);
  auto const names_of = [](Device const& device) {
    std::vector<std::string> names;
    for (auto const& test : device.raw.tests) names.push_back(test.name);
    return names;
  };
  if (names_of(there) != names_of(now))
    return fmt::format("{}: it has other tests, or its tests are in another order", now.name);
  if (!same_record(there, now)) return fmt::format("{}: its file has changed", now.name);
  bool const same = there.raw.disp_mm == now.raw.disp_mm && there.raw.force_kN == now.raw.force_kN &&
                    there.raw.time_s == now.raw.time_s && there.raw.load_kN == now.raw.load_kN &&
                    there.raw.logged_cycle == now.raw.logged_cycle &&
                    there.raw.counts_half_cycles() == now.raw.counts_half_cycles();
  return same ? "" : fmt::format("{}: its file is read in another way", now.name);
}

bool same_devices(Contents const& a, Contents const& b) {
  return std::ranges::equal(a.devices, b.devices, [](Device const& there, Device const& now) {
    return there.name == now.name && same_record(there, now);
  });
}

}  // namespace

std::vector<std::string> obstacles(Contents const& stored, Contents const& asked, Sides const& sides) {
  auto found = differences(grown(stored.settings, asked.settings), asked.settings, sides);
  if (stored.part != asked.part) {
    auto const named = [](std::optional<Part> const& part) { return part ? "part " + text(*part) : "all of it"; };
    found.push_back(fmt::format("{} {}, {} {}", named(stored.part), sides.one, named(asked.part), sides.other));
  }
  std::vector<std::string> gone;
  for (auto const& device : stored.devices) {
    auto const place = place_of(asked, device.name);
    if (!place)
      gone.push_back("'" + device.name + "'");
    else if (auto reason = obstacle(device, asked.devices[*place]); !reason.empty())
      found.push_back(std::move(reason));
  }
  constexpr std::size_t most = 5;
  auto const more = gone.size() > most ? gone.size() - most : 0;
  if (more > 0) gone.resize(most);
  if (!gone.empty())
    found.push_back(fmt::format("{} and not {}: {}{}", sides.one, sides.other, joined(gone),
                                more > 0 ? fmt::format(" and {} more", more) : ""));
  return found;
}

std::vector<std::string> growth(Contents const& stored, Contents const& asked) {
  std::vector<std::string> added;
  if (auto const more = asked.devices.size() - stored.devices.size(); more > 0)
    added.push_back(fmt::format("{} device{}", more, more == 1 ? "" : "s"));
  std::vector<std::string> mended, refused;  // devices whose file or refusal changed; all were refused before
  for (auto const& device : stored.devices)
    if (auto const& now = asked.devices[*place_of(asked, device.name)]; !same_record(device, now))
      (now.usable() ? mended : refused).push_back("'" + device.name + "'");
  if (!mended.empty()) added.push_back(joined(mended) + ", refused before");
  if (!refused.empty()) added.push_back(joined(refused) + ", still refused, with another file or reason");
  if (added.empty() && !same_devices(stored, asked)) added.emplace_back("another order of the devices");
  std::vector<std::string> laws;
  for (auto const& law : asked.settings.laws)
    if (!among(stored.settings.laws, law)) laws.push_back(law);
  if (!laws.empty()) added.push_back((laws.size() == 1 ? "law " : "laws ") + joined(laws));
  if (asked.settings.runs > stored.settings.runs)
    added.push_back(fmt::format("{} runs instead of {}", asked.settings.runs, stored.settings.runs));
  if (asked.settings.springs && !stored.settings.springs) added.emplace_back("laws fitted as springs");
  if (added.empty() && asked.settings.laws != stored.settings.laws) added.emplace_back("another order of the laws");
  return added;
}

void take_over(Contents stored, Contents& asked) {
  std::vector<std::size_t> places;
  for (auto const& device : stored.devices) places.push_back(*place_of(asked, device.name));
  auto const moved = [&](auto items) {
    for (auto& item : items) item.device = places[item.device];
    std::ranges::stable_sort(items, {}, by_device_and_law);
    return items;
  };
  bool const same_runs = stored.settings.runs == asked.settings.runs, same_lot = same_devices(stored, asked);
  asked.runs = moved(std::move(stored.runs));
  asked.makers = std::move(stored.makers);
  auto devices = moved(std::move(stored.device_analyses));
  if (asked.settings.springs && !stored.settings.springs) devices.clear();  // makes all of them again, with springs
  if (!same_lot || devices.empty()) {
    stored.lot_analyses.clear();
    stored.left_out.clear();
  }
  if (same_runs) {
    asked.device_analyses = std::move(devices);
    asked.lot_analyses = std::move(stored.lot_analyses);
    asked.left_out = std::move(stored.left_out);
  } else {
    asked.held_over = {.runs = stored.settings.runs,
                       .devices = std::move(devices),
                       .lots = std::move(stored.lot_analyses),
                       .left_out = std::move(stored.left_out)};
  }
}

}  // namespace isolaw::campaign
