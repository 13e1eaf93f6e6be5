#include "isolaw/render/tables/table_rows.hpp"

#include <algorithm>

#include "isolaw/study/findings.hpp"

namespace isolaw::render {

std::vector<Quantity> quantities_of(LawResult const& law) {
  std::vector<Quantity> quantities{{"OF", "-", true, std::nullopt, {}}};
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n)
    quantities.push_back({parameters[n].name, parameters[n].unit, parameters[n].free, n, parameters[n].paper_name});
  return quantities;
}

Statistic statistic_of(DeviceFit const& fit, Quantity const& quantity) {
  if (!quantity.n) return fit.objective;
  return *quantity.n < fit.parameters.size() ? fit.parameters[*quantity.n].value : Statistic{};
}

Statistic statistic_of(LawResult const& law, std::string const& device, Quantity const& quantity) {
  auto const* fit = fit_of(law, device);
  return fit == nullptr ? Statistic{} : statistic_of(*fit, quantity);
}

std::vector<FrontPoint> by_accuracy(Summary const& summary, FrontView view) {
  auto points = front_points(summary, view);
  std::ranges::stable_sort(points, {}, &FrontPoint::y);
  return points;
}

}  // namespace isolaw::render
