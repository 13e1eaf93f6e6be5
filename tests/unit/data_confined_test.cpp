// Tests functions that run in a process of their own. The results of the function must come back, and every way in
// which the process can end must give an outcome.
#include "isolaw/data/files/confined.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace isolaw::data {
namespace {

ConfinedLimits const limits{.memory_bytes = std::size_t{64} << 20, .seconds = 1, .output_bytes = 1 << 20};

TEST(Confined, ResultsComeBack) {
  std::string const large(500'000, 'x');
  auto const result = run_confined([&](auto const& write) { write("a"), write(large); }, limits);
  EXPECT_EQ(result.failure, "");
  EXPECT_EQ(result.output, "a" + large);
}

TEST(Confined, AnExceptionIsTheFailure) {
  auto const result = run_confined([](auto const&) { throw std::runtime_error("is damaged"); }, limits);
  EXPECT_EQ(result.failure, "is damaged");
  EXPECT_EQ(result.output, "");
}

TEST(Confined, DeathIsTheFailure) {
  auto const result = run_confined([](auto const&) { std::raise(SIGKILL); }, limits);
  EXPECT_NE(result.failure, "");
  auto const aborted = run_confined([](auto const&) { std::abort(); }, limits);
  EXPECT_NE(aborted.failure.find("brings down the library that reads it"), std::string::npos) << aborted.failure;
}

TEST(Confined, NoEndIsTheFailure) {
  auto const busy = run_confined(
      [](auto const&) {
        for (bool volatile on = true; on;) {
        }
      },
      limits);
  // The limit is 1 s of processor time, or 5 s by the clock on a machine that is busy with other things.
  EXPECT_TRUE(busy.failure == "takes longer than 1 s" || busy.failure == "takes longer than 5 s") << busy.failure;
  auto const asleep = run_confined([](auto const&) { ::sleep(60); }, limits);
  EXPECT_EQ(asleep.failure, "takes longer than 5 s");
}

TEST(Confined, TooMuchOutputIsTheFailure) {
  auto const result = run_confined(
      [](auto const& write) {
        std::string const piece(100'000, 'x');
        while (true) write(piece);
      },
      limits);
  EXPECT_EQ(result.failure, "holds more than it may");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Confined, NoFileIsOpened) {
  auto const result =
      run_confined([](auto const& write) { write(::open("/etc/hostname", O_RDONLY) < 0 ? "closed" : "open"); }, limits);
  EXPECT_EQ(result.output, "closed");
}

TEST(Confined, MemoryIsBounded) {
  auto const result = run_confined(
      [](auto const& write) {
        std::vector<char> const large(std::size_t{256} << 20, 'x');
        write({large.data(), 1});
      },
      limits);
  EXPECT_EQ(result.failure, "std::bad_alloc");
}
#endif

}  // namespace
}  // namespace isolaw::data
