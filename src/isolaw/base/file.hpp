// Reads plain files of bounded size that a user names or someone else wrote; checks whether a name leaves a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isolaw {

struct ReadLimits {
  std::uintmax_t largest_bytes;
  std::string_view allowed;            // for the messages: what is accepted
  std::string_view when_too_large;     // for the messages: what to try with a file that is too large
  std::string_view when_missing = {};  // the same for a file that is missing
};

// Follows links. Throws Error for a file that is missing, too large (checked first), unreadable or not plain.
std::string read_file(std::filesystem::path const& file, ReadLimits const& limits);
// "a pipe" or the like if the name, with links followed, belongs to anything but a plain file; otherwise nullopt.
std::optional<std::string> other_than_plain(std::filesystem::path const& file);
// The real place of `file`, with links followed, if it is outside `folder`; otherwise nullopt. A part of the path that
// does not exist yet is judged by its name. A name that cannot be followed, such as a circle of links, is outside.
std::optional<std::filesystem::path> leads_outside(std::filesystem::path const& file,
                                                   std::filesystem::path const& folder);

}  // namespace isolaw
