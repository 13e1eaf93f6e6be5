// The tables of cyclic properties, verdicts and the lot.
#include <string>

#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/cycle_results.hpp"

namespace isolaw::render {
namespace {

// What of a cycle stands before the frequency of its block, and after it.
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
                                                   "v_max_mm_s",
                                                   "N_mean_kN",
                                                   "N_min_kN",
                                                   "N_max_kN",
                                                   "closure_mm",
                                                   "closure_kN",
                                                   "first",
                                                   "last"});

void cycle_row(CsvTable& table, DeviceResult const& device, data::Block const& block, data::Cycle const& c) {
  auto const& reported = device.properties.reported;
  bool const is_reported = reported && reported->block == block.number && reported->number == c.number && c.counts();
  auto const number = c.counts() ? std::optional(c.number) : std::nullopt;
  table.add(device.name, block.number, number, c.counts(), c.not_counted, is_reported);
  CycleOf const of{c, device};
  table.cells(strain, of).add(block.frequency_Hz).cells(of_cycles, of).row(device.properties.refusal);
}

}  // namespace

std::string cycles_csv(Summary const& summary) {
  CsvTable table;
  table.add("device", "block", "cycle", "counts", "why not", "reported");
  table.head(strain).add("frequency [Hz]").head(of_cycles).row("no properties");
  constexpr std::size_t width = 9 + of_cycles.size();
  for (auto const& device : summary.devices) {
    for (auto const& block : device.properties.blocks)
      for (auto const& cycle : block.cycles) cycle_row(table, device, block, cycle);
    if (device.properties.blocks.empty())
      table.add(device.name).empty(width - 2).row(device.status == "ok" ? device.properties.refusal : device.message);
  }
  return table.take();
}

std::string tests_csv(Summary const& summary) {
  CsvTable table;
  table.row("device", "block", "quantity", "clause", "formula", "value", "unit", "design value", "deviation [%]",
            "limit", "verdict", "reason");
  for (auto const& device : summary.devices)
    for (auto const& a : device.acceptance.assessments)
      table.row(device.name, device.acceptance.block, a.quantity, a.clause, a.formula, a.value, a.unit, a.nominal,
                a.deviation_percent, a.limit, a.verdict, a.reason);
  return table.take();
}

std::string lot_csv(Summary const& summary) {
  CsvTable table;
  table.row("quantity", "unit", "lot size", "tested", "required", "with a value", "mean", "std", "CoV [%]", "min",
            "min device", "max", "max device", "design value", "deviation of the mean [%]", "worst deviation [%]",
            "worst device", "5 % fractile", "95 % fractile", "tolerance factor k 95/95", "tolerance low",
            "tolerance high", "no lower bound", "limit on the mean", "verdict", "reason", "outliers");
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
    table.row(q.quantity, q.unit, lot.lot_size, lot.devices, lot.required, q.count, q.mean, q.std, q.cov_percent, q.min,
              q.min_device, q.max, q.max_device, q.nominal, q.mean_deviation_percent, q.worst_deviation_percent,
              q.worst_device, q.fractile_5, q.fractile_95, q.tolerance_factor, q.tolerance_low, q.tolerance_high,
              q.no_lower, joined(limits, "; "), joined(verdicts, "; "), joined(reasons, "; "), joined(outliers, "; "));
  }
  return table.take();
}

std::string lambda_csv(Summary const& summary) {
  CsvTable table;
  table.row("property", "unit", "source", "lambda_spec min", "lambda_spec max", "lambda_test min", "lambda_test max",
            "min cycle", "max cycle", "lambda min", "lambda max", "lower bound", "upper bound", "note",
            "no lower bound");
  for (auto const& q : summary.acceptance.lot.quantities)
    for (auto const& b : q.bounds) {
      auto const& test = q.test_factors;
      table.add(q.quantity, q.unit, b.source, b.spec.min, b.spec.max);
      test ? table.add(test->min, test->max, test->min_cycle, test->max_cycle) : table.empty(4);
      table.row(b.combined.min, b.combined.max, b.lower, b.upper, b.note, b.no_lower);
    }
  return table.take();
}

}  // namespace isolaw::render
