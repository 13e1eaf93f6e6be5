// Runs exported buildings in the real OpenSees. The tests compare the results with their own integration of one mass on
// one isolator, with what symmetry demands, and between Tcl and Python.
#include <fmt/format.h>

#include <functional>
#include <map>
#include <sstream>

#include "contains.hpp"
#include "unit/programs_in_opensees.hpp"
#include "unit/programs_models.hpp"

namespace isolaw::programs_test {
namespace {

// Holds the columns of a file of results. The key of a column is its name in the header, without the unit.
using Table = std::map<std::string, std::vector<double>>;

Table table_of(std::string const& csv) {
  Table table;
  std::istringstream lines(csv);
  std::string line, cell;
  std::vector<std::string> names;
  std::getline(lines, line);
  std::istringstream header(line);
  while (std::getline(header, cell, ',')) names.push_back(cell.substr(0, cell.find(" [")));
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) table[names.at(i)].push_back(std::stod(cell));
  }
  return table;
}

std::vector<double> sum(std::vector<double> a, std::vector<double> const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b.at(i);
  return a;
}

// Integrates the motion of one mass from rest by Newmark's rule (average acceleration). Each new displacement x1 solves
// mass (4 (x1 - x0)/dt2 - 4 v0/dt - a0) + force = -mass ground, where dt2 is the square of dt.
// The test finds x1 by bracketing, and so does not depend on the iteration in OpenSees. `force` is called with the
// whole path.
std::vector<double> response(double mass, std::vector<double> const& ground, double dt,
                             std::function<double(std::vector<double> const&)> const& force) {
  std::vector<double> path{0.0};
  double v = 0.0, a = 0.0;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    double const x0 = path.back();
    auto const acceleration = [&](double x) { return 4.0 * (x - x0) / (dt * dt) - 4.0 * v / dt - a; };
    path.push_back(x0);
    auto const residual = [&](double x) {
      path.back() = x;
      return mass * (acceleration(x) + ground[i]) + force(path);
    };
    // No isolator in these tests moves by more than 20 mm in one step.
    double low = x0 - 20.0, high = x0 + 20.0, at_low = residual(low), at_high = residual(high);
    for (int k = 0; k < 60 && high - low > 1e-11; ++k) {
      double const weight = std::clamp(at_low / (at_low - at_high), 0.01, 0.99);
      double const x = low + (k % 3 == 2 ? 0.5 : weight) * (high - low), r = residual(x);
      (r < 0.0 ? low : high) = x;
      (r < 0.0 ? at_low : at_high) = r;
    }
    double const x = 0.5 * (low + high), a1 = acceleration(x);
    path.back() = x;
    v += 0.5 * dt * (a + a1);
    a = a1;
  }
  return path;
}

// Returns the ground motion at the steps of the analysis, with `pieces` steps between two samples.
std::vector<double> in_pieces(std::vector<double> const& values, int pieces) {
  std::vector<double> steps{values.front()};
  for (std::size_t i = 1; i < values.size(); ++i)
    for (int k = 1; k <= pieces; ++k) steps.push_back(values[i - 1] + (values[i] - values[i - 1]) * k / pieces);
  return steps;
}

struct Building {
  std::string name, law;
  std::vector<double> parameters;
  double acceleration_mm_s2;
  bool coupled;
  double from_law;  // allowed difference from the exact law, as a share of the largest displacement
};
std::vector<Building> const buildings{
    {"corner", "bilinear", bilinear_parameters, 800.0, true, 1e-6},
    {"smooth", "bouc-wen", bouc_wen_parameters, 450.0, true, 0.02},
    // This law is exported as a Bouc-Wen bearing, which OpenSees integrates with an error of up to 2 %.
    {"curves", "vaiana", vaiana_parameters(), 450.0, true, 0.02},
    {"hardening curves", "vaiana", vaiana_parameters(800.0, 12.0), 450.0, false, 1e-6},
    {"softening curves", "vaiana", vaiana_parameters(-800.0, 12.0), 450.0, false, 1e-6}};

