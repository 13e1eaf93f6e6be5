// Tests `isolaw export` of a whole building. The laws of the example lot are exported as an OpenSees script in Tcl and
// in Python, and OpenSees runs both. Further tests check what the export refuses.
#include "cli/models.hpp"
#include "cli/records.hpp"
#include "opensees.hpp"

namespace isolaw::cli_test {
namespace {

class ExportedModel : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("layout.csv", "name,x [m],y [m],load [kN]\nA,0,0,1600\nB,6,0,1600\nC,0,4,1700\nD,6,4,1700\n");
    write("x.csv", ground_motion(2.0, 0.02, 401));
    write("y.csv", ground_motion(1.0, 0.02, 401));
    ASSERT_EQ(isolaw({"example", "lot"}).code, 0);
  }
  void calibrate(std::string const& laws, Words const& more = {}) {
    auto const o = isolaw(Words{"calibrate", "lot/lot.toml", "--laws", laws, "--method", "best", "--runs", "1",
                                "--analysis", "full", "--replicates", "0", "--out", "C"} +
                          more);
    ASSERT_LE(o.code, 1) << o;
  }
  Outcome exported(std::string const& law, std::string const& to, Words const& more) {
    return isolaw(Words{"export", "C", "--law", law, "--device", "lot", "--to", to, "--anyway"} + more);
  }
  Words const whole_{"--layout", "layout.csv", "--axial", "900kN/mm", "--ground-motion", "x.csv"};
};

class ExportedModelInOpenSees : public ExportedModel {
 protected:
  void SetUp() override {
    if (!here_.is_there()) GTEST_SKIP() << here_.lacking();
    ExportedModel::SetUp();
  }
  Outcome finished(Words const& command) { return Process(command, path("."), path("out"), path("err")).wait(); }

  Outcome run_tcl(Words const& arguments) { return finished(Words{here_.python, here_.tcl_script} + arguments); }
  Outcome run_python(Words const& arguments) { return finished(Words{here_.python} + arguments); }

  OpenSeesHere const here_;
};

TEST_F(ExportedModelInOpenSees, of_the_example_lot_runs_in_both_languages) {
  Words tied;
  for (auto const* name : {"Kb", "f0", "alpha", "beta1", "beta2"})
    tied = tied + Words{"--set", fmt::format("vaiana.{0}-={0}+", name)};
  calibrate("bilinear,bouc-wen,vaiana", tied);
  for (auto const* law : {"bilinear", "bouc-wen", "vaiana"}) {
    Words const both = whole_ + Words{"--ground-motion-y", "y.csv"};
    auto o = exported(law, "opensees-model", both + Words{"--out", "m.tcl"});
    ASSERT_EQ(o.code, 0) << o;
    o = exported(law, "openseespy-model", both + Words{"--out", "m.py"});
    ASSERT_EQ(o.code, 0) << o;
    auto const tcl = run_tcl({"m.tcl", "run", "tcl"});
    EXPECT_EQ(tcl.code, 0) << law << tcl;
    auto const python = run_python({"m.py", "run", "python"});
    EXPECT_EQ(python.code, 0) << law << python;
    EXPECT_FALSE(contains(tcl.out + tcl.err + python.out + python.err, "WARNING ")) << tcl << python;
    EXPECT_EQ(read("tcl/peaks.csv"), read("python/peaks.csv")) << law;
    for (auto const* bound : {"lower", "nominal", "upper"}) {
      EXPECT_TRUE(contains(read("tcl/peaks.csv"), fmt::format("\n{},D,", bound))) << law << bound;
      for (auto const* file : {"slab.csv", "bearings.csv"})
        for (auto const* folder : {"tcl", "python"})
          EXPECT_EQ(std::ranges::count(read(fmt::format("{}/{}/{}", folder, bound, file)), '\n'), 402) << law << bound;
    }
    EXPECT_EQ(run_tcl({"m.tcl", "check"}).code, 0) << law;
    EXPECT_EQ(run_python({"m.py"}).code, 0) << law;
    fs::remove_all(path("tcl"));
    fs::remove_all(path("python"));
  }
}

