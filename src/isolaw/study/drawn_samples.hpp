// Which samples of a long series are shown.
#pragma once

#include <cstddef>
#include <vector>

namespace isolaw::study {

// Indices of the samples shown of `samples`: all, or evenly thinned to at most `most`, first and last kept.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::study
