#include "isolaw/study/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/analysis_findings.hpp"
#include "isolaw/study/energy_fall.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

Warning of_devices(std::string topic, Names devices, std::string remark) {
  auto sentence = fmt::format("{}: {}", enumerate(devices), remark);
  return {std::move(topic), std::move(sentence), std::move(devices), std::move(remark)};
}

void warn_of_missing_runs(Summary const& summary, std::vector<Warning>& warnings) {
  if (summary.missing_runs() > 0)
    warnings.push_back(
        {"not complete",
         fmt::format("not complete: {}{} of {} runs are there; every number and the choice of a law may still change",
                     summary.part ? fmt::format("part {} alone of {}: ", summary.part->number, summary.part->of) : "",
                     summary.runs, summary.expected_runs)});
  else if (summary.missing_analyses() > 0)
    warnings.push_back({"not complete", fmt::format("not complete: {} of {} analyses are there", summary.analyses,
                                                    summary.expected_analyses)});
}

// A record under two names counts twice, and makes parameters look less scattered than they are. Those that a device of
// `part` is among.
void warn_of_copies(Summary const& summary, Summary const& part, std::vector<Warning>& warnings) {
  for (auto const& group : devices_of_one_record(summary)) {
    Names names;
    for (auto const* device : group) names.push_back(device->name);
    if (std::ranges::none_of(part.devices,
                             [&](auto const& device) { return std::ranges::find(names, device.name) != names.end(); }))
      continue;
    warnings.push_back(
        {"copies", fmt::format("{} hold the same record{}", enumerate(names),
                               group.front()->raw.size() == 0
                                   ? std::string()
                                   : fmt::format(", which counts {} times in every mean and spread over the devices",
                                                 group.size()))});
  }
}

// Devices that hold the same compression test, by two or more.
std::vector<std::vector<DeviceResult const*>> devices_of_one_compression(Summary const& summary) {
  std::vector<std::vector<DeviceResult const*>> groups;
  for (auto const& device : summary.devices) {
    auto const& test = device.vertical_test;
    if (test.load_kN.empty()) continue;
    auto const same = [&](auto const& group) {
      auto const& other = group.front()->vertical_test;
      return other.load_kN == test.load_kN && other.disp_mm == test.disp_mm;
    };
    auto found = std::ranges::find_if(groups, same);
    if (found == groups.end()) found = groups.insert(groups.end(), {{}});
    found->push_back(&device);
  }
  std::erase_if(groups, [](auto const& group) { return group.size() < 2; });
  return groups;
}

// One compression test cannot be that of two devices.
void warn_of_vertical_copies(Summary const& summary, Summary const& part, std::vector<Warning>& warnings) {
  for (auto const& group : devices_of_one_compression(summary)) {
    bool const concerned = std::ranges::any_of(group, [&](auto const* device) {
      return std::ranges::find(part.devices, device->name, &DeviceResult::name) != part.devices.end();
    });
    if (!concerned) continue;
    Names names;
    for (auto const* device : group) names.push_back(device->name);
    warnings.push_back({"copies", fmt::format("{} hold the same compression test, whose K_v counts {} times",
                                              enumerate(names), group.size())});
  }
}

void warn_of_devices(Summary const& summary, std::vector<Warning>& warnings) {
  for (auto const& device : summary.devices)
    if (device.status != "ok")
      warnings.push_back({"refused", fmt::format("{} was refused: {}", device.name, on_one_line(device.message))});
}

// What is done already is no advice.
bool is_given(Summary const& summary, std::string_view setting) {
  auto const found = std::ranges::find(summary.settings, setting, &Setting::key);
  return found != summary.settings.end() && found->json != "\"all\"" && found->json != "\"\"";
}

