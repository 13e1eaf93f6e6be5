#include "isolaw/study/drawn_samples.hpp"

#include <algorithm>

namespace isolaw::study {

std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most) {
  std::vector<std::size_t> drawn;
  std::size_t const stride = most == 0 ? 1 : std::max<std::size_t>(1, (samples + most - 1) / most);
  for (std::size_t i = 0; i < samples; i += stride) drawn.push_back(i);
  if (samples > 0 && drawn.back() != samples - 1) drawn.push_back(samples - 1);
  return drawn;
}

}  // namespace isolaw::study
