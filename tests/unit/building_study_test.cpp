// Tests a study of a building: the file that describes the study, the random draws of the bearings, the runs, and the
// answers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/api/building_work.hpp"
#include "isolaw/building/answers.hpp"
#include "isolaw/building/arrangement.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/building/linear_oscillator.hpp"
#include "isolaw/building/plausibility.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/online/online.hpp"
#include "isolaw/num/random.hpp"
#include "isolaw/render/figures/building_figures.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "refusal.hpp"
#include "unit/building_study_fixture.hpp"

namespace isolaw::building {
namespace {

namespace fs = std::filesystem;

class BuildingFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("isolaw-building-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    motion("motion-1-x.csv", 20);
    motion("motion-1-y.csv", 20);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void motion(std::string const& name, int samples, std::string const& last = "0.1") const {
    std::ofstream out(folder_ / name);
    out << "time [s],acceleration [m/s2]\n";
    for (int i = 0; i < samples; ++i) out << 0.01 * i << ',' << (i + 1 < samples ? "0.5" : last) << '\n';
  }
  BuildingFile read(std::string const& text) const { return read_building_text(text, "b.toml", folder_); }
  // Returns the error message for the template of building files after one of its lines has been replaced.
  std::string refused(std::string const& line, std::string const& instead) const {
    auto text = building_template();
    auto const at = text.find(line);
    EXPECT_NE(at, std::string::npos) << line;
    text.replace(at, line.size(), instead);
    return refusal_of([&] { read(text); });
  }

  fs::path folder_;
};

TEST_F(BuildingFileTest, the_template_is_a_building) {
  auto const description = read(building_template());
  EXPECT_EQ(description.frame.floors.size(), 5u);
  EXPECT_EQ(description.bearings.size(), 28u);
  EXPECT_EQ(description.motions.size(), 1u);
  EXPECT_EQ(description.motions[0].y_mm_s2.size(), 20u);
  EXPECT_NEAR(description.motions[0].x_mm_s2[3], 250.0, 1e-9);
  Structure const structure(description.frame);
  EXPECT_NEAR(2.0 * std::numbers::pi / structure.frequency_rad_s()[0], 0.5, 1e-9);
  auto const file = (folder_ / "motion-1-x.csv").string();
  auto const given = read_building_text(building_template(), "b.toml", folder_, {.motions = read_motions({file})});
  EXPECT_TRUE(given.motions.at(0).y_mm_s2.empty());
  EXPECT_TRUE(contains(refusal_of([&] { read_motions({file, "none.csv", "no.AT2"}); }), "no.AT2"));
}

TEST_F(BuildingFileTest, what_is_wrong_is_said_once_with_its_line) {
  auto const mass = refused("mass_Mg = 700.0", "mass_Mg = -700.0");
  EXPECT_TRUE(contains(mass, "b.toml:") && contains(mass, "mass_Mg") && contains(mass, "-700") &&
              contains(mass, "a number above 0"))
      << mass;
  EXPECT_TRUE(contains(refused("draws = 500", "draws = -1"), "draws: -1")) << refused("draws = 500", "draws = -1");
  auto const outside = refused("along = 7", "along = 9");
  EXPECT_TRUE(contains(outside, "stands outside the plan") && contains(outside, "-20 to 20 m along x")) << outside;
  EXPECT_TRUE(contains(refused("[grid]", "[gird]"), "gird"));
  EXPECT_TRUE(contains(refused("lower = 0.9", ""), "[building] has no lower"));
  auto const laws = refused("laws = []", "laws = [\"bilinaer\"]");
  EXPECT_TRUE(contains(laws, "bilinaer") && contains(laws, "bilinear")) << laws;

  motion("motion-1-y.csv", 19);
  auto const notes =
      read(building_template()).motions.front().notes;  // the missing last sample of y is replaced by zero
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes.front().kind, FindingKind::ground_padded);
  motion("motion-1-y.csv", 20, "NaN");
  auto const nan = refusal_of([&] { read(building_template()); });
  EXPECT_TRUE(contains(nan, "motion-1-y.csv:21") && contains(nan, "no number")) << nan;
}

// Values that the caller passes replace those of the file and are checked in the same way. A Python mapping is read
// like a file, but error messages about it name no lines.
TEST_F(BuildingFileTest, what_is_given_is_laid_over_and_a_mapping_is_a_file) {
  Motion const motion{.name = "m", .step_s = 0.01, .x_mm_s2 = {0.0, 1.0}, .y_mm_s2 = {}};
  auto const read_with = [&](isolaw::Values settings, Motion const& shaken) {
    return read_building_text(building_template(), "b.toml", folder_,
                              {.motions = {shaken}, .settings = std::move(settings)});
  };
  auto const description = read_with({{"draws", 7}, {"laws", Json::array({"bilinear"})}}, motion);
  EXPECT_EQ(description.settings.draws, 7);
  EXPECT_EQ(description.settings.laws, std::vector<std::string>{"bilinear"});
  EXPECT_EQ(description.motions.at(0).x_mm_s2, motion.x_mm_s2);
  EXPECT_EQ(description.bearings.size(), 28u);
  auto const wrong = refusal_of([&] { read_with({{"draws", -1}, {"colour", 1}}, motion); });
  EXPECT_TRUE(contains(wrong, "b.toml: draws: -1") && contains(wrong, "unknown key 'colour'")) << wrong;
  auto nan = motion;
  nan.x_mm_s2[1] = std::nan("");
  EXPECT_TRUE(contains(refusal_of([&] { read_with({}, nan); }), "motion 'm': sample 2 is no number"));
  auto const tables = Json::parse(R"({"building": {"lower": 0.9, "upper": 1.1}, "base": {"mass_Mg": 1, "gyration_m": 2},
      "bearing": [{"x_m": -1, "y_m": 0}, {"x_m": 1, "y_m": 0, "is": "lot"}]})");
  auto const of_tables = building_of(tables, {.motions = {motion}, .settings = {}});
  EXPECT_EQ(of_tables.bearings.at(1).kind, BearingKind::lot);
  EXPECT_EQ(of_tables.bearings.at(1).at.x_mm, 1000.0);
  auto lacks = tables;
  lacks.erase("base");
  lacks["bearing"][0]["x_m"] = "left";
  auto const said = refusal_of([&] { building_of(lacks, {.motions = {motion}, .settings = {}}); });
  EXPECT_TRUE(contains(said, "building: no [base]") && contains(said, "left")) << said;
}

// Returns parameters of a bearing of usual size, in the units of the law.
Values usual_parameters(laws::LawEntry const& law) {
  double const length = law.info.length.in_record_units, force = law.info.force.in_record_units;
  laws::RecordScales const scales{100.0 / length, 100.0 / force,  1.0 * length / force,
                                  30.0 / force,   200.0 / length, 3e4 / length / force};
  Values values;
  for (auto const& p : law.parameters) {
    auto const box = p.scaled(scales);
    values.push_back(p.fixed_by_default.value_or(0.6 * box.lower + 0.4 * box.upper));
  }
  return values;
}

TEST(BuildingFile, takes_the_design_conditions_in_place_of_a_factor) {
  auto tables =
      Json::parse(R"({"building": {"lower": "conditions", "upper": 1.1}, "base": {"mass_Mg": 1, "gyration_m": 2},
      "bearing": [{"x_m": -1, "y_m": 0}, {"x_m": 1, "y_m": 0}]})");
  auto const read = [&] { return building_of(tables, {.motions = {synthetic_motion(5, 0, {})}, .settings = {}}); };
  auto const settings = read().settings;
  EXPECT_FALSE(settings.lower);
  EXPECT_EQ(settings.upper, whole(1.1));
  // A store of runs writes this setting as the word "conditions". Reading the word must give an empty `lower` again.
  for (auto const& key : settings_table()) {
    if (key.key != "lower") continue;
    FileTables from{.building = settings}, to;
    key.set(to, value_of(key.kind, {text_of(key.get(from))}));
    EXPECT_FALSE(to.building.lower);
  }
  tables["building"]["lower"] = "state";
  EXPECT_TRUE(contains(refusal_of(read), "0.05 to 1, a table of elastic and hysteretic, or \"conditions\""))
      << refusal_of(read);
}

