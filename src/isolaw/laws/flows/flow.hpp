// Flow gives the solution u(t) of the equation in saturating_flow.hpp. For a record it evaluates polynomials, for a
// trial it uses a table; law.hpp says what a record and a trial are.
#pragma once

#include "isolaw/laws/flows/saturating_flow.hpp"
#include "isolaw/laws/flows/trial_flow.hpp"

namespace isolaw::laws {

// T is the type of the parameters, X that of the motion.
template <class T, class X, Reach reach>
using Flow = std::conditional_t<std::is_same_v<X, double>, SaturatingFlow<T, reach>, online::Flow<reach>>;

}  // namespace isolaw::laws
