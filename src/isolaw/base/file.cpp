#include "isolaw/base/file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/system.hpp"

namespace isolaw {
namespace {

namespace fs = std::filesystem;

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
  auto const check = [&](FileStatus const& status) {
    if (!status.kind.empty()) refuse(fmt::format("is {}", status.kind));
    if (status.bytes > limits.largest_bytes)
      refuse("is " + size_text(status.bytes, limits.largest_bytes), limits.when_too_large);
  };

  // The file is checked before it is opened, since opening a device file could start the device. Meanwhile another file
  // may take the name, so the open file is checked again.
  auto status = status_of(file);
  if (!status) {
    bool const missing = errno == ENOENT || errno == ENOTDIR;
    refuse(missing ? "no such file" : "cannot be read: " + reason(), missing ? limits.when_missing : "");
  }
  check(*status);
  InputFile const input(file);
  if (!input.is_open() || !(status = input.status())) refuse("cannot be read: " + reason());
  check(*status);

  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(status->bytes) + 1);
  std::array<char, 1 << 16> buffer;
  while (true) {
    auto const count = input.read(buffer);
    if (count < 0) refuse("cannot be read to its end: " + reason());
    if (count == 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > limits.largest_bytes)  // the file grew, or the system reports no size for it
      refuse("is " + size_text(bytes.size(), limits.largest_bytes), limits.when_too_large);
  }
  // Refuses a file that was written to meanwhile, since perhaps only a part of the new text was read. Files of the
  // system, such as those in /proc, have size 0 and are not checked.
  if (status->bytes > 0 && input.status() != status)
    refuse("changed while it was read", "the command again when the file is complete");
  return bytes;
}

std::optional<std::string> other_than_plain(fs::path const& file) {
  auto const status = status_of(file);
  return status && !status->kind.empty() ? std::optional(std::string(status->kind)) : std::nullopt;
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
