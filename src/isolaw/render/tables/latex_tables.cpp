#include "isolaw/render/tables/latex_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/symbol.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/render/tables/table_rows.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::render {
namespace {

constexpr std::string_view packages =
    "% Needs in the preamble: \\usepackage{booktabs}; with names beyond ASCII \\usepackage[T1]{fontenc} too.\n";
constexpr std::string_view packages_of_long =
    "% Needs in the preamble: \\usepackage{booktabs,longtable}; with names beyond ASCII \\usepackage[T1]{fontenc} too.\n";

constexpr std::string_view after_backslash = "&%$#_{}";
// Replacements for characters that LaTeX does not print as they are. For example, it prints ?` as another character,
// and it takes [ or * after a line break for an option.
constexpr std::pair<char, std::string_view> signs[]{{'~', "\\textasciitilde{}"},
                                                    {'^', "\\textasciicircum{}"},
                                                    {'\\', "\\textbackslash{}"},
                                                    {'<', "\\textless{}"},
                                                    {'>', "\\textgreater{}"},
                                                    {'|', "\\textbar{}"},
                                                    {'"', "''{}"},
                                                    {'`', "{}`"},
                                                    {'[', "{[}"},
                                                    {']', "{]}"},
                                                    {'*', "{*}"}};

// Letters outside Latin-1 that pdfLaTeX can print from UTF-8 without further packages.
constexpr std::string_view known_letters = "ĂăĄąĆćČčĎďĐđĘęĚěĞğİıĹĺĽľŁłŃńŇňŐőŒœŔŕŘřŚśŞşŠšŢţŤťŮůŰűŸŹźŻżŽž";

std::string latex_of_letter(std::string_view sequence) {
  auto const byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(sequence[i])); };
  unsigned code = sequence.size() == 2 ? (byte(0) & 0x1Fu) << 6 | (byte(1) & 0x3Fu)
                  : sequence.size() == 3
                      ? (byte(0) & 0x0Fu) << 12 | (byte(1) & 0x3Fu) << 6 | (byte(2) & 0x3Fu)
                      : (byte(0) & 0x07u) << 18 | (byte(1) & 0x3Fu) << 12 | (byte(2) & 0x3Fu) << 6 | (byte(3) & 0x3Fu);
  bool const is_latin_1 = code >= 0xC0 && code <= 0xFF && code != 0xD7 && code != 0xF7;
  if (is_latin_1 || known_letters.find(sequence) != std::string_view::npos) return std::string(sequence);
  if (code == 0xA0) return " ";
  if (code == 0xB0) return "$^{\\circ}$";
  if (code == 0xB5 || code == 0x3BC) return "$\\mu$";
  if (code == 0x2013) return "--";
  if (code == 0x2014) return "---";
  return fmt::format("(U+{:04X})", code);
}

constexpr std::size_t longest_head = 32;

std::string device_head(std::string const& device) {
  auto const clean = printable(device);
  std::size_t end = 0;
  for (std::size_t letters = 0; end < clean.size() && letters < longest_head; ++letters)
    end += utf8_length(std::string_view(clean).substr(end));
  return latex_text(std::string_view(clean).substr(0, end)) + (end < clean.size() ? "\\ldots" : "");
}

std::string yes(bool flag) {
  return flag ? "yes" : "no";
}

constexpr int digits_of_std = 2;

std::string block_head(std::vector<std::string> const& devices, std::size_t columns) {
  std::string names = "& ", rules, words = "Law & Quantity";
  for (std::size_t i = 0; i < columns; ++i) {
    bool const there = i < devices.size();
    names += there ? fmt::format("& \\multicolumn{{3}}{{c}}{{{}}} ", device_head(devices[i])) : "& & & ";
    if (there) rules += fmt::format("\\cmidrule(lr){{{}-{}}}", 3 * i + 3, 3 * i + 5);
    words += there ? " & $\\mu$ & $\\sigma$ & best" : " & & &";
  }
  return names + "\\\\*\n" + rules + "\\nopagebreak\n" + words + " \\\\*\n\\midrule\\nopagebreak\n";
}

// Returns the power of ten by which the numbers of a row are divided, so that they become short. The unit of the row
// states this power.
int power_of(LawResult const& law, Quantity const& quantity) {
  double largest = 0.0;
  for (auto const& fit : law.devices) {
    auto const mean = statistic_of(fit, quantity).mean;
    if (mean && std::isfinite(*mean)) largest = std::max(largest, std::abs(*mean));
  }
  if (largest == 0.0) return 0;
  int const decade = static_cast<int>(std::floor(std::log10(largest)));
  return decade >= 4 || decade <= -3 ? decade : 0;
}

std::optional<double> scaled(std::optional<double> const& value, int power) {
  return value ? std::optional(*value / std::pow(10.0, power)) : std::nullopt;
}

