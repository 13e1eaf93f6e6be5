// What the analyses mean, in sentences: what changes without the optimiser's noise and why, what an engineer meets,
// what the tests leave open.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/study/findings.hpp"

namespace isolaw::study {

// What stands beside a key in a list whose keys stand in the order of their first appearance; added where it is not
// there.
template <class Key, class Of>
Of& beside(std::vector<std::pair<Key, Of>>& list, Key const& key) {
  auto const found = std::ranges::find(list, key, &std::pair<Key, Of>::first);
  return found != list.end() ? found->second : list.emplace_back(key, Of{}).second;
}

// For the first screen; empty without analyses.
std::vector<std::string> converged_sentences(Summary const& summary);

void warn_of_analysis(Summary const& summary, std::vector<Warning>& warnings);

}  // namespace isolaw::study
