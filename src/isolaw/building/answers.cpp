#include "isolaw/building/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::building {
namespace {

using std::numbers::pi;

double measure_of(std::span<double const> measured, Measure which) {
  return measured[static_cast<std::size_t>(which)];
}
double largest(std::span<double const> measured, std::size_t first, std::size_t count) {
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) most = std::max(most, measured[first + i]);
  return most;
}
double ratio(double a, double b) {
  return b > 0.0 ? a / b : 0.0;
}

constexpr std::string_view alike =
    "the bound analyses take every bearing alike, and so without the torsion of unequal ones";
constexpr Quantity quantity_rows[]{
    {"isolator_mm", "bearing displacement", "mm", "largest displacement of any bearing",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::isolator); }},
    {"centre_mm", "centre displacement", "mm", "largest displacement of the base's centre of mass",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::centre); }},
    {"corner_mm", "corner displacement", "mm", "largest displacement of a corner of the base",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::corner); }},
    {"corner_over_centre", "corner over centre", "-", "the one over the other: torsion",
     [](Layout const&, std::span<double const> m, double) {
       return ratio(measure_of(m, Measure::corner), measure_of(m, Measure::centre));
     },
     alike},
    {"rotation_mrad", "rotation", "mrad", "largest rotation of the base",
     [](Layout const&, std::span<double const> m, double) { return 1e3 * measure_of(m, Measure::rotation); }, alike},
    {"residual_mm", "residual displacement", "mm", "displacement of the centre when the rest after the motion ends",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::end); }},
    {"shear_over_weight", "base shear over weight", "-", "largest sum of the bearings' forces over the weight",
     [](Layout const&, std::span<double const> m, double weight) { return measure_of(m, Measure::shear) / weight; }},
    {"base_acceleration_g", "base acceleration", "g", "largest acceleration of the base slab in space, at samples",
     [](Layout const& l, std::span<double const> m, double) { return m[l.acceleration(0)] / data::gravity_mm_s2; }},
    {"roof_acceleration_g", "roof acceleration", "g", "of the highest floor",
     [](Layout const& l, std::span<double const> m, double) {
       return m[l.acceleration(l.floors)] / data::gravity_mm_s2;
     }},
    {"storey_shear_over_weight", "storey shear over weight", "-", "largest shear of any storey over the whole weight",
     [](Layout const& l, std::span<double const> m, double weight) {
       return largest(m, l.storey_shear(0), l.floors) / weight;
     }},
    {"drift_mm", "storey drift", "mm", "largest drift of any storey, at its centre of stiffness",
     [](Layout const& l, std::span<double const> m, double) { return largest(m, l.drift(0), l.floors); }},
    {"energy_kNm", "work on bearings", "kN m", "work done on the bearings",
     [](Layout const&, std::span<double const> m, double) { return 1e-3 * measure_of(m, Measure::hysteretic); }},
    {"worst_energy_share", "largest share of work", "-", "of it, that of the bearing that takes most",
     [](Layout const& l, std::span<double const> m, double) {
       return ratio(largest(m, l.energy(0), l.bearings), measure_of(m, Measure::hysteretic));
     },
     alike},
};

