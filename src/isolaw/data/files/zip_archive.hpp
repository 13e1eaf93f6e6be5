// Reads a zip archive in memory with minizip. One limit applies to all bytes that are unpacked from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

class ZipArchive {
 public:
  struct Memory {
    std::string_view bytes;
    std::size_t at = 0;
  };

  // `bytes` must outlive the object. Throws Error if the archive is damaged or holds more than 10 000 entries.
  ZipArchive(std::string_view bytes, std::string file);
  ~ZipArchive();
  ZipArchive(ZipArchive const&) = delete;
  ZipArchive& operator=(ZipArchive const&) = delete;

  bool has(std::string const& entry) const;
  // Passes an entry to `take` in pieces. Throws Error if the entry is missing, damaged, encrypted, too large, or
  // compressed by another method than deflate.
  void read(std::string const& entry, std::function<void(std::string_view)> const& take);

 private:
  [[noreturn]] void refuse(std::string const& entry, std::string found, std::string advice = {}) const;
  void open(std::string const& entry);

  std::string file_;
  Memory memory_;
  void* handle_ = nullptr;
  std::uint64_t limit_;
  std::uint64_t unpacked_ = 0;
};

}  // namespace isolaw::data
