#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/part_script.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/processor_time.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/estimate.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/fit/kernels.hpp"

namespace isolaw::app {
namespace {

std::vector<std::string> words_again(CalibrateArguments const& given) {
  std::vector<std::string> words;
  auto const add = [&](auto const& table, Values const& values) {
    for (auto const& row : table)
      if (auto const found = values.find(row.key); found != values.end())
        for (auto& word : words_of(row, found->second)) words.push_back(std::move(word));
  };
  add(campaign::setting_table(), given.settings);
  add(data::reading_table(), given.read);
  add(campaign::acceptance_table(), given.acceptance);
  for (auto const& test : given.vertical) words.insert(words.end(), {"--vertical", test});
  if (given.same_device) words.emplace_back("--same-device");
  if (given.allow_outside) words.emplace_back("--allow-outside");
  words.emplace_back("--");
  for (auto const& input : given.inputs) words.push_back(input.string());
  return words;
}

// Returns the memory that a part needs. It is about that of this process, because both read the whole lot, and a little
// more for each thread.
std::uint64_t memory_bytes(int jobs) {
  constexpr double margin = 1.5;
  constexpr std::uint64_t around = 128U << 20, thread = 16U << 20;
  auto const here = static_cast<double>(peak_memory_bytes());
  return static_cast<std::uint64_t>(margin * here) + around + thread * static_cast<std::uint64_t>(jobs);
}

std::string program_of(std::string const& word) {
  return word.find('/') == std::string::npos ? word : std::filesystem::absolute(word).lexically_normal().string();
}

// Refuses options that would have no effect: options of building studies if the input is a lot file, and options of
// lots if the input is a building file.
void require_used(PartsArguments const& arguments) {
  if (!arguments.campaign && (!arguments.motions.empty() || !arguments.stated.empty()))
    throw Error({.where = arguments.motions.empty() ? "--" + arguments.stated.begin()->first : "--motion",
                 .found = "is given for a lot",
                 .allowed = "for a building file, with --campaign",
                 .advice = "--campaign DIR, the campaign whose lot supplies the bearings"});
  if (!arguments.campaign) return;
  constexpr std::array<std::string_view, 9> of_building{
      "lot", "count", "--to", "--campaign", "--motion", "--motion-dt", "--motion-unit", "--out", "--jobs"};
  auto others = arguments.given;
  std::erase_if(others,
                [&](std::string const& name) { return std::ranges::find(of_building, name) != of_building.end(); });
  if (!others.empty())
    throw Error({.where = joined(others),
                 .found = "is given for a building file",
                 .allowed = "--motion, --motion-dt, --motion-unit, --out and --jobs with --campaign",
                 .advice = "set it in the building file; the campaign keeps its own settings"});
}

// Makes the script for a building study. To estimate the times it computes one block of runs for each law.
std::string script_of_building(PartsArguments const& arguments, std::string const& program) {
  auto const study = building_study(
      {.file = arguments.lot, .from = arguments.campaign, .motions = arguments.motions, .stated = arguments.stated});
  building::Runs const runs(study);
  auto const& blocks = runs.blocks();
  auto const of_law = blocks.count() / study.laws.size();
  double all_s = 0.0, blocks_s = 0.0;
  for (std::size_t law = 0; law < study.laws.size(); ++law) {
    double const before_s = process_time_s();
    runs.compute(blocks.at(law * of_law));
    double const block_s = process_time_s() - before_s;
    blocks_s += block_s;
    all_s += block_s * static_cast<double>(of_law);
  }
  int const jobs = std::max(1, arguments.calibrate.jobs.value_or(1));
  std::vector<std::string> words{"--from", arguments.campaign->string()};
  for (auto const& motion : arguments.motions) words.push_back("--motion=" + motion);
  for (auto const& option : building::stated_table())
    if (auto const found = arguments.stated.find(option.key); found != arguments.stated.end())
      for (auto& word : words_of(option, found->second)) words.push_back(std::move(word));
  words.insert(words.end(), {"--", arguments.lot.string()});
  auto const& title = study.file.settings.title;
  return part_script(arguments.to, {.program = program,
                                    .directory = std::filesystem::current_path(),
                                    .command = "building",
                                    .store = building_store_name,
                                    .words = words,
                                    .title = title.empty() ? arguments.lot.stem().string() : title,
                                    .out = arguments.calibrate.out.value_or(std::filesystem::path("out") / "building"),
                                    .parts = arguments.count,
                                    .jobs = jobs,
                                    .instruction_set = std::string(fit::name(fit::instruction_set())),
                                    // After a merge a few analyses remain for each law and motion. Together they take
                                    // about as long as one block of runs.
                                    .needs = {.part_s = all_s / arguments.count / jobs,
                                              .merge_s = blocks_s * static_cast<double>(study.file.motions.size()),
                                              .memory_bytes = memory_bytes(jobs)}});
}

}  // namespace

int parts(PartsArguments const& arguments, std::string const& program) {
  if (arguments.count < 1 || arguments.count > campaign::most_parts)
    throw Error({.where = "count",
                 .found = std::to_string(arguments.count),
                 .allowed = fmt::format("1 to {} parts", campaign::most_parts)});
  require_used(arguments);
  if (arguments.campaign) {
    print(script_of_building(arguments, program_of(program)));
    return exit_done;
  }
  auto given = arguments.calibrate;
  given.inputs = {arguments.lot};
  auto const lot = lot_of(given);
  auto const contents = campaign::prepare(lot);
  int const jobs = std::max(1, lot.jobs.value_or(1));
  auto const runs = contents.expected_runs();
  auto const count = static_cast<std::size_t>(arguments.count);
  if (runs < count) say("{} for {}: some parts will have none\n", counted(runs, "run"), counted(count, "part"));
  campaign::Estimate const estimate(contents);
  double analyses_s = 0.0;
  for (auto const kind : {campaign::TaskKind::device, campaign::TaskKind::lot, campaign::TaskKind::left_out})
    analyses_s += estimate.work_left_s(kind);
  auto const threads = static_cast<std::size_t>(jobs);
  auto const in_turn = (runs + count * threads - 1) / (count * threads);  // the number of runs that one thread computes
  double const run_s = runs > 0 ? estimate.work_left_s(campaign::TaskKind::run) / static_cast<double>(runs) : 0.0;
  std::vector<std::string> of_merge{"--figures", given.figures};
  print(part_script(arguments.to, {.program = program_of(program),
                                   .directory = std::filesystem::current_path(),
                                   .command = "calibrate",
                                   .store = store_name,
                                   .words = words_again(given),
                                   .merge = std::move(of_merge),
                                   .title = contents.title,
                                   .out = output_directory(given, lot),
                                   .parts = arguments.count,
                                   .jobs = jobs,
                                   .instruction_set = std::string(fit::name(fit::instruction_set())),
                                   .needs = {.part_s = run_s * static_cast<double>(in_turn),
                                             .merge_s = analyses_s / jobs,
                                             .memory_bytes = memory_bytes(jobs)}}));
  return exit_done;
}

}  // namespace isolaw::app
