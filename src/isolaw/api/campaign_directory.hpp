// The directory of a campaign: making it, locking it against other programs, and opening or beginning its store.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw {

inline constexpr char const* store_name = "campaign.sqlite";

void make_directory(std::filesystem::path const& directory);  // with its parents; throws Error

class TemporaryDirectory {  // removed by the destructor; the constructor throws Error
 public:
  TemporaryDirectory();
  TemporaryDirectory(TemporaryDirectory const&) = delete;
  TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;
  ~TemporaryDirectory();
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

class DirectoryLock {  // lets one process at a time work in a directory; released when the process ends, even by a kill
 public:
  explicit DirectoryLock(std::filesystem::path const& directory);  // throws Error if another process holds it
  DirectoryLock(DirectoryLock const&) = delete;
  DirectoryLock& operator=(DirectoryLock const&) = delete;
  ~DirectoryLock();

 private:
  int descriptor_;
};

struct Continued {                 // how a continued campaign differs from the one that the directory held
  std::vector<std::string> added;  // "2 devices", ...
  std::string released;            // the rule set of the stored campaign, if the continued one has none
  // "D01 (v.csv)" for devices whose compression test was not given again: it was kept, or the lot file dropped it.
  std::vector<std::string> kept_vertical, dropped_vertical;
};

// A stored compression test that is not given again stays if only records are named, and goes if a lot file omits it.
enum class LeftOut { stays, is_gone };

// Copies the results of the store's campaign into `contents`. The campaign must have the same settings and inputs, and
// the same or fewer devices, laws and runs, or Error is thrown. Starts anew if there is no store or `fresh` is true.
Continued open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh,
                         LeftOut vertical = LeftOut::stays);

}  // namespace isolaw
