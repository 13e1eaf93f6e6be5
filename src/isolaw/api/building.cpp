#include "isolaw/api/building.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/api/building_work.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/render/json/building_json.hpp"

namespace isolaw {
namespace {

Values values_of(std::vector<std::pair<std::string, std::string>> const& given) {
  Values values;
  for (auto const& [key, text] : given) {
    auto const rows = building::settings_table();
    auto const row = std::ranges::find(rows, key, &building::FileKey::key);
    values[key] = row == rows.end() ? Json(text) : value_of(row->kind, {text});
  }
  return values;
}

}  // namespace

bool Building::complete() const {
  return study_->complete;
}
std::string Building::verdict() const {
  return wording::paragraph(study_->answers.value().verdict);
}
std::optional<bool> Building::bounds_are_enough() const {
  return study_->answers.value().bounds_are_enough;
}
std::string Building::json() const {
  return render::building_json(study_->study, study_->answers.value());
}
std::vector<std::string> Building::laws() const {
  std::vector<std::string> ids;
  for (auto const& law : study_->study.laws) ids.push_back(law.law);
  return ids;
}
std::size_t Building::draws() const {
  return static_cast<std::size_t>(study_->study.file.settings.draws);
}
std::size_t Building::motions() const {
  return study_->study.file.motions.size();
}
std::vector<double> Building::peaks(std::string_view quantity) const {
  return peaks_of(*study_, quantity);
}

BuildingHistory Building::history(std::size_t law, std::size_t motion) const {
  if (law >= study_->study.laws.size() || motion >= motions())
    throw Error({.where = "history",
                 .found = fmt::format("law {}, motion {}", law, motion),
                 .allowed = fmt::format("below {} and {}", study_->study.laws.size(), motions())});
  auto run = building::nominal_run(study_->study, study_->study.laws[law], study_->study.file.motions[motion]);
  auto& h = run.history;
  return {.time_s = std::move(h.time_s),
          .base = std::move(h.base),
          .shear_kN = std::move(h.shear_kN),
          .acceleration_mm_s2 = std::move(h.acceleration)};
}

Building study_building(BuildingInput const& input, campaign::Contents const& contents,
                        BuildingOptions const& options) {
  building::ReplacedKeys in_place{.motions = {}, .settings = values_of(input.settings)};
  constexpr double mm_in_m = 1e3;
  for (auto const& [name, step_s, x, y] : input.motions) {
    auto& motion =
        in_place.motions.emplace_back(building::Motion{.name = name, .step_s = step_s, .x_mm_s2 = x, .y_mm_s2 = y});
    for (auto* const values : {&motion.x_mm_s2, &motion.y_mm_s2})
      for (double& a : *values) a *= mm_in_m;
  }
  auto file = input.text.empty() ? building::read_building(input.file, in_place)
                                 : building::read_building_text(input.text, "building", {}, in_place);
  BuildingWork work{.jobs = options.jobs, .directory = options.directory, .fresh = options.fresh};
  if (options.progress) work.progress = [&](building::RunProgress const& p) { options.progress(p.done, p.total); };
  work.interrupted = options.interrupted;
  return Building(
      std::make_shared<StudiedBuilding const>(study_building(building_study(std::move(file), contents), work)));
}

}  // namespace isolaw
