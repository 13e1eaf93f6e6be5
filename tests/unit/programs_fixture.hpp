// Lets tests export laws without a campaign. Makes histories of sine cycles and, from such histories and the parameters
// of a law, a Subject, which is all that an export needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/realise.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs_test {

using namespace isolaw::programs;

// Returns one cycle of `samples` steps at each amplitude, from rest at zero.
inline History cycles(std::vector<double> const& amplitudes_mm, int samples, double frequency_Hz = 0.5) {
  History history;
  history.device = "D";
  double const omega = 2.0 * std::numbers::pi * frequency_Hz;
  for (std::size_t c = 0; c < amplitudes_mm.size(); ++c)
    for (int i = c == 0 ? 0 : 1; i <= samples; ++i) {
      double const phase = 2.0 * std::numbers::pi * i / samples;
      history.time_s.push_back((static_cast<double>(c) + static_cast<double>(i) / samples) / frequency_Hz);
      history.disp_mm.push_back(i == samples ? 0.0 : amplitudes_mm[c] * std::sin(phase));
      history.vel_mm_s.push_back(amplitudes_mm[c] * omega * std::cos(phase));
    }
  return history;
}

inline Subject subject_of(std::string_view law, std::vector<double> parameters, int samples = 200,
                          double amplitude_mm = 150.0) {
  Subject subject;
  subject.version = "test";
  subject.title = "a lot";
  subject.law = &laws::find_law(law);
  subject.device = "D";
  subject.parameters = std::move(parameters);
  subject.histories.push_back(cycles({0.3 * amplitude_mm, amplitude_mm, amplitude_mm}, samples));
  subject.protocol = check_path(amplitude_mm, 0.5, 0.0);
  for (auto* history : {&subject.histories[0], &subject.protocol})
    history->law_kN = law_force(*subject.law, subject.parameters, *history);
  subject.histories[0].measured_kN = subject.histories[0].law_kN;
  subject.tested.disp_mm = subject.design_disp_mm = amplitude_mm;
  subject.frequency_Hz = 0.5;
  subject.K_eff_kN_per_mm = 0.7;
  subject.damping_percent = 15.0;
  subject.bounds = {.lower = BoundFactors{.stiffness = 0.9, .strength = 0.8, .overall = 0.87, .separate = true},
                    .upper = BoundFactors{.stiffness = 1.1, .strength = 1.3, .overall = 1.15, .separate = true},
                    .source = "the test"};
  return subject;
}

inline std::vector<double> const bilinear_parameters{2.5, 0.4, 18.0};
inline std::vector<double> const menegotto_pinto_parameters{2.5, 40.0, 0.15, 4.0, 0.925, 0.15};
inline std::vector<double> const bouc_wen_parameters{0.2, 2.0, 1.3, 0.045, 1.2, 0.02};
// Returns Kb, f0, alpha, beta1 and beta2, each for loading and unloading, in N and m. The last six parameters, gamma1
// to gamma3, are zero, which leaves out the sigmoid of the law.
inline std::vector<double> vaiana_parameters(double beta1 = 0.0, double beta2 = 0.0, double alpha = 60.0) {
  return {6e5, 6e5, 25e3, 25e3, alpha, alpha, beta1, beta1, beta2, beta2, 0, 0, 0, 0, 0, 0};
}

inline double largest_difference(std::vector<double> const& a, std::vector<double> const& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = a[i] == a[i] ? std::max(largest, std::abs(a[i] - b[i])) : HUGE_VAL;
  return largest;
}
inline double peak_of(std::vector<double> const& force) {
  double peak = 0.0;
  for (double const f : force) peak = std::max(peak, std::abs(f));
  return peak;
}

// Returns the commands of one variant of a procedure, parsed from the text of a Tcl script.
inline std::vector<Command> commands_in(std::string const& script, std::string const& procedure,
                                        std::string const& variant) {
  std::vector<Command> commands;
  std::istringstream lines(script);
  std::string line, in_procedure, in_variant;
  while (std::getline(lines, line)) {
    // An expression such as [expr {$tag + 1}] is read as the single word $tag.
    for (std::size_t at = 0; (at = line.find("[expr {$tag + ")) != std::string::npos;)
      line.replace(at, line.find(']', at) + 1 - at, "$tag");
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    if (words.empty() || words[0] == "#") continue;
    if (words[0] == "proc") in_procedure = words[1];
    if (words.size() == 2 && words[1] == "{") in_variant = words[0];
    if (in_procedure != procedure || in_variant != variant) continue;
    if (words[0] != "uniaxialMaterial" && words[0] != "element") continue;
    std::size_t const tags = words[0] == "element" ? 5 : words[1] == "Multiplier" ? 4 : words[1] == "Parallel" ? 5 : 3;
    Command command{.name = words[1], .arguments = {}};
    for (std::size_t i = tags; i < words.size() && !words[i].starts_with("{*}"); ++i)
      command.arguments.push_back(std::stod(words[i]));
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace isolaw::programs_test