// A device that loses energy from cycle to cycle while no law does: the laws hold for a mean of its cycles. Of a law
// alone that is said whatever others do.
void warn_of_degradation(Summary const& summary, std::vector<Warning>& warnings) {
  for (auto const& device : summary.devices) {
    EnergyFall const* nearest = nullptr;
    LawResult const* of = nullptr;
    bool followed = false;
    for (auto const& law : summary.laws) {
      auto const* fit = fit_of(law, device.name);
      if (fit == nullptr || !fit->energy_fall) continue;
      followed = followed || follows(*fit->energy_fall);
      if (nearest != nullptr && fit->energy_fall->percent <= nearest->percent) continue;
      nearest = &*fit->energy_fall;
      of = &law;
    }
    if (nearest == nullptr || followed) continue;
    auto const own = percent(std::max(0.0, nearest->percent) / 100.0);
    auto const who =
        summary.laws.size() == 1
            ? fmt::format("{} does not follow this degradation over cycles (its own falls by {}): it is right", of->id,
                          own)
            : fmt::format("no law follows this degradation over cycles ({} comes nearest, with {}): each is right",
                          of->id, own);
    warnings.push_back(of_devices(
        "degradation", {device.name},
        fmt::format("the energy of a cycle falls by {} from cycle {} to {} of block {}, and {} for "
                    "some cycles in between{}",
                    percent(nearest->measured_percent / 100.0), nearest->first_cycle, nearest->last_cycle,
                    nearest->block, who,
                    is_given(summary, "fit-cycles") ? "" : "; --fit-cycles fits to the first or to the last ones")));
  }
}

void warn_of_refused_laws(LawResult const& law, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, Names>> reasons;  // in order of first appearance
  for (auto const& fit : law.devices)
    if (!fit.refusal.empty()) beside(reasons, fit.refusal).push_back(fit.device);
  for (auto const& [reason, devices] : reasons) {
    auto text = fmt::format("{} was not identified on {}: {}", called(law), enumerate(devices), on_one_line(reason));
    if (law.objective.mean) text += fmt::format("; its mean and beta cover the other devices only");
    warnings.push_back({"law not identified", std::move(text)});
  }
}

void warn_of_failed_runs(LawResult const& law, std::vector<Warning>& warnings) {
  int failed = 0, runs = 0;
  std::string first;
  for (auto const& fit : law.devices) {
    runs += fit.runs;
    failed += fit.failed_runs;
    if (first.empty() && fit.failed_runs > 0) first = fmt::format("{}: {}", fit.device, fit.failure);
  }
  if (failed > 0)
    warnings.push_back(
        {"failed runs", fmt::format("{}: {} of {} runs failed, the first on {}", called(law), failed, runs, first)});
}

// What an optimiser tried in vain is no fault of the result, but it belongs to how the result was found.
void warn_of_failed_evaluations(LawResult const& law, std::vector<Warning>& warnings) {
  std::uint64_t failed = 0, evaluations = 0;
  for (auto const& fit : law.devices) {
    evaluations += fit.evaluations;
    failed += fit.failed_evaluations;
  }
  if (failed > 0)
    warnings.push_back(
        {"failed evaluations",
         fmt::format("{}: {} of {} parameter sets tried ({}) gave no finite force and were passed over", called(law),
                     failed, evaluations, percent(static_cast<double>(failed) / static_cast<double>(evaluations)))});
}

void warn_of_bounds(LawResult const& law, std::vector<Warning>& warnings) {
  std::size_t fitted = 0;
  std::vector<std::pair<std::pair<std::string, std::string>, Names>> at_bound;  // (parameter, side) and its devices
  for (auto const& fit : law.devices) {
    if (fit_status(fit) == "ok") ++fitted;
    for (auto const& parameter : fit.parameters)
      if (!parameter.at_bound.empty())
        beside(at_bound, std::pair(parameter.name, parameter.at_bound)).push_back(fit.device);
  }
  if (law.lot && !law.lot->at_bound.empty())
    warnings.push_back(
        {"at bound", fmt::format("{}: of the one law for all {}", called(law), enumerate(law.lot->at_bound, 6))});
  if (at_bound.empty()) return;
  Names parts;
  for (auto const& [edge, devices] : at_bound) {
    auto const where = devices.size() == fitted && fitted > 1 ? fmt::format("all {} devices", fitted)
                       : devices.size() > 3                   ? fmt::format("{} of {} devices", devices.size(), fitted)
                                                              : enumerate(devices);
    parts.push_back(fmt::format("{} at its {} bound on {}", edge.first, edge.second, where));
  }
  constexpr std::size_t most = 6;
  if (auto const more = parts.size(); more > most) {
    parts.resize(most);
    parts.push_back(fmt::format("and {} more", more - most));
  }
  warnings.push_back({"at bound", fmt::format("{}: {}", called(law), fmt::join(parts, "; "))});
}

