// The figures of the lot and its laws.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/front_view.hpp"

namespace isolaw::render {
namespace {

using MaybeNumber = std::optional<double>;

// Devices that were read, in the order of the summary: the same axis in every figure.
std::vector<std::string> device_names(Summary const& summary) {
  std::vector<std::string> names;
  for (auto const& device : summary.devices)
    if (device.status == "ok") names.push_back(device.name);
  return names;
}

DeviceFit const* fit_of(LawResult const& law, std::string const& device) {
  auto const fit = std::ranges::find(law.devices, device, &DeviceFit::device);
  return fit == law.devices.end() ? nullptr : &*fit;
}

// --- a panel over devices --------------------------------------------------------------------------------------------

struct DevicePoint {
  std::string device;
  Statistic value;  // all empty: a gap
  MaybeNumber percent;
};

struct DevicePanel {
  std::string title;       // drawn above; may be empty
  std::string name, unit;  // of the quantity
  MaybeNumber reference;   // mean of the devices, which percentages are of
  std::vector<DevicePoint> points;
};

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
    table.cell(i + 1).cell(point.device).cell(point.value.mean).cell(point.value.std).cell(point.percent).end_row();
  }
  table.end_block();
}

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

// Error bars are vectors: those of gnuplot leave a gap about the marker.
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
              file, index, column(3), column(4), column(4), blue);
  script.line("  '' index {} using 1:{}{} with points ls {}", index, column(3), axis.using_suffix(), blue);
}

MaybeFigure panels_figure(std::string const& name, std::string const& about, std::vector<DevicePanel> const& panels) {
  if (panels.empty()) return std::nullopt;
  auto const& points = panels.front().points;
  std::vector<std::string> devices;
  for (auto const& point : points) devices.push_back(point.device);
  Margins margins{.left = 14.5, .right = 13.0, .bottom = 0.0, .top = 5.0};
  int const columns = devices.size() <= 16 ? 3 : devices.size() <= 80 ? 2 : 1;
  DeviceAxis const axis(devices, grid_of(panels.size(), 0.0, margins, columns).panel_width_mm());
  margins.bottom = 7.5 + axis.label_mm;
  auto const grid = grid_of(panels.size(), 30.0, margins, columns);

  DataTable table;
  table.comment(about);
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set multiplot");
  for (std::size_t i = 0; i < panels.size(); ++i) {
    write_block(table, panels[i]);
    script.place(grid, i);
    draw_panel(script, name + ".dat", i, panels[i], axis);
  }
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

// --- accuracy against robustness -------------------------------------------------------------------------------------

struct FrontWords {
  std::string name, about, x_label, y_label, columns;
};

FrontWords words_of(FrontView view) {
  switch (view) {
    case FrontView::published:
      return {"front", "accuracy (mean objective) against robustness (beta), Fig. 14", "Robustness index β (-)",
              "Mean objective {/:Italic OF} (-)", "law beta mean_OF on_front"};
    case FrontView::converged:
      return {"front_converged", "accuracy against robustness without the optimiser's noise",
              "β of the least objectives (-)", "Least objective {/:Italic OF} (-)",
              "law beta_converged least_OF on_front"};
    case FrontView::left_out:
      break;
  }
  return {"front_left_out", "least objective against the objective on devices left out",
          "{/:Italic OF} on a device by the law of all others (-)", "Least objective {/:Italic OF} (-)",
          "law OF_on_devices_left_out least_OF on_front"};
}

struct Box {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;  // mm
};

double overlap(Box const& a, Box const& b) {
  double const wide = std::min(a.right, b.right) - std::max(a.left, b.left);
  double const tall = std::min(a.high, b.high) - std::max(a.low, b.low);
  return wide > 0.0 && tall > 0.0 ? wide * tall : 0.0;
}

// Where a name stands beside its marker so that it covers no marker and no other name, as far as there is such a place.
struct NamePlace {
  double dx_mm = 0.0, dy_mm = 0.0;
  std::string_view align;
};

// Points of the line that joins the front, from its left to its right end.
template <class At>
std::vector<std::pair<double, double>> along_front(std::vector<FrontPoint> points, At const& at) {
  constexpr int steps = 60;  // of each piece
  std::erase_if(points, [](auto const& point) { return !point.on_front; });
  std::ranges::stable_sort(points, {}, &FrontPoint::x);
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    auto const [x0, y0] = at(points[i]);
    auto const [x1, y1] = at(points[i + 1]);
    for (int k = 0; k <= steps; ++k) line.emplace_back(x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps);
  }
  return line;
}

