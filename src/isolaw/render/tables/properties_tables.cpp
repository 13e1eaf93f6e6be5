#include <string>

#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/acceptance_results.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

// Each row of the table of cycles has the column `strain`, then the frequency of the cycle's block, then the columns
// `of_cycles`.
constexpr auto strain = columns(cycle_results, {"strain_percent"});
constexpr auto of_cycles = columns(cycle_results, {"period_s",
                                                   "amplitude_mm",
                                                   "d_plus_mm",
                                                   "d_minus_mm",
                                                   "F_plus_kN",
                                                   "F_minus_kN",
                                                   "K_eff_kN_per_mm",
                                                   "K_plus_kN_per_mm",
                                                   "K_minus_kN_per_mm",
                                                   "G_MPa",
                                                   "energy_kN_mm",
                                                   "damping_percent",
                                                   "Q_d_kN",
                                                   "K_d_kN_per_mm",
                                                   "D_y_mm",
                                                   "K_1_kN_per_mm",
                                                   "F_y_kN",
                                                   "residual_plus_mm",
                                                   "residual_minus_mm",
                                                   "work_kN_mm",
                                                   "K_eff_in_block",
                                                   "K_eff_in_test",
                                                   "v_max_mm_s",
                                                   "N_mean_kN",
                                                   "N_min_kN",
                                                   "N_max_kN",
                                                   "closure_mm",
                                                   "closure_kN",
                                                   "first",
                                                   "last",
                                                   "half"});

void cycle_row(CsvTable& table, UnitSystem const& units, DeviceResult const& device, data::Block const& block,
               data::Cycle const& c) {
  auto const& reported = device.properties.reported;
  bool const is_reported = reported && reported->block == block.number && reported->number == c.number && c.counts();
  auto const number = c.counts() ? std::optional(c.number) : std::nullopt;
  table.add(device.name, block.number, number, c.counts(), c.not_counted, is_reported);
  CycleOf const row{c, device};
  table.cells(strain, row)
      .add(block.frequency_Hz)
      .cells(of_cycles, row)
      .row(wording::reasons(device.properties.refusal, units));
}

}  // namespace

std::string cycles_csv(Summary const& summary) {
  CsvTable table(summary.units());
  table.add("device", "block", "cycle", "counts", "why not", "reported");
  table.head(strain).add("frequency [Hz]").head(of_cycles).row("no properties");
  constexpr std::size_t width = 9 + of_cycles.size();
  for (auto const& device : summary.devices) {
    for (auto const& block : device.properties.blocks)
      for (auto const& cycle : block.cycles) cycle_row(table, summary.units(), device, block, cycle);
    if (device.properties.blocks.empty())
      table.add(device.name)
          .empty(width - 2)
          .row(device.status == "ok" ? wording::reasons(device.properties.refusal, summary.units()) : device.message);
  }
  return table.take();
}

std::string tests_csv(Summary const& summary) {
  constexpr auto of_test = columns(assessment_results, {"block", "quantity", "clause", "formula", "value", "unit",
                                                        "nominal", "deviation_percent", "limit", "verdict", "reason"});
  CsvTable table(summary.units());
  table.add("device").head(of_test).end_row();
  for (auto const& device : summary.devices)
    for (auto const& assessment : device.acceptance.assessments)
      table.add(device.name)
          .cells(of_test, AssessmentOf{assessment, device.acceptance.block}, assessment.unit)
          .end_row();
  return table.take();
}

std::string levels_csv(Summary const& summary) {
  constexpr auto of_level =
      columns(level_results, {"block", "amplitude_mm", "strain_percent", "frequency_Hz", "N_mean_kN", "cycle",
                              "K_eff_kN_per_mm", "damping_percent", "energy_kN_mm", "K_1_kN_per_mm", "K_d_kN_per_mm",
                              "D_y_mm", "F_y_kN", "K_eff_ratio", "damping_ratio", "reference"});
  CsvTable table(summary.units());
  table.add("device").head(of_level).end_row();
  for (auto const& device : summary.devices)
    for (auto const& level : study::levels_of(device)) table.add(device.name).cells(of_level, level).end_row();
  return table.take();
}

std::string vertical_csv(Summary const& summary) {
  constexpr auto of_device = columns(vertical_results, {"K_v_kN_per_mm", "how", "low_kN", "high_kN", "disp_low_mm",
                                                        "disp_high_mm", "loading", "file", "sha256", "refusal"});
  CsvTable table(summary.units());
  table.add("device").head(of_device).end_row();
  for (auto const& device : summary.devices)
    if (device.vertical_test.is_given()) table.add(device.name).cells(of_device, device).end_row();
  return table.take();
}

std::string lot_csv(Summary const& summary) {
  constexpr auto quantity = columns(quantity_results, {"quantity", "unit"});
  constexpr auto spread =
      columns(quantity_results, {"n", "mean", "sd", "cov_percent", "min", "min_device", "max", "max_device", "nominal",
                                 "deviation_of_mean_percent", "worst_deviation_percent", "worst_device", "fractile_5",
                                 "fractile_95", "tolerance_k", "tolerance_lower", "tolerance_upper", "no_lower_bound"});
  CsvTable table(summary.units());
  table.head(quantity).add("lot size", "tested", "required").head(spread);
  table.row("limit on the mean", "verdict", "reason", "outliers");
  auto const& lot = summary.acceptance.lot;
  for (auto const& q : lot.quantities) {
    std::vector<std::string> limits, verdicts, reasons, outliers;
    for (auto const& limit : q.mean_limits) {
      limits.push_back(limit.limit);
      verdicts.emplace_back(rules::name(limit.verdict));
      if (!limit.reason.empty()) reasons.push_back(limit.reason);
    }
    for (auto const& outlier : q.outliers) outliers.push_back(outlier.device + ": " + outlier.reason);
    if (!q.outlier_note.empty()) outliers.push_back(q.outlier_note);
    table.cells(quantity, q, q.unit).add(lot.lot_size, lot.devices, lot.required).cells(spread, q, q.unit);
    table.row(joined(limits, "; "), joined(verdicts, "; "), joined(reasons, "; "), joined(outliers, "; "));
  }
  return table.take();
}

std::string lambda_csv(Summary const& summary) {
  constexpr auto of_supply = columns(factor_results, {"property", "unit", "source", "spec_min", "spec_max"});
  constexpr auto of_test = columns(test_factor_results, {"min", "max", "min_cycle", "max_cycle"});
  constexpr auto bounds =
      columns(factor_results, {"lambda_min", "lambda_max", "lower", "upper", "note", "no_lower_bound"});
  CsvTable table(summary.units());
  table.head(of_supply).head(of_test).head(bounds).end_row();
  for (auto const& quantity : summary.acceptance.lot.quantities)
    for (auto const& bound : quantity.bounds) {
      FactorOf const row{quantity, bound};
      table.cells(of_supply, row, quantity.unit).cells(of_test, quantity).cells(bounds, row, quantity.unit).end_row();
    }
  return table.take();
}

}  // namespace isolaw::render
