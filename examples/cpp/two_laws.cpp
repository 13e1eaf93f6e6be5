// Uses isolaw as a library: the program reads a record, fits two laws to it and prints which of them fits better. Build
// it against an installed isolaw with the CMakeLists.txt beside it. docs/python.md shows the same in Python.
//   two_laws RECORD
#include <algorithm>
#include <cstdio>
#include <isolaw/api/isolaw.hpp>

int main(int count, char** words) try {
  if (count != 2) throw isolaw::Error({.where = "two_laws", .found = "no file", .allowed = "two_laws RECORD"});
  auto const record = isolaw::data::read_record(words[1]);
  std::printf("%zu samples\n", record.size());

  isolaw::campaign::Settings settings;
  settings.laws = {"bilinear", "bouc-wen"};
  settings.analysis = false;
  auto const campaign = isolaw::calibrate({{.name = "bearing", .record = record}}, settings);
  auto const summary = isolaw::study::build_summary(campaign);
  for (auto const& law : summary.laws)
    std::printf("%-10s objective %.6f\n", law.id.c_str(), law.objective.best.value());

  auto const& better =
      *std::ranges::min_element(summary.laws, {}, [](auto const& law) { return law.objective.best.value(); });
  std::printf("better: %s\n", better.id.c_str());
  for (auto const& parameter : better.devices.front().parameters)
    std::printf("  %s = %g %s\n", parameter.name.c_str(), parameter.value.best.value(), parameter.unit.c_str());

  // Computes the force of the better law under another motion, which has half the displacements of the test.
  auto motion = isolaw::data::motion_of(record);
  for (double& x : motion.disp_mm) x *= 0.5;
  for (double& v : motion.vel_mm_s) v *= 0.5;
  auto const fitted = isolaw::fitted_law(campaign, better.id, "bearing");
  isolaw::fit::LawOnMotion const model(isolaw::laws::find_law(better.id), motion, fitted.integration);
  std::printf("largest force under half of it: %.3f kN\n", std::ranges::max(model.force_kN(fitted.parameters)));
  return 0;
} catch (isolaw::Error const& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
