// Writes the outputs of a made-up lot for the browser tests: make_page DIR [DEVICES [LAWS [analysed|inadequate]]].
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/study_fixture.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: make_page DIR [DEVICES [LAWS [analysed|inadequate]]]\n";
    return 2;
  }
  int const devices = argc > 2 ? std::atoi(argv[2]) : 3;
  int const laws = argc > 3 ? std::atoi(argv[3]) : 3;
  try {
    auto summary = isolaw::study::fixture::lot(devices, laws);
    if (argc > 4 && std::string_view(argv[4]) == "analysed")
      summary = isolaw::study::fixture::analysed(std::move(summary));
    // The second law, on the front as published, misses the stiffness.
    if (argc > 4 && std::string_view(argv[4]) == "inadequate")
      for (auto& fit : summary.laws.at(1).devices) fit.K_eff_error_percent = 60.0;
    for (auto& law : summary.laws)
      for (auto& fit : law.devices)
        for (double const above : {1.3, 1.7})
          if (fit.objective.mean) fit.histories.push_back({above * *fit.objective.mean, *fit.objective.mean});
    // What a careful reader must be told of: a failed run, a coarse integration, a law that does not apply.
    summary.laws.back().devices.back().integration_shift = 0.0021;
    summary.laws.back().devices.front().failed_runs = 1;
    summary.laws.back().devices.front().failure = "the computed force became infinite";
    summary.devices.front().raw.warnings.push_back("the vertical load column is constant");
    isolaw::render::write_outputs(summary, argv[1]);
    std::cout << isolaw::render::ranking(summary);
  } catch (isolaw::Error const& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
