#include "isolaw/base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "isolaw/base/error.hpp"

namespace isolaw {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor const&) = delete;
  Descriptor& operator=(Descriptor const&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const { return number_; }

 private:
  int number_;
};

std::string_view kind(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string size_text(std::uintmax_t bytes, std::uintmax_t limit) {
  constexpr std::uintmax_t gib = std::uintmax_t{1} << 30;
  constexpr std::uintmax_t mib = std::uintmax_t{1} << 20;
  bool const large = limit >= gib;
  auto const unit = static_cast<double>(large ? gib : mib);
  return fmt::format("{:.2f} {} large, above {:g} {}", static_cast<double>(bytes) / unit, large ? "GiB" : "MiB",
                     static_cast<double>(limit) / unit, large ? "GiB" : "MiB");
}

}  // namespace

std::string read_file(fs::path const& file, ReadLimits const& limits) {
  auto const refuse = [&](std::string found, std::string_view advice = {}) {
    throw Error(Complaint{.where = file.generic_string(),
                          .found = std::move(found),
                          .allowed = std::string(limits.allowed),
                          .advice = std::string(advice)});
  };
  auto const reason = [] { return std::generic_category().message(errno); };
  auto const check = [&](struct stat const& status) {
    if (!S_ISREG(status.st_mode)) refuse(fmt::format("is {}", kind(status.st_mode)));
    auto const size = static_cast<std::uintmax_t>(std::max<off_t>(0, status.st_size));
    if (size > limits.largest_bytes) refuse("is " + size_text(size, limits.largest_bytes), limits.when_too_large);
  };

  // stat() comes before open(), since opening a device file could start the device. Between the two calls another
  // file may take the name, so fstat() checks the file that was opened.
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    bool const missing = errno == ENOENT || errno == ENOTDIR;
    refuse(missing ? "no such file" : "cannot be read: " + reason(), missing ? limits.when_missing : "");
  }
  check(status);
  Descriptor const handle(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (handle.get() < 0 || ::fstat(handle.get(), &status) != 0) refuse("cannot be read: " + reason());
  check(status);

  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  std::array<char, 1 << 16> buffer;
  while (true) {
    auto const count = ::read(handle.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse("cannot be read to its end: " + reason());
    if (count == 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > limits.largest_bytes)  // the file grew, or the system reports no size for it
      refuse("is " + size_text(bytes.size(), limits.largest_bytes), limits.when_too_large);
  }
  // Refuses a file that was written to meanwhile, since perhaps only a part of the new text was read. Files of the
  // system, such as those in /proc, have size 0 and are not checked.
  struct stat after {};
  bool const is_same = ::fstat(handle.get(), &after) == 0 && after.st_size == status.st_size &&
                       after.st_mtim.tv_sec == status.st_mtim.tv_sec && after.st_mtim.tv_nsec == status.st_mtim.tv_nsec;
  if (status.st_size > 0 && !is_same)
    refuse("changed while it was read", "the command again when the file is complete");
  return bytes;
}

std::optional<std::string> other_than_plain(fs::path const& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return std::nullopt;
  return std::string(kind(status.st_mode));
}

std::optional<fs::path> leads_outside(fs::path const& file, fs::path const& folder) {
  std::error_code failure;
  auto const root = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder, failure), failure);
  if (failure) return file;
  auto const target = fs::weakly_canonical(fs::absolute(file, failure), failure).lexically_normal();
  if (failure) return file;
  // weakly_canonical() leaves a link in the path if the target of the link does not exist. Such a link counts as
  // outside, since its target may be created anywhere.
  fs::path part;
  for (auto const& name : target) {
    part /= name;
    if (fs::is_symlink(fs::symlink_status(part, failure))) return fs::read_symlink(part, failure);
  }
  auto const inside = target.lexically_relative(root);
  if (inside.empty() || *inside.begin() == "..") return target;
  return std::nullopt;
}

}  // namespace isolaw
