// ISOLAW_SIMD chooses the instructions and `isolaw bench` measures their speed. The choice must not change any result.
#include <map>

#include "cli/published_laws.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

// A hash of 128 objectives of every law with Integration::converged and 128 with Integration::paper, each rounded to
// seven digits. It changes with the numbers of a law, its published box or the random draws. Whoever changes one of
// these on purpose replaces the hash.
constexpr char const* signature = "46c6fa670866d88b";

Words with(std::string const& set) {
  return {"ISOLAW_SIMD=" + set};
}

class InstructionSets : public InFreshDirectory {
 protected:
  // Returns the instruction sets of this processor, slowest first. It reads them from the message that refuses an
  // unknown instruction set. `emulator` is a command that runs the program on an emulated processor.
  Words available(Words emulator = {}) {
    emulator.insert(emulator.end(), {ISOLAW_BINARY, "bench"});
    auto const o = Process(emulator, directory(), path("out"), path("err"), with("nonsense")).wait();
    std::string const before = "allowed: ";
    auto const begin = o.err.find(before), end = o.err.find("; try:");
    EXPECT_NE(begin, std::string::npos) << o;
    EXPECT_NE(end, std::string::npos) << o;
    Words names;
    std::istringstream list(o.err.substr(begin + before.size(), end - begin - before.size()));
    for (std::string name; std::getline(list, name, ',');) names.push_back(name.substr(name.find_first_not_of(' ')));
    return names;
  }

  // Runs a campaign. Returns summary.json and all rows of the store except the one that names the instruction set.
  std::pair<Words, std::string> campaign(std::string const& set, std::string const& jobs) {
    auto const out = set + "-" + jobs;
    auto const o = start({"calibrate", "ex/study.toml", "--runs", "2", "--population", "42", "--generations", "6",
                          "--jobs", jobs, "--out", out},
                         with(set))
                       .wait();
    EXPECT_EQ(o.code, 0) << o;
    auto rows = all_rows(path(out) / "campaign.sqlite");
    EXPECT_EQ(query(path(out) / "campaign.sqlite", "SELECT instruction_set FROM maker"), Words{set});
    std::erase_if(rows, [](auto const& row) { return row.starts_with("maker: "); });
    return {rows, read(fs::path(out) / "summary.json")};
  }
};

TEST_F(InstructionSets, bench_gives_positive_times_of_every_law_and_the_same_signature_on_all) {
  auto const names = available();
  ASSERT_GE(names.size(), 2u);
  EXPECT_EQ(names.front(), "scalar");
  for (auto const& name : names) {
    auto const o = start({"bench", "--json"}, with(name)).wait();
    ASSERT_EQ(o.code, 0) << name << o;
    auto const bench = Json::parse(o.out);
    Words keys;
    for (auto const& [key, value] : bench.items()) keys.push_back(key);
    EXPECT_EQ(keys, (Words{"isa", "threads", "signature", "laws", "laws_paper"}));
    EXPECT_EQ(bench["isa"], name);
    EXPECT_EQ(bench["threads"], 1);
    EXPECT_EQ(bench["signature"], signature) << name;
    for (auto const* table : {"laws", "laws_paper"}) {
      EXPECT_EQ(bench[table].size(), expected_laws().size());
      for (auto const& law : expected_laws()) {
        ASSERT_TRUE(bench[table].contains(law.id)) << table << ", " << law.id;
        EXPECT_GT(bench[table][std::string(law.id)].get<double>(), 0.0) << table << ", " << law.id;
      }
    }
  }
}

TEST_F(InstructionSets, the_fastest_is_chosen_where_none_is_asked_for) {
  auto const names = available();
  for (auto const& environment : {Words{"ISOLAW_SIMD="}, Words{}}) {
    if (environment.empty() && std::getenv("ISOLAW_SIMD") != nullptr) continue;
    auto const o = start({"bench"}, environment).wait();
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_TRUE(contains(o.out, "instruction set " + names.back() + " (of"));
    EXPECT_TRUE(contains(o.out, signature));
    for (auto const& law : expected_laws()) EXPECT_TRUE(contains(o.out, fmt::format("\n  {} ", law.id)));
  }
}

TEST_F(InstructionSets, unknown_names_are_refused_with_the_allowed_ones_before_anything_is_written) {
  ASSERT_EQ(isolaw({"example", "ex"}).code, 0);
  for (auto const* name : {"nonsense", "AVX2", "avx2 ", "avx1024"})
    for (Words const& command : {Words{"bench"}, Words{"bench", "--json"}, Words{"calibrate", "ex/study.toml"}}) {
      auto const o = start(command, with(name)).wait();
      Words const message{"isolaw: ISOLAW_SIMD: '" + std::string(name) + "', which is no instruction set",
                          "allowed: scalar, ", "try: leave it unset"};
      if (std::ranges::count(command, "--json") > 0)
        expect_refused_as_object(o, message);
      else
        expect_refused(o, message);
    }
  EXPECT_FALSE(exists("out"));
}

TEST_F(InstructionSets, what_the_processor_lacks_is_refused_as_that) {
  auto const names = available();
  int lacking = 0;
  for (auto const* name : {"avx2", "avx512"}) {
    if (std::ranges::count(names, name) > 0) continue;
    ++lacking;
    auto const o = start({"bench"}, with(name)).wait();
    expect_refused(o, {"ISOLAW_SIMD", name, "allowed: scalar, "});
  }
  if (lacking == 0) GTEST_SKIP() << "this processor has them all";
}

#if defined(ISOLAW_QEMU)
// Code compiled for x86-64-v3 may use every instruction of this set, not only AVX2. isolaw must not run that code on a
// processor that lacks some of the instructions.
TEST_F(InstructionSets, a_processor_that_lacks_a_part_of_a_level_is_not_given_its_code) {
  auto const on = [&](std::string const& processor) { return available({ISOLAW_QEMU, "-cpu", processor}); };
  // QEMU before version 7.2 (as in Debian 12) cannot emulate AVX. Without AVX this test would show nothing.
  if (on("max") != Words{"scalar", "sse2", "avx2"}) GTEST_SKIP() << "no x86-64-v3 is emulated here";
  for (auto const* part : {"avx2", "fma", "bmi2", "f16c", "abm", "movbe"})
    EXPECT_EQ(on(std::string("max,-") + part), (Words{"scalar", "sse2"})) << "without " << part;
  EXPECT_EQ(on("Nehalem"), (Words{"scalar", "sse2"}));
}
#endif

TEST_F(InstructionSets, number_of_threads_changes_no_bit_on_any_of_them) {
  ASSERT_EQ(isolaw({"example", "ex"}).code, 0);
  std::map<std::string, std::pair<Words, std::string>> results;
  for (auto const& name : available()) {
    results[name] = campaign(name, "1");
    auto const two = campaign(name, "2");
    EXPECT_EQ(results[name].first, two.first) << name;
    EXPECT_EQ(results[name].second, two.second) << name;
    EXPECT_FALSE(two.first.empty());
  }
  if (!results.contains("avx2") || !results.contains("avx512"))
    GTEST_SKIP() << "this processor lacks avx2 or avx512, which give the same bits";
  EXPECT_EQ(results["avx2"].first, results["avx512"].first);
  EXPECT_EQ(results["avx2"].second, results["avx512"].second);
}

}  // namespace
}  // namespace isolaw::cli_test
