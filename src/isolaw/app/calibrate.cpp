#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/progress.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/shell.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/check.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/run_json.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::app {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

// Ctrl-C, a polite kill and a terminal that is closed stop the search after the current generation; a second signal
// ends the program at once. Where a closed terminal is to be ignored (nohup), it is.
class SignalGuard {
 public:
  SignalGuard() {
    interrupted = false;
    for (std::size_t i = 0; i < signals.size(); ++i) previous_[i] = std::signal(signals[i], on_signal);
    if (previous_.back() == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  }
  SignalGuard(SignalGuard const&) = delete;
  SignalGuard& operator=(SignalGuard const&) = delete;
  ~SignalGuard() {
    for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], previous_[i]);
  }

 private:
  static void on_signal(int number) {
    interrupted = true;
    std::signal(number, SIG_DFL);
  }
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::array<void (*)(int), signals.size()> previous_{};
};

// Figures that cannot be drawn are no failure: their data and scripts are there.
void draw_figures(study::Summary const& summary, render::FigureChoice choice, std::filesystem::path const& directory) {
  auto const outcome = render::write_figures(summary, choice, directory);
  auto const folder = shown(directory / "figures");
  if (outcome.program_missing)
    say("figures: {} not drawn, {}; try: install gnuplot (Debian: gnuplot-nox) and isolaw report, or gnuplot NAME.gp in {}, which holds data and scripts\n",
        outcome.figures - outcome.drawn, printable(outcome.reason), folder);
  else if (outcome.drawn < outcome.figures)
    say("figures: {} of {} not drawn: {}; data and scripts are in {}\n", outcome.figures - outcome.drawn,
        outcome.figures, printable(outcome.reason), folder);
}

void print(study::Summary const& summary, bool json) {
  auto text =
      json ? render::summary_json(summary) : render::ranking(summary, std::min(terminal_width(STDOUT_FILENO), 120));
  if (auto const verdicts = study::verdict_summary(summary); !json && !verdicts.empty()) text += "\n" + verdicts;
  app::print(text);
}

// Exit code 1 whenever a device was refused, a law could not be searched on a device, a run failed, or a limit of the
// rule set is not kept.
int exit_code(study::Summary const& summary) {
  for (auto const& device : summary.devices)
    if (device.status != "ok") return exit_with_refusals;
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      if (!fit.refusal.empty() || fit.failed_runs > 0) return exit_with_refusals;
  return study::acceptance_failed(summary) ? exit_with_refusals : exit_done;
}

std::string what_is_missing(study::Summary const& summary) {
  auto const runs = summary.missing_runs();
  return fmt::format("{} {} are missing; the calibrate command it was started with continues it",
                     runs > 0 ? runs : summary.missing_analyses(), runs > 0 ? "runs" : "analyses");
}

void warn_of_idle_overrides(campaign::Settings const& settings) {
  for (auto const& change : settings.overrides)
    if (std::ranges::find(settings.laws, change.law) == settings.laws.end())
      say("--set {}: has no effect, {} is not among the laws of this campaign\n", change.text(), change.law);
}

}  // namespace

