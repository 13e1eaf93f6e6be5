// Computes how a re-fit changes the response of a building: a rigid mass on one bearing under a ground motion,
// integrated (building/integrate.hpp) once with the law and once with the law that was fitted in its place. Every
// export of a re-fit states this change.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

// The user is warned if the peak displacement or base shear with the re-fit differs from that with the law by more than
// this percentage. With building::motions_for_a_mean motions or more the means over the motions are compared, with
// fewer the peaks under each motion.
inline constexpr double response_off_percent = 10.0;
// If no vertical load is known, the mass is such that it has this period with the law's K_eff at the tested amplitude.
inline constexpr double usual_period_s = 2.5;

struct PeaksUnderMotion {
  std::string motion;
  double law_disp_mm = 0.0, law_shear_kN = 0.0, refit_disp_mm = 0.0, refit_shear_kN = 0.0;  // peaks
};

struct RefitResponse {
  std::vector<PeaksUnderMotion> motions;
  // FindingKind::refit_response, or refit_response_off if the difference is beyond the limit. The finding has the
  // difference between the mean peaks with the re-fit and with the law, and the least and largest difference under one
  // motion. If the integration fails under one motion, `finding` and `motions` are empty, and why_not has the reason.
  std::optional<Finding> finding;
  double mass_Mg = 0.0, period_s = 0.0;
  std::string mass_from, motions_from;
  std::string why_not;
};

// Computes the response of the building with the law once, to compare it with the responses with any number of re-fits.
// The ground motions are Subject::motions or, if there are none, the motion of Subject::model along x. Without a model
// they are the motions of building::example_motion(), each scaled so that the peak displacement with the law is the
// tested displacement, or up to 2 % less. The mass is the mean mass on a bearing of the model. Without a model it
// follows from the mean vertical load of the tests, or from usual_period_s if no load is known.
class BuildingOnLaw {
 public:
  explicit BuildingOnLaw(Subject const& subject);
  // `refit` names the re-fit in sentences.
  RefitResponse compare(std::string_view refit, laws::LawEntry const& law, std::span<double const> parameters) const;

 private:
  void fail(std::string why);

  std::string law_;
  std::vector<data::GroundMotion> motions_;
  RefitResponse on_law_;
};
// Lists the computed response for the head of a file.
std::string building_text(Subject const& subject, RefitResponse const& response, UnitSystem const& units);

}  // namespace isolaw::programs