TEST(BuildingFile, takes_a_factor_for_each_part_of_the_force) {
  std::string const rest =
      "[base]\nmass_Mg = 1\ngyration_m = 2\n[[bearing]]\nx_m = -1\ny_m = 0\n[[bearing]]\nx_m = 1\ny_m = 0\n";
  auto const read = [&](std::string const& lower) {
    return read_building_text("[building]\nupper = 1.1\nlower = " + lower + "\n" + rest, "b.toml", {},
                              {.motions = {synthetic_motion(5, 0, {})}, .settings = {}})
        .settings;
  };
  auto const settings = read("{ elastic = 0.9, hysteretic = 0.7 }");
  EXPECT_EQ(settings.lower, (PartFactors{.elastic = 0.9, .hysteretic = 0.7}));
  EXPECT_EQ(settings.upper, whole(1.1));
  for (auto const& key : settings_table()) {  // a store of runs reads back what it wrote
    if (key.key != "lower") continue;
    FileTables from{.building = settings}, to;
    key.set(to, value_of(key.kind, {text_of(key.get(from))}));
    EXPECT_EQ(to.building.lower, settings.lower);
  }
  auto const refused = [&](std::string const& lower) { return refusal_of([&] { read(lower); }); };
  EXPECT_TRUE(contains(refused("{ elastic = 0.9 }"), "lower has no factor on the hysteretic part"));
  EXPECT_TRUE(contains(refused("{ elastic = 0.9, friction = 1 }"), "elastic and hysteretic"));
  EXPECT_TRUE(contains(refused("{ elastic = 1.2, hysteretic = 1.1 }"), "both factors of lower are above 1"));
  EXPECT_TRUE(contains(refused("{ elastic = 0.01, hysteretic = 1 }"), "0.05 to 20"));
  EXPECT_TRUE(contains(refused("1.2"), "0.05 to 1"));
}

// In a bilinear law K2 is the elastic part and K1 - K2 the stiffness of the hysteretic part.
TEST(BuildingStudy, bound_laws_take_the_place_of_a_factor) {
  auto study = usual_study(0.0, 0);
  PartFactors const factors{.elastic = 0.7, .hysteretic = 0.6};
  study.file.settings.lower.reset();
  study.laws[0].lower = factors;
  Devices const devices(study.laws[0], study.file, study.file.motions[0]);
  study.file.settings.lower = factors;  // the file may also state these factors
  EXPECT_EQ(Devices(study.laws[0], study.file, study.file.motions[0]).parameters_of({.kind = CaseKind::lower}),
            devices.parameters_of({.kind = CaseKind::lower}));
  auto const nominal = devices.parameters_of({}), lower = devices.parameters_of({.kind = CaseKind::lower}),
             upper = devices.parameters_of({.kind = CaseKind::upper});
  for (std::size_t i = 0; i < nominal.size(); i += 3) {
    EXPECT_NEAR(lower[i + 1], 0.7 * nominal[i + 1], 1e-12);
    EXPECT_NEAR(lower[i] - lower[i + 1], 0.6 * (nominal[i] - nominal[i + 1]), 1e-12);
    EXPECT_EQ(lower[i + 2], nominal[i + 2]);
    EXPECT_NEAR(upper[i], 1.1 * nominal[i], 1e-12);
  }
}

TEST(BuildingStudy, without_scatter_a_draw_is_the_nominal_run) {
  auto const study = usual_study(0.0, 3);
  Devices const devices(study.laws[0], study.file, study.file.motions[0]);
  EXPECT_EQ(devices.parameters_of({.kind = CaseKind::draw, .draw = 2}), devices.parameters_of({}));
}

TEST(BuildingStudy, a_draw_depends_on_its_number_alone) {
  auto const few = usual_study(0.07, 3), many = usual_study(0.07, 300);
  Devices const a(few.laws[0], few.file, few.file.motions[0]), b(many.laws[0], many.file, many.file.motions[0]);
  Case const second{.kind = CaseKind::draw, .draw = 1};
  EXPECT_EQ(a.parameters_of(second), b.parameters_of(second));
  EXPECT_NE(a.parameters_of(second), a.parameters_of({.kind = CaseKind::draw, .draw = 2}));
  auto const values = a.parameters_of(second);
  EXPECT_NE(values[0], values[3]);  // each bearing has parameters of its own
  EXPECT_EQ(values[2], values[5]);  // xy does not scatter in this population, so all bearings share its value
}

// Returns a study of bearings with power-masing, which has no two-dimensional form. The first number of `law` scales
// the force.
Study power_masing_study(Values const& law) {
  auto study = usual_study(0.0, 3);
  study.laws = {{.law = "power-masing",
                 .lot = law,
                 .devices = {},
                 .population = {},
                 .place = std::vector<std::optional<std::size_t>>(law.size()),
                 .median = law,
                 .limits = {},
                 .tested_mm = 0.0,
                 .springs = {}}};
  for (auto& bearing : study.file.bearings) bearing.kind = BearingKind::lot;
  return study;
}

// power-masing has no two-dimensional form, and its tangent is undefined at zero along a direction without motion.
// Under motion along x alone, the bearing must follow the one-dimensional law.
TEST(BuildingStudy, under_motions_along_x_a_law_is_itself) {
  Values const law{60.0, 0.6, 10.0, 0.0, 20.0, 0.05};
  auto study = power_masing_study(law);
  EXPECT_EQ(Devices(study.laws[0], study.file, study.file.motions[0]).coupling(), Coupling::springs);
  for (auto& motion : study.file.motions) motion.y_mm_s2.clear();
  ASSERT_EQ(Devices(study.laws[0], study.file, study.file.motions[0]).coupling(), Coupling::separate);
  auto const run = nominal_run(study, study.laws[0], study.file.motions[0]);
  ASSERT_EQ(run.outcome, Outcome::completed) << run.stop_reason;
  laws::Online online("power-masing", law);
  double most = 0.0, off = 0.0;
  for (std::size_t i = 0; i < run.history.time_s.size(); ++i) {
    auto const force = 6.0 * online.trial(run.history.base[i][0], run.history.velocity[i][0]).force;
    online.commit();
    most = std::max(most, std::abs(force));
    off = std::max(off, std::abs(force - run.history.shear_kN[i][0]));
    ASSERT_LT(std::abs(run.history.base[i][1]), 1e-6);
  }
  EXPECT_GT(run.value(Measure::isolator), 10.0);
  // The law `online` of this test starts at zero displacement. The bearing of the study starts its law only after the
  // first small displacement, so the forces differ slightly.
  EXPECT_LT(off, 1e-3 * most);
  auto const csv = history_csv(run, study.file.motions[0]);
  EXPECT_EQ(
      csv.find("time [s],base_x [mm],velocity_x [mm/s],force_x [kN],acceleration_base_x [mm/s2],acceleration_1_x"), 0u);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), run.history.time_s.size() + 1);
}

// The response to a motion along x alone must not change if the study also has a motion with two components.
TEST(BuildingStudy, a_motion_gives_the_same_response_alone_and_beside_others) {
  auto beside = power_masing_study({60.0, 0.6, 10.0, 0.0, 20.0, 0.05});
  beside.laws[0].springs = beside.laws;
  beside.laws[0].springs[0].lot[0] = beside.laws[0].springs[0].median[0] = 66.0;
  beside.file.motions.resize(2);
  beside.file.motions[0].y_mm_s2.clear();
  auto alone = beside;
  alone.file.motions.resize(1);
  Runs const runs_alone(alone), runs_beside(beside);
  auto const first = [](Runs const& runs, std::size_t motion) {
    return runs.compute({.law = 0, .motion = motion, .from = 0, .to = 1}).front().measured;
  };
  EXPECT_EQ(first(runs_alone, 0), first(runs_beside, 0));
  EXPECT_EQ(Devices(beside.laws[0], beside.file, beside.file.motions[0]).parameters_of({})[0], 60.0);
  EXPECT_EQ(Devices(beside.laws[0], beside.file, beside.file.motions[1]).parameters_of({})[0], 66.0);
}

// With this mass the integration would need such short steps that a run would never end.
TEST(BuildingStudy, steps_without_number_are_refused_with_their_cause) {
  auto study = usual_study(0.0, 3);
  study.file.frame.base.mass_Mg = 1e-6;
  EXPECT_TRUE(contains(refusal_of([&] { Runs{study}; }), "the base has a mass of 1e-06 t"))
      << refusal_of([&] { Runs{study}; });
  study = usual_study(0.0, 3);
  study.file.frame.base.gyration_mm = 1e-6;
  EXPECT_TRUE(contains(refusal_of([&] { Runs{study}; }), "a radius of gyration of 1e-06 mm"));
}

