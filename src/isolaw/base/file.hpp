// Reads plain files of bounded size from users and third parties, and checks whether a name leads out of a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isolaw {

struct ReadLimits {
  std::uintmax_t largest_bytes;
  std::string_view allowed;            // in messages: what is accepted
  std::string_view when_too_large;     // in messages: the remedy for a file that is too large
  std::string_view when_missing = {};  // in messages: the remedy for a missing file
};

// Returns the file's contents; follows links. Throws Error if it is missing, not plain, unreadable or too large.
std::string read_file(std::filesystem::path const& file, ReadLimits const& limits);
// Returns what the file is, such as "a pipe", if it is anything but a plain file (links are followed); else nullopt.
std::optional<std::string> other_than_plain(std::filesystem::path const& file);
// Returns the path to which `file` leads, with links followed, if this path is outside `folder`; nullopt if it is
// inside. Parts of the path that do not exist yet are taken as folders, not links. A name that cannot be followed, such
// as a circle of links, counts as outside.
std::optional<std::filesystem::path> leads_outside(std::filesystem::path const& file,
                                                   std::filesystem::path const& folder);

}  // namespace isolaw