TEST_F(ExportedModelInOpenSees, draws_of_the_lot_run) {
  calibrate("bilinear,bouc-wen");
  for (auto const* law : {"bilinear", "bouc-wen"}) {
    auto const o = exported(law, "opensees-model", whole_ + Words{"--draws", "3", "--out", "m.tcl"});
    ASSERT_EQ(o.code, 0) << o;
    auto const run = run_tcl({"m.tcl", "run", law});
    EXPECT_EQ(run.code, 0) << law << run;
    auto const said = run.out + run.err;
    for (auto const* row : {"\nnominal ", "\ndraw_1 ", "\ndraw_3 ", "\nmean ", "\nlargest "})
      EXPECT_TRUE(contains(said, row)) << law << said;
    EXPECT_NE(read(std::string(law) + "/draw_1/slab.csv"), read(std::string(law) + "/draw_2/slab.csv"));
    EXPECT_EQ(run_tcl({"m.tcl", "check"}).code, 0) << law;
  }
}

TEST_F(ExportedModel, draws_are_repeatable_by_their_seed) {
  calibrate("bouc-wen");
  auto const drawn = [&](Words const& more) {
    auto const o = exported("bouc-wen", "opensees-model", whole_ + Words{"--draws", "2"} + more);
    EXPECT_EQ(o.code, 0) << o;
    return o.out;
  };
  auto const first = drawn({"--seed", "7"});
  EXPECT_EQ(first, drawn({"--seed", "7"}));
  EXPECT_NE(first, drawn({"--seed", "8"}));
  EXPECT_TRUE(contains(first, "# Analyses: nominal, and 2 draws, seed 7, each isolator with a law of its own"));
  // The model draws the same devices as `isolaw sample` does. Each draw has four isolators, so isolator 1 of draw 2 is
  // the fifth device.
  auto const sampled = isolaw({"sample", "C", "--law", "bouc-wen", "--count", "8", "--seed", "7"});
  ASSERT_EQ(sampled.code, 0) << sampled;
  EXPECT_TRUE(contains(first, "draw_2_4 {"));
  EXPECT_FALSE(contains(first, "draw_2_5 {"));
  std::istringstream rows(sampled.out);
  std::string row;
  for (int i = 0; i <= 5; ++i) std::getline(rows, row);
  std::vector<double> values;
  std::istringstream cells(row);
  for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
  ASSERT_EQ(values.size(), 7u) << row;
  // The initial stiffness of bouc-wen is alpha Ke + (1 - alpha) Ke A. It is the first argument, kInit, of OpenSees'
  // bearing element.
  double const initial = values[2] * (values[1] + (1.0 - values[1]) * values[3]);
  auto const at = first.find("draw_2_1 {");
  ASSERT_NE(at, std::string::npos);
  constexpr std::string_view command = "elastomericBearingBoucWen $tag $i $j ";
  auto const argument = first.find(command, at);
  EXPECT_NEAR(std::stod(first.substr(argument + command.size())), initial, 1e-9 * initial) << row;
}

