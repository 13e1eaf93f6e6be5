#include "isolaw/app/lot_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::app {
namespace {

bool is_lot_file(std::filesystem::path const& path) {
  return path.extension() == ".toml";
}

// Each number may be large, but not all of them together: the runs are listed before the first one starts.
void refuse_endless(campaign::Lot const& lot) {
  constexpr std::size_t most_runs = 10'000'000;
  auto const runs = static_cast<std::size_t>(lot.settings.runs) * lot.settings.laws.size() * lot.devices.size();
  if (lot.devices.size() > campaign::most_devices)
    throw Error({.where = "lot",
                 .found = fmt::format("{} devices", lot.devices.size()),
                 .allowed = fmt::format("{} or fewer", campaign::most_devices),
                 .advice = "a campaign of its own for each production lot"});
  if (runs > most_runs)
    throw Error({.where = "--runs",
                 .found = fmt::format("{} runs of {} laws on {} devices are {} runs in all", lot.settings.runs,
                                      lot.settings.laws.size(), lot.devices.size(), runs),
                 .allowed = fmt::format("{} in all", most_runs),
                 .advice = "fewer runs, 20 are usual"});
}

// The last part of a directory's name, also of "." and "records/".
std::string folder_name(std::filesystem::path const& directory) {
  auto const path = std::filesystem::weakly_canonical(directory);
  return path.filename().string();
}

bool is_record_name(std::filesystem::path const& file) {
  static constexpr std::array extensions{".csv", ".tsv", ".txt", ".dat", ".asc", ".lvm", ".mat", ".xlsx", ".json"};
  auto extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return std::ranges::find(extensions, std::string_view(extension)) != extensions.end();
}

}  // namespace

std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs) {
  std::vector<std::filesystem::path> files;
  for (auto const& input : inputs) {
    if (!std::filesystem::is_directory(input)) {
      files.push_back(input);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    for (auto const& entry : std::filesystem::directory_iterator(input))
      if (entry.is_regular_file() && is_record_name(entry.path())) inside.push_back(entry.path());
    if (inside.empty())
      throw Error({.where = input.string(),
                   .found = "a directory without test records",
                   .allowed = "files ending in .csv, .tsv, .txt, .dat, .asc, .lvm, .mat, .xlsx or .json",
                   .advice = "naming the files themselves"});
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

namespace {

template <class T>
void override_with(std::optional<T> const& given, T& target) {
  if (given) target = *given;
}

}  // namespace

void apply(ReadArguments const& arguments, data::ReadOptions& options) {
  if (arguments.columns)
    for (auto const& [channel, column] : data::parse_columns(*arguments.columns)) options.columns[channel] = column;
  if (arguments.units)
    for (auto const& [channel, unit] : data::parse_units(*arguments.units)) options.units[channel] = unit;
  if (arguments.dt_s) options.dt_s = arguments.dt_s;
  if (arguments.flip_force) options.flip_force = true;
  auto& corrections = options.corrections;
  if (arguments.skew_ms) corrections.skew_s = *arguments.skew_ms / 1000.0;
  if (arguments.rig_friction_kN) corrections.friction_kN = arguments.rig_friction_kN;
  if (arguments.rig_friction_coefficient) corrections.friction_coefficient = arguments.rig_friction_coefficient;
  if (arguments.moving_mass_kg) corrections.moving_mass_kg = arguments.moving_mass_kg;
  if (arguments.force_factor) corrections.force_factor = arguments.force_factor;
  corrections.validate();
  if (arguments.sheet) options.sheet = arguments.sheet;
  if (arguments.test) options.test = data::parse_test(*arguments.test);
}

void apply(AcceptanceArguments const& arguments, campaign::Acceptance& acceptance) {
  if (arguments.rules) acceptance.rules_file = *arguments.rules;
  if (arguments.rules || (!acceptance.rules_file.empty() && acceptance.rules.empty())) {
    auto text = rules::load_rule_text(acceptance.rules_file);
    acceptance.rules = std::move(text.toml);
  }
  if (!acceptance.rules.empty()) rules::read_rule_text(acceptance.rules, acceptance.rules_file);
  if (arguments.design) acceptance.design = *arguments.design;
  if (!acceptance.design.empty()) {
    auto const damping = rules::parse_design(acceptance.design).damping_percent;
    if (damping && *damping < 1.0)
      say("--design damping={:g}: damping is in percent, and below 1 % is no damping of an isolator; try: "
          "damping={:g}\n",
          *damping, 100.0 * *damping);
  }
  if (arguments.lot_size) acceptance.lot_size = campaign::parse_lot_size(std::to_string(*arguments.lot_size));
}

campaign::Lot lot_of_file(std::filesystem::path const& file, campaign::LotFileOptions options) {
  options.is_built_in_rules = rules::is_built_in;
  return campaign::read_lot_file(file, options);
}

campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options) {
  bool const from_file = inputs.size() == 1 && is_lot_file(inputs.front());
  for (auto const& input : inputs)
    if (!from_file && is_lot_file(input))
      throw Error({.where = input.string(),
                   .found = "a lot file together with other inputs",
                   .allowed = "one lot file alone, or records",
                   .advice = "name the records in the lot file"});
  for (auto const& input : inputs) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(input / "lot.toml", unknown))
      say("{} holds a lot file, which is not used: its records are read as they are; try: {}\n", shown(input),
          shown(input / "lot.toml"));
  }
  auto lot = from_file ? lot_of_file(inputs.front(), options) : campaign::lot_of_files(records_of(inputs));
  auto const& first = inputs.front();
  bool const named_by_folder = from_file || std::filesystem::is_directory(first);
  if (lot.title.empty())
    lot.title = printable(!named_by_folder ? first.stem().string()
                          : from_file      ? std::filesystem::absolute(first).parent_path().filename().string()
                                           : folder_name(first));
  return lot;
}

