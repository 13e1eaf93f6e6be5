// OpenSees runs every script that `export` writes for the example lot and for the measured bearing. Each script
// compares OpenSees' forces with isolaw's and prints PASS.
#include "opensees.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class InOpenSees : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    if (!here_.is_there()) GTEST_SKIP() << here_.lacking();
  }

  Outcome finished(Words const& command) { return Process(command, path("."), path("out"), path("err")).wait(); }

  // Exports each law to Tcl and Python for this device, runs both scripts and expects PASS. Returns how many scripts
  // ran.
  int check_all(std::string const& device, Words const& laws) {
    int run = 0;
    for (auto const& law : laws)
      for (std::string const to : {"opensees", "openseespy"}) {
        std::string const file = to == "opensees" ? "exported.tcl" : "exported.py";
        auto const o = isolaw(
            {"export", "C", "--law", law, "--device", device, "--to", to, "--units", "N-m", "--anyway", "--out", file});
        EXPECT_EQ(o.code, 0) << law << " " << device << o;
        if (o.code != 0) continue;
        auto const checked = to == "opensees" ? finished({here_.python, here_.tcl_script, file, "check"})
                                              : finished({here_.python, file});
        auto const said = checked.out + checked.err;
        EXPECT_EQ(checked.code, 0) << law << " " << device << " " << to << checked;
        EXPECT_TRUE(contains(said, "PASS")) << law << " " << device << " " << to;
        EXPECT_EQ(said.find("WARNING"), std::string::npos) << law << " " << device << " " << to << checked;
        ++run;
      }
    return run;
  }

  OpenSeesHere const here_;
};

TEST_F(InOpenSees, exports_of_the_example_lot) {
  ASSERT_EQ(isolaw({"example", "lot"}).code, 0);
  auto const o = isolaw({"calibrate", "lot/lot.toml", "--laws", "paper", "--runs", "1", "--population", "20",
                         "--generations", "10", "--samples-per-cycle", "60", "--out", "C"});
  ASSERT_EQ(o.code, 0) << o;
  // The test exports every third law of each device, so each law is exported for three or four devices.
  auto const summary = json("C/summary.json");
  Words const laws = summary["settings"]["laws"];
  int run = 0;
  for (std::size_t i = 0; i < summary["devices"].size(); ++i)
    for (std::size_t law = i % 3; law < laws.size(); law += 3)
      run += check_all(summary["devices"][i]["name"], {laws[law]});
  EXPECT_EQ(run, 24 * 2);
}

// xara is a build of OpenSees with its own Tcl interpreter. An exported script compares its forces only if its first
// argument is `check`, but xara passes no arguments. check.tcl therefore calls the comparison itself.
TEST_F(InOpenSees, tcl_scripts_in_an_interpreter_of_their_own) {
  if (!here_.has_xara()) GTEST_SKIP() << "xara is not there; " << here_.lacking();
  ASSERT_EQ(isolaw({"example", "lot"}).code, 0);
  auto const o = isolaw({"calibrate", "lot/lot.toml", "--laws", "paper", "--runs", "1", "--population", "20",
                         "--generations", "10", "--samples-per-cycle", "60", "--analysis", "none", "--out", "C"});
  ASSERT_EQ(o.code, 0) << o;
  write(
      "check.tcl",
      "source exported.tcl\nforeach each [namespace children :: isolaw_*] { puts \"passed [${each}::self_check]\" }\n");
  for (std::string const law : json("C/summary.json")["settings"]["laws"]) {
    ASSERT_EQ(isolaw({"export", "C", "--law", law, "--device", "D01", "--to", "opensees", "--anyway", "--out",
                      "exported.tcl"})
                  .code,
              0);
    auto const checked = finished({here_.xara, "-m", "opensees", "check.tcl"});
    EXPECT_TRUE(contains(checked.out + checked.err, "passed 1")) << law << checked;
  }
}

// The second campaign ties the branches of vaiana, so that loading and unloading have the same limit curves. For this
// bearing the curves soften, and the export then needs two OpenSees materials in parallel.
TEST_F(InOpenSees, exports_of_the_measured_bearing) {
  auto const file = data / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  Words const thinned{"--dt",       "0.00214823", "--smooth", "9", "--samples-per-cycle", "103", "--runs", "1",
                      "--analysis", "none",       "--out",    "C"};
  // A short search is enough, because the scripts compare the forces of OpenSees with those of isolaw for any
  // parameters.
  auto const o =
      isolaw(Words{"calibrate", file, "--laws", "all", "--population", "20", "--generations", "20"} + thinned);
  ASSERT_EQ(o.code, 0) << o;
  Words const laws = json("C/summary.json")["settings"]["laws"];
  EXPECT_EQ(check_all("cyclic-24-49-98pct", laws), 2 * static_cast<int>(laws.size()));
  fs::remove_all(path("C"));
  auto const tied =
      isolaw(Words{"calibrate", file, "--laws", "vaiana", "--set", "vaiana.Kb-=Kb+", "--set", "vaiana.f0-=f0+", "--set",
                   "vaiana.alpha-=alpha+", "--set", "vaiana.beta1-=beta1+", "--set", "vaiana.beta2-=beta2+"} +
             thinned);
  ASSERT_EQ(tied.code, 0) << tied;
  EXPECT_EQ(check_all("cyclic-24-49-98pct", {"vaiana"}), 2);
  auto const exported = isolaw({"export", "C", "--law", "vaiana", "--device", "cyclic-24-49-98pct", "--to", "json"});
  auto const description = Json::parse(exported.out);
  EXPECT_EQ(description["fidelity"], "exact") << description["explanation"] << description["refused"];
}

}  // namespace
}  // namespace isolaw::cli_test