class ModelInOpenSees : public OpenSees {
 protected:
  // Writes the model in Tcl and runs it. The results are in `folder`.
  Realisation shaken(Building const& b, Model model, std::string const& folder,
                     UnitSystem const& units = unit_systems[0], std::string const& cases = "") {
    auto subject = subject_of(b.law, b.parameters);
    subject.model = std::move(model);
    auto realisation = realise(subject);
    add_draws(realisation, subject);
    write("model.tcl", opensees_model(subject, realisation, units));
    EXPECT_EQ(run_tcl(fmt::format("model.tcl run {} {}", folder, cases)), 0) << b.name << read("printed");
    EXPECT_EQ(read("printed").find("WARNING "), std::string::npos) << b.name << read("printed");
    return realisation;
  }
  Table slab(std::string const& folder, std::string const& of = "nominal") const {
    return table_of(read(fs::path(folder) / of / "slab.csv"));
  }
  Table isolators(std::string const& folder, std::string const& of = "nominal") const {
    return table_of(read(fs::path(folder) / of / "bearings.csv"));
  }
};

// The slab on four equal isolators neither turns nor moves along y, so it moves as a quarter of its mass on one
// isolator.
TEST_F(ModelInOpenSees, a_symmetric_building_moves_as_one_mass_on_one_isolator) {
  for (auto const& b : buildings) {
    auto const model = four(b.acceleration_mm_s2);
    auto const realisation = shaken(b, model, "out", unit_systems[0], "nominal");
    auto const& form = form_of_model(realisation);
    EXPECT_EQ(form.nominal.id == "bearing", b.coupled) << b.name;
    auto subject = subject_of(b.law, b.parameters);
    subject.model = model;
    auto const numbers = model_numbers(subject, realisation, unit_systems[0]);
    auto const found = slab("out");
    auto const ground = in_pieces(model.motions[0].acceleration_mm_s2, numbers.pieces);
    double const dt = numbers.motion_step_s / numbers.pieces, mass = numbers.mass / 4.0;
    auto const commands = in_units(form.nominal, unit_systems[0]);
    auto const at_samples = [&](std::vector<double> const& path) {
      std::vector<double> samples;
      for (std::size_t i = 0; i < path.size(); i += static_cast<std::size_t>(numbers.pieces))
        samples.push_back(path[i]);
      return samples;
    };
    auto const of_form =
        at_samples(response(mass, ground, dt, [&](auto const& path) { return replay(commands, path).back(); }));
    ASSERT_EQ(of_form.size(), found.at("ux").size()) << b.name;
    double const peak = peak_of(of_form);
    EXPECT_GT(peak, 30.0) << b.name;
    EXPECT_LT(peak, 225.0) << b.name;
    // Small errors of each of the 900 steps add up. Newton's rule for the displacement stops at 1e-8 mm. For Bouc-Wen,
    // OpenSees also iterates for the hysteretic variable z and stops at 1e-9 of its largest value.
    EXPECT_LT(largest_difference(found.at("ux"), of_form), 1e-6 * peak) << b.name;
    auto const of_law = at_samples(response(mass, ground, dt, [&](auto const& path) {
      History history;
      history.disp_mm = path;
      for (std::size_t i = 0; i < path.size(); ++i) {
        history.time_s.push_back(static_cast<double>(i) * dt);
        history.vel_mm_s.push_back(0.0);  // these laws do not depend on velocity
      }
      return law_force(*subject.law, subject.parameters, history).back();
    }));
    EXPECT_LT(largest_difference(found.at("ux"), of_law), b.from_law * peak) << b.name;
    EXPECT_LT(peak_of(found.at("turning")), 1e-12) << b.name;
    EXPECT_LT(peak_of(found.at("uy")), 1e-9 * peak) << b.name;
    // By symmetry each isolator takes a quarter of the shear.
    auto const each = isolators("out");
    std::vector<double> shear(found.at("Vx").size());
    for (auto const* name : {"A", "B", "C", "D"}) {
      EXPECT_LT(largest_difference(each.at(fmt::format("{} ux", name)), found.at("ux")), 1e-9 * peak) << b.name;
      shear = sum(shear, each.at(fmt::format("{} Fx", name)));
      auto four_times = each.at(fmt::format("{} Fx", name));
      for (double& f : four_times) f *= 4.0;
      EXPECT_LT(largest_difference(four_times, found.at("Vx")), 1e-8 * peak_of(shear)) << b.name;
    }
    EXPECT_LT(largest_difference(shear, found.at("Vx")), 1e-8 * peak_of(shear)) << b.name;
    // One isolator under a quarter of the mass must give the same motion.
    auto alone = model;
    alone.bearings.resize(1);
    alone.weight_kN = carried_kN;
    alone.x_mm = alone.y_mm = 0.0;
    shaken(b, alone, "alone", unit_systems[0], "nominal");
    EXPECT_LT(largest_difference(slab("alone").at("ux"), found.at("ux")), 1e-6 * peak) << b.name;
  }
}

