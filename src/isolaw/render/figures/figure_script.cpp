#include "isolaw/render/figures/figure_script.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/symbol.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

constexpr double mm_per_inch = 25.4, svg_px_per_inch = 96.0, font_pt = 7.0, pt_per_inch = 72.0;

std::string log_tics(Range const& range) {
  std::vector<double> values;
  int const first = static_cast<int>(std::floor(std::log10(range.low)));
  int const last = static_cast<int>(std::ceil(std::log10(range.high)));
  int const stride = std::max(1, (last - first) / 6);
  auto const add = [&](double value) {
    if (value >= range.low && value <= range.high) values.push_back(value);
  };
  if (last - first > 3) {
    for (int decade = first; decade <= last; decade += stride) add(std::pow(10.0, decade));
  } else {
    for (int decade = first; decade <= last; ++decade)
      for (double const digit : {1.0, 2.0, 5.0}) add(digit * std::pow(10.0, decade));
  }
  if (values.size() < 3) {  // the axis spans less than about a decade, so tics are evenly spaced
    values.clear();
    double const step = nice_step(range.high - range.low, 4);
    for (double k = std::ceil(range.low / step); k * step <= range.high; ++k) values.push_back(k * step);
  }
  std::vector<std::string> tics;
  for (double const value : values) {
    double const rounded = std::stod(to_text(value, 6));
    bool const is_plain = rounded >= 1e-3 && rounded < 1e4;
    auto const label = is_plain ? "'" + to_text(rounded, 6) + "'"
                                : gnuplot_label(values.size() > 1 && last - first > 3
                                                    ? fmt::format("10^{}", std::lround(std::log10(rounded)))
                                                    : to_text(rounded, 3));
    tics.push_back(label + " " + number(rounded));
  }
  return joined(tics);
}

}  // namespace

Grid grid_of(std::size_t panels, double panel_height_mm, Margins const& margins, int most_columns) {
  int const count = std::max(1, static_cast<int>(panels));
  int const columns = std::min(count, most_columns);
  return {.columns = columns,
          .rows = (count + columns - 1) / columns,
          .width_mm = count == 1 && most_columns > 1 ? single_column_mm : double_column_mm,
          .panel_height_mm = panel_height_mm,
          .margins = margins};
}