void warn_of_adequacy(LawResult const& law, std::vector<Warning>& warnings) {
  if (auto const why = inadequacy(law); !why.empty())
    warnings.push_back({"not adequate", fmt::format("{} does not describe the devices: it {}", called(law), why)});
}

void warn_of_held(LawResult const& law, std::vector<Warning>& warnings) {
  if (auto const held = pinned(law); held.decides())
    warnings.push_back(
        {"at bound", fmt::format("{}: {}, so that its beta is no robustness", called(law), held.text())});
}

void warn_of_integration(LawResult const& law, std::vector<Warning>& warnings) {
  Names devices;
  double largest = 0.0;
  for (auto const& fit : law.devices) {
    if (std::abs(fit.integration_shift.value_or(0.0)) <= large_integration_shift) continue;
    devices.push_back(fit.device);
    largest = std::max(largest, std::abs(*fit.integration_shift));
  }
  if (!devices.empty())
    warnings.push_back(
        {"integration",
         std::isfinite(largest)
             ? fmt::format("{}: a finer integration step would move the objective by up to {:.2g} on {}", called(law),
                           largest, enumerate(devices))
             : fmt::format(
                   "{}: its force is not finite in finer integration steps on {}: the result is of the steps, not of the law",
                   called(law), enumerate(devices))});
}

// What several records have in common is said once.
void warn_of_records(Summary const& summary, std::vector<Warning>& warnings) {
  std::vector<Finding> all;
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    auto found = device.raw.warnings;
    // Reading the record may have found already why it has no cyclic properties.
    for (auto const& reason : device.properties.refusal)
      if (std::ranges::find(found, reason) == found.end()) found.push_back(reason);
    for (auto& finding : found) {
      finding.devices = {device.name};
      all.push_back(std::move(finding));
    }
  }
  for (auto const& group : wording::grouped(all)) warnings.push_back({"record", wording::sentence(group)});
}

// A text cut at its numbers: what stands between them, and they.
struct Cut {
  std::vector<std::string> between;  // one more than numbers
  std::vector<std::string> numbers;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Digits with a sign or a point; not those of a name or of an option's value ("--skew-ms 4" has one, "F2" none).
Cut cut_at_numbers(std::string const& text) {
  Cut made{.between = {""}, .numbers = {}};
  for (std::size_t i = 0; i < text.size();) {
    bool const in_word = i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
    bool const is_signed = (text[i] == '-' || text[i] == '+') && (i == 0 || text[i - 1] == ' ');
    std::size_t const first = i + (is_signed ? 1 : 0);
    if (in_word || first >= text.size() || !is_digit(text[first])) {
      made.between.back() += text[i++];
      continue;
    }
    std::size_t end = first;
    auto const digits = [&] {
      while (end < text.size() && is_digit(text[end])) ++end;
    };
    digits();
    if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) ++end, digits();
    if (end + 2 < text.size() && text[end] == 'e' && (text[end + 1] == '-' || text[end + 1] == '+') &&
        is_digit(text[end + 2]))
      end += 2, digits();
    made.numbers.push_back(text.substr(i, end - i));
    made.between.emplace_back();
    i = end;
  }
  return made;
}

// The least and the largest as they were written, where they differ.
std::string span_of(std::vector<std::string> const& numbers) {
  auto const value = [](std::string const& text) { return number_in<double>(text).value_or(0.0); };
  auto const [least, largest] = std::ranges::minmax(numbers, {}, value);
  return value(least) == value(largest) ? least : fmt::format("{} to {}", least, largest);
}

std::string merged(std::vector<Cut> const& cuts) {
  std::string text = cuts.front().between.front();
  for (std::size_t k = 0; k < cuts.front().numbers.size(); ++k) {
    std::vector<std::string> numbers;
    for (auto const& cut : cuts) numbers.push_back(cut.numbers[k]);
    text += span_of(numbers) + cuts.front().between[k + 1];
  }
  return text;
}

}  // namespace

