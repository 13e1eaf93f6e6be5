#include "isolaw/render/terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

// Returns the number of columns that a text takes on a terminal. Every character counts as one column, although letters
// of some scripts, such as Chinese, are two columns wide.
int columns(std::string_view text) {
  return static_cast<int>(character_count(text));
}

// Removes control characters. Names come from files, and their control characters must not reach the terminal.
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

std::string bounded(double value, int decimals, double largest = 1e5) {
  return std::abs(value) < largest ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.2e}", value);
}

std::string fixed(std::optional<double> const& value, int decimals) {
  return value && std::isfinite(*value) ? bounded(*value, decimals) : "–";
}

// Returns a standard deviation as text. A deviation that is too small for the printed digits must not look like zero.
std::string spread(std::optional<double> const& std) {
  constexpr double least = 1e-4;
  if (!std || *std >= least / 2.0) return fixed(std, 4);
  return *std > 0.0 ? "<1e-4" : "0";
}

struct Row {
  std::string place, id;
  std::vector<std::string> cells;
  std::string remark = {};
};

// Makes a column two blanks wider than its longest text, but at least as wide as `widths` says. The column of Row::id
// is `id_gap` blanks wider than its longest text, and at least `id_width` wide.
std::string table(std::vector<Row> const& rows, std::vector<int> widths, int id_width, int id_gap = 0) {
  widths.resize(rows.front().cells.size());
  for (auto const& row : rows) {
    id_width = std::max(id_width, columns(row.id) + id_gap);
    for (std::size_t i = 0; i < row.cells.size(); ++i) widths[i] = std::max(widths[i], columns(row.cells[i]) + 2);
  }
  std::string text;
  for (auto const& row : rows) {
    std::string line = padded(row.place, 3, true) + "  " + padded(row.id, id_width);
    for (std::size_t i = 0; i < row.cells.size(); ++i) line += padded(row.cells[i], widths[i], true);
    line += row.remark;
    while (line.ends_with(' ')) line.pop_back();
    text += line + '\n';
  }
  return text;
}

std::string front_mark(bool has_place, bool on_front) {
  return !has_place ? "–" : on_front ? "●" : "○";
}

std::string law_table(Summary const& summary) {
  std::vector<Row> rows{{"", "law", {"mean OF ± std", "best", "beta", "front", "|dK| %", "|dE| %"}}};
  int place = 0;
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    bool const found = law.objective.mean.has_value();
    rows.push_back({found ? std::to_string(++place) : "–",
                    printable(law.id),
                    {found ? fixed(law.objective.mean, 4) + " ± " + spread(law.objective.std) : "–",
                     fixed(law.objective.best, 4), fixed(law.beta, 3), front_mark(found && law.beta, law.on_front),
                     fixed(mean_magnitude(law, &DeviceFit::K_eff_error_percent), 1),
                     fixed(mean_magnitude(law, &DeviceFit::energy_error_percent), 1)}});
  }
  return table(rows, {18, 8, 7, 7, 9, 9}, 3);
}

// Returns a line of text if laws are fitted to only part of the tests, else "". The line says that |dK| and |dE|, the
// errors of K_eff and energy, then belong to another cycle than the reported one.
std::string compared_on(Summary const& summary, int width) {
  bool const part =
      std::ranges::any_of(summary.devices, [](auto const& device) { return !device.record.scored.empty(); });
  return part ? wrapped("",
                        "|dK|, |dE|: on the third counted cycle of largest amplitude among those that the laws were "
                        "judged by, not on the reported one",
                        5, width)
              : std::string();
}

