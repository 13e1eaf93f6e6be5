#include "isolaw/api/conditions.hpp"

#include <utility>

#include "isolaw/api/calibrate.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw {
namespace {

campaign::LotFileOptions with_rules(campaign::LotFileOptions options) {
  options.built_in_rules = rules::built_in_names();
  options.check_design = [](std::string_view design) { rules::parse_design(design); };
  return options;
}

ConditionsSource source_of_lot(campaign::Lot lot, std::string const& where) {
  if (!lot.conditions)
    throw Error({.where = where,
                 .found = "the lot file has no table [conditions]",
                 .allowed = "[conditions] with a reference, and [[device.test]] tables with temperature-C and order",
                 .advice = "isolaw example DIR --conditions writes a lot that has them"});
  complete_acceptance(lot.acceptance);
  return {
      .observed = campaign::observe_tests(lot), .title = std::move(lot.title), .acceptance = std::move(lot.acceptance)};
}

ConditionsSource source_of_campaign(std::filesystem::path const& directory) {
  auto contents = campaign::Store::read(directory / "campaign.sqlite");
  if (!contents.observed)
    throw Error({.where = printable(directory.string()),
                 .found = "the campaign was made from a lot without a table [conditions]",
                 .allowed = "a campaign of a lot file with [conditions]",
                 .advice = "isolaw conditions lot.toml, once the lot file has the table"});
  return {.observed = std::move(*contents.observed),
          .title = std::move(contents.title),
          .acceptance = std::move(contents.acceptance)};
}

}  // namespace

campaign::Lot read_lot(std::filesystem::path const& file, campaign::LotFileOptions options) {
  return campaign::read_lot_file(file, with_rules(std::move(options)));
}

campaign::Lot read_lot(Json const& tables, std::filesystem::path const& folder, campaign::LotFileOptions options) {
  return campaign::lot_of_tables(tables, folder, with_rules(std::move(options)));
}

ConditionsSource conditions_source(std::filesystem::path const& source, bool allow_outside) {
  if (std::filesystem::is_directory(source)) return source_of_campaign(source);
  return source_of_lot(read_lot(source, {.allow_outside = allow_outside, .other_out = true}),
                       printable(source.string()));
}

ConditionsSource conditions_source(Json const& tables, std::filesystem::path const& folder, bool allow_outside) {
  return source_of_lot(read_lot(tables, folder, {.allow_outside = allow_outside, .other_out = true}), "lot");
}

}  // namespace isolaw