// Interpolates linearly between the sorted values: share 0 gives the smallest value and share 1 the largest.
double fractile(std::vector<double> const& sorted, double share) {
  if (sorted.empty()) return std::nan("");
  double const place = share * static_cast<double>(sorted.size() - 1);
  auto const i = static_cast<std::size_t>(place);
  if (i + 1 >= sorted.size()) return sorted.back();
  return sorted[i] + (place - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}
std::array<double, 4> fractiles(std::vector<double> values) {
  std::ranges::sort(values);
  std::array<double, 4> at_shares{};
  for (std::size_t i = 0; i < at_shares.size(); ++i) at_shares[i] = fractile(values, shares[i]);
  return at_shares;
}

double spread_ln(std::vector<double> const& values) {
  std::vector<double> logs;
  for (double const v : values)
    if (v > 0.0) logs.push_back(std::log(v));
  auto const moments = num::moments(logs);
  return moments.count < 2 ? 0.0 : moments.std;
}

struct Table {                                 // the values of one quantity in all runs of a law
  std::vector<std::vector<double>> by_motion;  // [motion][case]
  std::vector<double> mean;                    // [case] mean over the motions
};

Table table_of(std::size_t cases, std::vector<std::vector<std::vector<double>>> const& kept, std::size_t index) {
  Table table{.by_motion = {}, .mean = std::vector<double>(cases, 0.0)};
  for (auto const& motion : kept) {
    auto& row = table.by_motion.emplace_back(motion[index]);
    for (std::size_t c = 0; c < cases; ++c) table.mean[c] += row[c] / static_cast<double>(kept.size());
  }
  return table;
}

std::vector<double> part(std::vector<double> const& values, std::size_t first, std::size_t count) {
  std::vector<double> finite;
  for (std::size_t i = first; i < first + count; ++i)
    if (std::isfinite(values[i])) finite.push_back(values[i]);
  return finite;
}

// Largest relative displacement of a linear oscillator that starts at rest, by Newmark's average acceleration.
double linear_peak(Motion const& motion, double period_s, double damping) {
  double const w = 2.0 * pi / period_s;
  auto const parts = static_cast<std::size_t>(std::ceil(motion.step_s / std::min(0.005, period_s / 50.0)));
  double const dt = motion.step_s / static_cast<double>(parts);
  double const share = 1.0 / (1.0 + damping * w * dt + 0.25 * w * w * dt * dt);
  double u[2]{}, v[2]{}, a[2]{}, most = 0.0;
  for (std::size_t i = 0; i + 1 < motion.x_mm_s2.size(); ++i)
    for (std::size_t k = 1; k <= parts; ++k) {
      double const part = static_cast<double>(k) / static_cast<double>(parts);
      for (std::size_t d = 0; d < 2; ++d) {
        auto const& ground = d == 0 ? motion.x_mm_s2 : motion.y_mm_s2;
        if (ground.empty()) continue;
        double const g = ground[i] + part * (ground[i + 1] - ground[i]);
        double const speed = v[d] + 0.5 * dt * a[d], place = u[d] + dt * v[d] + 0.25 * dt * dt * a[d];
        double const next = share * (-g - 2.0 * damping * w * speed - w * w * place);
        u[d] = place + 0.25 * dt * dt * next;
        v[d] = speed + 0.5 * dt * next;
        a[d] = next;
      }
      most = std::max(most, std::hypot(u[0], u[1]));
    }
  return most;
}

// Iterates to the displacement D at which a linear oscillator with the bearings' stiffness and damping at D peaks at D.
void equivalent_linear(Checked& checked, Devices const& devices, Motion const& motion,
                       std::vector<double> const& bearings, double mass) {
  auto const& source = devices.source();
  std::size_t const each = source.lot.size(), count = bearings.size() / each;
  double amplitude_mm = 100.0;
  for (int i = 0; i < 60; ++i) {
    double k = 0.0, weighted = 0.0;
    Effective bearing;
    for (std::size_t j = 0; j < count; ++j) {
      auto const values = std::span(bearings).subspan(j * each, each);
      if (j == 0 || !std::ranges::equal(values, std::span(bearings).subspan((j - 1) * each, each)))
        bearing = effective(source.law, values, amplitude_mm, devices.coupling());
      k += bearing.stiffness_kN_mm;
      weighted += bearing.stiffness_kN_mm * bearing.damping;
    }
    if (!(k > 0.0)) break;
    checked.equivalent_period_s = 2.0 * pi * std::sqrt(mass / k);
    checked.equivalent_damping = std::min(0.6, weighted / k);
    double const next = linear_peak(motion, checked.equivalent_period_s, checked.equivalent_damping);
    double const change = next - amplitude_mm;
    amplitude_mm = std::max(1e-3, amplitude_mm + 0.5 * change);
    if (std::abs(change) < 1e-4 * amplitude_mm) break;
  }
  checked.equivalent_mm = amplitude_mm;
}

Coverage covered(Quantity const& quantity, std::vector<double> const& draws, Distribution const& d,
                 Settings const& settings, std::vector<double> const& grid) {
  auto const [least, most] = std::minmax(d.lower, d.upper);
  Coverage coverage{.quantity = quantity.key, .factor_low = {}, .factor_high = {}, .not_monotonic = {}};
  constexpr double rounding = 1e-9;  // relative tolerance, so that equal responses count as monotonic
  if (d.nominal < least - rounding * std::abs(least) || d.nominal > most + rounding * std::abs(most)) {
    coverage.monotony = Finding{.kind = FindingKind::bounds_not_monotonic,
                                .numbers = {{"lower", d.lower},
                                            {"nominal", d.nominal},
                                            {"upper", d.upper},
                                            {"lower_factor", settings.lower},
                                            {"upper_factor", settings.upper}},
                                .words = {{"quantity", std::string(quantity.title)},
                                          {"unit", quantity.unit == "-" ? "" : std::string(quantity.unit)},
                                          {"side", d.nominal < least ? "above" : "below"}}};
    coverage.not_monotonic = wording::remark(*coverage.monotony);
  }
  std::size_t inside = 0, below = 0;
  for (double const v : draws) {
    inside += v >= least && v <= most;
    below += v < least;
  }
  auto const n = static_cast<double>(draws.size());
  if (draws.empty()) return coverage;
  coverage.inside = static_cast<double>(inside) / n;
  coverage.below = static_cast<double>(below) / n;
  coverage.above = 1.0 - coverage.inside - coverage.below;
  auto const interval = binomial_interval(inside, draws.size());
  coverage.interval_low = interval[0], coverage.interval_high = interval[1];
  double low = grid[grid_half], high = low;
  for (std::uint32_t a = 0; a <= grid_half; ++a) {
    for (double const v : {grid[grid_half - a], grid[grid_half + a]}) low = std::min(low, v), high = std::max(high, v);
    auto const within = std::ranges::count_if(draws, [&](double v) { return v >= low && v <= high; });
    if (static_cast<double>(within) < wanted_share * n) continue;
    coverage.factor_low = grid_factor(grid_half - a);
    coverage.factor_high = grid_factor(grid_half + a);
    break;
  }
  return coverage;
}

bool has_draws(Study const& study) {
  return std::ranges::any_of(study.file.bearings, [](auto const& b) { return b.stands == Stands::draw; });
}

double largest_of_motions(Distribution const& distribution) {
  double most = distribution.fractiles[3];
  for (auto const& motion : distribution.by_motion) most = std::max(most, motion[3]);
  return most;
}

std::vector<Finding> verdict_of(Study const& study, Answers const& answers) {
  if (answers.laws.empty()) return {};
  auto const& first = answers.laws.front();
  if (!has_draws(study)) return {{.kind = FindingKind::building_no_draws}};
  auto const& c = first.coverage.front();
  Finding cover{.kind = FindingKind::building_bounds_cover,
                .law = first.law,
                .numbers = {{"inside", c.inside},
                            {"interval_low", c.interval_low},
                            {"interval_high", c.interval_high},
                            {"draws", static_cast<double>(first.draws)}},
                .words = {{"answer", !answers.bounds_are_enough   ? "No answer yet"
                                     : *answers.bounds_are_enough ? "Yes"
                                                                  : "No"},
                          {"nominal_outside", c.monotony && c.inside < wanted_share ? "yes" : ""}}};
  auto const factors = covering_factors(c);
  cover.numbers.insert(cover.numbers.end(), factors.numbers.begin(), factors.numbers.end());
  cover.words.insert(cover.words.end(), factors.words.begin(), factors.words.end());
  std::vector<Finding> verdict{std::move(cover)};
  for (auto const& law : answers.laws)
    if (law.by_first_bounds && *law.by_first_bounds < wanted_share)
      verdict.push_back({.kind = FindingKind::building_bounds_cover_with,
                         .law = law.law,
                         .numbers = {{"inside", *law.by_first_bounds}}});
  if (answers.law_std_ln) {
    double const lot = first.distributions.front().lot_std_ln;
    bool const law_matters_more = *answers.law_std_ln > lot;
    verdict.push_back(
        {.kind = FindingKind::building_law_or_lot,
         .numbers = {{"law_std_ln", *answers.law_std_ln}, {"lot_std_ln", lot}},
         .words = {{"more", law_matters_more ? "law" : "lot"}, {"less", law_matters_more ? "lot" : "law"}}});
  }
  return verdict;
}

std::optional<bool> bounds_are_enough(Study const& study, Answers const& answers) {
  if (!has_draws(study) || answers.laws.empty()) return {};
  auto const& own = answers.laws.front().coverage.front();
  bool const refuted = own.inside < wanted_share || std::ranges::any_of(answers.laws, [](LawAnswer const& law) {
                         return law.by_first_bounds && *law.by_first_bounds < wanted_share;
                       });
  if (refuted) return false;
  return own.interval_low >= wanted_share ? std::optional(true) : std::nullopt;
}

std::string_view form_sentence(LawAnswer const& law) {
  switch (law.coupling) {
    case Coupling::coupled:
      return "in its coupled form";
    case Coupling::separate:
      return "once along each axis, the motions being along x alone";
    case Coupling::springs:
      break;
  }
  return law.fitted_as_springs
             ? "as sixteen springs around the circle, with parameters fitted as such to the tests"
             : "as sixteen springs around the circle, with the parameters of the law along one direction, so that they dissipate less";
}

BearingLoops loops_of(Model const& model, Devices const& devices, Study const& study, std::size_t motion,
                      Options options) {
  options.bearing_forces = true;
  bool const drawn = has_draws(study);
  auto const bearings = devices.bearings(devices.of({.kind = drawn ? CaseKind::draw : CaseKind::nominal}));
  auto const run = integrate(model, bearings, study.file.motions[motion], options);
  auto const& h = run.history;
  auto const samples = h.time_s.size(),
             stride = std::max<std::size_t>(1, (samples + most_of_loops - 1) / most_of_loops);
  BearingLoops loops{.motion = motion,
                     .drawn = drawn,
                     .step_s = run.step_s * static_cast<double>(stride),
                     .x_mm = {},
                     .y_mm = {},
                     .rotation_rad = {},
                     .force_x_kN = std::vector<std::vector<double>>(bearings.size()),
                     .force_y_kN = std::vector<std::vector<double>>(bearings.size())};
  for (std::size_t i = 0; i < samples; i += stride) {
    loops.x_mm.push_back(h.base[i][0]);
    loops.y_mm.push_back(h.base[i][1]);
    loops.rotation_rad.push_back(h.base[i][2]);
    for (std::size_t j = 0; j < bearings.size(); ++j) {
      loops.force_x_kN[j].push_back(h.bearing_kN[i][2 * j]);
      loops.force_y_kN[j].push_back(h.bearing_kN[i][2 * j + 1]);
    }
  }
  return loops;
}

void add_spectra(std::vector<std::vector<double>>& to, Response const& run, double share) {
  auto const& periods = spectrum_periods_s();
  if (run.history.acceleration.empty()) return;
  auto const diaphragms = run.history.acceleration.front().size() / 2;
  to.resize(diaphragms, std::vector<double>(periods.size(), 0.0));
  for (std::size_t d = 0; d < diaphragms; ++d) {
    Motion floor{.name = {}, .step_s = run.step_s, .x_mm_s2 = {}};
    for (auto const& a : run.history.acceleration) {
      floor.x_mm_s2.push_back(a[2 * d]);
      floor.y_mm_s2.push_back(a[2 * d + 1]);
    }
    for (std::size_t p = 0; p < periods.size(); ++p) {
      double const w = 2.0 * pi / periods[p];
      to[d][p] += share * w * w * linear_peak(floor, periods[p], spectrum_damping) / data::gravity_mm_s2;
    }
  }
}

// Warns of each quantity for which the bound analyses enclose too few draws. The verdict says this of the first one,
// the bearing displacement, so it is warned of only if the bounds are not monotonic.
void warn_of_coverage(LawAnswer const& law, std::vector<Finding>& warnings) {
  for (auto const& c : law.coverage) {
    if (c.inside >= wanted_share) continue;
    if (c.monotony) {
      auto& warning = warnings.emplace_back(*c.monotony);
      warning.law = law.law;
      warning.numbers.push_back({"inside", c.inside});
    } else if (&c != &law.coverage.front()) {
      warnings.push_back({.kind = FindingKind::bounds_cover_less,
                          .law = law.law,
                          .numbers = {{"inside", c.inside}, {"wanted", wanted_share}},
                          .words = {{"quantity", std::string(quantity(c.quantity).title)}}});
    }
  }
}

std::vector<std::string> assumed_of(Study const& study, Answers const& answers) {
  auto const& s = study.file.settings;
  std::vector<std::string> sentences;
  auto const count = [&](Stands stands) {
    return std::ranges::count(study.file.bearings, stands, &BearingPlace::stands);
  };
  sentences.push_back(fmt::format(
      "Of {} bearings {} are draws of the lot, {} its law, {} tested devices, {} and {} its law times the lower and the upper factor.",
      study.file.bearings.size(), count(Stands::draw), count(Stands::lot), count(Stands::device), count(Stands::lower),
      count(Stands::upper)));
  sentences.push_back(fmt::format(
      "The bound analyses take every bearing at its nominal values, forces times {:.2f} and {:.2f}: stiffness and strength alike.",
      s.lower, s.upper));
  sentences.push_back(fmt::format("A building's response is its mean over {}, each scaled as the building file says.",
                                  counted(study.file.motions.size(), "motion")));
  sentences.push_back(
      s.populations > 1
          ? fmt::format("The population is as uncertain as the tests leave it: {} populations of {} draws.",
                        s.populations, s.draws_of_each)
          : std::string("The lot's population is taken as known: what few tests leave open is not in it."));
  for (auto const& law : answers.laws)
    sentences.push_back(fmt::format("{} goes into the plane {}.", laws::called(law.law), form_sentence(law)));
  sentences.push_back(fmt::format(
      "The superstructure is linear, {} above the base, {:.3g} s on a fixed base, {:.3g} % of damping in every mode; none of it is in the isolation layer.",
      study.file.frame.floors.empty() ? std::string("nothing")
                                      : fmt::format("{} floors", study.file.frame.floors.size()),
      answers.fixed_periods_s.empty() ? 0.0 : answers.fixed_periods_s.front(), 100.0 * s.damping));
  sentences.emplace_back(
      "Bearings move in plan: no axial load and its changes, no uplift, no vertical motion, no soil.");
  return sentences;
}

// Keeps every n-th sample, so that at most most_of_history remain. The last sample may be left out.
NominalHistory thinned(History const& history, double step_s) {
  auto const samples = history.time_s.size();
  auto const stride = std::max<std::size_t>(1, (samples + most_of_history - 1) / most_of_history);
  NominalHistory nominal{
      .step_s = step_s * static_cast<double>(stride), .x_mm = {}, .y_mm = {}, .shear_x_kN = {}, .shear_y_kN = {}};
  for (std::size_t i = 0; i < samples; i += stride) {
    nominal.x_mm.push_back(history.base[i][0]);
    nominal.y_mm.push_back(history.base[i][1]);
    nominal.shear_x_kN.push_back(history.shear_kN[i][0]);
    nominal.shear_y_kN.push_back(history.shear_kN[i][1]);
  }
  return nominal;
}

}  // namespace

