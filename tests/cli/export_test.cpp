// Tests `isolaw export`: every law to every target, what is refused, and that an export needs nothing but the store.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <numbers>

#include "cli/models.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/programs/exports.hpp"

namespace isolaw::cli_test {
namespace {

// Returns three cycles at 100 mm, 60 samples a cycle, of a bilinear loop with a rounded corner.
std::string loops(double stiffness) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  double hysteretic = 0.0, before = 0.0;
  for (int i = 0; i <= 180; ++i) {
    double const x = 100.0 * std::sin(2.0 * std::numbers::pi * i / 60.0);
    hysteretic +=
        (1.0 - hysteretic / 20.0 * (x > before ? 1.0 : -1.0)) * 2.0 * (x - before) / (1.0 + std::abs(x - before) * 0.1);
    before = x;
    text +=
        fmt::format("{:.4f},{:.5f},{:.5f}\n", i / 30.0, x, stiffness * (0.4 * x + std::clamp(hysteretic, -20.0, 20.0)));
  }
  return text;
}

// Returns the last column of a CSV table, without comment lines and the header.
std::vector<double> last_column(std::string const& csv) {
  std::vector<double> values;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);)
    if (auto const at = line.rfind(','); !line.starts_with('#') && at + 1 < line.size() && !line.ends_with(']'))
      values.push_back(std::stod(line.substr(at + 1)));
  return values;
}

class Export : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", loops(1.0));
    write("b.csv", loops(1.1));
  }
  Outcome calibrate(std::string const& laws, Words const& more = {}) {
    return isolaw(Words{"calibrate", "a.csv", "b.csv", "--laws", laws, "--runs", "1", "--out", "C"} + more);
  }
  Outcome exported(std::string const& law, std::string const& device, std::string const& to, Words const& more = {}) {
    return isolaw(Words{"export", "C", "--law", law, "--device", device, "--to", to} + more);
  }
};

// Returns how exactly an export must represent the law in other programs. "re-fitted" means that the export fits the
// nearest material that those programs have. It does so if they have no material that follows the law, and also if the
// law's loading and unloading have different limit curves, which no material of theirs supports.
std::string expected_fidelity(laws::LawEntry const& law, Json const& exported) {
  std::vector<double> values;
  for (auto const& parameter : exported["parameters"]) values.push_back(parameter["value"]);
  auto const form = law.canonical(values);
  if (std::holds_alternative<laws::NoForm>(form) || std::holds_alternative<laws::LimitCurvesForm>(form))
    return "re-fitted";
  return std::holds_alternative<laws::BoucWenForm>(form) ? "exact as the step goes to zero" : "exact";
}

// If a device does not pass the rule set, or was refused, exports and simulate must warn of it on the terminal and in
// their output.
TEST_F(Export, and_simulate_say_that_the_rule_set_is_not_kept_and_who_was_refused) {
  write("c.csv", "time [s],disp [mm],force [kN]\n0,1,2\n1,1,2\n2,1,2\n");
  auto const calibration = isolaw(Words{"calibrate", "a.csv", "b.csv", "c.csv", "--laws", "bilinear", "--runs", "1",
                                        "--analysis", "full", "--out", "C"} +
                                  held_to("K_eff=5,damping=1,disp=100"));
  ASSERT_EQ(calibration.code, 1) << calibration;
  std::string const lot = "The lot does not keep its rule set: NTC 2018: 2 of 3 devices fail: a ";
  std::string const refused = "c was refused. The lot has 3 devices; its law is made from the others";
  auto const unwrapped = [](std::string const& text) {
    std::string words;
    for (char const c : text)
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '%') words += c;
    return words;
  };
  for (auto const& target : programs::targets()) {
    SCOPED_TRACE(target.name);
    auto const more = Words{"--anyway"} + needed_by(target, directory());
    auto const of_lot = exported("bilinear", "lot", std::string(target.name), more);
    EXPECT_TRUE(contains(of_lot.err, "warning: " + lot)) << of_lot.err;
    EXPECT_TRUE(contains(of_lot.err, "warning: " + refused)) << of_lot.err;
    EXPECT_TRUE(contains(unwrapped(of_lot.out), unwrapped("2 of 3 devices fail: a "))) << of_lot.out;
    EXPECT_TRUE(contains(unwrapped(of_lot.out), unwrapped("c was refused"))) << of_lot.out;
    auto const of_device = exported("bilinear", "a", std::string(target.name), more);
    EXPECT_TRUE(contains(of_device.err, "warning: a fails NTC 2018: ")) << of_device.err;
    EXPECT_FALSE(contains(of_device.err, refused)) << of_device.err;
    EXPECT_TRUE(contains(unwrapped(of_device.out), unwrapped("a fails NTC 2018"))) << of_device.out;
  }
  write("u.csv", "time [s],disp [mm]\n0,0\n0.5,10\n1,20\n1.5,30\n");
  auto const simulated =
      isolaw({"simulate", "bilinear", "--from", "C", "--device", "lot", "--motion", "u.csv", "--anyway"});
  for (auto const& text : {simulated.out, simulated.err}) {
    EXPECT_TRUE(contains(text, lot)) << simulated;
    EXPECT_TRUE(contains(text, refused)) << simulated;
  }
}