std::string converged_table(Summary const& summary, int width) {
  std::vector<Row> rows{{"", "law", {"found", "least OF", "beta", "front", "left out", "worst", "open"}}};
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    if (!law.objective_converged) continue;
    int open = 0, free = 0;
    for (auto const& fit : law.counting())
      for (auto const& p : fit.parameters) {
        free += p.analysis ? 1 : 0;
        open += p.analysis && p.analysis->identifiability == analysis::Verdict::undetermined ? 1 : 0;
      }
    rows.push_back({"",
                    printable(law.id),
                    {law.success_share ? fmt::format("{:.0f} %", 100.0 * *law.success_share) : "–",
                     fixed(law.objective_converged, 4), fixed(law.beta_converged, 3),
                     front_mark(law.beta_converged.has_value(), law.on_front_converged), fixed(law.loo_objective, 4),
                     fixed(law.loo_worst, 4), free > 0 ? fmt::format("{:.0f} %", 100.0 * open / free) : "–"}});
  }
  if (rows.size() == 1 || summary.missing_runs() > 0 || summary.missing_analyses() > 0) return {};
  return "Without the optimiser's noise\n" + table(rows, {}, 0, 2) +
         wrapped(
             "",
             "found: runs that reached the least OF of this campaign; left out: OF on a device by the law of all others, mean and worst; open: parameters that the tests do not determine",
             5, width);
}

std::string prediction_table(Summary const& summary) {
  std::map<int, bool> blocks;  // block number, and whether the laws were fitted to it
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      for (auto const& score : fit.blocks) blocks[score.block] = score.fitted;
  if (blocks.empty()) return {};
  std::vector<Row> rows{{"", "law", {}}};
  constexpr std::size_t most = 6;
  std::size_t shown = 0;
  for (auto const& [block, fitted] : blocks)
    if (shown++ < most) rows.front().cells.push_back(fmt::format("block {}{}", block, fitted ? ", fitted" : ""));
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    if (!law.predicted_objective) continue;
    Row row{"", printable(law.id), {}, fmt::format("  {}", name(*law.prediction_grade))};
    for (auto const& [block, fitted] : blocks) {
      if (row.cells.size() == most) break;
      double sum = 0.0;
      int count = 0;
      for (auto const& fit : law.counting())
        for (auto const& score : fit.blocks)
          if (score.block == block) {
            sum += score.objective;
            ++count;
          }
      row.cells.push_back(count > 0 ? bounded(sum / count, 4) : "–");
    }
    rows.push_back(std::move(row));
  }
  if (rows.size() == 1) return {};
  auto text =
      "OF on blocks, predicted where not fitted\n" + table(rows, std::vector(rows.front().cells.size(), 12), 10);
  if (blocks.size() > most)
    text += fmt::format("     and {} more blocks: tables/prediction.csv\n", blocks.size() - most);
  return text;
}

class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width), height_(height), cells_(static_cast<std::size_t>(width * height), " ") {}

  bool is_free(int column, int row, int length) const {
    if (row < 0 || row >= height_ || column < 0 || column + length > width_) return false;
    for (int i = 0; i < length; ++i)
      if (cells_[index(column + i, row)] != " ") return false;
    return true;
  }
  void put(int column, int row, std::string_view character) { cells_[index(column, row)] = character; }
  int width() const { return width_; }
  std::string line(int row) const {
    std::string text;
    for (int column = 0; column < width_; ++column) text += cells_[index(column, row)];
    while (text.ends_with(' ')) text.pop_back();
    return text;
  }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * width_ + column); }

  int width_, height_;
  std::vector<std::string> cells_;
};

void put_label(Canvas& canvas, int column, int row, std::string_view id) {
  int const length = static_cast<int>(id.size());  // the ids of laws are ASCII
  std::array const places{
      std::pair{column + 2, row},     std::pair{column - 1 - length, row},     std::pair{column + 2, row - 1},
      std::pair{column + 2, row + 1}, std::pair{column - 1 - length, row - 1}, std::pair{column - 1 - length, row + 1}};
  for (auto const& [x, y] : places) {
    int const after = x + length < canvas.width() ? 1 : 0;  // room for a blank after the label
    if (!canvas.is_free(x - 1, y, 1 + length + after)) continue;
    for (int i = 0; i < length; ++i) canvas.put(x + i, y, id.substr(static_cast<std::size_t>(i), 1));
    return;
  }
}

struct Axis {
  double lower, upper;

