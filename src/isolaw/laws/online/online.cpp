#include "isolaw/laws/online/online.hpp"

#include <string>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/all_laws.hpp"
#include "isolaw/laws/online/motion.hpp"

namespace isolaw::laws {

struct Online::Form {
  virtual ~Form() = default;
  virtual std::unique_ptr<Form> copy() const = 0;
  virtual Force trial(double x, double v) = 0;
  virtual void commit() = 0;
};

namespace {

template <class Law>
class FormOf final : public Online::Form {
  using Motion = laws::Motion<Law>;

 public:
  FormOf(typename Motion::Parameters const& parameters, int parts)
      : law_(std::make_shared<Fixed const>(Fixed{parameters, constants_of<Law, double, Dual>(parameters)})),
        parts_(parts) {
    committed_.law = Motion::first_state(law_->parameters, law_->constants);
  }

  std::unique_ptr<Form> copy() const override { return std::make_unique<FormOf>(*this); }
  Online::Force trial(double x, double v) override {
    Motion::move(law_->parameters, law_->constants, committed_, x, v, parts_, trial_);
    return {trial_.force, trial_.tangent, trial_.damping};
  }
  void commit() override { Motion::keep(trial_, committed_); }

 private:
  struct Fixed {
    typename Motion::Parameters parameters;
    typename Motion::LawConstants constants;
  };
  std::shared_ptr<Fixed const> law_;
  int parts_;
  typename Motion::State committed_, trial_;
};

}  // namespace

Online::Online(std::string_view law, std::span<double const> parameters, double dead_band, int parts) {
  for_each_law([&]<class Law>() {
    if (law == Law::info.id)
      form_ = std::make_unique<FormOf<Law>>(
          typename Motion<Law>::Parameters{unpack<Law, double>(parameters), dead_band}, parts);
  });
  if (!form_) throw Error({.where = "law " + std::string(law), .found = "no law of this name"});
}

Online::~Online() = default;
Online::Online(Online&&) noexcept = default;
Online& Online::operator=(Online&&) noexcept = default;
Online::Online(Online const& other) : form_(other.form_->copy()) {}
Online& Online::operator=(Online const& other) {
  form_ = other.form_->copy();
  return *this;
}
Online::Force Online::trial(double x, double v) {
  return form_->trial(x, v);
}
void Online::commit() {
  form_->commit();
}

}  // namespace isolaw::laws
