#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "isolaw/num/statistics.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

constexpr std::size_t most_panels = 12;  // if there are more devices, they share one panel

struct Spread {
  MaybeNumber median, least, greatest;
};

Spread spread_of(std::vector<double> const& values) {
  if (values.empty()) return {};
  auto const [least, greatest] = std::ranges::minmax(values);
  return {num::median(values), least, greatest};
}

void add_found(std::vector<double>& found, DeviceFit const& fit, std::size_t step) {
  for (auto const& history : fit.histories) {
    if (history.empty()) continue;
    double const value = history[std::min(step, history.size() - 1)];
    if (std::isfinite(value)) found.push_back(value);
  }
}

std::vector<Spread> spreads(std::span<DeviceFit const* const> fits) {
  std::size_t steps = 0;
  for (auto const* fit : fits)
    for (auto const& history : fit->histories) steps = std::max(steps, history.size());
  std::vector<Spread> result;
  for (std::size_t step = 0; step < steps; ++step) {
    std::vector<double> found;
    for (auto const* fit : fits) add_found(found, *fit, step);
    result.push_back(spread_of(found));
  }
  return result;
}

void write_block(DataTable& table, std::string const& title, std::vector<Spread> const& steps) {
  table.comment(title);
  table.comment("step median least greatest");
  for (std::size_t i = 0; i < steps.size(); ++i) table.row(i + 1, steps[i].median, steps[i].least, steps[i].greatest);
  table.end_block();
}

Range range_of(std::vector<Spread> const& steps) {
  Range range;
  for (auto const& step : steps)
    for (auto const& value : {step.least, step.greatest})
      if (value && *value > 0.0) range.add(value);
  return range;
}

std::string_view name_of_steps(Summary const& summary) {
  auto const method = std::ranges::find(summary.settings, "method", &Setting::key);
  bool const descends = method != summary.settings.end() && method->json == "\"best\"";
  return descends ? "Descent" : "Generation";
}

struct Curves {
  std::string title;
  std::vector<Spread> steps;
};

std::string convergence_data(std::string const& about, std::vector<Curves> const& curves, std::string_view steps) {
  DataTable table;
  table.comment(about).comment("step: " + std::string(steps) + "; objectives are without a unit");
  for (auto const& curve : curves) write_block(table, curve.title, curve.steps);
  return table.take();
}

void draw_spread(Script& script, std::string const& file, std::size_t index, std::size_t law) {
  script.line("plot '{}' index {} using 1:3:4 with filledcurves lc rgb '{}' fs transparent solid 0.25 noborder, \\",
              file, index, law_looks[look_of(law)].colour);
  script.line("  '' index {} using 1:2 with lines ls {}", index, style_of(law));
}

std::string device_panels_script(std::string const& name, std::string const& about, std::vector<Curves> const& curves,
                                 std::string_view steps, std::size_t law) {
  auto const grid = grid_of(curves.size(), 30.0, {.left = 14.5, .right = 2.5, .bottom = 9.5, .top = 5.5});
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set multiplot");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    script.place(grid, i);
    script.line("set title {} noenhanced offset 0,-raise",
                gnuplot_string(shortened(curves[i].title, grid.panel_width_mm() + 8.0)));
    script.line("set xlabel '{}' offset 0,raise; set ylabel '{{/:Italic OF}} (-)' offset inward,0", steps);
    script.line("set xrange [1:{}]", std::max<std::size_t>(2, curves[i].steps.size()));
    set_log_axis(script, range_of(curves[i].steps));
    draw_spread(script, name + ".dat", i, law);
  }
  script.line("unset multiplot");
  return script.take();
}

std::string pooled_script(std::string const& name, std::string const& about, std::vector<Curves> const& curves,
                          std::string_view steps, std::size_t law) {
  Script script(name, about, single_column_mm, 62.0);
  script.margins(14.0, 3.0, 9.5, 7.0);
  script.line("set xlabel '{}' offset 0,raise; set ylabel '{{/:Italic OF}} (-)' offset inward,0", steps);
  script.line("set xrange [1:{}]", std::max<std::size_t>(2, curves.back().steps.size()));
  set_log_axis(script, range_of(curves.back().steps));
  script.line(
      "set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.6 width (kind eq 'svg' ? -1.5 : 1)");
  auto const all = curves.size() - 1;
  script.line(
      "plot '{}.dat' index {} using 1:3:4 with filledcurves lc rgb '{}' fs transparent solid 0.2 noborder title 'range', \\",
      name, all, law_looks[look_of(law)].colour);
  script.line("  for [i=0:{}] '' index i using 1:2 with lines lc rgb '#9a9a9a' lw 0.6 title (i==0?'devices':''), \\",
              all - 1);
  script.line("  '' index {} using 1:2 with lines ls {} lw 1.8 title 'median'", all, style_of(law));
  return script.take();
}

}  // namespace

MaybeFigure convergence_figure(Summary const& summary, LawResult const& law) {
  std::vector<Curves> curves;
  std::vector<DeviceFit const*> fits;
  for (auto const& fit : law.devices) {
    Curves curve{fit.device, spreads(std::array{&fit})};
    if (range_of(curve.steps).empty) continue;
    curves.push_back(std::move(curve));
    fits.push_back(&fit);
  }
  if (curves.empty()) return std::nullopt;
  auto const name = "convergence_" + law.id;
  auto const about = "best objective of " + law.id + " so far: median and range over the runs";
  auto const steps = name_of_steps(summary);
  bool const pooled = curves.size() > most_panels;
  if (pooled) curves.push_back({"all devices", spreads(fits)});
  auto const place = place_in_summary(summary, law);
  return Figure{name, convergence_data(about, curves, steps),
                pooled ? pooled_script(name, about, curves, steps, place)
                       : device_panels_script(name, about, curves, steps, place)};
}

}  // namespace isolaw::render
