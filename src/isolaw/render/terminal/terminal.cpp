#include "isolaw/render/terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

// Code points, which are columns for the scripts met in names of devices and laws.
int columns(std::string_view text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

// Names come from files: a control character must not reach the terminal.
std::string printable(std::string_view text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto const byte = static_cast<unsigned char>(text[i]);
    bool const c1 = byte == 0xC2u && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0u;
    if (c1) ++i;
    clean += byte < 0x20u || byte == 0x7Fu || c1 ? ' ' : text[i];
  }
  return clean;
}

std::string padded(std::string_view text, int width, bool right = false) {
  std::string const blanks(static_cast<std::size_t>(std::max(0, width - columns(text))), ' ');
  return right ? blanks + std::string(text) : std::string(text) + blanks;
}

// Words of `text` broken at `width`, every line indented by `indent`, the first one starting with `bullet`.
std::string wrapped(std::string_view bullet, std::string_view text, int indent, int width) {
  std::string out, line(bullet);
  line = padded(line, indent);
  bool fresh = true;
  std::string const clean = printable(text);
  for (std::size_t at = 0; at < clean.size();) {
    std::size_t const end = std::min(clean.find(' ', at), clean.size());
    std::string_view const word = std::string_view(clean).substr(at, end - at);
    if (!fresh && columns(line) + 1 + columns(word) > width) {
      out += line + '\n';
      line.assign(static_cast<std::size_t>(indent), ' ');
      fresh = true;
    }
    if (!word.empty()) {
      if (!fresh) line += ' ';
      line += word;
      fresh = false;
    }
    at = end + 1;
  }
  return out + line + '\n';
}

// In at most ten characters, whatever the value.
std::string bounded(double value, int decimals, double largest = 1e5) {
  return std::abs(value) < largest ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.2e}", value);
}

std::string fixed(std::optional<double> const& value, int decimals) {
  return value && std::isfinite(*value) ? bounded(*value, decimals) : "–";
}

std::string law_table(Summary const& summary) {
  auto const order = by_objective(summary);
  int id_width = 3;
  for (auto const& law : summary.laws) id_width = std::max(id_width, columns(printable(law.id)));
  using Cells = std::array<std::string, 6>;
  struct Row {
    std::string number, id;
    Cells cells;
  };
  std::vector<Row> rows{{"", "law", {"mean OF ± std", "best", "beta", "front", "|dK| %", "|dE| %"}}};
  std::array widths{18, 8, 7, 7, 9, 9};
  auto const add = [&](std::string number, std::string id, Cells cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], columns(cells[i]) + 2);
    rows.push_back({std::move(number), std::move(id), std::move(cells)});
  };
  auto const line_of = [&](Row const& row) {
    auto const& [number, id, cells] = row;
    std::string line = padded(number, 3, true) + "  " + padded(id, id_width);
    for (std::size_t i = 0; i < cells.size(); ++i) line += padded(cells[i], widths[i], true);
    while (line.ends_with(' ')) line.pop_back();
    return line + '\n';
  };
  int place = 0;
  for (std::size_t const index : order) {
    auto const& law = summary.laws[index];
    bool const ranked = law.objective.mean && law.beta;
    auto const objective =
        law.objective.mean ? fixed(law.objective.mean, 4) + " ± " + fixed(law.objective.std, 4) : "–";
    add(law.objective.mean ? std::to_string(++place) : "–", printable(law.id),
        {objective, fixed(law.objective.best, 4), fixed(law.beta, 3),
         !ranked        ? "–"
         : law.on_front ? "●"
                        : "○",
         fixed(mean_magnitude(law, &DeviceFit::K_eff_error_percent), 1),
         fixed(mean_magnitude(law, &DeviceFit::energy_error_percent), 1)});
  }
  std::string text;
  for (auto const& row : rows) text += line_of(row);
  return text;
}

// The laws without the optimiser's noise.
std::string converged_table(Summary const& summary, int width) {
  std::vector<std::array<std::string, 8>> rows{
      {"law", "found", "least OF", "beta", "front", "left out", "worst", "open"}};
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    if (!law.objective_converged) continue;
    int open = 0, free = 0;
    for (auto const& fit : law.devices)
      for (auto const& p : fit.parameters) {
        free += p.analysis ? 1 : 0;
        open += p.analysis && p.analysis->identifiability == "undetermined" ? 1 : 0;
      }
    rows.push_back({printable(law.id), law.success_share ? fmt::format("{:.0f} %", 100.0 * *law.success_share) : "–",
                    fixed(law.objective_converged, 4), fixed(law.beta_converged, 3),
                    !law.beta_converged      ? "–"
                    : law.on_front_converged ? "●"
                                             : "○",
                    fixed(law.loo_objective, 4), fixed(law.loo_worst, 4),
                    free > 0 ? fmt::format("{:.0f} %", 100.0 * open / free) : "–"});
  }
  if (rows.size() == 1 || summary.missing_runs() > 0 || summary.missing_analyses() > 0) return {};
  std::array<int, 8> widths{};
  for (auto const& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]) + 2);
  std::string text = "Without the optimiser's noise\n";
  for (auto const& row : rows) {
    std::string line = "     " + padded(row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) line += padded(row[i], widths[i], true);
    text += line + '\n';
  }
  return text +
         wrapped(
             "",
             "found: runs that reached the least OF known, of a named record or of this campaign; left out: OF on a device by the law of all others, mean and worst; open: parameters that the tests do not determine",
             5, width);
}

