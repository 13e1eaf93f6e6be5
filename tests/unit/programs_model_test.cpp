// Tests layouts of isolators and models of buildings without OpenSees: what isolaw reads, refuses and writes.
#include <gtest/gtest.h>

#include "contains.hpp"
#include "isolaw/base/error.hpp"
#include "unit/programs_models.hpp"

namespace isolaw::programs_test {
namespace {

std::string layout_complaint(std::string const& bytes) {
  try {
    read_layout_text(bytes, "l.csv");
  } catch (Error const& error) {
    return error.what();
  }
  return {};
}

TEST(Layout, is_read_in_the_units_of_its_header) {
  auto const places = read_layout_text(
      "# plan\nname; x [m]; y [cm]; load [MN]; K_v [kN/m]; angle [rad]\nA 1; 1,5; 20; 1,2; 500000; 0\n"
      "; -3; 40; 0,8; 500000; 3,14159265\n",
      "l.csv");
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].name, "A 1");
  EXPECT_EQ(places[1].name, "b2");
  EXPECT_DOUBLE_EQ(places[0].x_mm, 1500.0);
  EXPECT_DOUBLE_EQ(places[1].x_mm, -3000.0);
  EXPECT_DOUBLE_EQ(places[0].y_mm, 200.0);
  EXPECT_DOUBLE_EQ(*places[0].load_kN, 1200.0);
  EXPECT_DOUBLE_EQ(*places[0].K_v_kN_per_mm, 500.0);
  EXPECT_NEAR(places[1].angle_deg, 180.0, 1e-6);
  auto const plain = read_layout_text("x [mm],y [mm]\n0,0\n", "l.csv");
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_FALSE(plain[0].load_kN || plain[0].K_v_kN_per_mm);
  EXPECT_EQ(read_layout_text("x [mm]\ty [mm]\n0\t0\n1e3\t0\n", "l.csv").size(), 2u);
}

TEST(Layout, what_is_wrong_is_refused_with_its_place) {
  auto const says = [](std::string const& bytes, std::string const& words) {
    EXPECT_TRUE(contains(layout_complaint(bytes), words)) << layout_complaint(bytes);
  };
  says("", "empty");
  says("x [m],y [m]\n", "l.csv: no bearings");
  says("# nothing\n", "l.csv: no bearings");
  says("x,y [m]\n0,0\n", "l.csv:1: column 'x' has no unit");
  says("x [kN],y [m]\n0,0\n", "column 'x' is in 'kN'; allowed: 'x [UNIT]', the unit one of mm, cm, m, in, ft, dm, um");
  says("x [m],y [m],load\n0,0,3\n", "column 'load' has no unit");
  says("x [m],z [m]\n0,0\n", "column 'z [m]'");
  says("x [m],z [m]\n0,0\n", "no column y");
  says("x [m],x [m],y [m]\n0,0,0\n", "column x twice");
  says("x [m],y [m]\n0,nan\n", "l.csv:2: y is 'nan'; allowed: a finite number");
  says("x [m],y [m]\n0,inf\n", "l.csv:2: y is 'inf'");
  says("x [m],y [m]\n0,left\n", "l.csv:2: y is 'left'");
  says("x [m],y [m]\n0,0\n1\n", "l.csv:3: 1 cell; allowed: 2");
  says("x [m],y [m],load [kN]\n0,0,-3\n", "l.csv:2: load is '-3'; allowed: a number above 0");
  says("x [m],y [m],load [kN]\n0,0,3\n1,1,\n", "l.csv:3:");
  says("x [m],y [m]\n1,2\n3,4\n1,2.0001\n", "bearings 'b1' and 'b3' stand in one place");
  says("name,x [m],y [m]\nA,1,2\nA,3,4\n", "two bearings called 'A'");
}

Subject with_model(std::string_view law, std::vector<double> const& parameters, Model model) {
  auto subject = subject_of(law, parameters);
  subject.model = std::move(model);
  return subject;
}

