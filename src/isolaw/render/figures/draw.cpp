#include "isolaw/render/figures/draw.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "isolaw/base/system.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/gnuplot.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

class Scratch {
 public:
  Scratch() {
    std::error_code error;
    auto const parent = fs::temp_directory_path(error);
    if (!error) path_ = make_private_directory(parent / "isolaw-figures");
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

// gnuplot's library Cairo writes the current time into a PDF. A fixed time of the same length replaces it, so that
// equal results give equal files.
void remove_date(std::string& pdf) {
  constexpr std::string_view before = "/CreationDate (D:";
  auto const at = pdf.find(before);
  if (at == std::string::npos) return;
  std::string_view const fixed = "20000101000000";
  auto const digits = at + before.size();
  if (pdf.find_first_not_of("0123456789", digits) >= digits + fixed.size() && digits + fixed.size() < pdf.size())
    pdf.replace(digits, fixed.size(), fixed);
}

bool take_over(fs::path const& from, fs::path const& to, std::string const& name) {
  auto const svg = text_of(figure_file(from, name, ".svg"));
  auto pdf = text_of(figure_file(from, name, ".pdf"));
  remove_date(pdf);
  bool const has_svg = svg.size() > 16 && svg.find("</svg>", svg.size() - 16) != std::string::npos;
  bool const has_pdf = pdf.size() > 16 && pdf.find("%%EOF", pdf.size() - 16) != std::string::npos;
  if (has_svg) write_file(figure_file(to, name, ".svg"), svg);
  if (has_pdf) write_file(figure_file(to, name, ".pdf"), pdf);
  return has_svg && has_pdf;
}

// Largest number of figures that one process of gnuplot draws. Their temporary files take disk space until all of them
// are drawn.
constexpr std::size_t figures_per_process = 64;

// Draws `names` in one process. If a figure fails, a new process draws the next ones. Copies finished figures to `dir`.
void draw_batch(fs::path const& dir, std::vector<std::string> names, FigureOutcome& outcome) {
  Scratch const scratch;
  if (scratch.path().empty()) {
    outcome.reason = "no temporary folder can be made";
    return;
  }
  std::error_code error;
  for (auto const& name : names)
    for (auto const* extension : {".dat", ".gp"})
      fs::copy_file(figure_file(dir, name, extension), figure_file(scratch.path(), name, extension), error);
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

}  // namespace

fs::path figure_file(fs::path const& dir, std::string const& name, char const* extension) {
  return dir / (name + extension);
}

std::string text_of(fs::path const& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  return std::move(text).str();
}

void draw(fs::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome) {
  for (std::size_t first = 0; first < names.size() && !outcome.program_missing; first += figures_per_process) {
    auto const last = std::min(names.size(), first + figures_per_process);
    draw_batch(dir,
               {names.begin() + static_cast<std::ptrdiff_t>(first), names.begin() + static_cast<std::ptrdiff_t>(last)},
               outcome);
  }
}

}  // namespace isolaw::render
