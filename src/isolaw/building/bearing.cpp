#include "isolaw/building/bearing.hpp"

#include <string>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/in_plane.hpp"
#include "isolaw/laws/online.hpp"

namespace isolaw::building {
namespace {

class InPlaneBearing final : public Bearing {
 public:
  InPlaneBearing(laws::InPlane law, laws::LawInfo const& info)
      : law_(std::move(law)), length_(info.length.in_record_units), force_(info.force.in_record_units) {}

  BearingForce trial(Vector const& to, Vector const& velocity, double dt) override {
    auto const made = law_.trial({to.x / length_, to.y / length_}, {velocity.x / length_, velocity.y / length_}, dt);
    BearingForce out{.force = {force_ * made.force.x, force_ * made.force.y}};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        out.by_displacement[i][j] = made.by_displacement[i][j] * force_ / length_;
        out.by_velocity[i][j] = made.by_velocity[i][j] * force_ / length_;
      }
    return out;
  }
  void commit() override { law_.commit(); }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<InPlaneBearing>(*this); }

 private:
  laws::InPlane law_;
  double length_, force_;
};

class SeparateBearing final : public Bearing {
 public:
  SeparateBearing(laws::Online const& law, laws::LawInfo const& info)
      : x_(law), y_(law), length_(info.length.in_record_units), force_(info.force.in_record_units) {}

  BearingForce trial(Vector const& to, Vector const& velocity, double) override {
    auto const x = x_.trial(to.x / length_, velocity.x / length_), y = y_.trial(to.y / length_, velocity.y / length_);
    BearingForce out{.force = {force_ * x.force, force_ * y.force}};
    double const per = force_ / length_;
    out.by_displacement[0][0] = per * x.by_x, out.by_displacement[1][1] = per * y.by_x;
    out.by_velocity[0][0] = per * x.by_v, out.by_velocity[1][1] = per * y.by_v;
    return out;
  }
  void commit() override { x_.commit(), y_.commit(); }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<SeparateBearing>(*this); }

 private:
  laws::Online x_, y_;
  double length_, force_;
};

}  // namespace

Coupling coupling_of(std::string_view law, std::span<double const> parameters) {
  return laws::no_coupled_form(law, parameters) ? Coupling::springs : Coupling::coupled;
}

std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling) {
  auto const& entry = laws::find_law(law);
  if (parameters.size() != entry.parameters.size())
    throw Error({.where = std::string(law),
                 .found = std::to_string(parameters.size()) + " parameters",
                 .allowed = std::to_string(entry.parameters.size())});
  if (coupling == Coupling::coupled)
    return std::make_unique<InPlaneBearing>(laws::InPlane::coupled(law, parameters), entry.info);
  laws::Online const online(law, parameters);
  if (coupling == Coupling::separate) return std::make_unique<SeparateBearing>(online, entry.info);
  return std::make_unique<InPlaneBearing>(laws::InPlane::springs(online), entry.info);
}

}  // namespace isolaw::building
