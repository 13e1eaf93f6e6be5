// Makes figures that compare the campaign with Table A.5 of Cucuzza et al. 2025. For both, the standard deviation over
// the runs is shown as a share of |mean|.
#include <algorithm>
#include <cmath>

#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/render/figures/device_panels.hpp"
#include "isolaw/study/published.hpp"
#include "isolaw/study/table_a5.hpp"

namespace isolaw::render {
namespace {

struct DeviceSpread {
  std::string device;
  // relative: std / |mean|; percent: difference of this device's mean from the mean over all devices, as a percentage
  // of the mean over all devices
  MaybeNumber mean, std, relative, percent;
};
using Spreads = std::vector<DeviceSpread>;

void relate(Spreads& spreads) {
  std::vector<double> means;
  for (auto& [device, mean, std, relative, percent] : spreads) {
    if (mean) means.push_back(*mean);
    if (mean && std && *mean != 0.0) relative = *std / std::abs(*mean);
  }
  MaybeNumber const reference = means.size() > 1 ? MaybeNumber(num::moments(means).mean) : std::nullopt;
  for (auto& spread : spreads) spread.percent = percent_of(spread.mean, reference);
}

Spreads printed_spreads(table_a5::PerDevice const& mean, table_a5::PerDevice const& std) {
  Spreads spreads;
  for (std::size_t d = 0; d < table_a5::devices; ++d)
    spreads.push_back({fmt::format("P{}", d + 1), mean[d], std[d], {}, {}});
  relate(spreads);
  return spreads;
}

template <class Of>
Spreads spreads_here(Summary const& summary, LawResult const& law, Of const& statistic) {
  Spreads spreads;
  for (auto const& device : device_names(summary)) {
    auto const* fit = fit_of(law, device);
    auto const value = fit != nullptr ? statistic(*fit) : Statistic{};
    spreads.push_back({device, value.mean, value.std, {}, {}});
  }
  relate(spreads);
  return spreads;
}

void write_spreads(DataTable& table, std::string const& what, Spreads const& spreads) {
  table.comment(what);
  table.comment("number device mean std std_over_mean difference_from_the_mean_percent");
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    auto const& [device, mean, std, relative, percent] = spreads[i];
    table.row(i + 1, device, mean, std, relative, percent);
  }
  table.end_block();
}

struct Beside {
  std::string law;
  int number = 0;
  Spreads here, printed;
};

std::vector<Beside> laws_beside(Summary const& summary) {
  std::vector<Beside> laws;
  auto const known = study::published(summary);
  if (!known) return laws;
  for (auto const& row : known->laws) {
    auto const law = std::ranges::find(summary.laws, row.law, &LawResult::id);
    if (law == summary.laws.end() || !row.computed.objective) continue;
    auto const& printed = table_a5::laws[static_cast<std::size_t>(row.number - 1)];
    laws.push_back({row.law, row.number,
                    spreads_here(summary, *law, [](DeviceFit const& fit) { return fit.objective; }),
                    printed_spreads(printed.objective_mean, printed.objective_std)});
  }
  return laws;
}

// Returns gnuplot's expression for the x coordinate of a device. The campaign's devices fill the left half of a law's
// interval on the axis, the published study's devices the right half.
std::string place_in_half(std::size_t law, std::size_t devices, bool printed) {
  return fmt::format("({}+0.38*($1-0.5)/{})", number(static_cast<double>(law + 1) + (printed ? 0.04 : -0.42)), devices);
}

void plot_beside(Script& script, std::string const& file, std::vector<Beside> const& laws, int column, bool with_key) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < laws.size(); ++i)
    for (bool const printed : {false, true})
      parts.push_back(fmt::format("'{}' index {} using {}:{} with points ls {} pt {} {}", file, 2 * i + printed,
                                  place_in_half(i, (printed ? laws[i].printed : laws[i].here).size(), printed), column,
                                  printed ? grey : blue, printed ? 6 : 7,
                                  i > 0 || !with_key ? "notitle"
                                  : printed          ? "title 'published'"
                                                     : "title 'here'"));
  script.line("plot {}", joined(parts, ", \\\n    "));
}

struct BesidePanel {
  std::string name;
  Spreads here, printed;
};

// Returns the largest magnitude of `value` over the devices of both the campaign and the published study. The axis ends
// there.
double largest_of(BesidePanel const& panel, MaybeNumber DeviceSpread::*value) {
  double largest = 0.0;
  for (auto const* spreads : {&panel.here, &panel.printed})
    for (auto const& spread : *spreads)
      if ((spread.*value) && std::isfinite(*(spread.*value))) largest = std::max(largest, std::abs(*(spread.*value)));
  return largest;
}

