#include "isolaw/building/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "isolaw/base/words.hpp"
#include "isolaw/building/linear_oscillator.hpp"
#include "isolaw/building/plausibility.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::building {
namespace {

bool has_draws(Study const& study) {
  return study.file.settings.draws > 0 &&
         std::ranges::any_of(study.file.bearings, [](auto const& b) { return b.kind == BearingKind::draw; });
}

// The bearing displacement that 95 % of the draws do not exceed: the largest of its values under each motion and for
// the mean over the motions. If none of these values is finite, the result is the largest displacement of the nominal
// building under any motion.
Finding farthest(LawAnswer const& law, Study const& study, double tested_mm) {
  auto const& moves = law.distributions.front();
  constexpr std::size_t p95 = 3;
  double most = std::isfinite(moves.fractiles[p95]) ? moves.fractiles[p95] : 0.0;
  for (auto const& motion : moves.by_motion) most = motion[p95] > most ? motion[p95] : most;
  FindingWord of{"of", "draws"};
  if (!(most > 0.0))
    for (std::size_t i = 0; i < moves.nominal_by_motion.size(); ++i)
      if (moves.nominal_by_motion[i] > most) {
        most = moves.nominal_by_motion[i];
        of = {"motion", study.file.motions[i].name};
      }
  return {.kind = FindingKind::displacement_beyond_tests,
          .law = law.law,
          .numbers = {{"most_mm", most}, {"tested_mm", tested_mm}},
          .words = {std::move(of)}};
}

std::string titles_of(std::vector<LimitCheck> const& judged, LimitKept keeps) {
  std::vector<std::string> titles;
  for (auto const& each : judged)
    if (each.limit != tested_mm && each.limit_kept == keeps) titles.emplace_back(quantity(each.quantity).title);
  return wording::enumerate(titles);
}

// Whether the building with this law keeps its limits: "yes", "no", or "open" if the draws are too few to tell;
// "untested" if it keeps them but its bearings may move farther than in the tests; "unlimited" if the building file
// sets no limit.
std::string_view holds(LawAnswer const& law) {
  bool limited = false, tested = true;
  auto keeps = LimitKept::yes;
  for (auto const& each : law.limit_checks) {
    if (each.limit == tested_mm) {
      tested = each.limit_kept == LimitKept::yes;
      continue;
    }
    limited = true;
    if (keeps != LimitKept::no && each.limit_kept != LimitKept::yes) keeps = each.limit_kept;
  }
  return !limited ? "unlimited" : keeps == LimitKept::yes && !tested ? "untested" : name(keeps);
}

std::optional<bool> holds_at_all(LawAnswer const& law) {
  auto const answer = holds(law);
  return answer == name(LimitKept::yes) || answer == name(LimitKept::no) ? std::optional(answer == name(LimitKept::yes))
                                                                         : std::nullopt;
}

Finding holding(FindingKind kind, LawAnswer const& law) {
  auto const answer = holds(law);
  Finding finding{.kind = kind,
                  .law = law.law,
                  .numbers = {{"draws", static_cast<double>(law.draws)}},
                  .words = {{"holds", std::string(answer)},
                            {"which", titles_of(law.limit_checks,
                                                answer == name(LimitKept::no) ? LimitKept::no : LimitKept::open)}}};
  if (answer != name(LimitKept::open)) return finding;
  // "wanted" is the number of draws that would be enough to tell whether all limits are kept. It is left out if this
  // number is unknown for one of the limits.
  std::size_t wanted = 0;
  for (auto const& each : law.limit_checks) {
    if (each.limit == tested_mm || each.limit_kept != LimitKept::open) continue;
    if (!each.draws_wanted) return finding;
    wanted = std::max(wanted, *each.draws_wanted);
  }
  finding.numbers.push_back({"wanted", static_cast<double>(wanted)});
  return finding;
}

// Adds a finding if the law gave no finite numbers in the nominal building, a bound analysis or a draw. Such an
// analysis counts as breaking every limit. The finding tells the user that the cause may be the law and not the
// building.
void add_failing(LawAnswer const& law, std::vector<Finding>& verdict) {
  auto const& moves = law.distributions.front();
  bool const nominal = std::isnan(moves.nominal), bounds = std::isnan(moves.lower) || std::isnan(moves.upper);
  if (!nominal && !bounds && law.collapsed == 0) return;
  Finding failing{.kind = FindingKind::building_law_failed,
                  .law = law.law,
                  .words = {{"where", nominal && bounds ? "both"
                                      : nominal         ? "nominal"
                                      : bounds          ? "bounds"
                                                        : ""},
                            {"also", nominal || bounds ? "too" : "alone"}}};
  if (law.collapsed > 0)
    failing.numbers = {{"collapsed", static_cast<double>(law.collapsed)}, {"draws", static_cast<double>(law.draws)}};
  verdict.push_back(std::move(failing));
}

// Adds the finite ones of these numbers. The sentence of a finding leaves out the clause of a number that is missing.
void add_finite(Finding& finding, std::initializer_list<FindingNumber> numbers) {
  for (auto const& number : numbers)
    if (std::isfinite(number.value)) finding.numbers.push_back(number);
}

std::vector<Finding> verdict_of(Study const& study, Answers const& answers) {
  auto const found = std::ranges::find_if(answers.laws, has_result);
  if (found == answers.laws.end()) return {};
  auto const& law = *found;
  std::vector<Finding> verdict{holding(FindingKind::building_holds, law)};
  add_failing(law, verdict);
  for (auto const& other : answers.laws) {
    if (&other == &law) continue;
    if (has_result(other) && holds(other) != holds(law))
      verdict.push_back(holding(FindingKind::building_holds_with, other));
    add_failing(other, verdict);
  }

  auto const& moves = law.distributions.front();
  double const tested = study.laws[static_cast<std::size_t>(found - answers.laws.begin())].tested_mm;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Finding reach{.kind = FindingKind::building_reach, .law = law.law};
  add_finite(reach, {{"nominal_mm", law.design_displacement.nominal},
                     {"bound_mm", law.design_displacement.bound.value_or(none)},
                     {"p95_mm", law.design_displacement.p95.value_or(none)},
                     {"draws", static_cast<double>(law.draws)}});
  if (tested > 0.0) {
    reach.numbers.push_back({"tested_mm", tested});
    bool const beyond = std::ranges::any_of(
        reach.numbers, [&](FindingNumber const& n) { return n.name.ends_with("_mm") && n.value > tested; });
    reach.words = {{"tested", beyond ? "beyond" : "within"}};
  }
  if (std::isfinite(law.design_displacement.nominal)) verdict.push_back(std::move(reach));
  if (has_draws(study) && std::isfinite(moves.lot_std_ln))
    verdict.push_back({.kind = FindingKind::building_scatter,
                       .numbers = {{"lot_std_ln", moves.lot_std_ln}, {"motion_std_ln", moves.motion_std_ln}},
                       .words = {{"motions", study.file.motions.size() > 1 ? "several" : ""}}});

  auto const [least, most] = std::ranges::minmax_element(law.bearing_mm);
  if (most != law.bearing_mm.end() && std::isfinite(*most)) {
    constexpr double alike = 0.01;
    auto const number = static_cast<std::size_t>(most - law.bearing_mm.begin());
    auto const& at = study.file.bearings[number].at;
    bool const all_alike = *least >= (1.0 - alike) * *most;
    verdict.push_back({.kind = FindingKind::building_most_moved,
                       .numbers = {{"number", static_cast<double>(number + 1)},
                                   {"most_mm", *most},
                                   {"least_mm", *least},
                                   {"alike", alike}},
                       .words = {{"over", has_draws(study) ? "draws" : "motions"},
                                 {"bearings", law.bearing_mm.size() == 1 ? "one"
                                              : all_alike                ? "alike"
                                                                         : "unlike"},
                                 {"place", fmt::format("({:g}, {:g}) m", at.x_mm / 1e3, at.y_mm / 1e3)}}});
  }
  return verdict;
}

std::vector<Finding> about_bounds(Study const& study, Answers const& answers) {
  auto const found = std::ranges::find_if(answers.laws, has_result);
  if (found == answers.laws.end()) return {};
  auto const& first = *found;
  if (!has_draws(study)) return {{.kind = FindingKind::building_no_draws}};
  auto const& c = first.coverage.front();
  auto const numbers_of = [](LawAnswer const& law, double inside) {
    return std::vector<FindingNumber>{{"inside", inside},
                                      {"draws", static_cast<double>(law.draws)},
                                      {"collapsed", static_cast<double>(law.collapsed)}};
  };
  // The finding about the law that decides the answer comes first. If `own` is true, the study's first law decides. If
  // `own` is false, the bounds of the first law cover its own draws but not those of another law, and that other law
  // decides.
  bool const own = c.share_inside < wanted_share || answers.bounds_are_enough != false;
  Finding cover{.kind = FindingKind::building_bounds_cover,
                .law = first.law,
                .numbers = numbers_of(first, c.share_inside),
                .words = {{"answer", !own                         ? "of another law"
                                     : !answers.bounds_are_enough ? "No answer yet"
                                     : *answers.bounds_are_enough ? "Yes"
                                                                  : "No"},
                          {"nominal_outside", c.monotony && c.share_inside < wanted_share ? "yes" : ""}}};
  cover.numbers.push_back({"interval_low", c.interval_low});
  cover.numbers.push_back({"interval_high", c.interval_high});
  auto const factors = covering_factors(c);
  cover.numbers.insert(cover.numbers.end(), factors.numbers.begin(), factors.numbers.end());
  cover.words.insert(cover.words.end(), factors.words.begin(), factors.words.end());
  std::vector<Finding> said;
  if (own) said.push_back(cover);
  for (auto const& law : answers.laws)
    if (law.by_first_bounds && *law.by_first_bounds < wanted_share)
      said.push_back({.kind = FindingKind::building_bounds_cover_with,
                      .law = law.law,
                      .other_laws = {first.law},
                      .numbers = numbers_of(law, *law.by_first_bounds),
                      .words = {{"answer", said.empty() ? "No" : "of another law"}}});
  if (!own) said.push_back(std::move(cover));
  if (answers.law_std_ln && std::isfinite(first.distributions.front().lot_std_ln)) {
    double const lot = first.distributions.front().lot_std_ln;
    bool const law_matters_more = *answers.law_std_ln > lot;
    said.push_back({.kind = FindingKind::building_law_or_lot,
                    .numbers = {{"law_std_ln", *answers.law_std_ln}, {"lot_std_ln", lot}},
                    .words = {{"more", law_matters_more ? "law" : "lot"}, {"less", law_matters_more ? "lot" : "law"}}});
  }
  return said;
}

std::optional<bool> bounds_are_enough(Study const& study, Answers const& answers) {
  auto const first = std::ranges::find_if(answers.laws, has_result);
  if (!has_draws(study) || first == answers.laws.end()) return {};
  auto const& own = first->coverage.front();
  bool const refuted = own.share_inside < wanted_share || std::ranges::any_of(answers.laws, [](LawAnswer const& law) {
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
      return laws::springs_follow(law.law) ? "once along each axis, the motions being along x alone"
                                           : "once along each axis, its force not being equal on both sides";
    case Coupling::springs:
      break;
  }
  if (law.mixed)
    return law.fitted_as_springs
               ? "as sixteen springs around the circle, with parameters fitted as such to the tests, and once along each axis under motions along x alone"
               : "as sixteen springs around the circle, with the parameters of the law along one direction, so that they dissipate less, and once along each axis under motions along x alone";
  return law.fitted_as_springs
             ? "as sixteen springs around the circle, with parameters fitted as such to the tests"
             : "as sixteen springs around the circle, with the parameters of the law along one direction, so that they dissipate less";
}

// Warns of each quantity for which the bound analyses enclose too few draws. For the first quantity, the bearing
// displacement, the verdict says so already, so this quantity gets a warning only if its bounds are not monotonic.
void warn_of_coverage(LawAnswer const& law, std::vector<Finding>& warnings) {
  for (auto const& c : law.coverage) {
    if (c.share_inside >= wanted_share) continue;
    if (c.monotony) {
      auto& warning = warnings.emplace_back(*c.monotony);
      warning.law = law.law;
      warning.numbers.push_back({"inside", c.share_inside});
    } else if (&c != &law.coverage.front()) {
      warnings.push_back({.kind = FindingKind::bounds_cover_less,
                          .law = law.law,
                          .numbers = {{"inside", c.share_inside}, {"wanted", wanted_share}},
                          .words = {{"quantity", std::string(quantity(c.quantity).title)}}});
    }
  }
}

std::vector<std::string> assumed_of(Study const& study, Answers const& answers) {
  auto const& s = study.file.settings;
  std::vector<std::string> sentences;
  auto const count = [&](BearingKind kind) {
    return std::ranges::count(study.file.bearings, kind, &BearingPlace::kind);
  };
  sentences.push_back(fmt::format(
      "Of {} bearings {} {}, {} its law, {} tested devices, {} and {} its law as in the lower and the upper bound analysis.",
      study.file.bearings.size(), count(BearingKind::draw),
      s.draws > 0 ? "are draws of the lot" : "have the median parameters of the lot's population",
      count(BearingKind::lot), count(BearingKind::device), count(BearingKind::lower), count(BearingKind::upper)));
  auto const bound = [](std::optional<PartFactors> const& factors) {
    if (!factors) return std::string("as in the bound law over the design conditions of the lot");
    return factors->is_whole() ? fmt::format("times {:.2f}: stiffness and strength alike", factors->elastic)
                               : fmt::format("times {:.2f} in the elastic and {:.2f} in the hysteretic part",
                                             factors->elastic, factors->hysteretic);
  };
  sentences.push_back(fmt::format(
      "The bound analyses take every bearing at its nominal values; in the lower one its forces are {}, in the upper one {}.",
      bound(s.lower), bound(s.upper)));
  sentences.push_back(fmt::format("A building's response is its mean over {}, each scaled as the building file says.",
                                  counted(study.file.motions.size(), "motion")));
  if (has_draws(study))
    sentences.push_back(
        s.populations > 1
            ? fmt::format("The population is as uncertain as the tests leave it: {} populations of {} draws.",
                          s.populations, s.draws_of_each)
            : std::string("The lot's population is taken as known: what few tests leave open is not in it."));
  for (auto const& law : answers.laws)
    sentences.push_back(fmt::format("{} goes into the plane {}.", laws::display_name(law.law), form_sentence(law)));
  sentences.push_back(fmt::format(
      "The superstructure is linear, {} above the base, {:.3g} s on a fixed base, {:.3g} % of damping in every mode; none of it is in the isolation layer.",
      study.file.frame.floors.empty() ? std::string("nothing")
                                      : fmt::format("{} floors", study.file.frame.floors.size()),
      answers.fixed_periods_s.empty() ? 0.0 : answers.fixed_periods_s.front(), 100.0 * s.damping));
  sentences.emplace_back(
      "Bearings move in plan: no axial load and its changes, no uplift, no vertical motion, no soil.");
  return sentences;
}

// The responses of a law's runs as [motion][quantity][case]. A case is one choice of bearings, for example a draw.
using Kept = std::vector<std::vector<std::vector<double>>>;

// Reads the runs of one law. Puts each bearing's means, and the largest error of the energy balance, into `out`.
Kept take_runs(RunStore const& store, std::size_t law, std::size_t motions, CasePlaces const& places,
               Layout const& layout, double weight_kN, LawAnswer& out) {
  out.bearing_mm.assign(layout.bearings, 0.0);
  out.bearing_energy_share.assign(layout.bearings, 0.0);
  auto const counted_kind = places.draws > 0 ? CaseKind::draw : CaseKind::nominal;
  std::size_t runs_of_kind = 0;
  auto const rows = quantities();
  Kept kept(motions, {rows.size(), std::vector<double>(places.cases.size(), std::nan(""))});
  for (std::size_t motion = 0; motion < motions; ++motion)
    store.for_each_run(law, motion, [&](std::size_t place, std::vector<double> const& measured) {
      ++out.runs;
      bool const finite = std::ranges::all_of(measured, [](double v) { return std::isfinite(v); });
      out.failed += !finite;
      if (!finite) return;
      for (std::size_t q = 0; q < rows.size(); ++q) kept[motion][q][place] = rows[q].value(layout, measured, weight_kN);
      out.worst_balance = std::max(out.worst_balance, std::abs(measure_of(measured, Measure::balance)));
      if (places.cases[place].kind != counted_kind) return;
      ++runs_of_kind;
      for (std::size_t b = 0; b < layout.bearings; ++b) {
        out.bearing_mm[b] += measured[layout.displacement(b)];
        out.bearing_energy_share[b] += ratio(measured[layout.energy(b)], measure_of(measured, Measure::hysteretic));
      }
    });
  auto const finite = static_cast<double>(runs_of_kind);
  bool const enough =
      finite >= least_finite_share * static_cast<double>(motions * std::max(places.draws, std::size_t{1}));
  for (auto* const means : {&out.bearing_mm, &out.bearing_energy_share})
    for (double& value : *means) value = enough ? value / finite : std::nan("");
  return kept;
}

// Adds to `out` the distribution of every quantity, and how well the bound analyses cover each quantity that they can
// cover. `first` is the answer of the study's first law with a result. It is null if `out` is the answer of that law or
// no law has a result.
void add_distributions(LawAnswer& out, Kept const& kept, CasePlaces const& places, Settings const& settings,
                       LawAnswer const* first) {
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    auto const responses = responses_of(kept, q);
    auto const draws = part_of(responses.mean, places.first_draw, places.draws);
    auto const& d = out.distributions.emplace_back(distribution_of(responses, places, settings));
    if (!draws.empty() && quantities()[q].uncovered.empty())
      out.coverage.push_back(
          coverage_of(quantities()[q], draws, d, part_of(responses.mean, places.first_factor, 2 * grid_half + 1)));
    if (q == 0)
      out.collapsed =
          static_cast<std::size_t>(std::ranges::count_if(draws, [](double v) { return !std::isfinite(v); }));
    if (q != 0 || !first || draws.empty()) continue;
    auto const& bounds = first->distributions.front();
    auto const range = std::minmax(bounds.lower, bounds.upper);
    auto const inside = std::ranges::count_if(draws, [&](double v) { return v >= range.first && v <= range.second; });
    out.by_first_bounds = static_cast<double>(inside) / static_cast<double>(draws.size());
  }
}

// Compares the responses with the limits. Without `places`, `kept` holds the nominal building alone.
void judge(LawAnswer& out, Kept const& kept, CasePlaces const* places, Study const& study, double tested) {
  auto const against = [&](std::string_view limit, std::string_view of, double allowed) {
    auto const row = static_cast<std::size_t>(&quantity(of) - quantities().data());
    return check_limit(limit, of, allowed, responses_of(kept, row), places, places != nullptr && has_draws(study));
  };
  out.design_displacement = against({}, quantities().front().key, std::numeric_limits<double>::infinity());
  for (auto const& limit : limit_rows)
    if (auto const& allowed = study.file.limits.*limit.value)
      out.limit_checks.push_back(against(limit.key, limit.quantity, *allowed));
  if (tested > 0.0) out.limit_checks.push_back(against(tested_mm, quantities().front().key, tested));
}

// Integrates the nominal building implicitly under a motion. Compares the results with those of two other methods: the
// integrator that is used for the draws, which gave the displacement `of_draws_mm`, and the equivalent linear analysis.
NominalResult nominal_result(Study const& study, LawSource const& source, Model const& model, std::size_t motion_number,
                             double of_draws_mm, std::function<bool()> const& interrupted) {
  auto const& motion = study.file.motions[motion_number];
  Devices const devices(source, study.file, motion);
  auto const nominal = devices.parameters_of({});
  auto options = options_of(study, model, devices, motion);
  options.histories = true;
  options.interrupted = interrupted;
  NominalResult result;
  auto& checked = result.checked;
  checked.coupling = devices.coupling();
  auto const run = integrate(model, devices.bearings(nominal), motion, options);
  result.history = thinned(run.history, run.step_s);
  add_spectra(result.spectra_g, run, 1.0 / static_cast<double>(study.file.motions.size()));
  result.farthest_mm = run.value(Measure::isolator);
  checked.step_s = run.step_s;
  if (run.outcome != Outcome::completed) {
    // The values that an analysis reached before it stopped are not responses of the building, so they are left out.
    checked.outcome = run.stop_reason;
    for (auto& spectrum : result.spectra_g) std::ranges::fill(spectrum, std::nan(""));
    return result;
  }
  checked.outcome = name(run.outcome);
  checked.isolator_mm = run.value(Measure::isolator);
  checked.balance = run.value(Measure::balance);
  options.histories = false;
  options.longest_step_s = 0.5 * steps_of(motion, options.longest_step_s, 0.0).dt;
  if (auto const fine = integrate(model, devices.bearings(nominal), motion, options);
      fine.outcome == Outcome::completed)
    checked.missed_mm = richardson(run, fine)[static_cast<std::size_t>(Measure::isolator)];
  checked.draws_error_percent = 100.0 * (of_draws_mm / *checked.isolator_mm - 1.0);
  if (auto const linear = equivalent_linear(devices, motion, nominal, model.structure().mass()(0, 0))) {
    checked.equivalent_mm = linear->displacement_mm;
    checked.equivalent_period_s = linear->period_s;
    checked.equivalent_damping = linear->damping;
    checked.equivalent_error_percent = 100.0 * (linear->displacement_mm / run.value(Measure::centre) - 1.0);
  }
  // With 0.0 as the tested displacement, run_doubts() says nothing about a bearing that moves farther than in the
  // tests. The verdict and its warnings say this already, for the draws.
  checked.doubts = run_doubts(run, source.law, motion.name, 0.0);
  if (std::abs(*checked.draws_error_percent) > largest_difference_percent)
    checked.doubts.push_back(
        {.kind = FindingKind::draws_off_reference,
         .law = source.law,
         .numbers = {{"percent", *checked.draws_error_percent}, {"limit_percent", largest_difference_percent}},
         .words = {{"motion", motion.name}}});
  return result;
}

// Takes the results for the nominal building from the store. Computes those that the store lacks, and stores them.
void add_nominal_building(LawAnswer& out, Study const& study, RunStore const& store, std::size_t law,
                          Model const& model, Kept const& kept, std::function<bool()> const& interrupted) {
  auto const& motions = study.file.motions;
  auto const& source = study.laws[law];
  out.fitted_as_springs = !source.springs.empty();
  double farthest = -1.0;
  std::size_t strongest = 0;
  for (std::size_t motion = 0; motion < motions.size(); ++motion) {
    auto text = store.stored_text(law, motion);
    if (text.empty()) {
      text = kept_text(nominal_result(study, source, model, motion, kept[motion][0][0], interrupted));
      store.save_text(law, motion, text);
    }
    auto result = nominal_result_of(text);
    auto const coupling = result.checked.coupling;
    if (out.checked.empty() || coupling == Coupling::springs) out.coupling = coupling;
    out.mixed = out.mixed || (!out.checked.empty() && coupling != out.checked.back().coupling);
    out.floor_spectra_g.resize(std::max(out.floor_spectra_g.size(), result.spectra_g.size()),
                               std::vector<double>(spectrum_periods_s().size(), 0.0));
    for (std::size_t floor = 0; floor < result.spectra_g.size(); ++floor)
      for (std::size_t i = 0; i < result.spectra_g[floor].size(); ++i)
        out.floor_spectra_g[floor][i] += result.spectra_g[floor][i];
    if (result.farthest_mm > farthest) farthest = result.farthest_mm, strongest = motion;
    out.checked.push_back(std::move(result.checked));
    out.histories.push_back(std::move(result.history));
  }
  auto text = store.stored_text(law, motions.size());
  if (text.empty()) {
    Devices const devices(source, study.file, motions[strongest]);
    auto options = options_of(study, model, devices, motions[strongest]);
    options.histories = true;
    options.interrupted = interrupted;
    // The first draw is shown, or the nominal building if the law gave no numbers in this draw.
    auto const first_draw = CasePlaces(study.file.settings).first_draw;
    bool const drawn = has_draws(study) && std::isfinite(kept[strongest][0][first_draw]);
    text = kept_text(loops_of(model, devices, study, strongest, drawn, options));
    store.save_text(law, motions.size(), text);
  }
  out.loops = loops_of(text);
}

void add_warnings(Answers& answers, Study const& study) {
  auto const warn = [&](FindingKind kind, std::string const& law, std::vector<FindingNumber> numbers = {}) {
    answers.warnings.push_back({.kind = kind, .law = law, .numbers = std::move(numbers)});
  };
  answers.warnings = study_doubts(study);
  for (std::size_t i = 0; i < answers.laws.size(); ++i) {
    auto const& law = answers.laws[i];
    for (auto const& checked : law.checked) std::ranges::copy(checked.doubts, std::back_inserter(answers.warnings));
    double const tested = study.laws[i].tested_mm;
    if (auto far = farthest(law, study, tested); tested > 0.0 && far.number("most_mm") > tested)
      answers.warnings.push_back(std::move(far));
    if (has_draws(study) && has_result(law)) warn_of_coverage(law, answers.warnings);
    if (law.worst_balance > largest_energy_error_of_runs) {
      warn(FindingKind::energy_error_large, law.law,
           {{"error", law.worst_balance}, {"limit", largest_energy_error_of_runs}});
      answers.warnings.back().words = {{"whose", "one of the buildings"}};
    }
    if (law.failed > 0) warn(FindingKind::building_runs_failed, law.law, {{"failed", static_cast<double>(law.failed)}});
    if (law.collapsed > 0)
      warn(FindingKind::draws_collapsed, law.law,
           {{"collapsed", static_cast<double>(law.collapsed)},
            {"draws", static_cast<double>(law.draws)},
            {"finite", least_finite_share}});
  }
  auto const first = std::ranges::find_if(answers.laws, has_result);
  if (has_draws(study) && first != answers.laws.end() && !answers.bounds_are_enough) {
    auto const draws = static_cast<double>(first->draws);
    warn(FindingKind::draws_too_few, {}, {{"draws", draws}, {"wanted", wanted_share}});
    auto const inside = static_cast<std::size_t>(std::lround(first->coverage.front().share_inside * draws));
    if (auto const enough = draws_that_tell(inside, first->draws))
      answers.warnings.back().numbers.push_back({"enough", static_cast<double>(*enough)});
  }
  if (auto const motions = study.file.motions.size(); motions < motions_for_a_mean)
    warn(FindingKind::motions_too_few, {},
         {{"motions", static_cast<double>(motions)}, {"wanted", static_cast<double>(motions_for_a_mean)}});
}

}  // namespace

