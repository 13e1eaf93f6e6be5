// Compares a campaign with the study whose laws and method isolaw uses (Cucuzza et al. 2025). It sets the numbers of
// Table A.5 beside the campaign's, and says which of the study's statements hold in the campaign.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The numbers of one law. They derive from means and standard deviations over the runs on every device.
struct PublishedNumbers {
  std::optional<double> objective;         // mean over the devices
  std::optional<double> std_over_runs;     // mean over the devices of the standard deviation over the runs
  std::optional<double> std_over_devices;  // standard deviation of the devices' means
  std::optional<double> beta;
  bool on_front = false;  // on the front of objective against beta, among the study's laws
};

struct PublishedLaw {
  int number = 0;         // the law's number in the study
  std::string law;        // isolaw's id; law 5 has two rows, one for each reading of its equations
  bool compared = false;  // the campaign has this law, and the statements are judged with this reading of it
  PublishedNumbers printed, computed;
};

struct PublishedStatement {
  std::string where;               // place in the study
  std::string text;                // the statement in isolaw's words
  bool holds_in_table = false;     // the statement holds in the study's own Table A.5
  std::optional<bool> holds_here;  // whether it holds in the campaign; empty if laws, beta or scatter are missing
  std::string found;               // the campaign's numbers, or what is missing
};

struct Published {
  std::string source, verdict;
  std::vector<PublishedLaw> laws;  // in the study's order; also laws that the campaign lacks
  std::vector<PublishedStatement> statements;
};

// Returns nullopt if fewer than two of the study's laws were identified in the campaign.
std::optional<Published> published(Summary const& summary);

}  // namespace isolaw::study