TEST(BuildingStudy, refuses_bearings_that_nothing_stands_for) {
  auto study = usual_study(0.07, 3);
  auto const said = [&] { return refusal_of([&] { Devices(study.laws[0], study.file, study.file.motions[0]); }); };
  study.file.bearings[0] = {.at = {}, .kind = BearingKind::device, .device = "D07"};
  EXPECT_TRUE(contains(said(), "no device 'D07'"));
  study.file.bearings[0] = {};
  study.laws[0].population = {};
  EXPECT_TRUE(contains(said(), "no population") && contains(said(), "--analysis full")) << said();
}

class BuildingRuns : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() /
            ("isolaw-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".sqlite");
    fs::remove(file_);
  }
  void TearDown() override { fs::remove(file_); }
  std::string json(Study const& study, std::size_t threads, bool interrupted = false) const {
    fs::remove(file_);
    if (interrupted) {
      RunStore store(file_, properties_of(study), false);
      EXPECT_THROW(
          run_all(study, store, threads, {.progress = [](RunProgress const&) { throw std::runtime_error("stop"); }}),
          std::runtime_error);
      EXPECT_GT(store.runs_there(), 0u);
    }
    RunStore store(file_, properties_of(study), false);
    run_all(study, store, threads);
    return render::building_json(study, answer(study, store));
  }
  fs::path file_;
};

TEST_F(BuildingRuns, same_bytes_for_any_threads_and_after_an_interruption) {
  auto const study = usual_study(0.07, 250, 3);
  auto const one = json(study, 1);
  EXPECT_EQ(json(study, 2), one);
  EXPECT_EQ(json(study, 3), one);
  EXPECT_EQ(json(study, 2, true), one);
  auto other = study;
  other.file.settings.seed = 2;
  auto const refused = refusal_of([&] { RunStore(file_, properties_of(other), false); });
  EXPECT_TRUE(contains(refused, "the runs of another building") && contains(refused, "seed: 1 there, 2 now") &&
              contains(refused, "--fresh"))
      << refused;
  RunStore const fresh(file_, properties_of(other), true);
  EXPECT_EQ(fresh.runs_there(), 0u);
}

TEST_F(BuildingRuns, answers) {
  auto const study = usual_study(0.07, 120, 4);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  auto const& law = answers.laws.at(0);
  EXPECT_EQ(law.failed, 0u);
  EXPECT_LT(law.worst_balance, 2e-3);
  auto const& isolator = law.distributions[0];
  EXPECT_LT(isolator.fractiles[0], isolator.fractiles[1]);
  EXPECT_NEAR(isolator.fractiles[1] / isolator.nominal, 1.0, 0.1);
  // Each bearing's force scatters by 7 %. The sum of six forces scatters by 7 % / sqrt(6), and torsion adds to this.
  EXPECT_GT(isolator.lot_std_ln, 0.001);
  EXPECT_LT(isolator.lot_std_ln, 0.07);
  EXPECT_GT(isolator.motion_std_ln, 0.0);
  EXPECT_TRUE(isolator.uncertain_std_ln.has_value());
  // The lower bound has weaker bearings, which transmit less base shear.
  EXPECT_LT(law.distributions[6].lower, law.distributions[6].upper);
  for (auto const& coverage : law.coverage) {
    EXPECT_NEAR(coverage.share_inside + coverage.share_below + coverage.share_above, 1.0, 1e-12);
    EXPECT_LE(coverage.interval_low, coverage.share_inside);
    EXPECT_GE(coverage.interval_high, coverage.share_inside);
  }
  for (auto const& checked : law.checked) {
    EXPECT_EQ(checked.outcome, "completed");
    EXPECT_LT(std::abs(checked.balance.value()), 1e-3);
    EXPECT_LT(std::abs(checked.draws_error_percent.value()), 0.5);
    EXPECT_GT(checked.equivalent_mm, 0.0);
  }
  EXPECT_TRUE(contains(answers.about_bounds, ": with Bilinear the bounds cover ") &&
              contains(answers.about_bounds, "of 120 buildings"))
      << answers.about_bounds;
  auto const motions = std::ranges::find(answers.warnings, FindingKind::motions_too_few, &Finding::kind);
  ASSERT_NE(motions, answers.warnings.end());
  EXPECT_EQ(motions->number("motions"), 2.0);
  EXPECT_TRUE(contains(*motions, "2 motions: codes accept the mean over 7 motions or more")) << text_of(*motions);
  if (law.coverage[0].share_inside < wanted_share)
    EXPECT_EQ(answers.bounds_are_enough, false);
  else
    EXPECT_EQ(answers.bounds_are_enough.has_value(), law.coverage[0].interval_low >= wanted_share);
  std::uint64_t drawn = 0;
  for (auto const count : isolator.histogram.counts) drawn += count;
  EXPECT_EQ(drawn, 120u);
  // The stored history contains the measured maximum, unless a peak lies between its points.
  ASSERT_EQ(law.histories.size(), 2u);
  for (std::size_t m = 0; m < 2; ++m) {
    auto const& history = law.histories[m];
    EXPECT_LE(history.x_mm.size(), most_of_history);
    EXPECT_NEAR(history.step_s * static_cast<double>(history.x_mm.size()), 6.5, 0.1);
    double most = 0.0;
    for (std::size_t i = 0; i < history.x_mm.size(); ++i)
      most = std::max(most, std::hypot(history.x_mm[i], history.y_mm[i]));
    EXPECT_NEAR(most, law.distributions[1].nominal_by_motion[m], 0.02 * most);
  }
  // The stored loops are those of the first draw under the stronger motion. Each bearing has its own force.
  auto const& loops = law.loops;
  EXPECT_TRUE(loops.drawn);
  auto const strongest = static_cast<std::size_t>(law.checked[1].isolator_mm > law.checked[0].isolator_mm);
  EXPECT_EQ(loops.motion, strongest);
  ASSERT_EQ(loops.force_x_kN.size(), 6u);
  EXPECT_LE(loops.x_mm.size(), most_of_loops);
  EXPECT_GT(loops.x_mm.size(), most_of_loops / 2);
  EXPECT_NE(loops.force_x_kN[0], loops.force_x_kN[1]);
  for (auto const* forces : {&loops.force_x_kN, &loops.force_y_kN})
    for (auto const& force : *forces) EXPECT_EQ(force.size(), loops.x_mm.size());
  // At the shortest period the floor spectrum is close to the floor's peak acceleration. At some longer period the
  // roof's spectrum is higher.
  ASSERT_EQ(law.floor_spectra_g.size(), 4u);
  EXPECT_EQ(law.floor_spectra_g[0].size(), spectrum_periods_s().size());
  EXPECT_NEAR(law.floor_spectra_g[0].front() / law.distributions[7].nominal, 1.0, 0.25);
  EXPECT_GT(std::ranges::max(law.floor_spectra_g[3]), law.floor_spectra_g[3].front());
  // The largest displacement of a bearing, as a mean over draws and motions, is at most the 95 % fractile of the
  // largest displacement of any bearing. The bearings' shares of the energy add up to 1.
  double share = 0.0;
  for (std::size_t b = 0; b < 6; ++b) {
    EXPECT_GT(law.bearing_mm[b], 0.0);
    EXPECT_LE(law.bearing_mm[b], isolator.fractiles[3]);
    share += law.bearing_energy_share[b];
  }
  EXPECT_NEAR(share, 1.0, 1e-9);
}

TEST_F(BuildingRuns, without_draws_bounds_have_nothing_to_cover) {
  auto study = usual_study(0.07, 3);
  for (auto& bearing : study.file.bearings) bearing.kind = BearingKind::lot;
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  EXPECT_TRUE(contains(answers.about_bounds, "No bearing is drawn")) << answers.about_bounds;
  EXPECT_FALSE(answers.bounds_are_enough.has_value());
  auto const json = Json::parse(render::building_json(study, answers));
  auto const& law = json["laws"][0];
  EXPECT_TRUE(json["draws"].is_null() && law["draws"].is_null() && law["coverage"].is_null()) << law["coverage"];
  auto const& moves = law["quantities"]["isolator_mm"];
  EXPECT_TRUE(moves["p50"].is_null() && moves["lot_std_ln"].is_null() && moves["histogram"].is_null()) << moves;
  EXPECT_TRUE(moves["nominal"].is_number() && law["bearings"]["displacement_mm"][0].is_number());
  EXPECT_TRUE(render::building_figures(answers, record_units).empty());
}