std::span<Quantity const> quantities() {
  return quantity_rows;
}
Quantity const& quantity(std::string_view key) {
  return *std::ranges::find(quantity_rows, key, &Quantity::key);
}

// Thirty periods from 0.05 s (stiff equipment) to 4 s (isolators), each a fixed factor longer than the one before.
std::vector<double> const& spectrum_periods_s() {
  static std::vector<double> const all_periods = [] {
    constexpr std::size_t count = 30;
    constexpr double first = 0.05, last = 4.0;
    std::vector<double> periods;
    for (std::size_t i = 0; i < count; ++i)
      periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
    return periods;
  }();
  return all_periods;
}

std::string_view form(LawAnswer const& law) {
  if (law.coupling == Coupling::coupled) return "coupled";
  if (law.coupling == Coupling::separate) return "separate";
  return law.fitted_as_springs ? "springs" : "springs as given";
}

Finding covering_factors(Coverage const& coverage) {
  Finding finding{.kind = FindingKind::covering_factors,
                  .numbers = {{"wanted", wanted_share},
                              {"grid_low", grid_factor(0)},
                              {"grid_high", grid_factor(2 * grid_half)},
                              {"grid_step", grid_step}}};
  constexpr double rounding = 1e-9;
  bool const near = coverage.factor_low && *coverage.factor_low > 1.0 - grid_step - rounding;
  finding.words = {{"factors", !coverage.factor_low ? "none" : near ? "near" : "found"}};
  if (coverage.factor_low) finding.numbers.push_back({"factor_low", *coverage.factor_low});
  if (coverage.factor_high) finding.numbers.push_back({"factor_high", *coverage.factor_high});
  return finding;
}

