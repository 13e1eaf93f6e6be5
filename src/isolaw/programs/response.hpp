// Computes how a re-fit changes the response of a building: a rigid mass on one bearing under a ground motion,
// integrated (building/integrate.hpp) once with the law and once with the law that was fitted in its place. Every
// export of a re-fit states it.
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

// Beyond this difference of the peak displacement or base shear, in percent of the law's, the user is warned: of the
// mean over building::motions_for_a_mean motions or more, else under any motion.
inline constexpr double response_off_percent = 10.0;
// Period of the mass with the law's K_eff at the tested amplitude, if no vertical load is known.
inline constexpr double usual_period_s = 2.5;

struct UnderMotion {
  std::string motion;
  double law_disp_mm = 0.0, law_shear_kN = 0.0, refit_disp_mm = 0.0, refit_shear_kN = 0.0;  // peaks
};

struct RefitResponse {
  std::vector<UnderMotion> motions;
  // refit_response, or refit_response_off: how far the means of the re-fit's peaks over the motions are off those of
  // the law, and the least and the most under one motion. If one motion has no result, there is none, no motion is
  // listed, and why_not says why.
  std::optional<Finding> finding;
  double mass_Mg = 0.0, period_s = 0.0;
  std::string mass_from, motions_from;
  std::string why_not;
};

// The building on the law. The motions are Subject::motions, else the one of Subject::model along x. Without either
// they are building::example_motion, each scaled so that the law moves to the tested displacement, or up to 2 % less
// far. The mass is that which the model puts on a bearing, else that of the mean vertical load of the tests, else the
// one of usual_period_s.
class BuildingOnLaw {
 public:
  explicit BuildingOnLaw(Subject const& subject);
  // `refit` names the re-fit in sentences.
  RefitResponse with(std::string_view refit, laws::LawEntry const& law, std::span<double const> parameters) const;

 private:
  void fail(std::string why);

  std::string law_;
  std::vector<data::GroundMotion> motions_;
  RefitResponse on_law_;
};
// Lists the computed response for the head of a file.
std::string building_text(Subject const& subject, RefitResponse const& response, UnitSystem const& units);

}  // namespace isolaw::programs