// All three buildings lie within the bounds, but three draws cannot show that 95 % of all buildings do. The study must
// say that there is no answer yet.
TEST_F(BuildingRuns, a_few_draws_do_not_show_that_bounds_are_enough) {
  auto study = usual_study(0.001, 3);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  EXPECT_EQ(answers.laws.front().coverage.front().share_inside, 1.0);
  EXPECT_FALSE(answers.bounds_are_enough.has_value());
  EXPECT_TRUE(contains(answers.about_bounds, "No answer yet: with Bilinear the bounds cover 100 % of 3 buildings"))
      << answers.about_bounds;
  EXPECT_TRUE(says(answers.warnings,
                   "3 draws are too few to tell whether 95 % of buildings lie between the bounds: no answer yet; 72 "
                   "suffice if the share between them stays as it is (`draws` of the building file, with --fresh)."))
      << answers.warnings;
}

// The second law is twice as stiff, so the bounds computed with the first law do not cover the draws of the second. The
// study must answer that the bounds are not enough.
TEST_F(BuildingRuns, bounds_of_one_law_are_held_to_the_others) {
  auto study = usual_study(0.001, 80);
  auto other = study.laws.front();
  for (double& stiffness : other.population.medians) stiffness *= 2.0;
  for (double& logarithm : other.population.mean) logarithm += std::log(2.0);
  study.laws.push_back(other);
  study.file.settings.laws.push_back(other.law);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  ASSERT_TRUE(answers.laws[1].by_first_bounds.has_value());
  EXPECT_LT(*answers.laws[1].by_first_bounds, wanted_share) << answers.about_bounds;
  EXPECT_EQ(answers.bounds_are_enough, false);
  ASSERT_EQ(answers.about_bounds.size(), 3u) << answers.about_bounds;
  // The sentence with the answer "No" names the law whose draws lie outside. The next sentence says that the bounds
  // cover the draws of the first law itself.
  EXPECT_EQ(wording::sentence(answers.about_bounds[0]),
            "No: with Bilinear the bounds of Bilinear cover 0 % of 80 buildings.");
  EXPECT_TRUE(wording::sentence(answers.about_bounds[1]).starts_with("With Bilinear the bounds cover 100 % of 80 "))
      << answers.about_bounds;
  EXPECT_EQ(wording::sentence(answers.about_bounds[2]),
            "The choice of the law matters more than the scatter of the lot.");
  // The answer says which factors on the nominal properties would give bounds that cover 95 % of the draws. The draws
  // hardly scatter, so these factors differ from 1 by at most 2 %, the step of the search, and are no basis for design.
  EXPECT_EQ(answers.about_bounds[1].word("factors"), "near");
  EXPECT_TRUE(contains(answers.about_bounds[1], "; factors within 2 % of 1, the step of the search, would cover 95 %."))
      << answers.about_bounds;
}

// The same law is listed twice, so the first listing's bounds must cover the same share of draws of both listings.
TEST_F(BuildingRuns, bounds_of_one_law_cover_as_much_of_the_same_law) {
  auto study = usual_study(0.07, 40);
  study.file.settings.lower = whole(0.98);
  study.file.settings.upper = whole(1.02);
  study.laws.push_back(study.laws.front());
  study.file.settings.laws.push_back(study.laws.front().law);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  auto const inside = answers.laws[0].coverage.front().share_inside;
  EXPECT_TRUE(inside > 0.0 && inside < 1.0) << inside;
  EXPECT_EQ(answers.laws[1].by_first_bounds, inside);
}

TEST(BuildingAnswers, factors_are_said_where_they_mean_something) {
  Coverage c{.quantity = "isolator_mm", .factor_low = 0.94, .factor_high = 1.06};
  EXPECT_EQ(text_of(covering_factors(c)), "factors of 0.94 and 1.06 would cover 95 %");
  c.factor_low = 0.98, c.factor_high = 1.02;
  EXPECT_EQ(text_of(covering_factors(c)), "factors within 2 % of 1, the step of the search, would cover 95 %");
  c.factor_low.reset();
  EXPECT_EQ(text_of(covering_factors(c)), "no factors up to 0.60 and 1.40 would cover 95 %");
}

// Both bound analyses give less displacement than the nominal building, so no factors can make the bounds cover the
// draws. The answer must say so.
TEST_F(BuildingRuns, bounds_on_one_side_of_the_nominal_building_are_told) {
  auto const study = usual_study(0.001, 40);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  // Replace the results of the two bound analyses by a tenth of them.
  auto const other = file_.string() + "-2";
  RunStore changed(other, properties_of(study), true);
  for (std::size_t motion = 0; motion < 2; ++motion) {
    std::vector<RunStore::Row> rows;
    store.for_each_run(0, motion, [&](std::size_t place, std::vector<double> const& measured) {
      rows.push_back({0, motion, place, measured});
      if (place == 1 || place == 2)
        for (double& value : rows.back().measured) value *= 0.1;
    });
    changed.add(rows);
  }
  auto const answers = answer(study, changed);
  fs::remove(other);
  auto const& coverage = answers.laws[0].coverage[0];
  EXPECT_EQ(coverage.share_inside, 0.0);
  ASSERT_TRUE(coverage.monotony.has_value());
  EXPECT_EQ(coverage.monotony->kind, FindingKind::bounds_not_monotonic);
  EXPECT_EQ(coverage.monotony->number("nominal"), answers.laws[0].distributions[0].nominal);
  EXPECT_EQ(coverage.monotony->word("side"), "below");
  EXPECT_TRUE(coverage.not_monotonic.starts_with("both bound analyses (")) << coverage.not_monotonic;
  EXPECT_TRUE(contains(answers.about_bounds, "since the nominal building itself is outside them"))
      << answers.about_bounds;
  EXPECT_TRUE(contains(
      answers.warnings,
      "Bilinear: the share of 0 % of the draws between the bounds says nothing about bearing displacement, because both bound analyses ("))
      << answers.warnings;
}

// The law gave no numbers in most draws. These draws count as outside, and the answer itself must say that the law is
// the cause. Numbers that could be computed only from the few other draws are left out.
TEST_F(BuildingRuns, a_law_without_numbers_is_told_in_the_answer) {
  auto study = usual_study(0.01, 80);
  study.file.limits.bearing_mm = 1e4;
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  CasePlaces const places(study.file.settings);
  auto const with_failed = [&](std::size_t draws, bool nominal) {
    auto const other = file_.string() + "-2";
    fs::remove(other);
    RunStore changed(other, properties_of(study), true);
    for (std::size_t motion = 0; motion < 2; ++motion) {
      std::vector<RunStore::Row> rows;
      store.for_each_run(0, motion, [&](std::size_t place, std::vector<double> const& measured) {
        rows.push_back({0, motion, place, measured});
        bool const fails =
            (motion == 1 && place >= places.first_draw && place < places.first_draw + draws) || (nominal && place == 0);
        if (fails) std::ranges::fill(rows.back().measured, std::nan(""));
      });
      changed.add(rows);
    }
    auto answers = answer(study, changed);
    fs::remove(other);
    return answers;
  };
  auto const most = with_failed(60, false);
  EXPECT_EQ(most.holds, false);
  ASSERT_GT(most.verdict.size(), 1u);
  EXPECT_EQ(
      wording::sentence(most.verdict[1]),
      "Bilinear gave no finite numbers in 60 of 80 draws: these count as outside of every limit and of the bounds. "
      "This is a failure of the law in the model; it does not show that the building would fail.");
  EXPECT_TRUE(contains(most.about_bounds, "60 of these have no finite numbers and count as outside"))
      << most.about_bounds;
  auto const json = Json::parse(render::building_json(study, most));
  auto const& moves = json["laws"][0]["quantities"]["isolator_mm"];
  for (auto const* key : {"p50", "p84", "p95", "motion_std_ln", "lot_std_ln", "lot_share"})
    EXPECT_TRUE(moves[key].is_null()) << key;
  EXPECT_TRUE(moves["p16"].is_number());  // 20 of 80 draws have numbers, and the others count as larger
  EXPECT_TRUE(json["laws"][0]["bearings"]["displacement_mm"][0].is_null());
  EXPECT_EQ(json["laws"][0]["limits"][0]["broken_by"], "draws");
  EXPECT_FALSE(contains(wording::paragraph(most.verdict), "nan"));
  // The page shows the loops of the nominal building, since the first draw has no numbers under the motion that is
  // shown.
  EXPECT_EQ(most.laws[0].loops.motion, 1u);
  EXPECT_FALSE(most.laws[0].loops.drawn);

  auto const few = with_failed(2, false);
  EXPECT_TRUE(
      Json::parse(render::building_json(study, few))["laws"][0]["quantities"]["isolator_mm"]["lot_std_ln"].is_number());

  auto const nominal = with_failed(60, true);
  EXPECT_TRUE(contains(nominal.verdict, "gave no finite numbers in the nominal building, and in 60 of 80 draws:"));
  EXPECT_EQ(nominal.laws[0].limit_checks[0].broken_by, "nominal failed");
  EXPECT_FALSE(contains(wording::paragraph(nominal.verdict), "nan"));
}

