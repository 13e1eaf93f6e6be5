// A law in two directions, chosen by name: in its coupled form (plane.hpp), or as springs around the circle.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/laws/plane/vector.hpp"
#include "isolaw/laws/springs.hpp"

namespace isolaw::laws {

enum class Bidirectional { coupled, springs };

// A device that starts virgin at the origin. Displacements and forces are in the law's units, times in seconds. Every
// trial starts from the last committed state. Copies are independent of one another.
class InPlane {
 public:
  // Throws Error for a law or parameters without a coupled form, and for by_axis if no peak softens the law.
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

  struct Form;

 private:
  explicit InPlane(std::unique_ptr<Form> form);
  std::unique_ptr<Form> form_;
};

// Says why a law with these parameters has no coupled form; nullopt if it has one.
std::optional<std::string> no_coupled_form(std::string_view law, std::span<double const> parameters);
bool softens_with_the_peak(std::string_view law);  // if so, Softening matters

}  // namespace isolaw::laws
