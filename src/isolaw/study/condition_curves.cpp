#include "isolaw/study/condition_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace isolaw::study {
namespace {

using conditions::Effect;
using conditions::Level;
using conditions::Response;

struct Place {
  double at = 0.0, ln = 0.0;
};

std::optional<double> ln_of(Level const& level, std::string const& device) {
  auto const found = std::ranges::find(level.ratios, device, &conditions::DeviceRatio::device);
  return found == level.ratios.end() ? std::nullopt : std::optional(found->ln);
}

// Appends the straight line between two places. It is curved over the load itself, since it is straight over its
// square.
void append_line(ConditionCurve& curve, Response const& response, Place const& from, Place const& to) {
  int const steps = response.effect() == Effect::load ? 12 : 1;
  for (int i = curve.at.empty() ? 0 : 1; i <= steps; ++i) {
    double const at = i == steps ? to.at : from.at + (to.at - from.at) * i / steps;
    double const share =
        (response.abscissa(at) - response.abscissa(from.at)) / (response.abscissa(to.at) - response.abscissa(from.at));
    curve.at.push_back(at);
    curve.lambda.push_back(std::exp(from.ln + share * (to.ln - from.ln)));
  }
}

void add_curves(std::vector<ConditionCurve>& curves, EffectResponse const& of, ConditionsResult const& result) {
  auto const& response = of.response;
  auto const begin = [&](CurveKind kind, std::string device = {}) {
    return ConditionCurve{.quantity = of.quantity,
                          .effect = response.effect(),
                          .kind = kind,
                          .device = std::move(device),
                          .at = {},
                          .lambda = {}};
  };
  auto const keep = [&](ConditionCurve&& curve) {
    if (!curve.at.empty()) curves.push_back(std::move(curve));
  };
  std::vector<Level const*> paired;
  for (auto const& level : response.levels())
    if (!level.unpaired) paired.push_back(&level);

  std::vector<std::string> devices;
  for (auto const* level : paired)
    for (auto const& ratio : level->ratios)
      if (!level->reference && std::ranges::find(devices, ratio.device) == devices.end())
        devices.push_back(ratio.device);
  for (auto const& device : devices) {
    auto curve = begin(CurveKind::device, device);
    std::optional<Place> before;
    for (auto const* level : paired) {
      auto const ln = ln_of(*level, device);
      if (!ln) continue;
      Place const here{level->at, *ln};
      if (before) append_line(curve, response, *before, here);
      before = here;
    }
    keep(std::move(curve));
  }

  // Without a device in common there is no line between two levels.
  auto const mean_line = [&](Level const& first, Level const& second) -> std::optional<std::pair<Place, Place>> {
    double first_sum = 0.0, second_sum = 0.0;
    int common = 0;
    for (auto const& ratio : first.ratios)
      if (auto const other = ln_of(second, ratio.device)) first_sum += ratio.ln, second_sum += *other, ++common;
    if (common == 0) return std::nullopt;
    return std::pair(Place{first.at, first_sum / common}, Place{second.at, second_sum / common});
  };
  for (std::size_t i = 1; i < paired.size(); ++i)
    if (auto const line = mean_line(*paired[i - 1], *paired[i])) {
      auto curve = begin(CurveKind::mean);
      append_line(curve, response, line->first, line->second);
      keep(std::move(curve));
    }
  if (paired.size() < 2) return;
  for (auto const& end : result.ends) {
    if (end.quantity != of.quantity || end.effect != response.effect()) continue;
    if (end.factor.status != conditions::Status::extrapolated) continue;
    bool const below = end.at < paired.front()->at;
    auto const line = below ? mean_line(*paired[0], *paired[1]) : mean_line(*paired[paired.size() - 2], *paired.back());
    if (!line) continue;
    auto curve = begin(CurveKind::extrapolated);
    append_line(curve, response, below ? line->first : line->second, {end.at, end.factor.ln});
    keep(std::move(curve));
  }
}

}  // namespace

std::string_view name(CurveKind kind) {
  switch (kind) {
    case CurveKind::device:
      return "device";
    case CurveKind::mean:
      return "mean";
    case CurveKind::extrapolated:
      return "extrapolated";
  }
  return "";
}

std::vector<ConditionCurve> condition_curves(ConditionsResult const& result) {
  std::vector<ConditionCurve> curves;
  for (auto const& each : result.responses)
    if (each.response.effect() != Effect::ageing) add_curves(curves, each, result);
  return curves;
}

}  // namespace isolaw::study
