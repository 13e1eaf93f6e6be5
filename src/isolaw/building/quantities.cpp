#include "isolaw/building/quantities.hpp"

#include <algorithm>
#include <cstddef>
#include "isolaw/data/channels/ground_motion.hpp"

namespace isolaw::building {
namespace {

double largest(std::span<double const> measured, std::size_t first, std::size_t count) {
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) most = std::max(most, measured[first + i]);
  return most;
}

constexpr std::string_view alike =
    "the bound analyses take all bearings alike, so that they lack the torsion of unequal bearings";
constexpr Quantity quantity_rows[]{
    {"isolator_mm", "bearing displacement", "mm", "largest displacement of any bearing",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::isolator); }},
    {"centre_mm", "centre displacement", "mm", "largest displacement of the base's centre of mass",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::centre); }},
    {"corner_mm", "corner displacement", "mm", "largest displacement of a corner of the base",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::corner); }},
    {"corner_over_centre", "corner over centre", "-",
     "corner displacement divided by centre displacement; torsion makes it larger",
     [](Layout const&, std::span<double const> m, double) {
       return ratio(measure_of(m, Measure::corner), measure_of(m, Measure::centre));
     },
     alike},
    {"rotation_mrad", "rotation", "mrad", "largest rotation of the base",
     [](Layout const&, std::span<double const> m, double) { return 1e3 * measure_of(m, Measure::rotation); }, alike},
    {"residual_mm", "residual displacement", "mm",
     "displacement of the base's centre of mass at the end of the analysis, some seconds after the motion",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::end); }},
    {"shear_over_weight", "base shear over weight", "-", "largest sum of the bearings' forces, divided by the weight",
     [](Layout const&, std::span<double const> m, double weight) { return measure_of(m, Measure::shear) / weight; }},
    {"base_acceleration_g", "base acceleration", "g", "largest acceleration of the base slab in space, at samples",
     [](Layout const& l, std::span<double const> m, double) { return m[l.acceleration(0)] / data::gravity_mm_s2; }},
    {"roof_acceleration_g", "roof acceleration", "g", "largest acceleration of the highest floor",
     [](Layout const& l, std::span<double const> m, double) {
       return m[l.acceleration(l.floors)] / data::gravity_mm_s2;
     }},
    {"floor_acceleration_g", "floor acceleration", "g", "largest acceleration of any floor or of the base",
     [](Layout const& l, std::span<double const> m, double) {
       return largest(m, l.acceleration(0), l.floors + 1) / data::gravity_mm_s2;
     }},
    {"storey_shear_over_weight", "storey shear over weight", "-",
     "largest shear of any storey, divided by the whole weight",
     [](Layout const& l, std::span<double const> m, double weight) {
       return largest(m, l.storey_shear(0), l.floors) / weight;
     }},
    {"drift_mm", "storey drift", "mm", "largest drift of any storey, at its centre of stiffness",
     [](Layout const& l, std::span<double const> m, double) { return largest(m, l.drift(0), l.floors); }},
    {"energy_kNm", "work on bearings", "kN m", "work done on the bearings",
     [](Layout const&, std::span<double const> m, double) { return 1e-3 * measure_of(m, Measure::hysteretic); }},
    {"worst_energy_share", "largest share of work", "-",
     "share of the work on all bearings that the bearing with the largest work takes",
     [](Layout const& l, std::span<double const> m, double) {
       return ratio(largest(m, l.energy(0), l.bearings), measure_of(m, Measure::hysteretic));
     },
     alike},
};

}  // namespace

double measure_of(std::span<double const> measured, Measure which) {
  return measured[static_cast<std::size_t>(which)];
}

double ratio(double a, double b) {
  return b > 0.0 ? a / b : 0.0;
}

std::span<Quantity const> quantities() {
  return quantity_rows;
}
Quantity const& quantity(std::string_view key) {
  return *std::ranges::find(quantity_rows, key, &Quantity::key);
}

}  // namespace isolaw::building
