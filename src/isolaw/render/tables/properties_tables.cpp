// The tables of cyclic properties, verdicts and the lot.
#include <fmt/format.h>

#include <string>

#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/tables.hpp"

namespace isolaw::render {
namespace {

void header(CsvTable& table, std::initializer_list<char const*> names) {
  for (auto const* name : names) table.cell(name);
  table.end_row();
}

void cycle_row(CsvTable& table, DeviceResult const& device, data::Block const& block, data::Cycle const& c) {
  auto const strain = shear_strain(c, device.rubber_thickness_mm, device.rubber_area_mm2);
  auto const& reported = device.properties.reported;
  bool const is_reported = reported && reported->block == block.number && reported->number == c.number && c.counts();
  table.cell(device.name).cell(block.number);
  c.counts() ? table.cell(c.number) : table.empty(1);
  table.yes_no(c.counts()).cell(c.not_counted).yes_no(is_reported);
  table.cell(strain ? std::optional(strain->shear_strain_percent) : std::nullopt).cell(block.frequency_Hz);
  table.cell(c.period_s).cell(c.amplitude_mm).cell(c.d_plus_mm).cell(c.d_minus_mm).cell(c.F_plus_kN).cell(c.F_minus_kN);
  table.cell(c.K_eff_kN_per_mm).cell(c.K_plus()).cell(c.K_minus());
  table.cell(strain ? strain->G_MPa : std::nullopt).cell(c.energy_kN_mm).cell(c.damping_percent);
  table.cell(c.Q_d_kN).cell(c.K_d_kN_per_mm).cell(c.D_y_mm).cell(c.K_1_kN_per_mm).cell(c.v_max_mm_s);
  table.cell(c.N_mean_kN).cell(c.N_min_kN).cell(c.N_max_kN).cell(c.closure_mm).cell(c.closure_kN);
  table.cell(c.first).cell(c.last).cell(device.properties.refusal).end_row();
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
  header(table, {"device",         "block",          "cycle",         "counts",         "why not",      "reported",
                 "strain [%]",     "frequency [Hz]", "period [s]",    "amplitude [mm]", "d+ [mm]",      "d- [mm]",
                 "F+ [kN]",        "F- [kN]",        "K_eff [kN/mm]", "K+ [kN/mm]",     "K- [kN/mm]",   "G [MPa]",
                 "energy [kN mm]", "damping [%]",    "Q_d [kN]",      "K_d [kN/mm]",    "D_y [mm]",     "K_1 [kN/mm]",
                 "v max [mm/s]",   "N mean [kN]",    "N min [kN]",    "N max [kN]",     "closure [mm]", "closure [kN]",
                 "first sample",   "last sample",    "no properties"});
  constexpr int columns = 33;
  for (auto const& device : summary.devices) {
    for (auto const& block : device.properties.blocks)
      for (auto const& cycle : block.cycles) cycle_row(table, device, block, cycle);
    if (device.properties.blocks.empty())
      table.cell(device.name)
          .empty(columns - 2)
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