campaign::Lot lot_of(CalibrateArguments const& a) {
  std::uint64_t const seed = a.seed ? campaign::parse_seed(*a.seed) : 0;  // wrong usage is said before files are read
  auto lot = lot_of_inputs(a.inputs, {.allow_outside = a.allow_outside, .other_out = a.out.has_value()});
  auto& s = lot.settings;
  if (a.laws) s.laws = campaign::parse_laws(*a.laws);
  if (a.method) s.method = campaign::parse_method(*a.method);
  if (a.population || a.generations || a.stagnation_tolerance) {
    if (a.method && s.method != campaign::Method::genetic)
      throw Error({.where = a.population    ? "--population"
                            : a.generations ? "--generations"
                                            : "--stagnation-tolerance",
                   .found = fmt::format("an option of the genetic algorithm, with --method {}", *a.method),
                   .allowed = "with --method ga, which it also chooses where --method is not given"});
    s.method = campaign::Method::genetic;
  }
  if (a.integration) s.integration = campaign::parse_integration(*a.integration);
  if (a.turning_points) s.turning_points = campaign::parse_turning_points(*a.turning_points);
  if (a.box) s.box = campaign::parse_box(*a.box);
  for (auto const& text : a.set) {
    auto const change = fit::parse_override(text);
    std::erase_if(s.overrides, [&](auto const& o) { return o.law == change.law && o.parameter == change.parameter; });
    s.overrides.push_back(change);
  }
  if (a.runs) s.runs = campaign::checked_runs(*a.runs);
  s.complete();
  override_with(a.population, s.genetic.population);
  override_with(a.generations, s.genetic.generations);
  override_with(a.stagnation_tolerance, s.genetic.stagnation_tolerance);
  if (a.seed) s.seed = seed;
  override_with(a.smooth, s.clean.smooth);
  if (a.samples_per_cycle) s.clean.samples_per_cycle = campaign::parse_samples_per_cycle(*a.samples_per_cycle);
  if (a.center) s.clean.center = true;
  if (a.fit_blocks) s.clean.scored.blocks = data::parse_numbers("--fit-blocks", *a.fit_blocks);
  if (a.fit_cycles) s.clean.scored.cycles = data::parse_numbers("--fit-cycles", *a.fit_cycles);
  if (a.score_blocks) s.clean.scored.predicted = data::parse_numbers("--score-blocks", *a.score_blocks);
  if (a.analysis) s.analysis = campaign::parse_analysis(*a.analysis);
  override_with(a.replicates, s.replicates);
  if (a.out) lot.out = a.out;
  if (a.jobs) lot.jobs = a.jobs;
  for (auto& device : lot.devices) apply(a.read, device.read);
  apply(a.acceptance, lot.acceptance);
  if (s.laws.empty()) s.laws = campaign::parse_laws("all");
  s.validate();
  refuse_endless(lot);
  return lot;
}

std::filesystem::path output_directory(CalibrateArguments const& a, campaign::Lot const& lot) {
  if (lot.out) return *lot.out;
  auto const& first = a.inputs.front();
  auto const name = is_lot_file(first) ? std::filesystem::absolute(first).lexically_normal().parent_path().filename()
                    : std::filesystem::is_directory(first) ? std::filesystem::path(folder_name(first))
                                                           : first.stem();
  return std::filesystem::path("out") / name;
}

}  // namespace isolaw::app
