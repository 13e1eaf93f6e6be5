#include "isolaw/laws/online.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/all_laws.hpp"

namespace isolaw::laws {

struct Online::Form {
  virtual ~Form() = default;
  virtual std::unique_ptr<Form> copy() const = 0;
  virtual Force trial(double x, double v) = 0;
  virtual void commit() = 0;
};

namespace online_forms {
namespace {

template <class Law>
struct LawTag {};

// The files of online/ take the dead band from the same struct as the law's parameters.
template <class Law>
struct ParametersWithBand : ParamsOf<Law, double> {
  double dead_band = 0.0;
};

template <class Law, class State, auto move, auto keep>
class LawForm final : public Online::Form {
 public:
  LawForm(std::shared_ptr<Law const> law, int parts) : law_(std::move(law)), parts_(parts) {}

  std::unique_ptr<Form> copy() const override { return std::make_unique<LawForm>(*this); }
  Online::Force trial(double x, double v) override {
    move(*law_, committed_, x, v, parts_, trial_);
    return {trial_.force, trial_.tangent, trial_.damping};
  }
  void commit() override { keep(trial_, committed_); }

 private:
  std::shared_ptr<Law const> law_;
  int parts_;
  State committed_, trial_;
};

#define ISOLAW_FORM_LAW Bilinear
#define ISOLAW_FORM_FILE "isolaw/laws/online/bilinear.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Jankowski
#define ISOLAW_FORM_FILE "isolaw/laws/online/jankowski.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Vaiana
#define ISOLAW_FORM_FILE "isolaw/laws/online/vaiana.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW BoucWen
#define ISOLAW_FORM_FILE "isolaw/laws/online/bouc_wen.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Abe
#define ISOLAW_FORM_FILE "isolaw/laws/online/abe.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW AbeY0
#define ISOLAW_FORM_FILE "isolaw/laws/online/abe_y0.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW HwangWu
#define ISOLAW_FORM_FILE "isolaw/laws/online/hwang_wu.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Bwbn
#define ISOLAW_FORM_FILE "isolaw/laws/online/bwbn.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Gallardo
#define ISOLAW_FORM_FILE "isolaw/laws/online/gallardo.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW HistoryIntegral
#define ISOLAW_FORM_FILE "isolaw/laws/online/history_integral.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW KikuchiAiken
#define ISOLAW_FORM_FILE "isolaw/laws/online/kikuchi_aiken.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW MenegottoPinto
#define ISOLAW_FORM_FILE "isolaw/laws/online/menegotto_pinto.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW Ozdemir
#define ISOLAW_FORM_FILE "isolaw/laws/online/ozdemir.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW PowerMasing
#define ISOLAW_FORM_FILE "isolaw/laws/online/power_masing.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW PowerMasingViscous
#define ISOLAW_FORM_FILE "isolaw/laws/online/power_masing_viscous.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW PowerMasingWorn
#define ISOLAW_FORM_FILE "isolaw/laws/online/power_masing_worn.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW PowerScragging
#define ISOLAW_FORM_FILE "isolaw/laws/online/power_scragging.inc"
#include "isolaw/laws/online_form.inc"
#define ISOLAW_FORM_LAW RambergOsgood
#define ISOLAW_FORM_FILE "isolaw/laws/online/ramberg_osgood.inc"
#include "isolaw/laws/online_form.inc"

template <class Law>
constexpr bool has_form = requires(ParametersWithBand<Law> const& parameters) {
  new_form(LawTag<Law>(), parameters, 1);
};

}  // namespace
}  // namespace online_forms

Online::Online(std::string_view law, std::span<double const> parameters, double dead_band, int parts) {
  for_each_law([&]<class Law>() {
    if constexpr (online_forms::has_form<Law>)
      if (law == Law::info.id)
        form_ = new_form(online_forms::LawTag<Law>(), {unpack<Law, double>(parameters), dead_band}, parts);
  });
  if (!form_)
    throw Error({.where = "law " + std::string(law),
                 .found = "it needs a motion that is known ahead",
                 .allowed = "a law with a form in laws/online"});
}

bool has_online_form(std::string_view law) {
  bool found = false;
  for_each_law([&]<class Law>() { found = found || (online_forms::has_form<Law> && law == Law::info.id); });
  return found;
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
