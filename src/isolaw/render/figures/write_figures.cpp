#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>

#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/draw.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

void remove_drawings(fs::path const& dir, std::string const& name) {
  std::error_code ignored;
  for (auto const* extension : {".svg", ".pdf"}) fs::remove(figure_file(dir, name, extension), ignored);
}

std::vector<std::string> own_figures(fs::path const& dir) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (auto const& entry : fs::directory_iterator(dir, ignored)) {
    if (entry.path().extension() != ".gp" || !entry.is_regular_file(ignored)) continue;
    std::string start(script_mark.size(), '\0');
    std::ifstream(entry.path(), std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start == script_mark) names.push_back(entry.path().stem().string());
  }
  return names;
}

void remove_figure(fs::path const& dir, std::string const& name) {
  std::error_code ignored;
  remove_drawings(dir, name);
  for (auto const* extension : {".dat", ".gp"}) fs::remove(figure_file(dir, name, extension), ignored);
}

// Writes data and script of a figure, if they have changed. It first removes the old drawings, so that a drawing always
// fits the data file beside it.
void write_sources(fs::path const& dir, Figure const& figure) {
  auto const data = figure_file(dir, figure.name, ".dat"), script = figure_file(dir, figure.name, ".gp");
  if (text_of(data) == figure.data && text_of(script) == figure.script) return;
  remove_drawings(dir, figure.name);
  write_file(data, figure.data);
  write_file(script, figure.script);
}

bool is_drawn(fs::path const& dir, std::string const& name) {
  std::error_code ignored;
  return fs::is_regular_file(figure_file(dir, name, ".svg"), ignored) &&
         fs::is_regular_file(figure_file(dir, name, ".pdf"), ignored);
}

using Use = std::function<void(Figure const&)>;

enum class Others { removed, kept };  // what happens to isolaw's other figures in the same folder

FigureOutcome write_each(fs::path const& dir, Others others, std::function<void(Use const&)> const& for_each) {
  FigureOutcome outcome;
  auto const folder = dir / "figures";
  make_folder(folder);
  std::set<std::string> chosen;
  std::vector<std::string> missing;
  for_each([&](Figure const& figure) {
    write_sources(folder, figure);
    chosen.insert(figure.name);
    if (!is_drawn(folder, figure.name)) missing.push_back(figure.name);
  });
  if (others == Others::removed)
    for (auto const& name : own_figures(folder))
      if (!chosen.contains(name)) remove_figure(folder, name);
  outcome.figures = chosen.size();
  outcome.drawn = chosen.size() - missing.size();
  draw(folder, missing, outcome);
  return outcome;
}

// Removes figures whose results differ from those in `summary`, so that no figure contradicts the reports beside it.
// Returns how many figures it removed.
std::size_t remove_outdated(Summary const& summary, fs::path const& dir) {
  auto const folder = dir / "figures";
  auto const own = own_figures(folder);
  std::set<std::string> outdated(own.begin(), own.end());
  for (auto const choice : {FigureChoice::lot, FigureChoice::all})
    // After the comparison with the figures of the choice `lot`, `outdated` is usually empty. The many figures of the
    // choice `all` then need not be made.
    if (!outdated.empty())
      for_each_figure(summary, choice, [&](Figure const& figure) {
        if (outdated.contains(figure.name) && text_of(figure_file(folder, figure.name, ".dat")) == figure.data)
          outdated.erase(figure.name);
      });
  for (auto const& name : outdated) remove_figure(folder, name);
  return outdated.size();
}

}  // namespace

FigureOutcome write_figures(Summary const& summary, FigureChoice choice, fs::path const& dir) {
  if (choice == FigureChoice::none) {
    FigureOutcome outcome;
    outcome.removed = remove_outdated(summary, dir);
    return outcome;
  }
  return write_each(dir, Others::removed, [&](Use const& use) { for_each_figure(summary, choice, use); });
}

FigureOutcome write_figures(std::vector<Figure> const& figures, fs::path const& dir) {
  return write_each(dir, Others::removed, [&](Use const& use) { std::ranges::for_each(figures, use); });
}

FigureOutcome add_figures(std::vector<Figure> const& figures, fs::path const& dir) {
  return write_each(dir, Others::kept, [&](Use const& use) { std::ranges::for_each(figures, use); });
}

void remove_figures(fs::path const& dir) {
  for (auto const& name : own_figures(dir / "figures")) remove_figure(dir / "figures", name);
}

}  // namespace isolaw::render
