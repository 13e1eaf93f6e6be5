#include "isolaw/api/building_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/building_sources.hpp"

namespace isolaw {
namespace {

// The measured numbers of all draws as [law][draw][motion][measure], row by row as in NumPy.
std::vector<double> measured_of_draws(building::Study const& study, building::RunStore const& store,
                                      std::size_t measures) {
  auto const cases = building::cases_of(study.file.settings);
  auto const first = static_cast<std::size_t>(
      std::ranges::find(cases, building::CaseKind::draw, &building::Case::kind) - cases.begin());
  auto const draws = static_cast<std::size_t>(study.file.settings.draws), motions = study.file.motions.size();
  std::vector<double> measures_of_draws(study.laws.size() * draws * motions * measures, std::nan(""));
  for (std::size_t law = 0; law < study.laws.size(); ++law)
    for (std::size_t motion = 0; motion < motions; ++motion)
      store.for_each_run(law, motion, [&](std::size_t place, std::vector<double> const& measured) {
        if (place < first || place >= first + draws || measured.size() != measures) return;
        auto const row = (law * draws + place - first) * motions + motion;
        std::ranges::copy(measured, measures_of_draws.begin() + static_cast<std::ptrdiff_t>(row * measures));
      });
  return measures_of_draws;
}

// Throws Error if no run of any law was completed: the reports would hold no numbers.
void require_results(building::Answers const& answers) {
  if (std::ranges::any_of(answers.laws, building::has_result)) return;
  std::vector<Complaint> complaints;
  for (auto const& law : answers.laws)
    complaints.push_back({.where = fmt::format("law {}", law.law),
                          .found = building::why_without_result(law),
                          .allowed = "a law whose analyses reach the end of the motions",
                          .advice = "isolaw building --nominal, which writes how far the nominal building comes; "
                                    "another law in `laws` of the building file; or a smaller step_s"});
  throw Error(std::move(complaints));
}

}  // namespace

std::vector<double> peaks_of(StudiedBuilding const& studied, std::string_view quantity) {
  auto const rows = building::quantities();
  auto const row = std::ranges::find(rows, quantity, &building::Quantity::key);
  if (row == rows.end()) {
    std::vector<std::string_view> keys;
    for (auto const& one : rows) keys.push_back(one.key);
    throw Error({.where = "quantity", .found = in_quotes(quantity), .allowed = joined(keys)});
  }
  std::vector<double> peaks;
  auto const width = studied.layout.count();
  for (std::size_t at = 0; at < studied.measured.size(); at += width) {
    auto const measured = std::span(studied.measured).subspan(at, width);
    bool const finite = std::ranges::all_of(measured, [](double v) { return std::isfinite(v); });
    peaks.push_back(finite ? row->value(studied.layout, measured, studied.answers.value().weight_kN) : std::nan(""));
  }
  return peaks;
}

building::Study building_study(building::BuildingFile file, campaign::Contents const& contents,
                               std::string const& where) {
  auto const summary = study::build_summary(contents);
  building::Study result{.file = std::move(file), .laws = {}, .report_units = contents.acceptance.report_units};
  auto& wanted = result.file.settings.laws;
  if (wanted.empty()) wanted.push_back(study::recommended_law(summary, where));
  for (auto const& law : wanted) result.laws.push_back(study::law_source(contents, summary, law, where, result.file));
  return result;
}

building::Model checked_model(building::Study const& study) {
  for (auto const& motion : study.file.motions) building::require_sound(motion);
  building::Model model(building::Structure(study.file.frame), study.file.plan());
  for (auto const& law : study.laws)
    for (auto const& motion : study.file.motions)
      building::options_of(study, model, building::Devices(law, study.file, motion), motion);
  return model;
}

StudiedBuilding study_building(building::Study study, BuildingWork const& options) {
  auto const& part = options.part.part;
  if (part && !options.directory)
    throw Error({.where = "part " + campaign::text(*part),
                 .found = "no directory",
                 .allowed = "a directory of its own for each part, from which they are merged"});
  auto const model = checked_model(study);
  std::optional<TemporaryDirectory> nowhere;
  if (!options.directory) nowhere.emplace();
  auto const directory = options.directory.value_or(nowhere ? nowhere->path() : std::filesystem::path());
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / building_store_name;
  render::remove_leftovers(directory);
  std::string lost;
  if (options.fresh) {
    lost = building::building_store().lost_with(file);
    render::remove_building_outputs(directory);
  }
  std::optional<building::RunStore> store(std::in_place, file, building::properties_of(study), options.fresh,
                                          options.part);
  auto const threads =
      options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1U, std::thread::hardware_concurrency());
  StudiedBuilding studied{.study = std::move(study), .answers = {}, .measured = {}, .layout = model.layout()};
  studied.lost = std::move(lost);
  studied.complete = building::run_all(
      studied.study, *store, threads, {.progress = options.progress, .part = part, .interrupted = options.interrupted});
  studied.runs = store->runs_there();
  if (studied.complete && !part) try {
      studied.answers = building::answer(studied.study, *store, options.interrupted);
      require_results(*studied.answers);
      studied.measured = measured_of_draws(studied.study, *store, studied.layout.count());
    } catch (building::InterruptedRun const&) {
      studied.complete = false;
    }
  store.reset();
  building::building_store().put_in_order(file);
  if (studied.answers && options.directory) render::write_building_outputs(studied.study, *studied.answers, directory);
  return studied;
}

}  // namespace isolaw
