#include "isolaw/campaign/setting_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

using S = Settings;
using Ga = opt::GeneticOptions;
using Best = opt::MultistartOptions;
using Clean = data::CleanOptions;

constexpr std::pair<std::string_view, Method> methods[]{{"best", Method::best}, {"ga", Method::genetic}};
constexpr std::pair<std::string_view, fit::BoxKind> boxes[]{{"published", fit::BoxKind::published},
                                                            {"auto", fit::BoxKind::scaled}};
constexpr std::pair<std::string_view, laws::Integration> integrations[]{{"converged", laws::Integration::converged},
                                                                        {"paper", laws::Integration::paper}};
constexpr std::pair<std::string_view, laws::TurningPoints> turnings[]{
    {"sampled", laws::TurningPoints::as_sampled}, {"interpolated", laws::TurningPoints::interpolated}};
constexpr std::pair<std::string_view, std::optional<data::Weighting>> weightings[]{{"auto", std::nullopt},
                                                                                   {"time", data::Weighting::time},
                                                                                   {"swing", data::Weighting::swing},
                                                                                   {"travel", data::Weighting::travel}};
constexpr std::pair<std::string_view, bool> analyses[]{{"full", true}, {"none", false}};
constexpr std::pair<std::string_view, std::string_view> unit_ids[]{{unit_systems[0].id, unit_systems[0].id},
                                                                   {unit_systems[1].id, unit_systems[1].id},
                                                                   {unit_systems[2].id, unit_systems[2].id}};
static_assert(std::size(unit_ids) == unit_systems.size());
constexpr std::pair<std::string_view, bool> in_the_plane[]{{"none", false}, {"springs", true}};

void set_laws(S& s, Json const& value) {
  s.laws.clear();
  for (auto const& item : value.is_array() ? value : Json::array({value}))
    for (auto& id : parse_laws(text_in(item)))
      if (std::ranges::find(s.laws, id) == s.laws.end()) s.laws.push_back(std::move(id));
}

void set_overrides(Settings& s, Json const& value) {
  std::vector<fit::Override> overrides;
  for (auto const& item : value.is_array() ? value : Json::array({value})) {
    auto const change = fit::parse_override(text_in(item));
    for (auto const& other : overrides)
      if (other.law == change.law && other.parameter == change.parameter)
        throw Error({.where = {},
                     .found = fmt::format("{}.{} is set twice: {} and {}", change.law, change.parameter, other.text(),
                                          change.text()),
                     .allowed = "each parameter once"});
    overrides.push_back(change);
  }
  s.overrides = std::move(overrides);
}

Json texts_of(std::vector<fit::Override> const& overrides) {
  Json texts = Json::array();
  for (auto const& change : overrides) texts.push_back(change.text());
  return texts;
}

void set_seed(S& s, Json const& value) {
  auto const seed = number_in<std::uint64_t>(text_of(value));
  if (!seed) refuse(value, "a whole number from 0 to 18446744073709551615");
  s.seed = *seed;
}

// A setting that is a number or, if no number is set, `word`, for example "all". `type` is its type in Python.
template <class Access>
Setting number_or(std::string_view word, std::string_view type, Access place, Option<S> row) {
  row.get = [=](S const& s) { return place(s) ? Json(*place(s)) : Json(word); };
  row.set = [=, judge = row.set, kind = row.kind](S& s, Json const& value) {
    if (value == Json(word))
      place(s).reset();
    else
      judge(s, value.is_string() ? value_of(kind, {value.get<std::string>()}) : value);
  };
  row.kind = Kind::text;
  row.type = type;
  return {row};
}

Setting thinning() {
  auto const place = at(&S::clean, &Clean::samples_per_cycle);
  return number_or("all", "int | Literal[\"all\"] | None", place,
                   number<S>("samples-per-cycle", "thin records to this many samples per cycle", place,
                             {.least = 20, .most = std::numeric_limits<int>::max(), .words = "20 or more, or all"}));
}

Setting dead_band() {
  auto const place = at(&S::clean, &Clean::dead_band_mm);
  return number_or(
      "auto", "float | Literal[\"auto\"]", place,
      number<S>("dead-band", "laws that remember turning points ignore movements smaller than this, in mm", place,
                {.least = 0, .most = 1e4, .words = "0 to 10000, or auto (default): 3 times the noise of each record"}));
}

