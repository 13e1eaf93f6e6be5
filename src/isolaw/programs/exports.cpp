#include "isolaw/programs/exports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <ranges>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

constexpr std::string_view the_law_itself = "--to openseespy-law, opensees-cpp, abaqus or cpp, the law itself";

Realisation realised(Subject const& subject, Remarks& remarks) {
  auto realisation = realise(subject);
  if (realisation.forms.empty())
    throw Error({.where = "law " + std::string(subject.law->info.id),
                 .found = realisation.explanation,
                 .allowed = "a law that the program's materials can give",
                 .advice = std::string(the_law_itself)});
  if (auto const& form = realisation.forms.front(); far_off(form.from_law))
    remarks.objections.push_back(fmt::format("{}, the closest material of the program, is far off the law: {}",
                                             form.nominal.title, deviation_text(form.from_law)));
  else if (far_off(form.other_cycles))
    remarks.objections.push_back(fmt::format(
        "{}, the closest material of the program, is more than {:.0f} % off the law in cycles that were not tested: {}",
        form.nominal.title, other_cycle_far_off_percent, text(form.other_cycles)));
  else if (realisation.fidelity == Fidelity::refitted)
    remarks.cautions.push_back(
        fmt::format("{} replaces the law, off by: {}{}", form.nominal.title, deviation_text(form.from_law),
                    needs_warning(form.other_cycles) ? "; " + text(form.other_cycles) : std::string()));
  remarks.add(realisation.response, subject);
  return realisation;
}

Realisation realised_model(Subject const& subject, Remarks& remarks) {
  auto realisation = realised(subject, remarks);
  auto const worst = add_draws(realisation, subject);
  if (far_off(worst) && !far_off(realisation.forms.front().from_law))
    remarks.objections.push_back(
        fmt::format("the worst of the draws is far off its own law: {}", deviation_text(worst)));
  return realisation;
}

constexpr std::array all{
    Target{.name = "opensees",
           .write = [](Subject const& s, UnitSystem const& units,
                       Remarks& remarks) { return opensees_script(s, realised(s, remarks), units); },
           .is_named = true,
           .refits = true},
    Target{.name = "openseespy",
           .write = [](Subject const& s, UnitSystem const& units,
                       Remarks& remarks) { return openseespy_script(s, realised(s, remarks), units); },
           .refits = true},
    Target{.name = "openseespy-law",
           .write = [](Subject const& s, UnitSystem const& units, Remarks&) { return openseespy_law(s, units); }},
    Target{.name = "opensees-model",
           .write = [](Subject const& s, UnitSystem const& units,
                       Remarks& remarks) { return opensees_model(s, realised_model(s, remarks), units); },
           .needs_building = true,
           .is_named = true,
           .refits = true},
    Target{.name = "openseespy-model",
           .write = [](Subject const& s, UnitSystem const& units,
                       Remarks& remarks) { return openseespy_model(s, realised_model(s, remarks), units); },
           .needs_building = true,
           .is_named = true,
           .refits = true},
    Target{.name = "cpp",
           .write = [](Subject const& s, UnitSystem const& units, Remarks&) { return cpp_header(s, units); },
           .is_named = true},
    Target{.name = "opensees-cpp",
           .write = [](Subject const& s, UnitSystem const& units, Remarks&) { return opensees_material(s, units); },
           .is_named = true},
    Target{.name = "abaqus",
           .write = [](Subject const& s, UnitSystem const& units, Remarks&) { return abaqus_element(s, units); },
           .is_named = true},
    // The JSON contains the law itself and the error of each substitute, so a poor substitute is no reason to refuse
    // this export.
    Target{.name = "json",
           .write =
               [](Subject const& s, UnitSystem const& units, Remarks& remarks) {
                 auto const realisation = realise(s);
                 remarks.add(realisation.response, s);
                 return export_json(s, realisation, units);
               },
           .refits = true},
    Target{.name = "sheet", .write = value_sheet, .refits = true},
    Target{.name = "csv",
           .write = [](Subject const& s, UnitSystem const& units, Remarks&) { return protocol_csv(s, units); }}};

}  // namespace

void Remarks::add(RefitResponse const& response, Subject const& subject) {
  auto const add_new = [](auto& list, auto const& one) {
    if (std::ranges::find(list, one) == list.end()) list.push_back(one);
  };
  if (!response.why_not.empty())
    add_new(cautions, "the response of a building was not computed: " + response.why_not);
  else if (response.finding)
    add_new(responses, *response.finding);
  else if (response.motions.empty() && !subject.motions.empty())
    cautions.emplace_back(
        "--motion is not used: the file has the law itself, so there is no re-fit to compare with it");
}

std::span<Target const> targets() {
  return all;
}

std::vector<std::string_view> targets_where(bool Target::*is) {
  std::vector<std::string_view> names;
  for (auto const& target : all)
    if (target.*is) names.push_back(target.name);
  return names;
}

Target const& find_target(std::string_view name) {
  for (auto const& target : all)
    if (target.name == name) return target;
  throw Error(
      {.where = "--to", .found = std::string(name), .allowed = joined(all | std::views::transform(&Target::name))});
}

Export write_export(Subject const& subject, Target const& target, UnitSystem const& units, bool anyway) {
  Export result;
  auto const where = study::law_and_device_text(
      subject.law->info.id, subject.lot ? std::nullopt : std::optional<std::string_view>(subject.device));
  study::require_no_objection(subject.doubts, where, anyway);
  if (target.needs_building && !subject.model)
    throw Error({.where = fmt::format("--to {}", target.name),
                 .found = "a law without a model",
                 .allowed = "a layout of isolators, their mass and the motion of the ground"});
  Remarks remarks;
  result.text = target.write(subject, units, remarks);
  auto& to_form = remarks.objections;
  result.cautions = std::move(remarks.cautions);
  result.responses = std::move(remarks.responses);
  if (!to_form.empty() && !anyway)
    throw Error({.where = where,
                 .found = joined(to_form, "; "),
                 .allowed = "a form that is near to the law",
                 .advice = fmt::format("{}; or --anyway", the_law_itself)});
  if (subject.doubts.objection)
    result.overridden_objections.push_back(wording::remark(*subject.doubts.objection, units));
  std::ranges::move(to_form, std::back_inserter(result.overridden_objections));
  return result;
}

}  // namespace isolaw::programs
