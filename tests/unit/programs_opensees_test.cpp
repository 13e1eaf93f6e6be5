// Runs exported scripts in the real OpenSees, in Tcl and Python. The scripts check themselves. The tests also run
// time-history analyses and compare the forces with those computed along the resulting displacements.
#include <fmt/format.h>

#include "isolaw/base/words.hpp"
#include "unit/programs_in_opensees.hpp"

namespace isolaw::programs_test {
namespace {

struct Exported {
  std::string name, law;
  std::vector<double> parameters;
  // Peak acceleration of the ground, which moves the mass about as far as the tests did.
  double acceleration_mm_s2 = 450.0;
};
std::vector<Exported> const exported{{"corner", "bilinear", bilinear_parameters, 900.0},
                                     {"branches", "menegotto-pinto", menegotto_pinto_parameters, 300.0},
                                     {"smooth", "bouc-wen", bouc_wen_parameters},
                                     {"curves", "vaiana", vaiana_parameters()},
                                     {"hardening curves", "vaiana", vaiana_parameters(800.0, 12.0)},
                                     {"softening curves", "vaiana", vaiana_parameters(-800.0, 12.0)}};

TEST_F(OpenSees, scripts_check_themselves) {
  for (auto const& c : exported)
    for (auto const& units : unit_systems) {
      auto const subject = subject_of(c.law, c.parameters);
      auto const realisation = realise(subject);
      ASSERT_NE(realisation.fidelity, Fidelity::refitted) << c.name << ": " << realisation.explanation;
      auto const said = fmt::format("{} in {}\n", c.name, units.id);
      write("bearing.tcl", opensees_script(subject, realisation, units));
      EXPECT_EQ(run_tcl("bearing.tcl check"), 0) << said << read("printed");
      for (auto const& form : realisation.forms)
        for (auto const* variant : {"nominal", "lower", "upper"})
          EXPECT_NE(read("printed").find(fmt::format("isolaw {} {}: largest", form.nominal.id, variant)),
                    std::string::npos)
              << said << read("printed");
      EXPECT_EQ(read("printed").find("FAIL"), std::string::npos) << said << read("printed");
      EXPECT_EQ(read("printed").find("WARNING"), std::string::npos) << said << read("printed");
      write("bearing.py", openseespy_script(subject, realisation, units));
      EXPECT_EQ(run_python("bearing.py"), 0) << said << read("printed");
    }
}

// The check in a script must be able to fail. The test makes one force wrong and lets OpenSees refuse a command.
TEST_F(OpenSees, a_wrong_script_ends_with_another_exit_code) {
  auto const subject = subject_of("vaiana", vaiana_parameters());
  auto const script = opensees_script(subject, realise(subject), unit_systems[0]);
  auto const at = script.find("uniaxialMaterial HystereticAsym $tag ");
  ASSERT_NE(at, std::string::npos);
  auto changed = script;
  changed.insert(at + std::string_view("uniaxialMaterial HystereticAsym $tag ").size(), "1");
  write("bearing.tcl", changed);
  EXPECT_EQ(run_tcl("bearing.tcl check"), 1) << read("printed");
  EXPECT_NE(read("printed").find("FAIL"), std::string::npos) << read("printed");
  changed = script;
  changed.insert(at + std::string_view("uniaxialMaterial HystereticAsym $tag ").size(), "-");
  write("bearing.tcl", changed);
  EXPECT_EQ(run_tcl("bearing.tcl check"), 1) << read("printed");
}

// isolaw must refuse exactly those of the listed arguments for HystereticAsym that OpenSees refuses.
TEST_F(OpenSees, arguments_are_refused_where_the_program_refuses_them) {
  for (auto const& [a, taken] : {std::pair(std::vector<double>{2, 1, 3, 0, 0, 0}, true),
                                 {{-2, -3, 3, 0, 0, 0}, false},
                                 {{0, -1, 3, 0, 0, 0}, false},
                                 {{1, 1, 3, 0, 0, 0}, false},
                                 {{1, 2, 3, 0, 0, 0}, false},
                                 {{2, 1, 0, 0, 0, 0}, false},
                                 {{2, 1, -3, 0, 0, 0}, false},
                                 {{2, -1, 3, 0, 0, 0}, true},
                                 {{2, 1, 3, -0.1, 0, 0}, true}}) {
    std::vector<Command> const commands{{"HystereticAsym", a}};
    auto const text = joined(a | std::views::transform([](double v) { return fmt::format("{}", v); }), " ");
    EXPECT_EQ(refused_by_program(commands).empty(), taken) << text;
    write("one.tcl", fmt::format("model basic -ndm 1 -ndf 1\nif {{[catch {{uniaxialMaterial HystereticAsym 1 {}}}]}} "
                                 "{{puts refused}} else {{puts taken}}\n",
                                 text));
    EXPECT_EQ(run_tcl("one.tcl"), 0);
    EXPECT_EQ(read("printed").find("taken") != std::string::npos, taken) << text << read("printed");
  }
}

// Holds the displacement of a mass on the bearing and the force of the bearing at each step of Newmark's rule.
struct Response {
  std::vector<double> disp, force;
};

class InTime : public OpenSees {
 protected:
  // Shakes a mass on the bearing with four cycles of ground motion, near the period of two seconds that the mass has
  // with the stiffness after yielding. Units are kN and mm. `element` is the command that puts element 1 between nodes
  // 1 and 2 of a model of 2 or 3 `dimensions`.
  Response shaken(Subject const& subject, Realisation const& realisation, std::string const& element, int dimensions,
                  double step_s, double acceleration) const {
    write("bearing.tcl", opensees_script(subject, realisation, unit_systems[0]));
    bool const plane = dimensions == 2;
    write(
        "shaken.tcl",
        fmt::format("source bearing.tcl\nwipe\nmodel basic -ndm {} -ndf {}\n", dimensions, plane ? 3 : 6) +
            (plane ? "node 1 0 0\nnode 2 0 0\nfix 1 1 1 1\nfix 2 0 1 1\nmass 2 0.06 0.06 0.06\n"
                   : "node 1 0 0 0\nnode 2 0 0 0\nfix 1 1 1 1 1 1 1\nfix 2 0 1 1 1 1 1\n"
                     "mass 2 0.06 0.06 0.06 0.06 0.06 0.06\n") +
            "uniaxialMaterial Elastic 900 1000.0\n" + element +
            fmt::format(
                "\nset dt {}\nset values {{}}\nfor {{set i 0}} {{$i * $dt < 8.0}} {{incr i}} {{\n"
                "  set t [expr {{$i * $dt}}]\n  lappend values [expr {{{} * sin(3.2 * $t) * min(1.0, 0.5 * $t)}}]\n}}\n",
                step_s, acceleration) +
            "timeSeries Path 1 -dt $dt -values $values\npattern UniformExcitation 1 1 -accel 1\n"
            "constraints Plain\nnumberer Plain\nsystem FullGeneral\ntest NormDispIncr 1e-10 50\nalgorithm Newton\n"
            "integrator Newmark 0.5 0.25\nanalysis Transient\n"
            "for {set i 1} {$i < [llength $values]} {incr i} {\n  if {[analyze 1 $dt] != 0} {puts \"ended at $i\"; exit 2}\n"
            "  puts \"at [nodeDisp 2 1] [lindex [eleForce 1] " +
            (plane ? "3" : "6") + "]\"\n}\n");
    EXPECT_EQ(run_tcl("shaken.tcl"), 0) << read("printed");
    Response response;
    std::istringstream lines(read("printed"));
    for (std::string line, word; std::getline(lines, line);) {
      std::istringstream values(line);
      double x = 0.0, f = 0.0;
      if (!(values >> word >> x >> f) || word != "at") continue;
      response.disp.push_back(x);
      response.force.push_back(f);
    }
    return response;
  }
};

TEST_F(InTime, elements_give_the_force_of_the_replay) {
  for (auto const& c : exported) {
    auto const subject = subject_of(c.law, c.parameters);
    auto const realisation = realise(subject);
    auto const space = identifier(subject, unit_systems[0]);
    for (auto const& form : realisation.forms) {
      auto const& id = form.nominal.id;
      bool const is_bearing = id == "bearing";
      for (int const dimensions : {2, 3})
        for (double const step_s : {0.0005, 0.002, 0.005, 0.01, 0.02}) {
          auto const element = is_bearing
                                   ? fmt::format("{}::bearing 1 1 2 nominal {}", space,
                                                 dimensions == 2 ? "-P 900 -Mz 900 -orient 0 1 0 -1 0 0"
                                                                 : "-P 900 -T 900 -My 900 -Mz 900 -orient 0 0 1 1 0 0")
                                   : fmt::format("{}::{} 1\nelement zeroLength 1 1 2 -mat 1 -dir 1", space, id);
          auto const found = shaken(subject, realisation, element, dimensions, step_s, c.acceleration_mm_s2);
          auto const said = fmt::format("{}, {} in {} dimensions, {} s", c.name, id, dimensions, step_s);
          ASSERT_EQ(found.disp.size(), static_cast<std::size_t>(std::ceil(8.0 / step_s - 1e-9)) - 1) << said;
          // The mass must move far enough to test the material, but not far beyond the tests.
          EXPECT_GT(peak_of(found.disp), 30.0) << said;
          EXPECT_LT(peak_of(found.disp), 225.0) << said;
          auto const expected = replay(in_units(form.nominal, unit_systems[0]), found.disp);
          // Small errors of each step add up. Newton's rule for the displacement stops at 1e-10 mm. Materials of
          // Bouc-Wen also iterate for their hysteretic variable and stop at a tolerance of their own.
          double const tolerance = form.nominal.exactness == Exactness::every_step ? 1e-8 : 1e-5;
          EXPECT_LT(largest_difference(found.force, expected), tolerance * peak_of(expected)) << said;
        }
    }
  }
}

// If isolaw exports a law as a material of OpenSees, it states how far the device may travel. Up to this travel
// OpenSees must give finite forces.
TEST_F(OpenSees, travel_that_is_claimed_is_stood) {
  for (double const beta1 : {0.0, 50.0, 800.0, 6000.0, -50.0, -800.0})
    for (double const alpha : {40.0, 60.0, 140.0}) {
      auto const subject = subject_of("vaiana", vaiana_parameters(beta1, beta1 == 0.0 ? 0.0 : 12.0, alpha));
      auto const mapping = map_law(*subject.law, subject.parameters);
      ASSERT_FALSE(mapping.forms.empty());
      auto const& form = mapping.forms.front();
      ASSERT_TRUE(form.longest_travel_mm);
      auto const commands = in_units(form, unit_systems[0]);
      auto const tags = tags_of(commands);
      std::string script = "model basic -ndm 1 -ndf 1\n";
      for (std::size_t i = 0; i < commands.size(); ++i) {
        script += fmt::format("uniaxialMaterial {} {}", commands[i].name, tags[i].own + 1);
        for (auto const inner : tags[i].inner) script += fmt::format(" {}", inner + 1);
        script += argument_values(commands[i], " ") + "\n";
      }
      // The script moves over the stated travel in 37, 1000 and 20011 steps, from rest and from one side to the other.
      script += fmt::format(
          "uniaxialTest 1\nproc go {{from to steps}} {{\n  for {{set i 1}} {{$i <= $steps}} {{incr i}} {{\n"
          "    strainUniaxialTest [expr {{$from + ($to - $from) * double($i) / $steps}}]\n    set f [stressUniaxialTest]\n"
          "    if {{$f != $f}} {{puts \"no number between $from and $to\"; exit 2}}\n  }}\n}}\n"
          "foreach steps {{37 1000 20011}} {{\n  go 0.0 {0} $steps\n  go {0} 0.0 $steps\n  go 0.0 -{1} $steps\n  go -{1} {1} $steps\n"
          "  go {1} 0.0 $steps\n}}\n",
          *form.longest_travel_mm, 0.5 * *form.longest_swing_mm);
      write("travel.tcl", script);
      EXPECT_EQ(run_tcl("travel.tcl"), 0) << beta1 << " " << alpha << " " << *form.longest_travel_mm << read("printed");
      // The stated travel must not be much shorter than the travel at which OpenSees fails.
      EXPECT_GT(*form.longest_travel_mm * 1e-3 * alpha, 20.0) << beta1;
      EXPECT_GE(*form.longest_swing_mm, *form.longest_travel_mm) << beta1;
    }
}

}  // namespace
}  // namespace isolaw::programs_test
