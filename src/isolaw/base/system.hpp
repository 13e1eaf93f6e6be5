// Asks the operating system for what the C++ standard library lacks. system.cpp is for POSIX, system_windows.cpp for
// Windows. Functions that fail leave the reason in errno.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace isolaw {

// Must run before everything else. On Windows it makes the arguments UTF-8 and lets the streams carry bytes unchanged.
// On POSIX systems a write beyond the file size limit then returns an error instead of ending the program.
void prepare_process(int& argc, char**& argv);

enum class StandardStream { output = 1, error = 2 };
bool is_terminal(StandardStream stream);
int terminal_width(StandardStream stream);  // 80 if the stream is no terminal or has fewer than 40 columns

std::string host_name();
std::string system_name();  // for example "Linux 6.1.0-18-amd64 x86_64"
std::uint64_t peak_memory_bytes();
int process_id();
bool has_ended(int process);

struct FileStatus {
  std::string_view kind;  // such as "a directory"; empty for a plain file
  std::uintmax_t bytes;
  std::int64_t changed_ns;
  bool operator==(FileStatus const&) const = default;
};
std::optional<FileStatus> status_of(std::filesystem::path const& file);  // follows links

class InputFile {
 public:
  explicit InputFile(std::filesystem::path const& file);
  InputFile(InputFile const&) = delete;
  InputFile& operator=(InputFile const&) = delete;
  ~InputFile();
  bool is_open() const { return descriptor_ >= 0; }
  std::optional<FileStatus> status() const;
  std::ptrdiff_t read(std::span<char> buffer) const;  // the number of bytes; 0 at the end, -1 if it fails

 private:
  int descriptor_;
};

// Replaces the contents of a file and returns when all bytes are on the disk. On POSIX systems it fails if the name is
// a symbolic link.
std::error_code write_to_disk(std::filesystem::path const& file, std::string_view text);
// Makes a directory for this user alone. Its name begins like `name`. Returns an empty path if that fails.
std::filesystem::path make_private_directory(std::filesystem::path const& name);

class FolderLock {  // keeps other processes out of a folder until the object or the process ends
 public:
  explicit FolderLock(std::filesystem::path const& folder);
  FolderLock(FolderLock const&) = delete;
  FolderLock& operator=(FolderLock const&) = delete;
  ~FolderLock();
  bool is_taken() const { return taken_; }  // whether another process has the lock; false if it cannot be locked

 private:
  std::intptr_t handle_;
  bool taken_ = false;
};

struct ProgramEnd {
  enum class How { not_started, exited, ended_by_signal, took_too_long };
  How how;
  int code = 0;               // exit code or number of the signal; if not started: errno, or 0 if it cannot be run
  std::string messages = {};  // the first 64 KiB that the program wrote to standard error
};
// Runs a program without a shell in `directory` and ends it after `limit`. The program gets no input, and its standard
// output is ignored. On Linux and Windows it also ends when isolaw ends.
ProgramEnd run_program(std::vector<std::string> words, std::filesystem::path const& directory,
                       std::chrono::seconds limit);

// Converts a text of another encoding, such as "CP932" or "UTF-16LE". Returns nullopt if the bytes are no text in this
// encoding, or if the system does not know the encoding.
std::optional<std::string> converted_to_utf8(std::string_view bytes, std::string const& encoding);

#ifndef _WIN32
bool make_pipe(std::array<int, 2>& ends);  // programs that are started later do not inherit the ends
#endif

}  // namespace isolaw
