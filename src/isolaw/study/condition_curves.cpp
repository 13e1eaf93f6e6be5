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

// Appends the line between two places. On an axis of the load it is drawn as a curve, since it is straight over the
// square of the load.
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
    if (!level.unpaired_factor) paired.push_back(&level);

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

  // Between two levels the mean is a straight line too, because it is the mean of the same devices' lines. It need not
  // meet the mean at either level, where other devices may have been tested as well.
  auto const mean_at = [&](double condition) {
    double sum = 0.0;
    auto const lines = response.lines_at(condition);
    for (auto const& line : lines) sum += line.ln;
    return sum / static_cast<double>(lines.size());
  };
  for (std::size_t i = 1; i < paired.size(); ++i) {
    double const from = paired[i - 1]->at, to = paired[i]->at;
    double const one = std::lerp(from, to, 0.25), other = std::lerp(from, to, 0.75);
    double const slope = (mean_at(other) - mean_at(one)) / (response.abscissa(other) - response.abscissa(one));
    auto const on_line = [&](double at) {
      return Place{at, mean_at(one) + slope * (response.abscissa(at) - response.abscissa(one))};
    };
    auto curve = begin(CurveKind::mean);
    append_line(curve, response, on_line(from), on_line(to));
    keep(std::move(curve));
  }
  if (paired.size() < 2) return;
  for (auto const& end : result.ends) {
    if (end.quantity != of.quantity || end.effect != response.effect()) continue;
    if (end.factor.status != conditions::Status::extrapolated) continue;
    auto const& outermost = end.at < paired.front()->at ? *paired.front() : *paired.back();
    auto curve = begin(CurveKind::extrapolated);
    append_line(curve, response, {outermost.at, outermost.mean()}, {end.at, end.factor.ln});
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
    case CurveKind::smooth:
      return "smooth";
  }
  return "";
}

std::vector<ConditionCurve> condition_curves(ConditionsResult const& result) {
  std::vector<ConditionCurve> curves;
  for (auto const& each : result.responses)
    if (each.response.effect() != Effect::ageing) add_curves(curves, each, result);
  for (auto const& row : result.curves)
    curves.push_back({.quantity = row.quantity,
                      .effect = row.effect,
                      .kind = CurveKind::smooth,
                      .device = row.device,
                      .at = row.at,
                      .lambda = row.lambda});
  return curves;
}

}  // namespace isolaw::study
