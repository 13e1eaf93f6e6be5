#include "isolaw/building/nominal_building.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include "isolaw/wording/finding_json.hpp"

namespace isolaw::building {
namespace {

// Calls take(name, member) for each member of a result, with the member's name in the text of kept_text(). The
// functions that write and read this text both use this list.
void each_member(NominalResult& result, auto&& take) {
  auto& [checked, history, spectra_g, farthest_mm] = result;
  take("coupling", checked.coupling), take("outcome", checked.outcome), take("step_s", checked.step_s);
  take("isolator_mm", checked.isolator_mm), take("balance", checked.balance), take("missed_mm", checked.missed_mm);
  take("draws_error_percent", checked.draws_error_percent), take("equivalent_mm", checked.equivalent_mm);
  take("equivalent_error_percent", checked.equivalent_error_percent);
  take("equivalent_period_s", checked.equivalent_period_s), take("equivalent_damping", checked.equivalent_damping);
  take("doubts", checked.doubts);
  take("history_step_s", history.step_s), take("x_mm", history.x_mm), take("y_mm", history.y_mm);
  take("shear_x_kN", history.shear_x_kN), take("shear_y_kN", history.shear_y_kN);
  take("spectra_g", spectra_g), take("farthest_mm", farthest_mm);
}
void each_member(BearingLoops& loops, auto&& take) {
  take("motion", loops.motion), take("drawn", loops.drawn), take("step_s", loops.step_s);
  take("x_mm", loops.x_mm), take("y_mm", loops.y_mm), take("rotation_rad", loops.rotation_rad);
  take("force_x_kN", loops.force_x_kN), take("force_y_kN", loops.force_y_kN);
}

template <class T>
Json json_of(T const& value) {
  if constexpr (std::is_same_v<T, std::optional<double>>)
    return value ? Json(*value) : Json();
  else if constexpr (std::is_same_v<T, Coupling>)
    return static_cast<int>(value);
  else if constexpr (std::is_same_v<T, std::vector<Finding>>)
    return wording::findings_json(value);
  else
    return value;
}

void read(Json const& from, std::optional<double>& value) {
  value = from.is_null() ? std::nullopt : std::optional(from.get<double>());
}
void read(Json const& from, double& value) {
  value = from.is_null() ? std::nan("") : from.get<double>();
}
void read(Json const& from, Coupling& value) {
  value = static_cast<Coupling>(from.get<int>());
}
void read(Json const& from, std::vector<Finding>& value) {
  value = wording::findings_of(from.get<std::string>());
}
template <class T>
void read(Json const& from, std::vector<T>& values) {
  for (auto const& one : from) read(one, values.emplace_back());
}
template <class T>
void read(Json const& from, T& value) {
  value = from.get<T>();
}

template <class Result>
std::string text_of_members(Result result) {
  Json all;
  each_member(result, [&](char const* name, auto const& value) { all[name] = json_of(value); });
  return all.dump();
}
template <class Result>
Result read_members(std::string_view text) {
  Result result;
  auto const all = Json::parse(text);
  each_member(result, [&](char const* name, auto& value) { read(all.at(name), value); });
  return result;
}

}  // namespace

std::string kept_text(NominalResult const& result) {
  return text_of_members(result);
}
std::string kept_text(BearingLoops const& loops) {
  return text_of_members(loops);
}
NominalResult nominal_result_of(std::string_view text) {
  return read_members<NominalResult>(text);
}
BearingLoops loops_of(std::string_view text) {
  return read_members<BearingLoops>(text);
}

BearingLoops loops_of(Model const& model, Devices const& devices, Study const& study, std::size_t motion, bool drawn,
                      Options options) {
  options.bearing_forces = true;
  auto const bearings = devices.bearings(devices.parameters_of({.kind = drawn ? CaseKind::draw : CaseKind::nominal}));
  auto const run = integrate(model, bearings, study.file.motions[motion], options);
  auto const& h = run.history;
  auto const samples = h.time_s.size(),
             stride = std::max<std::size_t>(1, (samples + most_of_loops - 1) / most_of_loops);
  BearingLoops loops{.motion = motion,
                     .drawn = drawn,
                     .step_s = run.step_s * static_cast<double>(stride),
                     .x_mm = {},
                     .y_mm = {},
                     .rotation_rad = {},
                     .force_x_kN = std::vector<std::vector<double>>(bearings.size()),
                     .force_y_kN = std::vector<std::vector<double>>(bearings.size())};
  for (std::size_t i = 0; i < samples; i += stride) {
    loops.x_mm.push_back(h.base[i][0]);
    loops.y_mm.push_back(h.base[i][1]);
    loops.rotation_rad.push_back(h.base[i][2]);
    for (std::size_t j = 0; j < bearings.size(); ++j) {
      loops.force_x_kN[j].push_back(h.bearing_kN[i][2 * j]);
      loops.force_y_kN[j].push_back(h.bearing_kN[i][2 * j + 1]);
    }
  }
  return loops;
}

NominalHistory thinned(History const& history, double step_s) {
  auto const samples = history.time_s.size();
  auto const stride = std::max<std::size_t>(1, (samples + most_of_history - 1) / most_of_history);
  NominalHistory nominal{
      .step_s = step_s * static_cast<double>(stride), .x_mm = {}, .y_mm = {}, .shear_x_kN = {}, .shear_y_kN = {}};
  for (std::size_t i = 0; i < samples; i += stride) {
    nominal.x_mm.push_back(history.base[i][0]);
    nominal.y_mm.push_back(history.base[i][1]);
    nominal.shear_x_kN.push_back(history.shear_kN[i][0]);
    nominal.shear_y_kN.push_back(history.shear_kN[i][1]);
  }
  return nominal;
}

Response nominal_run(Study const& study, LawSource const& source, Motion const& motion) {
  Model const model(Structure(study.file.frame), study.file.plan());
  Devices const devices(source, study.file, motion);
  auto options = options_of(study, model, devices, motion);
  options.histories = true;
  return integrate(model, devices.bearings(devices.parameters_of({})), motion, options);
}

std::string history_csv(Response const& run, Motion const& motion) {
  auto const& history = run.history;
  std::size_t const diaphragms = history.acceleration.empty() ? 0 : history.acceleration.front().size() / 2;
  std::size_t const axes = motion.y_mm_s2.empty() ? 1 : 2;
  std::string csv = "time [s]";
  auto const head = [&](std::string_view what, std::string_view unit) {
    for (std::size_t axis = 0; axis < axes; ++axis) csv += fmt::format(",{}_{} [{}]", what, "xy"[axis], unit);
  };
  head("base", "mm");
  head("velocity", "mm/s");
  head("force", "kN");
  for (std::size_t floor = 0; floor < diaphragms; ++floor)
    head(floor == 0 ? std::string("acceleration_base") : fmt::format("acceleration_{}", floor), "mm/s2");
  csv += '\n';
  for (std::size_t i = 0; i < history.time_s.size(); ++i) {
    csv += fmt::format("{:.6g}", history.time_s[i]);
    auto const add = [&](auto const& values, std::size_t first) {
      for (std::size_t axis = 0; axis < axes; ++axis) csv += fmt::format(",{:.6g}", values[first + axis]);
    };
    add(history.base[i], 0);
    add(history.velocity[i], 0);
    add(history.shear_kN[i], 0);
    for (std::size_t floor = 0; floor < diaphragms; ++floor) add(history.acceleration[i], 2 * floor);
    csv += '\n';
  }
  return csv;
}

}  // namespace isolaw::building
