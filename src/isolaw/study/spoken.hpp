// Short names for code in study that writes sentences: functions of wording/words.hpp, and the name of a law.
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
// The name of a law in sentences. Its id is for options and files.
inline std::string display_name(LawResult const& law) {
  return std::string(laws::display_name(law.id));
}

}  // namespace isolaw::study
