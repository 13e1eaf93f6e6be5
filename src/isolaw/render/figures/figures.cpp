#include "isolaw/render/figures/figures.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures_of.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

void for_each_lot_figure(Summary const& summary, std::function<void(MaybeFigure const&)> const& use) {
  for (auto const view : front_views) use(front_figure(summary, view));
  use(objective_figure(summary));
  use(objective_by_device_figure(summary));
  for (auto const& law : summary.laws) {
    use(parameters_figure(summary, law));
    use(convergence_figure(summary, law));
  }
  use(properties_figure(summary));
}

// In file names; those of a device's figures may end in a law.
std::vector<std::string> device_stems(Summary const& summary) {
  std::vector<std::string> names, laws;
  for (auto const& device : summary.devices) names.push_back(device.name);
  for (auto const& law : summary.laws) laws.push_back(law.id);
  return file_stems(names, laws);
}

// Of the first device that has one.
MaybeFigure loops_of_one_device(Summary const& summary) {
  auto const stems = device_stems(summary);
  for (std::size_t d = 0; d < summary.devices.size(); ++d)
    if (auto figure = loops_of_laws_figure(summary, summary.devices[d], stems[d])) return figure;
  return std::nullopt;
}

void for_each_device_figure(Summary const& summary, std::function<void(MaybeFigure const&)> const& use) {
  auto const stems = device_stems(summary);
  for (std::size_t d = 0; d < summary.devices.size(); ++d) {
    use(record_figure(summary.devices[d], stems[d]));
    use(loops_of_laws_figure(summary, summary.devices[d], stems[d]));
    for (auto const& law : summary.laws) use(loops_figure(summary.devices[d], law, stems[d]));
  }
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
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

// --- files -----------------------------------------------------------------------------------------------------------

// Empty where there is no such file, or none that can be read.
std::string text_of(fs::path const& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  return std::move(text).str();
}

fs::path with(fs::path const& dir, std::string const& name, char const* extension) {
  return dir / (name + extension);
}

void remove_drawings(fs::path const& dir, std::string const& name) {
  std::error_code ignored;
  for (auto const* extension : {".svg", ".pdf"}) fs::remove(with(dir, name, extension), ignored);
}

// Names of isolaw's figures in `dir`.
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
  for (auto const* extension : {".dat", ".gp"}) fs::remove(with(dir, name, extension), ignored);
}

// Drawings of other data or by another script go first: what stands beside data is drawn from them.
void write_sources(fs::path const& dir, Figure const& figure) {
  auto const data = with(dir, figure.name, ".dat"), script = with(dir, figure.name, ".gp");
  if (text_of(data) == figure.data && text_of(script) == figure.script) return;
  remove_drawings(dir, figure.name);
  write_file(data, figure.data);
  write_file(script, figure.script);
}

bool is_drawn(fs::path const& dir, std::string const& name) {
  std::error_code ignored;
  return fs::is_regular_file(with(dir, name, ".svg"), ignored) && fs::is_regular_file(with(dir, name, ".pdf"), ignored);
}

// --- drawing ---------------------------------------------------------------------------------------------------------

