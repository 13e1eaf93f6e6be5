#include "isolaw/render/figures/figures.hpp"

#include <algorithm>
#include <set>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/render/figures/conditions_figures.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/study/typical_device.hpp"

namespace isolaw::render {
namespace {

void for_each_lot_figure(Summary const& summary, std::function<void(MaybeFigure const&)> const& use) {
  for (auto const view : front_views) use(front_figure(summary, view));
  use(objective_figure(summary));
  use(objective_by_device_figure(summary));
  for (auto const& law : summary.laws) {
    use(parameters_figure(summary, law));
    use(convergence_figure(summary, law));
  }
  use(published_objective_figure(summary));
  for (auto const& law : summary.laws) use(published_parameters_figure(summary, law));
  use(properties_figure(summary));
  if (!summary.conditions) return;
  for (auto const& figure : conditions_figures(*summary.conditions, summary.units())) use(figure);
}

std::vector<std::string> device_stems(Summary const& summary) {
  std::vector<std::string> names, laws;
  for (auto const& device : summary.devices) names.push_back(device.name);
  for (auto const& law : summary.laws) laws.push_back(law.id);
  return file_stems(names, laws);
}

MaybeFigure loops_of_one_device(Summary const& summary) {
  auto const stems = device_stems(summary);
  if (auto const typical = typical_device(summary))
    if (auto figure = loops_of_laws_figure(summary, summary.devices[*typical], stems[*typical])) return figure;
  for (std::size_t d = 0; d < summary.devices.size(); ++d)
    if (auto figure = loops_of_laws_figure(summary, summary.devices[d], stems[d])) return figure;
  return std::nullopt;
}

void for_each_device_figure(Summary const& summary, std::function<void(MaybeFigure const&)> const& use) {
  auto const stems = device_stems(summary);
  for (std::size_t d = 0; d < summary.devices.size(); ++d) {
    use(record_figure(summary.units(), summary.devices[d], stems[d]));
    use(loops_of_laws_figure(summary, summary.devices[d], stems[d]));
    for (auto const& law : summary.laws) use(loops_figure(summary, summary.devices[d], law, stems[d]));
  }
}

std::string safe_stem(std::string_view name) {
  constexpr std::size_t longest = 60;
  std::string stem;
  for (char const c : name) {
    bool const plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    bool const point = c == '.' && !stem.empty();
    if (stem.size() < longest) stem += plain || point ? c : '_';
  }
  return stem.empty() ? "_" : stem;
}

}  // namespace

std::size_t place_in_summary(Summary const& summary, LawResult const& law) {
  auto const found = std::ranges::find(summary.laws, law.id, &LawResult::id);
  return static_cast<std::size_t>(found - summary.laws.begin());
}

FigureChoice figure_choice(std::string_view name) {
  if (name == "none") return FigureChoice::none;
  if (name == "lot") return FigureChoice::lot;
  if (name == "all") return FigureChoice::all;
  throw Error({.where = "--figures",
               .found = in_quotes(name) + " is no choice of figures",
               .allowed = "lot (of laws and the lot), all (of every device too), none",
               .advice = "--figures lot"});
}

std::vector<std::string> file_stems(std::vector<std::string> const& names, std::vector<std::string> const& endings) {
  std::vector<std::string> stems;
  std::set<std::string> taken;
  for (auto const& name : names) {
    auto const stem = safe_stem(name);
    auto unique = stem;
    auto const all = [&] {
      std::vector<std::string> variants{lower(unique)};
      for (auto const& ending : endings) variants.push_back(lower(unique + "_" + ending));
      return variants;
    };
    auto const is_taken = [&](std::string const& one) { return taken.contains(one); };
    for (int number = 2; std::ranges::any_of(all(), is_taken); ++number) unique = stem + "_" + std::to_string(number);
    for (auto const& one : all()) taken.insert(one);
    stems.push_back(unique);
  }
  return stems;
}

void for_each_figure(Summary const& summary, FigureChoice choice, std::function<void(Figure const&)> const& use) {
  auto const use_if_any = [&](MaybeFigure const& figure) {
    if (figure) use(*figure);
  };
  if (choice != FigureChoice::none) for_each_lot_figure(summary, use_if_any);
  if (choice == FigureChoice::lot) use_if_any(loops_of_one_device(summary));
  if (choice == FigureChoice::all) for_each_device_figure(summary, use_if_any);
}

std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary) {
  std::vector<std::pair<std::string, std::string>> texts;
  for_each_figure(summary, FigureChoice::lot,
                  [&](Figure const& figure) { texts.emplace_back("figures/" + figure.name + ".dat", figure.data); });
  return texts;
}

}  // namespace isolaw::render
