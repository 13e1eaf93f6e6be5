// The list of laws. To add a law, include its header and add its type to AllLaws. The laws of Cucuzza et al. 2025 come
// first there, then all others in alphabetical order.
#pragma once

#include <tuple>

#include "isolaw/laws/abe.hpp"
#include "isolaw/laws/abe_y0.hpp"
#include "isolaw/laws/bilinear.hpp"
#include "isolaw/laws/bouc_wen.hpp"
#include "isolaw/laws/bwbn.hpp"
#include "isolaw/laws/gallardo.hpp"
#include "isolaw/laws/history_integral.hpp"
#include "isolaw/laws/hwang_wu.hpp"
#include "isolaw/laws/jankowski.hpp"
#include "isolaw/laws/kikuchi_aiken.hpp"
#include "isolaw/laws/menegotto_pinto.hpp"
#include "isolaw/laws/ozdemir.hpp"
#include "isolaw/laws/power_masing.hpp"
#include "isolaw/laws/power_masing_viscous.hpp"
#include "isolaw/laws/power_masing_worn.hpp"
#include "isolaw/laws/power_scragging.hpp"
#include "isolaw/laws/ramberg_osgood.hpp"
#include "isolaw/laws/vaiana.hpp"

namespace isolaw::laws {

using AllLaws = std::tuple<Bilinear, Jankowski, Vaiana, BoucWen, Abe, AbeY0, HwangWu, Bwbn, Gallardo, HistoryIntegral,
                           KikuchiAiken, MenegottoPinto, Ozdemir, PowerMasing, PowerMasingViscous, PowerMasingWorn,
                           PowerScragging, RambergOsgood>;

// Calls visit.template operator()<Law>() for every law, in the order of AllLaws.
template <class Visitor>
void for_each_law(Visitor&& visit) {
  [&]<class... Law>(std::tuple<Law...>*) { (visit.template operator()<Law>(), ...); }(static_cast<AllLaws*>(nullptr));
}

}  // namespace isolaw::laws
