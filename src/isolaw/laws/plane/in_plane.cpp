#include "isolaw/laws/plane/in_plane.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane/plane.hpp"

namespace isolaw::laws {

struct InPlane::Form {
  virtual ~Form() = default;
  virtual std::unique_ptr<Form> copy() const = 0;
  virtual Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity, double dt) = 0;
  virtual void commit() = 0;
  virtual std::vector<double> state() const = 0;
};

namespace {

template <class Law>
class CoupledForm final : public InPlane::Form {
 public:
  using Params = typename Law::template Params<double>;
  explicit CoupledForm(Params const& params) : params_(params), committed_(Law::template start<double>(params)) {}

  std::unique_ptr<Form> copy() const override { return std::make_unique<CoupledForm>(*this); }
  InPlane::Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const&, double dt) override {
    auto const step = plane::force_and_tangent(Law(), params_, committed_, from_, displacement, dt);
    trial_ = step.after;
    to_ = displacement;
    return {step.force, step.tangent, {}};
  }
  void commit() override {
    committed_ = trial_;
    from_ = to_;
  }
  std::vector<double> state() const override {
    using State = typename Law::template State<double>;
    auto const numbers = std::bit_cast<std::array<double, sizeof(State) / sizeof(double)>>(committed_);
    std::vector<double> state(numbers.begin(), numbers.end());
    state.insert(state.end(), {from_.x, from_.y});
    return state;
  }

 private:
  Params params_;
  typename Law::template State<double> committed_, trial_ = committed_;
  plane::Vector<double> from_{0.0, 0.0}, to_{0.0, 0.0};
};

class SpringsForm final : public InPlane::Form {
 public:
  explicit SpringsForm(Springs springs) : springs_(std::move(springs)) {}

  std::unique_ptr<Form> copy() const override { return std::make_unique<SpringsForm>(*this); }
  InPlane::Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity,
                       double) override {
    return springs_.trial(displacement, velocity);
  }
  void commit() override { springs_.commit(); }
  std::vector<double> state() const override { return springs_.state(); }

 private:
  Springs springs_;
};

template <class Visitor>
void visit_laws(plane::Softening softening, Visitor&& visit) {
  auto const each = [&]<class... Law>(std::tuple<Law...>*) { (visit.template operator()<Law>(), ...); };
  if (softening == plane::Softening::by_axis)
    each(static_cast<plane::LawsByAxis*>(nullptr));
  else
    each(static_cast<plane::AllLaws*>(nullptr));
}

std::string with_a_form(plane::Softening softening) {
  std::vector<std::string_view> ids;
  visit_laws(softening, [&]<class Law>() { ids.push_back(Law::info.id); });
  return joined(ids);
}

}  // namespace

std::optional<std::string> no_coupled_form(std::string_view law, std::span<double const> parameters) {
  std::optional<std::string> why = "this law has no coupled form";
  visit_laws(plane::Softening::by_distance, [&]<class Law>() {
    if (law != Law::info.id) return;
    why.reset();
    if constexpr (requires { Law::joint_limits; })
      for (auto const& limit : Law::joint_limits)
        if (!limit.holds(unpack<typename Law::OneDirection, double>(parameters)) && !why)
          why = fmt::format("its parameters do not meet {}", limit.statement);
  });
  return why;
}

bool springs_follow(std::string_view law) {
  return find_law(law).info.traits.odd;
}

bool softens_with_the_peak(std::string_view law) {
  bool found = false;
  visit_laws(plane::Softening::by_axis, [&]<class Law>() { found = found || law == Law::info.id; });
  return found;
}

InPlane InPlane::coupled(std::string_view law, std::span<double const> parameters, plane::Softening softening) {
  auto const refuse = [&](std::string found) {
    return Error({.where = fmt::format("law {}, coupled in two directions", law),
                  .found = std::move(found),
                  .allowed = with_a_form(softening),
                  .advice = springs_follow(law) ? "springs, which every law of equal force on both sides can be" : ""});
  };
  if (auto const why = no_coupled_form(law, parameters)) throw refuse(*why);
  std::unique_ptr<Form> form;
  visit_laws(softening, [&]<class Law>() {
    if (law == Law::info.id)
      form = std::make_unique<CoupledForm<Law>>(unpack<typename Law::OneDirection, double>(parameters));
  });
  if (!form) throw refuse("no peak softens this law");
  return InPlane(std::move(form));
}

InPlane InPlane::springs(Online const& law, int count) {
  return InPlane(std::make_unique<SpringsForm>(Springs(law, count)));
}

InPlane::InPlane(std::unique_ptr<Form> form) : form_(std::move(form)) {}
InPlane::~InPlane() = default;
InPlane::InPlane(InPlane&&) noexcept = default;
InPlane& InPlane::operator=(InPlane&&) noexcept = default;
InPlane::InPlane(InPlane const& other) : form_(other.form_->copy()) {}
InPlane& InPlane::operator=(InPlane const& other) {
  form_ = other.form_->copy();
  return *this;
}
InPlane::Force InPlane::trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity,
                              double dt) {
  return form_->trial(displacement, velocity, dt);
}
void InPlane::commit() {
  form_->commit();
}
std::vector<double> InPlane::state() const {
  return form_->state();
}

}  // namespace isolaw::laws
