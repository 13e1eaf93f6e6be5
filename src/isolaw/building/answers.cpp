#include "isolaw/building/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "isolaw/base/json.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::building {
namespace {

using std::numbers::pi;

double measure_of(std::span<double const> measured, Measure which) {
  return measured[static_cast<std::size_t>(which)];
}
double largest(std::span<double const> measured, std::size_t first, std::size_t count) {
  double made = 0.0;
  for (std::size_t i = 0; i < count; ++i) made = std::max(made, measured[first + i]);
  return made;
}
double ratio(double a, double b) {
  return b > 0.0 ? a / b : 0.0;
}

constexpr Quantity rows[]{
    {"isolator_mm", "mm", "largest displacement of any bearing",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::isolator); }},
    {"centre_mm", "mm", "largest displacement of the base's centre of mass",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::centre); }},
    {"corner_mm", "mm", "largest displacement of a corner of the base",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::corner); }},
    {"corner_over_centre", "-", "the one over the other: torsion",
     [](Layout const&, std::span<double const> m, double) {
       return ratio(measure_of(m, Measure::corner), measure_of(m, Measure::centre));
     }},
    {"rotation_mrad", "mrad", "largest rotation of the base",
     [](Layout const&, std::span<double const> m, double) { return 1e3 * measure_of(m, Measure::rotation); }},
    {"residual_mm", "mm", "displacement of the centre when the rest after the motion ends",
     [](Layout const&, std::span<double const> m, double) { return measure_of(m, Measure::end); }},
    {"shear_over_weight", "-", "largest sum of the bearings' forces over the weight",
     [](Layout const&, std::span<double const> m, double weight) { return measure_of(m, Measure::shear) / weight; }},
    {"base_acceleration_g", "g", "largest acceleration of the base slab in space, at samples",
     [](Layout const& l, std::span<double const> m, double) { return m[l.acceleration(0)] / 9806.65; }},
    {"roof_acceleration_g", "g", "of the highest floor",
     [](Layout const& l, std::span<double const> m, double) { return m[l.acceleration(l.floors)] / 9806.65; }},
    {"storey_shear_over_weight", "-", "largest shear of any storey over the whole weight",
     [](Layout const& l, std::span<double const> m, double weight) {
       return largest(m, l.storey_shear(0), l.floors) / weight;
     }},
    {"drift_mm", "mm", "largest drift of any storey, at its centre of stiffness",
     [](Layout const& l, std::span<double const> m, double) { return largest(m, l.drift(0), l.floors); }},
    {"energy_kNm", "kN m", "work done on the bearings",
     [](Layout const&, std::span<double const> m, double) { return 1e-3 * measure_of(m, Measure::hysteretic); }},
    {"worst_energy_share", "-", "of it, that of the bearing that takes most",
     [](Layout const& l, std::span<double const> m, double) {
       return ratio(largest(m, l.energy(0), l.bearings), measure_of(m, Measure::hysteretic));
     }},
};