// Without the analyses of a study, limits are judged by the nominal building alone, and the answer says so.
TEST(BuildingAnswers, a_nominal_building_alone_is_judged_too) {
  auto study = usual_study(0.07, 3);
  std::vector<std::vector<double>> runs;
  for (auto const& motion : study.file.motions) runs.push_back(nominal_run(study, study.laws[0], motion).measured);
  study.file.limits.bearing_mm = 1e4;
  auto const holds = answer_of_nominal(study, {runs});
  EXPECT_EQ(holds.holds, true);
  EXPECT_EQ(wording::paragraph(holds.verdict),
            "Yes: with Bilinear the building keeps every limit that is set; this is the nominal building alone, and "
            "neither the bound analyses nor the scatter of the lot were looked at.");
  study.file.limits.floor_acceleration_g = 1e-3;
  EXPECT_EQ(answer_of_nominal(study, {runs}).holds, false);
  runs[1].clear();
  study.file.limits.floor_acceleration_g.reset();
  EXPECT_EQ(answer_of_nominal(study, {runs}).laws[0].limit_checks[0].broken_by, "nominal failed");
}

// The force of this law differs between positive and negative displacements. Springs around a circle cannot follow
// this.
TEST(BuildingStudy, a_law_of_unequal_sides_acts_once_along_each_axis_and_is_told) {
  auto study = usual_study(0.0, 3);
  auto const& vaiana = laws::find_law("vaiana");
  auto const values = usual_parameters(vaiana);
  study.laws = {{.law = "vaiana",
                 .lot = values,
                 .devices = {},
                 .population = {},
                 .place = std::vector<std::optional<std::size_t>>(values.size()),
                 .median = values,
                 .limits = {},
                 .tested_mm = 0.0,
                 .springs = {}}};
  for (auto& bearing : study.file.bearings) bearing.kind = BearingKind::lot;
  ASSERT_FALSE(study.file.motions[0].y_mm_s2.empty());
  EXPECT_EQ(coupling_under(study.file.motions[0], study.laws[0]), Coupling::separate);
  auto const doubts = study_doubts(study);
  EXPECT_TRUE(contains(doubts, "its force differs between its two directions: it acts once along each axis")) << doubts;
  EXPECT_FALSE(contains(study_doubts(power_masing_study({60.0, 0.6, 10.0, 0.0, 20.0, 0.05})), "two directions:"));
}

// The campaign has findings that cast doubt on the calibration. A finding that holds for two laws is printed once. A
// finding about a tested device names the device once.
TEST_F(BuildingRuns, says_what_is_known_against_a_law) {
  auto study = usual_study(0.07, 4);
  Finding const open{.kind = FindingKind::not_determined,
                     .law = "bilinear",
                     .devices = {"device-01", "device-02"},
                     .parameters = {"Dy"},
                     .numbers = {{"affected", 2.0}, {"examined", 3.0}}};
  Finding const apart{.kind = FindingKind::outlier,
                      .devices = {"device-01"},
                      .numbers = {{"value", 0.81}, {"median", 0.62}, {"percent", 30.6}},
                      .words = {{"property", "effective stiffness"}, {"unit", "kN/mm"}}};
  study.laws[0].doubts = {open, apart};
  study.laws.push_back(study.laws[0]);
  study.laws[1].doubts = {apart};
  study.file.settings.laws.push_back(study.laws[1].law);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  EXPECT_EQ(answers.laws[0].doubts, study.laws[0].doubts);
  EXPECT_EQ(answers.calibration, study.laws[0].doubts);
  std::string const of_device =
      "device-01 is an outlier in its lot: effective stiffness 0.81 kN/mm (+31 % from the median).";
  auto const warnings = render::building_warnings(answers);
  EXPECT_EQ(std::ranges::count(warnings, "From the calibration: " + of_device), 1);
  EXPECT_EQ(std::ranges::count(warnings, "From the calibration: Bilinear: the tests cannot fix Dy (2 of 3 devices)."),
            1);
  for (auto const& warning : warnings) EXPECT_FALSE(contains(warning, "device-01: device-01")) << warning;
  auto const json = Json::parse(render::building_json(study, answers));
  EXPECT_EQ(json["laws"][1]["doubts"], Json::array({of_device}));
  ASSERT_EQ(json["calibration"].size(), 2u);
  EXPECT_EQ(json["calibration"][0]["kind"], "not-determined");
  EXPECT_EQ(json["calibration"][1]["kind"], "outlier");
  EXPECT_EQ(json["calibration"][1]["devices"], Json::array({"device-01"}));
  auto other = study;
  for (auto& law : other.laws) law.doubts.clear();
  EXPECT_EQ(properties_of(other), properties_of(study));
}

// A study with springs, whose runs are computed one by one, reports progress after each run. If it is interrupted, the
// finished runs are kept.
TEST_F(BuildingRuns, of_springs_are_told_one_by_one_and_can_be_interrupted) {
  auto study = power_masing_study({60.0, 0.6, 10.0, 0.0, 20.0, 0.05});
  study.laws[0].springs = study.laws;
  study.file.motions.resize(1);
  study.file.motions[0].x_mm_s2.resize(60);
  study.file.motions[0].y_mm_s2.resize(60);
  study.file.settings.rest_s = 0.0;
  std::size_t told = 0, asked = 0;
  {
    RunStore store(file_, properties_of(study), false);
    // isolaw asks several times during each run whether to stop. The fourth question after the third run comes within
    // the fourth run.
    EXPECT_FALSE(run_all(study, store, 1,
                         {.progress = [&](RunProgress const& p) { told = p.done; },
                          .part = {},
                          .interrupted = [&] { return told >= 3 && ++asked >= 4; }}));
    EXPECT_EQ(told, 3u);
    EXPECT_EQ(store.runs_there(), 3u);
    EXPECT_TRUE(run_all(study, store, 2));
  }
  RunStore const store(file_, properties_of(study), false);
  auto const answers = answer(study, store);
  EXPECT_EQ(form(answers.laws[0]), "springs");
}

// Eight runs are computed at a time, one in each lane. If the user interrupts the study, the runs of a block that are
// finished are kept and not computed again.
TEST_F(BuildingRuns, the_first_lanes_of_a_block_outlive_an_interruption) {
  auto study = usual_study(0.07, 30);
  study.file.motions.resize(1);
  std::size_t told = 0;
  RunStore store(file_, properties_of(study), false);
  EXPECT_FALSE(run_all(study, store, 1,
                       {.progress = [&](RunProgress const& p) { told = p.done; },
                        .part = {},
                        .interrupted = [&] { return told >= lane_width; }}));
  EXPECT_EQ(store.runs_there(), lane_width);
  std::size_t before = 0;
  EXPECT_TRUE(run_all(study, store, 1, {.progress = [&](RunProgress const& p) { before = before ? before : p.done; }}));
  EXPECT_EQ(before, 2 * lane_width);
}

