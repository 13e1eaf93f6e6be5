#include "isolaw/conditions/combine.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/num/statistics.hpp"

namespace isolaw::conditions {
namespace {

double lambda_of(Part const& part) {
  return part.factor.lambda();  // if the effect is not covered: the known part of the factor, or 1
}

bool counts(Part const& part, Form form) {
  return form != Form::asce || part.group != Group::none;
}

double value_of(Combination const& how, std::span<Part const> parts) {
  double environment = 1.0, test = 1.0, product = 1.0, each = 1.0, sum = 0.0;
  for (auto const& part : parts) {
    double const l = lambda_of(part);
    if (counts(part, how.form)) (part.group == Group::test ? test : environment) *= l;
    product *= l, each *= 1.0 + how.adjust * (l - 1.0), sum += l - 1.0;
  }
  switch (how.form) {
    case Form::asce:
      return (1.0 + how.adjust * (environment - 1.0)) * test * how.supply;
    case Form::each:
      return each * how.supply;
    case Form::product:
      return (1.0 + how.adjust * (product - 1.0)) * how.supply;
    case Form::sum:
      return 1.0 + how.margin * sum + (how.supply - 1.0);
  }
  return 1.0;
}

// Derivative of ln C by ln l, with the combined factor C = `value` and the factor l of one part.
double slope(Combination const& how, std::span<Part const> parts, Part const& part, double value) {
  double const l = lambda_of(part), f = how.adjust;
  double product = 1.0, environment = 1.0;
  for (auto const& each : parts) {
    product *= lambda_of(each);
    if (each.group == Group::environment) environment *= lambda_of(each);
  }
  switch (how.form) {
    case Form::asce:
      return part.group == Group::test ? 1.0 : f * environment / (1.0 + f * (environment - 1.0));
    case Form::each:
      return f * l / (1.0 + f * (l - 1.0));
    case Form::product:
      return f * product / (1.0 + f * (product - 1.0));
    case Form::sum:
      return how.margin * l / value;
  }
  return 0.0;
}

}  // namespace

Combined combine(Combination const& how, std::span<Part const> parts) {
  Combined all{.factor = value_of(how, parts)};
  double variance = 0.0, of_freedom = 0.0, straight = 0.0, total = 0.0, shown = 0.0;
  for (auto const& part : parts) {
    if (!counts(part, how.form)) continue;
    auto const& factor = part.factor;
    all.status = std::max(all.status, factor.status);
    if (factor.status == Status::not_covered) {
      all.not_covered.push_back(part.effect);
      continue;
    }
    total += std::abs(factor.ln);
    if (factor.status == Status::shown || factor.status == Status::interpolated) shown += std::abs(factor.ln);
    if (factor.status == Status::assumed) {
      all.assumed.push_back(part.effect);
      continue;
    }
    if (!factor.se) {
      all.without_interval.push_back(part.effect);
      continue;
    }
    double const g = slope(how, parts, part, all.factor), v = g * g * *factor.se * *factor.se;
    variance += v;
    if (v > 0.0) of_freedom += v * v / *factor.df;
    straight += g * g * (factor.line_error * factor.line_error + factor.drift * factor.drift);
  }
  all.share_shown = total > 0.0 ? shown / total : 0.0;
  all.se = std::sqrt(variance);
  all.df = of_freedom > 0.0 ? variance * variance / of_freedom : 0.0;
  if (!all.without_interval.empty() || !all.complete()) return all;
  double const statistical = variance > 0.0 ? num::student_97_5(all.df) * all.se : 0.0;
  double const half = std::sqrt(statistical * statistical + straight);
  all.interval = {.low = all.factor * std::exp(-half), .high = all.factor * std::exp(half)};
  return all;
}

}  // namespace isolaw::conditions
