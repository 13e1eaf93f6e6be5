#include "isolaw/campaign/merge.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "isolaw/campaign/grow.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/campaign/schema.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::campaign {
namespace {

std::size_t runs_in(std::filesystem::path const& file) {
  std::size_t count = 0;
  Store::for_each_run(file, [&](std::size_t, std::string const&, int) { ++count; });
  return count;
}

class CampaignMerge : public Merge {
 public:
  explicit CampaignMerge(std::function<void(MissingRun const&)> const& missing)
      : Merge(campaign_store(), this_maker()), missing_(missing) {}

 private:
  std::vector<std::string> differences(Path const& first, Path const& file) override {
    auto const hashes = Store::hashes_of_beginning(file);
    if (first_.empty()) first_ = hashes;
    if (hashes == first_) return {};
    auto there = Store::read_beginning(first), now = Store::read_beginning(file);
    there.part = now.part = std::nullopt;
    auto found = obstacles(there, now, {.one = "in " + first.string(), .other = "in " + file.string()});
    if (found.empty())
      for (auto const& more : growth(there, now)) found.push_back("larger by " + more);
    if (found.empty())
      for (std::size_t i = 0; i < hashes.size(); ++i)
        if (hashes[i] != first_[i])
          found.push_back(fmt::format("another {}", hashes[i].first == "meta" ? "title, or other rules or design values"
                                                                              : "table '" + hashes[i].first + "'"));
    return found;
  }

  void create(Path const& file, Path const& first, std::function<void()> const& before_replacing) override {
    auto beginning = Store::read_beginning_and_series(first);
    beginning.part.reset();
    Store::create(file, beginning, before_replacing).finish();
  }

  void copy_runs(Path const& to, std::vector<Path> const& parts, MergeResult& merged) override {
    auto store = Store::open(to);
    for (auto const& file : parts) {
      auto const taken = store.take_runs(file);
      merged.added += taken.added;
      merged.already_there += taken.already_there;
    }
    store.finish();
  }

  void tell_missing(Path const& file, MergeResult& merged) override {
    // The keys of the runs tell which runs are missing, so the records' series are not read here.
    auto const campaign = Store::read_beginning(file);
    auto const runs = static_cast<std::size_t>(campaign.settings.runs);
    std::map<std::pair<std::size_t, std::string_view>, std::size_t> places;
    for (std::size_t s = 0; s < campaign.searches.size(); ++s)
      if (campaign.searches[s].refusal.empty()) places[{campaign.searches[s].device, campaign.searches[s].law}] = s;
    std::vector<bool> there(campaign.searches.size() * runs);
    std::size_t count = 0;
    Store::for_each_run(file, [&](std::size_t device, std::string const& law, int number) {
      there.at(places.at({device, law}) * runs + static_cast<std::size_t>(number) - 1) = true;
      ++count;
    });
    merged.missing = campaign.expected_runs() - count;
    if (merged.missing == 0) return;
    std::optional<RunAssignment> assignment;
    if (merged.parts > 0) assignment.emplace(Store::read_beginning_and_series(file), merged.parts);
    for (auto const& [key, place] : places)
      for (std::size_t run = 0; run < runs; ++run) {
        if (there[place * runs + run]) continue;
        int const number = static_cast<int>(run) + 1, part = assignment ? assignment->part_of(place, number) : 0;
        ++merged.missing_of[part];
        if (missing_)
          missing_({.device = campaign.devices.at(key.first).name,
                    .law = std::string(key.second),
                    .number = number,
                    .part = part});
      }
  }

  bool has_every_run(Path const& file) override { return runs_in(file) == Store::read_beginning(file).expected_runs(); }

  void complete(Path const& file, std::vector<Path> const& whole, MergeResult& merged) override {
    // An analysis starts from the best of all runs, so analyses are copied only from stores that have every run.
    auto const runs = whole.empty() ? 0 : runs_in(file);
    auto complete = whole;
    std::erase_if(complete, [&](Path const& other) { return runs_in(other) < runs; });
    if (complete.empty()) return;
    auto store = Store::open(file);
    for (auto const& other : complete) merged.analyses += store.take_analyses(other);
    store.finish();
  }

  std::function<void(MissingRun const&)> const& missing_;
  std::vector<std::pair<std::string, std::string>> first_;
};

}  // namespace

MergeResult merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
                  MergeOptions const& options) {
  return CampaignMerge(options.missing).run(out, parts, options.fresh, options.before_replacing);
}

}  // namespace isolaw::campaign
