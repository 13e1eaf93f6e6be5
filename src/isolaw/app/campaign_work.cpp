#include "isolaw/app/campaign_work.hpp"

#include <fmt/format.h>

#include <exception>
#include <thread>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/interruption.hpp"
#include "isolaw/app/progress.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/processor_time.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/campaign/analyse.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/json/run_json.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::app {

CampaignWork::CampaignWork(std::vector<std::string> const& command_line)
    : command_(to_continue(command_line)),
      start_(Clock::now()),
      cpu_at_start_s_(process_time_s()),
      started_at_(std::time(nullptr)) {}

bool CampaignWork::compute(campaign::Contents& contents, std::filesystem::path const& file, WorkOptions const& how) {
  try {
    SignalGuard const guard;
    ProgressLine line;
    return campaign::run(contents, file,
                         {.jobs = how.jobs,
                          .progress = [&](auto const& p) { line.show(p); },
                          .interrupted = interrupted,
                          .short_of_threads =
                              [](int threads) {
                                say("the system gave no more threads or memory: {} did the work; try: --jobs {}\n",
                                    counted(threads, "thread"), threads);
                              },
                          .profile = &profile_,
                          .share = how.share});
  } catch (std::exception const&) {
    say("stopped: {} finished runs are kept in {}\nafter fixing the fault, continue with: {}\n", contents.runs.size(),
        shown(file), command_);
    throw;
  }
}

int CampaignWork::write_reports(std::filesystem::path const& file, WorkOptions const& how) {
  auto const& directory = how.directory;
  double const search_s = std::chrono::duration<double>(Clock::now() - start_).count();
  // Makes the summary from the store, as `isolaw report` does, so that both commands print the same.
  auto const summary = study::build_summary(campaign::Store::read(file));
  render::write_outputs(summary, directory);
  // Reports the time to draw figures separately, because the figures are only for print and not part of the results.
  auto const before_figures = Clock::now();
  double const cpu_s = process_time_s() - cpu_at_start_s_;
  own_.lap(campaign::Phase::report);
  profile_.mark({campaign::Phase::report});
  draw_figures(summary, how.figures, directory);
  double const figures_s = std::chrono::duration<double>(Clock::now() - before_figures).count();
  auto const profiled = render::profile_json(profile_);
  write_file(directory / "run.json",
             render::run_json({.command = command_,
                               .directory = std::filesystem::absolute(directory).string(),
                               .started_at = started_at_,
                               .search_s = search_s,
                               .total_s = std::chrono::duration<double>(before_figures - start_).count(),
                               .figures_s = figures_s,
                               .cpu_s = cpu_s,
                               .jobs = how.jobs > 0 ? how.jobs : static_cast<int>(std::thread::hardware_concurrency()),
                               .profile = profiled}));
  print(summary, directory, {.json = how.json, .details = how.details}, profiled);
  return exit_code(summary);
}

int CampaignWork::finish(campaign::Contents& contents, WorkOptions const& how) {
  auto const file = how.directory / store_name;
  own_.lap(campaign::Phase::read);
  profile_.mark({campaign::Phase::read});
  bool const finished = compute(contents, file, how);
  campaign::Meter::restart();
  if (how.share && !interrupted()) {
    say("part {} of {} of the analyses of the {} is finished: {}\nonce all parts are finished: isolaw merge OUT PARTS...\n",
        how.share->number, how.share->total,
        campaign::every_device_examined(contents) ? "devices and of the lot's laws" : "devices", shown(file));
    return exit_done;
  }
  if (!finished) {
    auto const analyses =
        contents.analyses() > 0 ? fmt::format(" and {} analyses", contents.analyses()) : std::string();
    say("interrupted: {} finished runs{} are kept in {}\nto continue: {}\n", contents.runs.size(), analyses,
        shown(file), command_);
    return exit_with_refusals;
  }
  if (contents.part) {
    say("part {} of {} is finished: {} in {}\nonce all parts are finished: isolaw merge OUT PARTS...\n",
        contents.part->number, contents.part->total, counted(contents.runs.size(), "run"), shown(file));
    return exit_done;  // also if devices were refused or runs failed: the report of the campaign says so
  }
  return write_reports(file, how);
}

}  // namespace isolaw::app
