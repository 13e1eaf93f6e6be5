#include "isolaw/api/calibrate.hpp"

#include <fmt/format.h>

#include <utility>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/letterhead.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw {

void complete_acceptance(campaign::Acceptance& acceptance) {
  auto& text = acceptance.rules;
  auto const& name = acceptance.rules_file;
  if (text.empty() && !name.empty()) text = rules::load_rule_text(name);
  if (!text.empty()) rules::read_rule_text(text, name);
  if (!acceptance.design.empty()) rules::parse_design(acceptance.design);
  if (acceptance.letterhead.empty() && !acceptance.letterhead_file.empty())
    acceptance.letterhead = load_letterhead(acceptance.letterhead_file);
}

std::vector<Complaint> remarks_on_design(campaign::Acceptance const& acceptance) {
  std::vector<Complaint> remarks;
  if (acceptance.design.empty()) return remarks;
  auto const design = rules::parse_design(acceptance.design);
  if (acceptance.rules.empty())
    remarks.push_back(
        {.where = "design values " + printable(acceptance.design),
         .found = fmt::format("without a rule set no device is checked against them{}",
                              design.disp_mm ? ", but laws are tried at the displacement" : ""),
         .advice = fmt::format("--rules NAME, one of {}, or --rules FILE", joined(rules::built_in_names()))});
  if (design.damping_percent && *design.damping_percent < 1.0)
    remarks.push_back({.where = fmt::format("--design damping={:g}", *design.damping_percent),
                       .found = "damping is in percent, and no isolator has less than 1 %",
                       .advice = fmt::format("damping={:g}", 100.0 * *design.damping_percent)});
  return remarks;
}

campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options) {
  if (!campaign::run(contents, store, options)) return contents;
  // Reads the campaign back from the store, so that callers get what another program would read.
  contents = campaign::Store::read(store);
  if (!contents.part) render::write_outputs(study::build_summary(contents), store.parent_path());
  return contents;
}

Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options) {
  fit::instruction_set();  // throws, before anything is written, if the machine lacks the instruction set asked for
  if (options.part) {
    campaign::parse_part(campaign::text(*options.part));
    if (!options.directory)
      throw Error({.where = "part " + campaign::text(*options.part),
                   .found = "no directory",
                   .allowed = "a directory of its own for each part, from which they are merged",
                   .advice = "out=DIR"});
  }
  auto contents = campaign::prepare(std::move(records), settings, options.title);
  contents.acceptance = options.acceptance;
  contents.part = options.part;
  complete_acceptance(contents.acceptance);
  // Throws before the long search if the rule set or the design values do not suit the lot.
  if (contents.acceptance != campaign::Acceptance{}) study::build_summary(contents);
  if (!options.directory) {
    TemporaryDirectory const directory;
    auto const file = directory.path() / store_name;
    campaign::Store::create(file, contents);
    campaign::run(contents, file, options.run);
    return {std::move(contents), {}};
  }
  make_directory(*options.directory);
  DirectoryLock const lock(*options.directory);
  auto const file = *options.directory / store_name;
  render::remove_leftovers(*options.directory);
  auto continued = open_or_create(file, contents, options.fresh);
  return {finish_campaign(std::move(contents), file, options.run), std::move(continued)};
}

}  // namespace isolaw
