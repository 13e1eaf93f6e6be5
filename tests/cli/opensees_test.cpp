// Every script that `export` writes for the example lot and the measured bearing, run in OpenSees if it is installed
// beside the checkout.
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class InOpenSees : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    if (!fs::exists(program_)) GTEST_SKIP() << "OpenSees is not here: " << program_;
    write("starts.tcl", "puts ready\n");
    if (auto const o = finished({program_, "starts.tcl"}); !contains(o.out + o.err, "ready"))
      GTEST_SKIP() << "OpenSees does not start (needs Debian's tcl, liblapack3, libgfortran5): " << o;
    write("openseespy/__init__.py", "");
    fs::create_symlink(program_.parent_path() / "opensees.so", path("openseespy/opensees.so"));
  }

  Outcome finished(Words const& command) { return Process(command, path("."), path("out"), path("err")).wait(); }

  // Exports every law of the campaign in C for the device, in Tcl and Python: refusals give a reason, all others agree.
  // Returns how many were run.
  int check_all(std::string const& device, Words const& laws) {
    int run = 0;
    for (auto const& law : laws)
      for (std::string const to : {"opensees", "openseespy"}) {
        std::string const file = to == "opensees" ? "exported.tcl" : "exported.py";
        auto const o = isolaw(
            {"export", "C", "--law", law, "--device", device, "--to", to, "--units", "N-m", "--anyway", "--out", file});
        EXPECT_EQ(o.code, 0) << law << " " << device << o;
        if (o.code != 0) continue;
        auto const checked = to == "opensees" ? finished({program_, file, "check"}) : finished({"python3", file});
        auto const said = checked.out + checked.err;
        // This OpenSees was built without Steel02.
        if (checked.code == 99 && said.find("STUB CALLED") != std::string::npos && law == "menegotto-pinto") {
          ++absent_;
          continue;
        }
        EXPECT_EQ(checked.code, 0) << law << " " << device << " " << to << checked;
        EXPECT_TRUE(contains(said, "PASS")) << law << " " << device << " " << to;
        EXPECT_EQ(said.find("WARNING"), std::string::npos) << law << " " << device << " " << to << checked;
        ++run;
      }
    return run;
  }

  int absent_ = 0;
  fs::path const program_ = data.parent_path() / "opensees/OpenSees";
};

TEST_F(InOpenSees, exports_of_the_example_lot) {
  ASSERT_EQ(isolaw({"example", "lot"}).code, 0);
  auto const o = isolaw({"calibrate", "lot/lot.toml", "--laws", "paper", "--runs", "1", "--population", "20",
                         "--generations", "10", "--samples-per-cycle", "60", "--out", "C"});
  ASSERT_EQ(o.code, 0) << o;
  auto const summary = json("C/summary.json");
  int run = 0;
  for (auto const& device : summary["devices"]) run += check_all(device["name"], summary["settings"]["laws"]);
  EXPECT_EQ(run, 10 * 7 * 2);
}

// Also with one set of limit curves: for this bearing they soften, which takes two materials in parallel.
TEST_F(InOpenSees, exports_of_the_measured_bearing) {
  auto const file = data / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  Words const thinned{"--dt", "0.00214823", "--smooth", "9", "--samples-per-cycle", "103", "--runs", "1", "--out", "C"};
  auto const o = isolaw(Words{"calibrate", file, "--laws", "all"} + thinned);
  ASSERT_EQ(o.code, 0) << o;
  Words const laws = json("C/summary.json")["settings"]["laws"];
  EXPECT_EQ(check_all("cyclic-24-49-98pct", laws) + absent_, 2 * static_cast<int>(laws.size()));
  EXPECT_LE(absent_, 2);
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
