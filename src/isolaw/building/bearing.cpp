#include "isolaw/building/bearing.hpp"

#include <tuple>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane.hpp"

namespace isolaw::building {
namespace {

template <class Law>
class Coupled final : public Bearing {
 public:
  explicit Coupled(std::span<double const> parameters)
      : params_(laws::unpack<typename Law::OneDirection, double>(parameters)),
        state_(Law::template start<double>(params_)) {}

  BearingForce trial(Vector const& to, Vector const&, double dt) override {
    constexpr double length = Law::info.length.in_record_units, force = Law::info.force.in_record_units;
    to_ = to;
    auto const scaled = [](Vector const& at) { return Vector{at.x / length, at.y / length}; };
    auto const made = laws::plane::force_and_tangent(Law{}, params_, state_, scaled(from_), scaled(to), dt);
    after_ = made.after;
    BearingForce out{.force = {force * made.force.x, force * made.force.y}};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) out.by_displacement[i][j] = made.tangent[i][j] * force / length;
    return out;
  }
  void commit() override {
    state_ = after_;
    from_ = to_;
  }
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<Coupled>(*this); }

 private:
  typename Law::template Params<double> params_;
  typename Law::template State<double> state_, after_{};
  Vector from_{0.0, 0.0}, to_{0.0, 0.0};
};

using Make = std::unique_ptr<Bearing> (*)(std::span<double const>);

template <class Law>
std::unique_ptr<Bearing> make_coupled(std::span<double const> parameters) {
  if constexpr (requires { Law::joint_limits; }) {
    auto const params = laws::unpack<typename Law::OneDirection, double>(parameters);
    for (auto const& limit : Law::joint_limits)
      if (!limit.holds(params))
        throw Error({.where = std::string(Law::info.id),
                     .found = "parameters without a form in two directions",
                     .allowed = std::string(limit.statement)});
  }
  return std::make_unique<Coupled<Law>>(parameters);
}

Make coupled_of(std::string_view law) {
  Make found = nullptr;
  [&]<class... Law>(std::tuple<Law...>*) {
    ((Law::info.id == law ? static_cast<void>(found = make_coupled<Law>) : static_cast<void>(0)), ...);
  }(static_cast<laws::plane::AllLaws*>(nullptr));
  return found;
}

}  // namespace

bool has_coupled_form(std::string_view law) {
  return coupled_of(law) != nullptr;
}

std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling) {
  auto const& entry = laws::find_law(law);
  if (parameters.size() != entry.parameters.size())
    throw Error({.where = std::string(law),
                 .found = std::to_string(parameters.size()) + " parameters",
                 .allowed = std::to_string(entry.parameters.size())});
  if (auto const make = coupled_of(law)) return make(parameters);
  throw Error({.where = std::string(law), .found = "no form in two directions", .allowed = "a law that has one"});
}

}  // namespace isolaw::building
