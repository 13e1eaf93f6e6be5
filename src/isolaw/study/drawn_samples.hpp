// Thins a long series of samples for figures and the page.
#pragma once

#include <cstddef>
#include <vector>

namespace isolaw::study {

// Indices of the samples to show: at most `most`, evenly thinned, and the last sample too. 0 keeps all samples.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::study
