#include <algorithm>

#include "isolaw/render/figures/device_panels.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::render {
namespace {

DevicePanel objective_panel(Summary const& summary, std::size_t place, std::vector<std::string> const& devices) {
  auto const& law = summary.laws[place];
  DevicePanel panel{
      .title = display_name(law), .name = "OF", .unit = "-", .reference = law.objective.mean, .law = place};
  for (auto const& device : devices) {
    auto const* fit = fit_of(law, device);
    DevicePoint point{device, {}, {}};
    if (fit != nullptr) point.value = fit->objective;
    point.percent = percent_of(point.value.mean, panel.reference);
    panel.points.push_back(std::move(point));
  }
  return panel;
}

std::vector<DevicePanel> objective_panels(Summary const& summary) {
  auto const devices = device_names(summary);
  std::vector<DevicePanel> panels;
  for (auto const law : by_objective(summary)) panels.push_back(objective_panel(summary, law, devices));
  return panels;
}

struct ObjectiveRanges {
  Range mean, std, percent;
};

ObjectiveRanges ranges_of(std::vector<DevicePanel> const& laws) {
  ObjectiveRanges ranges;
  ranges.mean.add(0.0);
  for (auto const& law : laws)
    for (auto const& point : law.points) {
      if (!point.value.mean) continue;
      ranges.mean.add(*point.value.mean + point.value.std.value_or(0.0));
      if (point.value.std && *point.value.std > 0.0) ranges.std.add(point.value.std);
      ranges.percent.add(point.percent);
    }
  return ranges;
}

// Returns gnuplot's expression for the x coordinate of a device. Law number k has an interval around k on the axis. The
// devices stand side by side in this interval.
std::string place_in_law(std::size_t law, std::size_t devices) {
  return fmt::format("({}+0.8*($1-{})/{})", law + 1, number((static_cast<double>(devices) + 1.0) / 2.0), devices);
}

void plot_laws(Script& script, std::string const& file, std::vector<DevicePanel> const& laws, int column,
               bool with_bars) {
  for (std::size_t i = 0; i < laws.size(); ++i) {
    auto const x = place_in_law(i, laws[i].points.size());
    std::string const start = i == 0 ? "plot " : "  ";
    if (with_bars)
      script.line(
          "{}'{}' index {} using {}:($3-$4):(0):(2*$4) with vectors heads size {},90 fixed ls {} dt 1 lw 0.8, \\",
          start, file, i, x, number(0.2 / static_cast<double>(laws[i].points.size())), style_of(laws[i].law));
    script.line("{}'{}' index {} using {}:{} with points {}{}", with_bars ? "  " : start, file, i, x, column,
                marked_style(laws[i].law), i + 1 < laws.size() ? ", \\" : "");
  }
}

std::string objective_script(std::string const& name, std::string const& about, std::vector<DevicePanel> const& laws) {
  auto const ranges = ranges_of(laws);
  std::size_t const panels = ranges.std.empty ? 2 : 3;
  Grid const grid{.columns = 1,
                  .rows = static_cast<int>(panels),
                  .width_mm = double_column_mm,
                  .panel_height_mm = 34.0,
                  .margins = {.left = 16.0, .right = 3.0, .bottom = 9.5, .top = 2.5}};
  Script script(name, about, grid.width_mm, grid.height_mm());
  std::vector<std::string> names;
  for (auto const& law : laws) names.push_back(law.title);
  draw_law_axis(script, names);
  script.line("set multiplot");
  std::size_t panel = 0;
  script.place(grid, panel++);
  script.line("set ylabel '{{/:Italic OF}}, mean (-)' offset inward,0; set yrange [0:{}]",
              number(ranges.mean.padded(0.08).high));
  plot_laws(script, name + ".dat", laws, 3, true);
  if (!ranges.std.empty) {
    script.place(grid, panel++);
    script.line("set ylabel '{{/:Italic OF}}, standard deviation (-)' offset inward,0");
    set_log_axis(script, ranges.std);
    plot_laws(script, name + ".dat", laws, 4, false);
    script.line("unset logscale y; set ytics autofreq");
  }
  script.place(grid, panel);
  auto const percent = ranges.percent.padded(0.1);
  script.line("set ylabel 'Difference (%)' offset inward,0; set yrange [{}:{}]", number(percent.low),
              number(percent.high));
  script.line("set arrow 100 from graph 0,first 0 to graph 1,first 0 nohead ls {} dt 3", black);
  plot_laws(script, name + ".dat", laws, 5, false);
  script.line("unset multiplot");
  return script.take();
}

}  // namespace

MaybeFigure objective_figure(Summary const& summary) {
  auto const laws = objective_panels(summary);
  if (std::ranges::none_of(laws, has_values)) return std::nullopt;
  std::string const name = "objective";
  std::string const about =
      "objective of every law on every device over the runs, and each device against the law's mean, Figs. 6 and 7";
  DataTable table;
  table.comment(about);
  for (auto const& law : laws) write_block(table, law);
  return Figure{name, table.take(), objective_script(name, about, laws)};
}

MaybeFigure objective_by_device_figure(Summary const& summary) {
  auto panels = objective_panels(summary);
  std::erase_if(panels, [](auto const& panel) { return !has_values(panel); });
  return panels_figure("objective_by_device", "objective of each device against the mean over the devices, Fig. 7",
                       panels);
}

}  // namespace isolaw::render
