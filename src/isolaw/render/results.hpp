// What every renderer draws: the results of a study, called by their own names.
#pragma once

#include "isolaw/study/summary.hpp"

namespace isolaw::render {

using namespace study;

}  // namespace isolaw::render