TEST_F(ModelInOpenSees, an_eccentric_building_turns) {
  auto const& b = buildings[1];
  shaken(b, four(b.acceleration_mm_s2, 0.3), "out", unit_systems[0], "nominal");
  auto const found = slab("out");
  EXPECT_GT(peak_of(found.at("turning")), 1e-4);
  // The side at y = 4 m is heavier and lags. The sides differ in displacement by the rotation times the distance
  // between them.
  auto const each = isolators("out");
  for (std::size_t i = 0; i < found.at("turning").size(); ++i)
    EXPECT_NEAR(each.at("A ux")[i] - each.at("C ux")[i], 4000.0 * found.at("turning")[i], 1e-6);
  auto const peaks = read("out/peaks.csv");
  EXPECT_TRUE(contains(peaks, fmt::format("nominal,C,"))) << peaks;
}

// Springs at right angles do not interact, so motion along y does not change the motion along x. A coupled bearing is
// weaker along x while it moves along y.
TEST_F(ModelInOpenSees, two_components_meet_in_coupled_bearings_alone) {
  for (auto const& b : {buildings[3], buildings[0]}) {
    auto model = four(b.acceleration_mm_s2);
    shaken(b, model, "x", unit_systems[0], "nominal");
    model.motions.push_back(shaking(0.8 * b.acceleration_mm_s2));
    shaken(b, model, "xy", unit_systems[0], "nominal");
    auto const x = slab("x").at("ux"), xy = slab("xy").at("ux");
    EXPECT_GT(peak_of(slab("xy").at("uy")), 10.0) << b.name;
    EXPECT_EQ(largest_difference(x, xy) > 0.05 * peak_of(x), b.coupled) << b.name;
    EXPECT_EQ(largest_difference(x, xy) > 1e-7 * peak_of(x), b.coupled) << b.name;
    // A bearing that is not coupled has a spring along its own x and one along its own y. If it is turned by 90
    // degrees, the second spring acts along -x of the building. This spring is stiffer for one sign of its displacement
    // than for the other, so the test reverses the ground motion as well.
    for (auto& bearing : model.bearings) bearing.angle_deg = 90.0;
    for (double& a : model.motions[0].acceleration_mm_s2) a = -a;
    auto const realisation = shaken(b, model, "turned", unit_systems[0], "nominal");
    auto turned = slab("turned").at("ux");
    for (double& value : turned) value = -value;
    // A coupled bearing has no preferred direction, and the second spring meets the displacements that the first met
    // before. For both kinds of bearing, the motion along x must therefore be the earlier one with its sign reversed.
    EXPECT_EQ(largest_difference(turned, xy) > 1e-6 * peak_of(x), false) << b.name;
    auto subject = subject_of(b.law, b.parameters);
    subject.model = model;
    EXPECT_EQ(
        contains(opensees_model(subject, realisation, unit_systems[0]), "force differs between its two directions"),
        !b.coupled);
  }
}

