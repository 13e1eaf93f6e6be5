#include "isolaw/base/system.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <iconv.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace isolaw {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int exit_not_started = 127;

std::string_view kind(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

FileStatus file_status(struct stat const& status) {
#ifdef __APPLE__
  auto const& changed = status.st_mtimespec;
#else
  auto const& changed = status.st_mtim;
#endif
  return {.kind = kind(status.st_mode),
          .bytes = static_cast<std::uintmax_t>(std::max<off_t>(0, status.st_size)),
          .changed_ns = std::int64_t{1'000'000'000} * changed.tv_sec + changed.tv_nsec};
}

[[noreturn]] void become(std::vector<char*> const& arguments, char const* directory, int messages) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // the kernel ends the started program when isolaw ends
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

}  // namespace

void prepare_process(int&, char**&) {
  ::signal(SIGXFSZ, SIG_IGN);
}

bool is_terminal(StandardStream stream) {
  return ::isatty(static_cast<int>(stream)) != 0;
}

int terminal_width(StandardStream stream) {
  winsize size{};
  return ::ioctl(static_cast<int>(stream), TIOCGWINSZ, &size) == 0 && size.ws_col >= 40 ? size.ws_col : 80;
}

std::string host_name() {
  utsname system{};
  ::uname(&system);
  return system.nodename;
}

std::string system_name() {
  utsname system{};
  ::uname(&system);
  return fmt::format("{} {} {}", system.sysname, system.release, system.machine);
}

std::uint64_t peak_memory_bytes() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
#ifdef __APPLE__
  constexpr std::uint64_t unit = 1;
#else
  constexpr std::uint64_t unit = 1024;
#endif
  return unit * static_cast<std::uint64_t>(used.ru_maxrss);
}

int process_id() {
  return ::getpid();
}

bool has_ended(int process) {
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

std::optional<FileStatus> status_of(fs::path const& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? std::optional(file_status(status)) : std::nullopt;
}

InputFile::InputFile(fs::path const& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}

InputFile::~InputFile() {
  if (is_open()) ::close(descriptor_);
}

std::optional<FileStatus> InputFile::status() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 ? std::optional(file_status(status)) : std::nullopt;
}

std::ptrdiff_t InputFile::read(std::span<char> buffer) const {
  while (true) {
    auto const count = ::read(descriptor_, buffer.data(), buffer.size());
    if (count >= 0 || errno != EINTR) return count;
  }
}

std::error_code write_to_disk(fs::path const& file, std::string_view text) {
  int const descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  bool written = descriptor >= 0;
  for (std::string_view rest = text; written && !rest.empty();) {
    auto const count = ::write(descriptor, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    written = count >= 0;
    if (written) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  written = written && (::fsync(descriptor) == 0 || errno == EINVAL);  // EINVAL: a pipe cannot be synchronised
  std::error_code error = written ? std::error_code() : std::error_code(errno, std::generic_category());
  if (descriptor >= 0 && ::close(descriptor) != 0 && !error) error = std::error_code(errno, std::generic_category());
  return error;
}

fs::path make_private_directory(fs::path const& name) {
  auto pattern = name.string() + "-XXXXXX";
  return ::mkdtemp(pattern.data()) == nullptr ? fs::path() : fs::path(pattern);
}

FolderLock::FolderLock(fs::path const& folder)
    : handle_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
      taken_(handle_ >= 0 && ::flock(static_cast<int>(handle_), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {}

FolderLock::~FolderLock() {
  if (handle_ >= 0) ::close(static_cast<int>(handle_));
}

std::optional<std::string> converted_to_utf8(std::string_view bytes, std::string const& encoding) {
  iconv_t converter = iconv_open("UTF-8", encoding.c_str());
  // musl's iconv, which the page uses in a browser, knows CP932 only as SHIFT_JIS.
  if (converter == reinterpret_cast<iconv_t>(-1) && encoding == "CP932") converter = iconv_open("UTF-8", "SHIFT_JIS");
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer;
  auto* in = const_cast<char*>(bytes.data());
  std::size_t in_left = bytes.size();
  bool failed = false;
  while (in_left > 0 && !failed) {
    auto* out = buffer.data();
    std::size_t out_left = buffer.size();
    failed = iconv(converter, &in, &in_left, &out, &out_left) == static_cast<std::size_t>(-1) && errno != E2BIG;
    text.append(buffer.data(), buffer.size() - out_left);
  }
  iconv_close(converter);
  return failed ? std::nullopt : std::optional(std::move(text));
}

bool make_pipe(std::array<int, 2>& ends) {
#ifdef __APPLE__
  if (::pipe(ends.data()) != 0) return false;
  for (int const end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  return true;
#else
  return ::pipe2(ends.data(), O_CLOEXEC) == 0;
#endif
}

ProgramEnd run_program(std::vector<std::string> words, fs::path const& directory, std::chrono::seconds limit) {
  using enum ProgramEnd::How;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (!make_pipe(ends)) return {not_started, errno};
  auto const child = ::fork();
  if (child == 0) become(arguments, directory.c_str(), ends[1]);
  int const failure = errno;
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return {not_started, failure};
  }
  auto messages = read_messages(ends[0], Clock::now() + limit);
  ::close(ends[0]);
  if (!messages) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!messages) return {took_too_long};
  if (WIFSIGNALED(status)) return {ended_by_signal, WTERMSIG(status), std::move(*messages)};
  if (WEXITSTATUS(status) == exit_not_started) return {not_started};
  return {exited, WEXITSTATUS(status), std::move(*messages)};
}

}  // namespace isolaw
