#include "isolaw/programs/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::programs {
namespace {

double sign(double x) {
  return x < 0.0 ? -1.0 : 1.0;
}

// Arguments: Fy E0 b. The force changes elastically and is limited by two lines of slope b E0.
class Steel01 final : public Material {
 public:
  explicit Steel01(std::span<double const> a) : Fy_(a[0]), E0_(a[1]), b_(a[2]) {}
  double force(double x) override {
    double const middle = b_ * E0_ * x, reach = Fy_ * (1.0 - b_);
    force_ = std::clamp(force_ + E0_ * (x - x_), middle - reach, middle + reach);
    x_ = x;
    return force_;
  }

 private:
  double Fy_, E0_, b_, x_ = 0.0, force_ = 0.0;
};

// Arguments: Fy E0 b R0 cR1 cR2. From each reversal (xr, fr) a curve bends at the corner (x0, f0) to an asymptote.
class Steel02 final : public Material {
 public:
  explicit Steel02(std::span<double const> a)
      : Fy_(a[0]), E0_(a[1]), b_(a[2]), R0_(a[3]), cR1_(a[4]), cR2_(a[5]), highest_(Fy_ / E0_), lowest_(-highest_) {}
  double force(double x) override {
    if (x == x_) return f_;
    if (double const direction = sign(x - x_); direction != direction_) turn(direction);
    double const e = (x - xr_) / (x0_ - xr_);
    double const curve = b_ * e + (1.0 - b_) * e / std::pow(1.0 + std::pow(std::abs(e), R_), 1.0 / R_);
    x_ = x;
    return f_ = fr_ + (f0_ - fr_) * curve;
  }

 private:
  void turn(double direction) {
    double const xy = Fy_ / E0_, hardening = b_ * E0_;
    if (direction_ > 0.0) highest_ = std::max(highest_, x_);
    if (direction_ < 0.0) lowest_ = std::min(lowest_, x_);
    direction_ = direction;
    xr_ = x_;
    fr_ = f_;
    x0_ = (direction * (Fy_ - hardening * xy) - fr_ + E0_ * xr_) / (E0_ - hardening);
    f0_ = direction * Fy_ + hardening * (x0_ - direction * xy);
    double const xi = std::abs((direction > 0.0 ? highest_ : lowest_) - x0_) / xy;
    R_ = R0_ * (1.0 - cR1_ * xi / (cR2_ + xi));
  }

  double Fy_, E0_, b_, R0_, cR1_, cR2_, highest_, lowest_;
  double x_ = 0.0, f_ = 0.0, direction_ = 0.0, xr_ = 0.0, fr_ = 0.0, x0_ = 0.0, f0_ = 0.0, R_ = 0.0;
};

// Arguments: kInit qd alpha1 alpha2 mu. Adds the forces of an elastic-plastic part, a spring and a hardening spring.
class BearingPlasticity final : public Material {
 public:
  explicit BearingPlasticity(std::span<double const> a)
      : k_(a[0]), qd_(a[1]), alpha1_(a[2]), alpha2_(a[3]), mu_(a[4]) {}
  double force(double x) override {
    double const k0 = (1.0 - alpha1_) * k_, trial = k0 * (x - plastic_), q = std::clamp(trial, -qd_, qd_);
    plastic_ = x - q / k0;
    return q + alpha1_ * k_ * x + alpha2_ * k_ * sign(x) * std::pow(std::abs(x), mu_);
  }

