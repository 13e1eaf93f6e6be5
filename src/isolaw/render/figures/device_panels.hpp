// Panels that each show one quantity over the devices of the lot, with error bars and the difference from the mean.
#pragma once

#include <string>
#include <vector>

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
  std::string title = {};      // written above the panel; may be empty
  std::string name, unit;      // name and unit of the quantity
  MaybeNumber reference = {};  // mean over the devices; percentages are differences from it
  std::size_t law = 0;         // the law's place in the summary
  std::vector<DevicePoint> points = {};
};

MaybeNumber percent_of(MaybeNumber const& value, MaybeNumber const& reference);
bool has_values(DevicePanel const& panel);
void write_block(DataTable& table, DevicePanel const& panel);

MaybeFigure panels_figure(std::string const& name, std::string const& about, std::vector<DevicePanel> const& panels);

}  // namespace isolaw::render
