#include "isolaw/report/write.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/report/figures.hpp"
#include "isolaw/report/html.hpp"
#include "isolaw/report/inspection.hpp"
#include "isolaw/report/latex_tables.hpp"
#include "isolaw/report/summary_json.hpp"
#include "isolaw/report/tables.hpp"

namespace isolaw::report {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_suffix = ".part";

[[noreturn]] void refuse(fs::path const& path, std::string const& reason) {
  throw Error(Complaint{
      path.string(), "cannot be written: " + reason, {}, "another output directory, or free space in this one"});
}

// What a campaign leaves, beside its store and figures.
struct Output {
  char const* name;
  std::string (*text)(Summary const&);
};
constexpr Output outputs[] = {
    {"summary.json", summary_json},
    {"tables/parameters.csv", parameters_csv},
    {"tables/objective.csv", objective_csv},
    {"tables/robustness.csv", robustness_csv},
    {"tables/converged.csv", converged_csv},
    {"tables/identifiability.csv", identifiability_csv},
    {"tables/lot_law.csv", lot_law_csv},
    {"tables/prediction.csv", prediction_csv},
    {"tables/cycles.csv", cycles_csv},
    {"tables/tests.csv", tests_csv},
    {"tables/lot.csv", lot_csv},
    {"tables/lambda.csv", lambda_csv},
    {"tables/table_a5.csv", table_a5_csv},
    {"tables/table_a5.tex", table_a5_tex},
    {"tables/robustness.tex", robustness_tex},
    {"tables/front.csv", front_csv},
    {"tables/front.tex", front_tex},
    {"report.html", html},
};

}  // namespace

void make_directory(fs::path const& dir) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(dir, error))) refuse(dir, "it is a symbolic link");
  fs::create_directories(dir, error);
  if (error) refuse(dir, error.message());
}

// Everything on disk before the name is given to it: after a power cut the old or the new file is there.
void write_file(fs::path const& path, std::string_view text) {
  auto aside = path;  // in the same directory, where a rename is atomic
  aside += "." + std::to_string(::getpid()) + std::string(part_suffix);
  int const file = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  bool written = file >= 0;
  for (std::string_view rest = text; written && !rest.empty();) {
    auto const count = ::write(file, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    written = count >= 0;
    if (written) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  written = written && (::fsync(file) == 0 || errno == EINVAL);  // EINVAL: a pipe or the like
  std::error_code error = written ? std::error_code() : std::error_code(errno, std::generic_category());
  if (file >= 0 && ::close(file) != 0 && !error) error = std::error_code(errno, std::generic_category());
  if (!error) fs::rename(aside, path, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(aside, ignored);
  refuse(path, error.message());
}

std::vector<std::pair<std::string, std::string>> output_texts(Summary const& summary) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (auto const& [name, text] : outputs) texts.emplace_back(name, text(summary));
  return texts;
}

void remove_outputs(fs::path const& dir) {
  auto const remove = [&](char const* name) {
    std::error_code ignored;
    if (fs::is_regular_file(dir / name, ignored)) fs::remove(dir / name, ignored);
  };
  for (auto const& output : outputs) remove(output.name);
  remove("run.json");
  remove_figures(dir);
}

void write_outputs(Summary const& summary, fs::path const& dir) {
  make_directory(dir / "tables");
  for (auto const& [name, text] : output_texts(summary)) write_file(dir / name, text);
}

void write_inspection(Summary const& summary, fs::path const& dir) {
  make_directory(dir / "tables");
  std::vector<std::pair<std::string, std::string>> const texts{
      {"inspection.json", inspection_json(summary)}, {"tables/cycles.csv", cycles_csv(summary)},
      {"tables/tests.csv", tests_csv(summary)},      {"tables/lot.csv", lot_csv(summary)},
      {"tables/lambda.csv", lambda_csv(summary)},    {"inspection.html", html(summary)}};
  for (auto const& [name, text] : texts) write_file(dir / name, text);
}

void remove_leftovers(fs::path const& dir) {
  for (auto const& folder : {dir, dir / "tables", dir / "figures"}) {
    std::error_code ignored;
    for (auto const& entry : fs::directory_iterator(folder, ignored)) {
      // NAME.PID.part, of a process that is no more.
      auto const name = entry.path().filename().string();
      if (!name.ends_with(part_suffix)) continue;
      auto const stem = std::string_view(name).substr(0, name.size() - part_suffix.size());
      auto const digits = stem.substr(stem.find_last_of('.') + 1);
      auto const owner = number_in<pid_t>(digits);
      if (owner && *owner > 0 && ::kill(*owner, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
    }
  }
}

}  // namespace isolaw::report