std::string block_row(LawResult const& law, Quantity const& quantity, std::vector<std::string> const& devices,
                      std::size_t columns) {
  int const power = power_of(law, quantity);
  auto unit = latex_unit(quantity.unit);
  if (power != 0) unit = fmt::format("$10^{{{}}}${}{}", power, unit.empty() ? "" : " ", unit);
  std::string row = quantity.n ? "" : latex_text(display_name(law));
  row += " & " + (quantity.n ? latex_symbol(quantity.name) : std::string("$\\mathit{OF}$"));
  if (!unit.empty()) row += " (" + unit + ")";
  if (!quantity.paper_name.empty()) row += ", paper: " + latex_symbol(quantity.paper_name);
  if (!quantity.free) row += ", fixed";
  for (std::size_t i = 0; i < columns; ++i) {
    if (i >= devices.size()) {
      row += " & & &";
      continue;
    }
    auto const statistic = statistic_of(law, devices[i], quantity);
    row += " & " + latex_number(scaled(statistic.mean, power)) + " & " +
           latex_number(scaled(statistic.std, power), digits_of_std) + " & " +
           latex_number(scaled(statistic.best, power));
  }
  return row;
}

std::size_t visible(std::string_view number) {
  constexpr std::string_view times = "\\times";
  auto const hidden =
      number.find(times) == std::string_view::npos ? 0 : times.size() - 2;  // the sign × is as wide as two letters
  return number.size() - hidden - static_cast<std::size_t>(std::ranges::count_if(number, [](char c) {
           return c == '$' || c == '{' || c == '}' || c == '^';
         }));
}

struct Letters {
  std::size_t law = 3, quantity = 8, head = 0, value = 5, std = 5;
};

Letters longest_texts(Summary const& summary, std::vector<std::string> const& devices) {
  Letters longest;
  auto const raise = [](std::size_t& to, std::size_t letters) { to = std::max(to, letters); };
  for (auto const& device : devices) raise(longest.head, std::min(printable(device).size(), longest_head));
  for (auto const& law : summary.laws) {
    raise(longest.law, display_name(law).size());
    for (auto const& quantity : quantities_of(law)) {
      int const power = power_of(law, quantity);
      auto const there = quantity.paper_name.empty() ? std::size_t{0} : quantity.paper_name.size() + 8;
      raise(longest.quantity, quantity.name.size() + quantity.unit.size() + there + 8);  // 8: power of ten and brackets
      for (auto const& fit : law.devices) {
        auto const statistic = statistic_of(fit, quantity);
        raise(longest.value, visible(latex_number(scaled(statistic.mean, power))));
        raise(longest.value, visible(latex_number(scaled(statistic.best, power))));
        raise(longest.std, visible(latex_number(scaled(statistic.std, power), digits_of_std)));
      }
    }
  }
  return longest;
}

std::size_t devices_side_by_side(Summary const& summary, std::vector<std::string> const& devices) {
  constexpr double page_mm = 174.0, letter_mm = 1.55, head_letter_mm = 1.75, gap_mm = 2.1;
  auto const letters = longest_texts(summary, devices);
  double const numbers_mm = letter_mm * static_cast<double>(2 * letters.value + letters.std) + 3.0 * gap_mm;
  double const block_mm = std::max(numbers_mm, head_letter_mm * static_cast<double>(letters.head));
  double const left_mm = letter_mm * static_cast<double>(letters.law + letters.quantity) + 2.0 * gap_mm;
  auto const fits = static_cast<std::size_t>(std::max(1.0, (page_mm - left_mm) / block_mm));
  return std::min({fits, devices.size(), std::size_t{3}});
}

std::string law_block(LawResult const& law, std::vector<std::string> const& devices, std::size_t columns) {
  auto text = block_head(devices, columns);
  auto const quantities = quantities_of(law);
  for (std::size_t i = 0; i < quantities.size(); ++i)
    text += block_row(law, quantities[i], devices, columns) + (i + 1 < quantities.size() ? " \\\\*\n" : " \\\\\n");
  return text + "\\addlinespace[6pt]\n";
}

std::string_view head_of_x(FrontView view) {
  return view == FrontView::left_out ? "$\\mathit{OF}$ on devices left out" : "$\\beta$";
}

}  // namespace

std::string latex_text(std::string_view text) {
  std::string latex;
  auto const clean = printable(text);
  for (std::string_view rest = clean; !rest.empty();) {
    auto const length = std::max<std::size_t>(1, utf8_length(rest));
    if (length > 1) {
      latex += latex_of_letter(rest.substr(0, length));
    } else {
      auto const special = std::ranges::find(signs, rest.front(), &std::pair<char, std::string_view>::first);
      // LaTeX would join two dashes or two quotes in a row into another sign, so `{}` keeps them apart.
      bool const joins = (rest.front() == '-' || rest.front() == '\'') && latex.ends_with(rest.front());
      if (joins) latex += "{}";
      if (after_backslash.find(rest.front()) != std::string_view::npos) latex += '\\';
      special == std::end(signs) ? latex += rest.front() : latex += special->second;
    }
    rest.remove_prefix(length);
  }
  return latex;
}

