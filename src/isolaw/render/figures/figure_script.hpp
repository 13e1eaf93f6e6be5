// Defines how the figures look: sizes and fonts for print, colours that colour-blind readers can tell apart (Okabe, Ito
// 2008), markers and dashes that differ even in grey print, a grid of panels, and an axis with the names of devices.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/render/results.hpp"
#include "isolaw/study/law_look.hpp"

namespace isolaw::render {

inline constexpr double single_column_mm = 84.0, double_column_mm = 174.0;
inline constexpr double letter_mm = 1.5;           // mean width of a letter at 7 pt
inline constexpr std::size_t most_samples = 4000;  // most points on a curve; more cannot be seen

// These are numbers of gnuplot line styles, which every script defines. The styles 1, 2, ... are the looks of laws
// (colour and marker); black and grey follow them.
inline constexpr int blue = 1, vermillion = 2, green = 3, sky = 6, black = law_look_count + 1, grey = black + 1;
constexpr int style_of(std::size_t law) {
  return static_cast<int>(look_of(law)) + 1;
}
std::string marked_style(std::size_t law);
// Every script begins with these words. isolaw removes a figure only if its script begins so, which shows that isolaw
// made it.
inline constexpr std::string_view script_mark = "# A figure of isolaw: ";

struct Margins {
  double left = 13.0, right = 3.0, bottom = 9.0, top = 3.0;  // around the axes of a panel, in mm
};

struct Grid {
  int columns = 1, rows = 1;
  double width_mm = single_column_mm, panel_height_mm = 40.0;  // width of the figure; height of the axes of one panel
  Margins margins;
  double head_mm = 0.0;  // room above all panels

  double panel_width_mm() const { return width_mm / columns - margins.left - margins.right; }
  double row_mm() const { return panel_height_mm + margins.top + margins.bottom; }
  double height_mm() const { return head_mm + rows * row_mm(); }
};

// Returns the distance between ticks of an axis: one, two or five times a power of ten, so that at most `steps`
// distances fit into the length.
double nice_step(double length, int steps);
// A single panel is as wide as one column of a printed page. Several panels together are as wide as two columns.
Grid grid_of(std::size_t panels, double panel_height_mm, Margins const& margins, int most_columns = 3);

class Script {
 public:
  Script(std::string_view name, std::string_view about, double width_mm, double height_mm);

  template <class... Args>
  Script& line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += "  " + fmt::format(format, std::forward<Args>(args)...) + "\n";
    return *this;
  }
  void place(Grid const& grid, std::size_t panel);
  void margins(double left_mm, double right_mm, double bottom_mm, double top_mm);
  std::string take();

 private:
  std::string text_;
  double width_mm_, height_mm_;
};
// Makes a user's text safe to draw: spells out control characters and cuts the text to the width.
std::string shortened(std::string_view text, double width_mm);

std::string number(double value);

constexpr std::string_view time_label(bool has_time) {
  return has_time ? "Time (s)" : "Sample";
}

inline std::string loop_units(bool has_time, UnitSystem const& units) {
  return fmt::format("time {}, displacement in {}, forces in {}", has_time ? "in s" : "as samples of the file",
                     units.length.symbol, units.force.symbol);
}

struct Range {
  double low = 0.0, high = 0.0;
  bool empty = true;

  void add(std::optional<double> const& value);
  Range padded(double share) const;      // for linear axes; the result has a length above zero
  Range padded_log(double share) const;  // for logarithmic axes
};

// A scale of an axis. Very large and very small values are drawn as multiples of a power of ten, which the label of the
// axis states.
struct Scale {
  double factor = 1.0;
  std::string label;  // for gnuplot, with the unit: 'K1 (10^{3} N/m)'
};
Scale scale_for(Range const& range, std::string_view name, std::string_view unit);
// Returns the name of a law for its place below an axis, as a quoted string. A part of the name in brackets goes to a
// second line.
std::string law_tic(std::string name);
// Draws an x axis on which law number k has the interval around k, with the law's name below it.
void draw_law_axis(Script& script, std::vector<std::string> const& laws);
// Makes the y axis logarithmic. Tics are at the decades, or closer together if the axis spans only a few decades.
void set_log_axis(Script& script, Range const& range);

// An x axis with an interval for each device. Below it stand the devices' names, or their numbers if the names are too
// long.
struct DeviceAxis {
  std::size_t count = 0;
  bool names = false, upright = false;
  double label_mm = 0.0;  // height of the labels

  DeviceAxis(std::vector<std::string> const& devices, double axis_mm);
  // gnuplot takes the names from column 2 of the data.
  std::string using_suffix() const { return names ? ":xticlabels(2)" : ""; }
  void draw(Script& script) const;
};

}  // namespace isolaw::render
