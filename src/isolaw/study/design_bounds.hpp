// The upper and the lower bound law over the design conditions of a lot file: the law with the largest and with the
// smallest K_eff and energy that its devices have under these conditions.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/conditions/bounds.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct DesignBound {
  double C_K = 1.0, C_E = 1.0;                            // K_eff and energy at the bound / at reference
  conditions::Status status = conditions::Status::shown;  // the weaker of the statuses of C_K and C_E
  double share_shown = 1.0;                               // the smaller Combined::share_shown of K_eff and energy
  conditions::BoundLaw law;
};

struct DesignBounds {
  std::optional<DesignBound> lower = {}, upper = {};  // both are set or neither
  std::optional<Finding> obstacle = {};               // why there are no bounds
};

// `parameters` are those of a device or of the lot. K_eff and energy are simulated in a block with the mean amplitude
// and frequency of the reference tests.
DesignBounds design_bounds(Summary const& summary, laws::LawEntry const& law, std::span<double const> parameters);

// The bound laws of a fitted law, for the outputs of a campaign.
struct LawBounds {
  std::string law = {};
  std::string device = {};  // the device whose parameters the fitted law has; empty if it has those of the lot
  DesignBounds bounds = {};
  // A reference cycle of the fitted law, and the forces of the bound laws at its displacements. Empty without bounds.
  conditions::CycleCurve reference = {};
  std::vector<double> lower_kN = {}, upper_kN = {};
};
// Returns an entry for each law that was fitted, in the order of the summary. A law has the parameters of the lot or,
// where there are none, those of the best run on the typical device.
std::vector<LawBounds> law_bounds(Summary const& summary);

// Says by which factors a bound law changes K_eff, energy and the elastic and hysteretic parts of the force. `which` is
// "upper" or "lower".
Finding about_bound(std::string_view which, DesignBound const& bound);

}  // namespace isolaw::study
