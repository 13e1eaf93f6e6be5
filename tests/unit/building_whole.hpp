// Assembles the equations of motion of a building as full matrices. No code of isolaw's own integration is used, so
// that tests can compare the two.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "isolaw/building/structure.hpp"
#include "isolaw/num/linear.hpp"

namespace isolaw::building {

struct Whole {
  num::Vector mass;       // one value per degree of freedom, the base first
  num::Matrix stiffness;  // of the storeys, without bearings
  num::Matrix damping;    // modal damping on a fixed base, the same ratio for all modes
};

inline Whole whole_equations(Frame const& frame, double ratio) {
  auto const floors = static_cast<Eigen::Index>(frame.floors.size()), n = 3 * floors, all = n + 3;
  auto const floor = [&](Eigen::Index i) -> Floor const& { return frame.floors[static_cast<std::size_t>(i)]; };
  Whole equations{num::Vector::Zero(all), num::Matrix::Zero(all, all), num::Matrix::Zero(all, all)};
  auto const put = [&](Diaphragm const& slab, Eigen::Index at) {
    double const m = slab.mass_Mg * Mg_in_mass;
    equations.mass.segment<3>(at) << m, m, m * slab.gyration_mm * slab.gyration_mm;
  };
  put(frame.base, 0);
  for (Eigen::Index i = 0; i < floors; ++i) {
    put(floor(i).slab, 3 * i + 3);
    Eigen::Matrix<double, 3, Eigen::Dynamic> B = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, all);
    auto const& under = i == 0 ? frame.base : floor(i - 1).slab;
    B.middleCols<3>(3 * i) = -carried(under.centre, floor(i).below.centre);
    B.middleCols<3>(3 * i + 3) = carried(floor(i).slab.centre, floor(i).below.centre);
    equations.stiffness += B.transpose() * floor(i).below.stiffness * B;
  }
  if (n == 0) return equations;
  // Damping matrix C = 2 zeta M sqrt(M^-1 K), for the motion relative to the base.
  num::Vector const root = equations.mass.tail(n).cwiseSqrt(), inverse = root.cwiseInverse();
  auto const eigen =
      num::symmetric_eigen(inverse.asDiagonal() * equations.stiffness.bottomRightCorner(n, n) * inverse.asDiagonal());
  num::Vector const frequency = eigen.values.cwiseSqrt();
  num::Matrix const damping = 2.0 * ratio * root.asDiagonal() * eigen.vectors * frequency.asDiagonal() *
                              eigen.vectors.transpose() * root.asDiagonal();
  num::Matrix relative = num::Matrix::Zero(n, all);
  relative.rightCols(n).setIdentity();
  for (Eigen::Index i = 0; i < floors; ++i)
    relative.block<3, 3>(3 * i, 0) = -carried(frame.base.centre, floor(i).slab.centre);
  equations.damping = relative.transpose() * damping * relative;
  return equations;
}

}  // namespace isolaw::building
