#include "isolaw/render/tables/building_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

constexpr auto distribution_columns =
    study::columns(study::distribution_results, {"lower", "nominal", "upper", "p16", "p50", "p84", "p95",
                                                 "motion_std_ln", "lot_std_ln", "lot_share", "uncertain_std_ln"});
constexpr auto coverage_columns = study::columns(
    study::coverage_results, {"inside", "lower", "upper", "below", "above", "factor_low", "factor_high"});
constexpr auto checked_columns = study::columns(
    study::checked_results, {"outcome", "isolator_mm", "energy_error", "step_s", "missed_mm", "lanes_off_percent",
                             "equivalent_mm", "equivalent_error_percent", "equivalent_period_s", "equivalent_damping"});

std::string whole_row(std::string_view text, int columns) {
  return fmt::format("\\multicolumn{{{}}}{{@{{}}l}}{{{}}} \\\\\n", columns, text);
}

}  // namespace

std::string building_csv(building::Study const& study, building::Answers const& answers) {
  CsvTable table(study.units());
  table.add("law", "quantity", "unit").head(distribution_columns).end_row();
  for (auto const& law : answers.laws)
    for (std::size_t q = 0; q < law.distributions.size(); ++q) {
      auto const& row = building::quantities()[q];
      table.add(law.law, name_in(row.key, study.units()), shown_unit(row.unit, study.units()).unit);
      table.cells(distribution_columns, law.distributions[q], row.unit).end_row();
    }
  return table.take();
}

std::string coverage_csv(building::Study const& study, building::Answers const& answers) {
  CsvTable table;
  table.add("law", "draws", "quantity").head(coverage_columns).row("not monotonic");
  for (auto const& law : answers.laws)
    for (auto const& of : law.coverage)
      table.add(law.law, law.draws, name_in(of.quantity, study.units()))
          .cells(coverage_columns, of)
          .row(of.monotony ? wording::remark(*of.monotony, study.units()) : std::string());
  return table.take();
}

std::string building_checks_csv(building::Study const& study, building::Answers const& answers) {
  CsvTable table(study.units());
  table.add("law", "motion").head(checked_columns).end_row();
  for (auto const& law : answers.laws)
    for (std::size_t m = 0; m < law.checked.size(); ++m)
      table.add(law.law, study.file.motions[m].name).cells(checked_columns, law.checked[m]).end_row();
  return table.take();
}

std::string building_tex(building::Study const& study, building::Answers const& answers) {
  auto const& s = study.file.settings;
  bool const drawn = std::ranges::any_of(answers.laws, [](auto const& law) { return law.draws > 0; });
  int const columns = drawn ? 10 : 4;
  std::string text = fmt::format(
      "% The isolated building: bound analyses{}.\n",
      drawn ? ", fractiles of the draws, parts of the spread of ln(response)" : "; no bearing is drawn from the lot");
  text += "% Needs in the preamble: \\usepackage{booktabs}; with names beyond ASCII \\usepackage[T1]{fontenc} too.\n";
  auto const bound = [](std::optional<building::PartFactors> const& factors) {
    if (!factors) return std::string("those of the bound law over the design conditions");
    return factors->is_whole()
               ? fmt::format("times {}", factors->elastic)
               : fmt::format("times {} (elastic part) and {} (hysteretic part)", factors->elastic, factors->hysteretic);
  };
  text += fmt::format("% Means over {} motions, {} draws; forces of the lower bound {}, of the upper one {}.\n",
                      study.file.motions.size(), drawn ? s.draws : 0, bound(s.lower), bound(s.upper));
  text += fmt::format("\\begin{{tabular}}{{@{{}}l{:r>{}}@{{}}}}\n\\toprule\n", "", columns - 1);
  text += " & \\multicolumn{3}{c}{Analyses}";
  if (drawn) text += " & \\multicolumn{4}{c}{Draws} & \\multicolumn{2}{c}{$\\sigma_{\\ln}$}";
  text += " \\\\\n\\cmidrule(lr){2-4}";
  if (drawn) text += "\\cmidrule(lr){5-8}\\cmidrule(l){9-10}";
  text += "\nQuantity & lower & nominal & upper";
  if (drawn) text += " & 16\\,\\% & 50\\,\\% & 84\\,\\% & 95\\,\\% & lot & motions";
  text += " \\\\\n\\midrule\n";
  for (auto const& law : answers.laws) {
    text +=
        "\\addlinespace\n" + whole_row(fmt::format("\\itshape {}", latex_text(laws::display_name(law.law))), columns);
    for (std::size_t q = 0; q < law.distributions.size(); ++q) {
      auto const& row = building::quantities()[q];
      auto const& d = law.distributions[q];
      auto const shown = shown_unit(row.unit, study.units());
      auto const unit = latex_unit(shown.unit);
      text += latex_text(row.title) + (unit.empty() ? "" : " (" + unit + ")");
      for (double const value : {d.lower, d.nominal, d.upper}) text += " & " + latex_number(shown.factor * value, 3);
      if (drawn) {
        for (double const value : d.fractiles) text += " & " + latex_number(shown.factor * value, 3);
        text += " & " + latex_number(d.lot_std_ln, 2) + " & " + latex_number(d.motion_std_ln, 2);
      }
      text += " \\\\\n";
    }
    for (std::size_t i = 0; i < law.coverage.size(); ++i) {
      auto const& c = law.coverage[i];
      text += whole_row(
          fmt::format("Bounds cover {:.1f}\\,\\% ({:.0f} to {:.0f}\\,\\%) in {}; {}", 100.0 * c.share_inside,
                      100.0 * c.interval_low, 100.0 * c.interval_high, latex_text(building::quantity(c.quantity).title),
                      latex_text(wording::sentence(building::covering_factors(c), study.units()))),
          columns);
    }
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace isolaw::render
