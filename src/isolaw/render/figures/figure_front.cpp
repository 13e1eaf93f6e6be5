#include <algorithm>
#include <array>

#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/study/published.hpp"

namespace isolaw::render {
namespace {

struct FrontWords {
  std::string name, about, x_label, y_label, columns;
};

FrontWords words_of(FrontView view) {
  switch (view) {
    case FrontView::runs:
      return {"front", "accuracy (mean objective) against robustness (beta), Fig. 14", "Robustness index β (-)",
              "Mean objective {/:Italic OF} (-)", "law beta mean_OF on_front mark"};
    case FrontView::converged:
      return {"front_converged", "accuracy against robustness without the optimiser's noise",
              "β of the least objectives (-)", "Least objective {/:Italic OF} (-)",
              "law beta_converged least_OF on_front mark"};
    case FrontView::left_out:
      break;
  }
  return {"front_left_out", "least objective against the objective on devices left out",
          "{/:Italic OF} on a device by the law of all others (-)", "Least objective {/:Italic OF} (-)",
          "law OF_on_devices_left_out least_OF on_front mark"};
}

struct Box {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;  // mm
};

double overlap(Box const& a, Box const& b) {
  double const wide = std::min(a.right, b.right) - std::max(a.left, b.left);
  double const tall = std::min(a.high, b.high) - std::max(a.low, b.low);
  return wide > 0.0 && tall > 0.0 ? wide * tall : 0.0;
}

struct NamePlace {
  double dx_mm = 0.0, dy_mm = 0.0;
  std::string_view align;
};

template <class At>
std::vector<std::pair<double, double>> along_front(std::vector<FrontPoint> points, At const& at) {
  constexpr int steps = 60;  // number of points on each straight piece
  std::erase_if(points, [](auto const& point) { return !point.is_unbeaten; });
  std::ranges::stable_sort(points, {}, &FrontPoint::x);
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    auto const [x0, y0] = at(points[i]);
    auto const [x1, y1] = at(points[i + 1]);
    for (int k = 0; k <= steps; ++k) line.emplace_back(x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps);
  }
  return line;
}

// Returns the laws of the published study as points. They are named 1, 2, ... as in the study, which has results for
// FrontView::runs only.
std::vector<FrontPoint> published_points(Summary const& summary, FrontView view) {
  std::vector<FrontPoint> points;
  auto const known = view == FrontView::runs ? study::published(summary) : std::nullopt;
  if (!known) return points;
  for (auto const& row : known->laws) {
    auto const name = std::to_string(row.number);
    if (points.empty() || points.back().law != name)
      points.push_back({name, *row.printed.beta, *row.printed.objective, row.printed.on_front});
  }
  return points;
}

std::vector<NamePlace> place_names(std::vector<FrontPoint> const& points, std::vector<FrontPoint> const& published,
                                   Range const& x, Range const& y, double width_mm, double height_mm) {
  constexpr double letter_height_mm = 2.6, marker_mm = 1.3, line_mm = 0.4;
  // Places for a name: first those beside the marker, then those one line farther away.
  static constexpr std::array<NamePlace, 14> candidates{{{2.0, 0.0, "left"},
                                                         {-2.0, 0.0, "right"},
                                                         {0.0, 2.4, "center"},
                                                         {0.0, -2.4, "center"},
                                                         {1.6, 1.9, "left"},
                                                         {1.6, -1.9, "left"},
                                                         {-1.6, 1.9, "right"},
                                                         {-1.6, -1.9, "right"},
                                                         {0.0, 5.0, "center"},
                                                         {0.0, -5.0, "center"},
                                                         {1.6, 4.5, "left"},
                                                         {1.6, -4.5, "left"},
                                                         {-1.6, 4.5, "right"},
                                                         {-1.6, -4.5, "right"}}};
  auto const at = [&](FrontPoint const& point) {
    return std::pair((point.x - x.low) / (x.high - x.low) * width_mm, (point.y - y.low) / (y.high - y.low) * height_mm);
  };
  std::vector<Box> taken;
  for (auto const* some : {&points, &published})
    for (auto const& point : *some) {
      auto const [px, py] = at(point);
      taken.push_back({px - marker_mm, px + marker_mm, py - marker_mm, py + marker_mm});
    }
  for (auto const& [px, py] : along_front(points, at))
    taken.push_back({px - line_mm, px + line_mm, py - line_mm, py + line_mm});
  std::vector<NamePlace> chosen;
  for (auto const& point : points) {
    auto const [x_mm, y_mm] = at(point);
    double const px = x_mm, py = y_mm;  // clang 14 cannot capture structured bindings in a lambda
    double const wide = letter_mm * static_cast<double>(laws::display_name(point.law).size());
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

std::string_view mark_of(FrontPoint const& point) {
  return point.is_unbeaten ? "filled" : point.is_adequate ? "open" : "cross";
}

std::string front_data(std::vector<FrontPoint> points, std::vector<FrontPoint> const& published,
                       FrontWords const& words) {
  DataTable table;
  table.comment(words.about).comment("all values are without a unit").comment(words.columns);
  for (auto const& point : points) table.row(point.law, point.x, point.y, std::size_t{point.on_front}, mark_of(point));
  table.end_block();
  table.comment("the front, from left to right");
  std::ranges::stable_sort(points, {}, &FrontPoint::x);
  for (auto const& point : points)
    if (point.is_unbeaten) table.row(point.law, point.x, point.y, std::size_t{point.on_front}, mark_of(point));
  if (published.empty()) return table.take();
  table.end_block();
  table.comment("the published study (Table A.5), by law number");
  for (auto const& point : published) table.row(point.law, point.x, point.y, std::size_t{point.on_front});
  return table.take();
}

std::string front_script(std::vector<FrontPoint> const& points, std::vector<FrontPoint> const& published,
                         FrontWords const& words) {
  constexpr double height_mm = 70.0, left = 14.0, right = 3.0, bottom = 9.5, top = 6.5;
  Range x, y;
  for (auto const* some : {&points, &published})
    for (auto const& point : *some) {
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
  auto const places = place_names(points, published, x, y, single_column_mm - left - right, height_mm - bottom - top);
  // gnuplot measures offsets in letters, which are on average over SVG and PDF 1.65 mm wide and 3.2 mm high.
  for (std::size_t i = 0; i < points.size(); ++i)
    script.line("set label {} {} noenhanced at {},{} {} offset {},{}", i + 1,
                gnuplot_string(laws::display_name(points[i].law)), number(points[i].x), number(points[i].y),
                places[i].align, number(places[i].dx_mm / 1.65), number(places[i].dy_mm / 3.2));
  auto const file = words.name + ".dat";
  std::vector<std::string> plots;
  auto const marked = [&](std::string_view mark, int style, int point, std::string_view title) {
    if (std::ranges::none_of(points, [&](auto const& one) { return mark_of(one) == mark; })) return;
    plots.push_back(
        fmt::format("'{}' index 0 using (strcol(5) eq '{}'?$2:NaN):3 with points ls {} pt {} ps 0.7 lw 1.6 title '{}'",
                    file, mark, style, point, title));
  };
  if (std::ranges::any_of(points, &FrontPoint::is_unbeaten))
    plots.push_back(fmt::format("'{}' index 1 using 2:3 with steps ls {} dt 2 notitle", file, green));
  marked("filled", green, front_point, "non-dominated");
  marked("open", vermillion, beaten_point, "dominated");
  marked("cross", vermillion, inadequate_point, "not adequate");
  if (!published.empty())
    plots.push_back(fmt::format(
        "'{0}' index 2 using 2:3 with points ls {1} pt 6 ps 0.9 title 'published', '{0}' index 2 using 2:3:1 with labels font ',5' textcolor ls {1} notitle",
        file, grey));
  script.line("plot {}", joined(plots));
  return script.take();
}

}  // namespace

MaybeFigure front_figure(Summary const& summary, FrontView view) {
  auto const points = front_points(summary, view);
  if (points.empty()) return std::nullopt;
  auto const words = words_of(view);
  auto const published = published_points(summary, view);
  return Figure{words.name, front_data(points, published, words), front_script(points, published, words)};
}

}  // namespace isolaw::render