TEST_F(ExportedModel, what_is_asked_for_wrongly_is_refused) {
  calibrate("bilinear");
  auto const refused = [&](Words const& words, std::vector<std::string> const& said) {
    auto const o = exported("bilinear", "opensees-model", words);
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_EQ(o.out, "");
    for (auto const& part : said) EXPECT_TRUE(contains(o.err, part)) << part << "\n" << o;
  };
  refused({}, {"--layout: is not given", "--ground-motion: is not given"});
  Words const motion{"--ground-motion", "x.csv"}, axial{"--axial", "900kN/mm"}, layout{"--layout", "layout.csv"};
  write("bare.csv", "x [m],y [m]\n0,0\n6,0\n");
  Words const bare{"--layout", "bare.csv"};
  refused(bare + axial + motion, {"--mass: is not given", "try: --mass 1200t"});
  refused(bare + Words{"--mass", "1200"} + axial + motion, {"--mass: '1200'", "unit of mass or weight"});
  refused(bare + Words{"--mass", "-3t"} + axial + motion, {"--mass: '-3t'"});
  refused(layout + motion, {"--axial: is not given", "no compression test", "--axial 1200kN/mm"});
  refused(layout + motion + Words{"--axial", "3kN"}, {"--axial: '3kN'"});
  refused(layout + motion + axial + Words{"--gyration", "3"}, {"--gyration: '3'"});
  refused(layout + motion + axial + Words{"--scale", "0"}, {"--scale: 0"});
  refused(layout + motion + axial + Words{"--draws", "501"},
          {"--draws: 501 draws of 4 bearings", "try: files of fewer draws, each with its own --seed"});
  refused(layout + motion + axial + Words{"--seed", "3"}, {"--seed: is given without draws"});
  write("short.csv", ground_motion(1.0, 0.02, 400));
  refused(whole_ + Words{"--ground-motion-y", "short.csv"}, {"--ground-motion-y: ", "401 samples", "400 samples"});
  write("finer.csv", ground_motion(1.0, 0.01, 401));
  refused(whole_ + Words{"--ground-motion-y", "finer.csv"}, {"--ground-motion-y: ", "every 0.02 s", "every 0.01 s"});
  write("nan.csv", ground_motion() + "2.020,nan\n");
  refused(layout + axial + Words{"--ground-motion", "nan.csv"}, {"nan.csv:103: 'nan' is no number"});
  write("empty.csv", "x [m],y [m]\n");
  refused(Words{"--layout", "empty.csv"} + axial + motion, {"empty.csv: no bearings"});
  refused(Words{"--layout", "nowhere.csv"} + axial + motion, {"nowhere.csv"});
  refused(whole_ + Words{"--out", "layout.csv"}, {"layout.csv: is an input of this command and would be replaced"});
  // The target opensees writes a material, not a model, so it must refuse an option for models.
  auto const o = exported("bilinear", "opensees", {"--mass", "3t"});
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(contains(
      o.err,
      "--mass: is given with --to opensees; allowed: a target that writes a whole model: opensees-model, openseespy-model"))
      << o;
}

TEST_F(ExportedModel, vertical_stiffness_comes_from_the_compression_tests) {
  write("a.csv", csv(record({.samples = 121, .per_cycle = 40, .interval_s = 0.05})));
  write("b.csv", csv(record({.samples = 121, .per_cycle = 40, .strength_kN = 22.0, .interval_s = 0.05})));
  write(
      "two.toml",
      "[[device]]\nname = \"a\"\nfile = \"a.csv\"\nK_v = 1100.0\n[[device]]\nname = \"b\"\nfile = \"b.csv\"\nK_v = 1300.0\n");
  auto const o = isolaw({"calibrate", "two.toml", "--laws", "bilinear", "--runs", "1", "--analysis", "full",
                         "--replicates", "0", "--out", "C"});
  ASSERT_LE(o.code, 1) << o;
  auto const said = [&](std::string const& device, Words const& more = {}) {
    return isolaw(Words{"export", "C", "--law", "bilinear", "--device", device, "--to", "opensees-model", "--anyway",
                        "--layout", "layout.csv", "--ground-motion", "x.csv"} +
                  more)
        .out;
  };
  EXPECT_TRUE(contains(said("a"), "# Vertical springs: 1100 kN/mm, the campaign's compression test;"));
  EXPECT_TRUE(contains(said("lot"), "# Vertical springs: 1200 kN/mm, the mean of the campaign's 2 compression tests;"));
  EXPECT_TRUE(contains(said("a", {"--axial", "2MN/mm"}), "# Vertical springs: 2000 kN/mm, --axial;"));
  write("layout.csv", "x [m],y [m],load [kN],K_v [kN/mm]\n0,0,1600,700\n6,0,1600,800\n");
  EXPECT_TRUE(contains(said("a"), "# Vertical springs: 700 to 800 kN/mm, the layout;"));
}

// Users may give isolators and files any name. In the exported scripts no part of a name may act as a command.
TEST_F(ExportedModel, hostile_names_stay_names) {
  calibrate("bilinear");
  write("evil [exec touch HACKED].csv", "name,x [m],y [m]\n\"A\"\"; } [exec touch HACKED] $evil\",0,0\nB,6,0\n");
  for (auto const to : programs::targets_where(&programs::Target::needs_building)) {
    auto const o = exported("bilinear", std::string(to),
                            {"--layout", "evil [exec touch HACKED].csv", "--mass", "320t", "--axial", "900kN/mm",
                             "--ground-motion", "x.csv"});
    ASSERT_EQ(o.code, 0) << o;
    for (auto const* part : {"[exec", "$evil", "\"; }"}) EXPECT_FALSE(contains(o.out, part)) << part;
  }
}

}  // namespace
}  // namespace isolaw::cli_test
