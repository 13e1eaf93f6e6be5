#include "isolaw/campaign/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {
namespace {

constexpr Word<Method> methods[]{{"best", Method::best}, {"ga", Method::genetic}};
constexpr Word<fit::BoxKind> boxes[]{{"published", fit::BoxKind::published}, {"auto", fit::BoxKind::scaled}};
constexpr Word<laws::Integration> integrations[]{{"converged", laws::Integration::converged},
                                                 {"paper", laws::Integration::paper}};
constexpr Word<laws::TurningPoints> turnings[]{{"sampled", laws::TurningPoints::as_sampled},
                                               {"interpolated", laws::TurningPoints::interpolated}};
constexpr Word<bool> analyses[]{{"full", true}, {"none", false}};

template <class T>
T parse_word(std::string const& where, std::string_view text, std::span<Word<T> const> words) {
  std::vector<Complaint> complaints;
  T found{};
  about(where, complaints, [&] { found = meant_by<T>(text, words); });
  if (!complaints.empty()) throw Error(std::move(complaints));
  return found;
}

std::vector<std::string> laws_of(Json const& value) {
  std::vector<std::string> ids;
  auto const add = [&](std::string const& text) {
    for (auto& id : parse_laws(text))
      if (std::ranges::find(ids, id) == ids.end()) ids.push_back(std::move(id));
  };
  if (!value.is_array())
    add(text_in(value));
  else
    for (auto const& item : value) add(text_in(item));
  return ids;
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

std::uint64_t seed_of(Json const& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  return parse_seed(value.is_string() ? value.get<std::string>() : shown(value));
}

std::optional<int> thinning_of(Json const& value, Limits const& limits) {
  if (value == "all") return std::nullopt;
  return whole_of(value.is_string() ? value_of(Kind::whole, {value.get<std::string>()}) : value, limits);
}

template <class Member>
Option<Settings> blocks(std::string_view key, std::string help, Member member) {
  return text<Settings>(
      key, Kind::text, std::move(help), [=](Settings const& s) -> Json { return member(s).text(); },
      [=](Settings& s, Json const& value) {
        member(s) = data::parse_numbers(fmt::format("--{}", key), text_in(value));
      });
}

// A constant of a method.
template <class Member>
Setting constant(Method method, std::string_view key, Member member, Limits limits) {
  return {number<Settings>(key, {}, member, std::move(limits)), method, true};
}

std::vector<Setting> make_table() {
  constexpr auto best = Method::best, genetic = Method::genetic;
  constexpr double below_1 = 1.0 - 0x1p-53, above_0 = std::numeric_limits<double>::min();
  constexpr double largest = std::numeric_limits<int>::max();
  Limits const thinning{.least = 20, .most = largest, .words = "20 or more, or all"};
  std::vector<Setting> table{
      {text<Settings>(
          "laws", Kind::list, "all, or ids separated by commas (isolaw laws lists them)",
          [](Settings const& s) -> Json { return s.laws; },
          [](Settings& s, Json const& value) { s.laws = laws_of(value); })},
      {word<Settings>(
          "method", "best (default): to the least objective there is; ga: the paper's genetic algorithm",
          [](auto& s) -> auto& { return s.method; }, methods)},
      {word<Settings>(
          "integration", "converged (default), or paper: one Runge-Kutta step per sample",
          [](auto& s) -> auto& { return s.integration; }, integrations)},
      {word<Settings>(
          "turning-points", "sampled (default), or interpolated: the path turns between samples, for smooth records",
          [](auto& s) -> auto& { return s.turning_points; }, turnings)},
      {number<Settings>(
          "runs", "independent runs per law and device", [](auto& s) -> auto& { return s.runs; },
          {.least = 1, .most = 100'000}, "3; ga: 20")},
      // The upper limits keep the count of evaluations an int; that of the pressure keeps every weight above zero.
      {number<Settings>("population", "of ga: individuals", [](auto& s) -> auto& { return s.genetic.population; },
                        {.least = 4, .most = 100'000, .words = "an even number from 4 to 100000", .step = 2}),
       genetic},
      {number<Settings>("generations", "of ga: generations, the initial one included",
                        [](auto& s) -> auto& { return s.genetic.generations; }, {.least = 1, .most = 20'000}),
       genetic},
      constant(genetic, "mutation_rate", [](auto& s) -> auto& { return s.genetic.mutation_rate; },
               {.least = 0, .most = 1}),
      constant(genetic, "stagnation", [](auto& s) -> auto& { return s.genetic.stagnation; },
               {.least = 1, .most = largest, .words = "at least 1 generation"}),
      {number<Settings>("stagnation_tolerance",
                        "of ga: relative improvement that counts as none; 20 generations without improvement end a run",
                        [](auto& s) -> auto& { return s.genetic.stagnation_tolerance; },
                        {.least = 0, .most = below_1, .words = "0 or more, below 1"}),
       genetic},
      constant(genetic, "selection_pressure", [](auto& s) -> auto& { return s.genetic.selection_pressure; },
               {.least = 0, .most = 100}),
      constant(best, "least_starts", [](auto& s) -> auto& { return s.multistart.least_starts; },
               {.least = 1, .most = 10'000}),
      constant(best, "starts", [](auto& s) -> auto& { return s.multistart.starts; }, {.least = 1, .most = 10'000}),
      constant(best, "hits", [](auto& s) -> auto& { return s.multistart.hits; }, {.least = 1, .most = 10'000}),
      constant(best, "hit_tolerance", [](auto& s) -> auto& { return s.multistart.hit_tolerance; },
               {.least = above_0, .most = below_1, .words = "above 0, below 1"}),
      constant(best, "most_evaluations", [](auto& s) -> auto& { return s.multistart.most_evaluations; },
               {.least = 1, .most = 1'000'000'000}),
      constant(best, "scattered", [](auto& s) -> auto& { return s.multistart.scattered; },
               {.least = 1, .most = 10'000}),
      constant(best, "hops", [](auto& s) -> auto& { return s.multistart.hops; }, {.least = 0, .most = 10'000}),
      {text<Settings>(
          "seed", Kind::text, "seed of the campaign (1)", [](Settings const& s) -> Json { return s.seed; },
          [](Settings& s, Json const& value) { s.seed = seed_of(value); })},
      {word<Settings>(
          "box", "search box: auto, scaled from each record (default), or published, Table 4 of the paper",
          [](auto& s) -> auto& { return s.box; }, boxes)},
      {text<Settings>(
          "set", Kind::repeated,
          "law.parameter=value | lower:upper | free | another parameter, to tie it; may be repeated",
          [](Settings const& s) { return texts_of(s.overrides); }, set_overrides)},
      {number<Settings>("smooth", "window of the centred moving average",
                        [](auto& s) -> auto& { return s.clean.smooth; },
                        {.least = 1, .most = largest, .words = "an odd number of samples, 1 for none", .step = 2})},
      {text<Settings>(
          "samples-per-cycle", Kind::text,
          help_of("thin records to this many samples per cycle", thinning.text(), "200"),
          [](Settings const& s) -> Json {
            return s.clean.samples_per_cycle ? Json(*s.clean.samples_per_cycle) : Json("all");
          },
          [=](Settings& s, Json const& value) { s.clean.samples_per_cycle = thinning_of(value, thinning); })},
      {flag<Settings>(
          "center", "remove the offset of displacement and force", [](auto& s) -> auto& { return s.clean.center; })},
      {blocks(
          "fit-blocks", "judge laws by these blocks of the test alone: 2, 1-3, 2- (all)",
          [](auto& s) -> auto& { return s.clean.scored.blocks; })},
      {blocks(
          "fit-cycles", "and by these cycles of each: 2- leaves out scragging (all)",
          [](auto& s) -> auto& { return s.clean.scored.cycles; })},
      {blocks(
          "score-blocks", "with --fit-blocks: predict these blocks by the laws fitted to those (all others)",
          [](auto& s) -> auto& { return s.clean.scored.predicted; })},
      {word<Settings>(
          "analysis",
          "what the tests determine, intervals, one law for the lot, devices left out: full (default), or none",
          [](auto& s) -> auto& { return s.analysis; }, analyses)},
      // A quantile of 2.5 % is that of one replicate in forty.
      {number<Settings>("replicates", "fits of the bootstrap for intervals",
                        [](auto& s) -> auto& { return s.replicates; },
                        {.least = 40, .most = 100'000, .words = "0 for none, or 40 to 100000", .or_zero = true})},
  };
  return table;
}

}  // namespace

std::span<Setting const> setting_table() {
  static std::vector<Setting> const table = make_table();
  return table;
}

Setting const* find_setting(std::string_view key) {
  auto const table = setting_table();
  auto const found = std::ranges::find(table, key, &Setting::key);
  return found == table.end() ? nullptr : &*found;
}

void take(Setting const& setting, Json const& value, bool method_given, Settings& settings) {
  if (!setting.belongs_to(settings.method)) {
    auto const own = name(*setting.of);
    if (method_given)
      throw Error({.where = {},
                   .found = fmt::format("belongs to method {}, and the method is {}", own, name(settings.method)),
                   .allowed = fmt::format("with method {}, which it also chooses where no method is named", own)});
    settings.method = *setting.of;
  }
  setting.set(settings, value);
}

void apply(std::vector<GivenSetting> const& given, Settings& settings) {
  std::vector<Complaint> complaints;
  bool const method_given = std::ranges::any_of(given, [](auto const& one) { return one.setting->key == "method"; });
  for (auto const& setting : setting_table())
    for (auto const& one : given)
      if (one.setting == &setting)
        about(setting.where(), complaints, [&] { take(setting, one.value, method_given, settings); });
  if (!complaints.empty()) throw Error(std::move(complaints));
}

void Settings::complete() {
  if (runs == 0) runs = method == Method::genetic ? 20 : 3;
}

void Settings::validate() const {
  auto completed = *this;
  completed.complete();
  std::vector<Complaint> complaints;
  for (auto const& setting : setting_table())
    if (setting.belongs_to(method))
      about(setting.where(), complaints, [&] { setting.set(completed, setting.get(completed)); });
  auto const require = [&](bool holds, char const* key, Json const& found, char const* allowed) {
    if (!holds) about(find_setting(key)->where(), complaints, [&] { refuse(found, allowed); });
  };
  require(multistart.starts >= multistart.least_starts, "starts", multistart.starts, "the least starts or more");
  require(multistart.hits <= multistart.least_starts, "hits", multistart.hits, "the least starts or fewer");
  require(!clean.scored.blocks.all() || clean.scored.predicted.all(), "score-blocks", clean.scored.predicted.text(),
          "together with --fit-blocks, the numbers of the blocks that laws are fitted to");
  if (!complaints.empty()) throw Error(std::move(complaints));
  for (auto const& id : laws) fit::make_box(laws::find_law(id), box, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, overrides);
}

std::vector<std::string> differences(Settings const& there, Settings const& now) {
  auto const words = [](Json const& value) {
    auto text = text_of(value);
    return text.empty() ? std::string("none") : text;
  };
  std::vector<std::string> found;
  for (auto const& setting : setting_table()) {
    if (!setting.belongs_to(there.method) || !setting.belongs_to(now.method)) continue;
    auto const a = setting.get(there), b = setting.get(now);
    if (a != b) found.push_back(fmt::format("{}: {} there, {} now", setting.key, words(a), words(b)));
  }
  return found;
}

std::vector<std::pair<std::string, std::string>> to_pairs(Settings const& settings) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (auto const& setting : setting_table())
    if (setting.belongs_to(settings.method)) pairs.emplace_back(setting.key, setting.get(settings).dump());
  return pairs;
}

Settings settings_from_pairs(std::vector<std::pair<std::string, std::string>> const& pairs) {
  std::map<std::string, std::string, std::less<>> const stored(pairs.begin(), pairs.end());
  Settings settings;
  std::vector<Complaint> complaints;
  for (auto const& setting : setting_table()) {
    if (!setting.belongs_to(settings.method)) continue;
    about(fmt::format("stored setting '{}'", setting.key), complaints, [&] {
      auto const found = stored.find(setting.key);
      if (found == stored.end()) throw Error({.where = {}, .found = "is missing"});
      setting.set(settings, Json::parse(found->second));
    });
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return settings;
}

std::vector<std::string> parse_laws(std::string_view text) {
  std::vector<std::string> ids;
  if (text == "all") {
    for (auto const& law : laws::catalogue()) ids.emplace_back(law.info.id);
    return ids;
  }
  while (true) {
    auto const comma = text.find(',');
    auto id = text.substr(0, comma);
    while (id.starts_with(' ')) id.remove_prefix(1);
    while (id.ends_with(' ')) id.remove_suffix(1);
    auto const& law = laws::find_law(id);
    if (std::ranges::find(ids, law.info.id) == ids.end()) ids.emplace_back(law.info.id);
    if (comma == std::string_view::npos) return ids;
    text.remove_prefix(comma + 1);
  }
}

std::uint64_t parse_seed(std::string_view text) {
  std::uint64_t value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw Error(
        {.where = "--seed", .found = in_quotes(text), .allowed = "a whole number from 0 to 18446744073709551615"});
  return value;
}

laws::Integration parse_integration(std::string_view text) {
  return parse_word<laws::Integration>("--integration", text, integrations);
}
laws::TurningPoints parse_turning_points(std::string_view text) {
  return parse_word<laws::TurningPoints>("--turning-points", text, turnings);
}

std::string_view name(Method method) {
  return word_for<Method>(method, methods);
}
std::string_view name(fit::BoxKind kind) {
  return word_for<fit::BoxKind>(kind, boxes);
}
std::string_view name(laws::Integration integration) {
  return word_for<laws::Integration>(integration, integrations);
}
std::string_view name(laws::TurningPoints turning_points) {
  return word_for<laws::TurningPoints>(turning_points, turnings);
}

}  // namespace isolaw::campaign
