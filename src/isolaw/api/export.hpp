// Exports a law of a campaign for an analysis program, for the command and Python.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw {

struct ExportOptions {
  std::string law, device, to;  // device: a name, or "lot"; to: one of programs::targets()
  Values acceptance;            // options of campaign::acceptance_table() that change the bounds
  std::optional<std::string> units, name;
  std::vector<std::string> motions;  // ground motions for comparing the law with its re-fit to the target
  Values stated;                     // the time step and unit of the motions: options of building::stated_table()
  Values model, seed;                // model: options of programs::model_table(); seed: for random draws
  bool anyway = false;               // export despite objections
};

struct ExportedLaw {
  std::string text;                 // the file
  std::vector<std::string> doubts;  // sentences about the law and its use, which the user has to read
};

// Throws Error for an unknown law, device or target, for options that do not go with the target, and for a law that is
// not fit for use unless `anyway` is set.
ExportedLaw export_law(campaign::Contents contents, ExportOptions const& options);

}  // namespace isolaw