std::string_view name(Coupling coupling) {
  return coupling == Coupling::coupled ? "coupled" : coupling == Coupling::separate ? "separate" : "springs";
}

std::string_view form(LawAnswer const& law) {
  return law.coupling == Coupling::springs && !law.fitted_as_springs ? "springs as given" : name(law.coupling);
}

bool has_result(LawAnswer const& law) {
  return law.failed < law.runs;
}

std::string why_without_result(LawAnswer const& law) {
  auto const stopped = std::ranges::find_if(
      law.checked, [](MotionCheck const& checked) { return checked.outcome != name(Outcome::completed); });
  return fmt::format(
      "none of its {} gave finite numbers{}", counted(law.runs, "analysis run"),
      stopped == law.checked.end() ? std::string() : ". The nominal building stops with: " + stopped->outcome);
}

Answers answer(Study const& study, RunStore const& store, std::function<bool()> const& interrupted) {
  Model const model(Structure(study.file.frame), study.file.plan());
  auto const& settings = study.file.settings;
  CasePlaces places(settings);
  // A building file without drawn bearings has 0 draws. A Study that a caller fills in may state another number.
  if (!has_draws(study)) places.draws = 0;
  Answers answers;
  answers.weight_kN = model.structure().weight_kN();
  for (double const w : model.structure().frequency_rad_s())
    answers.fixed_periods_s.push_back(2.0 * std::numbers::pi / w);
  answers.corners = model.plan().corners;
  answers.laws.reserve(study.laws.size());
  for (std::size_t law = 0; law < study.laws.size(); ++law) {
    auto const& source = study.laws[law];
    auto& out = answers.laws.emplace_back();
    out.law = source.law;
    out.draws = places.draws;
    out.doubts = source.doubts;
    auto const kept = take_runs(store, law, study.file.motions.size(), places, model.layout(), answers.weight_kN, out);
    auto const first = std::ranges::find_if(answers.laws, has_result);
    add_distributions(out, kept, places, settings, first == answers.laws.end() || &*first == &out ? nullptr : &*first);
    judge(out, kept, &places, study, source.tested_mm);
    add_nominal_building(out, study, store, law, model, kept, interrupted);
    for (auto const& doubt : out.doubts)
      if (std::ranges::find(answers.calibration, doubt) == answers.calibration.end())
        answers.calibration.push_back(doubt);
  }
  if (answers.laws.size() > 1) {
    std::vector<double> medians;
    for (auto const& law : answers.laws) medians.push_back(law.distributions.front().fractiles[1]);
    if (double const spread = spread_ln(medians); std::isfinite(spread)) answers.law_std_ln = spread;
  }
  answers.bounds_are_enough = bounds_are_enough(study, answers);
  answers.verdict = verdict_of(study, answers);
  if (auto const first = std::ranges::find_if(answers.laws, has_result); first != answers.laws.end())
    answers.holds = holds_at_all(*first);
  answers.about_bounds = about_bounds(study, answers);
  add_warnings(answers, study);
  answers.assumed = assumed_of(study, answers);
  return answers;
}

