// The exact flow of a law with a hysteretic variable: polynomials for the lanes of a kernel, a table for single trials.
#pragma once

#include "isolaw/laws/online/flow.hpp"
#include "isolaw/laws/saturating_flow.hpp"

namespace isolaw::laws {

// T: number of the parameters, X: number of the motion.
template <class T, class X, Reach reach>
using Flow = std::conditional_t<std::is_same_v<X, double>, SaturatingFlow<T, reach>, online::Flow<reach>>;

}  // namespace isolaw::laws
