// Thins a long series of samples for figures and the page.
#pragma once

#include <cstddef>
#include <vector>

namespace isolaw::study {

// Indices of evenly spaced samples to show, at most `most`, plus the last sample. With `most` = 0 all samples.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::study
