#include <fmt/format.h>

#include <algorithm>

#include "isolaw/num/statistics.hpp"
#include "isolaw/render/figures/device_panels.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {

MaybeFigure parameters_figure(Summary const& summary, LawResult const& law) {
  auto const devices = device_names(summary);
  auto const& parameters = parameters_of(law);
  auto const place = place_in_summary(summary, law);
  std::vector<DevicePanel> panels;
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    if (!parameters[n].free) continue;
    DevicePanel panel{.name = parameters[n].name, .unit = parameters[n].unit, .law = place};
    std::vector<double> means;
    for (auto const& device : devices) {
      DevicePoint point{device, {}, {}};
      auto const* fit = fit_of(law, device);
      if (fit != nullptr && fit->objective.mean && n < fit->parameters.size()) {
        point.value = fit->parameters[n].value;
        point.percent = fit->parameters[n].percent_of_lot;
        if (fit->counts && point.value.mean) means.push_back(*point.value.mean);
      }
      panel.points.push_back(std::move(point));
    }
    if (means.size() > 1) panel.reference = num::moments(means).mean;
    // If no point has a percentage, the mean is too close to zero to be a reference.
    if (std::ranges::none_of(panel.points, [](auto const& point) { return point.percent.has_value(); }))
      panel.reference.reset();
    if (means.empty()) continue;
    if (panels.size() < 26) panel.title = fmt::format("({})", static_cast<char>('a' + panels.size()));
    panels.push_back(std::move(panel));
  }
  return panels_figure(
      "parameters_" + law.id,
      "parameters of " + law.id +
          " on every device: mean and standard deviation over runs, difference from the mean of the devices, Figs. 8 to 13",
      panels);
}

}  // namespace isolaw::render