// By linear interpolation between the values in order, the first at 0 and the last at 1.
double fractile(std::vector<double> const& sorted, double share) {
  if (sorted.empty()) return std::nan("");
  double const at = share * static_cast<double>(sorted.size() - 1);
  auto const i = static_cast<std::size_t>(at);
  if (i + 1 >= sorted.size()) return sorted.back();
  return sorted[i] + (at - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}
std::array<double, 4> fractiles(std::vector<double> values) {
  std::ranges::sort(values);
  std::array<double, 4> made{};
  for (std::size_t i = 0; i < made.size(); ++i) made[i] = fractile(values, shares[i]);
  return made;
}

double spread_ln(std::vector<double> const& values) {
  std::vector<double> logs;
  for (double const v : values)
    if (v > 0.0) logs.push_back(std::log(v));
  auto const made = num::moments(logs);
  return made.count < 2 ? 0.0 : made.std;
}

// [case] of one quantity under each motion.
struct Table {
  std::vector<std::vector<double>> by_motion;
  std::vector<double> mean;  // over motions
};

Table table_of(std::size_t cases, std::vector<std::vector<std::vector<double>>> const& kept, std::size_t index) {
  Table made{.by_motion = {}, .mean = std::vector<double>(cases, 0.0)};
  for (auto const& motion : kept) {
    auto& row = made.by_motion.emplace_back(motion[index]);
    for (std::size_t c = 0; c < cases; ++c) made.mean[c] += row[c] / static_cast<double>(kept.size());
  }
  return made;
}

std::vector<double> part(std::vector<double> const& values, std::size_t first, std::size_t count) {
  std::vector<double> made;
  for (std::size_t i = first; i < first + count; ++i)
    if (std::isfinite(values[i])) made.push_back(values[i]);
  return made;
}

// Of one direction, at rest at first: the largest relative displacement, average acceleration.
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

// The displacement whose effective stiffness and damping give it back from the motion's own response.
void equivalent_linear(Checked& made, Devices const& devices, Motion const& motion, std::vector<double> const& bearings,
                       double mass) {
  auto const& source = devices.source();
  std::size_t const each = source.lot.size(), count = bearings.size() / each;
  double at = 100.0;
  for (int i = 0; i < 60; ++i) {
    double k = 0.0, weighted = 0.0;
    Effective one;
    for (std::size_t j = 0; j < count; ++j) {
      auto const values = std::span(bearings).subspan(j * each, each);
      // Most are the same.
      if (j == 0 || !std::ranges::equal(values, std::span(bearings).subspan((j - 1) * each, each)))
        one = effective(source.law, values, at, devices.coupling());
      k += one.stiffness_kN_mm;
      weighted += one.stiffness_kN_mm * one.damping;
    }
    if (!(k > 0.0)) break;
    made.equivalent_period_s = 2.0 * pi * std::sqrt(mass / k);
    made.equivalent_damping = std::min(0.6, weighted / k);
    double const next = linear_peak(motion, made.equivalent_period_s, made.equivalent_damping);
    double const change = next - at;
    at = std::max(1e-3, at + 0.5 * change);
    if (std::abs(change) < 1e-4 * at) break;
  }
  made.equivalent_mm = at;
}

Coverage covered(std::vector<double> const& draws, double lower, double upper, std::vector<double> const& grid) {
  auto const [least, most] = std::minmax(lower, upper);
  Coverage made;
  std::size_t inside = 0, below = 0;
  for (double const v : draws) {
    inside += v >= least && v <= most;
    below += v < least;
  }
  auto const n = static_cast<double>(draws.size());
  if (draws.empty()) return made;
  made.inside = static_cast<double>(inside) / n;
  made.below = static_cast<double>(below) / n;
  made.above = 1.0 - made.inside - made.below;
  auto const interval = binomial_interval(inside, draws.size());
  made.interval_low = interval[0], made.interval_high = interval[1];
  double low = grid[grid_half], high = low;
  for (std::uint32_t a = 0; a <= grid_half; ++a) {
    for (double const v : {grid[grid_half - a], grid[grid_half + a]}) low = std::min(low, v), high = std::max(high, v);
    auto const within = std::ranges::count_if(draws, [&](double v) { return v >= low && v <= high; });
    if (static_cast<double>(within) < 0.95 * n) continue;
    made.factor_low = grid_factor(grid_half - a);
    made.factor_high = grid_factor(grid_half + a);
    break;
  }
  return made;
}

std::string verdict_of(Answers const& answers) {
  if (answers.laws.empty()) return {};
  auto const& first = answers.laws.front();
  if (first.coverage.empty() || first.draws == 0) return "no draws were made";
  auto const& c = first.coverage.front();
  auto text = fmt::format(
      "The bounds cover {:.0f} % of {} buildings ({:.0f} to {:.0f} %) in the largest displacement of a bearing",
      100.0 * c.inside, first.draws, 100.0 * c.interval_low, 100.0 * c.interval_high);
  text += c.factor_low
              ? fmt::format("; system factors of {:.2f}/{:.2f} would cover 95 %", *c.factor_high, *c.factor_low)
              : std::string("; no system factors up to 1.40/0.60 would cover 95 %");
  if (answers.law_std_ln) {
    double const lot = first.distributions.front().lot_std_ln;
    text += *answers.law_std_ln > lot ? "; the law matters more than the lot" : "; the lot matters more than the law";
  }
  return text + ".";
}

}  // namespace