// Objectives on each block, means over the devices that have it.
std::string prediction_table(Summary const& summary) {
  std::map<int, bool> blocks;  // number, and whether it was fitted
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      for (auto const& score : fit.blocks) blocks[score.block] = score.fitted;
  if (blocks.empty()) return {};
  std::vector<std::vector<std::string>> rows{{"law"}};
  constexpr std::size_t most = 6;
  std::size_t shown = 0;
  for (auto const& [block, fitted] : blocks)
    if (shown++ < most) rows.front().push_back(fmt::format("block {}{}", block, fitted ? ", fitted" : ""));
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    if (!law.predicted_objective) continue;
    std::vector<std::string> row{printable(law.id)};
    for (auto const& [block, fitted] : blocks) {
      if (row.size() > most) break;
      double sum = 0.0;
      int count = 0;
      for (auto const& fit : law.devices)
        for (auto const& score : fit.blocks)
          if (score.block == block) {
            sum += score.objective;
            ++count;
          }
      row.push_back(count > 0 ? bounded(sum / count, 4) : "–");
    }
    if (law.prediction_collapses) row.back() += "  collapses";
    rows.push_back(std::move(row));
  }
  if (rows.size() == 1) return {};
  std::string text = "OF on blocks, predicted where not fitted\n";
  for (auto const& row : rows) {
    std::string line = "     " + padded(row[0], 10);
    for (std::size_t i = 1; i < row.size(); ++i) {
      auto const collapse = row[i].find("  collapses");
      line += padded(row[i].substr(0, collapse), std::max(12, columns(rows[0][i]) + 2), true);
      if (collapse != std::string::npos) line += "  collapses";
    }
    text += line + '\n';
  }
  if (blocks.size() > most)
    text += fmt::format("     and {} more blocks: tables/prediction.csv\n", blocks.size() - most);
  return text;
}

// A character raster addressed by column and row, of code points.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width), height_(height), cells_(static_cast<std::size_t>(width * height), U' ') {}

  bool is_free(int column, int row, int length) const {
    if (row < 0 || row >= height_ || column < 0 || column + length > width_) return false;
    for (int i = 0; i < length; ++i)
      if (cells_[index(column + i, row)] != U' ') return false;
    return true;
  }
  void put(int column, int row, char32_t c) { cells_[index(column, row)] = c; }
  int width() const { return width_; }
  std::string line(int row) const {
    std::string text;
    for (int column = 0; column < width_; ++column) append(text, cells_[index(column, row)]);
    while (text.ends_with(' ')) text.pop_back();
    return text;
  }
  static void append(std::string& text, char32_t c) {
    auto const byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
    if (c < 0x80) {
      text += byte(c);
    } else if (c < 0x800) {
      text += {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
    } else {
      text += {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
    }
  }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * width_ + column); }

  int width_, height_;
  std::vector<char32_t> cells_;
};

// Beside, above or below the point, wherever there is room; a label without room is left out (the table has it).
void put_label(Canvas& canvas, int column, int row, std::string_view id) {
  int const length = static_cast<int>(id.size());  // identifiers of laws are ASCII
  std::array const places{
      std::pair{column + 2, row},     std::pair{column - 1 - length, row},     std::pair{column + 2, row - 1},
      std::pair{column + 2, row + 1}, std::pair{column - 1 - length, row - 1}, std::pair{column - 1 - length, row + 1}};
  for (auto const& [x, y] : places) {
    int const after = x + length < canvas.width() ? 1 : 0;  // a blank on both sides keeps it apart from its neighbours
    if (!canvas.is_free(x - 1, y, 1 + length + after)) continue;
    for (int i = 0; i < length; ++i) canvas.put(x + i, y, static_cast<char32_t>(id[static_cast<std::size_t>(i)]));
    return;
  }
}

struct Axis {
  double lower, upper;

  // The data's range with a margin, never degenerate.
  static Axis around(std::vector<double> const& values) {
    constexpr double largest = 1e300;  // what lies beyond is drawn at the edge
    auto const [least, most] = std::minmax_element(values.begin(), values.end());
    double const low = std::clamp(*least, -largest, largest), high = std::clamp(*most, -largest, largest);
    double const margin = high > low ? 0.08 * (high - low) : 0.1 * std::max(std::abs(low), 1e-12);
    return {low - margin, high + margin};
  }
  int cell(double value, int cells) const {
    double const share = std::clamp((value - lower) / (upper - lower), 0.0, 1.0);
    return static_cast<int>(std::lround(share * (cells - 1)));
  }
};

