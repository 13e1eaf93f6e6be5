// calibrate draws figures by default, and report draws them again from the store. If gnuplot is missing, the data of
// the figures and everything else are written anyway.
#include "records.hpp"
#include "run.hpp"

namespace isolaw::cli_test {
namespace {

class Figures : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write_device("D1.csv", 1.0);
    write_device("D2.csv", 1.1);
  }

  void write_device(fs::path const& name, double factor) const {
    write(name, csv(record({.stiffness_kN_per_mm = 0.5 * factor})));
  }

  static Words command() {
    return {"calibrate", "D1.csv",       "D2.csv", "--laws",        "bilinear", "--method", "ga", "--runs",
            "2",         "--population", "10",     "--generations", "4",        "--out",    "R"};
  }
  std::string gnuplot_hidden() const { return "ISOLAW_GNUPLOT=" + path("no gnuplot").string(); }
  bool has_gnuplot() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }
};

TEST_F(Figures, OfTheLotByDefault) {
  auto const words = Words{ISOLAW_BINARY} + command() + Words{"--analysis", "none"};
  auto const outcome = Process(words, directory(), path("out"), path("err")).wait();
  ASSERT_EQ(outcome.code, 0) << outcome;
  for (auto const* name :
       {"front", "objective", "objective_by_device", "parameters_bilinear", "convergence_bilinear"}) {
    EXPECT_TRUE(exists(fs::path("R/figures") / (std::string(name) + ".dat"))) << name;
    EXPECT_TRUE(exists(fs::path("R/figures") / (std::string(name) + ".gp"))) << name;
    if (has_gnuplot()) {
      EXPECT_TRUE(exists(fs::path("R/figures") / (std::string(name) + ".svg"))) << name;
      EXPECT_TRUE(read(fs::path("R/figures") / (std::string(name) + ".pdf")).starts_with("%PDF")) << name;
    }
  }
  EXPECT_FALSE(exists("R/figures/record_D1.gp"));
  auto const facts = json("R/run.json");
  EXPECT_GT(facts.at("figures_seconds").get<double>(), 0.0);
  EXPECT_GE(facts.at("total_seconds").get<double>(), facts.at("search_seconds").get<double>());
}

TEST_F(Figures, WithoutGnuplotOneLineAndExitCodeZero) {
  auto const outcome = start(command() + Words{"--figures", "lot"}, {gnuplot_hidden()}).wait();
  ASSERT_EQ(outcome.code, 0) << outcome;
  EXPECT_EQ(count_of("figures:", outcome.err), 1u) << outcome;
  EXPECT_TRUE(contains(outcome.err, "not drawn"));
  EXPECT_TRUE(contains(outcome.err, "install gnuplot"));
  EXPECT_TRUE(exists("R/figures/front.gp"));
  EXPECT_TRUE(exists("R/figures/front.dat"));
  EXPECT_FALSE(exists("R/figures/front.svg"));
}

TEST_F(Figures, ReportMakesThemFromTheStore) {
  ASSERT_EQ(start(command() + Words{"--figures", "none"}).wait().code, 0);
  EXPECT_FALSE(exists("R/figures"));
  ASSERT_EQ(start({"report", "R", "--figures", "all"}, {gnuplot_hidden()}).wait().code, 0);
  EXPECT_TRUE(exists("R/figures/loops_D1_bilinear.dat"));
  EXPECT_TRUE(exists("R/figures/record_D2.dat"));
  ASSERT_EQ(start({"report", "R", "--figures", "lot"}, {gnuplot_hidden()}).wait().code, 0);
  EXPECT_FALSE(exists("R/figures/record_D2.dat"));  // `--figures lot` removes the figures of single records
}

TEST_F(Figures, OfAnotherCampaignGoWithIt) {
  ASSERT_EQ(start(command() + Words{"--figures", "all"}, {gnuplot_hidden()}).wait().code, 0);
  ASSERT_EQ(start(command() + Words{"--figures", "none", "--fresh", "--seed", "2"}).wait().code, 0);
  EXPECT_FALSE(exists("R/figures/front.dat"));
}

TEST_F(Figures, CheckComparesTheirData) {
  ASSERT_EQ(start(command() + Words{"--figures", "lot"}, {gnuplot_hidden()}).wait().code, 0);
  EXPECT_EQ(isolaw({"check", "R"}).code, 0);
  write("R/figures/front.dat", "another\n");
  auto const outcome = isolaw({"check", "R"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.out, "figures/front.dat is not what the store gives"));
}

TEST_F(Figures, AnotherChoiceIsRefusedBeforeAnyWork) {
  expect_refused(start(command() + Words{"--figures", "some"}).wait(), {"--figures", "'some'", "lot", "all", "none"});
  EXPECT_FALSE(exists("R"));
  expect_refused(isolaw({"report", "R", "--figures", "some"}), {"--figures", "'some'"});
}

}  // namespace
}  // namespace isolaw::cli_test
