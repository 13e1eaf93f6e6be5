#include "isolaw/render/figures/device_panels.hpp"

#include <algorithm>

#include "isolaw/base/json.hpp"

namespace isolaw::render {
namespace {

Range range_of(DevicePanel const& panel) {
  Range range;
  for (auto const& point : panel.points) {
    auto const& [mean, std, best] = point.value;
    if (!mean) continue;
    range.add(*mean - std.value_or(0.0));
    range.add(*mean + std.value_or(0.0));
  }
  range.add(panel.reference);
  return range.padded(0.1);
}

// Draws a panel. Error bars are drawn as vectors, because gnuplot's own error bars leave a gap around the marker.
void draw_panel(Script& script, std::string const& file, std::size_t index, DevicePanel const& panel,
                DeviceAxis const& axis) {
  auto const range = range_of(panel);
  auto const scale = scale_for(range, panel.name, panel.unit);
  auto const in_unit = [&](double value) { return number(value / scale.factor); };
  script.line("set title {} noenhanced offset 0,-raise", gnuplot_string(panel.title));
  script.line("set ylabel {} offset inward,0", scale.label);
  script.line("set yrange [{}:{}]", in_unit(range.low), in_unit(range.high));
  bool const has_percent = panel.reference && *panel.reference != 0.0;
  if (has_percent) {
    script.line("set y2range [{}:{}]", number(*percent_of(range.low, panel.reference)),
                number(*percent_of(range.high, panel.reference)));
    script.line("set y2tics; set ytics nomirror; set y2label 'Difference (%)' offset -inward,0");
  } else {
    script.line("unset y2tics; unset y2label; set ytics mirror");
  }
  axis.draw(script);
  auto const column = [&](int k) {
    return scale.factor == 1.0 ? fmt::format("(${})", k) : fmt::format("(${}/{})", k, number(scale.factor));
  };
  std::string plot = "plot ";
  if (panel.reference) plot += fmt::format("{} with lines ls {} dt 3, ", in_unit(*panel.reference), black);
  script.line("{}'{}' index {} using 1:({}-{}):(0):(2*{}) with vectors heads size 0.2,90 fixed ls {} dt 1, \\", plot,
              file, index, column(3), column(4), column(4), style_of(panel.law));
  script.line("  '' index {} using 1:{}{} with points {}", index, column(3), axis.using_suffix(),
              marked_style(panel.law));
}

}  // namespace

MaybeNumber percent_of(MaybeNumber const& value, MaybeNumber const& reference) {
  if (!value || !reference || *reference == 0.0) return std::nullopt;
  return 100.0 * (*value - *reference) / *reference;
}

bool has_values(DevicePanel const& panel) {
  return std::ranges::any_of(panel.points, [](auto const& point) { return point.value.mean.has_value(); });
}

void write_block(DataTable& table, DevicePanel const& panel) {
  auto const what = panel.title.empty() ? panel.name : panel.title + " " + panel.name;
  table.comment(what + " in " + panel.unit +
                (panel.reference ? ", mean of the devices " + to_text(panel.reference) : std::string()));
  table.comment("number device mean std difference_from_the_mean_percent");
  for (std::size_t i = 0; i < panel.points.size(); ++i) {
    auto const& point = panel.points[i];
    table.row(i + 1, point.device, point.value.mean, point.value.std, point.percent);
  }
  table.end_block();
}

Figure figure_over_devices(std::string const& name, std::string const& about, std::vector<std::string> const& devices,
                           std::size_t panels, PanelsOverDevices layout, DrawPanel const& draw) {
  DeviceAxis const axis(devices, grid_of(panels, 0.0, layout.margins, layout.columns).panel_width_mm());
  layout.margins.bottom += axis.label_mm;
  auto const grid = grid_of(panels, layout.height_mm, layout.margins, layout.columns);
  DataTable table;
  table.comment(about);
  Script script(name, about, grid.width_mm, grid.height_mm());
  if (!layout.setting.empty()) script.line("{}", layout.setting);
  script.line("set multiplot");
  for (std::size_t i = 0; i < panels; ++i) {
    script.place(grid, i);
    draw(table, script, i, axis);
  }
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

MaybeFigure panels_figure(std::string const& name, std::string const& about, std::vector<DevicePanel> const& panels) {
  if (panels.empty()) return std::nullopt;
  auto const& points = panels.front().points;
  std::vector<std::string> devices;
  for (auto const& point : points) devices.push_back(point.device);
  return figure_over_devices(name, about, devices, panels.size(),
                             {.margins = {.left = 14.5, .right = 13.0, .bottom = 7.5, .top = 5.0},
                              .columns = devices.size() <= 16   ? 3
                                         : devices.size() <= 80 ? 2
                                                                : 1},
                             [&](DataTable& table, Script& script, std::size_t i, DeviceAxis const& axis) {
                               write_block(table, panels[i]);
                               draw_panel(script, name + ".dat", i, panels[i], axis);
                             });
}

}  // namespace isolaw::render
