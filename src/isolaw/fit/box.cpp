#include "isolaw/fit/box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::fit {
namespace {

// Six decades as a natural logarithm. A logarithmic scale cannot reach zero. Therefore, if an interval touches or spans
// zero, its scale covers the six decades below the end that is farther from zero.
constexpr double decades_from_zero = 6.0 * 2.302585092994046;

// The logarithmic scale of an interval that touches or spans zero: value = linear_size sinh(c), with the coordinate c.
// The scale is logarithmic where |value| is above linear_size and linear below. c goes from `from` = asinh(lower /
// linear_size) to `to` at `upper`.
struct AcrossZero {
  double linear_size, from, to;

  AcrossZero(double lower, double upper)
      : linear_size(std::max(-lower, upper) / std::exp(decades_from_zero)),
        from(std::asinh(lower / linear_size)),
        to(std::asinh(upper / linear_size)) {}
};

constexpr std::string_view override_form =
    "law.parameter=value, law.parameter=lower:upper, law.parameter=free, law.parameter=another parameter";

std::optional<double> parse_number(std::string_view text) {
  auto const value = number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// The forces where the displacement crosses zero, by linear interpolation. A first sample at zero is no crossing.
std::vector<double> forces_at_zero(data::FitRecord const& record) {
  auto const &x = record.disp_mm, &f = record.force_kN;
  std::vector<double> forces;
  for (auto const& test : data::test_ranges(record.starts, record.size()))
    for (std::size_t i = test.first + 1; i < test.end; ++i) {
      if (!record.is_scored(i - 1) || !record.is_scored(i) || x[i - 1] == 0.0 || x[i - 1] * x[i] > 0.0) continue;
      double const t = x[i - 1] / (x[i - 1] - x[i]);
      forces.push_back(f[i - 1] + t * (f[i] - f[i - 1]));
    }
  return forces;
}

double peak_to_peak_stiffness(data::FitRecord const& record) {
  auto const &x = record.disp_mm, &f = record.force_kN;
  std::size_t low = x.size(), high = x.size();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!record.is_scored(i)) continue;
    if (low == x.size() || x[i] < x[low]) low = i;
    if (high == x.size() || x[i] > x[high]) high = i;
  }
  return high < x.size() && x[high] > x[low] ? (f[high] - f[low]) / (x[high] - x[low]) : 0.0;
}

}  // namespace

std::string limits_text(laws::Interval const& limits, std::string_view unit) {
  auto const in_unit = [&](double value) {
    return unit == "1" ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
  };
  // laws::positive begins at the smallest positive number, which stands for "above zero".
  bool const above = limits.lower == laws::positive.lower, from = above || std::isfinite(limits.lower);
  bool const to = std::isfinite(limits.upper);
  if (!from && !to) return unit == "1" ? std::string("any number") : fmt::format("any number of {}", unit);
  if (!from) return in_unit(limits.upper) + " or less";
  if (!to) return above ? "above " + in_unit(0.0) : in_unit(limits.lower) + " or more";
  return above ? fmt::format("above 0, up to {}", in_unit(limits.upper))
               : fmt::format("{} to {}", limits.lower, in_unit(limits.upper));
}

std::string Override::text() const {
  if (!tied_to.empty()) return fmt::format("{}.{}={}", law, parameter, tied_to);
  if (!interval) return fmt::format("{}.{}=free", law, parameter);
  if (interval->lower == interval->upper) return fmt::format("{}.{}={}", law, parameter, interval->lower);
  return fmt::format("{}.{}={}:{}", law, parameter, interval->lower, interval->upper);
}

Override const* last_override(std::span<Override const> overrides, laws::LawEntry const& law,
                              std::string_view parameter) {
  auto const found = std::ranges::find_if(overrides.rbegin(), overrides.rend(), [&](Override const& each) {
    return each.law == law.info.id && each.parameter == parameter;
  });
  return found == overrides.rend() ? nullptr : &*found;
}