void draw_beside(Script& script, std::string const& file, std::size_t index, BesidePanel const& panel,
                 DeviceAxis const& axis) {
  auto const half = 1.12 * largest_of(panel, &DeviceSpread::relative),
             percent = 1.12 * largest_of(panel, &DeviceSpread::percent);
  double const bars = half > 0.0 ? half : 0.1, points = percent > 0.0 ? percent : 1.0;
  auto const here = panel.here.size();
  if (index < 26) script.line("set title '({})' noenhanced offset 0,-raise", static_cast<char>('a' + index));
  script.line("set ylabel {} offset inward,0", gnuplot_label(panel.name + ": 1 ± σ/|μ|"));
  script.line("set yrange [{}:{}]", number(1.0 - bars), number(1.0 + bars));
  script.line("set y2range [{}:{}]", number(-points), number(points));
  script.line("set y2tics; set ytics nomirror; set y2label 'Difference of μ (%)' offset -inward,0");
  axis.draw(script);
  if (!axis.names) script.line("set xlabel 'Device, number; beyond the line published' offset 0,raise");
  script.line("set arrow 100 from first {0},graph 0 to first {0},graph 1 nohead ls {1} dt 1 lw 0.5", here + 1, grey);
  script.line("set label 100 'published' at graph 1,1.07 right font ',6' textcolor ls {}", grey);
  std::string plot = fmt::format("plot 1 with lines ls {} dt 3, \\\n", black);
  for (bool const printed : {false, true}) {
    auto const block = 2 * index + printed;
    auto const x = printed ? fmt::format("($1+{})", here + 1) : std::string("1");
    int const style = printed ? grey : blue;
    plot += fmt::format(
        "    '{0}' index {1} using {2}:(1-$5):(0):(2*$5) with vectors heads size 0.2,90 fixed ls {3} dt 1, \\\n", file,
        block, x, style);
    plot += fmt::format("    '{}' index {} using {}:6{} axes x1y2 with points ls {} pt {} ps 0.5{}", file, block, x,
                        axis.using_suffix(), printed ? grey : vermillion, printed ? 4 : 5, printed ? "" : ", \\\n");
  }
  script.line("{}", plot);
}

std::vector<BesidePanel> panels_beside(Summary const& summary, LawResult const& law, table_a5::Law const& printed) {
  std::vector<BesidePanel> panels;
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    auto const row = std::ranges::find(printed.parameters, parameters[n].name, &table_a5::Parameter::name);
    if (!parameters[n].free || row == printed.parameters.end()) continue;
    panels.push_back({parameters[n].name,
                      spreads_here(summary, law,
                                   [&](DeviceFit const& fit) {
                                     return n < fit.parameters.size() ? fit.parameters[n].value : Statistic{};
                                   }),
                      printed_spreads(row->mean, row->std)});
  }
  return panels;
}

}  // namespace

MaybeFigure published_objective_figure(Summary const& summary) {
  auto const laws = laws_beside(summary);
  if (laws.empty()) return std::nullopt;
  std::string const name = "published_objective";
  std::string const about =
      "objective of the published study's laws on every device beside its printed values: mean, standard deviation over the runs, and their ratio, Fig. 6";
  DataTable table;
  table.comment(about);
  Range means, stds, relatives;
  means.add(0.0);
  for (auto const& law : laws)
    for (bool const printed : {false, true}) {
      auto const& spreads = printed ? law.printed : law.here;
      write_spreads(table, fmt::format("law {}, {}{}", law.number, law.law, printed ? ", published" : ", here"),
                    spreads);
      for (auto const& spread : spreads) {
        means.add(spread.mean);
        if (spread.std && *spread.std > 0.0) stds.add(spread.std);
        if (spread.relative && *spread.relative > 0.0) relatives.add(spread.relative);
      }
    }
  Grid const grid{.columns = 1,
                  .rows = 3,
                  .width_mm = double_column_mm,
                  .panel_height_mm = 34.0,
                  .margins = {.left = 16.0, .right = 3.0, .bottom = 9.5, .top = 2.5},
                  .head_mm = 4.0};
  Script script(name, about, grid.width_mm, grid.height_mm());
  std::vector<std::string> names;
  for (auto const& law : laws) names.push_back(fmt::format("{} {}", law.number, laws::display_name(law.law)));
  draw_law_axis(script, names);
  script.line("set multiplot");
  script.place(grid, 0);
  script.line("set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1");
  script.line("set ylabel '{{/:Italic OF}}, mean μ (-)' offset inward,0; set yrange [0:{}]",
              number(means.padded(0.08).high));
  plot_beside(script, name + ".dat", laws, 3, true);
  script.line("unset key");
  script.place(grid, 1);
  script.line("set ylabel 'σ over the runs (-)' offset inward,0");
  set_log_axis(script, stds);
  plot_beside(script, name + ".dat", laws, 4, false);
  script.place(grid, 2);
  script.line("set ylabel 'σ/μ (-)' offset inward,0");
  set_log_axis(script, relatives);
  plot_beside(script, name + ".dat", laws, 5, false);
  script.line("unset logscale y; set ytics autofreq");
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

MaybeFigure published_parameters_figure(Summary const& summary, LawResult const& law) {
  auto const known = study::published(summary);
  if (!known) return std::nullopt;
  auto const row = std::ranges::find(known->laws, law.id, &study::PublishedLaw::law);
  if (row == known->laws.end() || !row->computed.objective) return std::nullopt;
  auto const panels = panels_beside(summary, law, table_a5::laws[static_cast<std::size_t>(row->number - 1)]);
  if (panels.empty()) return std::nullopt;
  auto const name = "published_parameters_" + law.id;
  auto const about = fmt::format(
      "parameters of {} beside the printed values of law {}: standard deviation over the runs divided by the mean, "
      "and difference from the mean of the devices, Fig. {}",
      law.id, row->number, row->number + 7);
  std::vector<std::string> places;
  for (auto const& spread : panels.front().here) places.push_back(spread.device);
  places.emplace_back();
  for (auto const& spread : panels.front().printed) places.push_back(spread.device);
  return figure_over_devices(name, about, places, panels.size(),
                             {.height_mm = 30.0,
                              .margins = {.left = 13.5, .right = 12.0, .bottom = 7.5, .top = 5.0},
                              .columns = places.size() <= 32 ? 2 : 1},
                             [&](DataTable& table, Script& script, std::size_t i, DeviceAxis const& axis) {
                               write_spreads(table, panels[i].name + ", here", panels[i].here);
                               write_spreads(table, panels[i].name + ", published", panels[i].printed);
                               draw_beside(script, name + ".dat", i, panels[i], axis);
                             });
}

}  // namespace isolaw::render