// In at most eight characters.
std::string tick_text(double value) {
  return std::abs(value) < 1e3 ? fmt::format("{:.3f}", value) : fmt::format("{:.1e}", value);
}

std::string front_plot(Summary const& summary, int width) {
  std::vector<LawResult const*> laws;
  std::vector<double> betas, objectives;
  for (auto const& law : summary.laws) {
    if (!law.objective.mean || !law.beta) continue;
    laws.push_back(&law);
    betas.push_back(*law.beta);
    objectives.push_back(*law.objective.mean);
  }
  constexpr int margin = 9, height = 13;
  int const plot_width = width - margin - 1;
  auto const x = Axis::around(betas), y = Axis::around(objectives);
  Canvas canvas(plot_width, height);
  auto const column = [&](LawResult const& law) { return x.cell(*law.beta, plot_width); };
  auto const row = [&](LawResult const& law) { return height - 1 - y.cell(*law.objective.mean, height); };
  for (auto const* law : laws) canvas.put(column(*law), row(*law), law->on_front ? U'●' : U'○');
  for (auto const* law : laws) put_label(canvas, column(*law), row(*law), printable(law->id));

  std::string text = "  mean OF, lower is more accurate\n";
  for (int r = 0; r < height; ++r) {
    bool const tick = r % 4 == 0;
    double const value = y.upper - (y.upper - y.lower) * r / (height - 1);
    text += padded(tick ? tick_text(value) + ' ' : "", margin, true) + (tick ? "┤" : "│") + canvas.line(r) + '\n';
  }
  std::string axis, numbers(static_cast<std::size_t>(margin + 1), ' ');
  for (int c = 0; c < plot_width; ++c) axis += c > 0 && c % 16 == 0 ? "┬" : "─";
  for (int c = 16; c + 3 < plot_width; c += 16) {
    double const value = x.lower + (x.upper - x.lower) * c / (plot_width - 1);
    numbers = padded(numbers, margin + 1 + c - 2) + tick_text(value);
  }
  text += padded("", margin) + "└" + axis + '\n' + numbers + '\n';
  text += padded("beta, lower is more robust", width, true) + '\n';
  text += "  ● not dominated   ○ dominated: another law is as accurate and as robust\n";
  return text;
}

std::string objective_bars(Summary const& summary, int width) {
  int id_width = 3;
  double largest = 0.0;
  for (auto const& law : summary.laws) {
    id_width = std::max(id_width, columns(printable(law.id)));
    largest = std::max(largest, law.objective.mean.value_or(0.0));
  }
  std::string text = "  mean OF, shorter is more accurate\n";
  int const room = width - id_width - 12;
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    text += "  " + padded(printable(law.id), id_width) + ' ';
    if (!law.objective.mean) {
      text += "not identified\n";
      continue;
    }
    int const eighths = largest > 0.0 ? static_cast<int>(std::lround(8.0 * room * (*law.objective.mean / largest))) : 0;
    for (int i = 0; i < eighths / 8; ++i) text += "█";
    if (eighths % 8 > 0) Canvas::append(text, U'█' + static_cast<char32_t>(8 - eighths % 8));
    text += ' ' + fixed(law.objective.mean, 4) + '\n';
  }
  return text;
}

std::string heading(Summary const& summary, int width) {
  auto const refused = std::count_if(summary.devices.begin(), summary.devices.end(),
                                     [](auto const& device) { return device.status != "ok"; });
  auto const runs =
      summary.missing_runs() > 0 ? fmt::format(", {} of {} runs", summary.runs, summary.expected_runs) : std::string();
  auto const text =
      fmt::format("{}: {} device{}{}, {} law{}{}, seed {}", summary.title.empty() ? "isolaw" : summary.title,
                  summary.devices.size(), summary.devices.size() == 1 ? "" : "s",
                  refused > 0 ? fmt::format(" ({} refused)", refused) : "", summary.laws.size(),
                  summary.laws.size() == 1 ? "" : "s", runs, summary.seed);
  return wrapped("", text, 0, width);
}

}  // namespace

std::string ranking(Summary const& summary, int width) {
  width = std::max(width, 60);
  auto const found = findings(summary);
  std::string text = heading(summary, width) + '\n' + law_table(summary) + '\n';
  text += wrapped("", found.headline, 0, width);
  if (auto const converged = converged_table(summary, width); !converged.empty()) text += '\n' + converged;
  if (auto const prediction = prediction_table(summary); !prediction.empty()) text += '\n' + prediction;
  if (!found.converged.empty()) text += '\n';
  for (auto const& sentence : found.converged) text += wrapped("", sentence, 0, width);
  if (!found.warnings.empty()) {
    text += "\nTake care:\n";
    for (auto const& warning : found.warnings) text += wrapped("  -", warning.sentence, 4, width);
  }
  text += '\n';
  if (found.beta_note.empty()) return text + front_plot(summary, width);
  text += wrapped("", "The robustness index beta is undefined: " + found.beta_note + ".", 0, width) + '\n';
  return text + objective_bars(summary, width);
}

}  // namespace isolaw::render
