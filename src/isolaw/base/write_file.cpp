#include "isolaw/base/write_file.hpp"

#include <string>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_suffix = ".part";

[[noreturn]] void refuse(fs::path const& path, std::string const& reason) {
  throw Error(Complaint{
      path.string(), "cannot be written: " + reason, {}, "another output directory, or free space in this one"});
}

}  // namespace

void make_folder(fs::path const& dir) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(dir, error))) refuse(dir, "it is a symbolic link");
  fs::create_directories(dir, error);
  if (error) refuse(dir, error.message());
}

// Writes all bytes to the disk before the file gets its name, so after a power cut either the old or the new file
// exists.
void write_file(fs::path const& path, std::string_view text) {
  auto aside = path;  // in the same directory, since only there is a rename atomic
  aside += "." + std::to_string(process_id()) + std::string(part_suffix);
  auto error = write_to_disk(aside, text);
  if (!error) fs::rename(aside, path, error);
  if (!error) return;
  std::error_code ignored;
  if (auto const folder = path.parent_path(); !folder.empty() && !fs::exists(folder, ignored))
    throw Error(Complaint{path.string(), "cannot be written: there is no directory " + folder.string(),
                          "a file in a directory that is there", "mkdir -p " + folder.string()});
  fs::remove(aside, ignored);
  refuse(path, error.message());
}

void remove_unfinished_files(fs::path const& folder) {
  std::error_code ignored;
  for (auto const& entry : fs::directory_iterator(folder, ignored)) {
    // Unfinished files are called NAME.PID.part. A file is removed if the process PID has ended.
    auto const name = entry.path().filename().string();
    if (!name.ends_with(part_suffix)) continue;
    auto const stem = std::string_view(name).substr(0, name.size() - part_suffix.size());
    auto const digits = stem.substr(stem.find_last_of('.') + 1);
    auto const owner = number_in<int>(digits);
    if (owner && *owner > 0 && has_ended(*owner)) fs::remove(entry.path(), ignored);
  }
}

}  // namespace isolaw
