// Gives the results of a study, which every renderer shows, their own names in isolaw::render.
#pragma once

#include "isolaw/study/summary.hpp"

namespace isolaw::render {

using namespace study;

}  // namespace isolaw::render
