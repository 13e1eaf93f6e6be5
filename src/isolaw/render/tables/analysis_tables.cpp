#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {

std::string identifiability_csv(Summary const& summary) {
  constexpr auto range = columns(analysis_results, {"optimum", "identifiability", "open_range"});
  constexpr auto intervals = columns(analysis_results, {"linear_interval", "bootstrap_interval"});
  CsvTable table;
  table.add("law", "device", "parameter", "unit").head(range).add("range ends at the box").head(intervals).end_row();
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      for (auto const& p : fit.parameters) {
        if (!p.analysis) continue;
        auto const& a = *p.analysis;
        table.add(law.id, fit.device, p.name, p.unit).cells(range, a);
        table.add(a.open_below && a.open_above ? "both" : a.open_below ? "below" : a.open_above ? "above" : "no");
        table.cells(intervals, a).end_row();
      }
  return table.take();
}

std::string converged_csv(Summary const& summary) {
  constexpr auto of_law =
      columns(law_results, {"id", "objective_converged", "beta_converged", "on_front_converged",
                            "beta: beta, mean of the runs", "on_front: on front, mean of the runs", "success_share",
                            "success_reference", "loo_objective", "loo_worst", "loo_worst_device", "on_front_loo"});
  constexpr auto of_lot =
      columns(lot_law_results, {"mean_objective", "worst_objective", "least_worst_objective", "least_worst_bound"});
  constexpr auto blocks = columns(law_results, {"left_out_of_beta", "fitted_objective", "predicted_objective",
                                                "prediction_grade", "beta_converged_note"});
  CsvTable table;
  table.head(of_law).head(of_lot).head(blocks).end_row();
  for (auto const& law : summary.laws) {
    table.cells(of_law, law);
    law.lot ? table.cells(of_lot, *law.lot) : table.empty(of_lot.size());
    table.cells(blocks, law).end_row();
  }
  return table.take();
}

std::string lot_law_csv(Summary const& summary) {
  CsvTable table;
  table.row("law", "parameter", "unit", "calibrated", "lot, least mean OF", "lot, least worst OF", "population median",
            "relative scatter [-]");
  for (auto const& law : summary.laws) {
    if (!law.lot) continue;
    auto const& parameters = parameters_of(law);
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      auto const& p = parameters[n];
      table.add(law.id, p.name, p.unit, p.free, law.lot->parameters[n], law.lot->worst_parameters[n]);
      auto const place = law.population ? place_of(*law.population, p.name) : std::nullopt;
      place ? table.add(law.population->medians[*place]) : table.empty(1);
      place&& law.population->has_covariance() ? table.add(law.population->relative_std[*place]) : table.empty(1);
      table.end_row();
    }
  }
  return table.take();
}

std::string prediction_csv(Summary const& summary) {
  constexpr auto of_fitted_part =
      columns(fit_results, {"optimum: the device itself", "lot_objective", "worst_objective", "left_out_objective"});
  CsvTable table;
  table.row("law", "device", "judged on", "law of", "OF [-]");
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices) {
      auto const row = [&](std::string_view judged, std::string_view of, Value const& objective) {
        if (!std::holds_alternative<std::monostate>(objective)) table.row(law.id, fit.device, judged, of, objective);
      };
      for (auto const& one : of_fitted_part) row("fitted part", one.heading, one.value(fit));
      for (auto const& score : fit.blocks)
        row("block " + std::to_string(score.block) + (score.fitted ? ", fitted" : ", predicted"), "the device itself",
            study::value_of(score.objective));
    }
  return table.take();
}

}  // namespace isolaw::render
