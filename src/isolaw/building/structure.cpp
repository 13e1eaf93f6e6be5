#include "isolaw/building/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "isolaw/data/channels/ground_motion.hpp"

namespace isolaw::building {
namespace {

constexpr double gravity = data::gravity_mm_s2 / 1e3;  // weight of 1 Mg in kN

void check_slab(Diaphragm const& slab, std::string const& name, std::vector<Complaint>& complaints) {
  auto const positive = [&](double value, std::string_view what, std::string_view unit) {
    if (!(value > 0.0) || !std::isfinite(value))
      complaints.push_back(
          {.where = name, .found = fmt::format("{} = {} {}", what, value, unit), .allowed = "a positive number"});
  };
  positive(slab.mass_Mg, "mass", "Mg");
  positive(slab.gyration_mm, "radius of gyration", "mm");
  if (!std::isfinite(slab.centre.x_mm) || !std::isfinite(slab.centre.y_mm))
    complaints.push_back({.where = name, .found = "a centre of mass that is no point", .allowed = "finite numbers"});
}

void check_storey(Storey const& storey, std::string const& name, std::vector<Complaint>& complaints) {
  bool const finite =
      storey.stiffness.allFinite() && std::isfinite(storey.centre.x_mm) && std::isfinite(storey.centre.y_mm);
  if (!finite || !(num::symmetric_eigen(storey.stiffness).values.minCoeff() > 0.0) ||
      !storey.stiffness.isApprox(storey.stiffness.transpose()))
    complaints.push_back({.where = name,
                          .found = "a storey below it that is not stiff in every direction",
                          .allowed = "a symmetric, positive definite stiffness"});
}

void require_valid(Frame const& frame) {
  std::vector<Complaint> complaints;
  check_slab(frame.base, "base", complaints);
  for (std::size_t i = 0; i < frame.floors.size(); ++i) {
    auto const name = fmt::format("floor {}", i + 1);
    check_slab(frame.floors[i].slab, name, complaints);
    check_storey(frame.floors[i].below, name, complaints);
  }
  for (double const ratio : frame.damping)
    if (!(ratio >= 0.0 && ratio < 1.0))
      complaints.push_back({.where = "damping", .found = fmt::format("{}", ratio), .allowed = "0 <= ratio < 1"});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

Vector3 masses_of(Diaphragm const& slab) {
  double const mass = slab.mass_Mg * Mg_in_mass;
  return {mass, mass, mass * slab.gyration_mm * slab.gyration_mm};
}

}  // namespace

Matrix3 carried(Point from, Point at) {
  Matrix3 transform = Matrix3::Identity();
  transform(0, 2) = -(at.y_mm - from.y_mm);
  transform(1, 2) = at.x_mm - from.x_mm;
  return transform;
}

Storey storey(double x_kN_mm, double y_kN_mm, double rotation_kNmm, Point centre) {
  Storey result{.centre = centre};
  result.stiffness.diagonal() << x_kN_mm, y_kN_mm, rotation_kNmm;
  return result;
}

std::vector<Floor> equal_floors(std::size_t count, Diaphragm const& slab, double period_x_s, double period_y_s,
                                double rotation_ratio) {
  using std::numbers::pi;
  // A chain of n equal masses m and springs k has the first frequency 2 sqrt(k/m) sin(pi / (4 n + 2)).
  double const factor = 2.0 * std::sin(pi / (4.0 * static_cast<double>(count) + 2.0));
  auto const stiffness = [&](double period_s) {
    double const rate = 2.0 * pi / (period_s * factor);
    return slab.mass_Mg * Mg_in_mass * rate * rate;
  };
  double const x = stiffness(period_x_s), y = stiffness(period_y_s);
  double const arm = rotation_ratio * slab.gyration_mm;
  return std::vector<Floor>(count, Floor{.below = storey(x, y, std::min(x, y) * arm * arm, slab.centre), .slab = slab});
}

Structure::Structure(Frame frame) : frame_(std::move(frame)) {
  require_valid(frame_);
  auto const n = static_cast<Eigen::Index>(3 * floors());
  masses_ = num::Vector::Zero(n + 3);
  stiffness_ = num::Matrix::Zero(n + 3, n + 3);
  masses_.head<3>() = masses_of(frame_.base);
  num::Matrix deformation = num::Matrix::Zero(n, n + 3), rigid = num::Matrix::Zero(n, 3);
  for (std::size_t i = 0; i < floors(); ++i) {
    auto const& [below, slab] = frame_.floors[i];
    auto const row = static_cast<Eigen::Index>(3 * i);
    masses_.segment<3>(row + 3) = masses_of(slab);
    auto const& under = i == 0 ? frame_.base : frame_.floors[i - 1].slab;
    deformation.block<3, 3>(row, row) = -carried(under.centre, below.centre);
    deformation.block<3, 3>(row, row + 3) = carried(slab.centre, below.centre);
    auto const part = deformation.middleRows<3>(row);
    stiffness_ += part.transpose() * below.stiffness * part;
    rigid.middleRows<3>(row) = carried(frame_.base.centre, slab.centre);
  }
  base_mass_ = masses_.head<3>().asDiagonal();
  mass_ = base_mass_;
  if (n == 0) return;
  num::Vector const upper = masses_.tail(n);
  mass_ += num::Matrix(rigid.transpose() * upper.asDiagonal() * rigid);
  find_modes(deformation, rigid);
}

void Structure::find_modes(num::Matrix const& deformation, num::Matrix const& rigid) {
  auto const n = rigid.rows();
  num::Vector const upper = masses_.tail(n), root = upper.cwiseSqrt().cwiseInverse();
  num::Matrix const scaled = root.asDiagonal() * stiffness_.bottomRightCorner(n, n) * root.asDiagonal();
  auto const eigen = num::symmetric_eigen(scaled);
  num::Matrix const shapes = root.asDiagonal() * eigen.vectors;
  num::Matrix const gamma = shapes.transpose() * upper.asDiagonal() * rigid;
  num::Matrix const drift = deformation.rightCols(n) * shapes;
  auto const row_major = [](num::Matrix const& from, std::vector<double>& to) {
    for (Eigen::Index i = 0; i < from.rows(); ++i)
      for (Eigen::Index j = 0; j < from.cols(); ++j) to.push_back(from(i, j));
  };
  row_major(gamma, participation_);
  row_major(shapes, shape_);
  row_major(rigid, rigid_);
  row_major(drift, deformation_);
  for (std::size_t i = 0; i < floors(); ++i)
    row_major(frame_.floors[i].below.stiffness * drift.middleRows<3>(static_cast<Eigen::Index>(3 * i)), shear_);
  for (Eigen::Index k = 0; k < n; ++k) {
    frequency_.push_back(std::sqrt(eigen.values(k)));
    auto const& given = frame_.damping;
    damping_.push_back(given.empty() ? 0.0 : given[std::min(static_cast<std::size_t>(k), given.size() - 1)]);
  }
}

double Structure::weight_kN() const {
  return mass_(0, 0) / Mg_in_mass * gravity;
}

std::vector<double> Structure::frequencies_on(Matrix3 const& bearings) const {
  num::Matrix whole = stiffness_;
  whole.topLeftCorner<3, 3>() += bearings;
  num::Vector const root = masses_.cwiseSqrt().cwiseInverse();
  auto const values = num::symmetric_eigen(root.asDiagonal() * whole * root.asDiagonal()).values;
  std::vector<double> frequencies;
  for (double const value : values) frequencies.push_back(std::sqrt(std::max(0.0, value)));
  return frequencies;
}

}  // namespace isolaw::building
