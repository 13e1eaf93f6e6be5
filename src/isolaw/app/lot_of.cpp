#include "isolaw/app/lot_of.hpp"

#include <fmt/format.h>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"

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
}

campaign::Lot lot_of(CalibrateArguments const& a) {
  std::uint64_t const seed = a.seed ? campaign::parse_seed(*a.seed) : 0;  // wrong usage is said before files are read
  bool const from_file = a.inputs.size() == 1 && is_lot_file(a.inputs.front());
  for (auto const& input : a.inputs)
    if (!from_file && is_lot_file(input))
      throw Error({.where = input.string(),
                   .found = "a lot file together with other inputs",
                   .allowed = "one lot file alone, or records",
                   .advice = "name the records in the lot file"});
  auto lot = from_file ? campaign::read_lot_file(a.inputs.front(),
                                                 {.allow_outside = a.allow_outside, .other_out = a.out.has_value()})
                       : campaign::lot_of_files(a.inputs);
  if (lot.title.empty())
    lot.title = printable(from_file ? std::filesystem::absolute(a.inputs.front()).parent_path().filename().string()
                                    : a.inputs.front().stem().string());
  auto& s = lot.settings;
  if (a.laws) s.laws = campaign::parse_laws(*a.laws);
  override_with(a.method, s.method);
  if (a.integration) s.integration = campaign::parse_integration(*a.integration);
  if (a.turning_points) s.turning_points = campaign::parse_turning_points(*a.turning_points);
  if (a.box) s.box = campaign::parse_box(*a.box);
  for (auto const& text : a.set) {
    auto const change = fit::parse_override(text);
    std::erase_if(s.overrides, [&](auto const& o) { return o.law == change.law && o.parameter == change.parameter; });
    s.overrides.push_back(change);
  }
  override_with(a.runs, s.runs);
  override_with(a.population, s.genetic.population);
  override_with(a.generations, s.genetic.generations);
  override_with(a.stagnation_tolerance, s.genetic.stagnation_tolerance);
  if (a.seed) s.seed = seed;
  override_with(a.smooth, s.clean.smooth);
  if (a.samples_per_cycle) s.clean.samples_per_cycle = campaign::parse_samples_per_cycle(*a.samples_per_cycle);
  if (a.center) s.clean.center = true;
  if (a.out) lot.out = a.out;
  if (a.jobs) lot.jobs = a.jobs;
  for (auto& device : lot.devices) apply(a.read, device.read);
  if (s.laws.empty()) s.laws = campaign::parse_laws("all");
  s.validate();
  refuse_endless(lot);
  return lot;
}

std::filesystem::path output_directory(CalibrateArguments const& a, campaign::Lot const& lot) {
  if (lot.out) return *lot.out;
  auto const& first = a.inputs.front();
  auto const name =
      is_lot_file(first) ? std::filesystem::absolute(first).lexically_normal().parent_path().filename() : first.stem();
  return std::filesystem::path("out") / name;
}

}  // namespace isolaw::app
