// Defines the Python functions that do the same as the commands inspect, rules, export, sample, check and example.
#include "core.hpp"

#include <fmt/format.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <iterator>
#include <optional>

#include "isolaw/api/calibrate.hpp"
#include "isolaw/api/catalogue_json.hpp"
#include "isolaw/api/check.hpp"
#include "isolaw/api/conditions.hpp"
#include "isolaw/api/export.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/example_lot.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model.hpp"
#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/study/draws.hpp"

namespace isolaw::python {
namespace {

// `lot` is the path of a lot file, the tables of one as a dict, or a list of records. Returns inspection.json and
// remarks on the design values.
nb::tuple inspected_lot(nb::object const& lot, std::filesystem::path const& folder, bool allow_outside,
                        nb::dict const& given, nb::dict const& vertical) {
  auto const acceptance = given_of(campaign::acceptance_table(), given);
  auto const complete = [&](campaign::Acceptance& to) {
    lay_over(campaign::acceptance_table(), acceptance, to);
    complete_acceptance(to);
  };
  std::string json;
  std::vector<std::string> remarks;
  auto const inspect = [&](auto const& prepare) {
    nb::gil_scoped_release const released;
    auto const contents = prepare();
    json = render::inspection_json(study::build_summary(contents));
    if (!acceptance.empty()) remarks = texts_in_keywords(remarks_on_design(contents.acceptance));
  };
  if (nb::isinstance<nb::list>(lot)) {
    auto records = named_records(nb::cast<nb::list>(lot), vertical);
    inspect([&] {
      campaign::Acceptance to;
      complete(to);
      return campaign::prepare_devices(std::move(records), to);
    });
  } else {
    auto const tables = nb::isinstance<nb::dict>(lot) ? json_of(lot) : Json();
    auto const file = tables.is_null() ? nb::cast<std::filesystem::path>(lot) : std::filesystem::path();
    campaign::LotFileOptions const options{.allow_outside = allow_outside, .other_out = true};
    inspect([&] {
      auto read = tables.is_null() ? read_lot(file, options) : read_lot(tables, folder, options);
      complete(read.acceptance);
      return campaign::prepare_devices(read);
    });
  }
  return nb::make_tuple(json, remarks);
}

std::optional<std::string> text_in(nb::dict const& given, char const* key) {
  return given.contains(key) && !given[key].is_none() ? std::optional(nb::cast<std::string>(given[key])) : std::nullopt;
}

Values seed_in(nb::dict const& given) {
  auto const seed = json_of(given.get("seed", nb::none()));
  return seed.is_null() ? Values{} : Values{{"seed", seed}};
}

// Returns the text of the exported file, and sentences about the law that its user has to read.
nb::tuple exported(Campaign const& campaign, std::string const& law, std::string const& device, std::string const& to,
                   std::vector<std::string> const& motions, nb::dict const& given, bool anyway) {
  ExportOptions const options{.law = law,
                              .device = device,
                              .to = to,
                              .acceptance = given_of(campaign::acceptance_table(), given),
                              .units = text_in(given, "units"),
                              .name = text_in(given, "name"),
                              .motions = motions,
                              .stated = given_of(building::stated_table(), given),
                              .model = given_of(programs::model_table(), given),
                              .seed = seed_in(given),
                              .anyway = anyway};
  try {
    programs::find_target(to);
  } catch (Error const& error) {
    auto complaints = error.complaints();
    // Complaints name options, which are later translated to Python keywords. "--to" would become to_s, because the
    // commands that read records have an option --to with this keyword. So the keyword of export() is set here.
    complaints.front().where = "to";
    throw Error(std::move(complaints));
  }
  auto const result = [&] {
    nb::gil_scoped_release const released;
    return export_law(campaign.contents, options);
  }();
  return nb::make_tuple(result.text, result.doubts);
}

// Returns the parameters of drawn devices, shape (count, parameters), and warnings about them.
nb::tuple drawn(Campaign const& campaign, std::string const& law, int count, nb::dict const& given) {
  study::require_draws(count);
  auto settings = campaign.contents.settings;
  campaign::apply(seed_in(given), settings);
  auto const draws = study::draw_devices(campaign.contents, campaign.summary, law, static_cast<std::size_t>(count),
                                         settings.seed, "the campaign");
  std::vector<double> values;
  for (auto const& device : draws.values) values.insert(values.end(), device.begin(), device.end());
  std::vector<std::string> names;
  for (auto const& parameter : *draws.parameters) names.push_back(parameter.name);
  auto const columns = names.size();
  return nb::make_tuple(names, array_of(std::move(values), {draws.values.size(), columns}), study::warnings(draws));
}

std::vector<std::string> remarks_of(nb::dict const& given) {
  auto const stated = given_of(campaign::acceptance_table(), given);
  if (stated.empty()) return {};
  campaign::Acceptance acceptance;
  lay_over(campaign::acceptance_table(), stated, acceptance);
  complete_acceptance(acceptance);
  return texts_in_keywords(remarks_on_design(acceptance));
}

// A damaged store may hold bytes that are no text.
std::vector<std::string> printables(std::vector<std::string> texts) {
  for (auto& text : texts) text = printable(text);
  return texts;
}

nb::dict checked(std::filesystem::path const& directory) {
  auto const result = [&] {
    nb::gil_scoped_release const released;
    return check_directory(directory);
  }();
  nb::dict found;
  found["sound"] = result.is_sound();
  found["campaign"] = nb::none();
  found["building"] = nb::none();
  if (auto const& campaign = result.campaign) {
    nb::dict one;
    one["sound"] = campaign->is_sound();
    one["devices"] = campaign->check.devices;
    one["runs"] = campaign->check.runs;
    one["expected_runs"] = campaign->check.expected_runs;
    one["analyses"] = campaign->check.analyses;
    one["expected_analyses"] = campaign->check.expected_analyses;
    one["largest_difference"] = campaign->check.largest_difference;
    one["faults"] = printables(campaign->check.faults);
    one["differences"] = printables(campaign->check.differences);
    one["missing"] = printable(campaign->missing);
    one["compared_files"] = campaign->compared_files;
    one["outdated_files"] = campaign->outdated_files;
    one["other_rules"] = campaign->other_rules;
    one["made_by"] = printable(campaign->made_by);
    found["campaign"] = one;
  }
  if (auto const& building = result.building) {
    nb::dict one;
    one["sound"] = building->is_sound();
    one["runs"] = building->runs;
    one["expected_runs"] = building->expected_runs;
    one["faults"] = printables(building->faults);
    found["building"] = one;
  }
  return found;
}

void write_example(std::filesystem::path const& directory, std::string const& kind) {
  nb::gil_scoped_release const released;
  if (kind == "building") return app::write_example_building(directory);
  std::map<std::string, std::vector<app::TextFile> (*)()> const kinds{
      {"lot", app::example_lot}, {"tests", app::example_tests}, {"conditions", app::example_conditions}};
  auto const found = kinds.find(kind);
  if (found == kinds.end())
    throw Error(
        {.where = "kind", .found = in_quotes(kind), .allowed = "lot, tests, conditions, building", .advice = {}});
  app::write_example(directory, found->second());
}

}  // namespace

void add_commands(nb::module_& m) {
  m.def("inspect", &inspected_lot, nb::arg("lot"), nb::arg("folder"), nb::arg("allow_outside"), nb::arg("given"),
        nb::arg("vertical"));
  m.def("rule_sets_json", &rule_sets_json);
  m.def("rule_text", &rule_text, nb::arg("name"));
  m.def("export", &exported, nb::arg("campaign"), nb::arg("law"), nb::arg("device"), nb::arg("to"), nb::arg("motions"),
        nb::arg("given"), nb::arg("anyway"));
  m.def("remarks_on_design", &remarks_of, nb::arg("given"));
  m.def(
      "write_output",
      [](std::filesystem::path const& file, std::string const& text) { app::write_output(file, text, {}); },
      nb::arg("file"), nb::arg("text"));
  m.def("sample", &drawn, nb::arg("campaign"), nb::arg("law"), nb::arg("count"), nb::arg("given"));
  m.def("check", &checked, nb::arg("directory"));
  m.def("example", &write_example, nb::arg("directory"), nb::arg("kind"));
}

}  // namespace isolaw::python