 private:
  double k_, qd_, alpha1_, alpha2_, mu_, plastic_ = 0.0;
};

// Newton's rule in implicit_z() ends if the change of z is small enough, or fails after `most` iterations. The values
// are the defaults of OpenSees.
struct Iteration {
  double tolerance = 1e-8;  // the iteration ends if z changes by less
  int most = 20;
};

// Backward Euler for dz = dx (A - |z|^n (gamma + beta sgn(dx z))). NaN if Newton's rule fails, as in OpenSees.
double implicit_z(double z0, double dx, double A, double beta, double gamma, double n, double start,
                  Iteration const& iteration) {
  if (dx == 0.0) return z0;
  constexpr double least = std::numeric_limits<double>::epsilon();  // used in place of |z| if z is 0
  double z = start;
  for (int i = 0; i < iteration.most; ++i) {
    double const size = z == 0.0 ? least : std::abs(z), shape = gamma + beta * sign(dx * z);
    double const gap = z - z0 - dx * (A - std::pow(size, n) * shape);
    double const slope = 1.0 + dx * n * std::pow(size, n - 1.0) * (z == 0.0 ? 0.0 : sign(z)) * shape;
    double const change = gap / slope;
    z -= change;
    if (std::abs(change) <= iteration.tolerance) return z;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Arguments: alpha ko n gamma beta Ao deltaA deltaNu deltaEta [tol maxIter]. z is a length.
class BoucWen final : public Material {
 public:
  explicit BoucWen(std::span<double const> a) : alpha_(a[0]), k_(a[1]), n_(a[2]), gamma_(a[3]), beta_(a[4]), A_(a[5]) {
    if (a.size() > 10) iteration_ = {.tolerance = a[9], .most = static_cast<int>(a[10])};
    if (a[6] != 0.0 || a[7] != 0.0 || a[8] != 0.0)
      throw Error({.where = "BoucWen", .found = "deltaA, deltaNu or deltaEta", .allowed = "0: no degradation"});
  }
  double force(double x) override {
    constexpr double start = 0.01;  // OpenSees starts Newton's rule at z = 0.01, whatever the unit of length
    z_ = implicit_z(z_, x - x_, A_, beta_, gamma_, n_, start, iteration_);
    x_ = x;
    return alpha_ * k_ * x + (1.0 - alpha_) * k_ * z_;
  }

 private:
  double alpha_, k_, n_, gamma_, beta_, A_, x_ = 0.0, z_ = 0.0;
  Iteration iteration_;
};

// The Bouc-Wen law with a z that has no unit: a length divided by the yield displacement uy.
class DimensionlessBoucWen final : public Material {
 public:
  struct Parameters {
    double k, uy, qd, alpha1, alpha2, mu, eta, beta, gamma;
    Iteration iteration;
  };
  explicit DimensionlessBoucWen(Parameters const& p) : p_(p) {}
  double force(double x) override {
    z_ = implicit_z(z_, (x - x_) / p_.uy, 1.0, p_.beta, p_.gamma, p_.eta, z_, p_.iteration);
    x_ = x;
    return p_.qd * z_ + p_.alpha1 * p_.k * x + p_.alpha2 * p_.k * sign(x) * std::pow(std::abs(x), p_.mu);
  }

 private:
  Parameters p_;
  double x_ = 0.0, z_ = 0.0;
};

// In BoucWenOriginal and elastomericBearingBoucWen the third to eighth arguments are alpha1 alpha2 mu eta beta gamma.
DimensionlessBoucWen::Parameters with_shape(double k, double uy, double qd, std::span<double const> a,
                                            Iteration const& iteration) {
  return {k, uy, qd, a[2], a[3], a[4], a[5], a[6], a[7], iteration};
}

// Arguments of BoucWenOriginal: E fy alphaL alphaNL mu eta beta gamma [tol maxIter].
DimensionlessBoucWen::Parameters bouc_wen_original(std::span<double const> a) {
  double const uy = a[1] / a[0], qd = a[1] - a[2] * a[0] * uy - a[3] * a[0] * std::pow(uy, a[4]);
  return with_shape(a[0], uy, qd, a,
                    a.size() > 9 ? Iteration{.tolerance = a[8], .most = static_cast<int>(a[9])} : Iteration{});
}

// Arguments of elastomericBearingBoucWen: kInit qd alpha1 alpha2 mu eta beta gamma.
DimensionlessBoucWen::Parameters bearing_bouc_wen(std::span<double const> a) {
  return with_shape(a[0], a[1] / ((1.0 - a[2]) * a[0]), a[1], a,
                    {.tolerance = bearing_tolerance, .most = bearing_iterations});
}

// Arguments: ka kb fo b1 b2 gamma. After a long travel in one direction, rounding can make s * distance, whose
// logarithm is taken, negative. The force is then NaN.
class HystereticAsym final : public Material {
 public:
  explicit HystereticAsym(std::span<double const> a)
      : ka_(a[0]), kb_(a[1]), f0_(a[2]), b1_(a[3]), b2_(a[4]), g_(a[5]), a_((a[0] - a[1]) / (2.0 * a[2])) {}
  double force(double u) override {
    if (u == u_) return f_;
    double const s = sign(u - u_);
    double const distance = (elastic(u_) - f_) * std::exp(-g_ * u_) + kb_ * u_ + s * f0_;
    double const uj = s * u_ + std::log(s * a_ * distance / (ka_ - kb_)) / a_;
    f_ = elastic(u) + std::exp(g_ * u) * (kb_ * u + s * f0_ - s * (ka_ - kb_) / a_ * std::exp(-a_ * (s * u - uj)));
    u_ = u;
    return f_;
  }

 private:
  double elastic(double u) const { return std::exp(b1_ * u) - std::exp(-b2_ * u) - (b1_ + b2_) * u; }

  double ka_, kb_, f0_, b1_, b2_, g_, a_, u_ = 0.0, f_ = 0.0;
};

class Multiplier final : public Material {
 public:
  Multiplier(std::unique_ptr<Material> other, double factor) : other_(std::move(other)), factor_(factor) {}
  double force(double x) override { return factor_ * other_->force(x); }

 private:
  std::unique_ptr<Material> other_;
  double factor_;
};

class Parallel final : public Material {
 public:
  Parallel(std::unique_ptr<Material> one, std::unique_ptr<Material> other)
      : one_(std::move(one)), other_(std::move(other)) {}
  double force(double x) override { return one_->force(x) + other_->force(x); }

 private:
  std::unique_ptr<Material> one_, other_;
};

std::size_t inner_count(std::string_view name) {
  return name == "Multiplier" ? 1 : name == "Parallel" ? 2 : 0;
}

std::unique_ptr<Material> make_one(Command const& command, std::vector<std::unique_ptr<Material>> inner) {
  auto const& a = command.arguments;
  auto const expect = [&](std::size_t least, std::size_t most) {
    if (a.size() < least || a.size() > most)
      throw Error({.where = command.name,
                   .found = fmt::format("{} arguments after the tag", a.size()),
                   .allowed = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most)});
  };
  if (command.name == "Steel01") return expect(3, 3), std::make_unique<Steel01>(a);
  if (command.name == "Steel02") return expect(6, 6), std::make_unique<Steel02>(a);
  if (command.name == "BoucWen") return expect(9, 11), std::make_unique<BoucWen>(a);
  if (command.name == "BoucWenOriginal")
    return expect(8, 10), std::make_unique<DimensionlessBoucWen>(bouc_wen_original(a));
  if (command.name == "HystereticAsym") return expect(6, 6), std::make_unique<HystereticAsym>(a);
  if (command.name == "elastomericBearingPlasticity") return expect(5, 5), std::make_unique<BearingPlasticity>(a);
  if (command.name == "elastomericBearingBoucWen")
    return expect(8, 8), std::make_unique<DimensionlessBoucWen>(bearing_bouc_wen(a));
  if (command.name == "Multiplier") return expect(1, 1), std::make_unique<Multiplier>(std::move(inner[0]), a[0]);
  if (command.name == "Parallel")
    return expect(0, 0), std::make_unique<Parallel>(std::move(inner[0]), std::move(inner[1]));
  throw Error(
      {.where = command.name,
       .found = "no material that is replayed here",
       .allowed =
           "Steel01, Steel02, BoucWen, BoucWenOriginal, HystereticAsym, Multiplier of one before it, Parallel of two, elastomericBearingPlasticity, elastomericBearingBoucWen"});
}

}  // namespace

std::vector<Tags> tags_of(std::span<Command const> commands) {
  std::vector<Tags> all_tags;
  std::vector<std::size_t> free;  // tags of the materials that no command has taken yet
  for (std::size_t i = 0; i < commands.size(); ++i) {
    auto& tags = all_tags.emplace_back(Tags{.own = i + 1 == commands.size() ? 0 : i + 1, .inner = {}});
    auto const wanted = inner_count(commands[i].name);
    if (free.size() < wanted)
      throw Error({.where = commands[i].name,
                   .found = fmt::format("{} materials before it", free.size()),
                   .allowed = fmt::format("{}", wanted)});
    tags.inner.assign(free.end() - static_cast<std::ptrdiff_t>(wanted), free.end());
    free.resize(free.size() - wanted);
    free.push_back(tags.own);
  }
  if (free.size() != 1)
    throw Error({.where = "material",
                 .found = fmt::format("{} that nothing stands on", free.size()),
                 .allowed = "one: the last command"});
  return all_tags;
}

std::string refused_by_program(std::span<Command const> commands) {
  for (auto const& [name, a] : commands) {
    if (!std::ranges::all_of(a, [](double v) { return std::isfinite(v); })) return name + " takes numbers alone";
    if (name != "HystereticAsym" || a.size() < 3) continue;
    if (!(a[0] > 0.0)) return fmt::format("{} takes ka above 0, here {:.4g}", name, a[0]);
    if (!(a[1] < a[0])) return fmt::format("{} takes kb below ka, here {:.4g} and {:.4g}", name, a[1], a[0]);
    if (!(a[2] > 0.0)) return fmt::format("{} takes fo above 0, here {:.4g}", name, a[2]);
  }
  return {};
}

std::unique_ptr<Material> make_material(std::span<Command const> commands) {
  auto const tags = tags_of(commands);
  std::vector<std::unique_ptr<Material>> materials(commands.size());  // the index is the material's tag
  for (std::size_t i = 0; i < commands.size(); ++i) {
    std::vector<std::unique_ptr<Material>> inner;
    for (auto const tag : tags[i].inner) inner.push_back(std::move(materials[tag]));
    materials[tags[i].own] = make_one(commands[i], std::move(inner));
  }
  return std::move(materials.front());
}

std::vector<double> replay(std::span<Command const> commands, std::span<double const> disp) {
  auto const material = make_material(commands);
  std::vector<double> force;
  force.reserve(disp.size());
  for (double const x : disp) force.push_back(material->force(x));
  return force;
}

}  // namespace isolaw::programs
