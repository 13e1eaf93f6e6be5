// Runs everything that writes output, on campaigns with all laws and the default search. In the sanitized build the
// sanitizers also find errors in computations whose results no output shows.
#include <map>
#include <sstream>

#include "cli/models.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/programs/exports.hpp"

namespace isolaw::cli_test {
namespace {

class Outputs : public InFreshDirectory {
 protected:
  // The third device's record has no time, so a law that needs time is fitted to two of the three devices.
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record({.samples = 121, .per_cycle = 40, .interval_s = 0.05})));
    write("b.csv", csv(record({.samples = 121, .per_cycle = 40, .strength_kN = 22.0, .interval_s = 0.05})));
    write("c.csv",
          csv(record({.samples = 121, .per_cycle = 40, .stiffness_kN_per_mm = 0.53}), "displacement [mm],force [kN]",
              [](std::size_t, Sample const& s) { return fmt::format("{:.5f},{:.5f}", s.disp_mm, s.force_kN); }));
  }
  // Expects that the command ends in success or in a refusal, without an error that a sanitizer found.
  Outcome sound(Words const& words) {
    auto const o = start(words).wait(900s);  // all laws with sanitizers may take minutes
    EXPECT_LT(o.code, 3) << o;
    EXPECT_EQ(o.err.find("Sanitizer"), std::string::npos) << o;
    EXPECT_EQ(o.err.find("runtime error"), std::string::npos) << o;
    return o;
  }
  std::map<std::string, std::string> files(std::string const& folder) const {
    std::map<std::string, std::string> found;
    for (auto const& entry : fs::recursive_directory_iterator(path(folder)))
      if (entry.is_regular_file() && entry.path().filename() != "run.json" && entry.path().extension() != ".sqlite")
        found[fs::relative(entry.path(), path(folder)).string()] = read_file(entry.path());
    return found;
  }
};

TEST_F(Outputs, EveryWriterOnAllLawsWithDefaultOptions) {
  Words const tests{"--rules", "ntc-2018", "--design", "K_eff=0.7,damping=20,disp=100"};
  sound(Words{"calibrate", "a.csv", "b.csv", "c.csv", "--laws", "all", "--runs", "1", "--replicates", "40",
              "--analysis", "full", "--figures", "all", "--out", "O"} +
        tests);
  ASSERT_TRUE(exists("O/report.html"));
  sound({"report", "O", "--figures", "all", "--out", "again"});
  auto const first = files("O"), again = files("again");
  EXPECT_GT(first.size(), 60u);
  for (auto const& [name, text] : first) EXPECT_TRUE(again.contains(name) && again.at(name) == text) << name;
  EXPECT_EQ(sound({"check", "O"}).code, 0);
  EXPECT_FALSE(sound({"report", "O", "--json", "--figures", "none", "--out", "json"}).out.empty());
  EXPECT_EQ(json("O/summary.json")["laws"].size(), laws::catalogue().size());
  sound(Words{"inspect", "a.csv", "b.csv", "c.csv", "--out", "I"} + tests);
  sound(Words{"inspect", "a.csv", "--json"} + tests);
}

// Exports every law to every program: to half of the programs the law of one device, to the others that of the lot.
// With sanitizers this takes minutes, so each law is a test by itself.
class Exports : public Outputs, public ::testing::WithParamInterface<std::size_t> {};
TEST_P(Exports, OfALawToEveryProgram) {
  std::string const law(laws::catalogue()[GetParam()].info.id);
  sound({"calibrate", "a.csv", "b.csv", "c.csv", "--laws", law, "--runs", "1", "--replicates", "40", "--analysis",
         "full", "--figures", "none", "--out", "O"});
  auto const of_law = json("O/summary.json")["laws"][0];
  EXPECT_FALSE(of_law["lot"].is_null());
  bool const has_population = !of_law["population"]["covariance"].empty();
  EXPECT_NE(sound({"sample", "O", "--law", law}).out.empty(), has_population);
  std::size_t count = GetParam();
  for (auto const& target : programs::targets()) {
    std::string const to(target.name), device = ++count % 2 == 0 ? "a" : "lot";
    sound(Words{"export", "O", "--law", law, "--device", device, "--to", to, "--out", to} +
          needed_by(target, path(".")));
  }
}
INSTANTIATE_TEST_SUITE_P(Every, Exports, ::testing::Range(std::size_t{0}, laws::catalogue().size()));

// Calibrates the first two devices of the example lot with the settings of its lot file. All other settings have their
// defaults. `report` must then write the same files from the store, and `check` must find no fault.
TEST_F(Outputs, EveryWriterOnTheExampleLot) {
  sound({"example", "lot"});
  auto lot = read("lot/lot.toml");
  auto const third = lot.find("[[device]]", lot.find("[[device]]", lot.find("[[device]]") + 1) + 1);
  ASSERT_NE(third, std::string::npos);
  write("lot/two.toml", lot.substr(0, third));
  sound({"calibrate", "lot/two.toml", "--figures", "all", "--out", "O"});
  sound({"report", "O", "--figures", "all", "--out", "again"});
  EXPECT_EQ(files("O"), files("again"));
  EXPECT_EQ(sound({"check", "O"}).code, 0);
}

// bouc-wen gives the same forces for any value of A if the other parameters change with it. The population of the lot
// is therefore given for A = 1, and the table states no scatter of A.
TEST_F(Outputs, LotLawOfTheReducedFormLeavesTheRedundantParameterOut) {
  ASSERT_EQ(sound({"calibrate", "a.csv", "b.csv", "--laws", "bouc-wen", "--runs", "1", "--replicates", "0",
                   "--analysis", "full", "--out", "O"})
                .code,
            0);
  auto const law = json("O/summary.json")["laws"][0];
  ASSERT_TRUE(law["reduced"].get<bool>());
  std::istringstream lines(read("O/tables/lot_law.csv"));
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("bouc-wen,A,")) {
      EXPECT_TRUE(line.ends_with(",,\r")) << line;
      ++found;
    }
  EXPECT_EQ(found, 1u);
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
}

}  // namespace
}  // namespace isolaw::cli_test