int calibrate(CalibrateArguments const& arguments, std::vector<std::string> const& command_line) {
  using Clock = std::chrono::steady_clock;
  auto const start = Clock::now();
  std::time_t const started_at = std::time(nullptr);
  auto const figures = render::figure_choice(arguments.figures);
  fit::instruction_set();  // throws before anything is written, also where no run is left to do
  auto const lot = lot_of(arguments);
  warn_of_idle_overrides(lot.settings);
  auto contents = campaign::prepare(lot);
  for (auto const& device : contents.devices)
    if (!device.usable()) say("{}: refused\n  {}\n", device.name, device.refusal);
  // What the lot cannot be held to is said before the search, not after it.
  if (lot.acceptance != campaign::Acceptance{}) study::build_summary(contents);

  auto const directory = output_directory(arguments, lot);
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / store_name;
  render::remove_leftovers(directory);
  open_or_create(file, contents, arguments.fresh);
  if (!contents.complete() && !contents.runs.empty())
    say("continuing: {} runs are there already\n", contents.runs.size());

  // To continue is not to start over.
  auto words = command_line;
  std::erase(words, "--fresh");
  auto const command = shell_quoted(words);
  bool finished = false;
  try {
    SignalGuard const guard;
    ProgressLine line;
    finished = campaign::run(contents, file,
                             {.jobs = lot.jobs.value_or(0),
                              .progress = [&](auto const& p) { line.show(p); },
                              .interrupted = [] { return interrupted.load(); },
                              .short_of_threads =
                                  [](int threads) {
                                    say("the system gave no more threads or memory: {} worked; try: --jobs {}\n",
                                        threads, threads);
                                  }});
  } catch (std::exception const&) {
    say("stopped: {} finished runs are kept in {}\nonce the fault is mended, continue with: {}\n", contents.runs.size(),
        shown(file), command);
    throw;
  }
  if (!finished) {
    auto const analyses =
        contents.analyses() > 0 ? fmt::format(" and {} analyses", contents.analyses()) : std::string();
    say("interrupted: {} finished runs{} are kept in {}\nto continue: {}\n", contents.runs.size(), analyses,
        shown(file), command);
    return exit_with_refusals;
  }
  double const search_s = std::chrono::duration<double>(Clock::now() - start).count();
  // From the store, not from memory: what is printed is what `isolaw report` would print.
  auto const summary = study::build_summary(campaign::Store::read(file));
  render::write_outputs(summary, directory);
  // Figures are for print, and no part of the study: their time is told apart from its.
  auto const before_figures = Clock::now();
  draw_figures(summary, figures, directory);
  write_file(
      directory / "run.json",
      render::run_json(
          {.command = command,
           .directory = std::filesystem::absolute(directory).string(),
           .started_at = started_at,
           .search_s = search_s,
           .total_s = std::chrono::duration<double>(before_figures - start).count(),
           .figures_s = std::chrono::duration<double>(Clock::now() - before_figures).count(),
           .jobs = lot.jobs.value_or(0) > 0 ? *lot.jobs : static_cast<int>(std::thread::hardware_concurrency())}));
  print(summary, arguments.json);
  say("results: {} (open {})\n", shown(directory), shown(directory / "report.html"));
  return exit_code(summary);
}

int report(ReportArguments const& arguments) {
  auto const& directory = arguments.directory;
  auto const figures = render::figure_choice(arguments.figures);
  auto contents = campaign::Store::read(directory / store_name);
  apply(arguments.acceptance, contents.acceptance);
  auto const summary = study::build_summary(contents);
  // What is printed does not depend on the files: a store on read-only media can be looked at as it is.
  std::optional<Error> not_written;
  try {
    render::write_outputs(summary, arguments.out.value_or(directory));
    draw_figures(summary, figures, arguments.out.value_or(directory));
  } catch (Error const& error) {
    not_written = error;
  }
  print(summary, arguments.json);
  if (!contents.complete()) say("the campaign is not complete: {}\n", what_is_missing(summary));
  if (not_written) throw *not_written;
  return contents.complete() ? exit_code(summary) : exit_with_refusals;
}

