// The building without its bearings: a base slab and floors, each a rigid diaphragm with three degrees of freedom (ux,
// uy and the rotation at its centre of mass), joined by storeys that shear and twist (a shear building).
// Source: Chopra, Dynamics of Structures, sections 9.5 and 18; Naeim and Kelly, Design of Seismic Isolated Structures.
//
// The superstructure is linear: its motion relative to the rigidly moving base is a sum of its modes on a fixed base.
// With u_b the base's displacement relative to the ground, A its absolute acceleration, and q, phi, omega, zeta the
// modes' amplitudes, shapes, frequencies and damping ratios,
//   q'' + 2 zeta omega q' + omega^2 q = -Gamma A      Gamma = phi^T M_s R; M_s, R the floors' masses and rigid motion
//   M A + Gamma^T q'' + f(u_b, u_b') = 0              M the mass of the whole rigid building, f the bearings' force
// No mode is left out, so these are the full equations. Only the modes on the fixed base are damped, not the isolation
// layer.
//
// Units kN, mm, s; a mass is in kN s2/mm = 1000 Mg, and 1 kN/mm on 100 Mg has omega^2 = 10 1/s2.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "isolaw/num/linear.hpp"

namespace isolaw::building {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

inline constexpr double Mg_in_mass = 1e-3;  // a mass of 1 Mg in the unit of mass of this module, kN s2/mm

struct Point {
  double x_mm = 0.0, y_mm = 0.0;
};

// Maps a rigid plate's motion at `from` to its motion at `at`: (ux - y theta, uy + x theta, theta), (x, y) = at - from.
Matrix3 carried(Point from, Point at);

struct Diaphragm {
  double mass_Mg = 0.0;
  double gyration_mm = 0.0;  // radius of gyration of its mass about the vertical through the centre of mass
  Point centre = {};         // centre of mass in plan
};

struct Storey {
  // Derivatives of the storey's forces and moment by its drifts along x and y and its twist about `centre`. Units:
  // kN/mm for force by drift, kN mm for moment by twist, kN for force by twist and moment by drift.
  Matrix3 stiffness = Matrix3::Zero();
  Point centre = {};  // centre of stiffness in plan
};
Storey storey(double x_kN_mm, double y_kN_mm, double rotation_kNmm, Point centre = {});

struct Floor {
  Storey below;  // the storey between this floor and the floor or base under it
  Diaphragm slab;
};

// `count` equal floors with the given first periods along x and y on a fixed base. Their first torsional frequency is
// `rotation_ratio` times the lower of the first frequencies along x and y.
std::vector<Floor> equal_floors(std::size_t count, Diaphragm const& slab, double period_x_s, double period_y_s,
                                double rotation_ratio = 1.3);

struct Frame {
  Diaphragm base;
  std::vector<Floor> floors;         // from the lowest up; empty: the building is only the base slab on its bearings
  std::vector<double> damping = {};  // ratios of the modes on a fixed base; the last one holds for all higher modes
};

// A frame and its modes on a fixed base. The arrays are row-major.
class Structure {
 public:
  // Throws one Error that lists all faults: masses and radii that are not above 0, storeys whose stiffness matrix is
  // not positive definite, centres that are not finite, and damping ratios outside [0, 1).
  explicit Structure(Frame frame);

  Frame const& frame() const { return frame_; }
  std::size_t floors() const { return frame_.floors.size(); }
  std::size_t modes() const { return frequency_.size(); }

  // Mass matrices in (ux, uy, rotation) of the base's centre of mass: of the whole building as a rigid body (M at the
  // top of this file), and of the base slab alone.
  Matrix3 const& mass() const { return mass_; }
  Matrix3 const& base_mass() const { return base_mass_; }
  double weight_kN() const;
  // Circular frequencies [rad/s], ascending, and damping ratios of the modes on a fixed base.
  std::vector<double> const& frequency_rad_s() const { return frequency_; }
  std::vector<double> const& damping() const { return damping_; }
  std::vector<double> const& participation() const { return participation_; }  // Gamma at the file's top, [mode][3]
  // A floor's centre of mass has the absolute acceleration rigid A + shape q'', with A and q as at the top of this
  // file. `shape` is [floor][3][mode], `rigid` is [floor][3][3].
  std::vector<double> const& shape() const { return shape_; }
  std::vector<double> const& rigid() const { return rigid_; }
  // For a mode of amplitude 1: the drifts and the twist of each storey at Storey::centre, and the storey's shears [kN]
  // and moment [kN mm]. [storey][3][mode].
  std::vector<double> const& deformation() const { return deformation_; }
  std::vector<double> const& shear() const { return shear_; }

  // Ascending circular frequencies [rad/s] on bearings whose stiffness about the base's centre of mass is `bearings`.
  std::vector<double> frequencies_on(Matrix3 const& bearings) const;

 private:
  // `deformation` maps the displacements of the degrees of freedom to the deformations of the storeys. `rigid` maps the
  // base's motion to the motion of the floors.
  void find_modes(num::Matrix const& deformation, num::Matrix const& rigid);

  Frame frame_;
  Matrix3 mass_, base_mass_;
  num::Vector masses_;     // mass of each degree of freedom: ux, uy and rotation of the base, then of each floor
  num::Matrix stiffness_;  // stiffness of the storeys between these degrees of freedom; bearings excluded
  std::vector<double> frequency_, damping_, participation_, shape_, rigid_, deformation_, shear_;
};

}  // namespace isolaw::building
