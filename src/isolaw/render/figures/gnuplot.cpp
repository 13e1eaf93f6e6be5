#include "isolaw/render/figures/gnuplot.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"

namespace isolaw::render {
namespace {

// Finds in the output of gnuplot why it failed: the last line of the form `"front.gp" line 7: reason`.
std::string error_in(std::string const& messages) {
  auto const at = messages.rfind(" line ");
  if (at == std::string::npos) return {};
  auto const start = messages.rfind('\n', at);
  auto const line = messages.substr(start == std::string::npos ? 0 : start + 1);
  return printable(line.substr(0, line.find('\n')));
}

std::string gnuplot_program() {
  char const* const named = std::getenv("ISOLAW_GNUPLOT");
  return named != nullptr && *named != '\0' ? named : "gnuplot";
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (char const c : printable(text)) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string gnuplot_text(std::string_view text) {
  std::string label;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::string_view("_@&~{}\\").find(text[i]) != std::string_view::npos) label += '\\';
    label += text[i];
    if (text[i] != '^') continue;
    auto end = i + 1;
    while (end < text.size() && (text[end] == '-' || std::isalnum(static_cast<unsigned char>(text[end])) != 0)) ++end;
    label += fmt::format("{{{}}}", text.substr(i + 1, end - i - 1));
    i = end - 1;
  }
  return label;
}

std::string gnuplot_label(std::string_view text) {
  return gnuplot_string(gnuplot_text(text));
}

DataTable& DataTable::comment(std::string_view text) {
  text_ += "# " + printable(text) + "\n";
  return *this;
}

void DataTable::cell(std::string_view text) {
  text_ += '"';
  for (char const c : printable(text)) {
    if (c == '\\') text_ += '\\';  // `\n` in the text must not become a line break in the drawing
    text_ += c == '"' ? '\'' : c;
  }
  text_ += "\" ";
}

void DataTable::cell(std::optional<double> const& number) {
  auto const digits = to_text(number);
  text_ += (digits.empty() ? "NaN" : digits) + ' ';
}

std::string DataTable::take() {
  while (text_.ends_with("\n\n")) text_.pop_back();
  return std::exchange(text_, {});
}

GnuplotEnd run_gnuplot(std::vector<std::string> const& scripts, std::filesystem::path const& directory,
                       std::chrono::seconds limit) {
  std::vector<std::string> words{gnuplot_program(), "-d"};  // -d: gnuplot ignores the user's settings file
  words.insert(words.end(), scripts.begin(), scripts.end());
  auto const end = run_program(words, directory, limit);
  switch (end.how) {
    case ProgramEnd::How::not_started:
      return {false, end.code != 0 ? std::generic_category().message(end.code) : words.front() + " cannot be started"};
    case ProgramEnd::How::took_too_long:
      return {true, fmt::format("takes longer than {} s", limit.count())};
    case ProgramEnd::How::ended_by_signal:
      return {true, fmt::format("ended by signal {}", end.code)};
    case ProgramEnd::How::exited:
      break;
  }
  if (end.code == 0) return {true, {}};
  auto const error = error_in(end.messages);
  return {true, error.empty() ? fmt::format("ended with exit code {}", end.code) : error};
}

}  // namespace isolaw::render
