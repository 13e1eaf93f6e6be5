// From a law to what a program can compute: the exact forms where their replay agrees with the law, else the nearest
// available law, fitted again, with its error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/programs/away.hpp"
#include "isolaw/programs/mapping.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

enum class Fidelity {
  exact,           // at every step
  exact_in_limit,  // as the step goes to zero
  refitted,        // another law, fitted to this one's force
  not_available
};
std::string_view name(Fidelity fidelity);

// How far a force is from another over a history, in percent.
struct Deviation {
  double largest = 0.0;                 // of the other's peak
  std::optional<double> at_s;           // when; empty without time
  std::size_t at_sample = 0;            // the same as a sample of the record, from 1
  double rms = 0.0;                     // root mean square over the samples, of the other's peak
  std::optional<double> K_eff, energy;  // of the reported cycle; without one, empty
};
// `other` is the reference; values that are not numbers in it are left out. A force that is no number gives infinity.
Deviation deviation(History const& history, std::span<double const> force_kN, std::span<double const> other_kN);
void keep_worst(Deviation& worst, Deviation const& other);

// A form with what its replay came to.
struct Realised {
  Form nominal;
  std::optional<Form> lower, upper;
  std::vector<std::pair<std::string, Form>> draws = {};  // by name, of a model's isolators (model_text.hpp)
  Deviation from_law;                                    // the worst over the histories, at the sampling of the records
  std::optional<Deviation> finer;                        // with steps finer_steps times smaller, where that matters
  std::optional<Deviation> from_measured;                // of a device's record
  std::vector<OtherCycle> other_cycles;                  // of a re-fit
  std::optional<StepsNeeded> steps;  // of a form that is exact as the step goes to zero; empty: none of those tried
  double longest_travel_mm = 0.0, longest_step_mm = 0.0;  // of the records: in one direction, and between samples
};
inline constexpr int finer_steps = 16;

struct Realisation {
  Fidelity fidelity = Fidelity::not_available;
  std::string explanation;      // one sentence: what is exact, or why it is not
  std::vector<Realised> forms;  // the first is the one to use
  std::string substitute;       // the law that was fitted in its place
  std::vector<double> substitute_parameters;
  std::vector<std::string> refused;         // forms whose replay failed, and how
  std::optional<Deviation> draws_from_law;  // the worst of a model's draws against its own law, on the first history
};

// Largest deviation from the law, in percent of the peak force, of a form that is called exact; and of one that is
// exact as the step goes to zero, with steps finer_steps times smaller than the records'.
inline constexpr double exact_percent = 1e-7, limit_percent = 0.5;
// A history this much longer than the tested one must still give a force.
inline constexpr double overtravel = 1.5;

// The laws that stand in where a program lacks one: that of a loop with a corner, and a smooth one.
inline constexpr std::string_view corner_law = "bilinear", smooth_law = "bouc-wen";

// A substitute that differs by more than this from the law at some sample or in the root mean square, in percent of the
// peak force, or misses its stiffness or energy by more than an adequate law may (study/adequacy.hpp), is far off.
inline constexpr double far_off_percent = 50.0, far_off_rms_percent = 10.0;
bool far_off(Deviation const& from_law);
bool far_off(std::vector<OtherCycle> const& cycles);

// The nearest parameters of another law to this law's force on the first history.
struct InPlace {
  laws::LawEntry const* law = nullptr;  // null: none gave a force
  std::vector<double> parameters;
  double objective = 0.0;
};
InPlace fit_in_place(Subject const& subject, std::string_view law, std::vector<fit::Override> const& overrides = {});

// How far a law with these parameters is from the subject's, the worst over the histories.
Deviation deviation_of_law(Subject const& subject, laws::LawEntry const& law, std::span<double const> parameters);

Realisation realise(Subject const& subject);

// Force of a form [kN] over displacements in mm, run in a unit system.
std::vector<double> replay_kN(Form const& form, UnitSystem const& units, std::span<double const> disp_mm);

// Refuses a form whose replay is not the law: "" where it agrees, else how it fails.
std::string failure_of(Form const& form, Subject const& subject, Realised& realised);

}  // namespace isolaw::programs
