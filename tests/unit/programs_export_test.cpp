// Tests exported scripts: reads the commands back from the text of a script and computes the force that they give.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "unit/programs_box.hpp"

namespace isolaw::programs_test {
namespace {

// Computes the force in kN along a history with the commands of a procedure in a script.
std::vector<double> of_script(std::string const& script, std::string const& procedure, std::string const& variant,
                              UnitSystem const& units, History const& history) {
  auto const commands = commands_in(script, procedure, variant);
  std::vector<double> disp;
  for (double const x : history.disp_mm) disp.push_back(units.from_mm(x));
  auto force = replay(commands, disp);
  for (double& f : force) f *= units.force.in_record_units;
  return force;
}

struct Case {
  std::string law;
  std::vector<double> parameters;
  std::vector<std::string> procedures;
  double tolerance;  // as a share of the peak force
};

std::vector<Case> exact_cases() {
  return {{"bilinear", bilinear_parameters, {"material", "bearing"}, 1e-12},
          {"menegotto-pinto", menegotto_pinto_parameters, {"material"}, 1e-12},
          {"vaiana", vaiana_parameters(), {"material"}, 1e-9},
          {"vaiana", vaiana_parameters(800.0, 12.0), {"material"}, 1e-9},
          // One backward Euler step per sample, at 200 samples per cycle, computes Bouc-Wen within 3 %.
          {"bouc-wen", bouc_wen_parameters, {"material", "material_original", "bearing"}, 0.03},
          {"vaiana", vaiana_parameters(), {"material_bouc_wen", "material_original", "bearing"}, 0.03}};
}

// If the replay of a script has no deviation, there is no worst sample, so the text must name none.
TEST(Deviations, of_an_exact_replay_have_no_place) {
  EXPECT_EQ(deviation_text({}).find("(at "), std::string::npos) << deviation_text({});
  Deviation some;
  some.largest = 1.0;
  some.at_sample = 7;
  EXPECT_NE(deviation_text(some).find("(at sample 7)"), std::string::npos) << deviation_text(some);
}

TEST(Scripts, give_the_laws_force_when_read_back_in_every_unit_system) {
  for (auto const& c : exact_cases()) {
    auto const subject = subject_of(c.law, c.parameters);
    auto const& history = subject.histories[0];
    auto const realisation = realise(subject);
    for (auto const& procedure : c.procedures) {
      std::vector<double> in_kN_mm;
      for (auto const& units : unit_systems) {
        SCOPED_TRACE(c.law + " " + procedure + " " + std::string(units.id));
        auto const script = opensees_script(subject, realisation, units);
        auto const force = of_script(script, procedure, "nominal", units, history);
        ASSERT_EQ(force.size(), history.law_kN.size());
        EXPECT_LE(largest_difference(force, history.law_kN), c.tolerance * peak_of(history.law_kN));
        if (in_kN_mm.empty()) in_kN_mm = force;
        // In other units the force must be the same up to rounding errors.
        EXPECT_LE(largest_difference(force, in_kN_mm), 1e-9 * peak_of(in_kN_mm));
      }
    }
  }
}

TEST(Scripts, bouc_wen_in_smaller_steps_is_the_law) {
  auto const subject = subject_of("bouc-wen", bouc_wen_parameters);
  auto const script = opensees_script(subject, realise(subject), unit_systems[1]);
  auto const fine = subject_of("bouc-wen", bouc_wen_parameters, 200 * 64).histories[0];
  for (auto const* procedure : {"material", "material_original", "bearing"})
    EXPECT_LE(largest_difference(of_script(script, procedure, "nominal", unit_systems[1], fine), fine.law_kN),
              5e-4 * peak_of(fine.law_kN))
        << procedure;
}

// The bounds scale two parts of the force separately: the part that grows with displacement and the hysteretic part.
TEST(Scripts, bounds_scale_stiffness_and_strength) {
  for (auto const& c : exact_cases()) {
    if (c.tolerance > 0.01 || c.parameters == vaiana_parameters(800.0, 12.0)) continue;
    auto const subject = subject_of(c.law, c.parameters);
    auto const script = opensees_script(subject, realise(subject), unit_systems[0]);
    auto const& history = subject.histories[0];
    auto const& p = c.parameters;
    double const K = c.law == "bilinear" ? p[1] : c.law == "menegotto-pinto" ? p[2] * p[0] : p[0] * 1e-6;
    for (auto const& [variant, factors] :
         {std::pair{"lower", *subject.bounds.lower}, {"upper", *subject.bounds.upper}}) {
      auto const force = of_script(script, "material", variant, unit_systems[0], history);
      for (std::size_t i = 0; i < force.size(); ++i) {
        double const spring = K * history.disp_mm[i], rest = history.law_kN[i] - spring;
        ASSERT_NEAR(force[i], factors.stiffness * spring + factors.strength * rest, 1e-9) << c.law << " " << variant;
      }
    }
  }
}

TEST(Scripts, carry_the_force_that_their_own_material_must_give) {
  for (auto const& c : exact_cases()) {
    auto const subject = subject_of(c.law, c.parameters);
    for (auto const& units : unit_systems) {
      auto const script = opensees_script(subject, realise(subject), units);
      auto const list = [&](std::string const& after) {
        auto const from = script.find(after);
        EXPECT_NE(from, std::string::npos) << after;
        auto const begin = script.find('{', from) + 1;
        std::istringstream text(script.substr(begin, script.find('}', begin) - begin));
        std::vector<double> values;
        for (double v; text >> v;) values.push_back(v);
        return values;
      };
      auto const disp = list("variable disp {");
      ASSERT_EQ(disp.size(), subject.protocol.disp_mm.size());
      for (auto const* variant : {"nominal", "lower", "upper"}) {
        auto const force = replay(commands_in(script, c.procedures[0], variant), disp);
        auto const expected = list("set expected(" + c.procedures[0] + "," + variant + ") {");
        EXPECT_LE(largest_difference(force, expected), 1e-8 * peak_of(expected)) << c.law << " " << variant;
      }
    }
  }
}

TEST(Replays, find_a_wrong_order_of_arguments) {
  for (auto const* id : {"material", "material_original", "bearing"}) {
    auto const subject = subject_of("bouc-wen", bouc_wen_parameters);
    auto forms = map_law(*subject.law, subject.parameters).forms;
    auto const form = std::ranges::find(forms, std::string(id), &Form::id);
    Realised realised;
    ASSERT_EQ(failure_of(*form, subject, realised), "");
    auto& arguments = form->commands[0].arguments;
    auto const gamma = std::ranges::find(arguments, std::string("gamma"), &Argument::name);
    auto const beta = std::ranges::find(arguments, std::string("beta"), &Argument::name);
    std::swap(gamma->value, beta->value);
    EXPECT_NE(failure_of(*form, subject, realised), "") << id;
  }
}

// The replay of the exported commands must also find the error if gamma and beta are too large by the same factor, as
// with a wrong unit.
TEST(Replays, find_a_wrong_normalisation) {
  auto const subject = subject_of("bouc-wen", bouc_wen_parameters);
  auto form = map_law(*subject.law, subject.parameters).forms[0];
  form.commands[0].arguments[3].value *= 1.1;
  form.commands[0].arguments[4].value *= 1.1;
  Realised realised;
  EXPECT_NE(failure_of(form, subject, realised), "");
}

// The force of OpenSees' HystereticAsym becomes NaN if the device travels further than about 35 / alpha in one
// direction. isolaw then exports a Bouc-Wen material with exponent 1, which gives the same force. If the law hardens,
// no other material gives the same force, and isolaw fits a Bouc-Wen law instead.
TEST(Replays, refuse_the_material_that_turns_into_no_number) {
  auto const fast = subject_of("vaiana", vaiana_parameters(0.0, 0.0, 150.0));  // alpha times travel is 45
  auto const realisation = realise(fast);
  ASSERT_FALSE(realisation.refused.empty());
  EXPECT_NE(realisation.refused[0].find("HystereticAsym"), std::string::npos);
  EXPECT_NE(realisation.refused[0].find("NaN"), std::string::npos);
  EXPECT_EQ(realisation.fidelity, Fidelity::exact_in_limit);
  EXPECT_EQ(realisation.forms[0].nominal.id, "material_bouc_wen");

  // With this alpha, HystereticAsym still works at the travel of the test, but at 1.5 times that travel it would fail.
  auto const beyond = realise(subject_of("vaiana", vaiana_parameters(0.0, 0.0, 90.0)));
  ASSERT_FALSE(beyond.refused.empty());
  EXPECT_NE(beyond.refused[0].find("1.5 times as far"), std::string::npos) << beyond.refused[0];

  auto const hardening = realise(subject_of("vaiana", vaiana_parameters(800.0, 12.0, 150.0)));
  EXPECT_EQ(hardening.fidelity, Fidelity::refitted);
  EXPECT_NE(hardening.explanation.find("NaN"), std::string::npos);
}

TEST(Refits, say_their_error_and_are_the_same_again) {
  auto parameters = vaiana_parameters();
  parameters[1] *= 1.05;  // unloading differs from loading
  auto const subject = subject_of("vaiana", parameters);
  auto const realisation = realise(subject), again = realise(subject);
  ASSERT_EQ(realisation.fidelity, Fidelity::refitted);
  EXPECT_EQ(realisation.substitute_parameters, again.substitute_parameters);
  EXPECT_EQ(realisation.substitute, "bouc-wen");
  auto const& error = realisation.forms[0].from_law;
  EXPECT_GT(error.rms, 0.1);
  EXPECT_LT(error.rms, 5.0);
  // The stated error of the fit must be the error of the written script.
  auto const script = opensees_script(subject, realisation, unit_systems[2]);
  auto const force = of_script(script, "material", "nominal", unit_systems[2], subject.histories[0]);
  EXPECT_NEAR(100.0 * largest_difference(force, subject.histories[0].law_kN) / peak_of(subject.histories[0].law_kN),
              error.largest, 1e-6);
}

// Returns the numbers of each line below the head. Comment lines are left out.
std::vector<std::vector<double>> rows_of(std::string const& csv, std::string& head) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ")) continue;
    if (head.empty()) {
      head = line;
      continue;
    }
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

// The path swings from D to -D in the steps 60 to 100. A bilinear law with the strength Qd = (K1 - K2) xy there has the
// stiffness K_eff = K2 + Qd / D.
TEST(Tables, hold_the_protocol_and_the_force_in_every_unit_system) {
  auto const subject = subject_of("bilinear", bilinear_parameters);
  for (auto const& units : unit_systems) {
    SCOPED_TRACE(units.id);
    std::string head;
    auto const rows = rows_of(protocol_csv(subject, units), head);
    EXPECT_EQ(head, "time [s],displacement [" + std::string(units.length.symbol) + "],velocity [" +
                        std::string(units.length.symbol) + "/s],force [" + std::string(units.force.symbol) + "]");
    ASSERT_EQ(rows.size(), subject.protocol.disp_mm.size());
    double const D = 150.0 / units.length.in_record_units, omega = std::numbers::pi;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].size(), 4u);
      EXPECT_NEAR(rows[i][0], 0.025 * static_cast<double>(i), 1e-9);
      EXPECT_LE(std::abs(rows[i][1]), D * (1.0 + 1e-9));
      EXPECT_LE(std::abs(rows[i][2]), omega * D * (1.0 + 1e-9));
      if (i < 60 || i > 100) continue;
      double const phase = std::numbers::pi / 40.0 * static_cast<double>(i - 60);
      EXPECT_NEAR(rows[i][1], D * std::cos(phase), 1e-9 * D);
      EXPECT_NEAR(rows[i][2], -D * omega * std::sin(phase), 1e-8 * D);
    }
    EXPECT_EQ(rows.front(), (std::vector<double>{0.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(rows.back()[1], 0.0);
    double const K_eff = (rows[60][3] - rows[100][3]) / (rows[60][1] - rows[100][1]);
    EXPECT_NEAR(K_eff * units.force.in_record_units / units.length.in_record_units, 0.4 + 2.1 * 18.0 / 150.0, 1e-9);
  }
}

TEST(Tables, say_in_their_head_what_they_hold) {
  auto subject = subject_of("jankowski", {4e5, 6e6, -2e8, -9e5, 18.0, 1.3e6, 23.0, 6.8, 3e4, 5e5, 0.33});
  subject.objective = 0.0123;
  auto const text = protocol_csv(subject, unit_systems[2]);
  auto const head = text.substr(0, text.find("\ntime "));
  EXPECT_TRUE(head.starts_with("# SPDX-License-Identifier: MIT-0\n# Licence: ")) << head;
  for (auto const* part : {"# Law: jankowski: ", "# Parameters: ", "# Fitted to the tests with: objective 0.0123",
                           "# Units of this file: kip, in, s", "# Protocol: from rest at zero, which the first row is",
                           "with its velocity, on which the law depends", "# Upper bound: force x 1.15"})
    EXPECT_NE(head.find(part), std::string::npos) << part << " is missing in\n" << head;
  EXPECT_EQ(protocol_csv(subject_of("bilinear", bilinear_parameters), unit_systems[0]).find("with its velocity"),
            std::string::npos);
}

// Materials of analysis programs start at rest. The first row must be at rest too, or a law that depends on the
// velocity would begin with a force that no program can give.
TEST(Tables, of_laws_that_depend_on_velocity_begin_at_rest) {
  for (auto const& law : laws::catalogue()) {
    if (law.info.traits.rate_independent) continue;
    auto const text = protocol_csv(subject_of(law.info.id, inside_box(law, 0.35)), unit_systems[0]);
    EXPECT_NE(text.find("from rest at zero, which the first row is"), std::string::npos) << text.substr(0, 3000);
    std::string head;
    auto const rows = rows_of(text, head);
    EXPECT_EQ(rows[0], (std::vector<double>{0.0, 0.0, 0.0, 0.0})) << law.info.id;
    EXPECT_GT(rows[1][2], 0.0);
    EXPECT_NE(rows[1][3], 0.0);
  }
}

TEST(Sheets, write_the_equations_as_they_are) {
  Remarks remarks;
  auto const text = value_sheet(subject_of("bouc-wen", bouc_wen_parameters), unit_systems[0], remarks);
  std::string_view const formula = laws::find_law("bouc-wen").info.formula;
  EXPECT_NE(text.find("```\n" + std::string(formula.substr(0, formula.find('\n'))) + "\n"), std::string::npos);
  EXPECT_NE(text.find("|z|^n"), std::string::npos);
  EXPECT_EQ(text.find("_z_"), std::string::npos);
}

// A stiffness of 1e310 kN/mm is no number, so no link has a force.
TEST(Sheets, without_a_link_refer_to_none) {
  for (auto const& law : laws::catalogue()) {
    if (law.info.traits.rate_independent) continue;
    auto subject = subject_of(law.info.id, inside_box(law, 0.35));
    for (double& x : subject.histories[0].disp_mm) x *= 1e-160;
    for (double& f : subject.histories[0].law_kN) f *= 1e150;
    Remarks remarks;
    auto const text = value_sheet(subject, unit_systems[0], remarks);
    ASSERT_EQ(remarks.objections.size(), 1u);
    EXPECT_EQ(remarks.objections[0], "no link of these programs could be fitted in the law's place");
    for (auto const* word : {"links above", "Errors below", "no model below"})
      EXPECT_EQ(text.find(word), std::string::npos) << word << " in\n" << text;
  }
}

// The CSI link has a control displacement and a control strength for each memory of the law: K, g, S, D, s, u.
TEST(Sheets, give_the_loops_of_history_integral) {
  Remarks remarks;
  auto const text =
      value_sheet(subject_of("history-integral", {60.0, 0.8, 20.0, 40.0, 0.25, 0.1}), unit_systems[1], remarks);
  for (auto const* row : {"| Control strain D 1 | m | 0.04 |", "| Control strength S 1 | N | 15000 | 12000 | 19500 |",
                          "| Control strain D 2 | m | 0.004 |", "| Control strength S 2 | N | 5000 |",
                          "| Resistance | N/m | 553265 |", "that could not be read"})
    EXPECT_NE(text.find(row), std::string::npos) << row << " is missing in\n" << text;
  auto const other = value_sheet(subject_of("bilinear", bilinear_parameters), unit_systems[1], remarks);
  EXPECT_EQ(other.find("Control strain"), std::string::npos);
  EXPECT_NE(other.find("High Damping Rubber Isolator**: not available"), std::string::npos);
}

// isolaw also computes forces on the path from zero to the first sample and at turning points between samples. These
// points do not count in the root mean square.
TEST(Refits, root_mean_square_counts_each_sample_once) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  History const history{.device = "D",
                        .time_s = {0.0, 0.0, 1.0, 1.5, 2.0},
                        .disp_mm = {0.0, 0.1, 5.0, 6.0, 4.0},
                        .vel_mm_s = {1.0, 1.0, 1.0, 0.0, -1.0},
                        .measured_kN = {none, 2.0, 10.0, none, 8.0},
                        .law_kN = {2.0, 2.0, 10.0, 12.0, 8.0}};
  std::vector<double> const force{0.0, 0.0, 11.0, 9.0, 8.0};
  double const rms_kN = std::sqrt((4.0 + 1.0 + 0.0) / 3.0);
  EXPECT_NEAR(deviation(history, force, history.law_kN).rms, 100.0 * rms_kN / 12.0, 1e-12);
  EXPECT_NEAR(deviation(history, force, history.measured_kN).rms, 100.0 * rms_kN / 10.0, 1e-12);
  // The largest deviation is taken over all points at which isolaw computes forces.
  EXPECT_NEAR(deviation(history, force, history.law_kN).largest, 100.0 * 3.0 / 12.0, 1e-12);
}

TEST(Names, tell_campaigns_and_units_apart) {
  auto subject = subject_of("bouc-wen", bouc_wen_parameters);
  EXPECT_EQ(identifier(subject, unit_systems[0]), "isolaw_bouc_wen_a_lot_D_kN_mm");
  subject.title = "Bearings of the viaduct, delivery 2";
  EXPECT_EQ(identifier(subject, unit_systems[1]), "isolaw_bouc_wen_Bearings_of_the_viad_D_N_m");
  subject.name = "pier_7";
  EXPECT_EQ(identifier(subject, unit_systems[1]), "pier_7");
  EXPECT_NO_THROW(require_export_name("pier_7"));
  EXPECT_NO_THROW(require_export_name(std::string(40, 'a')));
  for (auto const& wrong : {"", "7a", "_a", "a_", "a__b", "a b", "a-b", "a;b", "é", "class", "std"})
    EXPECT_THROW(require_export_name(wrong), Error) << wrong;
  EXPECT_THROW(require_export_name(std::string(41, 'a')), Error);
}

TEST(Scripts, are_not_broken_by_hostile_names) {
  auto subject = subject_of("bilinear", bilinear_parameters);
  subject.device = "x\\\n[exec rm]\"\"\"; } {$a`b`\r # '''";
  subject.title = "t\\";
  auto const tcl = opensees_script(subject, realise(subject), unit_systems[0]);
  auto const python = openseespy_script(subject, realise(subject), unit_systems[0]);
  for (auto const* text : {&tcl, &python}) {
    std::istringstream lines(*text);
    bool found = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.find("exec rm") == std::string::npos) continue;
      found = true;
      EXPECT_TRUE(line.starts_with("# ")) << line;
      EXPECT_EQ(line.find_first_of("\\[]{}$`\"\r"), std::string::npos) << line;
    }
    EXPECT_TRUE(found);
    EXPECT_EQ(text->find("\\\n"), std::string::npos);
  }
  EXPECT_EQ(identifier(subject, unit_systems[0])
                .find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"),
            std::string::npos);
}

}  // namespace
}  // namespace isolaw::programs_test
