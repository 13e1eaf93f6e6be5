// The directory of a campaign: made, held by one program at a time, and its store opened to be continued or begun.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw {

inline constexpr char const* store_name = "campaign.sqlite";

// Throws Error.
void make_directory(std::filesystem::path const& directory);

// One campaign at a time in a directory. The lock goes with the process, however it ends.
class DirectoryLock {
 public:
  // Throws Error where another one works there.
  explicit DirectoryLock(std::filesystem::path const& directory);
  DirectoryLock(DirectoryLock const&) = delete;
  DirectoryLock& operator=(DirectoryLock const&) = delete;
  ~DirectoryLock();

 private:
  int descriptor_;
};

// What a directory's campaign has more, or no longer, than when it was left.
struct Continued {
  std::vector<std::string> added;  // "2 devices", ...
  std::string released;            // the rule set that the tests were held to, where they are held to none now
};

// Takes over what an interrupted or finished campaign of the same settings and inputs computed, or of fewer devices,
// laws or runs; starts anew where there is none or `fresh` says so. Throws Error where another campaign is there.
Continued open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh);

}  // namespace isolaw
