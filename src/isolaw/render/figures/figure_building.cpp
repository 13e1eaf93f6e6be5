#include <algorithm>
#include <array>
#include <cmath>

#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/render/figures/building_figures.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

constexpr std::array<std::string_view, 2> drawn{"isolator_mm", "shear_over_weight"};
building::Quantity const& drawn_quantity(std::size_t i) {
  return building::quantity(drawn.at(i));
}

building::Distribution const& distribution_of(building::LawAnswer const& law, building::Quantity const& quantity) {
  return law.distributions[static_cast<std::size_t>(&quantity - building::quantities().data())];
}

std::string axis_label(building::Quantity const& quantity, std::string_view unit) {
  auto title = std::string(quantity.title);
  title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return gnuplot_label(fmt::format("{} ({})", title, unit));
}

struct Line {
  double at = 0.0;
  int style = black, dash = 1;
};

Figure histograms_figure(building::Answers const& answers, UnitSystem const& units) {
  std::string const name = "building_histograms";
  std::string const about = "draws of the building between the bound analyses";
  auto const columns = drawn.size();
  Grid const grid{.columns = static_cast<int>(columns),
                  .rows = static_cast<int>(answers.laws.size()),
                  .width_mm = double_column_mm,
                  .panel_height_mm = 34.0,
                  .margins = {.left = 13.0, .right = 3.0, .bottom = 10.0, .top = 6.0}};
  DataTable table;
  table.comment(about);
  table.comment("middle_of_bin width percent_of_draws");
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.line("set style fill solid 0.55 border; set boxwidth");
  script.line("set multiplot");
  std::vector<Range> ranges(columns);
  for (std::size_t q = 0; q < columns; ++q)
    for (auto const& law : answers.laws) {
      auto const& d = distribution_of(law, drawn_quantity(q));
      auto const& h = d.histogram;
      auto const factor = shown_unit(drawn_quantity(q).unit, units).factor;
      for (double const v : {d.lower, d.nominal, d.upper}) ranges[q].add(factor * v);
      if (h.counts.empty()) continue;
      ranges[q].add(factor * h.from);
      ranges[q].add(factor * (h.from + h.width * static_cast<double>(h.counts.size())));
    }
  std::size_t panel = 0;
  for (std::size_t l = 0; l < answers.laws.size(); ++l)
    for (std::size_t q = 0; q < columns; ++q, ++panel) {
      auto const& law = answers.laws[l];
      auto const& d = distribution_of(law, drawn_quantity(q));
      auto const& h = d.histogram;
      auto const [unit, factor] = shown_unit(drawn_quantity(q).unit, units);
      // The bars are percentages of all draws. A draw whose response is not finite lies in no bin, so the bars of a law
      // with such draws add up to less than 100 %.
      auto const all = static_cast<double>(law.draws);
      for (std::size_t i = 0; i < h.counts.size(); ++i)
        table.row(factor * (h.from + (static_cast<double>(i) + 0.5) * h.width), factor * h.width,
                  100.0 * static_cast<double>(h.counts[i]) / all);
      table.end_block();
      script.place(grid, panel);
      auto const range = ranges[q].padded(0.05);
      script.line("set xrange [{}:{}]; set yrange [0:{}]", number(range.low), number(range.high),
                  number(h.counts.empty() ? 1.0 : 108.0 * static_cast<double>(std::ranges::max(h.counts)) / all));
      script.line("set xlabel {} offset 0,raise; set ylabel 'Draws (%)' offset inward,0",
                  axis_label(drawn_quantity(q), unit));
      script.line("set label 1 {} at graph 0,1.07 left noenhanced", gnuplot_string(laws::display_name(law.law)));
      int arrow = 0;
      for (auto const& line : {Line{d.lower, vermillion, 1}, Line{d.nominal, black, 3}, Line{d.upper, vermillion, 2}}) {
        ++arrow;
        if (std::isfinite(line.at))
          script.line("set arrow {0} from first {1},graph 0 to first {1},graph 1 nohead front ls {2} dt {3}", arrow,
                      number(factor * line.at), line.style, line.dash);
        else
          script.line("unset arrow {}", arrow);  // otherwise the previous panel's arrow would stay
      }
      script.line("plot '{}.dat' index {} using 1:3:2 with boxes ls {} lw 0.5", name, panel, style_of(l));
    }
  script.line("unset multiplot");
  return {name, table.take(), script.take()};
}

Figure variance_figure(building::Answers const& answers) {
  std::string const name = "building_variance";
  std::string const about = "parts of the spread of the largest displacement of a bearing";
  Margins const margins{.left = 13.0, .right = 3.0, .bottom = 10.0, .top = 10.5};  // top: room for two lines of the key
  constexpr std::size_t most_in_a_column = 3;
  auto const grid = grid_of(1, 42.0, margins, answers.laws.size() > most_in_a_column ? 1 : 2);
  auto const& quantity = drawn_quantity(0);
  bool const uncertain = std::ranges::any_of(
      answers.laws, [&](auto const& law) { return distribution_of(law, quantity).uncertain_std_ln.has_value(); });
  DataTable table;
  table.comment(about);
  table.comment("law motions lot populations, standard deviations of ln");
  std::vector<std::string> tics;
  for (auto const& law : answers.laws) {
    auto const& d = distribution_of(law, quantity);
    table.row(law.law, d.motion_std_ln, d.lot_std_ln, d.uncertain_std_ln);
    tics.push_back(fmt::format("{} {}", law_tic(std::string(laws::display_name(law.law))), tics.size()));
  }
  table.end_block();
  Script script(name, about, grid.width_mm, grid.height_mm());
  script.margins(margins.left, margins.right, margins.bottom, margins.top);
  script.line("set key at graph 0,1.02 left bottom horizontal Left reverse samplen 1.2");
  script.line("set style data histograms; set style histogram clustered gap 1; set style fill solid 0.8 border");
  script.line("set xtics scale 0 noenhanced ({}); set xrange [-0.6:{}]", joined(tics),
              number(static_cast<double>(answers.laws.size()) - 0.4));
  script.line("set ylabel 'Scatter, {{/:Italic σ}}_{{ln}} (-)' offset inward,0; set yrange [0:*]");
  auto plot = fmt::format("'{0}.dat' using 2 ls {1} title 'motions', '{0}.dat' using 3 ls {2} title 'the lot'", name,
                          grey, blue);
  if (uncertain) plot += fmt::format(", '{}.dat' using 4 ls {} title 'uncertain population'", name, sky);
  if (answers.law_std_ln)
    plot += fmt::format(", {} with lines ls {} dt 2 title 'between laws'", number(*answers.law_std_ln), vermillion);
  script.line("plot {}", plot);
  return {name, table.take(), script.take()};
}

}  // namespace

std::vector<Figure> building_figures(building::Answers const& answers, UnitSystem const& units) {
  // Both figures show random draws of the building. If no law has any, there are no figures.
  if (std::ranges::none_of(answers.laws, [](auto const& law) { return law.draws > 0; })) return {};
  return {histograms_figure(answers, units), variance_figure(answers)};
}

FigureOutcome write_building_figures(building::Answers const& answers, UnitSystem const& units,
                                     std::filesystem::path const& dir) {
  return write_figures(building_figures(answers, units), dir);
}

}  // namespace isolaw::render
