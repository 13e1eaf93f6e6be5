// Turns a law into a program's commands: exact forms if their replay agrees, else the nearest law fitted to this one.
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
  refitted,        // another law, fitted to the force of this one
  not_available
};
std::string_view name(Fidelity fidelity);

// The difference of one force from another.
struct Deviation {
  double largest = 0.0;                 // in percent of the reference's peak
  std::optional<double> at_s;           // time of the largest deviation; empty without time
  std::size_t at_sample = 0;            // sample of the largest deviation in the record, from 1
  double rms = 0.0;                     // root mean square over the samples, in percent of the reference's peak
  std::optional<double> K_eff, energy;  // errors in the reported cycle, in percent; empty without one
};
// `other` is the reference; points where it is NaN are left out. A force that is NaN gives infinity.
Deviation deviation(History const& history, std::span<double const> force_kN, std::span<double const> other_kN);
void keep_worst(Deviation& worst, Deviation const& other);
struct Realised {
  Form nominal;
  std::optional<Form> lower, upper;
  std::vector<std::pair<std::string, Form>> draws =
      {};                                  // a model's drawn isolators, by drawn_variant() (model_text.hpp)
  Deviation from_law;                      // the worst over the histories, at the records' sampling
  std::optional<Deviation> finer;          // the same in finer_steps times smaller steps, small_steps only
  std::optional<Deviation> from_measured;  // against the measured force
  std::vector<OtherCycle> other_cycles;    // only for a law that was fitted in place of this one
  std::optional<StepsNeeded> steps;        // small_steps only; empty also if no number tried was enough
  double longest_travel_mm = 0.0, longest_step_mm = 0.0;  // in the records: in one direction, and from sample to sample
};
inline constexpr int finer_steps = 16;

struct Realisation {
  Fidelity fidelity = Fidelity::not_available;
  std::string explanation;      // one sentence: what is exact, or why it is not
  std::vector<Realised> forms;  // the first is the one to use
  std::string substitute;       // id of the law that was fitted in place of the law; empty for an exact form
  std::vector<double> substitute_parameters;
  std::vector<std::string> refused;         // "form: how its replay failed"
  std::optional<Deviation> draws_from_law;  // the worst draw against its own law, on the first history
};

// Limits in percent of the peak force, at the records' steps and at steps finer_steps times smaller.
inline constexpr double exact_percent = 1e-7, limit_percent = 0.5;
// The form must still give a force if the isolator moves this many times as far as in the tests.
inline constexpr double overtravel = 1.5;

inline constexpr std::string_view corner_law = "bilinear", smooth_law = "bouc-wen";

// Percent of the peak force, at one sample and rms. far_off() also limits stiffness and energy (study/adequacy.hpp).
inline constexpr double far_off_percent = 50.0, far_off_rms_percent = 10.0;
bool far_off(Deviation const& from_law);
bool far_off(std::vector<OtherCycle> const& cycles);

struct Substitute {
  laws::LawEntry const* law = nullptr;  // null if no law gave a force
  std::vector<double> parameters;
  double objective = 0.0;
};
Substitute fit_substitute(Subject const& subject, std::string_view law,
                          std::vector<fit::Override> const& overrides = {});

// The worst deviation over the histories.
Deviation deviation_of_law(Subject const& subject, laws::LawEntry const& law, std::span<double const> parameters);

Realisation realise(Subject const& subject);

// Force of a form [kN] over displacements in mm, computed in the given unit system as the program would.
std::vector<double> replay_kN(Form const& form, UnitSystem const& units, std::span<double const> disp_mm);

// Replays a form into `realised`. Returns how the form differs from the law, "" if it agrees.
std::string failure_of(Form const& form, Subject const& subject, Realised& realised);

}  // namespace isolaw::programs
