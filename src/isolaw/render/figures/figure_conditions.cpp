#include <algorithm>
#include <array>
#include <cmath>

#include "isolaw/base/words.hpp"
#include "isolaw/render/figures/conditions_figures.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/condition_curves.hpp"
#include "isolaw/study/conditions_results.hpp"

namespace isolaw::render {
namespace {

using conditions::Effect;

constexpr std::array shown_effects{Effect::temperature, Effect::rate, Effect::load, Effect::ageing};
constexpr std::array<std::pair<rules::Quantity, std::string_view>, 2> shown_quantities{
    {{rules::Quantity::K_eff, "{/:Italic K}_{eff} factor"}, {rules::Quantity::damping, "Damping factor"}}};

// Holds the data of a panel, which shows one effect (such as temperature) on one property (such as K_eff).
struct ConditionPanel {
  Effect effect;
  double factor = 1.0;  // converts the condition from its stored unit to the unit shown
  std::string label;
  std::vector<LevelRow const*> levels = {};
  std::vector<EndRow const*> ends = {};
  std::vector<ConditionCurve const*> curves = {};
  std::optional<double> reference = {};
  std::optional<campaign::ConditionRange> design = {};

  // Returns the x coordinate of a level. A level of ageing is not a single number, so the levels of ageing stand at 1,
  // 2, ... and the reference at 0.
  double place(std::size_t level) const {
    return effect == Effect::ageing ? static_cast<double>(level + 1) : factor * levels[level]->factor.at;
  }
};

ConditionPanel condition_panel(ConditionsResult const& result, std::vector<ConditionCurve> const& curves,
                               rules::Quantity quantity, Effect effect, UnitSystem const& units) {
  auto const& from = result.stated.reference;
  auto const& design = result.stated.design;
  auto const shown = shown_unit(unit_of(effect), units);
  ConditionPanel panel{.effect = effect, .factor = shown.factor, .label = {}};
  auto const is_here = [&](auto const& row) { return row.quantity == quantity && row.effect == effect; };
  for (auto const& level : result.levels)
    if (is_here(level) && level.factor.status != conditions::Status::not_covered) panel.levels.push_back(&level);
  for (auto const& end : result.ends)
    if (is_here(end)) panel.ends.push_back(&end);
  for (auto const& curve : curves)
    if (is_here(curve)) panel.curves.push_back(&curve);
  if (effect == Effect::temperature) {
    panel.label = "Temperature (°C)", panel.reference = from.temperature_C, panel.design = design.temperature_C;
  } else if (effect == Effect::rate) {
    panel.label = "Frequency (Hz)", panel.reference = from.frequency_Hz, panel.design = design.frequency_Hz;
  } else if (effect == Effect::load) {
    panel.label = "Vertical load (" + shown.unit + ")", panel.reference = from.load_kN, panel.design = design.load_kN;
  } else {
    panel.reference = 0.0;
    for (std::size_t i = 0; design.aged && i < panel.levels.size(); ++i) {
      auto const& aged = panel.levels[i]->ageing;
      double const place = panel.place(i), half = 0.3;
      if (aged && conditions::agrees(*aged, {.days = design.aged->days, .at_C = design.aged->at_C}))
        panel.design = {place - half, place + half};
    }
  }
  return panel;
}

// Returns the range of the logarithmic axis. A very wide interval would leave little room for the factors. The axis
// therefore extends beyond them by at most half their own range or a factor of 1.2, whichever is more, and longer
// intervals are cut.
Range range_of_factors(std::vector<ConditionPanel> const& panels) {
  Range factors;
  factors.add(1.0);
  for (auto const& panel : panels) {
    for (auto const* level : panel.levels) {
      factors.add(level->factor.lambda());
      for (auto const& ratio : level->ratios) factors.add(std::exp(ratio.ln));
    }
    for (auto const* curve : panel.curves)
      for (double const lambda : curve->lambda) factors.add(lambda);
  }
  Range range = factors;
  double const room = std::exp(std::max(0.5 * std::log(factors.high / factors.low), 0.2));
  for (auto const& panel : panels)
    for (auto const* level : panel.levels)
      for (auto const about : {conditions::About::mean, conditions::About::device})
        if (auto const found = interval(level->factor, about)) {
          range.add(std::max(found->low, factors.low / room));
          range.add(std::min(found->high, factors.high * room));
        }
  return range;
}

// Writes the data of a panel as blocks of gnuplot's data file and returns the commands that plot them. `block` is the
// index of the next block in the file.
std::vector<std::string> write_panel(DataTable& table, ConditionPanel const& panel, std::string const& file,
                                     std::size_t& block, Range const& range) {
  std::vector<std::string> plots;
  auto const plot = [&](std::string const& how) { plots.push_back(fmt::format("'{}' index {} {}", file, block, how)); };
  auto const add = [&](std::string const& how) {
    table.end_block();
    plot(how);
    ++block;
  };
  MaybeNumber const none;
  auto const lines = [&](CurveKind kind, std::string const& how) {
    bool any = false;
    auto const point = [&](double at, double lambda) {
      if (!any) table.comment(fmt::format("{}, {}: condition factor", name(panel.effect), name(kind)));
      table.row(at, lambda);
      any = true;
    };
    for (auto const* curve : panel.curves) {
      if (curve->kind != kind) continue;
      for (std::size_t i = 0; i < curve->at.size(); ++i) point(panel.factor * curve->at[i], curve->lambda[i]);
      table.row(none, none);
    }
    if (panel.effect == Effect::ageing)
      for (std::size_t i = 0; i < panel.levels.size(); ++i) {
        auto const line = [&](double lambda) {
          point(0.0, 1.0);
          point(panel.place(i), lambda);
          table.row(none, none);
        };
        if (kind == CurveKind::mean) line(panel.levels[i]->factor.lambda());
        if (kind == CurveKind::device)
          for (auto const& ratio : panel.levels[i]->ratios) line(std::exp(ratio.ln));
      }
    if (any) add(how);
  };
  lines(CurveKind::device, fmt::format("with lines ls {} dt 1 lw 0.6", grey));
  lines(CurveKind::mean, fmt::format("with lines ls {}", blue));
  lines(CurveKind::extrapolated, fmt::format("with lines ls {} dt 3", blue));
  lines(CurveKind::smooth, fmt::format("with lines ls {} dt (12,7) lw 0.6", black));
  // An interval is drawn as a line (an arrow without a head) and cut at the axis limits. A triangle marks a cut end.
  auto const low = number(range.low), high = number(range.high);
  auto const bars = [&](conditions::About about, double thickness) {
    bool any = false, cut = false;
    for (std::size_t i = 0; i < panel.levels.size(); ++i) {
      auto const found = interval(panel.levels[i]->factor, about);
      if (!found) continue;
      if (!any)
        table.comment(fmt::format("{}, 95 % interval, {}: condition low high", name(panel.effect), name(about)));
      table.row(panel.place(i), found->low, found->high);
      any = true;
      cut |= found->low < range.low || found->high > range.high;
    }
    if (!any) return;
    if (cut) {
      plot(fmt::format("using 1:($2<{0}?{0}:NaN) with points ls {1} pt 11 ps 0.6", low, blue));
      plot(fmt::format("using 1:($3>{0}?{0}:NaN) with points ls {1} pt 9 ps 0.6", high, blue));
    }
    auto const from = fmt::format("($2<{0}?{0}:$2)", low), to = fmt::format("($3>{0}?{0}:$3)", high);
    add(fmt::format("using 1:{0}:(0):({1}-{0}) with vectors nohead ls {2} dt 1 lw {3}", from, to, blue,
                    number(thickness)));
  };
  bars(conditions::About::device, 0.8);
  bars(conditions::About::mean, 2.5);
  auto const points = [&](bool shown, int symbol) {
    bool any = false;
    for (std::size_t i = 0; i < panel.levels.size(); ++i) {
      auto const& factor = panel.levels[i]->factor;
      if ((factor.status == conditions::Status::shown) != shown) continue;
      if (!any)
        table.comment(fmt::format("{}, levels{}: condition factor", name(panel.effect),
                                  shown ? "" : " of other devices or scaled specimens"));
      table.row(panel.place(i), factor.lambda());
      any = true;
    }
    if (any) add(fmt::format("with points ls {} pt {}", blue, symbol));
  };
  points(true, 7);
  points(false, 4);
  return plots;
}

void set_condition_axis(Script& script, ConditionPanel const& panel) {
  Range range;
  range.add(panel.reference ? std::optional(panel.factor * *panel.reference) : std::nullopt);
  for (std::size_t i = 0; i < panel.levels.size(); ++i) range.add(panel.place(i));
  for (auto const* end : panel.ends) range.add(panel.factor * end->at);
  script.line("unset logscale x; set xtics norotate nomirror autofreq; unset object 1; unset label 1");
  if (panel.effect == Effect::ageing) {
    std::vector<std::string> tics{"'not aged' 0"};
    for (std::size_t i = 0; i < panel.levels.size(); ++i)
      tics.push_back(fmt::format("\"{:g} days\\n{:g} °C\" {}", panel.levels[i]->ageing->days,
                                 panel.levels[i]->ageing->at_C, number(panel.place(i))));
    script.line("set xrange [-0.5:{}]; set xtics ({}); set xlabel ''",
                number(panel.place(panel.levels.size() - 1) + 0.5), joined(tics));
  } else {
    auto const padded = panel.effect == Effect::rate ? range.padded_log(0.06) : range.padded(0.06);
    if (panel.effect == Effect::rate) script.line("set logscale x; set xtics (0.01,0.02,0.05,0.1,0.2,0.5,1,2,5,10,20)");
    if (panel.effect != Effect::rate)
      script.line("set xtics autofreq {}", number(nice_step(padded.high - padded.low, 4)));
    script.line("set xrange [{}:{}]; set xlabel {} offset 0,raise", number(padded.low), number(padded.high),
                gnuplot_label(panel.label));
  }
  if (panel.design)
    script.line(
        "set object 1 rectangle from first {},graph 0 to first {},graph 1 behind fillcolor rgb '#e3f0ea' fillstyle solid noborder",
        number(panel.factor * panel.design->low), number(panel.factor * panel.design->high));
  if (panel.reference)
    script.line("set label 1 '' at first {},first 1 front point ls {} pt 6 ps 0.7",
                number(panel.factor * *panel.reference), black);
}

}  // namespace

MaybeFigure conditions_figure(ConditionsResult const& result, UnitSystem const& units) {
  auto const curves = condition_curves(result);
  std::vector<Effect> effects;
  for (auto const effect : shown_effects)
    if (std::ranges::any_of(result.levels, [&](LevelRow const& row) { return row.effect == effect; }))
      effects.push_back(effect);
  if (effects.empty()) return std::nullopt;
  std::string const name = "conditions";
  std::string const about = "factors on effective stiffness and damping over the conditions of the tests";
  Grid const grid{.columns = static_cast<int>(effects.size()),
                  .rows = static_cast<int>(shown_quantities.size()),
                  .width_mm = effects.size() > 1 ? double_column_mm : single_column_mm,
                  .panel_height_mm = 36.0,
                  .margins = {.left = 11.0, .right = 2.5, .bottom = 10.0, .top = 3.0}};
  DataTable table;
  table.comment(about);
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set multiplot");
  std::size_t place = 0, block = 0;
  for (auto const& [quantity, label] : shown_quantities) {
    std::vector<ConditionPanel> panels;
    for (auto const effect : effects) panels.push_back(condition_panel(result, curves, quantity, effect, units));
    auto const range = range_of_factors(panels);
    for (auto const& panel : panels) {
      script.place(grid, place++);
      if (panel.levels.empty()) continue;
      table.comment(fmt::format("{} over {}", rules::name(quantity), rules::name(panel.effect)));
      auto plots = write_panel(table, panel, name + ".dat", block, range);
      set_log_axis(script, range);
      set_condition_axis(script, panel);
      script.line("set ylabel '{}' offset inward,0", label);
      plots.insert(plots.begin(), fmt::format("1 with lines ls {} dt 1 lw 0.5", grey));
      script.line("plot {}", joined(plots));
    }
  }
  script.line("unset multiplot");
  return Figure{name, table.take(), script.take()};
}

std::vector<Figure> conditions_figures(ConditionsResult const& result, UnitSystem const& units) {
  std::vector<Figure> figures;
  for (auto figure : {conditions_figure(result, units), factors_figure(result)})
    if (figure) figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace isolaw::render
