// Lets the code in isolaw::render, which shows the results of a study, use the names of isolaw::study without a prefix.
#pragma once

#include "isolaw/study/summary.hpp"

namespace isolaw::render {

using namespace study;

}  // namespace isolaw::render