Answers answer_of_nominal(Study const& study, std::vector<std::vector<std::vector<double>>> const& measured) {
  Model const model(Structure(study.file.frame), study.file.plan());
  auto const rows = quantities();
  Answers answers;
  answers.laws.reserve(study.laws.size());
  for (std::size_t law = 0; law < study.laws.size(); ++law) {
    Kept kept;
    auto& out = answers.laws.emplace_back();
    for (auto const& run : measured[law]) {
      ++out.runs, out.failed += run.empty();
      auto& values = kept.emplace_back();
      for (auto const& row : rows)
        values.push_back({run.empty() ? std::nan("") : row.value(model.layout(), run, model.structure().weight_kN())});
    }
    out.law = study.laws[law].law;
    judge(out, kept, nullptr, study, study.laws[law].tested_mm);
  }
  auto const whole = [](LawAnswer const& law) { return law.failed == 0; };
  auto first = std::ranges::find_if(answers.laws, whole);
  if (first == answers.laws.end()) first = answers.laws.begin();
  auto const say = [&](FindingKind kind, LawAnswer const& law) {
    answers.verdict.push_back(holding(kind, law));
    answers.verdict.back().words.push_back({"alone", "yes"});
  };
  say(FindingKind::building_holds, *first);
  for (auto const& law : answers.laws) {
    if (!whole(law))
      answers.verdict.push_back({.kind = FindingKind::building_law_failed,
                                 .law = law.law,
                                 .words = {{"where", "nominal"}, {"also", "alone"}}});
    else if (holds(law) != holds(*first))
      say(FindingKind::building_holds_with, law);
  }
  answers.holds = holds_at_all(*first);
  return answers;
}

}  // namespace isolaw::building