std::vector<NamePlace> place_names(std::vector<FrontPoint> const& points, Range const& x, Range const& y,
                                   double width_mm, double height_mm) {
  constexpr double letter_height_mm = 2.6, marker_mm = 1.3, line_mm = 0.4;
  static constexpr std::array<NamePlace, 8> candidates{{{2.0, 0.0, "left"},
                                                        {-2.0, 0.0, "right"},
                                                        {0.0, 2.4, "center"},
                                                        {0.0, -2.4, "center"},
                                                        {1.6, 1.9, "left"},
                                                        {1.6, -1.9, "left"},
                                                        {-1.6, 1.9, "right"},
                                                        {-1.6, -1.9, "right"}}};
  auto const at = [&](FrontPoint const& point) {
    return std::pair((point.x - x.low) / (x.high - x.low) * width_mm, (point.y - y.low) / (y.high - y.low) * height_mm);
  };
  std::vector<Box> taken;
  for (auto const& point : points) {
    auto const [px, py] = at(point);
    taken.push_back({px - marker_mm, px + marker_mm, py - marker_mm, py + marker_mm});
  }
  for (auto const& [px, py] : along_front(points, at))
    taken.push_back({px - line_mm, px + line_mm, py - line_mm, py + line_mm});
  std::vector<NamePlace> chosen;
  for (auto const& point : points) {
    auto const [px, py] = at(point);
    double const wide = letter_mm * static_cast<double>(point.law.size());
    auto const box_at = [&](NamePlace const& place) {
      double const from = px + place.dx_mm;
      double const left = place.align == "left" ? from : place.align == "right" ? from - wide : from - wide / 2.0;
      return Box{left, left + wide, py + place.dy_mm - letter_height_mm / 2.0,
                 py + place.dy_mm + letter_height_mm / 2.0};
    };
    auto const cost = [&](NamePlace const& place) {
      auto const box = box_at(place);
      double sum = 0.0;
      for (auto const& other : taken) sum += overlap(box, other);
      bool const inside =
          box.left >= 0.5 && box.right <= width_mm - 0.5 && box.low >= 0.5 && box.high <= height_mm - 0.5;
      return sum + (inside ? 0.0 : 1000.0);
    };
    auto const best = *std::ranges::min_element(candidates, {}, cost);
    chosen.push_back(best);
    taken.push_back(box_at(best));
  }
  return chosen;
}

std::string front_data(std::vector<FrontPoint> points, FrontWords const& words) {
  DataTable table;
  table.comment(words.about).comment("all values are without a unit").comment(words.columns);
  for (auto const& point : points)
    table.cell(point.law).cell(point.x).cell(point.y).cell(std::size_t{point.on_front}).end_row();
  table.end_block();
  table.comment("the front, from left to right");
  std::ranges::stable_sort(points, {}, &FrontPoint::x);
  for (auto const& point : points)
    if (point.on_front) table.cell(point.law).cell(point.x).cell(point.y).cell(std::size_t{1}).end_row();
  return table.take();
}