// A limit is judged by the nominal building, the two bound analyses and the draws. As in building codes, the mean over
// the motions is judged if there are seven or more, and the largest response if there are fewer.
TEST(BuildingAnswers, a_limit_is_judged_by_nominal_building_bounds_and_draws) {
  Settings settings{.draws = 100, .populations = 0, .lower = whole(0.9), .upper = whole(1.1)};
  CasePlaces const places(settings);
  auto const responses = [&](std::size_t motions, double nominal, double bound, std::size_t beyond, double last = 1.0) {
    Responses made;
    std::vector<double> values(places.cases.size(), 80.0);
    values[0] = nominal, values[1] = bound;
    for (std::size_t i = 0; i < beyond; ++i) values[places.first_draw + i] = 120.0;
    made.by_motion.assign(motions, values);
    for (double& value : made.by_motion.back()) value *= last;
    made.mean = values;
    return made;
  };
  auto const at_100 = [&](Responses const& made, bool has_draws = true) {
    return check_limit("bearing_mm", "isolator_mm", 100.0, made, &places, has_draws);
  };
  auto const sure = at_100(responses(7, 80.0, 90.0, 0));
  EXPECT_EQ(sure.limit_kept, LimitKept::yes);
  EXPECT_EQ(sure.share_kept, 1.0);
  EXPECT_EQ(sure.bound, 90.0);
  EXPECT_EQ(sure.p95, 80.0);
  EXPECT_EQ(at_100(responses(7, 101.0, 90.0, 0)).limit_kept, LimitKept::no);
  EXPECT_EQ(at_100(responses(7, 101.0, 90.0, 0)).broken_by, "nominal");
  EXPECT_EQ(at_100(responses(7, 80.0, 101.0, 0)).limit_kept, LimitKept::no);
  EXPECT_EQ(at_100(responses(7, 80.0, 101.0, 0)).broken_by, "bounds");  // although every draw keeps the limit
  EXPECT_EQ(at_100(responses(7, 80.0, 101.0, 0)).share_kept, 1.0);
  EXPECT_EQ(at_100(responses(7, std::nan(""), 90.0, 0)).broken_by, "nominal failed");
  // If one of the two bound analyses gave no numbers, this must not be hidden by the numbers of the other.
  auto const without_bound = at_100(responses(7, 80.0, std::nan(""), 0));
  EXPECT_EQ(without_bound.broken_by, "bounds failed");
  EXPECT_TRUE(std::isnan(*without_bound.bound));
  Responses alone{.by_motion = std::vector<std::vector<double>>(7, {80.0}), .mean = {80.0}};
  auto const nominal = check_limit("bearing_mm", "isolator_mm", 100.0, alone);
  EXPECT_TRUE(nominal.limit_kept == LimitKept::yes && !nominal.bound && !nominal.p95);
  EXPECT_EQ(at_100(responses(7, 80.0, 101.0, 0), false).limit_kept, LimitKept::no);
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 50), false).limit_kept, LimitKept::yes);  // no draws are judged
  // 96 of 100 draws keep the limit. The true share may then be 90 to 99 %, so it is open whether it reaches 95 %.
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 4)).limit_kept, LimitKept::open);
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 4)).draws_wanted, draws_that_tell(96, 100));
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 6)).limit_kept, LimitKept::no);
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 6)).broken_by, "draws");
  // With seven motions the mean counts, which this test leaves at 80. With six the largest response counts, here 104.
  EXPECT_EQ(at_100(responses(7, 80.0, 90.0, 0, 1.3)).limit_kept, LimitKept::yes);
  EXPECT_EQ(at_100(responses(6, 80.0, 90.0, 0, 1.3)).limit_kept, LimitKept::no);
  auto collapsed = responses(7, 80.0, 90.0, 0);
  for (std::size_t i = 0; i < 6; ++i) collapsed.mean[places.first_draw + i] = std::nan("");
  EXPECT_EQ(at_100(collapsed).limit_kept, LimitKept::no);
  EXPECT_EQ(at_100(collapsed).share_kept, 0.94);
}

// Limits are compared with results in the store. If only the limits of an answered study change, nothing is integrated
// again: an integration would ask whether it is interrupted, and this test would then throw.
TEST_F(BuildingRuns, are_judged_by_other_limits_without_integrating) {
  auto study = usual_study(0.07, 8);
  RunStore const store(file_, properties_of(study), false);
  {
    RunStore runs(file_, properties_of(study), false);
    run_all(study, runs, 1);
  }
  auto const first = answer(study, store);
  study.file.limits.bearing_mm = 1.0;
  auto const judged = answer(study, store, [] { return true; });
  EXPECT_EQ(judged.holds, false);
  study.file.limits.bearing_mm.reset();
  EXPECT_EQ(render::building_json(study, answer(study, store)), render::building_json(study, first));
  fs::remove(file_);
  RunStore anew(file_, properties_of(study), false);
  run_all(study, anew, 1);
  EXPECT_THROW(answer(study, anew, [] { return true; }), InterruptedRun);
}

TEST_F(BuildingRuns, say_first_whether_the_building_holds) {
  auto study = usual_study(0.07, 100);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const said = [&] { return wording::paragraph(answer(study, store).verdict); };
  EXPECT_TRUE(said().starts_with("The building file sets no limits")) << said();
  EXPECT_FALSE(answer(study, store).holds);
  auto const nominal = answer(study, store).laws[0].distributions[0].nominal;
  study.file.limits.bearing_mm = 10.0 * nominal;
  study.file.limits.floor_acceleration_g = 1e-3;
  EXPECT_EQ(answer(study, store).holds, false);  // the runs in the store do not depend on the limits
  EXPECT_TRUE(said().starts_with("No: with Bilinear the building does not keep its limit on floor acceleration."))
      << said();
  study.file.limits.floor_acceleration_g = 100.0;
  study.laws[0].tested_mm = 0.5 * nominal;
  EXPECT_FALSE(answer(study, store).holds);
  EXPECT_TRUE(contains(said(), "keeps every limit that is set, but its bearings move further than they were tested"));
  study.laws[0].tested_mm = 10.0 * nominal;
  EXPECT_EQ(answer(study, store).holds, true) << said();
  for (auto& bearing : study.file.bearings) bearing.kind = BearingKind::lot;
  auto const json = Json::parse(render::building_json(study, answer(study, store)));
  EXPECT_EQ(json["holds"], true);
  EXPECT_EQ(json["answer"][0]["sentence"], "Yes: with Bilinear the building keeps every limit that is set.");
  EXPECT_EQ(json["laws"][0]["limits"][2]["limit"], "tested_mm");
  EXPECT_TRUE(json["laws"][0]["limits"][0]["p95"].is_null());
}

// The expected digits of the Clopper-Pearson interval are from R's binom.test; its formula is in Brown, Cai and
// DasGupta 2001.
TEST(BuildingAnswers, binomial_interval) {
  auto const interval = binomial_interval(95, 100);
  EXPECT_NEAR(interval[0], 0.8871651, 1e-6);
  EXPECT_NEAR(interval[1], 0.9835681, 1e-6);
  EXPECT_EQ(binomial_interval(20, 20)[1], 1.0);
  EXPECT_NEAR(binomial_interval(20, 20)[0], std::pow(0.025, 1.0 / 20.0), 1e-9);
  // If all of n draws are inside, the interval's lower end is 0.025^(1/n). It reaches 0.95 with n = 72 draws.
  EXPECT_EQ(draws_that_tell(20, 20), 72u);
  EXPECT_EQ(draws_that_tell(3, 3), 72u);
  EXPECT_EQ(draws_that_tell(95, 100), std::nullopt);
  auto const many = *draws_that_tell(98, 100);  // checked at multiples of 50 draws, of which exactly 98 % can be inside
  EXPECT_GE(binomial_interval((many + 49) / 50 * 49, (many + 49) / 50 * 50)[0], wanted_share);
  EXPECT_LT(binomial_interval(many / 50 * 49 - 49, many / 50 * 50 - 50)[0], wanted_share);
}

// Beyond the yield point the stiffness of these bearings is negative, so no linear oscillator is equivalent to them.
TEST(BuildingAnswers, no_linear_oscillator_is_equivalent_to_bearings_without_stiffness) {
  auto study = usual_study(0.0, 3);
  auto& law = study.laws[0];
  law.lot = law.median = {6.0, -4.0, 1.0};
  for (auto& bearing : study.file.bearings) bearing.kind = BearingKind::lot;
  Devices const devices(law, study.file, study.file.motions[0]);
  EXPECT_FALSE(equivalent_linear(devices, study.file.motions[0], devices.parameters_of({}), 0.1).has_value());
}

// For a closed loop of a bilinear device K is K2 + Qd / D, and the damping is 4 Qd (D - Dy) / (2 pi K D^2).
TEST(BuildingAnswers, effective_stiffness_and_damping) {
  double const K1 = 6.0, K2 = 0.9, Qd = 30.0, Dy = Qd / (K1 - K2), D = 150.0;
  auto const properties = effective("bilinear", Values{K1, K2, Dy}, D, 1.0, Coupling::coupled);
  EXPECT_NEAR(properties.stiffness_kN_mm, K2 + Qd / D, 1e-12);
  EXPECT_NEAR(properties.damping, 4.0 * Qd * (D - Dy) / (2.0 * std::numbers::pi * (K2 + Qd / D) * D * D), 2e-3);
}

TEST(BuildingAnswers, histograms_hold_every_value) {
  auto const bins = histogram({1.0, 2.0, 2.5, 4.0, 5.0, 3.0, 1.5, 5.0});
  EXPECT_EQ(bins.counts.size(), 4u);
  EXPECT_EQ(bins.counts, (std::vector<std::uint64_t>{2, 2, 1, 3}));
  EXPECT_EQ(bins.from, 1.0);
  EXPECT_EQ(bins.width, 1.0);
  auto const same = histogram(Values(7, 3.0));
  EXPECT_EQ(same.counts, std::vector<std::uint64_t>{7});
  EXPECT_LT(same.from, 3.0);
  EXPECT_GT(same.from + same.width, 3.0);
  EXPECT_TRUE(histogram({}).counts.empty());
}