std::string latex_number(std::optional<double> const& number, int digits_shown) {
  if (!number || !std::isfinite(*number)) return "--";
  if (*number == 0.0) return "$0$";
  auto text = fmt::format("{:#.{}g}", *number, digits_shown);
  auto const e = text.find('e');
  auto digits = text.substr(0, e);
  // fmt writes "1234." or "1234.0". If there are enough digits before the point, the point and the rest are dropped.
  auto const point = digits.find('.');
  auto const before = static_cast<int>(std::ranges::count_if(digits.substr(0, point), [](char c) { return c != '-'; }));
  if (before >= digits_shown) digits.resize(std::min(point, digits.size()));
  if (e == std::string::npos) return "$" + digits + "$";
  return fmt::format("${}\\times10^{{{}}}$", digits, std::stoi(text.substr(e + 1)));
}

std::string latex_unit(std::string_view unit) {
  if (unit == "-" || unit == "1") return {};
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] != '^') {
      text += latex_text(unit.substr(i, 1));
      continue;
    }
    auto const end = std::min(unit.find_first_not_of("-0123456789", i + 1), unit.size());
    text += fmt::format("$^{{{}}}$", unit.substr(i + 1, end - i - 1));
    i = end - 1;
  }
  return text;
}

std::string table_a5_tex(Summary const& summary) {
  auto const devices = device_names(summary);
  std::string text =
      "% Objective and parameters of every law on every device: mean and standard deviation over the runs, best run.\n";
  text += packages_of_long;
  if (devices.empty() || summary.laws.empty()) return text + "% There is nothing to tabulate.\n";
  auto const columns = devices_side_by_side(summary, devices);
  text += "\\begingroup\\footnotesize\\setlength{\\tabcolsep}{3pt}\n";
  text += fmt::format("\\begin{{longtable}}{{@{{}}ll*{{{}}}{{r}}@{{}}}}\n", 3 * columns);
  text +=
      "\\caption{Objective $\\mathit{OF}$ and parameters of every law on every device: mean $\\mu$ and standard deviation $\\sigma$ over the runs, and best run.}\\label{tab:isolaw-a5}\\\\\n";
  text += "\\toprule\n\\endfirsthead\n";
  text +=
      fmt::format("\\multicolumn{{{}}}{{@{{}}l}}{{\\tablename\\ \\thetable{{}} (continued)}}\\\\\n", 3 * columns + 2);
  text += "\\toprule\n\\endhead\n\\bottomrule\n\\endfoot\n";
  for (auto const& law : summary.laws)
    for (std::size_t first = 0; first < devices.size(); first += columns) {
      auto const last = std::min(devices.size(), first + columns);
      text += law_block(
          law,
          {devices.begin() + static_cast<std::ptrdiff_t>(first), devices.begin() + static_cast<std::ptrdiff_t>(last)},
          columns);
    }
  return text + "\\end{longtable}\n\\endgroup\n";
}

std::string robustness_tex(Summary const& summary) {
  std::string text =
      "% Accuracy (mean, standard deviation and best of the objective) and robustness (beta) of every law.\n";
  text += packages;
  text += "\\begin{tabular}{@{}lrrrrl@{}}\n\\toprule\n";
  text += "Law & \\multicolumn{3}{c}{$\\mathit{OF}$} & $\\beta$ & Non-dominated \\\\\n\\cmidrule(lr){2-4}\n";
  text += " & mean & std & best & & \\\\\n\\midrule\n";
  for (auto const& law : summary.laws)
    text += fmt::format("{} & {} & {} & {} & {} & {} \\\\\n", latex_text(display_name(law)),
                        latex_number(law.objective.mean), latex_number(law.objective.std),
                        latex_number(law.objective.best), latex_number(law.beta), yes(law.on_front));
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string front_tex(Summary const& summary) {
  std::string text = "% Accuracy against robustness, Fig. 14 of Cucuzza et al. 2025 in numbers, by rising objective.\n";
  text += packages;
  text += "\\begin{tabular}{@{}lrrll@{}}\n\\toprule\n";
  bool first = true;
  for (auto const view : front_views) {
    auto const points = by_accuracy(summary, view);
    if (points.empty()) continue;
    if (!first) text += "\\midrule\n";
    first = false;
    text += fmt::format("\\multicolumn{{5}}{{@{{}}l}}{{\\itshape {}}} \\\\\n", latex_text(name(view)));
    text +=
        fmt::format("Law & $\\mathit{{OF}}$ & {} & Non-dominated & Dominated by \\\\\n\\midrule\n", head_of_x(view));
    for (auto const& point : points) {
      auto others = dominating(points, point);
      for (auto& law : others) law = laws::display_name(law);
      text +=
          fmt::format("{} & {} & {} & {} & {} \\\\\n", latex_text(laws::display_name(point.law)), latex_number(point.y),
                      latex_number(point.x), yes(point.on_front), others.empty() ? "--" : latex_text(joined(others)));
    }
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace isolaw::render