std::string front_script(std::vector<FrontPoint> const& points, FrontWords const& words) {
  constexpr double height_mm = 70.0, left = 14.0, right = 3.0, bottom = 9.5, top = 6.5;
  Range x, y;
  for (auto const& point : points) {
    x.add(point.x);
    y.add(point.y);
  }
  x = x.padded(0.14);
  y = y.padded(0.14);
  Script script(words.name, words.about, single_column_mm, height_mm);
  script.margins(left, right, bottom, top);
  script.line("set xrange [{}:{}]; set yrange [{}:{}]", number(x.low), number(x.high), number(y.low), number(y.high));
  script.line("set xlabel '{}' offset 0,raise; set ylabel '{}' offset inward,0", words.x_label, words.y_label);
  script.line("set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1 width (kind eq 'svg' ? -2 : 1)");
  auto const places = place_names(points, x, y, single_column_mm - left - right, height_mm - bottom - top);
  for (std::size_t i = 0; i < points.size();
       ++i)  // offsets in letters, 1.65 mm wide and 3.2 mm high on the average of both files
    script.line("set label {} {} noenhanced at {},{} {} offset {},{}", i + 1, gnuplot_string(points[i].law),
                number(points[i].x), number(points[i].y), places[i].align, number(places[i].dx_mm / 1.65),
                number(places[i].dy_mm / 3.2));
  auto const file = words.name + ".dat";
  bool const has_front = std::ranges::any_of(points, &FrontPoint::on_front);
  bool const has_dominated = !std::ranges::all_of(points, &FrontPoint::on_front);
  std::string plot;
  if (has_front)
    plot += fmt::format(
        "'{0}' index 1 using 2:3 with steps ls {1} dt 2 notitle, "
        "'{0}' index 0 using ($4==1?$2:NaN):3 with points ls {1} pt 7 ps 0.7 title 'non-dominated'",
        file, green);
  if (has_dominated)
    plot += fmt::format("{}'{}' index 0 using ($4==0?$2:NaN):3 with points ls {} pt 8 ps 0.8 lw 1.6 title 'dominated'",
                        has_front ? ", " : "", file, vermillion);
  script.line("plot {}", plot);
  return script.take();
}

// --- convergence -----------------------------------------------------------------------------------------------------

constexpr std::size_t most_panels = 12;  // of devices; beyond, one panel holds them all

struct Spread {
  MaybeNumber median, least, greatest;
};

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  auto const n = values.size();
  return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values.front(), values.back()};
}

// What the runs had found by a step; one that ended before keeps what it had.
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
  std::vector<Spread> made;
  for (std::size_t step = 0; step < steps; ++step) {
    std::vector<double> found;
    for (auto const* fit : fits) add_found(found, *fit, step);
    made.push_back(spread_of(std::move(found)));
  }
  return made;
}

