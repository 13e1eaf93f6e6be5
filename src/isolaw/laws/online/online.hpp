// A law, chosen by name, for a motion that is not known ahead. Each trial starts from the last committed state and
// returns the force with its tangents.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace isolaw::laws {

// A device that follows a law. It starts virgin at displacement 0. Numbers are in the law's units and seconds. Copies
// are independent of one another.
class Online {
 public:
  // `parameters` are in the law's order. `dead_band` [law's length] is the dead band of the record that the parameters
  // were fitted to; only laws with the trait `remembers` use it. Each trial is divided into `parts` equal steps. Throws
  // Error for an unknown law.
  Online(std::string_view law, std::span<double const> parameters, double dead_band = 0.0, int parts = 1);
  ~Online();
  Online(Online const& other);
  Online& operator=(Online const& other);
  Online(Online&&) noexcept;
  Online& operator=(Online&&) noexcept;

  struct Force {
    double force, by_x, by_v;  // the force and its consistent tangents by displacement and velocity
  };
  // The force after a motion from the committed state to x, where the velocity is v. The duration does not matter.
  Force trial(double x, double v);
  void commit();  // makes the last trial the committed state

  // The committed state as a fixed count of numbers: the law's own, in the order of members() of its State and Memory,
  // then the displacement, the velocity, the direction of the motion (-1, 0 or 1) and the largest |x| so far. A list,
  // such as that of turning points, is given as its length and its last item, which is zeros for an empty list.
  std::vector<double> state() const;

  struct Form;

 private:
  std::unique_ptr<Form> form_;
};

}  // namespace isolaw::laws
