// run.json: everything about a campaign that varies between runs of the same inputs and settings.
#pragma once

#include <ctime>
#include <string>
#include <string_view>

#include "isolaw/campaign/profile.hpp"

namespace isolaw::render {

struct RunFacts {
  std::string command, directory;
  std::time_t started_at = 0;
  double search_s = 0.0, total_s = 0.0;  // total: without the drawing of figures
  double figures_s = 0.0;
  double cpu_s = 0.0;  // processor time of the process meanwhile, likewise without figures
  int jobs = 0;
  std::string profile;  // as profile_json() writes it
};

std::string run_json(RunFacts const& facts);

// What a campaign spent its time on, an object for each phase, as an array of run.json.
std::string profile_json(campaign::Profile const& profile);
// summary.json with one more key at its end, "profile". summary.json itself holds no times.
std::string with_profile(std::string summary_json, std::string_view profile);

}  // namespace isolaw::render