void write_block(DataTable& table, std::string const& title, std::vector<Spread> const& steps) {
  table.comment(title);
  table.comment("step median least greatest");
  for (std::size_t i = 0; i < steps.size(); ++i)
    table.cell(i + 1).cell(steps[i].median).cell(steps[i].least).cell(steps[i].greatest).end_row();
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

void set_log_axis(Script& script, Range const& range) {
  auto const padded = range.padded_log(0.06);
  script.line("set logscale y; set yrange [{}:{}]; set ytics mirror ({})", number(padded.low), number(padded.high),
              log_tics(padded));
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

void draw_spread(Script& script, std::string const& file, std::size_t index) {
  script.line("plot '{}' index {} using 1:3:4 with filledcurves lc rgb '#b9d9ec' fs solid 1.0 noborder, \\", file,
              index);
  script.line("  '' index {} using 1:2 with lines ls {}", index, blue);
}

std::string device_panels_script(std::string const& name, std::string const& about, std::vector<Curves> const& curves,
                                 std::string_view steps) {
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
    draw_spread(script, name + ".dat", i);
  }
  script.line("unset multiplot");
  return script.take();
}

// The last of the curves is of all devices.
std::string pooled_script(std::string const& name, std::string const& about, std::vector<Curves> const& curves,
                          std::string_view steps) {
  Script script(name, about, single_column_mm, 62.0);
  script.margins(14.0, 3.0, 9.5, 7.0);
  script.line("set xlabel '{}' offset 0,raise; set ylabel '{{/:Italic OF}} (-)' offset inward,0", steps);
  script.line("set xrange [1:{}]", std::max<std::size_t>(2, curves.back().steps.size()));
  set_log_axis(script, range_of(curves.back().steps));
  script.line(
      "set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.6 width (kind eq 'svg' ? -1.5 : 1)");
  auto const all = curves.size() - 1;
  script.line(
      "plot '{}.dat' index {} using 1:3:4 with filledcurves lc rgb '#dcecf5' fs solid 1.0 noborder title 'range', \\",
      name, all);
  script.line("  for [i=0:{}] '' index i using 1:2 with lines lc rgb '#9a9a9a' lw 0.6 title (i==0?'devices':''), \\",
              all - 1);
  script.line("  '' index {} using 1:2 with lines ls {} lw 1.8 title 'median'", all, blue);
  return script.take();
}

// --- objective -------------------------------------------------------------------------------------------------------

DevicePanel objective_panel(LawResult const& law, std::vector<std::string> const& devices) {
  DevicePanel panel{.title = law.id, .name = "OF", .unit = "-", .reference = law.objective.mean, .points = {}};
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
  for (auto const& law : summary.laws) panels.push_back(objective_panel(law, devices));
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

// Within the place of a law its devices stand side by side in their order.
std::string place_in_law(std::size_t law, std::size_t devices) {
  return fmt::format("({}+0.8*($1-{})/{})", law + 1, number((static_cast<double>(devices) + 1.0) / 2.0), devices);
}

void plot_laws(Script& script, std::string const& file, std::vector<DevicePanel> const& laws, int column,
               bool with_bars) {
  for (std::size_t i = 0; i < laws.size(); ++i) {
    auto const x = place_in_law(i, laws[i].points.size());
    int const style = static_cast<int>(i % 7) + 1;
    std::string const start = i == 0 ? "plot " : "  ";
    if (with_bars)
      script.line(
          "{}'{}' index {} using {}:($3-$4):(0):(2*$4) with vectors heads size {},90 fixed ls {} dt 1 lw 0.8, \\",
          start, file, i, x, number(0.2 / static_cast<double>(laws[i].points.size())), style);
    script.line("{}'{}' index {} using {}:{} with points ls {}{}", with_bars ? "  " : start, file, i, x, column, style,
                i + 1 < laws.size() ? ", \\" : "");
  }
}

std::string objective_script(std::string const& name, std::string const& about, std::vector<DevicePanel> const& laws) {
  auto const ranges = ranges_of(laws);
  std::size_t const panels = ranges.std.empty ? 2 : 3;
  Grid const grid{.columns = 1,
                  .rows = static_cast<int>(panels),
                  .width_mm = double_column_mm,
                  .panel_height_mm = 34.0,
                  .margins = {.left = 16.0, .right = 3.0, .bottom = 6.5, .top = 2.5}};
  Script script(name, about, grid.width_mm, grid.height_mm());
  std::string tics;
  for (std::size_t i = 0; i < laws.size(); ++i)
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_string(laws[i].title), i + 1);
  script.line("set xrange [0.5:{}.5]; set xtics scale 0 noenhanced ({})", laws.size(), tics);
  for (std::size_t i = 1; i < laws.size(); ++i)
    script.line("set arrow from first {0}.5,graph 0 to first {0}.5,graph 1 nohead ls {1} dt 3 lw 0.5", i, grey);
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

// --- properties ------------------------------------------------------------------------------------------------------

// What a rule set derives, one value or one of each side; without a set the cycle that counts.
std::vector<double> property_values(DeviceResult const& device, rules::Quantity quantity) {
  auto const name = std::string(rules::name(quantity));
  std::vector<double> values;
  for (auto const& assessment : device.acceptance.assessments)
    if (assessment.value && (assessment.quantity == name || assessment.quantity.starts_with(name + ", ")))
      values.push_back(*assessment.value);
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
  limits.design = summary.acceptance.design.of(quantity);
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
  std::vector<std::vector<double>> values;  // per device
};

PropertyPanel property_panel(Summary const& summary, rules::Quantity quantity, std::string label) {
  PropertyPanel panel{.name = std::string(rules::name(quantity)),
                      .label = std::move(label),
                      .unit = std::string(rules::unit(quantity)),
                      .limits = limits_of(summary, quantity),
                      .values = {}};
  for (auto const& device : summary.devices)
    if (device.status == "ok") panel.values.push_back(property_values(device, quantity));
  return panel;
}

void write_block(DataTable& table, PropertyPanel const& panel, std::vector<std::string> const& devices) {
  auto const& limits = panel.limits;
  table.comment(panel.name + " in " + panel.unit + "; design value and limits of each device, where there are any");
  table.comment("number device value value_of_the_other_side design lower_limit upper_limit");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    auto const& values = panel.values[i];
    auto const at = [&](std::size_t k) { return k < values.size() ? MaybeNumber(values[k]) : std::nullopt; };
    table.cell(i + 1).cell(devices[i]).cell(at(0)).cell(at(1));
    table.cell(limits.design).cell(limits.lower).cell(limits.upper).end_row();
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

MaybeFigure front_figure(Summary const& summary, FrontView view) {
  auto const points = front_points(summary, view);
  if (points.empty()) return std::nullopt;
  auto const words = words_of(view);
  return Figure{words.name, front_data(points, words), front_script(points, words)};
}

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

MaybeFigure parameters_figure(Summary const& summary, LawResult const& law) {
  auto const devices = device_names(summary);
  auto const& parameters = parameters_of(law);
  std::vector<DevicePanel> panels;
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    if (!parameters[n].free) continue;
    DevicePanel panel{
        .title = {}, .name = parameters[n].name, .unit = parameters[n].unit, .reference = {}, .points = {}};
    std::vector<double> means;
    for (auto const& device : devices) {
      DevicePoint point{device, {}, {}};
      auto const* fit = fit_of(law, device);
      if (fit != nullptr && fit->objective.mean && n < fit->parameters.size()) {
        point.value = fit->parameters[n].value;
        point.percent = fit->parameters[n].percent_of_lot;
        if (point.value.mean) means.push_back(*point.value.mean);
      }
      panel.points.push_back(std::move(point));
    }
    if (means.size() > 1) panel.reference = num::moments(means).mean;
    // No percentages where the mean is too near to zero for them.
    if (std::ranges::none_of(panel.points, [](auto const& point) { return point.percent.has_value(); }))
      panel.reference.reset();
    if (means.empty()) continue;
    if (panels.size() < 26) panel.title = fmt::format("({})", static_cast<char>('a' + panels.size()));
    panels.push_back(std::move(panel));
  }
  return panels_figure("parameters_" + law.id,
                       "parameters of " + law.id +
                           " on every device: mean and standard deviation over runs, difference from the mean of the "
                           "devices, Figs. 8 to 13",
                       panels);
}

MaybeFigure convergence_figure(Summary const& summary, LawResult const& law) {
  std::vector<Curves> curves;
  std::vector<DeviceFit const*> fits;
  for (auto const& fit : law.devices) {
    Curves made{fit.device, spreads(std::array{&fit})};
    if (range_of(made.steps).empty) continue;
    curves.push_back(std::move(made));
    fits.push_back(&fit);
  }
  if (curves.empty()) return std::nullopt;
  auto const name = "convergence_" + law.id;
  auto const about = "best objective of " + law.id + " so far: median and range over the runs";
  auto const steps = name_of_steps(summary);
  bool const pooled = curves.size() > most_panels;
  if (pooled) curves.push_back({"all devices", spreads(fits)});
  return Figure{name, convergence_data(about, curves, steps),
                pooled ? pooled_script(name, about, curves, steps) : device_panels_script(name, about, curves, steps)};
}

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
  Margins margins{.left = 14.0, .right = 3.0, .bottom = 0.0, .top = 9.0};
  DeviceAxis const axis(devices, grid_of(panels.size(), 0.0, margins).panel_width_mm());
  margins.bottom = 7.5 + axis.label_mm;
  auto const grid = grid_of(panels.size(), 42.0, margins);
  DataTable table;
  table.comment(about);
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line(
      "set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.6 width (kind eq 'svg' ? -1.5 : 1)");
  script.line("set multiplot");
  for (std::size_t i = 0; i < panels.size(); ++i) {
    write_block(table, panels[i], devices);
    script.place(grid, i);
    draw_panel(script, name + ".dat", i, panels[i], axis);
  }
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

}  // namespace isolaw::render
