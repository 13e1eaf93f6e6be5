// Writes run.json. It has everything that differs if the same campaign is computed twice, such as times.
#pragma once

#include <ctime>
#include <string>

#include "isolaw/campaign/profile.hpp"

namespace isolaw::render {

struct RunFacts {
  std::string command, directory;
  std::time_t started_at = 0;
  double search_s = 0.0, total_s = 0.0;  // total_s excludes the drawing of figures
  double figures_s = 0.0;
  double cpu_s = 0.0;  // processor time of the process during total_s
  int jobs = 0;
  std::string profile;  // from profile_json()
};

std::string run_json(RunFacts const& facts);
// Returns a JSON array with one object for each phase of a campaign, which says how long the phase took.
std::string profile_json(campaign::Profile const& profile);

}  // namespace isolaw::render