Override parse_override(std::string_view text) {
  auto const where = fmt::format("--set {}", text);
  auto const equals = text.find('='), dot = text.find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot > equals)
    throw Error({.where = where, .found = "not of the form law.parameter=...", .allowed = std::string(override_form)});

  auto const& law = laws::find_law(text.substr(0, dot));
  auto const& parameter = law.parameters[law.index_of(text.substr(dot + 1, equals - dot - 1))];
  Override result{.law = std::string(law.info.id), .parameter = std::string(parameter.name), .interval = std::nullopt};
  auto const value = text.substr(equals + 1);
  if (value == "free") return result;
  if (auto const other = std::ranges::find(law.parameters, value, &laws::ParameterInfo::name);
      other != law.parameters.end()) {
    if (other->name == parameter.name || other->unit != parameter.unit)
      throw Error({.where = where,
                   .found = other->name == parameter.name ? fmt::format("{} is tied to itself", value)
                                                          : fmt::format("{} is in {}, {} in {}", parameter.name,
                                                                        parameter.unit, value, other->unit),
                   .allowed = "another parameter of the law, of the same unit"});
    result.tied_to = value;
    return result;
  }

  auto const colon = value.find(':');
  bool const fixed = colon == std::string_view::npos;
  auto const lower = parse_number(value.substr(0, colon));
  auto const upper = fixed ? lower : parse_number(value.substr(colon + 1));
  if (!lower || !upper)
    throw Error({.where = where,
                 .found = fmt::format("'{}' is not a number, an interval, 'free' or a parameter of the law", value),
                 .allowed = std::string(override_form)});
  if (!fixed && *lower >= *upper)
    throw Error({.where = where,
                 .found = fmt::format("the lower bound {} is not below the upper bound {}", *lower, *upper),
                 .allowed = "lower < upper",
                 .advice = fmt::format("--set {}.{}={}:{}, or one value to fix the parameter", result.law,
                                       result.parameter, *upper, *lower == *upper ? *upper + 1.0 : *lower)});
  auto const& limits = parameter.physical;
  if (*lower < limits.lower || *upper > limits.upper)
    throw Error({.where = where,
                 .found = fmt::format("[{}, {}] leaves the physical limits of {}", *lower, *upper, parameter.name),
                 .allowed = limits_text(limits, parameter.unit)});
  result.interval = laws::Interval{*lower, *upper};
  return result;
}

double SearchParameter::at(double u) const {
  u = std::clamp(u, 0.0, 1.0);
  if (scale == laws::Scale::linear) return lower + u * (upper - lower);
  if (lower == 0.0)
    return std::clamp(upper * std::expm1(decades_from_zero * u) / std::expm1(decades_from_zero), 0.0, upper);
  if (upper == 0.0)
    return std::clamp(lower * std::expm1(decades_from_zero * (1.0 - u)) / std::expm1(decades_from_zero), lower, 0.0);
  if (lower < 0.0 && upper > 0.0) {
    AcrossZero const across(lower, upper);
    return std::clamp(across.linear_size * std::sinh(across.from + u * (across.to - across.from)), lower, upper);
  }
  double const sign = lower < 0.0 ? -1.0 : 1.0;
  double const a = std::log(std::abs(lower)), b = std::log(std::abs(upper));
  return std::clamp(sign * std::exp(a + u * (b - a)), lower, upper);
}

double SearchParameter::coordinate(double value_) const {
  auto const from_zero = [](double share) {
    return std::log1p(std::max(0.0, share) * std::expm1(decades_from_zero)) / decades_from_zero;
  };
  double u = 0.0;
  if (scale == laws::Scale::linear) {
    u = (value_ - lower) / (upper - lower);
  } else if (lower == 0.0) {
    u = from_zero(value_ / upper);
  } else if (upper == 0.0) {
    u = 1.0 - from_zero(value_ / lower);
  } else if (lower < 0.0 && upper > 0.0) {
    AcrossZero const across(lower, upper);
    u = (std::asinh(value_ / across.linear_size) - across.from) / (across.to - across.from);
  } else {
    double const a = std::log(std::abs(lower)), b = std::log(std::abs(upper));
    u = (std::log(std::abs(value_)) - a) / (b - a);
  }
  return std::clamp(u, 0.0, 1.0);
}

std::size_t SearchBox::free_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(parameters, [](auto const& p) { return p.free; }));
}

void SearchBox::expand(std::span<double const> point, std::span<double> values) const {
  std::size_t next = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    values[i] = parameters[i].free ? parameters[i].at(point[next++]) : parameters[i].value;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].tied_to) values[i] = values[*parameters[i].tied_to];
}

std::vector<double> SearchBox::contract(std::span<double const> values) const {
  std::vector<double> point;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].free) point.push_back(parameters[i].coordinate(values[i]));
  return point;
}

SearchBox on_logarithmic_scales(SearchBox box, laws::LawEntry const& law) {
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto& p = box.parameters[i];
    if (!p.free || p.lower * p.upper < 0.0) continue;
    double const smaller = std::min(std::abs(p.lower), std::abs(p.upper)),
                 larger = std::max(std::abs(p.lower), std::abs(p.upper));
    bool const declared = law.parameters[i].scaled_search == laws::Scale::logarithmic;
    if (smaller > 0.0 ? declared || larger >= wide_interval * smaller : declared) p.scale = laws::Scale::logarithmic;
  }
  return box;
}

std::string_view name(AtBound bound) {
  return bound == AtBound::lower ? "lower" : bound == AtBound::upper ? "upper" : "";
}

AtBound at_bound(SearchParameter const& parameter, double value) {
  if (!parameter.free) return AtBound::no;
  double const u = parameter.coordinate(value);
  return u <= bound_tolerance ? AtBound::lower : u >= 1.0 - bound_tolerance ? AtBound::upper : AtBound::no;
}

