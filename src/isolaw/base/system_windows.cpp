// Implements system.hpp for Windows, with the C library's functions where they suffice.
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
// These headers need windows.h before them.
#include <fcntl.h>
#include <fmt/format.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "isolaw/base/system.hpp"

namespace isolaw {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Status = struct _stat64;

class Handle {
 public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  ~Handle() { close(); }
  void close() {
    if (*this) ::CloseHandle(handle_);
    handle_ = nullptr;
  }
  explicit operator bool() const { return handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE; }
  HANDLE get() const { return handle_; }
  HANDLE* address() { return &handle_; }

 private:
  HANDLE handle_;
};

FileStatus file_status(Status const& status) {
  auto const type = status.st_mode & S_IFMT;
  return {.kind = type == S_IFREG   ? ""
                  : type == S_IFDIR ? "a directory"
                  : type == S_IFIFO ? "a pipe"
                                    : "a device",
          .bytes = static_cast<std::uintmax_t>(std::max<std::int64_t>(0, status.st_size)),
          .changed_ns = std::int64_t{1'000'000'000} * status.st_mtime};
}

// Returns nullopt if the text has half a surrogate pair.
std::optional<std::string> utf8(std::wstring_view text) {
  auto const length = static_cast<int>(text.size());
  auto const bytes =
      ::WideCharToMultiByte(CP_UTF8, WC_ERR_INVALID_CHARS, text.data(), length, nullptr, 0, nullptr, nullptr);
  if (bytes == 0 && length > 0) return std::nullopt;
  std::string converted(static_cast<std::size_t>(bytes), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, converted.data(), bytes, nullptr, nullptr);
  return converted;
}

// Reads UTF-16 or UTF-32. Windows has no code page for them that its functions accept.
std::optional<std::wstring> wide(std::string_view bytes, std::size_t unit, bool big_endian) {
  std::wstring text;
  if (bytes.size() % unit != 0) return std::nullopt;
  for (std::size_t at = 0; at < bytes.size(); at += unit) {
    std::uint32_t code = 0;
    for (std::size_t i = 0; i < unit; ++i)
      code = code << 8U | static_cast<unsigned char>(bytes[at + (big_endian ? i : unit - 1 - i)]);
    bool const is_half = code >= 0xD800 && code < 0xE000;
    if (code > 0x10FFFF || (unit == 4 && is_half)) return std::nullopt;
    if (code > 0xFFFF) text += static_cast<wchar_t>(0xD7C0 + (code >> 10U));
    text += static_cast<wchar_t>(code > 0xFFFF ? 0xDC00 + (code & 0x3FFU) : code);
  }
  return text;
}

HANDLE handle_of(StandardStream stream) {
  return ::GetStdHandle(stream == StandardStream::output ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

// Quotes a word so that the C library of the started program splits the command line into the same words again. A
// backslash is special only before a quotation mark.
void append_quoted(std::wstring& line, std::wstring const& word) {
  line += line.empty() ? L"\"" : L" \"";
  std::size_t backslashes = 0;
  for (wchar_t const c : word) {
    if (c == L'"') line.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    line += c;
  }
  line.append(backslashes, L'\\');
  line += L'"';
}

// Looks for a program in PATH. CreateProcess would look in the current folder first, where a stranger's file may be.
std::wstring find_program(std::string const& name) {
  if (fs::path const path(name); path.has_parent_path()) return path.wstring();
  std::wstring found(32768, L'\0');
  auto const length = ::SearchPathW(::_wgetenv(L"PATH"), fs::path(name).c_str(), L".exe",
                                    static_cast<DWORD>(found.size()), found.data(), nullptr);
  found.resize(length < found.size() ? length : 0);
  return found;
}

}  // namespace

void prepare_process(int& argc, char**& argv) {
  // In binary mode, files and streams hold the same bytes as on other systems.
  _fmode = _O_BINARY;
  for (int const stream : {0, 1, 2}) ::_setmode(stream, _O_BINARY);
  static UINT const code_page = ::GetConsoleOutputCP();
  ::SetConsoleOutputCP(CP_UTF8);
  std::atexit([] { ::SetConsoleOutputCP(code_page); });
  DWORD mode = 0;
  for (auto const stream : {StandardStream::output, StandardStream::error})
    if (::GetConsoleMode(handle_of(stream), &mode) != 0)
      ::SetConsoleMode(handle_of(stream), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);

  static std::vector<std::string> words;
  static std::vector<char*> pointers;
  wchar_t** const given = ::CommandLineToArgvW(::GetCommandLineW(), &argc);
  for (int i = 0; i < argc; ++i) words.push_back(utf8(given[i]).value_or(""));
  ::LocalFree(given);
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  argv = pointers.data();
}

bool is_terminal(StandardStream stream) {
  DWORD mode = 0;  // _isatty() would be true for NUL too
  return ::GetConsoleMode(handle_of(stream), &mode) != 0;
}

int terminal_width(StandardStream stream) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (::GetConsoleScreenBufferInfo(handle_of(stream), &info) == 0) return 80;
  int const columns = info.srWindow.Right - info.srWindow.Left + 1;
  return columns >= 40 ? columns : 80;
}

std::string host_name() {
  auto const* const name = ::_wgetenv(L"COMPUTERNAME");
  return name == nullptr ? std::string() : utf8(name).value_or("");
}

std::string system_name() {
  return "Windows x86_64";
}

std::uint64_t peak_memory_bytes() {
  PROCESS_MEMORY_COUNTERS used{};
  ::K32GetProcessMemoryInfo(::GetCurrentProcess(), &used, sizeof(used));
  return used.PeakWorkingSetSize;
}

int process_id() {
  return static_cast<int>(::GetCurrentProcessId());
}

bool has_ended(int process) {
  Handle const handle(::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process)));
  if (!handle) return ::GetLastError() == ERROR_INVALID_PARAMETER;  // there is no such process
  return ::WaitForSingleObject(handle.get(), 0) == WAIT_OBJECT_0;
}

std::optional<FileStatus> status_of(fs::path const& file) {
  Status status{};
  return ::_wstat64(file.c_str(), &status) == 0 ? std::optional(file_status(status)) : std::nullopt;
}

InputFile::InputFile(fs::path const& file)
    : descriptor_(::_wopen(file.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT)) {}

InputFile::~InputFile() {
  if (is_open()) ::_close(descriptor_);
}

std::optional<FileStatus> InputFile::status() const {
  Status status{};
  return ::_fstat64(descriptor_, &status) == 0 ? std::optional(file_status(status)) : std::nullopt;
}

std::ptrdiff_t InputFile::read(std::span<char> buffer) const {
  return ::_read(descriptor_, buffer.data(), static_cast<unsigned>(buffer.size()));
}

std::error_code write_to_disk(fs::path const& file, std::string_view text) {
  int const descriptor = ::_wopen(file.c_str(), _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT, 0666);
  bool written = descriptor >= 0;
  constexpr std::size_t at_once = 1 << 20;
  for (std::string_view rest = text; written && !rest.empty();) {
    auto const count = ::_write(descriptor, rest.data(), static_cast<unsigned>(std::min(rest.size(), at_once)));
    written = count >= 0;
    if (written) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  written = written && ::_commit(descriptor) == 0;
  std::error_code error = written ? std::error_code() : std::error_code(errno, std::generic_category());
  if (descriptor >= 0 && ::_close(descriptor) != 0 && !error) error = std::error_code(errno, std::generic_category());
  return error;
}

fs::path make_private_directory(fs::path const& name) {
  constexpr int most = 1000;
  for (int i = 0; i < most; ++i) {
    auto path = name;
    path += fmt::format("-{}-{}", process_id(), i);
    if (::_wmkdir(path.c_str()) == 0) return path;
    if (errno != EEXIST) break;
  }
  return {};
}

// Windows cannot lock a folder, so a hidden file in it is held open. Windows removes this file when it is closed, even
// if isolaw is killed.
FolderLock::FolderLock(fs::path const& folder) {
  HANDLE const handle =
      ::CreateFileW((folder / ".isolaw-lock").c_str(), GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS,
                    FILE_ATTRIBUTE_HIDDEN | FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  handle_ = reinterpret_cast<std::intptr_t>(handle);
  taken_ = handle == INVALID_HANDLE_VALUE && ::GetLastError() == ERROR_SHARING_VIOLATION;
}

FolderLock::~FolderLock() {
  Handle const closing(reinterpret_cast<HANDLE>(handle_));
}

std::optional<std::string> converted_to_utf8(std::string_view bytes, std::string const& encoding) {
  constexpr std::size_t most = std::size_t{1} << 30;  // the lengths that Windows takes are of type int
  if (bytes.size() > most) return std::nullopt;
  if (encoding.starts_with("UTF-")) {
    auto const text = wide(bytes, encoding.starts_with("UTF-32") ? 4 : 2, encoding.ends_with("BE"));
    return text ? utf8(*text) : std::nullopt;
  }
  constexpr UINT gb18030 = 54936;
  auto const page = encoding == "GB18030" ? gb18030 : static_cast<UINT>(std::atoi(encoding.c_str() + 2));
  auto const given = static_cast<int>(bytes.size());
  auto const length = ::MultiByteToWideChar(page, MB_ERR_INVALID_CHARS, bytes.data(), given, nullptr, 0);
  if (length == 0 && given > 0) return std::nullopt;
  std::wstring text(static_cast<std::size_t>(length), L'\0');
  ::MultiByteToWideChar(page, 0, bytes.data(), given, text.data(), length);
  return utf8(text);
}

ProgramEnd run_program(std::vector<std::string> words, fs::path const& directory, std::chrono::seconds limit) {
  using enum ProgramEnd::How;
  auto const program = find_program(words.front());
  if (program.empty()) return {not_started};
  std::wstring line;
  for (auto const& word : words) append_quoted(line, fs::path(word).wstring());

  constexpr DWORD longest = 1 << 16;
  SECURITY_ATTRIBUTES inherited{.nLength = sizeof(inherited), .lpSecurityDescriptor = nullptr, .bInheritHandle = TRUE};
  Handle reading, writing;
  Handle const nowhere(::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                     &inherited, OPEN_EXISTING, 0, nullptr));
  if (::CreatePipe(reading.address(), writing.address(), &inherited, longest) == 0 || !nowhere)
    return {not_started, ENOMEM};
  ::SetHandleInformation(reading.get(), HANDLE_FLAG_INHERIT, 0);
  // Windows ends all processes of the job when its last handle is closed, which happens at the latest when isolaw ends.
  Handle const job(::CreateJobObjectW(nullptr, nullptr));
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION ends_with_us{};
  ends_with_us.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  ::SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &ends_with_us, sizeof(ends_with_us));

  STARTUPINFOW start{};
  start.cb = sizeof(start);
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = start.hStdOutput = nowhere.get();
  start.hStdError = writing.get();
  PROCESS_INFORMATION started{};
  if (::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW | CREATE_SUSPENDED,
                       nullptr, directory.c_str(), &start, &started) == 0)
    return {not_started};
  Handle const process(started.hProcess), thread(started.hThread);
  ::AssignProcessToJobObject(job.get(), process.get());
  ::ResumeThread(thread.get());
  writing.close();

  std::string messages;
  auto const deadline = Clock::now() + limit;
  DWORD pause_ms = 0;
  while (true) {
    // The pipe is read after this test, since output that the program wrote just before its end is still in the pipe.
    bool const has_ended = ::WaitForSingleObject(process.get(), pause_ms) == WAIT_OBJECT_0;
    std::array<char, 4096> buffer;
    DWORD there = 0;
    pause_ms = 20;
    while (::PeekNamedPipe(reading.get(), nullptr, 0, nullptr, &there, nullptr) != 0 && there > 0) {
      DWORD count = 0;
      if (::ReadFile(reading.get(), buffer.data(), static_cast<DWORD>(buffer.size()), &count, nullptr) == 0) break;
      pause_ms = 0;  // more may follow at once
      if (messages.size() < longest) messages.append(buffer.data(), count);
    }
    if (has_ended) break;
    if (Clock::now() < deadline) continue;
    ::TerminateProcess(process.get(), 1);
    return {took_too_long};
  }
  DWORD code = 0;
  ::GetExitCodeProcess(process.get(), &code);
  return {exited, static_cast<int>(code), std::move(messages)};
}

}  // namespace isolaw
