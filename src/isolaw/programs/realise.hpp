// Expresses a law by commands of an analysis program. The commands count as exact if a replay of them, computed here,
// agrees with the law. Without such commands, another law that was fitted to this one (a substitute) takes its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/programs/mapping.hpp"
#include "isolaw/programs/response.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/programs/untested_motions.hpp"

namespace isolaw::programs {

enum class Fidelity {
  exact,           // agrees with the law at every step
  exact_in_limit,  // approaches the law as the step goes to zero
  refitted,        // another law, fitted to the forces of the exported one
  not_available
};
std::string_view name(Fidelity fidelity);

// How far a force differs from a reference force.
struct Deviation {
  double largest = 0.0;                 // largest difference, in percent of the reference's peak force
  std::optional<double> at_s;           // time of the largest difference; empty for a record without times
  std::size_t at_sample = 0;            // number of the sample with the largest difference, from 1
  double rms = 0.0;                     // root mean square of the samples, in percent of the reference's peak force
  std::optional<double> K_eff, energy;  // differences in the reported cycle, in percent; empty without such a cycle
};
// Points where the reference `other_kN` is NaN are left out. A `force_kN` that is NaN gives an infinite deviation.
Deviation deviation(History const& history, std::span<double const> force_kN, std::span<double const> other_kN);
void keep_worst(Deviation& worst, Deviation const& other);
struct Realised {
  Form nominal;
  std::optional<Form> lower = {}, upper = {};
  std::vector<std::pair<std::string, Form>> draws =
      {};                   // forms of the drawn laws, named by drawn_variant() (model_text.hpp)
  Deviation from_law = {};  // deviation from the law, largest over all histories, in steps up to replayed_step_mm
  // Deviation from the law with steps that are finer_steps times smaller than those for from_law. Only for
  // Exactness::small_steps, and not for a substitute.
  std::optional<Deviation> finer = {};
  std::optional<Deviation> from_measured = {};  // deviation from the measured force
  std::vector<OtherCycle> other_cycles = {};    // only for a substitute
  std::optional<StepsNeeded> steps = {};        // only for small_steps; empty if no number of steps was enough
  // The records' longest travel in one direction, and their longest step between two samples.
  double longest_travel_mm = 0.0, longest_step_mm = 0.0;
  double replayed_step_mm = 0.0;  // longest step of the replay; a substitute's steps are cut as its file demands
};
inline constexpr int finer_steps = 16;

struct Realisation {
  Fidelity fidelity = Fidelity::not_available;
  std::string explanation;      // a sentence that says what is exact, or why nothing is
  std::vector<Realised> forms;  // the preferred form is first
  std::string substitute;       // id of the law that was fitted instead of the subject's law; "" if none
  std::vector<double> substitute_parameters;
  RefitResponse response;                   // how the substitute changes the response of a building
  std::vector<std::string> refused;         // rejected forms, each with the reason: "form: how its replay failed"
  std::optional<Deviation> draws_from_law;  // largest deviation of a form from its drawn law, on the first history
};

// The commands of a form count as exact if their force differs from the law's by at most this percentage of the peak
// force: exact_percent at every step, or limit_percent at finer steps if the program integrates an equation.
inline constexpr double exact_percent = 1e-7, limit_percent = 0.5;
// The commands must also give a finite force if the isolator moves this many times as far as in the tests.
inline constexpr double overtravel = 1.5;

inline constexpr std::string_view corner_law = "bilinear", smooth_law = "bouc-wen";

// Limits of far_off() on the largest difference at a sample and on the rms difference, in percent of the peak force.
// The limits on the differences of K_eff and energy are in study/adequacy.hpp.
inline constexpr double far_off_percent = 50.0, far_off_rms_percent = 10.0;
bool far_off(Deviation const& from_law);
bool far_off(std::vector<OtherCycle> const& cycles);

struct Substitute {
  laws::LawEntry const* law = nullptr;  // null if the fit found no parameters with a finite force
  std::vector<double> parameters;
  double objective = 0.0;
};
Substitute fit_substitute(Subject const& subject, std::string_view law,
                          std::vector<fit::Override> const& overrides = {});

// Returns the largest deviation of `law` from the subject's law over all histories.
Deviation deviation_of_law(Subject const& subject, laws::LawEntry const& law, std::span<double const> parameters);

Realisation realise(Subject const& subject);

// Computes the force in kN of a form, the commands that stand for a law in a program. The commands get their arguments
// and displacements in `units`, and the force is computed as the program would compute it.
std::vector<double> replay_kN(Form const& form, UnitSystem const& units, std::span<double const> disp_mm);

// Replays a form and stores the result in `realised`. Returns how the form differs from the law, or "" if it agrees.
std::string failure_of(Form const& form, Subject const& subject, Realised& realised);

}  // namespace isolaw::programs