double nice_step(double length, int steps) {
  double const raw = length / steps, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (double const factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

Script::Script(std::string_view name, std::string_view about, double width_mm, double height_mm)
    : width_mm_(width_mm), height_mm_(height_mm) {
  text_ =
      fmt::format("{}{}\n# gnuplot {}.gp draws {}.svg and {}.pdf from {}.dat: {} mm wide, {} mm high.\n", script_mark,
                  printable(about), name, name, name, name, to_text(width_mm, 4), to_text(height_mm, 4));
  text_ += "reset\nset encoding utf8\n";
  text_ += "do for [kind in 'svg pdf'] {\n";
  line("if (kind eq 'svg') {{");
  line("  set terminal svg size {:.0f},{:.0f} enhanced font 'sans-serif,{:.2f}' linewidth 0.8 background '#ffffff'",
       width_mm / mm_per_inch * svg_px_per_inch, height_mm / mm_per_inch * svg_px_per_inch,
       font_pt / pt_per_inch * svg_px_per_inch);
  line("}} else {{");
  line("  set terminal pdfcairo size {}cm,{}cm enhanced font 'Sans,{}' fontscale 0.75 linewidth 0.75",
       to_text(width_mm / 10.0, 5), to_text(height_mm / 10.0, 5), to_text(font_pt, 3));
  line("}}");
  // gnuplot measures offsets in letter sizes, which differ between SVG and PDF. These variables correct for the
  // difference.
  line("raise = kind eq 'svg' ? 0.75 : 0.35; inward = kind eq 'svg' ? 1.4 : 0.8");
  line("set output '{}.'.kind", name);
  for (std::size_t i = 0; i < law_look_count; ++i)
    line("set style line {} lc rgb '{}' lw 1.2 pt {} ps 0.55 dt 1", style_of(i), law_looks[i].colour,
         law_looks[i].point);
  line("set style line {} lc rgb '#000000' lw 1 pt 4 ps 0.45 dt 1  # black", black);
  line("set style line {} lc rgb '#7f7f7f' lw 1 pt 8 ps 0.55 dt 3  # grey", grey);
  line("set border lw 0.8");
  line("set tics scale 0.6");
  line("set key samplen 2.2 spacing 1.0 noenhanced");
  line("unset key");
}

void Script::margins(double left_mm, double right_mm, double bottom_mm, double top_mm) {
  line("set lmargin at screen {}", number(left_mm / width_mm_));
  line("set rmargin at screen {}", number(1.0 - right_mm / width_mm_));
  line("set bmargin at screen {}", number(bottom_mm / height_mm_));
  line("set tmargin at screen {}", number(1.0 - top_mm / height_mm_));
}

void Script::place(Grid const& grid, std::size_t panel) {
  auto const columns = static_cast<std::size_t>(grid.columns);
  double const column = static_cast<double>(panel % columns), row = static_cast<double>(panel / columns);
  double const left = column * grid.width_mm / grid.columns + grid.margins.left;
  double const top = grid.head_mm + row * grid.row_mm() + grid.margins.top;
  margins(left, grid.width_mm - left - grid.panel_width_mm(), grid.height_mm() - top - grid.panel_height_mm, top);
}

std::string Script::take() {
  line("unset output");
  text_ += "}\n";
  return std::exchange(text_, {});
}

std::string marked_style(std::size_t law) {
  auto const style = fmt::format("ls {}", style_of(law));
  return is_hollow(law) ? style + fmt::format(" pt {}", law_looks[look_of(law)].hollow) : style;
}

std::string shortened(std::string_view text, double width_mm) {
  auto clean = printable(text);
  auto const most = static_cast<std::size_t>(width_mm / letter_mm);
  if (character_count(clean) <= most) return clean;
  std::size_t end = 0;
  for (std::size_t count = 0; count + 1 < most; ++count) end += utf8_length(std::string_view(clean).substr(end));
  return clean.substr(0, end) + "…";
}

std::string number(double value) {
  return to_text(value, 6);
}

void Range::add(std::optional<double> const& value) {
  if (!value || !std::isfinite(*value)) return;
  low = empty ? *value : std::min(low, *value);
  high = empty ? *value : std::max(high, *value);
  empty = false;
}

Range Range::padded(double share) const {
  double const length = high - low;
  // Numbers in scripts have six digits. The ends of a shorter range could therefore be written as the same number, and
  // gnuplot refuses an axis of length zero.
  double const least = 1e-4 * std::max(std::abs(low), std::abs(high));
  double const by = length > least ? share * length : low != 0.0 ? 0.05 * std::max(std::abs(low), std::abs(high)) : 1.0;
  return {low - by, high + by, false};
}

Range Range::padded_log(double share) const {
  double const by = std::max(std::pow(high / low, share), 1.05);
  return {low / by, high * by, false};
}

std::string law_tic(std::string name) {
  if (auto const bracket = name.find(" ("); bracket != std::string::npos) name.replace(bracket, 1, "\\n");
  return '"' + name + '"';
}

Scale scale_for(Range const& range, std::string_view name, std::string_view unit) {
  double const largest = std::max(std::abs(range.low), std::abs(range.high));
  int const decade = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  bool const is_plain = decade >= -2 && decade <= 3;
  int const power = is_plain ? 0 : 3 * static_cast<int>(std::floor(decade / 3.0));
  bool const has_unit = unit != "-" && unit != "1" && !unit.empty();
  std::string inside = power == 0 ? "" : fmt::format("10^{}", power);
  if (has_unit) inside += (inside.empty() ? "" : " ") + std::string(unit);
  return {std::pow(10.0, power),
          gnuplot_string(fmt::format("{} ({})", gnuplot_symbol(name), inside.empty() ? "-" : gnuplot_text(inside)))};
}

DeviceAxis::DeviceAxis(std::vector<std::string> const& devices, double axis_mm) : count(devices.size()) {
  constexpr double upright_mm = 2.9, longest_upright_mm = 22.0;
  std::size_t longest = 0;
  for (auto const& device : devices) longest = std::max(longest, character_count(printable(device)));
  double const room = axis_mm / static_cast<double>(std::max<std::size_t>(1, count));
  double const wide = letter_mm * static_cast<double>(longest);
  bool const fits_flat = wide + letter_mm <= room;
  names = fits_flat || (room >= upright_mm && wide <= longest_upright_mm);
  upright = names && !fits_flat;
  label_mm = upright ? wide : 3.0;
}

void DeviceAxis::draw(Script& script) const {
  script.line("set xrange [0.5:{}.5]", count);
  if (names) {
    script.line("set xtics {} nomirror noenhanced scale 0.4", upright ? "rotate by 90 right" : "norotate");
    script.line("set xlabel 'Device' offset 0,raise");
    return;
  }
  auto const step = std::max<std::size_t>(1, static_cast<std::size_t>(nice_step(static_cast<double>(count), 8)));
  script.line("set xtics norotate nomirror autofreq {},{},{}", step == 1 ? 1 : step, step, count);
  script.line("set xlabel 'Device, number' offset 0,raise");
}

void draw_law_axis(Script& script, std::vector<std::string> const& laws) {
  std::vector<std::string> tics;
  for (auto const& law : laws) tics.push_back(fmt::format("{} {}", law_tic(law), tics.size() + 1));
  script.line("set xrange [0.5:{}.5]; set xtics scale 0 noenhanced ({})", laws.size(), joined(tics));
  for (std::size_t i = 1; i < laws.size(); ++i)
    script.line("set arrow from first {0}.5,graph 0 to first {0}.5,graph 1 nohead ls {1} dt 3 lw 0.5", i, grey);
}

void set_log_axis(Script& script, Range const& range) {
  auto const padded = range.padded_log(0.06);
  script.line("set logscale y; set yrange [{}:{}]; set ytics mirror ({})", number(padded.low), number(padded.high),
              log_tics(padded));
}

}  // namespace isolaw::render
