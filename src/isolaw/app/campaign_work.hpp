// Computes the missing runs and analyses of a campaign, then writes the reports. The caller has locked the directory.
#pragma once

#include <chrono>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/profile.hpp"
#include "isolaw/render/figures/figures.hpp"

namespace isolaw::app {

struct WorkOptions {
  std::filesystem::path directory;
  int jobs = 0;
  std::optional<campaign::Part> share = {};  // if given, make only this part of the analyses and write no report
  render::FigureChoice figures = {};
  bool json = false, details = false;
};

// Does the work of a campaign. A command constructs this object when it starts, because all reported times are measured
// from the construction.
class CampaignWork {
 public:
  explicit CampaignWork(std::vector<std::string> const& command_line);
  int finish(campaign::Contents& contents, WorkOptions const& how);

 private:
  using Clock = std::chrono::steady_clock;

  // Returns whether all runs and analyses are complete. They may be complete even if the user interrupted the command.
  bool compute(campaign::Contents& contents, std::filesystem::path const& file, WorkOptions const& how);
  int write_reports(std::filesystem::path const& file, WorkOptions const& how);

  std::string command_;
  Clock::time_point start_;
  double cpu_at_start_s_;
  std::time_t started_at_;
  campaign::Profile profile_;
  campaign::Meter own_{&profile_};
};

}  // namespace isolaw::app
