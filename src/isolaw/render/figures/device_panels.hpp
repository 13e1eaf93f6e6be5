// Draws panels over the devices of the lot. Each panel shows one quantity, with error bars and the difference from the
// mean.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {

struct DevicePoint {
  std::string device;
  Statistic value;  // if it holds no number, the plot has a gap
  MaybeNumber percent;
};

struct DevicePanel {
  std::string title = {};      // heading above the panel; may be empty
  std::string name, unit;      // name and unit of the quantity
  MaybeNumber reference = {};  // mean over the devices; percentages are differences from it
  std::size_t law = 0;         // index of the law in Summary::laws
  std::vector<DevicePoint> points = {};
};

MaybeNumber percent_of(MaybeNumber const& value, MaybeNumber const& reference);
bool has_values(DevicePanel const& panel);
void write_block(DataTable& table, DevicePanel const& panel);

struct PanelsOverDevices {
  double height_mm = 30.0;
  Margins margins;  // margins of a panel; room for the devices' names is added to `bottom`
  int columns = 3;
  std::string setting = {};  // a line of gnuplot's script that stands before the panels
};
using DrawPanel = std::function<void(DataTable&, Script&, std::size_t panel, DeviceAxis const&)>;
// Makes a figure of panels that have the devices along their x axes. `draw` writes the data of a panel and plots them.
Figure figure_over_devices(std::string const& name, std::string const& about, std::vector<std::string> const& devices,
                           std::size_t panels, PanelsOverDevices layout, DrawPanel const& draw);

MaybeFigure panels_figure(std::string const& name, std::string const& about, std::vector<DevicePanel> const& panels);

}  // namespace isolaw::render
