#include "isolaw/data/files/zip_archive.hpp"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/data/files/inflate_limit.hpp"

namespace isolaw::data {
namespace {

using Memory = ZipArchive::Memory;

constexpr std::string_view damaged = "the archive is damaged";

zlib_filefunc64_def functions_on(Memory* memory) {
  static constexpr auto to_memory = [](voidpf stream) -> Memory& { return *static_cast<Memory*>(stream); };
  return {.zopen64_file = [](voidpf opaque, void const*, int) { return opaque; },
          .zread_file =
              [](voidpf, voidpf stream, void* buffer, uLong size) {
                auto& m = to_memory(stream);
                auto const count = std::min<std::size_t>(size, m.bytes.size() - m.at);
                std::memcpy(buffer, m.bytes.data() + m.at, count);
                m.at += count;
                return static_cast<uLong>(count);
              },
          .zwrite_file = [](voidpf, voidpf, void const*, uLong) { return uLong{0}; },
          .ztell64_file = [](voidpf, voidpf stream) { return static_cast<ZPOS64_T>(to_memory(stream).at); },
          .zseek64_file = [](voidpf, voidpf stream, ZPOS64_T offset, int origin) -> long {
            auto& m = to_memory(stream);
            ZPOS64_T const base = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                                  : origin == ZLIB_FILEFUNC_SEEK_CUR ? m.at
                                                                     : m.bytes.size();
            if (offset > m.bytes.size() - base) return -1;
            m.at = static_cast<std::size_t>(base + offset);
            return 0;
          },
          .zclose_file = [](voidpf, voidpf) { return 0; },
          .zerror_file = [](voidpf, voidpf) { return 0; },
          .opaque = memory};
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes, std::string file)
    : file_(std::move(file)), memory_{.bytes = bytes}, limit_(unpacked_limit(bytes.size())) {
  constexpr ZPOS64_T most_entries = 10'000;
  auto functions = functions_on(&memory_);
  handle_ = unzOpen2_64("", &functions);
  if (handle_ == nullptr) refuse({}, std::string(damaged), "save it again");
  unz_global_info64 info{};
  bool const read = unzGetGlobalInfo64(handle_, &info) == UNZ_OK;
  if (read && info.number_entry <= most_entries) return;
  unzClose(handle_);
  refuse({}, read ? fmt::format("{} entries in the archive, above {}", info.number_entry, most_entries)
                  : std::string(damaged));
}

ZipArchive::~ZipArchive() {
  unzClose(handle_);
}

void ZipArchive::refuse(std::string const& entry, std::string found, std::string advice) const {
  throw Error(Complaint{.where = entry.empty() ? file_ : fmt::format("{}:{}", file_, entry),
                        .found = std::move(found),
                        .allowed = "a workbook as Excel writes it",
                        .advice = std::move(advice)});
}

bool ZipArchive::has(std::string const& entry) const {
  constexpr int ignoring_case = 2;
  return unzLocateFile(handle_, entry.c_str(), ignoring_case) == UNZ_OK;
}

void ZipArchive::open(std::string const& entry) {
  if (!has(entry)) refuse(entry, "is not in the archive");
  unz_file_info64 info{};
  if (unzGetCurrentFileInfo64(handle_, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    refuse(entry, std::string(damaged));
  if ((info.flag & 1u) != 0) refuse(entry, "is encrypted", "save it without a password");
  constexpr uLong stored = 0, deflated = 8;
  if (info.compression_method != stored && info.compression_method != deflated)
    refuse(entry, fmt::format("is packed by method {}", info.compression_method), "save it again");
  if (unzOpenCurrentFile(handle_) != UNZ_OK) refuse(entry, std::string(damaged));
}

void ZipArchive::read(std::string const& entry, std::function<void(std::string_view)> const& take) {
  open(entry);
  std::array<char, 1 << 16> buffer;
  while (true) {
    auto const count = unzReadCurrentFile(handle_, buffer.data(), static_cast<unsigned>(buffer.size()));
    if (count < 0) {
      unzCloseCurrentFile(handle_);
      refuse(entry, std::string(damaged), "save it again");
    }
    if (count == 0) break;
    unpacked_ += static_cast<std::uint64_t>(count);
    if (unpacked_ > limit_) {
      unzCloseCurrentFile(handle_);
      refuse(entry,
             fmt::format("grows beyond {} MiB when unpacked, from a file of {:.3g} MiB", limit_ >> 20,
                         static_cast<double>(memory_.bytes.size()) / 1048576.0),
             "a file with the test alone");
    }
    take({buffer.data(), static_cast<std::size_t>(count)});
  }
  if (unzCloseCurrentFile(handle_) == UNZ_CRCERROR) refuse(entry, std::string(damaged), "save it again");
}

}  // namespace isolaw::data
