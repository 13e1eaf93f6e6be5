// A law in two directions by name: coupled, where it has such a form (plane.hpp), or as springs around the circle.
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

// In the law's units and seconds, virgin at the origin; trials from the last committed state. Copies go their own ways.
class InPlane {
 public:
  // Throws Error for a law, or parameters of it, without a coupled form; by_axis for one that no peak softens.
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

// Why a law with these parameters has no coupled form; nullopt where it has one.
std::optional<std::string> no_coupled_form(std::string_view law, std::span<double const> parameters);
// Whether a peak softens it, so that Softening matters.
bool softens_with_the_peak(std::string_view law);

}  // namespace isolaw::laws
