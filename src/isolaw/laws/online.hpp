// A law where the motion is not known ahead: trials from the last committed state, with tangents. The same forms that
// exports hold (online/*.inc), compiled into the library; a test holds them to the laws.
#pragma once

#include <memory>
#include <span>
#include <string_view>

namespace isolaw::laws {

// In the law's units and seconds, virgin at 0. Copies go their own ways and share what does not change.
class Online {
 public:
  // Parameters in the order of the catalogue. `dead_band`: of the record that a law which remembers was fitted to.
  // Every trial is computed in `parts` equal ones. Throws Error for a law that has no such form.
  Online(std::string_view law, std::span<double const> parameters, double dead_band = 0.0, int parts = 1);
  ~Online();
  Online(Online const& other);
  Online& operator=(Online const& other);
  Online(Online&&) noexcept;
  Online& operator=(Online&&) noexcept;

  struct Force {
    double force, by_x, by_v;  // derivatives of the step as computed, by the displacement and velocity of its end
  };
  // Of a motion from the committed state, however many trials there were before. Laws have no clock: a step's duration
  // is not asked for.
  Force trial(double x, double v);
  void commit();  // the last trial

  struct Form;

 private:
  std::unique_ptr<Form> form_;
};

bool has_online_form(std::string_view law);

}  // namespace isolaw::laws