// Rice's rule gives the number of bins: 2 n^(1/3) for n values.
Histogram histogram(std::vector<double> const& values) {
  Histogram histogram;
  if (values.empty()) return histogram;
  auto const [least, most] = std::ranges::minmax(values);
  bool const spread = most - least > 1e-9 * std::abs(most);
  auto const bins =
      spread ? static_cast<std::size_t>(std::ceil(2.0 * std::cbrt(static_cast<double>(values.size())))) : 1;
  histogram.width = spread ? (most - least) / static_cast<double>(bins) : 1e-3 * std::abs(most);
  histogram.from = spread ? least : least - 0.5 * histogram.width;
  histogram.counts.assign(bins, 0);
  for (double const v : values)
    ++histogram.counts[spread ? std::min(bins - 1, static_cast<std::size_t>((v - least) / histogram.width)) : 0];
  return histogram;
}

std::array<double, 2> binomial_interval(std::size_t found, std::size_t trials, double level) {
  if (trials == 0) return {0.0, 1.0};
  using Binomial = boost::math::binomial_distribution<>;
  auto const n = static_cast<double>(trials), k = static_cast<double>(found);
  double const tail = 0.5 * (1.0 - level);
  return {found == 0 ? 0.0 : Binomial::find_lower_bound_on_p(n, k, tail),
          found == trials ? 1.0 : Binomial::find_upper_bound_on_p(n, k, tail)};
}

Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, Coupling coupling) {
  auto const bearing = make_bearing(law, parameters, coupling);
  constexpr int steps = 200, cycles = 3;
  double before = 0.0, force_before = 0.0, energy = 0.0, forward = 0.0, backward = 0.0;
  for (int i = 1; i <= steps * cycles; ++i) {
    double const x = amplitude_mm * std::sin(2.0 * pi * i / steps);
    double const force = bearing->trial({x, 0.0}, {0.0, 0.0}, 1.0 / steps).force.x;
    bearing->commit();
    if (i > steps * (cycles - 1)) energy += 0.5 * (force + force_before) * (x - before);
    if (i == steps * (cycles - 1) + steps / 4) forward = force;
    if (i == steps * (cycles - 1) + 3 * steps / 4) backward = force;
    before = x, force_before = force;
  }
  double const k = (forward - backward) / (2.0 * amplitude_mm);
  return {k, energy / (2.0 * pi * k * amplitude_mm * amplitude_mm)};
}

Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness) {
  auto const n = places.size();
  Arrangement arrangement;
  arrangement.device.resize(stiffness.size());
  std::iota(arrangement.device.begin(), arrangement.device.end(), std::size_t{0});
  auto const eccentricity = [&] {
    double sum = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double const k = stiffness[arrangement.device[i]];
      sum += k, x += k * (places[i].x_mm - centre.x_mm), y += k * (places[i].y_mm - centre.y_mm);
    }
    return std::hypot(x, y) / sum;
  };
  arrangement.in_order_mm = arrangement.eccentricity_mm = eccentricity();
  for (bool better = true; better;) {
    better = false;
    std::size_t best_i = 0, best_j = 0;
    double best = arrangement.eccentricity_mm * (1.0 - 1e-12);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < arrangement.device.size(); ++j) {
        std::swap(arrangement.device[i], arrangement.device[j]);
        if (double const now = eccentricity(); now < best) best = now, best_i = i, best_j = j, better = true;
        std::swap(arrangement.device[i], arrangement.device[j]);
      }
    if (!better) break;
    std::swap(arrangement.device[best_i], arrangement.device[best_j]);
    arrangement.eccentricity_mm = best;
  }
  arrangement.device.resize(n);
  return arrangement;
}

