// A law in two directions, chosen by name: one state for both directions (plane.hpp), or springs around the circle.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/laws/plane/springs.hpp"
#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws {

enum class Bidirectional { coupled, springs };

// A device that starts virgin at the origin. Displacements and forces are in the law's units, times in seconds. Every
// trial starts from the last committed state. Copies are independent of one another.
class InPlane {
 public:
  // A device with one state for both directions. Throws Error if the law cannot have one with these parameters, and for
  // Softening::by_axis if no peak softens the law.
  static InPlane coupled(std::string_view law, std::span<double const> parameters,
                         plane::Softening softening = plane::Softening::by_distance);
  static InPlane springs(Online const& law, int count = usual_springs);

  InPlane(InPlane const& other);
  InPlane& operator=(InPlane const& other);
  InPlane(InPlane&&) noexcept;
  InPlane& operator=(InPlane&&) noexcept;
  ~InPlane();

  using Force = Springs::Force;
  Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity, double dt);
  void commit();

  // The committed state as a fixed count of numbers: for a coupled law those of its State, then the displacement; for
  // springs those of Springs::state().
  std::vector<double> state() const;

  struct Form;

 private:
  explicit InPlane(std::unique_ptr<Form> form);
  std::unique_ptr<Form> form_;
};

// Says why a law with these parameters cannot have one state for both directions; nullopt if it can.
std::optional<std::string> no_coupled_form(std::string_view law, std::span<double const> parameters);
// Whether springs around a circle reproduce the law. They do if its force is the same on both sides. Springs of any
// other law would give a force across the motion that depends on the angle at which the circle begins.
bool springs_follow(std::string_view law);
// Whether the largest displacement so far softens the coupled form, so that plane::Softening matters.
bool softens_with_the_peak(std::string_view law);

}  // namespace isolaw::laws
