// Makes an invented study of a building, which several tests share: those of the study's answers and those of the files
// and pages that show the answers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "isolaw/building/runs.hpp"
#include "isolaw/building/synthetic_motion.hpp"
#include "unit/building_fixture.hpp"

namespace isolaw::building {

// Returns a bilinear law whose parameters K1 and K2 scatter in the population. The third parameter is the same for all
// devices.
inline LawSource bilinear_source(double scatter, std::size_t count) {
  auto const nominal = usual_bilinear(count);
  LawSource source{.law = "bilinear",
                   .lot = nominal,
                   .devices = {},
                   .population = {},
                   .place = {0, 1, std::nullopt},
                   .median = nominal,
                   .limits = {{}, {}},
                   .tested_mm = 0.0,
                   .springs = {}};
  auto& p = source.population;
  p.names = {"K1", "K2"};
  p.transforms = {lot::Transform::logarithm, lot::Transform::logarithm};
  p.signs = {1.0, 1.0};
  p.devices = 6;
  p.mean = {std::log(nominal[0]), std::log(nominal[1])};
  p.medians = {std::exp(p.mean[0]), std::exp(p.mean[1])};
  source.median = {p.medians[0], p.medians[1], nominal[2]};
  double const v = scatter * scatter;
  p.covariance = {{v, 0.8 * v}, {0.8 * v, v}};
  p.uncertainty = {{0.01 * v, 0.0}, {0.0, 0.01 * v}};
  p.estimates = {{1.01 * v, 0.8 * v}, {0.8 * v, 1.01 * v}};
  p.directions = 2;
  p.std = {scatter, scatter};
  return source;
}

inline Study usual_study(double scatter, int count, int populations = 0) {
  Study study;
  auto& f = study.file;
  f.settings = {.title = "test",
                .laws = {"bilinear"},
                .draws = count,
                .populations = populations,
                .draws_of_each = 4,
                .lower = whole(0.9),
                .upper = whole(1.1),
                .rest_s = 0.5};
  f.frame = three_floors();
  for (auto const& at : grid(3, 2, 6000.0).bearings)
    f.bearings.push_back({.at = at, .kind = BearingKind::draw, .device = {}});
  for (std::uint32_t i = 0; i < 2; ++i)
    f.motions.push_back(synthetic_motion(5, i, {.step_s = 0.02, .duration_s = 6.0, .peak_g = 0.4}));
  study.laws = {bilinear_source(scatter, 6)};
  return study;
}

}  // namespace isolaw::building
