#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/drawn_samples.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::render {
namespace {

std::string loop_data(UnitSystem const& units, DeviceResult const& device, DeviceFit const& fit,
                      std::string const& about) {
  auto const& record = device.record;
  DataTable table;
  table.comment(about);
  table.comment(loop_units(record.has_time(), units));
  table.comment("time disp measured_force computed_force residual");
  for (auto const i : drawn_samples(record.size(), most_samples)) {
    double const measured = units.from_kN(record.force_kN[i]), computed = units.from_kN(fit.force_kN[i]);
    table.row(record.time_s[i], units.from_mm(record.disp_mm[i]), measured, computed, measured - computed);
  }
  return table.take();
}

std::string loop_script(UnitSystem const& units, std::string const& name, std::string const& about,
                        std::string const& title, bool has_time, std::size_t law) {
  constexpr double height_mm = 78.0, left = 14.0, split = 80.0, top = 7.0;
  Script script(name, about, double_column_mm, height_mm);
  auto const file = name + ".dat";
  script.line("set multiplot");
  script.line("set grid lc rgb '#e2e2e2' lt 1 lw 0.5");
  script.margins(left, double_column_mm - split, 9.5, top);
  script.line("set label 1 {} noenhanced at graph 0,1.03", gnuplot_string(shortened(title, split + 8.0)));
  script.line("set xlabel 'Displacement ({})' offset 0,raise; set ylabel 'Force ({})' offset inward,0",
              units.length.symbol, units.force.symbol);
  script.line("plot '{0}' using 2:3 with lines ls {1} dt 1 lw 1.6, '{0}' using 2:4 with lines ls {2}", file, grey,
              style_of(law));
  script.line("unset label 1");
  script.margins(split + 16.0, 3.0, 36.0, top);
  script.line("set key at graph 1,1.02 right bottom horizontal Left reverse width (kind eq 'svg' ? -2 : 1)");
  script.line("set xlabel ''; set format x ''");
  script.line(
      "plot '{0}' using 1:3 with lines ls {1} dt 1 lw 1.6 title 'measured', '{0}' using 1:4 with lines ls {2} title 'computed'",
      file, grey, style_of(law));
  script.line("unset key; set format x");
  script.margins(split + 16.0, 3.0, 9.5, height_mm - 33.5);
  script.line("set xlabel '{}' offset 0,raise; set ylabel 'Residual ({})' offset inward,0", time_label(has_time),
              units.force.symbol);
  script.line("plot 0 with lines ls {} lw 0.6, '{}' using 1:5 with lines ls {}", black, file, style_of(law));
  script.line("unset multiplot");
  return script.take();
}

}  // namespace

MaybeFigure loops_figure(Summary const& summary, DeviceResult const& device, LawResult const& law,
                         std::string const& stem) {
  auto const* fit = fit_of(law, device.name);
  auto const samples = device.record.size();
  if (fit == nullptr || samples == 0 || fit->force_kN.size() != samples) return std::nullopt;
  auto const name = "loops_" + stem + "_" + law.id;
  std::string const about = "measured and computed force, Fig. 5; residual is measured minus computed";
  return Figure{name, loop_data(summary.units(), device, *fit, about),
                loop_script(summary.units(), name, about, display_name(law) + ", " + device.name,
                            device.record.has_time(), place_in_summary(summary, law))};
}

}  // namespace isolaw::render
