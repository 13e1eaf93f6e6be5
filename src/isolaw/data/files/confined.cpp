#include "isolaw/data/files/confined.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <system_error>

#include "isolaw/base/system.hpp"

namespace isolaw::data {
namespace {

constexpr int exit_well = 0, exit_by_exception = 3;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void limit(decltype(RLIMIT_CPU) what, rlim_t to) {
  rlimit const both{.rlim_cur = to, .rlim_max = to};
  ::setrlimit(what, &both);
}

std::uint64_t address_space_held() {
  unsigned long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return std::uint64_t{pages} * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    auto const count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) ::_exit(exit_by_exception);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

// Runs `work` in the forked process, which then prints nothing, opens no file and writes only to the pipe `output`.
[[noreturn]] void be_confined(std::function<void(std::function<void(std::string_view)> const&)> const& work,
                              ConfinedLimits const& limits, int output) {
  int const nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int const standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (nowhere >= 0) ::dup2(nowhere, standard);
  for (int const deadly : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT}) ::signal(deadly, SIG_DFL);
  // Sanitizers reserve address space and open files, so a limit on either would break them.
  if (!sanitized) {
    limit(RLIMIT_AS, address_space_held() + limits.memory_bytes);
    limit(RLIMIT_NOFILE, 0);
  }
  limit(RLIMIT_CPU, limits.seconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  try {
    work([&](std::string_view bytes) { write_all(output, bytes); });
    ::_exit(exit_well);
  } catch (std::exception const& error) {
    write_all(output, error.what());
  } catch (...) {
  }
  ::_exit(exit_by_exception);
}

// Reads the pipe until the forked process closes it. Returns why isolaw stopped the process, or an empty text.
std::string collect(int input, ConfinedLimits const& limits, std::string& output) {
  // limits.seconds limits the processor time. A process on a busy machine also waits for the processor, so the limit by
  // the clock is five times as long.
  auto const patience = 5 * limits.seconds;
  auto const deadline = std::chrono::steady_clock::now() + std::chrono::seconds(patience);
  std::array<char, 1 << 16> buffer;
  while (true) {
    auto const left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return fmt::format("takes longer than {} s", patience);
    pollfd waiting{.fd = input, .events = POLLIN, .revents = 0};
    auto const ready = ::poll(&waiting, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno != EINTR) return "cannot be waited for";
    if (ready <= 0) continue;
    auto const count = ::read(input, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return "cannot be read";
    if (count == 0) return {};
    output.append(buffer.data(), static_cast<std::size_t>(count));
    if (output.size() > limits.output_bytes) return "holds more than it may";
  }
}

std::string ending(int status, ConfinedLimits const& limits, std::string const& output) {
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
               ? fmt::format("takes longer than {} s", limits.seconds)
               : fmt::format("brings down the library that reads it (signal {})", WTERMSIG(status));
  if (WEXITSTATUS(status) == exit_well) return {};
  if (WEXITSTATUS(status) != exit_by_exception) return "brings down the library that reads it";
  return output.empty() ? "cannot be read" : output;
}

}  // namespace

ConfinedResult run_confined(std::function<void(std::function<void(std::string_view)> const&)> const& work,
                            ConfinedLimits const& limits) {
  std::array<int, 2> ends{};
  if (!make_pipe(ends)) throw std::system_error(errno, std::generic_category(), "pipe");
  auto const child = ::fork();
  if (child < 0) {
    auto const reason = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  if (child == 0) be_confined(work, limits, ends[1]);
  ::close(ends[1]);
  ConfinedResult result;
  result.failure = collect(ends[0], limits, result.output);
  ::close(ends[0]);
  if (!result.failure.empty()) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (result.failure.empty()) result.failure = ending(status, limits, result.output);
  if (!result.failure.empty()) result.output.clear();
  return result;
}

}  // namespace isolaw::data
