// The result tables as CSV: RFC 4180 (commas, quotes doubled, CRLF), units in the header, six significant digits
// (summary.json has them all). Text that a spreadsheet would run as a formula gets a leading apostrophe.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Layout of Table A.5 of Cucuzza et al. 2025: per law a row OF and one per parameter, per device mean and standard
// deviation over the runs; the parameter's spread over the lot, Delta_n of Eqs. (28)-(30). Bounds scaled from each
// record read "per device" (summary.json has them).
std::string parameters_csv(Summary const& summary);

// One row per law and device, the refused ones first: objective, runs, errors of the best fit, integration shift, why
// there is none, how many runs are missing.
std::string objective_csv(Summary const& summary);

// One row per law: mean objective, beta, front.
std::string robustness_csv(Summary const& summary);

// Layout of Table A.5 of Cucuzza et al. 2025: per law and device mean and standard deviation over the runs, and the
// value of the best run, of the objective and of every parameter.
std::string table_a5_csv(Summary const& summary);

// Fig. 14 in numbers: the laws by rising objective, which of them are not dominated, and by whom the others are.
std::string front_csv(Summary const& summary);

// One row per device, block and cycle, those that do not count included with the reason; a device without cycles has
// one row with the reason.
std::string cycles_csv(Summary const& summary);
// One row per device and limit of the rule set: value, design value, deviation, limit, verdict, reason.
std::string tests_csv(Summary const& summary);
std::string levels_csv(Summary const& summary);
std::string vertical_csv(Summary const& summary);
// One row per quantity of the lot: spread, sample, outliers, limits on the mean.
std::string lot_csv(Summary const& summary);
// One row per quantity and source of lambda_spec: factors, upper and lower bound values.
std::string lambda_csv(Summary const& summary);

// One cell of untrusted text, quoted where needed and never a formula.
std::string csv_cell(std::string_view text);

// What the tests determine: a row per law, device and free parameter; only the head without analyses.
std::string identifiability_csv(Summary const& summary);
// The laws without the optimiser's noise, with devices left out and blocks predicted: a row per law.
std::string converged_csv(Summary const& summary);
// One parameter vector for the lot, and the population: a row per law and parameter.
std::string lot_law_csv(Summary const& summary);
// Objectives of laws on what they were and were not fitted to: a row per law, device and part.
std::string prediction_csv(Summary const& summary);

}  // namespace isolaw::render