Answers answer(Study const& study, RunStore const& store) {
  Model const model(Structure(study.file.frame), study.file.plan());
  auto const layout = model.layout();
  auto const& settings = study.file.settings;
  auto const cases = cases_of(settings);
  auto const first_draw =
      static_cast<std::size_t>(std::ranges::find(cases, CaseKind::draw, &Case::kind) - cases.begin());
  auto const first_uncertain = first_draw + static_cast<std::size_t>(settings.draws);
  auto const first_factor =
      static_cast<std::size_t>(std::ranges::find(cases, CaseKind::factor, &Case::kind) - cases.begin());
  Answers answers;
  answers.weight_kN = model.structure().weight_kN();
  for (double const w : model.structure().frequency_rad_s()) answers.fixed_periods_s.push_back(2.0 * pi / w);
  answers.corners = model.plan().corners;
  for (std::size_t law = 0; law < study.laws.size(); ++law) {
    auto& out = answers.laws.emplace_back();
    auto const& source = study.laws[law];
    out.law = source.law;
    out.draws = static_cast<std::size_t>(settings.draws);
    out.doubts = source.doubts;
    out.bearing_mm.assign(layout.bearings, 0.0);
    out.bearing_energy_share.assign(layout.bearings, 0.0);
    double runs_of_draws = 0.0;
    // [motion][quantity][case]
    std::vector<std::vector<std::vector<double>>> kept(
        study.file.motions.size(),
        std::vector<std::vector<double>>(std::size(quantity_rows), std::vector<double>(cases.size(), std::nan(""))));
    for (std::size_t motion = 0; motion < kept.size(); ++motion)
      store.each(law, motion, [&](std::size_t place, std::vector<double> const& measured) {
        bool const finite = std::ranges::all_of(measured, [](double v) { return std::isfinite(v); });
        out.failed += !finite;
        if (!finite) return;
        for (std::size_t q = 0; q < std::size(quantity_rows); ++q)
          kept[motion][q][place] = quantity_rows[q].of(layout, measured, answers.weight_kN);
        out.worst_balance = std::max(out.worst_balance, std::abs(measure_of(measured, Measure::balance)));
        if (cases[place].kind != CaseKind::draw) return;
        runs_of_draws += 1.0;
        for (std::size_t b = 0; b < layout.bearings; ++b) {
          out.bearing_mm[b] += measured[layout.displacement(b)];
          out.bearing_energy_share[b] += ratio(measured[layout.energy(b)], measure_of(measured, Measure::hysteretic));
        }
      });
    for (auto* const means : {&out.bearing_mm, &out.bearing_energy_share})
      for (double& value : *means) value = runs_of_draws > 0.0 ? value / runs_of_draws : std::nan("");
    for (std::size_t q = 0; q < std::size(quantity_rows); ++q) {
      auto const table = table_of(cases.size(), kept, q);
      auto const draws = part(table.mean, first_draw, static_cast<std::size_t>(settings.draws));
      Distribution d{.nominal = table.mean[0],
                     .lower = table.mean[1],
                     .upper = table.mean[2],
                     .fractiles = fractiles(draws),
                     .uncertain_std_ln = {},
                     .by_motion = {},
                     .nominal_by_motion = {},
                     .histogram = histogram(draws)};
      // Var(ln response) = variance over motions of the means + mean over motions of the variances.
      std::vector<double> means;
      double within = 0.0;
      for (auto const& row : table.by_motion) {
        auto const motion_draws = part(row, first_draw, static_cast<std::size_t>(settings.draws));
        d.by_motion.push_back(fractiles(motion_draws));
        d.nominal_by_motion.push_back(row[0]);
        std::vector<double> logs;
        for (double const v : motion_draws)
          if (v > 0.0) logs.push_back(std::log(v));
        if (logs.empty()) continue;
        auto const moments = num::moments(logs);
        means.push_back(moments.mean);
        within += moments.count > 1 ? moments.std * moments.std : 0.0;
      }
      if (!means.empty()) {
        within /= static_cast<double>(means.size());
        double const between = means.size() > 1 ? std::pow(num::moments(means).std, 2) : 0.0;
        d.motion_std_ln = std::sqrt(between);
        d.lot_std_ln = std::sqrt(within);
        d.lot_share = between + within > 0.0 ? within / (between + within) : 0.0;
      }
      if (settings.populations > 1) {
        std::vector<double> medians;
        for (int p = 0; p < settings.populations; ++p)
          medians.push_back(
              num::median(part(table.mean, first_uncertain + static_cast<std::size_t>(p * settings.draws_of_each),
                               static_cast<std::size_t>(settings.draws_of_each))));
        d.uncertain_std_ln = spread_ln(medians);
      }
      if (quantity_rows[q].uncovered.empty())
        out.coverage.push_back(
            covered(quantity_rows[q], draws, d, settings, part(table.mean, first_factor, 2 * grid_half + 1)));
      if (q == 0 && answers.laws.size() > 1 && !draws.empty()) {
        auto const& bounds = answers.laws.front().distributions.front();
        auto const range = std::minmax(bounds.lower, bounds.upper);
        out.by_first_bounds = static_cast<double>(std::ranges::count_if(
                                  draws, [&](double v) { return v >= range.first && v <= range.second; })) /
                              static_cast<double>(draws.size());
      }
      out.distributions.push_back(std::move(d));
    }

    Devices const devices(source, study.file);
    auto const nominal = devices.of({});
    auto options = options_of(study, model, devices);
    options.histories = true;
    out.coupling = devices.coupling();
    out.fitted_as_springs = source.as_springs;
    double farthest = -1.0;
    std::size_t strongest = 0;
    for (std::size_t motion = 0; motion < kept.size(); ++motion) {
      auto& checked = out.checked.emplace_back();
      auto half = options;
      half.histories = false;
      half.longest_step_s = 0.5 * steps_of(study.file.motions[motion], options.longest_step_s, 0.0).dt;
      auto const run = integrate(model, devices.bearings(nominal), study.file.motions[motion], options);
      auto const fine = integrate(model, devices.bearings(nominal), study.file.motions[motion], half);
      out.histories.push_back(thinned(run.history, run.step_s));
      add_spectra(out.floor_spectra_g, run, 1.0 / static_cast<double>(kept.size()));
      if (run.of(Measure::isolator) > farthest) farthest = run.of(Measure::isolator), strongest = motion;
      checked.outcome = run.outcome == Outcome::completed ? std::string(name(run.outcome)) : run.why;
      checked.isolator_mm = run.of(Measure::isolator);
      checked.balance = run.of(Measure::balance);
      checked.step_s = run.step_s;
      checked.missed_mm = richardson(run, fine)[static_cast<std::size_t>(Measure::isolator)];
      checked.draws_error_percent = 100.0 * (kept[motion][0][0] / checked.isolator_mm - 1.0);
      equivalent_linear(checked, devices, study.file.motions[motion], nominal, model.structure().mass()(0, 0));
      checked.equivalent_error_percent = 100.0 * (checked.equivalent_mm / run.of(Measure::centre) - 1.0);
    }
    if (!kept.empty()) out.loops = loops_of(model, devices, study, strongest, options);
  }
  if (answers.laws.size() > 1) {
    std::vector<double> medians;
    for (auto const& law : answers.laws) medians.push_back(law.distributions.front().fractiles[1]);
    answers.law_std_ln = spread_ln(medians);
  }
  for (std::size_t i = 0; i < answers.laws.size(); ++i) {
    auto const& law = answers.laws[i];
    double const tested = study.laws[i].tested_mm, most = largest_of_motions(law.distributions.front());
    if (tested > 0.0 && most > tested)
      answers.warnings.push_back({.kind = FindingKind::displacement_beyond_tests,
                                  .law = law.law,
                                  .numbers = {{"most_mm", most}, {"tested_mm", tested}}});
    if (has_draws(study)) warn_of_coverage(law, answers.warnings);
    if (law.coupling == Coupling::springs && !law.fitted_as_springs)
      answers.warnings.push_back({.kind = FindingKind::springs_as_given, .law = law.law});
    if (law.failed > 0)
      answers.warnings.push_back({.kind = FindingKind::building_runs_failed,
                                  .law = law.law,
                                  .numbers = {{"failed", static_cast<double>(law.failed)}}});
    for (auto const& doubt : law.doubts)
      if (std::ranges::find(answers.calibration, doubt) == answers.calibration.end())
        answers.calibration.push_back(doubt);
  }
  answers.bounds_are_enough = bounds_are_enough(study, answers);
  answers.verdict = verdict_of(study, answers);
  if (has_draws(study) && !answers.laws.empty() && !answers.bounds_are_enough)
    answers.warnings.push_back(
        {.kind = FindingKind::draws_too_few,
         .numbers = {{"draws", static_cast<double>(answers.laws.front().draws)}, {"wanted", wanted_share}}});
  if (auto const motions = study.file.motions.size(); motions < motions_for_a_mean)
    answers.warnings.push_back(
        {.kind = FindingKind::motions_too_few,
         .numbers = {{"motions", static_cast<double>(motions)}, {"wanted", static_cast<double>(motions_for_a_mean)}}});
  answers.assumed = assumed_of(study, answers);
  return answers;
}