std::span<Quantity const> quantities() {
  return rows;
}

std::array<double, 2> binomial_interval(std::size_t found, std::size_t of, double level) {
  if (of == 0) return {0.0, 1.0};
  using Binomial = boost::math::binomial_distribution<>;
  auto const n = static_cast<double>(of), k = static_cast<double>(found);
  double const tail = 0.5 * (1.0 - level);
  return {found == 0 ? 0.0 : Binomial::find_lower_bound_on_p(n, k, tail),
          found == of ? 1.0 : Binomial::find_upper_bound_on_p(n, k, tail)};
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
  Arrangement made;
  made.device.resize(stiffness.size());
  std::iota(made.device.begin(), made.device.end(), std::size_t{0});
  auto const eccentricity = [&] {
    double sum = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double const k = stiffness[made.device[i]];
      sum += k, x += k * (places[i].x_mm - centre.x_mm), y += k * (places[i].y_mm - centre.y_mm);
    }
    return std::hypot(x, y) / sum;
  };
  made.in_order_mm = made.eccentricity_mm = eccentricity();
  for (bool better = true; better;) {
    better = false;
    std::size_t best_i = 0, best_j = 0;
    double best = made.eccentricity_mm * (1.0 - 1e-12);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < made.device.size(); ++j) {
        std::swap(made.device[i], made.device[j]);
        if (double const now = eccentricity(); now < best) best = now, best_i = i, best_j = j, better = true;
        std::swap(made.device[i], made.device[j]);
      }
    if (!better) break;
    std::swap(made.device[best_i], made.device[best_j]);
    made.eccentricity_mm = best;
  }
  made.device.resize(n);
  return made;
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
  Answers made;
  made.weight_kN = model.structure().weight_kN();
  for (double const w : model.structure().frequency_rad_s()) made.fixed_periods_s.push_back(2.0 * pi / w);
  for (std::size_t law = 0; law < study.laws.size(); ++law) {
    auto& out = made.laws.emplace_back();
    auto const& source = study.laws[law];
    out.law = source.law;
    out.draws = static_cast<std::size_t>(settings.draws);
    // [motion][quantity][case]
    std::vector<std::vector<std::vector<double>>> kept(
        study.file.motions.size(),
        std::vector<std::vector<double>>(std::size(rows), std::vector<double>(cases.size(), std::nan(""))));
    for (std::size_t motion = 0; motion < kept.size(); ++motion)
      store.each(law, motion, [&](std::size_t place, std::vector<double> const& measured) {
        bool const finite = std::ranges::all_of(measured, [](double v) { return std::isfinite(v); });
        out.failed += !finite;
        if (!finite) return;
        for (std::size_t q = 0; q < std::size(rows); ++q)
          kept[motion][q][place] = rows[q].of(layout, measured, made.weight_kN);
        out.worst_balance = std::max(out.worst_balance, std::abs(measure_of(measured, Measure::balance)));
      });
    for (std::size_t q = 0; q < std::size(rows); ++q) {
      auto const table = table_of(cases.size(), kept, q);
      auto const draws = part(table.mean, first_draw, static_cast<std::size_t>(settings.draws));
      Distribution d{.nominal = table.mean[0],
                     .lower = table.mean[1],
                     .upper = table.mean[2],
                     .fractiles = fractiles(draws),
                     .uncertain_std_ln = {},
                     .by_motion = {},
                     .nominal_by_motion = {}};
      // Var ln = Var over motions of the mean + mean over motions of the variance.
      std::vector<double> means;
      double within = 0.0;
      for (auto const& row : table.by_motion) {
        auto const of_motion = part(row, first_draw, static_cast<std::size_t>(settings.draws));
        d.by_motion.push_back(fractiles(of_motion));
        d.nominal_by_motion.push_back(row[0]);
        std::vector<double> logs;
        for (double const v : of_motion)
          if (v > 0.0) logs.push_back(std::log(v));
        if (logs.empty()) continue;
        auto const of = num::moments(logs);
        means.push_back(of.mean);
        within += of.count > 1 ? of.std * of.std : 0.0;
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
      if (std::ranges::find(covered_quantities, rows[q].key) != std::end(covered_quantities))
        out.coverage.push_back(covered(draws, d.lower, d.upper, part(table.mean, first_factor, 2 * grid_half + 1)));
      out.distributions.push_back(std::move(d));
    }

    Devices const devices(source, study.file);
    auto const nominal = devices.of({});
    auto const options = options_of(study, model, devices);
    for (std::size_t motion = 0; motion < kept.size(); ++motion) {
      auto& checked = out.checked.emplace_back();
      auto half = options;
      half.longest_step_s = 0.5 * steps_of(study.file.motions[motion], options.longest_step_s, 0.0).dt;
      auto const run = integrate(model, devices.bearings(nominal), study.file.motions[motion], options);
      auto const fine = integrate(model, devices.bearings(nominal), study.file.motions[motion], half);
      checked.outcome = run.outcome == Outcome::completed ? std::string(name(run.outcome)) : run.why;
      checked.isolator_mm = run.of(Measure::isolator);
      checked.balance = run.of(Measure::balance);
      checked.step_s = run.step_s;
      checked.missed_mm = richardson(run, fine)[static_cast<std::size_t>(Measure::isolator)];
      checked.lanes_off_percent = 100.0 * (kept[motion][0][0] / checked.isolator_mm - 1.0);
      equivalent_linear(checked, devices, study.file.motions[motion], nominal, model.structure().mass()(0, 0));
      checked.equivalent_error_percent = 100.0 * (checked.equivalent_mm / run.of(Measure::centre) - 1.0);
    }
  }
  if (made.laws.size() > 1) {
    std::vector<double> medians;
    for (auto const& law : made.laws) medians.push_back(law.distributions.front().fractiles[1]);
    made.law_std_ln = spread_ln(medians);
  }
  for (std::size_t i = 0; i < made.laws.size(); ++i) {
    auto const& law = made.laws[i];
    double const tested = study.laws[i].tested_mm, most = law.distributions.front().fractiles[3];
    if (tested > 0.0 && most > tested)
      made.warnings.push_back(fmt::format(
          "{}: bearings move up to {:.0f} mm (95 % of the draws), and the tests went to {:.0f} mm: beyond it the law is extrapolated",
          law.law, most, tested));
    if (law.failed > 0)
      made.warnings.push_back(fmt::format("{}: {} runs gave no finite numbers and are left out", law.law, law.failed));
  }
  made.verdict = verdict_of(made);
  return made;
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
  std::string made = "time [s]";
  auto const head = [&](std::string_view what, std::string_view unit) {
    for (std::size_t axis = 0; axis < axes; ++axis) made += fmt::format(",{}_{} [{}]", what, "xy"[axis], unit);
  };
  head("base", "mm");
  head("velocity", "mm/s");
  head("force", "kN");
  for (std::size_t floor = 0; floor < diaphragms; ++floor)
    head(floor == 0 ? std::string("acceleration_base") : fmt::format("acceleration_{}", floor), "mm/s2");
  made += '\n';
  for (std::size_t i = 0; i < history.time_s.size(); ++i) {
    made += fmt::format("{:.6g}", history.time_s[i]);
    auto const add = [&](auto const& values, std::size_t first) {
      for (std::size_t axis = 0; axis < axes; ++axis) made += fmt::format(",{:.6g}", values[first + axis]);
    };
    add(history.base[i], 0);
    add(history.velocity[i], 0);
    add(history.shear_kN[i], 0);
    for (std::size_t floor = 0; floor < diaphragms; ++floor) add(history.acceleration[i], 2 * floor);
    made += '\n';
  }
  return made;
}