Setting blocks(std::string_view key, std::string help, data::Numbers data::Selection::*numbers) {
  auto const place = at(&S::clean, &Clean::scored, numbers);
  return {{{.key = key, .help = std::move(help)},
           [place](S const& s) -> Json { return place(s).text(); },
           [place, key](S& s, Json const& value) {
             place(s) = data::parse_numbers("--" + std::string(key), text_in(value));
           }}};
}

// A constant of the genetic algorithm or of the default search, which the store keeps but users cannot set.
template <class T>
Setting constant(std::string_view key, T Ga::*member, Limits limits) {
  return {number<S>(key, {}, at(&S::genetic, member), std::move(limits)), Method::genetic, true};
}
template <class T>
Setting constant(std::string_view key, T Best::*member, Limits limits) {
  return {number<S>(key, {}, at(&S::multistart, member), std::move(limits)), Method::best, true};
}

std::vector<Setting> make_settings() {
  constexpr double below_1 = 1.0 - 0x1p-53, above_0 = std::numeric_limits<double>::min();
  constexpr double largest = std::numeric_limits<int>::max();
  constexpr auto ga = Method::genetic;
  return {
      {{{.key = "laws",
         .kind = Kind::list,
         .help =
             "laws to fit: usual (default), paper (those of Cucuzza et al. 2025), all, or ids such as bilinear,bouc-wen. The command 'isolaw laws' lists all laws and marks each as paper, usual or all; usual fits the laws marked paper or usual",
         .heading = Heading::everyday},
        [](S const& s) -> Json { return s.laws; },
        set_laws}},
      {word<S>(
          "method",
          "how parameters are searched: best (default), by local searches from many starting points; ga, by the genetic algorithm of Cucuzza et al. 2025",
          at(&S::method), methods)},
      {word<S>(
          "integration",
          "how the equations of laws are integrated: converged (default), so finely that the force does not depend on the sampling; paper, by one Runge-Kutta step per sample, as in Cucuzza et al. 2025",
          at(&S::integration), integrations)},
      {word<S>(
          "turning-points",
          "where the motion turns: sampled (default), at a sample; interpolated, between samples, for records with little noise",
          at(&S::turning_points), turnings)},
      {number<S>("runs", "number of independent searches for each law on each device", at(&S::runs),
                 {.least = 1, .most = 1e5}, "2; with --method ga 20")},
      // The upper limits keep the number of evaluations within an int. The limit of selection_pressure keeps the
      // weights above zero with which the genetic algorithm selects parents.
      {number<S>("population", "with --method ga: number of individuals (sets of parameters)",
                 at(&S::genetic, &Ga::population),
                 {.least = 4, .most = 1e5, .words = "an even number from 4 to 100000", .step = 2}),
       ga},
      {number<S>("generations", "with --method ga: number of generations, counting the initial one",
                 at(&S::genetic, &Ga::generations), {.least = 1, .most = 20'000}),
       ga},
      constant("mutation_rate", &Ga::mutation_rate, {.least = 0, .most = 1}),
      constant("stagnation", &Ga::stagnation, {.least = 1, .most = largest, .words = "at least 1 generation"}),
      {number<S>(
           "stagnation_tolerance",
           "with --method ga: end a run when 20 generations lower the best objective by no more than this share of it",
           at(&S::genetic, &Ga::stagnation_tolerance), {.least = 0, .most = below_1, .words = "0 or more, below 1"}),
       ga},
      constant("selection_pressure", &Ga::selection_pressure, {.least = 0, .most = 100}),
      constant("least_starts", &Best::least_starts, {.least = 1, .most = 10'000}),
      constant("starts", &Best::starts, {.least = 1, .most = 10'000}),
      constant("hits", &Best::hits, {.least = 1, .most = 10'000}),
      constant("hit_tolerance", &Best::hit_tolerance, {.least = above_0, .most = below_1, .words = "above 0, below 1"}),
      constant("most_evaluations", &Best::most_evaluations, {.least = 1, .most = 1e9}),
      constant("scattered", &Best::scattered, {.least = 1, .most = 10'000}),
      constant("hops", &Best::hops, {.least = 0, .most = 10'000}),
      {{{.key = "seed", .help = "seed of all random numbers (default 1)", .type = "int"},
        [](S const& s) -> Json { return s.seed; },
        set_seed}},
      {word<S>(
          "box",
          "search range of the parameters: auto (default), scaled from the record, or published, Table 4 of Cucuzza et al. 2025",
          at(&S::box), boxes)},
      {{{.key = "set",
         .kind = Kind::repeated,
         .help =
             "fix a parameter (bilinear.K2=0.6), limit it (bilinear.K2=0.5:0.7), search it although it is fixed by default (=free), or give it the value of another (=K1); may be repeated"},
        [](S const& s) { return texts_of(s.overrides); },
        set_overrides}},
      {number<S>("smooth", "width of the centred moving average that smooths records", at(&S::clean, &Clean::smooth),
                 {.least = 1, .most = largest, .words = "an odd number of samples, 1 for none", .step = 2})},
      thinning(),
      {flag<S>("center", "remove the offset of displacement and force", at(&S::clean, &Clean::center))},
      dead_band(),
      {word<S>(
           "weights",
           "weight of a sample in the fit: time, the time between samples; swing, that time weighted by the size of the swing (the way between two turning points), so that a large swing counts more than small ones; travel, the distance moved between samples; auto (default): time if all swings are alike within 10 %, with --method ga or with --box published, otherwise swing",
           at(&S::clean, &Clean::weights), weightings),
       {},
       false,
       "time"},
      blocks(
          "fit-blocks",
          "fit laws only to the blocks with these numbers, as isolaw inspect prints them: 2, 1-3, or 2- for all from the second on (default all)",
          &data::Selection::blocks),
      blocks("fit-cycles",
             "fit laws only to these cycles of each block, such as 2- to leave out the first cycle (default all)",
             &data::Selection::cycles),
      blocks("score-blocks",
             "with --fit-blocks: blocks that the fitted laws must predict, for example 3 or 3-5 (default all others)",
             &data::Selection::predicted),
      {word<S>(
           "analysis",
           "full (default): also find which parameters the tests determine, the confidence intervals of the parameters, one law for the lot, and errors on devices left out of the fit; or none",
           at(&S::analysis), analyses)
           .under(Heading::analysis)},
      // A 95 % interval leaves out 2.5 % of the replicates at each end: one replicate of 40, so at least 40 are needed.
      {number<S>("replicates",
                 "number of fits to resampled records (bootstrap) for the confidence intervals of the parameters",
                 at(&S::replicates),
                 {.least = 40, .most = 1e5, .words = "0 for none, or 40 to 100000", .or_zero = true})
           .under(Heading::analysis)},
      {word<S>(
           "bidirectional",
           "springs: for laws that have no form of their own in two directions, also fit springs around a circle, which isolaw building then uses; or none (default)",
           at(&S::springs), in_the_plane)
           .under(Heading::analysis),
       {},
       false,
       "none"},
  };
}

// Sets the design values from a text or from a table such as {"K_eff": 1.2, "damping": 15}. The new values replace all
// design values of a lot file or a campaign.
void set_design(Acceptance& to, Json const& value) {
  if (!value.is_object()) {
    if (trimmed(text_in(value)).empty()) refuse(value, "design values, K_eff=1.2,damping=15");
    return void(to.design = text_in(value));
  }
  std::string design;
  for (auto const& [key, item] : value.items()) {
    if (!item.is_number())
      throw Error({.where = {},
                   .found = fmt::format("design.{} is not a number", key),
                   .allowed = "K_eff = 1.2, damping = 15.0"});
    design += fmt::format("{}{}={}", design.empty() ? "" : ",", key, item.get<double>());
  }
  to.design = std::move(design);
}

void set_rules(Acceptance& to, Json const& value) {
  if (text_in(value).empty()) refuse(value, "a built-in rule set, or a file");
  to.rules_file = text_in(value);
  to.rules.clear();
}

Option<Acceptance> alike(std::string_view key, std::string_view what, std::optional<double> Alike::*member,
                         double usual) {
  auto help = fmt::format("for a verdict on the lot: allowed difference between the tests in {}", what);
  return number<Acceptance>(key, std::move(help), at(&Acceptance::alike, member), {.least = 0, .most = 1000},
                            fmt::format("{}", usual))
      .under(Heading::acceptance);
}

std::vector<Option<Acceptance>> make_acceptance() {
  auto const unless_empty = [](std::string const& text) { return text.empty() ? Json() : Json(text); };
  auto report_units = word<Acceptance>("report-units", "units that reports show: kN-mm (default), N-m or kip-in",
                                       at(&Acceptance::report_units), unit_ids)
                          .under(Heading::everyday);
  report_units.get = [](Acceptance const& a) {
    return a.report_units == record_units.id ? Json() : Json(a.report_units);
  };
  return {
      {{.key = "rules",
        .help = "rule set to check the tests against: a name from isolaw rules, such as ntc-2018, or a file",
        .type = "str | PathLike[str]",
        .heading = Heading::everyday},
       [=](Acceptance const& a) { return unless_empty(a.rules_file); },
       set_rules},
      {{.key = "design",
        .kind = Kind::assignments,
        .help = "design values in kN, mm, Hz and %: K_eff=1.2,damping=15,disp=150,frequency=0.5,...",
        .type = "str | Mapping[str, float]",
        .heading = Heading::everyday},
       [=](Acceptance const& a) { return unless_empty(a.design); },
       set_design},
      number<Acceptance>("lot-size", "number of devices in the production lot, tested or not",
                         at(&Acceptance::lot_size), {.least = 1, .most = 1e7})
          .under(Heading::acceptance),
      report_units,
      {{.key = "letterhead",
        .help = "file with the laboratory's letterhead for the certificate: .svg, .png, .jpg or .txt",
        .type = "str | PathLike[str]",
        .heading = Heading::acceptance},
       [=](Acceptance const& a) { return unless_empty(a.letterhead_file); },
       [](Acceptance& to, Json const& value) {
         to.letterhead_file = text_in(value);
         to.letterhead.clear();
       }},
      alike("alike-temperature-C", "temperature, in degrees Celsius", &Alike::temperature_C, Alike::own_temperature_C),
      alike("alike-frequency-percent", "frequency, in percent", &Alike::frequency_percent,
            Alike::own_frequency_percent),
      alike("alike-load-percent", "vertical load, in percent", &Alike::load_percent, Alike::own_load_percent),
      alike("alike-amplitude-percent", "amplitude, in percent", &Alike::amplitude_percent,
            Alike::own_amplitude_percent),
      alike("alike-earlier-cycles", "the number of earlier cycles that are as large as the counting cycles",
            &Alike::earlier_cycles, Alike::own_earlier_cycles),
  };
}

}  // namespace

std::span<Setting const> setting_table() {
  static std::vector<Setting> const table = make_settings();
  return table;
}

Setting const* find_setting(std::string_view key) {
  auto const table = setting_table();
  auto const found = std::ranges::find(table, key, &Setting::key);
  return found == table.end() ? nullptr : &*found;
}

void take(Setting const& setting, Json const& value, bool method_given, Settings& settings) {
  if (!setting.belongs_to(settings.method)) {
    auto const own = methods[setting.only_method == Method::genetic].first,
               chosen = methods[settings.method == Method::genetic].first;
    if (method_given)
      throw Error({.where = {},
                   .found = fmt::format("belongs to method {}, but the method is {}", own, chosen),
                   .allowed = fmt::format("with method {}, or without a method: it then chooses {}", own, own)});
    settings.method = *setting.only_method;
  }
  setting.set(settings, value);
}

void apply(Values const& given, Settings& settings) {
  judge_each(setting_table(), [&](Setting const& setting) {
    auto const found = given.find(setting.key);
    if (found != given.end()) take(setting, found->second, given.contains("method"), settings);
  });
}

std::vector<std::string> differences(Settings const& there, Settings const& now, Sides const& sides) {
  auto const words = [](Json const& value) {
    auto text = text_of(value);
    return text.empty() ? std::string("none") : text;
  };
  std::vector<std::string> found;
  for (auto const& setting : setting_table()) {
    if (!setting.belongs_to(there.method) || !setting.belongs_to(now.method)) continue;
    auto const a = setting.get(there), b = setting.get(now);
    if (a != b)
      found.push_back(fmt::format("{}: {} {}, {} {}", setting.key, words(a), sides.one, words(b), sides.other));
  }
  return found;
}

std::span<Option<Acceptance> const> acceptance_table() {
  static std::vector<Option<Acceptance>> const table = make_acceptance();
  return table;
}

std::span<Option<Acceptance> const> alike_table() {
  auto const table = acceptance_table();
  auto const is_alike = [](Option<Acceptance> const& option) { return option.key.starts_with("alike-"); };
  auto const first = std::ranges::find_if(table, is_alike);
  return {first, std::find_if_not(first, table.end(), is_alike)};
}

int parse_lot_size(std::string_view text) {
  Acceptance acceptance;
  auto const row = std::ranges::find(acceptance_table(), "lot-size", &Option<Acceptance>::key);
  row->set(acceptance, value_of(Kind::whole, {std::string(text)}));
  return *acceptance.lot_size;
}

}  // namespace isolaw::campaign