std::optional<laws::Interval> interval_beyond(laws::ParameterInfo const& parameter, laws::Interval interval,
                                              AtBound bound) {
  constexpr double farther = 10.0;
  // Moves one end of the interval outwards, which is away from zero or towards it. `other` is the other end.
  auto const away = [&](double end, double other) {
    if (end == 0.0) return -other;
    bool const from_zero = (end > 0.0) == (end > other);
    return from_zero ? farther * end : end / farther;
  };
  auto const& limits = parameter.physical;
  if (bound == AtBound::lower && interval.lower > limits.lower)
    interval.lower = std::max(limits.lower, away(interval.lower, interval.upper));
  else if (bound == AtBound::upper && interval.upper < limits.upper)
    interval.upper = std::min(limits.upper, away(interval.upper, interval.lower));
  else
    return std::nullopt;
  return interval;
}

bool same_bounds(SearchBox const& a, SearchBox const& b) {
  return std::ranges::equal(a.parameters, b.parameters,
                            [](auto const& p, auto const& q) { return p.lower == q.lower && p.upper == q.upper; });
}

std::optional<SearchBox> box_beyond(SearchBox const& box, laws::LawEntry const& law, std::span<double const> values,
                                    std::span<Override const> overrides) {
  auto wider = box;
  bool moved = false;
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto const* change = last_override(overrides, law, law.parameters[i].name);
    if (change != nullptr && change->interval) continue;
    auto const& p = box.parameters[i];
    auto const interval = interval_beyond(law.parameters[i], {p.lower, p.upper}, at_bound(p, values[i]));
    if (!interval) continue;
    wider.parameters[i].lower = interval->lower;
    wider.parameters[i].upper = interval->upper;
    moved = true;
  }
  return moved ? std::optional(std::move(wider)) : std::nullopt;
}

laws::RecordScales scales_of(data::FitRecord const& record, laws::LawInfo const& law) {
  auto const& x = record.disp_mm;
  auto const& f = record.force_kN;
  if (x.empty()) throw Error({.where = "law " + std::string(law.id), .found = "a record of 0 samples"});
  double const disp = record.largest_scored(x), force = record.largest_scored(f);
  double stiffness = peak_to_peak_stiffness(record);
  // If the record has no clear slope from peak to peak, the largest force over the largest displacement serves as
  // stiffness.
  if (!(stiffness > 0.05 * force / disp)) stiffness = force / disp;

  auto const at_zero = forces_at_zero(record);
  double strength = 0.0;
  for (double const value : at_zero) strength += std::abs(value) / static_cast<double>(at_zero.size());
  // If the displacement never crosses zero or the loop is very thin, a quarter of the largest force serves as strength.
  if (!(strength > 0.02 * force)) strength = 0.25 * force;

  // The work of a test over all samples, including those that do not count in the objective: some laws remember all
  // work that was done on the device.
  double work = 0.0;
  for (auto const& test : data::test_ranges(record.starts, record.size())) {
    double of_test = 0.0;
    for (std::size_t i = test.first + 1; i < test.end; ++i) of_test += 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1]);
    work = std::max(work, of_test);
  }
  if (!(work > 0.1 * force * disp)) work = force * disp;

  double const F = law.force.in_record_units, L = law.length.in_record_units;
  return {.disp = disp / L,
          .force = force / F,
          .stiffness = stiffness * L / F,
          .strength = strength / F,
          .velocity = record.largest_scored(record.vel_mm_s) / L,
          .work = work / (F * L)};
}

SearchBox make_box(laws::LawEntry const& law, BoxKind kind, laws::RecordScales const& scales,
                   std::span<Override const> overrides) {
  SearchBox box;
  for (auto const& info : law.parameters) {
    bool const from_paper = kind == BoxKind::published && info.published.has_value();
    auto const interval = from_paper ? *info.published : info.scaled(scales);
    SearchParameter parameter{.name = std::string(info.name),
                              .unit = std::string(info.unit),
                              .free = !info.fixed_by_default.has_value(),
                              .value = info.fixed_by_default.value_or(0.0),
                              .lower = interval.lower,
                              .upper = interval.upper,
                              .scale = from_paper ? laws::Scale::linear : info.scaled_search};
    auto const* change = last_override(overrides, law, info.name);
    if (change != nullptr && !change->tied_to.empty()) {
      parameter.free = false;
      parameter.tied_to = law.index_of(change->tied_to);
    } else if (change != nullptr) {
      parameter.free = !change->interval || change->interval->lower < change->interval->upper;
      if (change->interval) {
        parameter.lower = change->interval->lower;
        parameter.upper = change->interval->upper;
        parameter.value = parameter.lower;
        // An override that touches or spans zero is linear here. on_logarithmic_scales() may change this later.
        if (parameter.lower * parameter.upper <= 0.0) parameter.scale = laws::Scale::linear;
      }
    }
    box.parameters.push_back(parameter);
  }
  for (auto& p : box.parameters) {
    if (!p.tied_to) continue;
    auto const& other = box.parameters[*p.tied_to];
    if (other.tied_to)
      throw Error({.where = fmt::format("--set {}.{}={}", law.info.id, p.name, other.name),
                   .found = fmt::format("{} is tied to {}", other.name, box.parameters[*other.tied_to].name),
                   .allowed = "a parameter that is free or fixed"});
    p.value = other.value;
    p.lower = other.lower;
    p.upper = other.upper;
  }
  return box;
}

}  // namespace isolaw::fit
