// run.json: everything about a campaign that varies between runs of the same inputs and settings.
#pragma once

#include <ctime>
#include <string>

namespace isolaw::render {

struct RunFacts {
  std::string command, directory;
  std::time_t started_at = 0;
  double search_s = 0.0, total_s = 0.0;  // total: without the drawing of figures
  double figures_s = 0.0;
  int jobs = 0;
};

std::string run_json(RunFacts const& facts);

}  // namespace isolaw::render
