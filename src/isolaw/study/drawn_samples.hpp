// Thins a long series of samples for figures and the page.
#pragma once

#include <cstddef>
#include <vector>

namespace isolaw::study {

// Indices of the samples to show: all, or evenly thinned to at most `most`, and the last besides; `most` 0 keeps all.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::study
