#include "isolaw/render/tables/tables.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "isolaw/render/tables/csv.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

// "D3 upper; D5 lower"
std::string devices_at_bound(LawResult const& law, std::size_t parameter) {
  std::string text;
  for (auto const& fit : law.devices) {
    if (parameter >= fit.parameters.size() || fit.parameters[parameter].at_bound.empty()) continue;
    if (!text.empty()) text += "; ";
    text += fit.device + " " + fit.parameters[parameter].at_bound;
  }
  return text;
}

// A bound of the search box; boxes scaled from the record differ between devices.
void bound_cell(CsvTable& table, LawResult const& law, std::size_t parameter, double ParameterFit::*bound) {
  std::optional<double> common;
  for (auto const& fit : law.devices) {
    if (parameter >= fit.parameters.size()) continue;
    double const value = fit.parameters[parameter].*bound;
    if (common && *common != value) {
      table.cell("per device");
      return;
    }
    common = value;
  }
  table.cell(common);
}

}  // namespace

std::string parameters_csv(Summary const& summary) {
  CsvTable table;
  table.cell("law").cell("quantity").cell("unit").cell("lower bound").cell("upper bound").cell("calibrated");
  std::vector<std::string> devices;
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    devices.push_back(device.name);
    table.cell(device.name + " mean").cell(device.name + " std");
  }
  table.cell("Delta_n [-]").cell("best at bound").end_row();

  for (auto const& law : summary.laws) {
    // The fits in the order of the header; a device the law was not tried on leaves its cells empty.
    std::vector<DeviceFit const*> fits;
    for (auto const& device : devices) {
      auto const fit =
          std::find_if(law.devices.begin(), law.devices.end(), [&](auto const& f) { return f.device == device; });
      fits.push_back(fit == law.devices.end() ? nullptr : &*fit);
    }
    table.cell(law.id).cell("OF").cell("-").empty(3);
    for (auto const* fit : fits) fit ? table.cell(fit->objective.mean).cell(fit->objective.std) : table.empty(2);
    table.empty(2).end_row();
    auto const& parameters = parameters_of(law);
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      table.cell(law.id).cell(parameters[n].name).cell(parameters[n].unit);
      bound_cell(table, law, n, &ParameterFit::lower);
      bound_cell(table, law, n, &ParameterFit::upper);
      table.yes_no(parameters[n].free);
      for (auto const* fit : fits) {
        bool const there = fit && n < fit->parameters.size();
        there ? table.cell(fit->parameters[n].value.mean).cell(fit->parameters[n].value.std) : table.empty(2);
      }
      table.cell(parameters[n].free ? largest_difference(law, n) : std::nullopt);
      table.cell(devices_at_bound(law, n)).end_row();
    }
  }
  return table.take();
}

std::string objective_csv(Summary const& summary) {
  constexpr auto of_fit = columns(fit_results, {"name", "objective", "runs", "failed_runs", "evaluations",
                                                "failed_evaluations", "K_eff_error_percent", "energy_error_percent",
                                                "damping_error_percent", "integration_shift", "status", "message"});
  CsvTable table;
  table.cell("law").head(of_fit).cell("missing runs").end_row();
  for (auto const& law : summary.laws) {
    for (auto const& device : summary.devices)
      if (device.status != "ok")
        table.cell(law.id).cell(device.name).empty(11).cell("refused").cell(device.message).cell(0).end_row();
    for (auto const& fit : law.devices) table.cell(law.id).cells(of_fit, fit).cell(fit.missing_runs).end_row();
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

}  // namespace isolaw::render