// A folder of its own, removed with all in it.
class Scratch {
 public:
  Scratch() {
    std::error_code error;
    auto name = (fs::temp_directory_path(error) / "isolaw-figures-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Scratch(Scratch const&) = delete;
  Scratch& operator=(Scratch const&) = delete;
  ~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  fs::path const& path() const { return path_; }

 private:
  fs::path path_;
};

// Cairo states when a PDF was made: a fixed time of the same length, so that the same store gives the same bytes.
void remove_date(std::string& pdf) {
  constexpr std::string_view before = "/CreationDate (D:";
  auto const at = pdf.find(before);
  if (at == std::string::npos) return;
  std::string_view const fixed = "20000101000000";
  auto const digits = at + before.size();
  if (pdf.find_first_not_of("0123456789", digits) >= digits + fixed.size() && digits + fixed.size() < pdf.size())
    pdf.replace(digits, fixed.size(), fixed);
}

// Complete drawings are taken over, whole or not at all. Whether both are there.
bool take_over(fs::path const& from, fs::path const& to, std::string const& name) {
  auto const svg = text_of(with(from, name, ".svg"));
  auto pdf = text_of(with(from, name, ".pdf"));
  remove_date(pdf);
  bool const has_svg = svg.size() > 16 && svg.find("</svg>", svg.size() - 16) != std::string::npos;
  bool const has_pdf = pdf.size() > 16 && pdf.find("%%EOF", pdf.size() - 16) != std::string::npos;
  if (has_svg) write_file(with(to, name, ".svg"), svg);
  if (has_pdf) write_file(with(to, name, ".pdf"), pdf);
  return has_svg && has_pdf;
}

// Few figures to a process: a fault in one costs the few after it a second start, and a folder of few is soon emptied.
constexpr std::size_t figures_per_process = 64;

// Draws `names` in one process, or in as many as there are figures that cannot be drawn, and takes them over.
void draw_batch(fs::path const& dir, std::vector<std::string> names, FigureOutcome& outcome) {
  Scratch const scratch;
  if (scratch.path().empty()) {
    outcome.reason = "no temporary folder can be made";
    return;
  }
  std::error_code error;
  for (auto const& name : names)
    for (auto const* extension : {".dat", ".gp"})
      fs::copy_file(with(dir, name, extension), with(scratch.path(), name, extension), error);
  while (!names.empty()) {
    std::vector<std::string> scripts;
    for (auto const& name : names) scripts.push_back(name + ".gp");
    auto const end = run_gnuplot(scripts, scratch.path(), std::chrono::seconds(60 + 5 * names.size()));
    if (!end.started) {
      outcome.program_missing = true;
      outcome.reason = end.reason;
      return;
    }
    auto const failed =
        std::ranges::find_if_not(names, [&](std::string const& name) { return take_over(scratch.path(), dir, name); });
    outcome.drawn += static_cast<std::size_t>(failed - names.begin());
    if (failed == names.end()) return;
    if (outcome.reason.empty()) outcome.reason = *failed + ": " + (end.reason.empty() ? "incomplete" : end.reason);
    names.erase(names.begin(), failed + 1);
  }
}

void draw(fs::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome) {
  for (std::size_t first = 0; first < names.size() && !outcome.program_missing; first += figures_per_process) {
    auto const last = std::min(names.size(), first + figures_per_process);
    draw_batch(dir,
               {names.begin() + static_cast<std::ptrdiff_t>(first), names.begin() + static_cast<std::ptrdiff_t>(last)},
               outcome);
  }
}

}  // namespace

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
      std::vector<std::string> made{lower_case(unique)};
      for (auto const& ending : endings) made.push_back(lower_case(unique + "_" + ending));
      return made;
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

FigureOutcome write_figures(Summary const& summary, FigureChoice choice, fs::path const& dir) {
  FigureOutcome outcome;
  if (choice == FigureChoice::none) return outcome;
  auto const folder = dir / "figures";
  make_folder(folder);
  std::set<std::string> chosen;
  std::vector<std::string> missing;
  for_each_figure(summary, choice, [&](Figure const& figure) {
    write_sources(folder, figure);
    chosen.insert(figure.name);
    if (!is_drawn(folder, figure.name)) missing.push_back(figure.name);
  });
  for (auto const& name : own_figures(folder))
    if (!chosen.contains(name)) remove_figure(folder, name);
  outcome.figures = chosen.size();
  outcome.drawn = chosen.size() - missing.size();
  draw(folder, missing, outcome);
  return outcome;
}

void remove_figures(fs::path const& dir) {
  for (auto const& name : own_figures(dir / "figures")) remove_figure(dir / "figures", name);
}

std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary) {
  std::vector<std::pair<std::string, std::string>> texts;
  for_each_figure(summary, FigureChoice::lot,
                  [&](Figure const& figure) { texts.emplace_back("figures/" + figure.name + ".dat", figure.data); });
  return texts;
}

}  // namespace isolaw::render
