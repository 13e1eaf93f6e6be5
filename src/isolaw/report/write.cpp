#include "isolaw/report/write.hpp"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/report/html.hpp"
#include "isolaw/report/summary_json.hpp"
#include "isolaw/report/tables.hpp"

namespace isolaw::report {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(fs::path const& path, std::string const& reason) {
  throw Error(Complaint{
      path.string(), "cannot be written: " + reason, {}, "another output directory, or free space in this one"});
}

void make_directory(fs::path const& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) refuse(dir, error.message());
}

}  // namespace

void write_file(fs::path const& path, std::string_view text) {
  auto aside = path;  // in the same directory, where a rename is atomic
  aside += "." + std::to_string(::getpid()) + ".part";
  std::error_code error;
  {
    errno = 0;
    std::ofstream file(aside, std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) error = std::error_code(errno != 0 ? errno : EIO, std::generic_category());
  }
  if (!error) fs::rename(aside, path, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(aside, ignored);
  refuse(path, error.message());
}

void write_outputs(Summary const& summary, fs::path const& dir) {
  make_directory(dir / "tables");
  write_file(dir / "summary.json", summary_json(summary));
  write_file(dir / "tables" / "parameters.csv", parameters_csv(summary));
  write_file(dir / "tables" / "objective.csv", objective_csv(summary));
  write_file(dir / "tables" / "robustness.csv", robustness_csv(summary));
  write_file(dir / "tables" / "properties.csv", properties_csv(summary));
  write_file(dir / "report.html", html(summary));
}

}  // namespace isolaw::report
