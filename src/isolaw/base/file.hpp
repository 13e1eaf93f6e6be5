// Files that others name or wrote: read whole and only when they are plain files of bounded size; whether a name leads
// out of a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isolaw {

struct ReadLimits {
  std::uintmax_t largest_bytes;
  std::string_view allowed;         // what the messages say would have been accepted
  std::string_view when_too_large;  // what to try then
  std::string_view when_missing = {};
};

// The bytes of the file; links are followed. Throws Error: no such file, a directory, pipe, socket or device (which is
// never waited for), too large (before anything is read), unreadable.
std::string read_file(std::filesystem::path const& file, ReadLimits const& limits);

// "a pipe" or the like when the name is taken by something that is no plain file, links followed; nullopt otherwise.
std::optional<std::string> other_than_plain(std::filesystem::path const& file);

// Where `file` really leads when that is neither `folder` nor below it, links followed; nullopt when it stays. What
// does not exist yet counts by its name. A name that cannot be followed (a circle of links) leads outside.
std::optional<std::filesystem::path> leads_outside(std::filesystem::path const& file,
                                                   std::filesystem::path const& folder);

}  // namespace isolaw
