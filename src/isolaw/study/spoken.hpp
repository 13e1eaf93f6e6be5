// Pieces of sentences in study: those of wording/words.hpp, and the name of a law of the summary.
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

// The law as sentences name it; its id is for what is typed.
inline std::string called(LawResult const& law) {
  return std::string(laws::called(law.id));
}

}  // namespace isolaw::study
