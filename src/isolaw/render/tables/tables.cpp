#include "isolaw/render/tables/tables.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/table_rows.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

std::string devices_at_bound(LawResult const& law, std::size_t parameter) {
  std::vector<std::string> devices;
  for (auto const& fit : law.devices)
    if (parameter < fit.parameters.size() && fit.parameters[parameter].at_bound != fit::AtBound::no)
      devices.push_back(fmt::format("{} {}", fit.device, name(fit.parameters[parameter].at_bound)));
  return joined(devices, "; ");
}

// Returns the bound of a parameter if it is the same for all devices. Boxes that are scaled from each record differ
// between devices; the function then returns "per device".
Value common_bound(LawResult const& law, std::size_t parameter, double ParameterFit::*bound) {
  std::optional<double> common;
  for (auto const& fit : law.devices) {
    if (parameter >= fit.parameters.size()) continue;
    double const value = fit.parameters[parameter].*bound;
    if (common && *common != value) return "per device";
    common = value;
  }
  return study::value_of(common);
}

}  // namespace

std::string parameters_csv(Summary const& summary) {
  CsvTable table;
  table.add("law", "quantity", "unit", "lower bound", "upper bound", "calibrated");
  auto const devices = device_names(summary);
  for (auto const& device : devices) table.add(device + " mean", device + " std");
  table.row("Delta_n [-]", "best at bound");

  for (auto const& law : summary.laws) {
    table.add(law.id, "OF", "-").empty(3);
    for (auto const& device : devices) {
      auto const* fit = fit_of(law, device);
      fit ? table.add(fit->objective.mean, fit->objective.std) : table.empty(2);
    }
    table.empty(2).end_row();
    auto const& parameters = parameters_of(law);
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      table.add(law.id, parameters[n].name, parameters[n].unit, common_bound(law, n, &ParameterFit::lower),
                common_bound(law, n, &ParameterFit::upper), parameters[n].free);
      for (auto const& device : devices) {
        auto const* fit = fit_of(law, device);
        bool const there = fit != nullptr && n < fit->parameters.size();
        there ? table.add(fit->parameters[n].value.mean, fit->parameters[n].value.std) : table.empty(2);
      }
      table.row(parameters[n].free ? largest_difference(law, n) : std::nullopt, devices_at_bound(law, n));
    }
  }
  return table.take();
}

std::string objective_csv(Summary const& summary) {
  constexpr auto of_fit = columns(fit_results, {"name", "objective", "runs", "failed_runs", "evaluations",
                                                "failed_evaluations", "K_eff_error_percent", "energy_error_percent",
                                                "damping_error_percent", "integration_shift", "status", "message"});
  constexpr auto by_time = columns(fit_results, {"objective_by_time"});
  bool const weighed = std::ranges::any_of(summary.laws, [](LawResult const& law) {
    return std::ranges::any_of(law.devices, [](DeviceFit const& fit) { return fit.objective_by_time.has_value(); });
  });
  CsvTable table;
  table.add("law").head(of_fit).add("missing runs");
  if (weighed) table.head(by_time);
  table.end_row();
  for (auto const& law : summary.laws) {
    for (auto const& device : summary.devices)
      if (device.status != "ok")
        table.add(law.id, device.name).empty(11).add("refused", device.message, 0).empty(weighed ? 1 : 0).end_row();
    for (auto const& fit : law.devices) {
      table.add(law.id).cells(of_fit, fit).add(fit.missing_runs);
      if (weighed) table.cells(by_time, fit);
      table.end_row();
    }
  }
  return table.take();
}

std::string robustness_csv(Summary const& summary) {
  constexpr auto of_law = columns(law_results, {"id", "objective", "beta", "on_front", "beta_note"});
  CsvTable table;
  table.head(of_law).end_row();
  for (auto const& law : summary.laws) table.cells(of_law, law).end_row();
  return table.take();
}

std::string table_a5_csv(Summary const& summary) {
  CsvTable table;
  table.add("law", "quantity", "unit", "calibrated", "in the paper");
  auto const devices = device_names(summary);
  for (auto const& device : devices) table.add(device + " mean", device + " std", device + " best");
  table.end_row();
  for (auto const& law : summary.laws)
    for (auto const& quantity : quantities_of(law)) {
      table.add(law.id, quantity.name, quantity.unit);
      quantity.n ? table.add(quantity.free) : table.empty(1);
      table.add(quantity.paper_name);
      for (auto const& device : devices) table.add(statistic_of(law, device, quantity));
      table.end_row();
    }
  return table.take();
}

std::string front_csv(Summary const& summary) {
  CsvTable table;
  table.row("view", "law", "accuracy OF [-]", "robustness beta, or OF on devices left out [-]", "on front",
            "dominated by");
  for (auto const view : front_views) {
    auto const points = by_accuracy(summary, view);
    for (auto const& point : points)
      table.row(view, point.law, point.y, point.x, point.on_front, joined(dominating(points, point)));
  }
  return table.take();
}

}  // namespace isolaw::render
