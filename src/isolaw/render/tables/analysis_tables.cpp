#include <algorithm>

#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {

std::string identifiability_csv(Summary const& summary) {
  CsvTable table;
  table.cell("law").cell("device").cell("parameter").cell("unit").cell("optimum").cell("identifiability");
  table.cell("open range lower").cell("open range upper").cell("range ends at the box");
  table.cell("linear interval lower").cell("linear interval upper");
  table.cell("bootstrap interval lower").cell("bootstrap interval upper").end_row();
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      for (auto const& p : fit.parameters) {
        if (!p.analysis) continue;
        auto const& a = *p.analysis;
        table.cell(law.id).cell(fit.device).cell(p.name).cell(p.unit).cell(a.optimum).cell(a.identifiability);
        table.cell(a.open_lower).cell(a.open_upper);
        table.cell(a.open_below && a.open_above ? "both" : a.open_below ? "below" : a.open_above ? "above" : "no");
        table.cell(a.linear_lower).cell(a.linear_upper).cell(a.bootstrap_lower).cell(a.bootstrap_upper).end_row();
      }
  return table.take();
}

std::string converged_csv(Summary const& summary) {
  CsvTable table;
  table.cell("law").cell("mean least OF [-]").cell("beta, converged [-]").cell("on front, converged");
  table.cell("beta, as published [-]")
      .cell("on front, as published")
      .cell("success share [-]")
      .cell("success refers to");
  table.cell("OF, device left out [-]").cell("OF, worst device left out [-]").cell("worst device left out");
  table.cell("on front, left out").cell("OF, law of the lot [-]").cell("OF, law of the lot, worst device [-]");
  table.cell("least OF of the worst device [-]")
      .cell("least possible where descents are global [-]")
      .cell("left out of beta");
  table.cell("OF, blocks fitted [-]")
      .cell("OF, blocks predicted [-]")
      .cell("prediction collapses")
      .cell("note")
      .end_row();
  for (auto const& law : summary.laws) {
    table.cell(law.id).cell(law.objective_converged).cell(law.beta_converged).yes_no(law.on_front_converged);
    table.cell(law.beta).yes_no(law.on_front).cell(law.success_share).cell(law.success_reference);
    table.cell(law.loo_objective).cell(law.loo_worst).cell(law.loo_worst_device).yes_no(law.on_front_loo);
    if (law.lot)
      table.cell(law.lot->mean).cell(law.lot->worst).cell(law.lot->least_worst).cell(law.lot->least_worst_bound);
    else
      table.empty(4);
    table.cell(enumerate(law.left_out_of_beta, 99)).cell(law.fitted_objective).cell(law.predicted_objective);
    if (law.predicted_objective)
      table.yes_no(law.prediction_collapses);
    else
      table.empty(1);
    table.cell(law.beta_converged_note).end_row();
  }
  return table.take();
}

std::string lot_law_csv(Summary const& summary) {
  CsvTable table;
  table.cell("law").cell("parameter").cell("unit").cell("calibrated").cell("lot, least mean OF");
  table.cell("lot, least worst OF").cell("population median").cell("relative scatter [-]").end_row();
  for (auto const& law : summary.laws) {
    if (!law.lot) continue;
    auto const& parameters = parameters_of(law);
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      auto const& p = parameters[n];
      table.cell(law.id).cell(p.name).cell(p.unit).yes_no(p.free);
      table.cell(law.lot->parameters[n]).cell(law.lot->worst_parameters[n]);
      bool const in_population = law.population && p.free && !law.population->medians.empty();
      if (!in_population) {
        table.empty(2).end_row();
        continue;
      }
      auto const& names = law.population->names;
      auto const at = static_cast<std::size_t>(std::ranges::find(names, p.name) - names.begin());
      table.cell(law.population->medians[at]);
      law.population->has_covariance() ? table.cell(law.population->relative_std[at]) : table.empty(1);
      table.end_row();
    }
  }
  return table.take();
}

std::string prediction_csv(Summary const& summary) {
  CsvTable table;
  table.cell("law").cell("device").cell("judged on").cell("law of").cell("OF [-]").end_row();
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices) {
      auto const row = [&](std::string_view judged, std::string_view of, std::optional<double> const& objective) {
        if (objective) table.cell(law.id).cell(fit.device).cell(judged).cell(of).cell(objective).end_row();
      };
      row("fitted part", "the device itself", fit.optimum);
      row("fitted part", "the lot, least mean", fit.lot_objective);
      row("fitted part", "the lot, least worst", fit.worst_objective);
      row("fitted part", "all other devices", fit.left_out_objective);
      for (auto const& score : fit.blocks)
        row("block " + std::to_string(score.block) + (score.fitted ? ", fitted" : ", predicted"), "the device itself",
            score.objective);
    }
  return table.take();
}

}  // namespace isolaw::render