class ExportOfLaw : public Export, public ::testing::WithParamInterface<std::size_t> {};
TEST_P(ExportOfLaw, goes_to_every_target) {
  auto const& entry = laws::catalogue()[GetParam()];
  std::string const law(entry.info.id);
  ASSERT_EQ(calibrate(law).code, 0);
  for (auto const& target : programs::targets()) {
    std::string const to(target.name);
    SCOPED_TRACE(law + " " + to);
    auto const o = exported(law, "a", to, Words{"--anyway"} + needed_by(target, path(".")));
    ASSERT_EQ(o.code, 0) << o;
    // The search was short, so parameters may lie at bounds, and a re-fit may be far off the law. All messages must
    // be warnings or notes.
    std::istringstream said(o.err);
    bool refitted = false;
    for (std::string line; std::getline(said, line);) {
      bool const response = contains(line, " in its place, a building's peak displacement is off by ");
      EXPECT_TRUE(line.starts_with("warning: ") || line.starts_with("note: ")) << line;
      refitted = refitted || response;
    }
    EXPECT_EQ(refitted, contains(o.out, "In a building: with ") || contains(o.out, "| In a building | with ") ||
                            contains(o.out, "\"displacement_percent\""));
    EXPECT_TRUE(contains(o.out, law));
    EXPECT_TRUE(contains(o.out, to == "json" ? "\"tested\"" : "Displacement tested"));
    EXPECT_EQ(contains(o.out, "MIT-0"), to != "json");
    if (to == "json") {
      EXPECT_EQ(exported(law, "a", to).out, o.out);
      auto const j = Json::parse(o.out);
      auto const expected = expected_fidelity(entry, j);
      EXPECT_EQ(j["fidelity"], expected);
      EXPECT_EQ(j["substitute"].get<std::string>().empty(), expected != "re-fitted");
      EXPECT_EQ(j.contains("in_a_building"), expected == "re-fitted");
      for (auto const& form : j["forms"]) EXPECT_TRUE(form["from_law"]["largest_percent_of_peak"].is_number());
      // The two devices have the stiffness v and 1.1 v. The tolerance factor k of a sample of two is 36.52, so the mean
      // minus k standard deviations is negative, and there is no lower bound.
      EXPECT_NEAR(j["bounds"]["upper"]["force"].get<double>(), 1.05 + 36.519 * 0.1 / std::sqrt(2.0), 0.3);
      EXPECT_TRUE(j["bounds"]["lower"].is_null());
      EXPECT_NEAR(j["bounds"]["tolerance_k"].get<double>(), 36.519, 1e-3);
      EXPECT_EQ(j["bounds"]["coverage_percent"], 95);
      EXPECT_EQ(j["bounds"]["confidence_percent"], 95);
      EXPECT_TRUE(contains(o.out, "holds 95 % of the devices with confidence 95 % (too few devices for a lower bound"));
    }
    if (law == "vaiana" && to == "json") {
      EXPECT_TRUE(contains(o.out, "--set vaiana.Kb-=Kb+"));
    }
    if (to.starts_with("opensees")) {
      EXPECT_TRUE(contains(o.out, "Fidelity: "));
    }
    if (to == "csv" && entry.info.traits.rate_independent) {
      // The table is read again as a motion, and simulate must give the forces in it. Rate-dependent laws are left
      // out: they would need the table's velocities too.
      write("protocol.csv", exported(law, "a", to, {"--units", "kip-in"}).out);
      auto const again = isolaw(
          {"simulate", law, "--from", "C", "--device", "a", "--motion", "protocol.csv", "--turning-points", "sampled"});
      ASSERT_EQ(again.code, 0) << again;
      auto const expected = last_column(read("protocol.csv")), force = last_column(again.out);
      ASSERT_EQ(force.size(), expected.size());
      double const peak = std::ranges::max(expected) * 4.4482216152605;
      for (std::size_t i = 0; i < force.size(); ++i)
        ASSERT_NEAR(force[i], expected[i] * 4.4482216152605, 1e-6 * peak) << i;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Every, ExportOfLaw, ::testing::Range(std::size_t{0}, laws::catalogue().size()),
                         [](auto const& law) {
                           std::string name(laws::catalogue()[law.param].info.id);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// The dashpot is so strong that the largest force of a cycle is far above the force at the peaks of displacement. Every
// target must refuse such a law.
TEST_F(Export, refuses_a_law_whose_force_is_not_possible_within_the_tests) {
  ASSERT_EQ(isolaw({"calibrate", ISOLAW_SOURCE_DIR "/examples/published-lot/device-01.csv", "--laws",
                    "power-masing-viscous,bouc-wen", "--set", "power-masing-viscous.c=0.3", "--analysis", "none",
                    "--figures", "none", "--out", "C"})
                .code,
            0);
  for (auto const* target : {"opensees", "openseespy-law", "opensees-cpp", "abaqus", "cpp", "sheet", "csv", "json"}) {
    expect_refused(exported("power-masing-viscous", "device-01", target),
                   {"its force is not possible, even within the tests", "its largest force is", "--anyway"});
    auto const anyway = exported("power-masing-viscous", "device-01", target, {"--anyway"});
    EXPECT_TRUE(contains(anyway.err, "its force is not possible, even within the tests")) << anyway.err;
    EXPECT_TRUE(contains(anyway.out, "not possible")) << target;
  }
  EXPECT_EQ(exported("bouc-wen", "device-01", "cpp").code, 0);
}

TEST_F(Export, reads_the_store_alone_and_writes_files) {
  ASSERT_EQ(calibrate("bilinear").code, 0);
  auto const before = exported("bilinear", "b", "opensees", {"--units", "N-m"});
  ASSERT_EQ(before.code, 0) << before;
  EXPECT_TRUE(contains(before.out, "Units of this file: N, m, s"));
  EXPECT_TRUE(contains(before.out, "Displacement tested: up to 0.1 m")) << before;
  EXPECT_TRUE(contains(before.out, " over this one's 6.6e+05;")) << before;
  fs::create_directory(path("elsewhere"));
  fs::rename(path("C/campaign.sqlite"), path("elsewhere/campaign.sqlite"));
  fs::remove(path("b.csv"));
  auto const o = isolaw({"export", "elsewhere", "--law", "bilinear", "--device", "b", "--to", "opensees", "--units",
                         "N-m", "--out", "b.tcl"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(o.out.empty());
  EXPECT_TRUE(contains(o.err, "b.tcl"));
  EXPECT_EQ(read("b.tcl"), before.out);
}

// A record without time has samples but no seconds, so the export must name samples.
TEST_F(Export, of_a_record_without_time_counts_samples) {
  std::string without;
  std::istringstream lines(loops(1.0));
  for (std::string line; std::getline(lines, line);) without += line.substr(line.find(',') + 1) + "\n";
  write("untimed.csv", without);
  ASSERT_EQ(isolaw({"calibrate", "untimed.csv", "--laws", "abe", "--runs", "1", "--out", "C"}).code, 0);
  auto const script = exported("abe", "untimed", "opensees");
  ASSERT_EQ(script.code, 0) << script;
  EXPECT_TRUE(contains(script.out, "of the peak force (at sample ")) << script.out;
  auto const form = Json::parse(exported("abe", "untimed", "json").out)["forms"][0];
  EXPECT_TRUE(form["from_law"]["at_s"].is_null());
  EXPECT_GT(form["from_law"]["at_sample"], 1);
  EXPECT_LE(form["from_law"]["at_sample"], 181);
}

TEST_F(Export, of_the_lot_needs_its_one_law) {
  ASSERT_EQ(calibrate("bilinear", {"--analysis", "full", "--replicates", "0"}).code, 0);
  auto const o = exported("bilinear", "lot", "json");
  ASSERT_EQ(o.code, 0) << o;
  auto const j = Json::parse(o.out);
  EXPECT_EQ(j["of_the_lot"], true);
  // The two devices differ by 10 %. K2 of the law of the lot must lie between the values of the two devices. The factor
  // on its force must be above 1 for the upper bound.
  auto const K2_of = [&](std::string const& device) {
    return Json::parse(exported("bilinear", device, "json").out)["parameters"][1]["value"].get<double>();
  };
  double const K2 = j["parameters"][1]["value"];
  EXPECT_GT(K2, std::min(K2_of("a"), K2_of("b")));
  EXPECT_LT(K2, std::max(K2_of("a"), K2_of("b")));
  EXPECT_GT(j["bounds"]["upper"]["force"], 1.0);
}

// Reads the factor lambda of a property such as "K_d" and a source such as "contract band" from the column `name` of
// tables/lambda.csv.
double lambda_of(std::string const& table, std::string const& property, std::string const& source,
                 std::string const& name) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  auto const cells = [](std::string const& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string cell; std::getline(stream, cell, ',');) parts.push_back(cell);
    return parts;
  };
  auto const names = cells(line);
  auto const at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  while (std::getline(lines, line)) {
    auto const row = cells(line);
    if (row[0] == property && row[2] == source) return std::stod(row.at(at));
  }
  throw std::runtime_error("no " + property + " of " + source);
}

TEST_F(Export, takes_bounds_from_the_rule_set) {
  ASSERT_EQ(calibrate("bilinear", {"--rules", "asce-7-22"}).code, 0);
  auto const of = [&](std::string const& device, Words const& more = {}) {
    auto const o = exported("bilinear", device, "json", more);
    EXPECT_EQ(o.code, 0) << o;
    return Json::parse(o.out)["bounds"];
  };
  auto const a = of("a"), b = of("b");
  EXPECT_TRUE(contains(a["source"].get<std::string>(), "asce-7-22 (not verified)"));
  EXPECT_TRUE(a["tolerance_k"].is_null()) << "a band of the contract is not estimated from the devices";
  EXPECT_EQ(a["upper"]["separate"], true);
  auto const table = read("C/tables/lambda.csv");
  for (auto const& [key, property] : {std::pair{"stiffness", "K_d"}, {"strength", "Q_d"}})
    for (auto const& [side, column] : {std::pair{"lower", "lambda min"}, {"upper", "lambda max"}}) {
      // A bound is lambda times the mean of the lot. The devices have the values v and 1.1 v, and their mean is 1.05 v.
      // So the factors on their own values are 1.05 lambda and 1.05 / 1.1 lambda.
      double const lambda = lambda_of(table, property, "contract band", column);
      EXPECT_NEAR(a[side][key].get<double>(), 1.05 * lambda, 0.002 * lambda) << property << " " << side;
      EXPECT_NEAR(b[side][key].get<double>(), 1.05 / 1.1 * lambda, 0.002 * lambda) << property << " " << side;
    }
  // The factor on the force is a weighted mean of the factors on stiffness and strength, so it lies between them.
  EXPECT_GE(a["upper"]["force"], std::min(a["upper"]["stiffness"], a["upper"]["strength"]));
  EXPECT_LE(a["upper"]["force"], std::max(a["upper"]["stiffness"], a["upper"]["strength"]));
  // --rules in the export command applies to this export only and not to the campaign.
  EXPECT_TRUE(contains(of("a", {"--rules", "aashto"})["source"].get<std::string>(), "aashto"));
  EXPECT_EQ(of("a"), a);
}

// If the loading and unloading branches of a vaiana law differ, its export is not exact and lists the ties between
// parameters that would make it exact. This campaign sets these ties, so its export must be exact.
TEST_F(Export, of_vaiana_with_equal_branches_is_exact) {
  Words ties;
  for (std::string const name : {"Kb", "f0", "alpha", "beta1", "beta2"})
    ties = ties + Words{"--set", "vaiana." + name + "-=" + name + "+"};
  ASSERT_EQ(calibrate("vaiana", ties).code, 0);
  auto const hardening = Json::parse(exported("vaiana", "a", "json").out);
  EXPECT_EQ(hardening["fidelity"], "exact") << hardening["explanation"] << hardening["refused"];
  EXPECT_LT(hardening["forms"][0]["from_law"]["largest_percent_of_peak"], 1e-7);
  // OpenSees needs two commands for a law that hardens, HystereticAsym and Multiplier. For a law that softens it needs
  // four: HystereticAsym twice, Multiplier and Parallel.
  double beta1 = 0.0;
  for (auto const& parameter : hardening["parameters"])
    if (parameter["name"] == "beta1+") beta1 = parameter["value"];
  EXPECT_EQ(hardening["forms"][0]["nominal"].size(), beta1 < 0.0 ? 4U : 2U);
}

TEST_F(Export, says_what_there_is_when_asked_wrongly) {
  ASSERT_EQ(calibrate("bilinear,bouc-wen").code, 0);
  expect_refused(exported("linear", "a", "opensees"), {"linear", "no such law", "bilinear", "bouc-wen"});
  expect_refused(exported("abe", "a", "opensees"), {"law abe", "not in this campaign", "bilinear, bouc-wen"});
  expect_refused(exported("bilinear", "c", "opensees"), {"'c'", "not in this campaign", "allowed: a, b"});
  expect_refused(exported("bilinear", "lot", "opensees"), {"the lot", "no analysis was made", "--analysis full"});
  expect_refused(exported("bilinear", "a", "sap"), {"--to", "sap", "opensees, openseespy, "});
  expect_refused(exported("bilinear", "a", "json", {"--units", "MN-m"}), {"--units", "MN-m", "kN-mm, N-m, kip-in"});
  expect_refused(
      exported("bilinear", "a", "cpp", {"--motion", "m.AT2"}),
      {"--motion", "is given with --to cpp, which writes the law itself", "a target that may re-fit the law"});
  expect_refused(exported("bilinear", "a", "json", {"--motion", "none.AT2"}), {"none.AT2"});
  write("ground.csv", ground_motion());
  auto const unused = exported("bilinear", "a", "opensees", {"--motion", "ground.csv"});
  EXPECT_TRUE(contains(unused.err, "warning: --motion is not used: the file has the law itself")) << unused;
  // A file that states neither step nor unit is read with those of the options, as `isolaw building` reads it too.
  std::string column;
  std::istringstream rows(ground_motion());
  for (std::string row; std::getline(rows, row);)
    if (auto const comma = row.find(','); std::isdigit(row.front()) != 0) column += row.substr(comma + 1) + "\n";
  write("one.txt", column);
  expect_refused(exported("bilinear", "a", "opensees", {"--motion", "one.txt"}),
                 {"one.txt", "try: --motion-dt SECONDS and --motion-unit UNIT"});
  Words const stated{"--motion-dt", "0.01", "--motion-unit", "m/s2"};
  EXPECT_EQ(exported("bilinear", "a", "opensees", Words{"--motion", "one.txt"} + stated).code, 0);
  expect_refused(exported("bilinear", "a", "opensees", stated), {"--motion-dt: is given alone"});
  expect_refused(exported("bilinear", "a", "opensees", {"--motion", "ground.csv,ground.csv"}),
                 {"--motion", "two components", "along one"});
  expect_refused(exported("bilinear", "a", "json", {"--out", "none/such.json"}),
                 {"none/such.json", "cannot be written"});
  expect_refused(isolaw({"export", "nothing", "--law", "bilinear", "--device", "a", "--to", "json"}), {"nothing"});
  expect_refused(isolaw({"export", "C", "--device", "a", "--to", "json"}), {"--law"});
}

TEST_F(Export, of_a_law_without_result_says_why) {
  // jankowski depends on velocity, so it has no result for a record without time.
  auto text = loops(1.0);
  std::string without_time = "disp [mm],force [kN]\n";
  std::istringstream lines(text.substr(text.find('\n') + 1));
  for (std::string line; std::getline(lines, line);) without_time += line.substr(line.find(',') + 1) + "\n";
  write("t.csv", without_time);
  isolaw({"calibrate", "t.csv", "--laws", "bilinear,jankowski", "--runs", "1", "--out", "C"});
  expect_refused(exported("jankowski", "t", "cpp"), {"law jankowski, device 't'", "no result", "time"});
  auto const o = exported("bilinear", "t", "json");
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(Json::parse(o.out)["tested"]["highest_frequency_Hz"].is_null());
  EXPECT_TRUE(contains(exported("bilinear", "t", "opensees").out, "Frequency tested: not stated"));
}

TEST_F(Export, of_devices_with_hostile_names_stays_a_comment) {
  write("lot.toml",
        "title = 'T [exec rm] \\'\n[[device]]\nname = 'x\"\"\"; } {$a`b` [exec touch HACKED] \\'\nfile = 'a.csv'\n");
  auto const calibration = isolaw({"calibrate", "lot.toml", "--laws", "bilinear", "--runs", "1", "--out", "C"});
  ASSERT_EQ(calibration.code, 0) << calibration;
  for (auto const& target : programs::targets()) {
    std::string const to(target.name);
    if (to == "json" || to == "sheet") continue;
    auto const o = exported("bilinear", "x\"\"\"; } {$a`b` [exec touch HACKED] \\", to, needed_by(target, path(".")));
    ASSERT_EQ(o.code, 0) << o;
    std::istringstream lines(o.out);
    bool const is_cpp = to == "cpp" || to == "opensees-cpp" || to == "abaqus";
    for (std::string line; std::getline(lines, line);) {
      // No comment may end with a backslash, which would continue it on the next line. In C++, lines of a macro may end
      // with one.
      if (!is_cpp || line.starts_with("//")) {
        EXPECT_FALSE(line.ends_with("\\")) << line;
      }
      if (line.find("exec touch") == std::string::npos) continue;
      EXPECT_TRUE(line.starts_with(is_cpp ? "// " : "# ")) << line;
      EXPECT_EQ(line.find_first_of("[]{}$`\"\\"), std::string::npos) << line;
    }
  }
  // JSON quotes the name, so it may stay as it is.
  EXPECT_EQ(Json::parse(exported("bilinear", "x\"\"\"; } {$a`b` [exec touch HACKED] \\", "json").out)["device"],
            "x\"\"\"; } {$a`b` [exec touch HACKED] \\");
}

TEST_F(Export, keeps_devices_of_alike_names_apart) {
  write("lot.toml", "[[device]]\nname = 'P 1'\nfile = 'a.csv'\n[[device]]\nname = 'P-1'\nfile = 'b.csv'\n");
  ASSERT_EQ(isolaw({"calibrate", "lot.toml", "--laws", "bouc-wen", "--runs", "1", "--out", "C"}).code, 0);
  // The title of the lot is its folder's name.
  EXPECT_TRUE(contains(exported("bouc-wen", "P 1", "cpp").out, "_P_1_1_kN_mm {"));
  EXPECT_TRUE(contains(exported("bouc-wen", "P-1", "cpp").out, "_P_1_2_kN_mm {"));
  EXPECT_TRUE(contains(exported("bouc-wen", "P-1", "cpp", {"--units", "N-m"}).out, "_P_1_2_N_m {"));
  for (auto const* to : {"cpp", "abaqus", "opensees-cpp"})
    EXPECT_TRUE(contains(exported("bouc-wen", "P 1", to, {"--name", "pier_7"}).out, "namespace pier_7 {")) << to;
  EXPECT_TRUE(contains(exported("bouc-wen", "P 1", "opensees", {"--anyway", "--name", "pier_7"}).out, "eval pier_7 {"));
  auto const wrong = exported("bouc-wen", "P 1", "cpp", {"--name", "pier 7"});
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_TRUE(contains(wrong.err, "--name: pier 7; allowed: a letter, then letters, digits and single _ between them"))
      << wrong;
  EXPECT_TRUE(contains(exported("bouc-wen", "P 1", "csv", {"--name", "a"}).err, "--name: is given with --to csv"));
}

}  // namespace
}  // namespace isolaw::cli_test
