#include "isolaw/render/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"

namespace isolaw::render {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_not_started = 127;

[[noreturn]] void become_gnuplot(std::vector<char*> const& arguments, char const* directory, int messages) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // the kernel ends gnuplot if isolaw ends
#endif
  int const nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int const standard : {STDIN_FILENO, STDOUT_FILENO}) ::dup2(nowhere, standard);
  ::dup2(messages, STDERR_FILENO);
  if (nowhere >= 0 && ::chdir(directory) == 0) ::execvp(arguments.front(), arguments.data());
  ::_exit(exit_not_started);
}

std::optional<std::string> read_messages(int input, Clock::time_point deadline) {
  constexpr std::size_t longest = 1 << 16;
  std::string messages;
  std::array<char, 4096> buffer;
  while (true) {
    auto const left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return std::nullopt;
    pollfd waiting{.fd = input, .events = POLLIN, .revents = 0};
    int const ready = ::poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1000)));
    if (ready < 0 && errno != EINTR) return messages;
    if (ready <= 0) continue;
    auto const count = ::read(input, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return messages;
    if (messages.size() < longest) messages.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// Finds gnuplot's reason, `"front.gp" line 7: reason`. It is the last of the lines that gnuplot prints about an error.
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

std::string ending(int status, std::string const& messages) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return {};
  auto const error = error_in(messages);
  return error.empty() ? fmt::format("ended with exit code {}", WEXITSTATUS(status)) : error;
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
  std::vector<std::string> words{gnuplot_program(), "-d"};  // -d: without the user's settings
  words.insert(words.end(), scripts.begin(), scripts.end());
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {false, std::strerror(errno)};
  auto const child = ::fork();
  if (child == 0) become_gnuplot(arguments, directory.c_str(), ends[1]);
  int const failure = errno;
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return {false, std::strerror(failure)};
  }
  auto const messages = read_messages(ends[0], Clock::now() + limit);
  ::close(ends[0]);
  if (!messages) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!messages) return {true, fmt::format("takes longer than {} s", limit.count())};
  if (WIFEXITED(status) && WEXITSTATUS(status) == exit_not_started)
    return {false, words.front() + " cannot be started"};
  return {true, ending(status, *messages)};
}

}  // namespace isolaw::render