  // Returns the range of the values with a margin. The range is never empty.
  static Axis around(std::vector<double> const& values) {
    constexpr double largest = 1e300;  // larger values are drawn at the edge
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
  for (auto const* law : laws) canvas.put(column(*law), row(*law), law->on_front ? "●" : "○");
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
  constexpr std::array<std::string_view, 8> parts{"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  for (std::size_t const index : by_objective(summary)) {
    auto const& law = summary.laws[index];
    text += "  " + padded(printable(law.id), id_width) + ' ';
    if (!law.objective.mean) {
      text += "not identified\n";
      continue;
    }
    int const eighths = largest > 0.0 ? static_cast<int>(std::lround(8.0 * room * (*law.objective.mean / largest))) : 0;
    for (int i = 0; i < eighths / 8; ++i) text += "█";
    text += parts[static_cast<std::size_t>(eighths % 8)];
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

std::string answers(Summary const& summary, Findings const& found, int width) {
  if (!found.recommendation) return {};
  auto const& advice = *found.recommendation;
  auto const& units = summary.units();
  auto text = wrapped("", wording::paragraph(advice.answer, units), 0, width);
  std::string line = wording::paragraph(advice.reasons, units);
  if (advice.law && !advice.doubts().empty())
    line += fmt::format(" Low confidence: {}.", wording::paragraph(advice.doubts(), units, "; ", false));
  if (!advice.range_findings.empty()) line += " " + wording::paragraph(advice.range_findings, units);
  if (!advice.improvements.empty())
    line += fmt::format(" To be surer: {}.", wording::paragraph(advice.improvements, units, "; "));
  text += wrapped("", line, 2, width);
  if (advice.programs) text += wrapped("", wording::sentence(*advice.programs, units) + ".", 2, width);
  for (auto const& standing : advice.standings)
    if (standing.reason)
      text += wrapped("",
                      fmt::format("{} is ruled out: {}.", laws::display_name(summary.laws[standing.law].id),
                                  wording::remark(*standing.reason, units)),
                      2, width);
  return text + '\n';
}

std::string short_table(Summary const& summary, Recommendation const& answer) {
  constexpr std::size_t most = 8;
  auto const any = [&](auto has) { return std::ranges::any_of(summary.laws, has); };
  auto const any_standing = [&](auto has) { return std::ranges::any_of(answer.standings, has); };
  bool const devices = any([](auto const& law) { return law.loo_objective.has_value(); });
  bool const blocks = any([](auto const& law) { return law.predicted_objective.has_value(); });
  bool const larger = !blocks && any_standing([](auto const& standing) { return standing.predicts.has_value(); });
  auto const percent = [](std::optional<double> const& error) {
    return error && std::isfinite(*error) ? fmt::format("{:.1f} %", 100.0 * *error) : std::string("–");
  };
  std::vector<Row> rows{{"", "law", {"fits"}}};
  if (devices) rows.front().cells.emplace_back("new device");
  if (devices && !blocks && !larger) rows.front().cells.emplace_back("worst");
  if (blocks) rows.front().cells.emplace_back("new blocks");
  if (larger) rows.front().cells.emplace_back("larger swings");
  rows.front().cells.emplace_back("free");
  for (auto const& standing : answer.standings) {
    if (rows.size() > most) break;
    auto const& law = summary.laws[standing.law];
    Row row{standing.rank == Rank::taken ? "●" : "○", printable(laws::display_name(law.id)), {percent(standing.fits)}};
    if (devices) row.cells.push_back(percent(law.loo_objective));
    if (devices && !blocks && !larger) row.cells.push_back(percent(law.loo_worst));
    if (blocks) row.cells.push_back(percent(law.predicted_objective));
    if (larger) row.cells.push_back(percent(standing.predicts));
    row.cells.push_back(standing.parameters > 0 ? std::to_string(standing.parameters) : "–");
    if (standing.rank == Rank::tied) row.remark = "   as good";
    if (standing.reason)
      row.remark = standing.reason->kind == FindingKind::out_not_identified ? "   not identified" : "   ruled out";
    rows.push_back(std::move(row));
  }
  auto text = table(rows, {}, 0, 1);
  if (auto const left = answer.standings.size() + 1 - rows.size(); left > 0)
    text += fmt::format("     and {} more: --details\n", left);
  return text;
}

}  // namespace

std::string wrapped(std::string_view bullet, std::string_view text, int indent, int width) {
  std::string out, line(bullet);
  line = padded(line, indent);
  bool fresh = true;
  std::string const clean = printable(text);
  for (std::size_t at = 0; at < clean.size();) {
    std::size_t end = std::min(clean.find(' ', at), clean.size());
    // A number stays with its percent sign.
    if (clean.compare(end, 2, " %") == 0) end = std::min(clean.find(' ', end + 1), clean.size());
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

std::string answer(Summary const& summary, std::string_view directory, std::string_view campaign, int width) {
  width = std::max(width, 60);
  constexpr int margin = 12;
  auto const found = findings(summary);
  auto text = heading(summary, width) + '\n';
  if (!found.recommendation) return text;
  auto const& shown = *found.recommendation;
  auto const& units = summary.units();
  auto const* law = shown.law ? &summary.laws[*shown.law] : nullptr;
  auto const weak = law != nullptr ? shown.doubts() : std::vector<Finding>();
  text += wrapped("", wording::paragraph(shown.answer, units), 0, width);
  if (law == nullptr) text += wrapped("", wording::paragraph(shown.reasons, units), 2, width);
  if (!weak.empty())
    text += wrapped("", fmt::format("Low confidence: {}.", wording::paragraph(weak, units, "; ", false)), 2, width);
  text += '\n' + short_table(summary, shown) + '\n';
  if (!shown.range_findings.empty())
    text += wrapped("Beyond", wording::paragraph(shown.range_findings, units), margin, width);
  if (!shown.improvements.empty())
    text += wrapped("To be surer", wording::paragraph(shown.improvements, units, "; ") + ".", margin, width);
  // Warnings that do not concern the answer are shown only with --details.
  auto concerned = found.warnings;
  std::erase_if(concerned, [&](Finding const& finding) { return !concerns_answer(summary, shown, finding); });
  auto const groups = wording::grouped(concerned), every = wording::grouped(found.warnings);
  constexpr std::size_t most = 2;
  constexpr auto screen = 25, below = 3;  // numbers of lines; `below` lines follow the warnings
  std::size_t told = 0;
  for (; told < std::min(most, groups.size()); ++told) {
    auto const warning = wrapped(told == 0 ? "Look at" : "", wording::sentence(groups[told], units, 3), margin, width);
    if (std::ranges::count(text + warning, '\n') + below > screen) break;
    text += warning;
  }
  if (every.size() > told)
    text +=
        wrapped(told == 0 ? "Look at" : "",
                counted(every.size() - told, told == 0 ? "warning" : "more warning") + ": --details", margin, width);
  // The command stays on one line so that it can be copied.
  if (law != nullptr) text += fmt::format("Next        {}\n", printable(export_command(summary, shown, campaign)));
  text += wrapped("Report", fmt::format("{}/report.html", directory), margin, width);
  return text;
}

std::string ranking(Summary const& summary, int width) {
  width = std::max(width, 60);
  auto const found = findings(summary);
  std::string text = heading(summary, width) + '\n' + answers(summary, found, width) + law_table(summary) +
                     compared_on(summary, width) + '\n';
  text += wrapped("", wording::paragraph(found.headline), 0, width);
  if (auto const converged = converged_table(summary, width); !converged.empty()) text += '\n' + converged;
  if (auto const prediction = prediction_table(summary); !prediction.empty()) text += '\n' + prediction;
  if (!found.converged.empty()) text += '\n';
  for (auto const& sentence : wording::sentences(found.converged, wording::anywhere, summary.units()))
    text += wrapped("", sentence, 0, width);
  if (!found.warnings.empty()) {
    text += "\nTake care:\n";
    for (auto const& sentence : wording::sentences(found.warnings, wording::in_report, summary.units()))
      text += wrapped("  -", sentence, 4, width);
  }
  text += '\n';
  if (found.beta_note.empty()) return text + front_plot(summary, width);
  text += wrapped("", "The robustness index beta is undefined: " + found.beta_note + ".", 0, width) + '\n';
  return text + objective_bars(summary, width);
}

}  // namespace isolaw::render
