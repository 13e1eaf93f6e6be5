// Result tables as CSV after RFC 4180 (commas, quotes doubled, CRLF), with units in the header and six significant
// digits (summary.json has all digits). Text that a spreadsheet would run as a formula gets a leading apostrophe.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Table A.5 of Cucuzza et al. 2025 with laws as rows. Each law has a row OF and a row for each parameter, with mean and
// standard deviation over the runs for each device. The last two columns are the parameter's spread over the lot,
// Delta_n of Eqs. (28)-(30), and the devices on which the best run lies at a bound. The cell of a bound that is scaled
// from each record says "per device"; summary.json has these bounds.
std::string parameters_csv(Summary const& summary);
// A row for each law and device, refused devices first: objective, runs, errors of properties, integration error, and
// the reason why a result is missing.
std::string objective_csv(Summary const& summary);
std::string robustness_csv(Summary const& summary);
// After Table A.5 of Cucuzza et al. 2025: for each law and device the mean, the standard deviation over the runs and
// the best run's value of the objective and of every parameter.
std::string table_a5_csv(Summary const& summary);
// Fig. 14 in numbers: the laws by rising objective, and the laws that dominate each of them.
std::string front_csv(Summary const& summary);
// A row for each device, block and cycle. If a cycle does not count or a device has no cycles, the row says why.
std::string cycles_csv(Summary const& summary);
// A row for each device and limit of the rule set: value, design value, deviation, limit, verdict, reason.
std::string tests_csv(Summary const& summary);
std::string levels_csv(Summary const& summary);
std::string vertical_csv(Summary const& summary);
// A row for each quantity of the lot: spread, sample, outliers, limits on the mean.
std::string lot_csv(Summary const& summary);
std::string lambda_csv(Summary const& summary);
// A cell of untrusted text: quoted if needed, never a formula.
std::string csv_cell(std::string_view text);
// Identifiability and intervals, with a row for each law, device and free parameter. Without analyses only the header.
std::string identifiability_csv(Summary const& summary);
std::string converged_csv(Summary const& summary);
std::string lot_law_csv(Summary const& summary);
// A row for each law, device and part of the tests: the objective on the fitted part, then on each block.
std::string prediction_csv(Summary const& summary);

}  // namespace isolaw::render