// The numbers of one building, once in kN and mm and once in N and m, must differ by the factors of the units.
TEST(ModelNumbers, follow_the_units_of_the_file) {
  auto const subject = with_model("bilinear", bilinear_parameters, four(900.0));
  auto const realisation = realise(subject);
  auto const first = model_numbers(subject, realisation, unit_systems[0]);
  auto const N_m = model_numbers(subject, realisation, unit_systems[1]);
  EXPECT_NEAR(first.mass, 4.0 * carried_kN / 9806.65, 1e-12);
  EXPECT_NEAR(N_m.mass, 1e6 * first.mass, 1e-6);                  // the factor from kN s2/mm to kg
  EXPECT_NEAR(N_m.inertia, first.inertia, 1e-9 * first.inertia);  // kN mm is the same unit as N m
  EXPECT_NEAR(N_m.inertia, N_m.mass * 2.1 * 2.1, 1e-6);
  EXPECT_NEAR(N_m.bearings[3].x, 6.0, 1e-12);
  EXPECT_NEAR(N_m.bearings[3].K_v, 500e6, 1.0);
  EXPECT_NEAR(N_m.motions[0][100], 1e-3 * first.motions[0][100], 1e-12);
  EXPECT_EQ(first.pieces, 2);
  EXPECT_TRUE(first.coupled);
  EXPECT_EQ(first.cases, (std::vector<std::string>{"lower", "nominal", "upper"}));
  double load = 0.0, mass = 0.0;
  for (auto const& b : first.bearings) {
    load += b.load;
    mass += b.mass;
  }
  EXPECT_NEAR(load, first.weight, 1e-9);
  EXPECT_NEAR(mass, first.mass, 1e-12);
}

// OpenSees integrates Bouc-Wen with an error that falls with the step. The model's step must be as small as isolaw
// demands for this law.
TEST(ModelNumbers, take_the_step_that_the_law_needs) {
  auto model = four(450.0);
  model.motions = {shaking(450.0, 0.1)};
  auto const subject = with_model("bouc-wen", bouc_wen_parameters, model);
  auto const realisation = realise(subject);
  auto const& form = form_of_model(realisation);
  ASSERT_TRUE(form.steps);
  auto const numbers = model_numbers(subject, realisation, unit_systems[0]);
  EXPECT_LE(numbers.motion_step_s / numbers.pieces, 1.0 / (form.steps->per_cycle * subject.frequency_Hz) * (1 + 1e-12));
}

TEST(ModelText, says_what_is_in_the_model_and_what_is_not) {
  auto subject = with_model("bilinear", bilinear_parameters, four(900.0));
  subject.tested.load_min_kN = subject.tested.load_max_kN = 2000.0;
  Remarks none;
  for (auto const name : targets_where(&Target::needs_building)) {
    auto const text = find_target(name).write(subject, unit_systems[0], none);
    for (auto const* words :
         {"# Model: 4 isolators", "# Weight carried: 2353.6 kN", "# Its centre: x = 3000, y = 2000 mm",
          "# Vertical springs: 500 kN/mm", "# Not in the model: ", "P-delta", "# Ground motion along x: made here",
          "# Step of the analysis: 0.005 s", "# Analyses: lower, nominal, upper",
          "# Fidelity: ", "# Displacement tested: ", "# Prediction: ",
          "# Warning: the isolators carry 588.4 kN and were tested under 2000"})
      EXPECT_TRUE(contains(text, words)) << name << ": " << words;
  }
  // A subject without a building cannot be exported as a building.
  subject.model.reset();
  EXPECT_THROW(write_export(subject, find_target("opensees-model"), unit_systems[0], true), Error);
}

TEST(ModelText, one_isolator_is_held_against_turning) {
  auto model = four(900.0);
  model.bearings.resize(1);
  model.weight_kN = model.bearings[0].load_kN;
  auto const subject = with_model("bilinear", bilinear_parameters, model);
  auto const text = opensees_model(subject, realise(subject), unit_systems[0]);
  EXPECT_TRUE(contains(text, "variable held 1"));
  EXPECT_TRUE(contains(text, "# Turning in plan: held"));
}

