#include "isolaw/conditions/dependence.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "isolaw/conditions/history_effects.hpp"

namespace isolaw::conditions {
namespace {

DeviceDependence judged(rules::DependenceLimit const& limit, bool verified, bool as_asked, Factor const& ratio) {
  DeviceDependence result;
  if (ratio.status != Status::not_covered) result.ratio = ratio;
  switch (ratio.status) {
    case Status::shown:
    case Status::interpolated:
      break;
    case Status::extrapolated:
      result.reason = NotAssessed::extrapolated;
      return result;
    case Status::scaled:
      result.reason = NotAssessed::scaled;
      return result;
    default:
      result.reason = NotAssessed::no_test;
      return result;
  }
  if (!verified) {
    result.verdict = rules::Verdict::information;
  } else if (!as_asked) {
    result.reason = NotAssessed::other_tests;
  } else {
    bool const holds = rules::is_within(ratio.lambda(), 1.0, -limit.within_percent, limit.within_percent);
    result.verdict = holds ? rules::Verdict::pass : rules::Verdict::fail;
  }
  return result;
}

}  // namespace

std::string_view name(NotAssessed reason) {
  static constexpr std::array<std::string_view, 5> names{"no condition", "no test", "extrapolated", "scaled",
                                                         "other tests"};
  return names.at(static_cast<std::size_t>(reason));
}

std::vector<DeviceDependence> judge_dependence(rules::DependenceLimit const& limit, bool verified,
                                               Response const& response, DesignConditions const& design,
                                               bool as_asked) {
  bool const of_ageing = response.effect() == Effect::ageing;
  auto levels = limit.levels.empty() ? design.ends : limit.levels;
  if (of_ageing) levels.assign(design.ageing ? 1 : 0, 0.0);
  if (levels.empty()) return {{.reason = NotAssessed::no_condition}};
  std::ranges::sort(levels);
  levels.erase(std::ranges::unique(levels).begin(), levels.end());

  std::set<std::string, std::less<>> devices;
  for (auto const& level : response.levels())
    if (!level.reference)
      for (auto const& ratio : level.ratios) devices.insert(ratio.device);

  std::vector<DeviceDependence> results;
  for (double const level : levels) {
    if (!of_ageing && response.is_reference(level)) continue;
    auto const add = [&](DeviceDependence result, std::string const& device) {
      result.device = device;
      if (!of_ageing) result.at = level;
      results.push_back(std::move(result));
    };
    if (devices.empty()) add({.reason = NotAssessed::no_test}, "");
    for (auto const& device : devices) {
      auto const own = response.of_device(device);
      auto const ratio = of_ageing ? aged_factor(own.at(design.ageing->test), design.ageing->years,
                                                 design.ageing->test_stands_for_years)
                                   : own.at(level);
      add(judged(limit, verified, as_asked, ratio), device);
    }
  }
  return results;
}

}  // namespace isolaw::conditions
