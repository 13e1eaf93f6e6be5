// The tables of cyclic properties, verdicts and the lot.
#include <fmt/format.h>

#include <string>

#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/cycle_results.hpp"

namespace isolaw::render {
namespace {

void header(CsvTable& table, std::initializer_list<char const*> names) {
  for (auto const* name : names) table.cell(name);
  table.end_row();
}

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
  table.cell(device.name).cell(block.number);
  c.counts() ? table.cell(c.number) : table.empty(1);
  table.yes_no(c.counts()).cell(c.not_counted).yes_no(is_reported);
  CycleOf const of{c, device};
  table.cells(strain, of).cell(block.frequency_Hz).cells(of_cycles, of).cell(device.properties.refusal).end_row();
}

void assessment_row(CsvTable& table, std::string_view device, std::optional<int> block, rules::Assessment const& a) {
  table.cell(device);
  block ? table.cell(*block) : table.empty(1);
  table.cell(a.quantity).cell(a.clause).cell(a.formula).cell(a.value).cell(a.unit).cell(a.nominal);
  table.cell(a.deviation_percent).cell(a.limit).cell(rules::name(a.verdict)).cell(a.reason).end_row();
}

}  // namespace

std::string cycles_csv(Summary const& summary) {
  CsvTable table;
  for (auto const* name : {"device", "block", "cycle", "counts", "why not", "reported"}) table.cell(name);
  table.head(strain).cell("frequency [Hz]").head(of_cycles).cell("no properties").end_row();
  constexpr std::size_t width = 9 + of_cycles.size();
  for (auto const& device : summary.devices) {
    for (auto const& block : device.properties.blocks)
      for (auto const& cycle : block.cycles) cycle_row(table, device, block, cycle);
    if (device.properties.blocks.empty())
      table.cell(device.name)
          .empty(width - 2)
          .cell(device.status == "ok" ? device.properties.refusal : device.message)
          .end_row();
  }
  return table.take();
}

std::string tests_csv(Summary const& summary) {
  CsvTable table;
  header(table, {"device", "block", "quantity", "clause", "formula", "value", "unit", "design value", "deviation [%]",
                 "limit", "verdict", "reason"});
  for (auto const& device : summary.devices)
    for (auto const& assessment : device.acceptance.assessments)
      assessment_row(table, device.name, device.acceptance.block, assessment);
  return table.take();
}

std::string lot_csv(Summary const& summary) {
  CsvTable table;
  header(table, {"quantity",
                 "unit",
                 "lot size",
                 "tested",
                 "required",
                 "with a value",
                 "mean",
                 "std",
                 "CoV [%]",
                 "min",
                 "min device",
                 "max",
                 "max device",
                 "design value",
                 "deviation of the mean [%]",
                 "worst deviation [%]",
                 "worst device",
                 "5 % fractile",
                 "95 % fractile",
                 "tolerance factor k 95/95",
                 "tolerance low",
                 "tolerance high",
                 "no lower bound",
                 "limit on the mean",
                 "verdict",
                 "reason",
                 "outliers"});
  auto const& lot = summary.acceptance.lot;
  auto const whole = [&](std::optional<int> value) { value ? table.cell(*value) : table.empty(1); };
  for (auto const& q : lot.quantities) {
    table.cell(rules::name(q.quantity)).cell(q.unit);
    whole(lot.lot_size);
    table.cell(lot.devices);
    whole(lot.required);
    table.cell(q.count).cell(q.mean).cell(q.std).cell(q.cov_percent).cell(q.min).cell(q.min_device).cell(q.max);
    table.cell(q.max_device).cell(q.nominal).cell(q.mean_deviation_percent).cell(q.worst_deviation_percent);
    table.cell(q.worst_device).cell(q.fractile_5).cell(q.fractile_95).cell(q.tolerance_factor).cell(q.tolerance_low);
    table.cell(q.tolerance_high).cell(q.no_lower);
    std::vector<std::string> limits, verdicts, reasons, outliers;
    for (auto const& limit : q.mean_limits) {
      limits.push_back(limit.limit);
      verdicts.emplace_back(rules::name(limit.verdict));
      if (!limit.reason.empty()) reasons.push_back(limit.reason);
    }
    for (auto const& outlier : q.outliers) outliers.push_back(outlier.device + ": " + outlier.reason);
    if (!q.outlier_note.empty()) outliers.push_back(q.outlier_note);
    table.cell(joined(limits, "; "))
        .cell(joined(verdicts, "; "))
        .cell(joined(reasons, "; "))
        .cell(joined(outliers, "; "))
        .end_row();
  }
  return table.take();
}

std::string lambda_csv(Summary const& summary) {
  CsvTable table;
  header(table, {"property", "unit", "source", "lambda_spec min", "lambda_spec max", "lambda_test min",
                 "lambda_test max", "min cycle", "max cycle", "lambda min", "lambda max", "lower bound", "upper bound",
                 "note", "no lower bound"});
  for (auto const& q : summary.acceptance.lot.quantities)
    for (auto const& b : q.bounds) {
      table.cell(rules::name(q.quantity)).cell(q.unit).cell(b.source).cell(b.spec.min).cell(b.spec.max);
      if (auto const& test = q.test_factors)
        table.cell(test->min).cell(test->max).cell(test->min_cycle).cell(test->max_cycle);
      else
        table.empty(4);
      table.cell(b.combined.min).cell(b.combined.max).cell(b.lower).cell(b.upper).cell(b.note).cell(b.no_lower);
      table.end_row();
    }
  return table.take();
}

}  // namespace isolaw::render
