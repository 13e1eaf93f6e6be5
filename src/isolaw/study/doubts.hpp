// What is known against one law of a campaign, for whoever takes it from there: exports and `simulate` say it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Doubts {
  // Warnings of findings.hpp that concern the law on the device: the campaign, the search, the parameters, the
  // prediction, the record.
  std::vector<std::string> warnings;
  // "good: objective .03 on the blocks it was not fitted to (...)", or that it was not asked for.
  std::string prediction;
  std::string objection;  // why it should not be taken at all; empty otherwise
};

// Of the law on one device; without a device, of the one law of the lot.
Doubts doubts(Summary const& summary, std::string_view law, std::optional<std::string_view> device);

}  // namespace isolaw::study
