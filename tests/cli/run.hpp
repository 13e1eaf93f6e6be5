// Starts the isolaw program in a fresh directory and keeps its output. All tests of tests/cli use this file.
#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace isolaw::cli_test {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
using namespace std::chrono_literals;

inline fs::path const data = ISOLAW_DATA_DIR;  // measured records; where they are missing, tests are skipped
inline Words const smallest_search{"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1"};

inline std::string read_file(fs::path const& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream bytes;
  if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
  return std::move(bytes).str();
}

inline void write_file(fs::path const& path, std::string_view bytes) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

struct Outcome {
  int code = -1;  // exit code, or 128 + the number of the signal that ended the program
  bool timed_out = false;
  std::string out, err;
  long peak_kB = 0;
};

inline std::ostream& operator<<(std::ostream& stream, Outcome const& o) {
  constexpr std::size_t shown = 3000;
  return stream << "exit code " << o.code << (o.timed_out ? " (time limit)" : "")
                << "\nstdout: " << o.out.substr(0, shown) << "\nstderr: " << o.err.substr(0, shown);
}

// A started program. The destructor kills it if it still runs.
class Process {
 public:
  Process(Words const& command, fs::path const& directory, fs::path output, fs::path errors,
          Words const& environment = {})
      : output_(std::move(output)), errors_(std::move(errors)) {
    std::vector<char*> arguments, variables;
    for (auto const& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    for (auto const& variable : environment) variables.push_back(const_cast<char*>(variable.c_str()));
    for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
    variables.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
    constexpr int truncate = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), truncate, 0644);
    posix_spawn_file_actions_addopen(&actions, 2, errors_.c_str(), truncate, 0644);
    int const failure = posix_spawnp(&pid_, arguments.front(), &actions, nullptr, arguments.data(), variables.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::runtime_error("cannot start " + command.front());
  }
  Process(Process const&) = delete;
  Process& operator=(Process const&) = delete;
  ~Process() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }

  void send(int signal) const { kill(pid_, signal); }

  // Returns true once the program has ended; `result` then has its exit code and output.
  bool ended(Outcome& result) {
    int status = 0;
    rusage used{};
    if (wait4(pid_, &status, WNOHANG, &used) != pid_) return false;
    pid_ = 0;
    result.peak_kB = used.ru_maxrss;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    auto const text = [](fs::path const& path) { return fs::is_regular_file(path) ? read_file(path) : std::string(); };
    result.out = text(output_);
    result.err = text(errors_);
    return true;
  }

  Outcome wait(std::chrono::seconds limit = 120s) {
    Outcome result;
    auto const end = std::chrono::steady_clock::now() + limit;
    while (!ended(result)) {
      if (std::chrono::steady_clock::now() > end) {
        result.timed_out = true;
        send(SIGKILL);
      }
      std::this_thread::sleep_for(2ms);
    }
    return result;
  }

 private:
  pid_t pid_ = 0;
  fs::path output_, errors_;
};

// Returns options that check the tests against the Italian code NTC with these design values.
inline Words held_to(std::string const& design) {
  return {"--rules", "ntc-2018", "--design", design};
}

// Adds options that switch off analyses and figures, unless the command itself asks for them. Analyses and figures
// would take far longer than the short searches of most tests.
inline Words without_extras(Words words) {
  if (words.size() < 2 || (words.front() != "calibrate" && words.front() != "report")) return words;
  static Words const flags{"--fresh",      "--json",        "--center",     "--allow-outside",
                           "--flip-force", "--half-cycles", "--same-device"};
  bool const lacks_a_value = words.back().starts_with('-') && std::ranges::find(flags, words.back()) == flags.end();
  if (lacks_a_value) return words;
  Words const options = words.front() == "calibrate" ? Words{"--analysis", "--figures"} : Words{"--figures"};
  for (auto const& option : options) {
    bool const asked = std::ranges::find(words, option) != words.end();
    if (!asked) words.insert(std::ranges::find(words, "--"), {option, "none"});
  }
  return words;
}

// Gives each test a new directory. Commands run there, and relative file names refer to it.
class InFreshDirectory : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "isolaw-cli-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    base_ = name;
    fs::create_directory(base_ / "work");
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(base_, ignored);
  }

  fs::path directory() const { return base_ / "work"; }
  fs::path path(fs::path const& name) const { return directory() / name; }
  void write(fs::path const& name, std::string_view bytes) const { write_file(path(name), bytes); }
  std::string read(fs::path const& name) const { return read_file(path(name)); }
  Json json(fs::path const& name) const { return Json::parse(read(name)); }
  bool exists(fs::path const& name) const { return fs::exists(path(name)); }

  // Starts isolaw with `words`. Its captured output goes to files outside the working directory.
  Process start(Words words, Words const& environment = {}) {
    words = without_extras(std::move(words));
    words.insert(words.begin(), ISOLAW_BINARY);
    auto const number = std::to_string(++commands_);
    return Process(words, directory(), base_ / ("out" + number), base_ / ("err" + number), environment);
  }
  Outcome isolaw(Words words) { return start(std::move(words)).wait(); }
  Outcome isolaw_in(fs::path const& where, Words words) {
    words = without_extras(std::move(words));
    words.insert(words.begin(), ISOLAW_BINARY);
    return Process(words, where, base_ / "out", base_ / "err").wait();
  }

 private:
  fs::path base_;
  int commands_ = 0;
};

inline Words operator+(Words a, Words const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::size_t count_of(std::string_view part, std::string_view text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

inline testing::AssertionResult contains(std::string_view text, std::string_view part) {
  if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no '" << part << "' in:\n" << text.substr(0, 4000);
}

// Expects this exit code and a message on standard error that contains all these parts and is no internal error.
inline void expect_message(Outcome const& o, int code, std::vector<std::string> const& parts) {
  EXPECT_EQ(o.code, code) << o;
  for (auto const& part : parts) EXPECT_TRUE(contains(o.err, part)) << "exit code " << o.code;
  EXPECT_EQ(o.err.find("internal error"), std::string::npos) << o;
}

// Joins lines that isolaw wrapped to the width of the terminal.
inline std::string unwrapped(std::string const& text) {
  return std::regex_replace(text, std::regex("\n +"), " ");
}

// Replaces the output folder in the text of calibrate or report, so that the texts of two folders can be compared.
inline std::string without_folder(std::string const& text, std::string const& folder) {
  return std::regex_replace(text, std::regex("\\b" + folder + "(?=/report.html| --law)"), "FOLDER");
}

// Expects a refusal: exit code 2, a message with all these parts on standard error, and nothing on standard output.
inline void expect_refused(Outcome const& o, std::vector<std::string> const& parts) {
  expect_message(o, 2, parts);
  EXPECT_TRUE(o.out.empty()) << o;
}

// Expects that a command with --json is refused. Standard output then has the complaints as one JSON object, which this
// function returns.
inline Json expect_refused_as_object(Outcome const& o, std::vector<std::string> const& parts) {
  expect_message(o, 2, parts);
  auto const object = Json::parse(o.out, nullptr, false);
  EXPECT_TRUE(object.is_object() && object["exit"] == 2 && !object["error"]["complaints"].empty()) << o;
  return object;
}

}  // namespace isolaw::cli_test
