// Thins a long series of samples for figures and the page.
#pragma once

#include <cstddef>
#include <vector>

namespace isolaw::study {

// Indices of the samples to show: evenly thinned to at most `most`, and the last one as well. 0 keeps all samples.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::study
