// Tests campaigns that are computed in parts: how runs are assigned to the parts, and how the parts are merged. Merging
// a thousand parts must take time in proportion to the rows, and no more memory than merging a hundred.
#include "isolaw/campaign/merge.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <map>

#include "campaign_fixture.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::campaign {
namespace {

class MergeTest : public testing::Folder {
 protected:
  Contents prepared(std::vector<std::string> laws, int runs) const {
    Lot lot;
    lot.settings.laws = std::move(laws);
    lot.settings.runs = runs;
    lot.settings.clean.samples_per_cycle = 40;
    lot.settings.analysis = false;
    for (auto const* name : {"a", "b"})
      lot.devices.push_back(testing::device_input(
          name, {write(std::string(name) + ".csv", testing::record_text(*name == 'a' ? 1.0 : 1.2))}));
    lot.settings.complete();
    return prepare(lot);
  }
};

TEST_F(MergeTest, RunsAreDealtEvenlyByTheirCost) {
  auto const contents = prepared({"bilinear", "abe", "hwang-wu", "vaiana"}, 6);
  for (int const parts : {1, 2, 5, 7, 48, 60}) {
    RunAssignment const deal(contents, parts);
    std::vector<std::size_t> runs(static_cast<std::size_t>(parts));
    std::vector<std::uint64_t> cost(runs.size());
    std::uint64_t dearest = 0;
    for (std::size_t s = 0; s < contents.searches.size(); ++s)
      for (int number = 1; number <= 6; ++number) {
        auto const part = static_cast<std::size_t>(deal.part_of(s, number)) - 1;
        ASSERT_LT(part, runs.size());
        ++runs[part];
        cost[part] += relative_cost(contents, contents.searches[s]);
        dearest = std::max(dearest, relative_cost(contents, contents.searches[s]));
      }
    EXPECT_LE(std::ranges::max(runs) - std::ranges::min(runs), 1u) << parts;
    EXPECT_LE(std::ranges::max(cost) - std::ranges::min(cost), dearest) << parts;
    for (int part = 1; part <= parts; ++part) {
      auto share = contents;
      share.part = {part, parts};
      EXPECT_EQ(share.expected_here(), runs[static_cast<std::size_t>(part) - 1]) << part << " of " << parts;
    }
  }
}

TEST_F(MergeTest, DevicesAreDealtByWhatExaminingThemCosts) {
  auto const contents = prepared({"bilinear", "abe", "hwang-wu", "vaiana"}, 1);
  for (int const parts : {1, 2, 3, 20}) {
    auto const dealt = campaign::assign_analyses(contents, parts);
    std::vector<std::uint64_t> cost(static_cast<std::size_t>(parts));
    std::uint64_t dearest = 0;
    for (std::size_t s = 0; s < contents.searches.size(); ++s) {
      ASSERT_TRUE(dealt[s] >= 1 && dealt[s] <= parts);
      cost[static_cast<std::size_t>(dealt[s]) - 1] += relative_cost(contents, contents.searches[s]);
      dearest = std::max(dearest, relative_cost(contents, contents.searches[s]));
    }
    EXPECT_LE(std::ranges::max(cost) - std::ranges::min(cost), dearest) << parts;
  }
}

// Machines compute parts without communicating, so every machine must assign the runs in the same way.
TEST_F(MergeTest, TheDealIsTheSameOnEveryMachine) {
  auto const contents = prepared({"bilinear", "abe"}, 3);
  RunAssignment const deal(contents, 4);
  std::vector<int> dealt;
  for (std::size_t s = 0; s < contents.searches.size(); ++s)
    for (int number = 1; number <= 3; ++number) dealt.push_back(deal.part_of(s, number));
  // The parts of runs 1, 2 and 3 of the searches bilinear on device a, abe on a, bilinear on b, and abe on b.
  EXPECT_EQ(dealt, (std::vector{3, 4, 1, 1, 2, 3, 2, 3, 4, 4, 1, 2}));
}

TEST_F(MergeTest, AStoreInOrderIsTheSameFileHoweverItCameAbout) {
  auto contents = prepared({"bilinear", "abe"}, 40);
  std::vector<campaign::Run> runs;
  for (auto const& search : contents.searches)
    for (int number = 1; number <= 40; ++number)
      runs.push_back(testing::failed_run(search.device, search.law, number, std::string(30, 'x')));
  auto in_order = runs;
  std::ranges::sort(in_order, {}, [](auto const& run) { return std::tie(run.device, run.law, run.number); });
  std::string first;
  for (int const stride : {1, 7, 159}) {  // 160 runs: a stride without a factor in common with 160 reaches every run
    auto const file = folder / "campaign.sqlite";
    auto store = Store::create(file, contents);
    for (std::size_t i = 0; i < runs.size(); ++i) store.add(runs[i * static_cast<std::size_t>(stride) % runs.size()]);
    ASSERT_TRUE(store.finish());
    auto const before = bytes_of(file);
    campaign_store().put_in_order(file);
    auto const after = bytes_of(file);
    if (first.empty()) first = after;
    EXPECT_TRUE(after == first) << stride;
    EXPECT_FALSE(after == before);
    testing::expect_same(Store::read(file).runs, in_order);
    EXPECT_EQ(sqlite::integrity(file), std::vector<std::string>{});
    campaign_store().put_in_order(file);  // the store is in order already, so the file must not change
    EXPECT_TRUE(bytes_of(file) == first);
  }
}

#ifdef __linux__

// Reads a counter that the system keeps for this process in /proc/self: "rchar" or "wchar" in the file io, "VmRSS" or
// "VmHWM" in the file status.
std::uint64_t counted_by_system(std::string const& file, std::string const& key) {
  std::ifstream in("/proc/self/" + file);
  for (std::string word; in >> word;)
    if (word == key + ":") {
      std::uint64_t value = 0;
      in >> value;
      return value;
    }
  return 0;
}

TEST_F(MergeTest, OfAThousandPartsIsLinearInRowsAndFlatInMemory) {
  // `most` is the largest number of parts, and `each` is the number of runs of each search that one part computes.
  constexpr int most = 1000, each = 5;
  struct Cost {
    std::uint64_t bytes = 0;
    std::int64_t sqlite_bytes = 0, process_kB = 0;
  };
  std::map<int, Cost> costs;
  for (int const parts : {100, most}) {
    // Part k has runs k, k + parts, ... of every search.
    auto contents = prepared({"bilinear", "vaiana"}, each * parts);
    contents.part = {1, parts};
    contents.makers = {this_maker()};
    for (auto const& search : contents.searches)
      for (int i = 0; i < each; ++i) {
        auto run = testing::failed_run(search.device, search.law, 1 + i * parts, std::string(200, 'x'));
        run.outcome = Outcome::confirmed;
        run.objective = 0.1;
        run.integration_shift = 0.0;
        run.failure.clear();
        run.parameters.resize(search.box.parameters.size(), 1.0);
        run.history.assign(20, 0.1);
        contents.runs.push_back(std::move(run));
      }
    auto const first = folder / "1.sqlite";
    Store::create(first, contents).finish();
    std::vector<std::filesystem::path> files;
    for (int number = 1; number <= parts; ++number) {
      files.push_back(folder / fmt::format("{}.sqlite", number));
      if (number == 1) continue;
      std::filesystem::copy_file(first, files.back(), std::filesystem::copy_options::overwrite_existing);
      sqlite3* db = nullptr;
      ASSERT_EQ(sqlite3_open(files.back().c_str(), &db), SQLITE_OK);
      auto const sql = fmt::format(
          "PRAGMA synchronous = OFF; BEGIN; UPDATE meta SET value = '{0}/{1}' WHERE key = 'part'; UPDATE run SET number = number + {0} - 1; "
          "UPDATE run_parameter SET number = number + {0} - 1; COMMIT",
          number, parts);
      ASSERT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
      sqlite3_close(db);
    }
    // Merge the files in an arbitrary order.
    for (std::size_t i = 0; i < files.size(); ++i) std::swap(files[i], files[i * 7919 % files.size()]);
    auto const out = folder / "campaign.sqlite";
    std::filesystem::remove(out);
    std::ofstream("/proc/self/clear_refs") << 5;  // resets the peak memory of the process
    auto const memory_before = counted_by_system("status", "VmRSS");
    sqlite3_memory_highwater(1);
    auto const bytes_before = counted_by_system("io", "rchar") + counted_by_system("io", "wchar");
    auto const merged = merge(out, files);
    auto& cost = costs[parts];
    cost.bytes = counted_by_system("io", "rchar") + counted_by_system("io", "wchar") - bytes_before;
    cost.sqlite_bytes = sqlite3_memory_highwater(0);
    cost.process_kB = static_cast<std::int64_t>(counted_by_system("status", "VmHWM") - memory_before);
    EXPECT_EQ(merged.missing, 0u);
    EXPECT_EQ(merged.added, contents.expected_runs());
    EXPECT_EQ(merged.parts, parts);
  }
  // The rows of a part are spread over the whole tree of the database. Once this tree is larger than the page cache,
  // merging a part must read and write only the pages of that part, so bytes grow with the rows. If every part read the
  // whole tree, a thousand parts would move ten times as many bytes.
  auto const& few = costs.at(100);
  auto const& many = costs.at(most);
  EXPECT_LT(static_cast<double>(many.bytes), 2.5 * most / 100 * static_cast<double>(few.bytes));
  // The page cache is full with 100 parts already, so ten times the rows must not need more memory.
  EXPECT_LT(many.sqlite_bytes, few.sqlite_bytes + (4 << 20));
  EXPECT_LT(many.process_kB, few.process_kB + (8 << 10));
}

#endif

}  // namespace
}  // namespace isolaw::campaign
