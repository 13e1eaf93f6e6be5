// Makes the tables of results as CSV by RFC 4180 (commas, doubled quotes, CRLF). Units are in the header. Numbers have
// six significant digits; summary.json has all digits. A text that a spreadsheet would run as a formula gets a leading
// apostrophe.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns numbers as in Table A.5 of Cucuzza et al. 2025, but with laws as rows. Each law has a row OF and a row for
// each parameter, with mean and standard deviation over the runs for each device. The last two columns are the
// parameter's spread over the lot, Delta_n of Eqs. (28)-(30), and the devices on which the best run lies at a bound.
// The cell of a bound that is scaled from each record says "per device"; summary.json has these bounds.
std::string parameters_csv(Summary const& summary);
// Returns a table with a row for each law and device, refused devices first. The columns are the objective, the runs,
// the errors of the properties, the error of integration, and the reason why a result is missing.
std::string objective_csv(Summary const& summary);
std::string robustness_csv(Summary const& summary);
// Returns a table in the form of Table A.5 of Cucuzza et al. 2025. For each law and device it has the objective and
// every parameter: mean and standard deviation over the runs, and the value of the best run.
std::string table_a5_csv(Summary const& summary);
// Returns the numbers of a plot like Fig. 14 of the paper: the laws, sorted by rising objective, and for each law the
// laws that dominate it.
std::string front_csv(Summary const& summary);
// Returns a table with a row for each device, block and cycle. If a cycle does not count or a device has no cycles, the
// row says why.
std::string cycles_csv(Summary const& summary);
// Returns a table with a row for each device and limit of the rule set. The columns are value, design value, deviation,
// limit, verdict and reason.
std::string tests_csv(Summary const& summary);
std::string levels_csv(Summary const& summary);
std::string vertical_csv(Summary const& summary);
// Returns a table with a row for each quantity of the lot. The columns are spread, sample, outliers and limits on the
// mean.
std::string lot_csv(Summary const& summary);
std::string lambda_csv(Summary const& summary);
// Returns a cell with text from the user. It is in quotes if necessary, and a spreadsheet never takes it for a formula.
std::string csv_cell(std::string_view text);
// Returns a table of identifiability and intervals with a row for each law, device and free parameter. Without analyses
// it has only the header.
std::string identifiability_csv(Summary const& summary);
std::string converged_csv(Summary const& summary);
std::string lot_law_csv(Summary const& summary);
// Returns a table with several rows for each law and device. The first rows have objectives on the fitted part of the
// tests, with parameters fitted to the device itself, to the lot and so on. Further rows have the objective on each
// block.
std::string prediction_csv(Summary const& summary);

}  // namespace isolaw::render