Response nominal_run(Study const& study, LawSource const& source, Motion const& motion) {
  Model const model(Structure(study.file.frame), study.file.plan());
  Devices const devices(source, study.file);
  auto options = options_of(study, model, devices);
  options.histories = true;
  return integrate(model, devices.bearings(devices.of({})), motion, options);
}

std::string history_csv(Response const& run, Motion const& motion) {
  auto const& history = run.history;
  std::size_t const diaphragms = history.acceleration.empty() ? 0 : history.acceleration.front().size() / 2;
  std::size_t const axes = motion.y_mm_s2.empty() ? 1 : 2;
  std::string csv = "time [s]";
  auto const head = [&](std::string_view what, std::string_view unit) {
    for (std::size_t axis = 0; axis < axes; ++axis) csv += fmt::format(",{}_{} [{}]", what, "xy"[axis], unit);
  };
  head("base", "mm");
  head("velocity", "mm/s");
  head("force", "kN");
  for (std::size_t floor = 0; floor < diaphragms; ++floor)
    head(floor == 0 ? std::string("acceleration_base") : fmt::format("acceleration_{}", floor), "mm/s2");
  csv += '\n';
  for (std::size_t i = 0; i < history.time_s.size(); ++i) {
    csv += fmt::format("{:.6g}", history.time_s[i]);
    auto const add = [&](auto const& values, std::size_t first) {
      for (std::size_t axis = 0; axis < axes; ++axis) csv += fmt::format(",{:.6g}", values[first + axis]);
    };
    add(history.base[i], 0);
    add(history.velocity[i], 0);
    add(history.shear_kN[i], 0);
    for (std::size_t floor = 0; floor < diaphragms; ++floor) add(history.acceleration[i], 2 * floor);
    csv += '\n';
  }
  return csv;
}

}  // namespace isolaw::building