std::string_view action(Warning const& warning) {
  struct Row {
    std::string_view topic, action;
  };
  static constexpr std::string_view records = "Look at the records", laws = "Do not lean on these laws",
                                    search = "Search longer or in finer steps",
                                    parameters = "Fix parameters, widen their boxes, or test more";
  static constexpr Row rows[]{{"not complete", "Continue the campaign"},
                              {"refused", records},
                              {"copies", records},
                              {"degradation", records},
                              {"record", records},
                              {"outlier", records},
                              {"law not identified", laws},
                              {"not adequate", laws},
                              {"prediction", laws},
                              {"not predicted", "Keep blocks of the tests from the fit"},
                              {"failed runs", search},
                              {"failed evaluations", search},
                              {"search", search},
                              {"integration", search},
                              {"undetermined", parameters},
                              {"at bound", parameters}};
  auto const found = std::ranges::find(rows, warning.topic, &Row::topic);
  return found == std::end(rows) ? "Take care" : found->action;
}

std::vector<Warning> warnings(Summary const& whole, Summary const& summary) {
  std::vector<Warning> all;
  warn_of_missing_runs(summary, all);
  warn_of_devices(summary, all);
  warn_of_copies(whole, summary, all);
  warn_of_vertical_copies(whole, summary, all);
  warn_of_degradation(summary, all);
  for (auto const warn : {warn_of_refused_laws, warn_of_failed_runs, warn_of_failed_evaluations})
    for (auto const& law : summary.laws) warn(law, all);
  for (auto const& law : whole.laws)
    if (std::ranges::find(summary.laws, law.id, &LawResult::id) != summary.laws.end()) warn_of_adequacy(law, all);
  for (auto const& law : summary.laws) warn_of_held(law, all);
  warn_of_analysis(summary, all);
  for (auto const warn : {warn_of_bounds, warn_of_integration})
    for (auto const& law : summary.laws) warn(law, all);
  warn_of_records(summary, all);
  return all;
}

std::vector<std::vector<std::string>> device_warnings(Summary const& summary) {
  std::vector<Names> all;
  for (auto const& device : summary.devices) all.push_back(wording::remarks(device.raw.warnings));
  auto const add = [&](auto const& groups, auto say) {
    for (auto const& group : groups)
      for (auto const* device : group) {
        Names others;
        for (auto const* other : group)
          if (other != device) others.push_back(other->name);
        all[static_cast<std::size_t>(device - summary.devices.data())].push_back(say(enumerate(others)));
      }
  };
  add(devices_of_one_record(summary), rules::same_record_as);
  add(devices_of_one_compression(summary),
      [](std::string const& others) { return "the same compression test as " + others; });
  return all;
}

std::vector<Warning> in_few_lines(std::vector<Warning> const& warnings) {
  struct Kind {
    std::string topic;
    std::vector<Cut> cuts;
    std::size_t place = 0;  // of its line
  };
  std::vector<Kind> kinds;
  std::vector<Warning> lines;
  for (auto const& warning : warnings) {
    auto const cut = cut_at_numbers(warning.remark);
    auto const same = std::ranges::find_if(kinds, [&](Kind const& kind) {
      return kind.topic == warning.topic && kind.cuts.front().between == cut.between;
    });
    if (warning.devices.empty() || same == kinds.end()) {
      if (!warning.devices.empty()) kinds.push_back({warning.topic, {cut}, lines.size()});
      lines.push_back(warning);
      continue;
    }
    same->cuts.push_back(cut);
    auto& line = lines[same->place];
    for (auto const& name : warning.devices)
      if (std::ranges::find(line.devices, name) == line.devices.end()) line.devices.push_back(name);
    line.remark = merged(same->cuts);
    line.sentence = fmt::format("{}: {}", enumerate(line.devices, 3), line.remark);
  }
  return lines;
}

std::vector<Warning> warnings(Summary const& summary) {
  return warnings(summary, summary);
}

}  // namespace isolaw::study