TEST_F(ModelInOpenSees, bounds_are_three_analyses_from_soft_to_stiff) {
  for (auto const& b : buildings) {
    shaken(b, four(b.acceleration_mm_s2), "out");
    std::vector<double> stiffness;
    for (auto const* bound : {"lower", "nominal", "upper"}) {
      auto const each = isolators("out", bound);
      stiffness.push_back(peak_of(each.at("A Fx")) / peak_of(each.at("A ux")));
      EXPECT_TRUE(contains(read("out/peaks.csv"), fmt::format("\n{},A,", bound))) << b.name;
      EXPECT_TRUE(contains(read("printed"), fmt::format("\n{} ", bound))) << b.name << read("printed");
    }
    EXPECT_LT(stiffness[0], stiffness[1]) << b.name;
    EXPECT_LT(stiffness[1], stiffness[2]) << b.name;
  }
}

// The Tcl and the Python model must give the same results, in any system of units.
TEST_F(ModelInOpenSees, python_does_what_tcl_does_in_any_units) {
  for (auto const& b : {buildings[1], buildings[3]}) {
    auto model = four(b.acceleration_mm_s2, 0.2);
    model.motions.push_back(shaking(0.5 * b.acceleration_mm_s2));
    auto const realisation = shaken(b, model, "tcl");
    auto subject = subject_of(b.law, b.parameters);
    subject.model = model;
    write("model.py", openseespy_model(subject, realisation, unit_systems[0]));
    EXPECT_EQ(run_python("model.py run python"), 0) << read("printed");
    EXPECT_EQ(read("tcl/peaks.csv"), read("python/peaks.csv"));
    // OpenSees passes values to Tcl with twenty decimals, so the two results agree closely but not exactly.
    for (auto const* file : {"lower/slab.csv", "nominal/bearings.csv"}) {
      auto const one = table_of(read(fs::path("tcl") / file)), other = table_of(read(fs::path("python") / file));
      EXPECT_EQ(one.size(), other.size()) << file;
      for (auto const& [name, values] : one) {
        EXPECT_EQ(values.size(), 451u) << file << name;
        EXPECT_LT(largest_difference(values, other.at(name)), 1e-9 * peak_of(values)) << file << name;
      }
    }
    write("model.py", openseespy_model(subject, realisation, unit_systems[1]));
    EXPECT_EQ(run_python("model.py run metres nominal"), 0) << read("printed");
    auto const mm = slab("tcl").at("ux");
    auto metres = slab("metres").at("ux");
    for (double& x : metres) x *= 1e3;
    EXPECT_LT(largest_difference(metres, mm), 1e-5 * peak_of(mm)) << b.name;
    EXPECT_FALSE(fs::exists(folder_ / "metres/lower"));
    // The self-check of the materials must also pass in a file with a building.
    EXPECT_EQ(run_python("model.py"), 0) << read("printed");
    EXPECT_EQ(run_tcl("model.tcl check"), 0) << read("printed");
  }
}

// A draw with nominal isolators must give the nominal result. A draw with one stiffer isolator makes the slab turn.
TEST_F(ModelInOpenSees, draws_are_analyses_of_their_own) {
  auto const& b = buildings[0];
  auto model = four(b.acceleration_mm_s2);
  auto stiffer = b.parameters;
  stiffer[1] *= 1.2;
  model.draws = {{b.parameters, b.parameters, b.parameters, b.parameters},
                 {stiffer, b.parameters, b.parameters, b.parameters}};
  shaken(b, model, "out");
  EXPECT_EQ(read("out/draw_1/slab.csv"), read("out/nominal/slab.csv"));
  EXPECT_LT(peak_of(slab("out").at("turning")), 1e-12);
  EXPECT_GT(peak_of(slab("out", "draw_2").at("turning")), 1e-6);
  EXPECT_TRUE(contains(read("printed"), "\nmean ")) << read("printed");
  EXPECT_TRUE(contains(read("printed"), "\nlargest ")) << read("printed");
}