// A draw gives each isolator of the building its own parameters. Each of these isolators gets a material of its own,
// which the exported file checks like the other materials.
TEST(ModelDraws, become_variants_that_the_file_checks) {
  auto model = four(900.0);
  auto stiffer = bilinear_parameters;
  stiffer[1] *= 1.25;
  model.draws = {{bilinear_parameters, stiffer, bilinear_parameters, stiffer},
                 {stiffer, stiffer, stiffer, bilinear_parameters}};
  auto const subject = with_model("bilinear", bilinear_parameters, model);
  auto realisation = realise(subject);
  auto const worst = add_draws(realisation, subject);
  EXPECT_LT(worst.largest, exact_percent);
  auto const check = self_check(subject, realisation, unit_systems[0]);
  std::size_t found = 0;
  for (auto const& form : check.forms)
    for (auto const& variant : form.variants) {
      if (!variant.name.starts_with("draw_")) continue;
      ++found;
      EXPECT_TRUE(form.is_element);
      bool const is_stiffer = variant.name == "draw_1_2" || variant.name == "draw_1_4" ||
                              (variant.name.starts_with("draw_2") && variant.name != "draw_2_4");
      auto const expected = law_force(*subject.law, is_stiffer ? stiffer : bilinear_parameters, subject.protocol);
      EXPECT_LT(largest_difference(variant.force, expected), 1e-6 * peak_of(expected)) << variant.name;
    }
  EXPECT_EQ(found, 8u);
  EXPECT_EQ(model_numbers(subject, realisation, unit_systems[0]).cases,
            (std::vector<std::string>{"nominal", "draw_1", "draw_2"}));
}

TEST(ModelDraws, one_that_the_program_cannot_give_is_named) {
  auto model = four(900.0);
  auto never_yields = bilinear_parameters;
  never_yields[0] = never_yields[1];
  model.draws = {{bilinear_parameters, bilinear_parameters, bilinear_parameters, bilinear_parameters},
                 {bilinear_parameters, bilinear_parameters, never_yields, bilinear_parameters}};
  auto const subject = with_model("bilinear", bilinear_parameters, model);
  auto realisation = realise(subject);
  try {
    add_draws(realisation, subject);
    FAIL() << "it was taken";
  } catch (Error const& error) {
    EXPECT_TRUE(contains(error.what(), "--draws, draw 2, bearing C: ")) << error.what();
    EXPECT_TRUE(contains(error.what(), "without yielding")) << error.what();
  }
}

// If a substitute is exported in place of a law, it is fitted to the law of each isolator in a draw separately.
TEST(ModelDraws, of_a_law_that_has_a_stand_in_are_fitted_one_by_one) {
  auto uneven = vaiana_parameters();
  uneven[1] *= 1.1;
  auto stronger = uneven;
  stronger[2] *= 1.3;
  stronger[3] *= 1.3;
  auto model = four(450.0);
  model.draws = {{uneven, stronger, uneven, stronger}};
  auto const subject = with_model("vaiana", uneven, model);
  auto realisation = realise(subject);
  ASSERT_EQ(realisation.fidelity, Fidelity::refitted);
  auto const worst = add_draws(realisation, subject);
  EXPECT_GT(worst.largest, exact_percent);
  EXPECT_FALSE(far_off(worst)) << deviation_text(worst);
  EXPECT_TRUE(contains(opensees_model(subject, realisation, unit_systems[0]),
                       "#   draws against their own laws: the worst, on the record of D: largest "));
  auto const& draws = form_of_model(realisation).draws;
  ASSERT_EQ(draws.size(), 4u);
  auto const peak = [&](std::size_t i) {
    return peak_of(replay_kN(draws[i].second, unit_systems[0], subject.protocol.disp_mm));
  };
  EXPECT_DOUBLE_EQ(peak(0), peak(2));
  EXPECT_GT(peak(1), 1.03 * peak(0));
}

}  // namespace
}  // namespace isolaw::programs_test
