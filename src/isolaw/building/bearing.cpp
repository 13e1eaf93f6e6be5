#include "isolaw/building/bearing.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/online/online.hpp"
#include "isolaw/laws/plane/in_plane.hpp"

namespace isolaw::building {
namespace {

class InPlaneBearing final : public Bearing {
 public:
  InPlaneBearing(laws::InPlane law, laws::LawInfo const& info)
      : law_(std::move(law)), length_(info.length.in_record_units), force_(info.force.in_record_units) {}

  BearingForce trial(Vector const& to, Vector const& velocity, double dt) override {
    auto const force = law_.trial({to.x / length_, to.y / length_}, {velocity.x / length_, velocity.y / length_}, dt);
    BearingForce out{.force = {force_ * force.force.x, force_ * force.force.y}};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        out.by_displacement[i][j] = force.by_displacement[i][j] * force_ / length_;
        out.by_velocity[i][j] = force.by_velocity[i][j] * force_ / length_;
      }
    return out;
  }
  void commit() override { law_.commit(); }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<InPlaneBearing>(*this); }

 private:
  laws::InPlane law_;
  double length_, force_;
};

// A bearing that has never moved farther than this from its start counts as at rest.
constexpr double rest_mm = 1e-6;

// The law in one direction. Until the bearing first moves beyond `rest_mm`, the force follows the law's tangents at
// rest. Before that the bearing moves by rounding errors only, and laws with a power of the displacement give Newton's
// method no useful tangent there.
class OneDirection {
 public:
  OneDirection(laws::Online const& law, laws::LawInfo const& info)
      : law_(law), length_(info.length.in_record_units), force_(info.force.in_record_units), first_(law_.trial(0, 0)) {}

  laws::Online::Force trial(double x_mm, double v_mm_s) {
    goes_ = went_ || std::abs(x_mm) > rest_mm;
    double const x = x_mm / length_, v = v_mm_s / length_;
    auto force = goes_ ? law_.trial(x, v) : first_;
    if (!goes_) force.force += force.by_x * x + force.by_v * v;
    return {force_ * force.force, force_ / length_ * force.by_x, force_ / length_ * force.by_v};
  }
  void commit() {
    if (goes_) law_.commit();
    went_ = goes_;
  }

 private:
  laws::Online law_;
  double length_, force_;
  laws::Online::Force first_;
  bool went_ = false, goes_ = false;
};

// Whether the force at a displacement of `rest_mm` is more than twice what the tangent at rest predicts. The force is
// that large for laws with a power of the displacement whose slope at 0 is infinite, because these laws return a finite
// tangent there.
bool has_no_slope_at_rest(laws::Online law, laws::LawInfo const& info) {
  double const rest = rest_mm / info.length.in_record_units, slope = law.trial(0.0, 0.0).by_x;
  constexpr double much = 2.0;
  return law.trial(rest, 0.0).force > much * slope * rest;
}

// Springs around the circle, as laws::Springs, for a law for which has_no_slope_at_rest() is true. A spring at right
// angles to the motion moves by rounding errors only, and the law's force would be noise there. So each spring follows
// the chord of the law from 0 to `rest_mm` until the spring first moves beyond `rest_mm`. Exactly at 0 the tangent is
// still that of the law, because the longest integration step is chosen from it.
class RestingSprings final : public Bearing {
 public:
  RestingSprings(laws::Online const& law, laws::LawInfo const& info)
      : length_(info.length.in_record_units), force_(info.force.in_record_units), rest_(rest_mm / length_) {
    auto virgin = law;
    slope_ = virgin.trial(0.0, 0.0).by_x;
    chord_ = virgin.trial(rest_, 0.0).force / rest_;
    springs_.reserve(laws::usual_springs);
    for (int i = 0; i < laws::usual_springs; ++i) {
      double const angle = std::numbers::pi * i / laws::usual_springs;
      springs_.push_back({.along = {std::cos(angle), std::sin(angle)}, .law = law});
    }
  }

  BearingForce trial(Vector const& to, Vector const& velocity, double) override {
    BearingForce out{};
    for (auto& spring : springs_) {
      double const way = share_.way / length_;
      double const x = way * (to.x * spring.along[0] + to.y * spring.along[1]);
      double const v = way * (velocity.x * spring.along[0] + velocity.y * spring.along[1]);
      spring.goes = spring.went || std::abs(x) > rest_;
      auto const force =
          spring.goes ? spring.law.trial(x, v) : laws::Online::Force{chord_ * x, x == 0.0 ? slope_ : chord_, 0.0};
      double const of_law = share_.force * force_;
      out.force.x += of_law * force.force * spring.along[0];
      out.force.y += of_law * force.force * spring.along[1];
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
          double const both = of_law * way * spring.along[i] * spring.along[j];
          out.by_displacement[i][j] += both * force.by_x;
          out.by_velocity[i][j] += both * force.by_v;
        }
    }
    return out;
  }
  void commit() override {
    for (auto& spring : springs_) {
      if (spring.goes) spring.law.commit();
      spring.went = spring.goes;
    }
  }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<RestingSprings>(*this); }

 private:
  struct Spring {
    std::array<double, 2> along;
    laws::Online law;
    // Whether the spring has moved more than rest_ since the start: `went` up to the last commit, `goes` up to the last
    // trial.
    bool went = false, goes = false;
  };
  std::vector<Spring> springs_;
  laws::SpringShares share_ = laws::spring_shares(laws::usual_springs);
  double length_, force_, rest_, slope_ = 0.0, chord_ = 0.0;
};

class SeparateBearing final : public Bearing {
 public:
  SeparateBearing(laws::Online const& law, laws::LawInfo const& info) : x_(law, info), y_(law, info) {}

  BearingForce trial(Vector const& to, Vector const& velocity, double) override {
    auto const x = x_.trial(to.x, velocity.x), y = y_.trial(to.y, velocity.y);
    BearingForce out{.force = {x.force, y.force}};
    out.by_displacement[0][0] = x.by_x, out.by_displacement[1][1] = y.by_x;
    out.by_velocity[0][0] = x.by_v, out.by_velocity[1][1] = y.by_v;
    return out;
  }
  void commit() override { x_.commit(), y_.commit(); }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<SeparateBearing>(*this); }

 private:
  OneDirection x_, y_;
};

}  // namespace

Coupling coupling_of(std::string_view law, std::span<double const> parameters) {
  return laws::no_coupled_form(law, parameters) ? Coupling::springs : Coupling::coupled;
}

std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling,
                                      double dead_band_mm, int parts) {
  auto const& entry = laws::find_law(law);
  if (parameters.size() != entry.parameters.size())
    throw Error({.where = std::string(law),
                 .found = std::to_string(parameters.size()) + " parameters",
                 .allowed = std::to_string(entry.parameters.size())});
  if (coupling == Coupling::coupled)
    return std::make_unique<InPlaneBearing>(laws::InPlane::coupled(law, parameters), entry.info);
  laws::Online const online(law, parameters, dead_band_mm / entry.info.length.in_record_units, parts);
  if (coupling == Coupling::separate) return std::make_unique<SeparateBearing>(online, entry.info);
  if (has_no_slope_at_rest(online, entry.info)) return std::make_unique<RestingSprings>(online, entry.info);
  return std::make_unique<InPlaneBearing>(laws::InPlane::springs(online), entry.info);
}

}  // namespace isolaw::building
