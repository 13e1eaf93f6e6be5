// Helpers for sentences in study: those of wording/words.hpp, and the name of a law in the summary.
#pragma once

#include <string>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/summary.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::study {

using wording::capitalised;
using wording::enumerate;
using wording::percent;
using wording::with_decimals;
// The name by which sentences call a law; its id is for what a user types.
inline std::string called(LawResult const& law) {
  return std::string(laws::called(law.id));
}

}  // namespace isolaw::study
