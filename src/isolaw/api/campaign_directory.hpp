// Makes and locks the directory of a campaign, and opens or creates the campaign's store in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/base/system.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw {

inline constexpr char const* store_name = "campaign.sqlite";

void make_directory(std::filesystem::path const& directory);  // also makes its parents; throws Error

class TemporaryDirectory {  // the destructor removes the directory; the constructor throws Error if it cannot make it
 public:
  TemporaryDirectory();
  TemporaryDirectory(TemporaryDirectory const&) = delete;
  TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;
  ~TemporaryDirectory();
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

class DirectoryLock {  // keeps other processes out of a directory until the object or the process ends
 public:
  explicit DirectoryLock(std::filesystem::path const& directory);  // throws Error if another process holds it

 private:
  FolderLock lock_;
};

struct Continuation {                   // how a campaign differs from the stored one that it continues
  std::vector<std::string> added = {};  // for example "2 devices"
  std::string dropped_rules = {};       // rule set of the stored campaign if the new one has no rules; else empty
  // Compression tests of the stored campaign that the new input lacks: "D01 (v.csv)" for the test of device D01.
  std::vector<std::string> kept_vertical = {}, dropped_vertical = {};
  std::string lost = {};  // a sentence if starting over replaced a damaged or empty file; else empty
};

// Decides what happens to a compression test that is in the store but not in the input. It stays if the user names
// records on the command line; it goes if a lot file leaves it out.
enum class UnlistedVertical { keep, drop };

// Copies the results in the store into `contents`. Throws Error if the stored settings or inputs differ. `contents` may
// have more devices, laws and runs than the store, but not if it is one part of a divided campaign. Makes a new store
// if there is none or if `fresh` is true.
Continuation open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh,
                            UnlistedVertical vertical = UnlistedVertical::keep);

}  // namespace isolaw
