#include <algorithm>
#include <array>

#include "isolaw/render/figures/device_panels.hpp"

namespace isolaw::render {
namespace {

// Returns the values of a device that the rule set assesses: one value, or one for each side of the loop. Without such
// values it returns the value of the cycle that counting_cycle() (study/acceptance.hpp) chooses, usually the third.
std::vector<double> property_values(DeviceResult const& device, rules::Quantity quantity) {
  std::vector<double> values;
  for (auto const& assessment : device.acceptance.assessments)
    if (assessment.value && rules::is_of(assessment, quantity)) values.push_back(*assessment.value);
  if (!values.empty()) return values;
  auto const* cycle = counting_cycle(device.properties, device.acceptance.block);
  if (cycle == nullptr) return {};
  return {quantity == rules::Quantity::K_eff ? cycle->K_eff_kN_per_mm : cycle->damping_percent};
}

struct PropertyLimits {
  MaybeNumber design, lower, upper;
};

PropertyLimits limits_of(Summary const& summary, rules::Quantity quantity) {
  PropertyLimits limits;
  limits.design = summary.acceptance.design.value(quantity);
  if (!limits.design) return limits;
  for (auto const& limit : summary.acceptance.rules.limits) {
    if (limit.quantity != quantity || limit.scope != rules::Scope::each) continue;
    if (limit.lower_percent) limits.lower = *limits.design * (1.0 + *limit.lower_percent / 100.0);
    if (limit.upper_percent) limits.upper = *limits.design * (1.0 + *limit.upper_percent / 100.0);
  }
  return limits;
}

struct PropertyPanel {
  std::string name, label, unit;
  PropertyLimits limits;
  std::vector<std::vector<double>> values = {};  // [device][one value or two sides]
};

PropertyPanel property_panel(Summary const& summary, rules::Quantity quantity, std::string label) {
  auto const shown = shown_unit(rules::unit(quantity), summary.units());
  PropertyPanel panel{.name = std::string(rules::name(quantity)),
                      .label = std::move(label),
                      .unit = shown.unit,
                      .limits = limits_of(summary, quantity)};
  for (auto const& device : summary.devices)
    if (device.status == "ok") panel.values.push_back(property_values(device, quantity));
  for (auto& values : panel.values)
    for (double& value : values) value *= shown.factor;
  for (auto* limit : {&panel.limits.design, &panel.limits.lower, &panel.limits.upper})
    if (*limit) **limit *= shown.factor;
  return panel;
}

void write_block(DataTable& table, PropertyPanel const& panel, std::vector<std::string> const& devices) {
  auto const& limits = panel.limits;
  table.comment(panel.name + " in " + panel.unit + "; design value and limits of each device, where there are any");
  table.comment("number device value value_of_the_other_side design lower_limit upper_limit");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    auto const& values = panel.values[i];
    auto const at = [&](std::size_t k) { return k < values.size() ? MaybeNumber(values[k]) : std::nullopt; };
    table.row(i + 1, devices[i], at(0), at(1), limits.design, limits.lower, limits.upper);
  }
  table.end_block();
}

void draw_panel(Script& script, std::string const& file, std::size_t index, PropertyPanel const& panel,
                DeviceAxis const& axis) {
  Range range;
  bool has_sides = false;
  for (auto const& values : panel.values) {
    has_sides = has_sides || values.size() > 1;
    for (double const value : values) range.add(value);
  }
  for (auto const& value : {panel.limits.design, panel.limits.lower, panel.limits.upper}) range.add(value);
  range = range.padded(0.1);
  script.line("set ylabel '{} ({})' offset inward,0", panel.label, panel.unit);
  script.line("set yrange [{}:{}]", number(range.low), number(range.high));
  axis.draw(script);
  std::string plot;
  if (panel.limits.design) plot += fmt::format("{} ls {} title 'design value', ", number(*panel.limits.design), black);
  bool titled = false;
  for (auto const& limit : {panel.limits.lower, panel.limits.upper})
    if (limit) {
      plot += fmt::format("{} ls {} dt 2 title '{}', ", number(*limit), vermillion, titled ? "" : "limits");
      titled = true;
    }
  plot += fmt::format("'{}' index {} using 1:3{} with points ls {} title '{}'", file, index, axis.using_suffix(), blue,
                      has_sides ? "positive side" : "devices");
  if (has_sides)
    plot += fmt::format(", '{}' index {} using 1:4 with points ls {} title 'negative side'", file, index, sky);
  script.line("plot {}", plot);
}

}  // namespace

MaybeFigure properties_figure(Summary const& summary) {
  std::array const panels{property_panel(summary, rules::Quantity::K_eff, "{/:Italic K}_{eff}"),
                          property_panel(summary, rules::Quantity::damping, "Damping ξ")};
  bool const has_values = std::ranges::any_of(panels, [](auto const& panel) {
    return std::ranges::any_of(panel.values, [](auto const& values) { return !values.empty(); });
  });
  if (!has_values) return std::nullopt;
  std::string const name = "properties";
  std::string const about = "effective stiffness and equivalent viscous damping of every device";
  auto const devices = device_names(summary);
  return figure_over_devices(
      name, about, devices, panels.size(),
      {.height_mm = 42.0,
       .margins = {.left = 14.0, .right = 3.0, .bottom = 7.5, .top = 9.0},
       .setting =
           "set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.6 width (kind eq 'svg' ? -1.5 : 1)"},
      [&](DataTable& table, Script& script, std::size_t i, DeviceAxis const& axis) {
        write_block(table, panels[i], devices);
        draw_panel(script, name + ".dat", i, panels[i], axis);
      });
}

}  // namespace isolaw::render
