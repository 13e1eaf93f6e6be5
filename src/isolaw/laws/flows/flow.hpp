// Flow solves the equation of a hysteretic variable exactly: by polynomials in kernels, from a table in single trials.
#pragma once

#include "isolaw/laws/flows/saturating_flow.hpp"
#include "isolaw/laws/flows/trial_flow.hpp"

namespace isolaw::laws {

// T is the type of the parameters, X that of the motion.
template <class T, class X, Reach reach>
using Flow = std::conditional_t<std::is_same_v<X, double>, SaturatingFlow<T, reach>, online::Flow<reach>>;

}  // namespace isolaw::laws
