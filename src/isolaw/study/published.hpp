// The campaign beside the study whose laws and method it takes (Cucuzza et al. 2025): what that prints of its ten
// devices in Table A.5, the same of this campaign, and which of the study's statements hold here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Of one law, from means and standard deviations over the runs on every device.
struct PublishedNumbers {
  std::optional<double> objective;         // mean over the devices
  std::optional<double> std_over_runs;     // mean over the devices of the standard deviation over the runs
  std::optional<double> std_over_devices;  // of the devices' means
  std::optional<double> beta;
  bool on_front = false;  // of objective against beta, among the study's laws
};

struct PublishedLaw {
  int number = 0;         // the study's
  std::string law;        // of isolaw; two readings of law 5 are two rows
  bool compared = false;  // in the campaign, and the reading that statements are judged by
  PublishedNumbers printed, here;
};

struct PublishedStatement {
  std::string where;         // in the study
  std::string text;          // in our words
  bool in_table = false;     // holds in the study's own Table A.5
  std::optional<bool> here;  // empty: not judged, for want of laws or of beta
  std::string found;         // the numbers here; what is missing
};

struct Published {
  std::string source, verdict;
  std::vector<PublishedLaw> laws;  // by number; those that the campaign lacks too
  std::vector<PublishedStatement> statements;
};

// Where two of the study's laws at least were identified here.
std::optional<Published> published(Summary const& summary);

}  // namespace isolaw::study
