#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <exception>
#include <thread>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/progress.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/processor_time.hpp"
#include "isolaw/base/shell.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/run_json.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

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

void warn_of_idle_overrides(campaign::Settings const& settings) {
  for (auto const& change : settings.overrides)
    if (std::ranges::find(settings.laws, change.law) == settings.laws.end())
      say("--set {}: has no effect, {} is not among the laws of this campaign\n", change.text(), change.law);
}

}  // namespace

int calibrate(CalibrateArguments const& arguments, std::vector<std::string> const& command_line) {
  using Clock = std::chrono::steady_clock;
  auto const start = Clock::now();
  double const cpu_at_start_s = process_time_s();
  campaign::Profile profile;
  campaign::Meter own(&profile);
  std::time_t const started_at = std::time(nullptr);
  auto const figures = render::figure_choice(arguments.figures);
  fit::instruction_set();  // throws before anything is written, also where no run is left to do
  auto const lot = lot_of(arguments);
  warn_of_idle_overrides(lot.settings);
  auto contents = campaign::prepare(lot);
  for (auto const& device : contents.devices)
    if (!device.usable()) say("{}: refused\n  {}\n", device.name, device.refusal);
  for (auto const& device : contents.devices)
    if (!device.vertical.refusal.empty())
      say("{}: no vertical stiffness\n  {}\n", device.name, device.vertical.refusal);
  // What the lot cannot be held to is said before the search, not after it.
  if (lot.acceptance != campaign::Acceptance{}) study::build_summary(contents);

  auto const directory = output_directory(arguments, lot);
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / store_name;
  render::remove_leftovers(directory);
  auto const [added, released, kept, dropped] =
      open_or_create(file, contents, arguments.fresh, is_of_lot_file(arguments) ? LeftOut::is_gone : LeftOut::stays);
  if (!added.empty()) say("grows by {}\n", joined(added));
  if (!released.empty())
    say("no longer held to rule set {}: --rules {} holds the tests to it again, without another search\n",
        printable(released), printable(released));
  if (!kept.empty())
    say("the compression tests that this campaign holds stay: {}; --vertical DEVICE=FILE gives another\n",
        printable(joined(kept)));
  if (!dropped.empty())
    say("no longer in the lot file, and their K_v no longer in this campaign: the compression tests of {}\n",
        printable(joined(dropped)));
  if (!contents.complete() && !contents.runs.empty())
    say("continuing: {} {} there already\n", counted(contents.runs.size(), "run"),
        contents.runs.size() == 1 ? "is" : "are");

  // To continue is not to start over.
  auto words = command_line;
  std::erase(words, "--fresh");
  auto const command = shell_quoted(words);
  bool finished = false;
  own.lap(campaign::Phase::read);
  profile.mark({campaign::Phase::read});
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
                                  },
                              .profile = &profile});
  } catch (std::exception const&) {
    say("stopped: {} finished runs are kept in {}\nonce the fault is mended, continue with: {}\n", contents.runs.size(),
        shown(file), command);
    throw;
  }
  own.restart();
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
  double const cpu_s = process_time_s() - cpu_at_start_s;
  own.lap(campaign::Phase::report);
  profile.mark({campaign::Phase::report});
  draw_figures(summary, figures, directory);
  double const figures_s = std::chrono::duration<double>(Clock::now() - before_figures).count();
  auto const profiled = render::profile_json(profile);
  write_file(directory / "run.json",
             render::run_json(
                 {.command = command,
                  .directory = std::filesystem::absolute(directory).string(),
                  .started_at = started_at,
                  .search_s = search_s,
                  .total_s = std::chrono::duration<double>(before_figures - start).count(),
                  .figures_s = figures_s,
                  .cpu_s = cpu_s,
                  .jobs = lot.jobs.value_or(0) > 0 ? *lot.jobs : static_cast<int>(std::thread::hardware_concurrency()),
                  .profile = profiled}));
  print(summary, arguments.json, profiled);
  say("results: {} (open {})\n", shown(directory), shown(directory / "report.html"));
  return exit_code(summary);
}

}  // namespace isolaw::app
