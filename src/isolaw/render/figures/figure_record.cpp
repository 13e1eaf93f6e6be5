#include <span>

#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/drawn_samples.hpp"

namespace isolaw::render {
namespace {

void write_history(UnitSystem const& units, DataTable& table, std::string_view title, std::span<double const> time,
                   std::span<double const> disp_mm, std::span<double const> force_kN) {
  table.comment(title);
  table.comment(
      fmt::format("{} disp_{} force_{}", time.empty() ? "sample" : "time_s", units.length.symbol, units.force.symbol));
  for (auto const i : drawn_samples(disp_mm.size(), most_samples))
    table.row(time.empty() ? static_cast<double>(i) : time[i], units.from_mm(disp_mm[i]), units.from_kN(force_kN[i]));
  table.end_block();
}

std::string record_script(UnitSystem const& units, std::string const& name, std::string const& about,
                          std::string const& title, bool has_time) {
  Grid const grid{.columns = 1,
                  .rows = 2,
                  .width_mm = double_column_mm,
                  .panel_height_mm = 36.0,
                  .margins = {.left = 14.0, .right = 3.0, .bottom = 9.5, .top = 6.0}};
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set xlabel '{}' offset 0,raise", time_label(has_time));
  script.line("set grid lc rgb '#e2e2e2' lt 1 lw 0.5");
  script.line("set key at graph 1,1.02 right bottom horizontal Left reverse width (kind eq 'svg' ? -2 : 1)");
  script.line("set multiplot");
  for (std::size_t i = 0; i < 2; ++i) {
    script.place(grid, i);
    script.line("set ylabel '{} ({})' offset inward,0", i == 0 ? "Displacement" : "Force",
                i == 0 ? units.length.symbol : units.force.symbol);
    if (i == 0) script.line("set label 1 {} noenhanced at graph 0,1.06", gnuplot_string(shortened(title, 100.0)));
    script.line(
        "plot '{0}.dat' index 0 using 1:{1} with lines ls {2} dt 1 lw 2 title 'before cleaning', '' index 1 using 1:{1} with lines ls {3} dt 2 title 'after cleaning'",
        name, i + 2, grey, vermillion);
    if (i == 0) script.line("unset label 1; unset key");
  }
  script.line("unset multiplot");
  return script.take();
}

}  // namespace

MaybeFigure record_figure(UnitSystem const& units, DeviceResult const& device, std::string const& stem) {
  if (device.raw.size() == 0 || device.record.size() == 0) return std::nullopt;
  auto const name = "record_" + stem;
  std::string const about = "a record before and after cleaning, Fig. 4";
  DataTable table;
  table.comment(about);
  write_history(units, table, "before cleaning", device.raw.time_s, device.raw.disp_mm, device.raw.force_kN);
  write_history(units, table, "after cleaning", device.record.time_s, device.record.disp_mm, device.record.force_kN);
  return Figure{name, table.take(), record_script(units, name, about, device.name, device.record.has_time())};
}

}  // namespace isolaw::render
