// Computes a law that remembers its path (trait `remembers`) for a motion that is not known ahead.
#pragma once

#include "isolaw/laws/memory/followed.hpp"
#include "isolaw/laws/memory/remembered.hpp"

namespace isolaw::laws {

// The parameters of a law, and the dead band of the record that it was fitted to. Only laws with the trait `remembers`
// use the dead band.
template <class Law>
struct ParametersWithBand : ParamsOf<Law, double> {
  double dead_band = 0.0;
};

template <class Law>
struct Remembering {
  using Parameters = ParametersWithBand<Law>;
  using LawConstants = decltype(constants_of<Law, double, Dual>(Parameters()));
  using OwnState = typename Law::template State<Dual>;
  using Memory = typename Law::template Memory<Dual>;
  using Step = StepOf<Dual>;

  // `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
  // [export]
  // The state of the law, the motion without its noise (`follower`, x), and what the law remembers of it (`memory`).
  struct LawState {
    OwnState law;
    Followed<Dual> follower;
    Dual x;
    Memory memory;
    template <class Each>
    void members(Each& each) {
      each(law, follower, x, memory);
    }
  };

  static Dual follow(Parameters const& p, LawConstants const& c, LawState& state, Step step) {
    step.x0 = state.x;
    step.x1 = state.follower.move(step.x1, p.dead_band);
    state.x = step.x1;
    state.memory.move(step.x0, step.x1, step.direction);
    step.dx = step.x1 - step.x0;
    step.direction = state.memory.direction;
    step.length = step.direction * step.dx;
    return Law::step(p, c, state.law, step, state.memory);
  }

  static Dual law_force(Parameters const& p, LawConstants const& c, LawState& state, Step const& step) {
    double const pulled_to = state.follower.pulled.v;
    Dual F = follow(p, c, state, step);
    if (p.dead_band <= 0.0 || state.follower.pulled.v != pulled_to) return F;
    // Within the dead band the force does not change, and a tangent of 0 would make the matrix of an analysis singular.
    // The tangent is therefore taken outside the band, a tenth of the band beyond its end in the direction of motion.
    // It is not taken at the very end, because the slope may have no bound there.
    LawState beyond = state;
    Members settled([](double&) {});
    settled(beyond);
    Step out = step;
    out.x1 = Dual(pulled_to + 1.1 * step.direction * p.dead_band, 1.0, 0.0);
    F.by_x = follow(p, c, beyond, out).by_x;
    return F;
  }
  // [end]
};

}  // namespace isolaw::laws
