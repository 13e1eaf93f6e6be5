#include "isolaw/api/campaign_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw {
namespace {

// What makes the stored campaign another one than the one asked for; empty when it can be continued.
std::vector<std::string> differences(campaign::Contents const& stored, campaign::Contents const& asked) {
  auto settings = stored.settings;
  if (asked.settings.analysis) settings.analysis = true;  // can be added
  auto found = differences(settings, asked.settings);
  if (stored.devices.size() != asked.devices.size())
    found.push_back(fmt::format("{} devices there, {} now", stored.devices.size(), asked.devices.size()));
  for (std::size_t d = 0; d < std::min(stored.devices.size(), asked.devices.size()); ++d) {
    auto const &a = stored.devices[d], &b = asked.devices[d];
    if (a.name != b.name)
      found.push_back(fmt::format("device {}: '{}' there, '{}' now", d + 1, a.name, b.name));
    else if (a.usable() && !b.usable())
      found.push_back(fmt::format("{}: refused now: {}", b.name, b.refusal));
    else if (a.raw.sha256 != b.raw.sha256 || a.refusal != b.refusal)
      found.push_back(fmt::format("{}: its file has changed", b.name));
    else if (a.raw.disp_mm != b.raw.disp_mm || a.raw.force_kN != b.raw.force_kN || a.raw.time_s != b.raw.time_s ||
             a.raw.load_kN != b.raw.load_kN)
      found.push_back(fmt::format("{}: its file is read in another way", b.name));
  }
  return found;
}

// Numbers of two builds may differ: what one began, it finishes.
void require_own(std::filesystem::path const& file, std::vector<campaign::Maker> const& makers) {
  auto const me = campaign::this_maker();
  if (std::ranges::all_of(makers, [&](auto const& maker) { return same_build(maker, me); })) return;
  throw Error(
      {.where = file.string(),
       .found = fmt::format("an unfinished campaign of isolaw {}; this is {}, whose numbers may differ",
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

DirectoryLock::DirectoryLock(std::filesystem::path const& directory)
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    throw Error({.where = directory.string(),
                 .found = "another isolaw works in this directory",
                 .advice = "wait for it, or another --out DIR"});
  }
}

DirectoryLock::~DirectoryLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void open_or_create(std::filesystem::path const& file, campaign::Contents& contents, bool fresh) {
  if (fresh || !std::filesystem::exists(file)) {
    // A kill between the two leaves the former store without its reports, which can be made again: never reports of one
    // campaign beside the store of another.
    campaign::Store::create(file, contents, [&] { render::remove_outputs(file.parent_path()); });
    return;
  }
  campaign::Store::remove_unfinished(file);
  // Of a process that was killed: what it had not finished writing is undone, what it had is kept.
  if (!campaign::Store::is_plain(file)) campaign::Store::open(file).finish();
  auto stored = campaign::Store::read(file);
  auto const changed = differences(stored, contents);
  if (!changed.empty())
    throw Error({.where = file.string(),
                 .found = "the campaign there differs: " + joined(changed, "; "),
                 .allowed = "the same settings and records, to continue it",
                 .advice = "--fresh to start over, or another --out DIR"});
  bool const described =
      stored.title == contents.title && stored.acceptance == contents.acceptance &&
      stored.settings.analysis == contents.settings.analysis &&
      std::ranges::equal(stored.devices, contents.devices, {}, &campaign::Device::info, &campaign::Device::info);
  contents.runs = std::move(stored.runs);
  contents.device_analyses = std::move(stored.device_analyses);
  contents.lot_analyses = std::move(stored.lot_analyses);
  contents.left_out = std::move(stored.left_out);
  contents.makers = std::move(stored.makers);
  if (!contents.complete()) require_own(file, contents.makers);
  if (!described) campaign::Store::open(file).describe(contents);
}

}  // namespace isolaw
