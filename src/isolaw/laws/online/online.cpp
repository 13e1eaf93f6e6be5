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
  virtual std::vector<double> state() const = 0;
};

namespace {

// Lists the numbers of a state as Online::state() gives them.
struct Listed {
  std::vector<double> numbers;

  template <class... Parts>
  void operator()(Parts&... parts) {
    (one(parts), ...);
  }
  void one(double& x) { numbers.push_back(x); }
  void one(Dual& x) { numbers.push_back(x.v); }
  void one(bool& x) { numbers.push_back(x ? 1.0 : 0.0); }
  template <class Part>
  void one(std::vector<Part>& list) {
    numbers.push_back(static_cast<double>(list.size()));
    Part last = list.empty() ? Part() : list.back();
    one(last);
  }
  template <class Part>
  void one(Part& part) {
    part.members(*this);
  }
};

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
  std::vector<double> state() const override {
    auto state = committed_;  // a copy, because members() is not const
    Listed listed;
    listed(state.law, state.x, state.v, state.direction, state.peak);
    return listed.numbers;
  }

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
std::vector<double> Online::state() const {
  return form_->state();
}

}  // namespace isolaw::laws
