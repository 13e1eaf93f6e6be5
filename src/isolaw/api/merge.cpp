#include "isolaw/api/merge.hpp"

#include <fmt/format.h>

#include <optional>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw {

std::filesystem::path store_of_part(std::filesystem::path const& part, std::filesystem::path const& directory,
                                    std::string const& name) {
  std::error_code unknown;
  auto const store = std::filesystem::is_regular_file(part, unknown) ? part : part / name;
  if (std::filesystem::equivalent(store, directory / name, unknown))
    throw Error({.where = part.string(),
                 .found = "is the directory that is merged into",
                 .allowed = "the directories of parts",
                 .advice = "isolaw merge OUT PARTS..., OUT first"});
  return store;
}

campaign::MergeResult merge_runs(DirectoryLock const& /*held*/, std::filesystem::path const& directory,
                                 std::vector<std::filesystem::path> const& parts, MergeCallOptions const& options) {
  std::vector<std::filesystem::path> stores;
  for (auto const& part : parts) stores.push_back(store_of_part(part, directory));
  render::remove_leftovers(directory);
  return campaign::merge(directory / store_name, stores,
                         {.before_replacing = [&] { render::remove_outputs(directory); },
                          .missing = options.missing,
                          .fresh = options.fresh});
}

campaign::Contents merge(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                         MergeCallOptions const& options) {
  fit::instruction_set();  // throws, before anything is written, if the machine lacks the instruction set asked for
  for (auto const& part : parts) store_of_part(part, directory);
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto how = options;
  std::optional<campaign::MissingRun> first;
  how.missing = [&](campaign::MissingRun const& run) {
    if (!first) first = run;
    if (options.missing) options.missing(run);
  };
  auto const merged = merge_runs(lock, directory, parts, how);
  if (merged.missing > 0)
    throw Error({.where = directory.string(),
                 .found = fmt::format("{}; the first: run {} of {} on device '{}'{}", missing_text(merged),
                                      first->number, first->law, first->device,
                                      merged.absent.empty() ? "" : "; not there: " + joined(merged.absent)),
                 .allowed = "every part of the campaign",
                 .advice = "computing or copying what is missing, and merging it; what was there is kept"});
  auto const file = directory / store_name;
  auto contents = campaign::Store::read(file);
  return finish_campaign(std::move(contents), file, options.run);
}

}  // namespace isolaw