// A law without a two-dimensional form becomes a set of springs. The campaign may have fitted parameters to such
// springs, but draws always have parameters of the law in one direction. The exported file must say this and not ask
// for a fit of springs that is there already.
TEST(OpenSeesPyModel, of_draws_does_not_ask_for_springs_that_are_fitted) {
  std::vector<double> const parameters{60.0, 0.6, 10.0, 0.0, 20.0, 0.05};
  auto subject = subject_of("power-masing", parameters);
  auto model = four(900.0);
  model.motions.push_back(shaking(450.0));
  subject.model = model;
  auto realisation = realise(subject);
  // Returns the file's text as one line, without the # at the start of comment lines.
  auto const text = [&] {
    std::istringstream words(openseespy_model(subject, realisation, unit_systems[0]));
    std::string all;
    for (std::string word; words >> word;)
      if (word != "#") all += word + " ";
    return all;
  };
  EXPECT_TRUE(contains(text(), "--bidirectional springs fits them"));
  subject.springs = parameters;
  EXPECT_TRUE(contains(text(), "parameters that were fitted to such springs"));
  subject.model->draws = {{parameters, parameters, parameters, parameters}};
  add_draws(realisation, subject);
  EXPECT_TRUE(contains(text(), "fitted to such springs, which draws do not have"));
  EXPECT_FALSE(contains(text(), "--bidirectional springs fits them"));
}

// OpenSees itself exits with 0 after an error in a script; the exported script must exit with 1.
TEST_F(ModelInOpenSees, what_fails_ends_with_another_exit_code) {
  auto subject = subject_of("bilinear", bilinear_parameters);
  subject.model = four(900.0);
  auto const realisation = realise(subject);
  auto const script = opensees_model(subject, realisation, unit_systems[0]);
  write("model.tcl", script);
  EXPECT_EQ(run_tcl("model.tcl run out nonsense"), 1) << read("printed");
  EXPECT_TRUE(contains(read("printed"), "no case nonsense; there is: lower nominal upper")) << read("printed");
  write("model.py", openseespy_model(subject, realisation, unit_systems[0]));
  EXPECT_EQ(run_python("model.py run out nonsense"), 1) << read("printed");
  EXPECT_TRUE(contains(read("printed"), "no case nonsense")) << read("printed");
  // Replace the bearing by a type that OpenSees does not know.
  auto broken = script;
  constexpr std::string_view name = "element elastomericBearingPlasticity $tag";
  broken.replace(broken.find(name), name.size(), "element elastomericBearingNone $tag");
  write("model.tcl", broken);
  EXPECT_EQ(run_tcl("model.tcl run out nominal"), 1) << read("printed");
  // Make the tolerance negative, so that the analysis cannot converge.
  broken = script;
  constexpr std::string_view tolerance = "variable tolerance ";
  broken.insert(broken.find(tolerance) + tolerance.size(), "-");
  write("model.tcl", broken);
  EXPECT_EQ(run_tcl("model.tcl run out nominal"), 1) << read("printed");
  EXPECT_TRUE(contains(read("printed"), "no equilibrium")) << read("printed");
}

// The script must print a warning if a displacement exceeds the tested one.
TEST_F(ModelInOpenSees, displacements_beyond_the_tests_are_said) {
  auto subject = subject_of("bilinear", bilinear_parameters);
  subject.model = four(900.0);
  subject.tested.disp_mm = 20.0;
  write("model.tcl", opensees_model(subject, realise(subject), unit_systems[0]));
  EXPECT_EQ(run_tcl("model.tcl run out nominal"), 0) << read("printed");
  EXPECT_TRUE(contains(read("printed"), "WARNING: beyond the 20 mm that were tested")) << read("printed");
}

}  // namespace
}  // namespace isolaw::programs_test