std::string answers_json(Study const& study, Answers const& answers) {
  JsonWriter json(JsonWriter::Layout::indented);
  constexpr std::string_view names[]{"p16", "p50", "p84", "p95"};
  auto const fractiles_of = [&](std::array<double, 4> const& values) {
    for (std::size_t i = 0; i < values.size(); ++i) json.member(names[i], values[i]);
  };
  json.begin_object();
  json.member("title", study.file.settings.title);
  json.member("verdict", answers.verdict);
  json.member("warnings", answers.warnings);
  json.member("weight_kN", answers.weight_kN);
  json.key("fixed_base_periods_s").begin_array();
  for (double const t : answers.fixed_periods_s) json.value(t);
  json.end_array();
  json.member("draws", study.file.settings.draws);
  json.member("seed", study.file.settings.seed);
  json.key("motions").begin_array();
  for (auto const& m : study.file.motions) {
    double peak = 0.0;
    for (std::size_t i = 0; i < m.x_mm_s2.size(); ++i)
      peak = std::max(peak, std::hypot(m.x_mm_s2[i], m.y_mm_s2.empty() ? 0.0 : m.y_mm_s2[i]));
    json.begin_object()
        .member("name", m.name)
        .member("components", m.y_mm_s2.empty() ? 1 : 2)
        .member("step_s", m.step_s);
    json.member("samples", static_cast<std::uint64_t>(m.x_mm_s2.size())).member("peak_g", peak / 9806.65).end_object();
  }
  json.end_array();
  json.member("law_std_ln", answers.law_std_ln);
  json.key("laws").begin_array();
  for (auto const& law : answers.laws) {
    json.begin_object().member("id", law.law).member("draws", static_cast<std::uint64_t>(law.draws));
    json.member("failed", static_cast<std::uint64_t>(law.failed));
    json.key("peak_mm").begin_object();
    fractiles_of(law.distributions.front().fractiles);
    json.end_object();
    json.key("coverage").begin_object();
    auto const coverage = [&](Coverage const& c) {
      json.member("inside", c.inside).member("lower", c.interval_low).member("upper", c.interval_high);
      json.member("below", c.below).member("above", c.above);
      json.member("factor_low", c.factor_low).member("factor_high", c.factor_high);
    };
    coverage(law.coverage.front());
    json.key("of").begin_object();
    for (std::size_t i = 0; i < law.coverage.size(); ++i) {
      json.key(covered_quantities[i]).begin_object();
      coverage(law.coverage[i]);
      json.end_object();
    }
    json.end_object().end_object();
    json.member("energy_error", law.worst_balance);
    json.key("quantities").begin_object();
    for (std::size_t q = 0; q < law.distributions.size(); ++q) {
      auto const& d = law.distributions[q];
      json.key(rows[q].key).begin_object();
      json.member("unit", rows[q].unit).member("meaning", rows[q].meaning);
      json.member("nominal", d.nominal).member("lower", d.lower).member("upper", d.upper);
      fractiles_of(d.fractiles);
      json.member("motion_std_ln", d.motion_std_ln).member("lot_std_ln", d.lot_std_ln).member("lot_share", d.lot_share);
      json.member("uncertain_std_ln", d.uncertain_std_ln);
      json.key("by_motion").begin_array();
      for (std::size_t m = 0; m < d.by_motion.size(); ++m) {
        json.begin_object().member("nominal", d.nominal_by_motion[m]);
        fractiles_of(d.by_motion[m]);
        json.end_object();
      }
      json.end_array().end_object();
    }
    json.end_object();
    json.key("checked").begin_array();
    for (auto const& c : law.checked) {
      json.begin_object()
          .member("outcome", c.outcome)
          .member("isolator_mm", c.isolator_mm)
          .member("energy_error", c.balance);
      json.member("step_s", c.step_s).member("missed_mm", c.missed_mm).member("lanes_off_percent", c.lanes_off_percent);
      json.member("equivalent_mm", c.equivalent_mm).member("equivalent_error_percent", c.equivalent_error_percent);
      json.member("equivalent_period_s", c.equivalent_period_s)
          .member("equivalent_damping", c.equivalent_damping)
          .end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().end_object();
  return json.take();
}

}  // namespace isolaw::building
