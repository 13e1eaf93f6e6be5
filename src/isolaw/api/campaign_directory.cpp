#include "isolaw/api/campaign_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/grow.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw {
namespace {

// Throws Error unless the same build of isolaw began the campaign, since two builds may give different numbers.
void require_own(std::filesystem::path const& file, std::vector<campaign::Maker> const& makers) {
  auto const me = campaign::this_maker();
  if (std::ranges::all_of(makers, [&](auto const& maker) { return same_build(maker, me); })) return;
  throw Error(
      {.where = file.string(),
       .found = fmt::format("a campaign of isolaw {} that is to be continued; this is {}, whose numbers may differ",
                            text(std::span(makers)), text(me)),
       .allowed = "runs of one build in a campaign",
       .advice =
           "finish it with the isolaw that began it (isolaw --version tells its build), --fresh to start over, or another --out DIR"});
}

}  // namespace

void make_directory(std::filesystem::path const& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw Error(
        {.where = directory.string(), .found = "cannot make the directory: " + error.message(), .advice = "--out DIR"});
}

TemporaryDirectory::TemporaryDirectory()
    : path_(make_private_directory(std::filesystem::temp_directory_path() / "isolaw")) {
  if (path_.empty())
    throw Error({.where = std::filesystem::temp_directory_path().string(),
                 .found = "cannot make a directory for the results: " + std::generic_category().message(errno),
                 .advice = "a directory of its own, or TMPDIR"});
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

DirectoryLock::DirectoryLock(std::filesystem::path const& directory) : lock_(directory) {
  if (lock_.is_taken())
    throw Error({.where = directory.string(),
                 .found = "another isolaw works in this directory",
                 .advice = "wait for it, or another --out DIR"});
}

Continuation open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh,
                            UnlistedVertical vertical) {
  // Removes the old reports, then replaces the store. If the process is killed in between, only the old reports are
  // lost, and they can be written again from the old store.
  auto const create = [&] {
    campaign::Store::create(file, contents, [&] { render::remove_outputs(file.parent_path()); });
  };
  if (fresh || !std::filesystem::exists(file)) {
    auto lost = campaign::campaign_store().lost_with(file);
    create();
    return {.lost = std::move(lost)};
  }
  campaign::sqlite::remove_unfinished(file);
  // If an earlier process was killed, writes the log that it left into the store, or undoes a transaction that it did
  // not finish.
  campaign::campaign_store().fold_log(file);
  // If the store holds a part of a campaign, checks it for damage before it is continued, since isolaw merge will read
  // it. SQLite alone would not notice that a database page was cut off: it reads the missing bytes as zeros.
  if (contents.part)
    if (auto const faults = campaign::sqlite::integrity(file); !faults.empty())
      campaign::sqlite::refuse_damaged(file.string(), faults.front());
  auto stored = campaign::Store::read(file);
  auto const changed = campaign::obstacles(stored, contents);
  if (!changed.empty())
    throw Error({.where = file.string(),
                 .found = "the campaign there differs: " + joined(changed, "; "),
                 .allowed = "the same settings and records, to continue it; devices, laws and runs may be added",
                 .advice = "--fresh to start over, or another --out DIR"});
  if (auto const more = campaign::growth(stored, contents); contents.part && !more.empty())
    throw Error({.where = file.string(),
                 .found = fmt::format("part {} of a campaign that is now larger, by {}: its runs are dealt anew",
                                      campaign::text(*contents.part), joined(more)),
                 .allowed = "the lot and settings that it was begun with",
                 .advice = "isolaw merge of the parts there are, then all of it grown without --part; or --fresh"});
  Continuation continued;
  for (auto& device : contents.devices) {
    auto const there = std::ranges::find(stored.devices, device.name, &campaign::Device::name);
    if (there == stored.devices.end() || !there->vertical.is_given() || device.vertical.is_given()) continue;
    bool const stays = vertical == UnlistedVertical::keep;
    auto const& file_name = there->vertical.file;
    (stays ? continued.kept_vertical : continued.dropped_vertical)
        .push_back(fmt::format("{} ({})", device.name, file_name.empty() ? "as stated" : file_name));
    if (stays) device.vertical = there->vertical;
  }
  bool const described =
      stored.title == contents.title && stored.acceptance == contents.acceptance &&
      stored.settings.analysis == contents.settings.analysis &&
      std::ranges::equal(stored.devices, contents.devices, {}, &campaign::Device::info, &campaign::Device::info) &&
      std::ranges::equal(stored.devices, contents.devices, {}, &campaign::Device::vertical,
                         &campaign::Device::vertical);
  continued.added = campaign::growth(stored, contents);
  continued.dropped_rules = contents.acceptance.rules.empty() ? stored.acceptance.rules_file : "";
  campaign::take_over(std::move(stored), contents);
  if (!contents.complete()) require_own(file, contents.makers);
  if (!continued.added.empty())
    create();
  else if (!described)
    campaign::Store::open(file).describe(contents);
  return continued;
}

}  // namespace isolaw
