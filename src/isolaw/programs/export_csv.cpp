// Writes the self-check's displacements and the law's forces as CSV, for programs that have no export of their own.
#include <fmt/format.h>

#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/text.hpp"

namespace isolaw::programs {
namespace {

std::string cell(double value) {
  return fmt::format("{:.10g}", value);
}

}  // namespace

std::string protocol_csv(Subject const& subject, UnitSystem const& units) {
  auto const& path = subject.protocol;
  auto all =
      facts_of_the_law(subject, units, "any program", "the force is that of the law itself, as isolaw computes it");
  all.push_back(
      {"Protocol",
       fmt::format(
           "from rest at zero, which the first row is, swings up to half and to the whole tested amplitude, and smaller ones within them; {} steps to a cycle of {:.4g} Hz",
           protocol_steps, subject.frequency_Hz)});
  all.push_back(
      {"To check",
       fmt::format("impose the displacement{} and compare the force",
                   subject.law->info.traits.rate_independent ? "" : " with its velocity, on which the law depends,")});
  std::string text;
  for (auto const& line : fact_lines(all)) text += "# " + line + "\n";
  text += fmt::format("time [s],displacement [{0}],velocity [{0}/s],force [{1}]\n", units.length.symbol,
                      units.force.symbol);
  for (std::size_t i = 0; i < path.disp_mm.size(); ++i)
    text += fmt::format("{},{},{},{}\n", cell(path.time_s[i]), cell(units.from_mm(path.disp_mm[i])),
                        cell(units.from_mm(path.vel_mm_s[i])), cell(units.from_kN(path.law_kN[i])));
  return text;
}

}  // namespace isolaw::programs
