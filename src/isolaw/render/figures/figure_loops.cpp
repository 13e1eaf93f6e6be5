#include <algorithm>

#include "isolaw/base/words.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/drawn_samples.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::render {
namespace {

struct LoopPanel {
  std::string title;
  DeviceFit const* fit = nullptr;  // null if there is no loop to draw
  std::string absence;             // why there is no loop
  std::size_t law = 0;             // index of the law in Summary::laws
};

LoopPanel loop_panel(DeviceResult const& device, LawResult const& law) {
  auto const* fit = fit_of(law, device.name);
  if (fit != nullptr && fit_status(*fit) == "ok" && fit->force_kN.size() == device.record.size())
    return {fmt::format("{}: OF = {:.4f}", display_name(law), fit->objective.best.value_or(0.0)), fit, {}};
  if (fit == nullptr) return {display_name(law), nullptr, "not tried"};
  auto reason = fit->refusal.empty() ? fit->failure : fit->refusal;
  constexpr std::size_t most = 60;  // a panel has room for this many bytes
  if (reason.size() > most) reason = reason.substr(0, reason.find_last_of(' ', most)) + " ...";
  return {display_name(law), nullptr, std::string(fit_status(*fit)) + (reason.empty() ? "" : ": " + reason)};
}

std::string loops_data(UnitSystem const& units, DeviceResult const& device, std::vector<LoopPanel> const& panels,
                       std::string const& about) {
  auto const& record = device.record;
  DataTable table;
  table.comment(about);
  table.comment(loop_units(record.has_time(), units));
  table.comment("computed forces in the order of the panels; NaN if a law has no fit");
  for (auto const& panel : panels) table.comment(panel.title + (panel.fit == nullptr ? ", " + panel.absence : ""));
  table.comment("time disp measured_force computed_force ...");
  for (auto const i : drawn_samples(record.size(), most_samples)) {
    std::vector<MaybeNumber> computed;
    for (auto const& panel : panels)
      computed.push_back(panel.fit == nullptr ? MaybeNumber() : MaybeNumber(units.from_kN(panel.fit->force_kN[i])));
    table.row(record.time_s[i], units.from_mm(record.disp_mm[i]), units.from_kN(record.force_kN[i]), computed);
  }
  return table.take();
}

std::vector<std::string> lines_of(std::string_view text, double width_mm) {
  constexpr std::size_t most_lines = 6;
  std::vector<std::string> lines{""};
  while (!text.empty()) {
    auto const word = take_part(text, ' ');
    double const wide = letter_mm * static_cast<double>(lines.back().size() + 1 + word.size());
    if (wide > width_mm && !lines.back().empty()) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  if (lines.size() > most_lines) {
    lines.resize(most_lines);
    lines.back() += " …";
  }
  for (auto& line : lines) line = shortened(line, width_mm);
  return lines;
}

void draw_absence(Script& script, LoopPanel const& panel, double width_mm) {
  auto const lines = lines_of(panel.absence, width_mm);
  double const middle = 0.5 * (static_cast<double>(lines.size()) - 1.0);
  for (std::size_t i = 0; i < lines.size(); ++i)
    script.line("set label {} {} noenhanced at graph 0.5,0.5 center offset 0,{}", i + 2, gnuplot_string(lines[i]),
                number(middle - static_cast<double>(i)));
  script.line("unset grid");
  script.line("plot NaN");
  for (std::size_t i = 0; i < lines.size(); ++i) script.line("unset label {}", i + 2);
}

// Draws the device's name and the key of the curves in a strip above all panels, because the key is wider than a panel.
void draw_head(Script& script, Grid const& grid, std::string const& device, std::size_t law) {
  constexpr double key_mm = 45.0;
  script.margins(grid.margins.left, grid.margins.right, grid.height_mm() - grid.head_mm, 0.5);
  // gnuplot would otherwise keep the settings of the panels that were drawn before.
  script.line("unset border; unset tics; unset grid; unset title; unset xlabel; unset ylabel");
  script.line("set xrange [0:1]; set yrange [0:1]");
  script.line("set label 1 {} noenhanced at graph 0,0.5",
              gnuplot_string(shortened(device, grid.width_mm - grid.margins.left - key_mm)));
  script.line("set key at graph 1,0.5 right center horizontal Left reverse width (kind eq 'svg' ? -1 : 1)");
  script.line("plot NaN with lines ls {} dt 1 lw 1.6 title 'measured', NaN with lines ls {} title 'computed'", grey,
              style_of(law));
  script.line("unset key; unset label 1; set border 31 lw 0.8; set tics scale 0.6");
}

std::string loops_script(UnitSystem const& units, std::string const& name, std::string const& about,
                         DeviceResult const& device, std::vector<LoopPanel> const& panels) {
  auto grid = grid_of(panels.size(), 32.0, {.left = 13.0, .right = 3.0, .bottom = 9.0, .top = 5.0});
  grid.head_mm = 5.0;
  Range disp, force;
  for (double const x : device.record.disp_mm) disp.add(units.from_mm(x));
  for (double const f : device.record.force_kN) force.add(units.from_kN(f));
  // The axis extends beyond the measured forces by half their range on each side. The loop of a law with larger forces
  // is cut off there.
  double const spare = 0.5 * (force.high - force.low), lowest = force.low - spare, highest = force.high + spare;
  for (auto const& panel : panels)
    if (panel.fit != nullptr)
      for (double const f : panel.fit->force_kN) force.add(std::clamp(units.from_kN(f), lowest, highest));
  disp = disp.padded(0.05);
  force = force.padded(0.05);
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set multiplot");
  draw_head(script, grid, device.name, panels.front().law);
  script.line("set xrange [{}:{}]; set yrange [{}:{}]", number(disp.low), number(disp.high), number(force.low),
              number(force.high));
  if (disp.high > disp.low) script.line("set xtics {}", number(nice_step(disp.high - disp.low, 4)));
  script.line("set xlabel 'Displacement ({})' offset 0,raise; set ylabel 'Force ({})' offset inward,0",
              units.length.symbol, units.force.symbol);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    script.place(grid, i);
    script.line("set grid lc rgb '#e2e2e2' lt 1 lw 0.5");
    script.line("set title {} noenhanced offset 0,-raise", gnuplot_string(panels[i].title));
    if (panels[i].fit == nullptr)
      draw_absence(script, panels[i], grid.panel_width_mm());
    else
      script.line("plot '{0}.dat' using 2:3 with lines ls {1} dt 1 lw 1.6, '' using 2:{2} with lines ls {3}", name,
                  grey, i + 4, style_of(panels[i].law));
  }
  script.line("unset multiplot");
  return script.take();
}

}  // namespace

MaybeFigure loops_of_laws_figure(Summary const& summary, DeviceResult const& device, std::string const& stem) {
  if (device.record.size() == 0) return std::nullopt;
  std::vector<LoopPanel> panels;
  for (auto const law : by_objective(summary)) {
    panels.push_back(loop_panel(device, summary.laws[law]));
    panels.back().law = law;
  }
  if (std::ranges::none_of(panels, [](auto const& panel) { return panel.fit != nullptr; })) return std::nullopt;
  auto const name = "loops_" + stem;
  std::string const about =
      "measured and computed loop of every law on a device, Fig. 5; OF is the objective of the best run";
  return Figure{name, loops_data(summary.units(), device, panels, about),
                loops_script(summary.units(), name, about, device, panels)};
}

}  // namespace isolaw::render
