// Computes a law for a motion that is not known ahead. Each trial starts from the last committed state.
#pragma once

#include "isolaw/laws/online/numbers.hpp"
#include "isolaw/laws/online/remembering.hpp"

namespace isolaw::laws {

template <class Law>
struct WithoutMemory {
  using LawState = typename Law::template State<Dual>;
  static Dual law_force(auto const& p, auto const& c, LawState& state, StepOf<Dual> const& step) {
    return Law::step(p, c, state, step);
  }
};
template <class Law>
using Follows = std::conditional_t<Law::info.traits.remembers, Remembering<Law>, WithoutMemory<Law>>;

template <class Law>
struct Motion {
  using Parameters = ParametersWithBand<Law>;
  using LawConstants = decltype(constants_of<Law, double, Dual>(Parameters()));
  using LawState = typename Follows<Law>::LawState;
  using Step = StepOf<Dual>;
  static Dual law_force(Parameters const& p, LawConstants const& c, LawState& state, Step const& step) {
    return Follows<Law>::law_force(p, c, state, step);
  }
  static LawState first_state(Parameters const& p, LawConstants const& c) {
    auto const first = laws::first_state<Law, double, Dual>(p, c, Step());
    if constexpr (Law::info.traits.remembers)
      return LawState{.law = first, .follower = {}, .x = 0.0, .memory = {}};
    else
      return first;
  }

  // `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
  // [export]
  // The state of a device: its law's memory of the motion, and its force, in the law's units.
  struct State {
    LawState law;
    double x = 0.0, v = 0.0, direction = 0.0;
    Dual peak;
    double force = 0.0, tangent = 0.0, damping = 0.0;
    template <class Each>
    void members(Each& each) {
      each(law, x, v, direction, peak, force, tangent, damping);
    }
  };

  // Computes the trial state: the motion starts at the committed state and is divided into `parts` equal steps.
  static void move(Parameters const& p, LawConstants const& c, State const& committed, double x1, double v1, int parts,
                   State& trial) {
    trial = committed;
    double const x0 = committed.x, v0 = committed.v;
    // Without motion the tangent is computed in the direction of the last motion.
    double const direction = x1 > x0 ? 1.0 : x1 < x0 ? -1.0 : committed.direction != 0.0 ? committed.direction : 1.0;
    Dual F, x_before = x0, v_before = v0;
    for (int k = 1; k <= parts; ++k) {
      double const t = static_cast<double>(k) / parts;
      Step step;
      step.x0 = x_before;
      step.v0 = v_before;
      step.x1 = Dual(k == parts ? x1 : x0 + t * (x1 - x0), t, 0.0);
      step.v1 = Dual(k == parts ? v1 : v0 + t * (v1 - v0), 0.0, t);
      step.dx = step.x1 - step.x0;
      step.direction = direction;
      step.length = direction * step.dx;
      step.reversal = direction != trial.direction;
      step.peak0 = trial.peak;
      // If x1 reaches the peak, the peak becomes x1 with its derivative, so that the tangent includes its growth.
      bool const new_peak = std::abs(step.x1.v) >= trial.peak.v && direction * step.x1.v >= 0.0;
      step.peak1 = new_peak ? direction * step.x1 : trial.peak;
      F = law_force(p, c, trial.law, step);
      trial.direction = direction;
      trial.peak = step.peak1;
      x_before = step.x1;
      v_before = step.v1;
    }
    if (x1 == x0) {  // at rest only the velocity can change the state
      if (v1 == v0) trial.law = committed.law;
      trial.direction = committed.direction;
      trial.peak = committed.peak;
    }
    trial.x = x1;
    trial.v = v1;
    trial.force = F.v;
    trial.tangent = F.by_x;
    trial.damping = F.by_v;
  }

  // The trial becomes the committed state, which has no derivatives.
  static void keep(State& trial, State& committed) {
    Members settled([](double&) {});
    settled(trial);
    committed = trial;
  }
  // [end]
};

}  // namespace isolaw::laws
