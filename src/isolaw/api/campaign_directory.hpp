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

// A directory of its own that goes with its owner. Throws Error.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  TemporaryDirectory(TemporaryDirectory const&) = delete;
  TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;
  ~TemporaryDirectory();
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

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
  // Devices whose compression test was not given again, each with what it was: kept, or gone with the lot file's line.
  std::vector<std::string> kept_vertical, dropped_vertical;
};

// What a device that is given without its compression test means: a lot file says all there is of a device; where
// records are named, a test that the campaign holds stays with it.
enum class LeftOut { stays, is_gone };

// Takes over what an interrupted or finished campaign of the same settings and inputs computed, or of fewer devices,
// laws or runs; starts anew where there is none or `fresh` says so. Throws Error where another campaign is there.
Continued open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh,
                         LeftOut vertical = LeftOut::stays);

}  // namespace isolaw