TEST(BuildingAnswers, arrangement) {
  auto const places = grid(4, 2, 5000.0).bearings;
  Values const stiffness{1.00, 1.02, 1.05, 1.10, 0.93, 0.97, 1.01, 0.90};
  auto const arrangement = arrange(places, {}, stiffness);
  EXPECT_LT(arrangement.eccentricity_mm, 0.1 * arrangement.in_order_mm);
  auto sorted = arrangement.device;
  std::ranges::sort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
}

// The result is compared with the best of all orders of the devices, which this test tries one by one.
TEST(BuildingAnswers, an_arrangement_of_few_devices_is_the_best_one) {
  num::Draws draws(num::Stream(7), 0, 0);
  for (int count = 3; count <= 7; ++count) {
    std::vector<Point> places;
    Values stiffness;
    for (int i = 0; i < count; ++i) {
      places.push_back({10'000.0 * draws.uniform(), 8'000.0 * draws.uniform()});
      stiffness.push_back(0.8 + 0.4 * draws.uniform());
    }
    Point const centre{5'000.0, 4'000.0};
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double least = 1e9;
    do {
      double k = 0.0, x = 0.0, y = 0.0;
      for (std::size_t i = 0; i < order.size(); ++i) {
        double const one = stiffness[order[i]];
        k += one, x += one * (places[i].x_mm - centre.x_mm), y += one * (places[i].y_mm - centre.y_mm);
      }
      least = std::min(least, std::hypot(x, y) / k);
    } while (std::ranges::next_permutation(order).found);
    EXPECT_NEAR(arrange(places, centre, stiffness).eccentricity_mm, least, 1e-9 * least) << count;
  }
}

// With many devices not every order can be tried. The search from many starts must still find an arrangement whose
// centre of stiffness is within 1 mm of the wanted place.
TEST(BuildingAnswers, an_arrangement_of_many_devices_is_near_the_best_one) {
  auto const places = grid(5, 4, 5000.0).bearings;
  num::Draws draws(num::Stream(8), 0, 0);
  Values stiffness;
  for (std::size_t i = 0; i < places.size(); ++i) stiffness.push_back(0.8 + 0.4 * draws.uniform());
  EXPECT_LT(arrange(places, {}, stiffness).eccentricity_mm, 1.0);
}

// Beyond its yield displacement this law pushes the building away, and no analysis with it reaches the end of the
// motion. A study of this law alone must be refused. A study that also has a sound law must answer for the sound law.
TEST_F(BuildingRuns, without_any_result_are_refused_and_another_law_is_answered) {
  auto failing = usual_study(0.07, 3);
  failing.file.motions.resize(1);
  for (auto& bearing : failing.file.bearings) bearing.kind = BearingKind::lot;
  failing.laws[0].lot = {6.0, -1e5, 10.0};
  auto const said = refusal_of([&] { study_building(failing, {.jobs = 1}); });
  EXPECT_TRUE(contains(said, "law bilinear: none of its ")) << said;

  auto both = usual_study(0.07, 3);
  both.file.motions.resize(1);
  both.laws.push_back(both.laws.front());
  both.laws[0].lot = {6.0, -1e5, 10.0};
  both.laws[0].median = both.laws[0].lot;
  both.laws[0].place = {std::nullopt, std::nullopt, std::nullopt};
  RunStore store(file_, properties_of(both), false);
  run_all(both, store, 1);
  auto const answers = answer(both, store);
  EXPECT_FALSE(has_result(answers.laws[0]));
  EXPECT_TRUE(has_result(answers.laws[1]));
  EXPECT_TRUE(contains(answers.about_bounds, "with Bilinear the bounds cover")) << answers.about_bounds;
  EXPECT_FALSE(answers.laws[1].by_first_bounds.has_value());
  for (auto const& figure : render::building_figures(answers, record_units))
    EXPECT_FALSE(contains(figure.script, "nan")) << figure.script;
}

// Draws whose softening law pushes the building away have no finite numbers. They count as outside of the bounds.
TEST_F(BuildingRuns, draws_that_collapse_are_outside_of_the_bounds) {
  auto study = usual_study(0.001, 40);
  study.file.motions.resize(1);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const sound = answer(study, store);
  EXPECT_EQ(sound.laws[0].collapsed, 0u);
  EXPECT_EQ(sound.laws[0].coverage.front().share_inside, 1.0);
  RunStore broken(file_.string() + "-2", properties_of(study), true);
  CasePlaces const places(study.file.settings);
  std::vector<RunStore::Row> rows;
  store.for_each_run(0, 0, [&](std::size_t place, std::vector<double> measured) {
    if (place >= places.first_draw && place < places.first_draw + 10) measured[0] = std::nan("");
    rows.push_back({.law = 0, .motion = 0, .place = place, .measured = measured});
  });
  broken.add(rows);
  auto const answers = answer(study, broken);
  EXPECT_EQ(answers.laws[0].collapsed, 10u);
  EXPECT_NEAR(answers.laws[0].coverage.front().share_inside, 0.75, 1e-12);
  EXPECT_EQ(answers.bounds_are_enough, false);
  EXPECT_EQ(std::ranges::count(answers.warnings, FindingKind::draws_collapsed, &Finding::kind), 1);
}

// If a bit of a stored run is changed, both the computation of answers and check_runs() must find it.
TEST_F(BuildingRuns, with_other_numbers_than_were_computed_are_found_out) {
  auto study = usual_study(0.001, 3);
  study.file.motions.resize(1);
  {
    RunStore store(file_, properties_of(study), false);
    run_all(study, store, 1);
  }
  auto const sound = check_runs(file_);
  EXPECT_EQ(sound.runs, sound.expected);
  EXPECT_TRUE(sound.faults.empty());
  campaign::sqlite::Connection::to_write(file_).execute(
      "UPDATE runs SET measured = substr(measured, 1, 7) || x'41' || substr(measured, 9) WHERE place = 2");
  EXPECT_EQ(check_runs(file_).faults,
            (std::vector<std::string>{"run 3 of law 1 under motion 1 has other numbers than when it was computed"}));
  RunStore const store(file_, properties_of(study), false);
  EXPECT_TRUE(contains(refusal_of([&] { answer(study, store); }), "has other numbers than when it was computed"));
}

// For every law, effective() is compared with the stiffness and damping of the third of three cycles. Their force is
// computed as for a record, at ten times as many points as effective() uses. If a law depends on velocity, faster
// cycles must have another damping.
TEST(BuildingAnswers, effective_properties_of_every_law_are_those_of_its_cycle_at_that_speed) {
  constexpr std::size_t steps = 2000, cycles = 3;
  constexpr double amplitude = 80.0;
  for (auto const& law : laws::catalogue()) {
    auto const values = usual_parameters(law);
    double const length = law.info.length.in_record_units, in_kN = law.info.force.in_record_units;
    Values damping;
    for (double const period_s : {2.0, 0.2}) {
      SCOPED_TRACE(fmt::format("{} in cycles of {} s", law.info.id, period_s));
      Values x, v;
      for (std::size_t i = 0; i <= steps * cycles; ++i) {
        double const angle = 2.0 * std::numbers::pi * static_cast<double>(i) / steps;
        x.push_back(amplitude / length * std::sin(angle));
        v.push_back(amplitude / length * 2.0 * std::numbers::pi / period_s * std::cos(angle));
      }
      auto const path = laws::make_path(x, v);
      Values force(path.samples());
      law.evaluate(values, path, laws::Integration::converged, force);
      constexpr std::size_t last = steps * (cycles - 1);
      double const k = in_kN * (force[last + steps / 4] - force[last + 3 * steps / 4]) / (2.0 * amplitude);
      double energy = 0.0;
      for (std::size_t i = last; i < steps * cycles; ++i)
        energy += 0.5 * in_kN * length * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
      damping.push_back(energy / (2.0 * std::numbers::pi * k * amplitude * amplitude));
      std::vector<Coupling> forms{Coupling::separate};
      if (coupling_of(law.info.id, values) == Coupling::coupled) forms.push_back(Coupling::coupled);
      for (auto const form : forms) {
        auto const found = effective(law.info.id, values, amplitude, period_s, form);
        // effective() takes 200 steps for a cycle and straight lines between them, which limits the agreement.
        EXPECT_NEAR(found.stiffness_kN_mm, k, 5e-3 * std::abs(k)) << name(form);
        EXPECT_NEAR(found.damping, damping.back(), 5e-3 * std::abs(damping.back()) + 1e-4) << name(form);
      }
    }
    EXPECT_EQ(std::abs(damping[1] - damping[0]) < 1e-9, law.info.traits.rate_independent) << law.info.id;
  }
}