namespace {

bool holds(std::filesystem::path const& file, std::string_view text) {
  std::error_code unknown;
  if (std::filesystem::file_size(file, unknown) != text.size() || unknown) return false;
  std::string there(text.size(), '\0');
  std::ifstream(file, std::ios::binary).read(there.data(), static_cast<std::streamsize>(there.size()));
  return there == text;
}

// How many runs fewer than the store the reports beside it were made from; 0 when their summary.json does not say so.
std::size_t runs_since(std::filesystem::path const& directory, std::size_t missing_runs) {
  try {
    auto const text =
        read_file(directory / "summary.json",
                  {.largest_bytes = std::uintmax_t{1} << 30, .allowed = "a summary of isolaw", .when_too_large = {}});
    auto const told = render::missing_runs_in(text).value_or(0);
    return told > missing_runs ? told - missing_runs : 0;
  } catch (Error const&) {
    return 0;
  }
}

// `isolaw report --rules ...` holds the tests to something else than the store says; the page states to what. Whether it
// does; `contents` and `summary` are then those of the page. What cannot be read counts as not stated.
bool hold_to_what_the_page_states(std::filesystem::path const& directory, campaign::Contents& contents,
                                  study::Summary& summary) {
  auto const stored = contents.acceptance;
  try {
    auto const stated = render::asked_in(
        read_file(directory / "report.html",
                  {.largest_bytes = std::uintmax_t{1} << 30, .allowed = "a page of isolaw", .when_too_large = {}}));
    if (!stated || *stated == stored) return false;
    contents.acceptance = *stated;
    summary = study::build_summary(contents);
    return true;
  } catch (Error const&) {
    contents.acceptance = stored;
    return false;
  }
}

struct Outputs {
  int compared = 0;
  std::vector<std::string> other;  // names of those that are not what the store gives
};

Outputs compare_outputs(std::filesystem::path const& directory, study::Summary const& summary) {
  Outputs found;
  auto texts = render::output_texts(summary);
  std::ranges::move(render::figure_data(summary), std::back_inserter(texts));
  for (auto const& [name, text] : texts) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(directory / name, unknown)) continue;
    ++found.compared;
    if (!holds(directory / name, text)) found.other.push_back(name);
  }
  return found;
}

}  // namespace

int check(std::filesystem::path const& directory) {
  auto const file = directory / store_name;
  auto result = campaign::check(file);
  auto contents = campaign::Store::read(file);
  auto summary = study::build_summary(contents);
  bool const other_rules = hold_to_what_the_page_states(directory, contents, summary);
  auto const outputs = compare_outputs(directory, summary);
  auto const since = outputs.other.empty() ? 0 : runs_since(directory, summary.missing_runs());
  if (since == 0)
    for (auto const& name : outputs.other)
      (result.of_another_build ? result.differences : result.faults)
          .push_back(
              fmt::format("{} is not what the store gives; isolaw report {} makes it again", name, shown(directory)));
  fmt::print("{}: {}\n", shown(file),
             !result.faults.empty()       ? fmt::format("{} fault(s)", result.faults.size())
             : result.differences.empty() ? "sound"
                                          : fmt::format("sound, but for {} difference(s)", result.differences.size()));
  fmt::print("  {} devices, {} laws on them, {} of {} runs", result.devices, result.searches, result.runs,
             result.expected_runs);
  fmt::print("{}\n", result.expected_analyses > 0
                         ? fmt::format(", {} of {} analyses", result.analyses, result.expected_analyses)
                         : std::string());
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0)
    fmt::print("  not complete: {}\n", what_is_missing(summary));
  fmt::print("  records cleaned and objectives computed again: largest relative difference {:.2g}\n",
             result.largest_difference);
  if (outputs.compared > 0) fmt::print("  {} files beside it compared with what the store gives\n", outputs.compared);
  if (other_rules && outputs.compared > 0)
    fmt::print(
        "  they were made with other rules, design values or lot size than the store holds, and compared with these\n");
  if (since > 0)
    fmt::print("  out of date: {} of them, made before the last {} runs; isolaw report {} makes them again\n",
               outputs.other.size(), since, shown(directory));
  if (result.of_another_build)
    fmt::print("  made by isolaw {}; this is {}, which may compute otherwise\n",
               campaign::text(std::span(contents.makers)), campaign::text(campaign::this_maker()));
  for (auto const& fault : result.faults) fmt::print("  fault: {}\n", fault);
  for (auto const& difference : result.differences) fmt::print("  difference: {}\n", difference);
  return result.faults.empty() && result.differences.empty() && since == 0 ? exit_done : exit_with_refusals;
}

}  // namespace isolaw::app
