#include <algorithm>
#include <array>
#include <cmath>

#include "isolaw/base/symbol.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/render/figures/conditions_figures.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

using conditions::Status;

constexpr std::array statuses{Status::shown,    Status::interpolated, Status::extrapolated,
                              Status::unpaired, Status::scaled,       Status::assumed};
constexpr int style_of_status(Status status) {
  switch (status) {
    case Status::shown:
      return green;
    case Status::interpolated:
      return blue;
    case Status::extrapolated:
      return vermillion;
    case Status::unpaired:
    case Status::scaled:
      return sky;
    default:
      return black;
  }
}

struct FactorBar {
  std::string effect;
  double lambda = 1.0;
  Status status = Status::shown;
  std::size_t row = 0;
};

struct FactorBars {
  rules::Quantity quantity;
  std::vector<std::string> rows = {};
  std::vector<FactorBar> bars = {};
  std::vector<std::size_t> not_covered = {};  // indices in `rows` of the effects that no test covers
};

FactorBars bars_of(ConditionsResult const& result, BoundRow const& bound) {
  FactorBars all{.quantity = bound.quantity};
  auto const add = [&](std::string const& effect, double max, Status max_status, double min, Status min_status) {
    all.bars.push_back({effect, max, max_status, all.rows.size()});
    all.bars.push_back({effect, min, min_status, all.rows.size()});
    all.rows.push_back(effect);
  };
  for (auto const& row : result.design) {
    if (row.quantity != bound.quantity) continue;
    auto const effect = std::string(name(row.effect));
    if (row.max.status == Status::not_covered) {
      all.not_covered.push_back(all.rows.size());
      all.rows.push_back(effect);
    } else {
      add(effect, row.max.lambda(), row.max.status, row.min.lambda(), row.min.status);
    }
  }
  add("all together", bound.max.factor, bound.max.status, bound.min.factor, bound.min.status);
  return all;
}

// Returns the symbol of a property, such as K_eff, or its name if it has no symbol.
std::string title_of(rules::Quantity quantity) {
  auto const name = rules::name(quantity);
  bool const is_symbol = name.find('_') != std::string_view::npos;
  return gnuplot_string(is_symbol ? gnuplot_symbol(name) : std::string(name));
}

}  // namespace

MaybeFigure factors_figure(ConditionsResult const& result) {
  constexpr std::size_t most = 2;  // number of properties drawn: the first two, K_eff and energy
  std::vector<FactorBars> panels;
  for (auto const& bound : result.bounds)
    if (panels.size() < most) panels.push_back(bars_of(result, bound));
  if (panels.empty()) return std::nullopt;
  std::string const name = "factors";
  std::string const about = "largest and smallest factor of each effect over the design conditions";
  Margins const margins{.left = 18.0, .right = 4.0, .bottom = 9.0, .top = 9.0};
  constexpr double row_mm = 5.0;
  auto const grid = grid_of(panels.size(), row_mm * static_cast<double>(panels.front().rows.size()), margins, 2);
  Range range;
  range.add(1.0);
  for (auto const& panel : panels)
    for (auto const& bar : panel.bars) range.add(bar.lambda);
  auto const padded = range.padded_log(0.3);  // room for the numbers beside the bars
  DataTable table;
  table.comment(about);
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set multiplot");
  script.line("set logscale x; set xrange [{}:{}]; set xtics nomirror (0.2,0.3,0.4,0.6,0.8,1,1.2,1.5,2,3,4,5)",
              number(padded.low), number(padded.high));
  script.line("set style fill solid 0.8 noborder");
  script.line(
      "set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.2 width (kind eq 'svg' ? -1.5 : 1)");
  script.line("set xlabel 'Factor (-)' offset 0,raise");
  script.line("set arrow 1 from first 1,graph 0 to first 1,graph 1 nohead front ls {} dt 1 lw 0.6", black);
  std::size_t block = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    auto const& panel = panels[p];
    std::vector<std::string> plots, tics;
    for (std::size_t i = 0; i < panel.rows.size(); ++i) tics.push_back(fmt::format("'{}' {}", panel.rows[i], i));
    for (auto const status : statuses) {
      auto const is_here = [&](FactorBar const& bar) { return bar.status == status && bar.lambda != 1.0; };
      if (std::ranges::none_of(panel.bars, is_here)) continue;
      table.comment(fmt::format("{}, {}: row effect factor", rules::name(panel.quantity), conditions::name(status)));
      for (auto const& bar : panel.bars)
        if (is_here(bar)) table.row(bar.row, bar.effect, bar.lambda);
      table.end_block();
      auto const title = status == Status::assumed ? "ASSUMED" : conditions::name(status);
      plots.push_back(fmt::format(
          "'{}.dat' index {} using 3:1:($3<1?$3:1):($3<1?1:$3):($1-0.32):($1+0.32) with boxxyerror ls {} title '{}'",
          name, block, style_of_status(status), title));
      for (auto const* side : {"($3>1?$3*1.02:NaN):1:(sprintf('%.3f',$3)) with labels left",
                               "($3<1?$3/1.02:NaN):1:(sprintf('%.3f',$3)) with labels right"})
        plots.push_back(fmt::format("'{}.dat' index {} using {} notitle", name, block, side));
      ++block;
    }
    script.place(grid, p);
    script.line("unset label; set yrange [{}:-0.6]; set ytics scale 0 noenhanced ({})",
                number(static_cast<double>(panel.rows.size()) - 0.4), joined(tics));
    script.line("set label 100 {} at graph 1,1.06 right", title_of(panel.quantity));
    for (std::size_t const row : panel.not_covered)
      script.line("set label {} ' NOT COVERED' at first 1,first {} left", row + 1, row);
    plots.push_back("NaN notitle");  // gnuplot needs something to plot, also if all factors are 1 and no bar is drawn
    script.line("plot {}", joined(plots));
  }
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

}  // namespace isolaw::render