TEST(BuildingAnswers, motions_that_no_earthquake_makes_are_doubted) {
  auto const kinds = [](Motion const& motion) {
    std::vector<FindingKind> found;
    for (auto const& doubt : motion_doubts(motion)) found.push_back(doubt.kind);
    return found;
  };
  auto const usual = example_motion(0);
  EXPECT_TRUE(kinds(usual).empty());
  auto strong = usual, off_zero = usual;
  for (double& a : strong.x_mm_s2) a *= 9.81;
  EXPECT_EQ(kinds(strong).front(), FindingKind::ground_too_strong);
  for (double& a : off_zero.x_mm_s2) a += 200.0;
  EXPECT_EQ(kinds(off_zero).front(), FindingKind::ground_off_zero);
  Motion const pulse{.name = "pulse", .step_s = 0.01, .x_mm_s2 = {0.0, 10.0, 20.0, 10.0, 0.0, -1.0, -30.0, 0.0, 0.0}};
  EXPECT_FALSE(kinds(pulse).empty());
}

std::vector<FindingKind> kinds_of(std::vector<Finding> const& findings) {
  std::vector<FindingKind> kinds;
  for (auto const& finding : findings) kinds.push_back(finding.kind);
  return kinds;
}

// There is a doubt about a run only if a measure exceeds its limit.
TEST(BuildingAnswers, doubts_about_a_run_begin_at_their_limits) {
  constexpr double tested_mm = 200.0;
  struct {
    Measure measure;
    double limit;
    FindingKind kind;
  } const doubts[]{{Measure::isolator, tested_mm, FindingKind::displacement_beyond_tests},
                   {Measure::balance, 1e-3, FindingKind::energy_error_large},
                   {Measure::balance, -1e-3, FindingKind::energy_error_large},
                   {Measure::rotation, 0.1, FindingKind::rotation_large}};
  for (auto const& [measure, limit, kind] : doubts)
    for (double const factor : {0.99, 1.01}) {
      Response run;
      run.measured.assign(Layout{0, 1}.count(), 0.0);
      run.measured[static_cast<std::size_t>(measure)] = factor * limit;
      EXPECT_EQ(kinds_of(run_doubts(run, "bilinear", "m", tested_mm)),
                factor > 1.0 ? std::vector{kind} : std::vector<FindingKind>())
          << factor * limit;
    }
  Response far;
  far.measured.assign(Layout{0, 1}.count(), 0.0);
  far.measured[static_cast<std::size_t>(Measure::isolator)] = 1e4;
  EXPECT_TRUE(run_doubts(far, "bilinear", "m", 0.0).empty()) << "what the tests reached is not known";
}

// Masses in kg where Mg is asked make the period 32 times too long.
TEST(BuildingAnswers, a_period_that_no_isolated_building_has_is_doubted) {
  for (double const factor : {1.0, 1e3, 1e-3}) {
    auto study = usual_study(0.0, 3);
    study.file.frame.base.mass_Mg *= factor;
    for (auto& floor : study.file.frame.floors) floor.slab.mass_Mg *= factor;
    EXPECT_EQ(std::ranges::count(study_doubts(study), FindingKind::period_implausible, &Finding::kind), factor != 1.0)
        << factor;
  }
}

// Draws are integrated explicitly. The nominal building is also integrated implicitly, which is the reference: explicit
// results that differ from it by more than 1 % are doubted.
TEST_F(BuildingRuns, off_the_reference_by_more_than_a_percent_are_doubted) {
  auto study = usual_study(0.001, 3);
  study.file.motions.resize(1);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  double const reference = answer(study, store).laws[0].checked[0].isolator_mm.value();
  for (double const percent : {0.9, -0.9, 1.1, -1.1}) {
    RunStore other(file_.string() + "-2", properties_of(study), true);
    std::vector<RunStore::Row> rows;
    store.for_each_run(0, 0, [&](std::size_t place, std::vector<double> measured) {
      if (place == 0) measured[static_cast<std::size_t>(Measure::isolator)] = reference * (1.0 + percent / 100.0);
      rows.push_back({.law = 0, .motion = 0, .place = place, .measured = std::move(measured)});
    });
    other.add(rows);
    EXPECT_EQ(std::ranges::count(answer(study, other).warnings, FindingKind::draws_off_reference, &Finding::kind),
              std::abs(percent) > 1.0)
        << percent;
  }
  fs::remove(file_.string() + "-2");
}

// Doubts about the nominal run are warnings of the study. The bearings stand close together and off the centre of mass,
// so that the base turns by more than the analysis holds for.
TEST_F(BuildingRuns, that_rotate_too_far_are_warned_of) {
  auto study = usual_study(0.001, 3);
  study.file.motions.resize(1);
  study.file.frame.floors.clear();
  study.file.frame.base = {.mass_Mg = 1600.0, .gyration_mm = 500.0, .centre = {0.0, 500.0}};
  for (auto& bearing : study.file.bearings) bearing.at = {0.02 * bearing.at.x_mm, 0.02 * bearing.at.y_mm};
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const answers = answer(study, store);
  EXPECT_EQ(std::ranges::count(answers.warnings, FindingKind::rotation_large, &Finding::kind), 1) << answers.warnings;
}

// The stated step error of the nominal run is compared with the difference from a run with a sixteenth of its step.
TEST_F(BuildingRuns, miss_what_shorter_steps_would_find) {
  auto study = usual_study(0.001, 3);
  study.file.motions.resize(1);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  auto const checked = answer(study, store).laws[0].checked[0];
  Model const model(Structure(study.file.frame), study.file.plan());
  Devices const devices(study.laws[0], study.file, study.file.motions[0]);
  auto const isolator_mm = [&](double step_s) {
    return integrate(model, devices.bearings(devices.parameters_of({})), study.file.motions[0],
                     {.longest_step_s = step_s, .rest_s = study.file.settings.rest_s})
        .value(Measure::isolator);
  };
  EXPECT_EQ(isolator_mm(checked.step_s), checked.isolator_mm);
  double const error = std::abs(checked.isolator_mm.value() - isolator_mm(checked.step_s / 16.0));
  EXPECT_GT(error, 1e-3);
  // isolaw estimates the error from a run with half the step. If the error fell with the square of the step, that run's
  // own error would be a quarter. Because the law yields within steps, it falls more slowly, so the tolerance is wide.
  EXPECT_NEAR(checked.missed_mm.value(), error, 0.5 * error);
}

// The search for factors tries numbers with two decimals. Each must be the double nearest to its decimal value, so that
// files show 0.82 as 0.82.
TEST(BuildingAnswers, factors_of_the_grid_are_their_two_decimals) {
  EXPECT_EQ(grid_factor(11), 0.82);
  for (std::uint32_t i = 0; i <= 2 * grid_half; ++i)
    EXPECT_EQ(Json(grid_factor(i)).dump(), Json(std::stod(fmt::format("{:.2f}", 0.6 + 0.02 * i))).dump());
}

// The balance of energy of one run of 48 is off. All other runs are sound, including the nominal building, so only a
// check of every run finds it.
TEST_F(BuildingRuns, an_energy_that_does_not_balance_in_one_of_them_is_said) {
  auto const study = usual_study(0.001, 3);
  auto const other = file_.string() + ".whole";
  fs::remove(other);
  RunStore whole(other, properties_of(study), false), store(file_, properties_of(study), false);
  run_all(study, whole, 1);
  for (std::size_t motion = 0; motion < 2; ++motion)
    whole.for_each_run(0, motion, [&](std::size_t place, std::vector<double> measured) {
      if (motion == 1 && place == 4) measured[static_cast<std::size_t>(Measure::balance)] = -0.01;
      store.add({{.law = 0, .motion = motion, .place = place, .measured = std::move(measured)}});
    });
  auto const warned = [&](RunStore const& runs) {
    auto const warnings = answer(study, runs).warnings;
    return std::ranges::count(warnings, FindingKind::energy_error_large, &Finding::kind);
  };
  EXPECT_EQ(warned(whole), 0);
  EXPECT_EQ(warned(store), 1);
  fs::remove(other);
}

TEST_F(BuildingRuns, the_share_that_bounds_cover_has_both_its_ends_in_percent) {
  auto const study = usual_study(0.001, 3);
  RunStore store(file_, properties_of(study), false);
  run_all(study, store, 1);
  EXPECT_TRUE(contains(answer(study, store).about_bounds, "cover 100 % of 3 buildings (29 % to 100 %)"))
      << answer(study, store).about_bounds;
}

}  // namespace
}  // namespace isolaw::building
