// Reads the text of a rule file into a RuleSet.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <span>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {
namespace {

constexpr std::size_t longest_note = 2048;  // largest size of a source's or a clause's text in bytes
constexpr std::size_t most_tables = 100;    // largest number of tables of one kind in a file
constexpr int last_cycle = 1000;

struct Range {
  double lower, upper;
  bool holds(double value) const { return value >= lower && value <= upper; }  // false for NaN
};
constexpr Range percent{1e-6, 1000.0};
constexpr Range kelvins{1e-6, 1000.0};
constexpr Range earlier{0.0, 1000.0};  // cycles
constexpr Range deviation{-100.0, 1000.0};
constexpr Range share{1e-6, 100.0};
constexpr Range frequency_Hz{1e-6, 1000.0};
constexpr Range ratio{1e-6, 1.0};
constexpr Range factor{1e-3, 100.0};
constexpr Range temperature_C{-100.0, 200.0};
constexpr Range load_kN{0.0, 1e9};

template <class Value>
using Choices = std::vector<std::pair<std::string_view, Value>>;

template <class Value>
Choices<Value> by_name(std::span<Value const> values) {
  Choices<Value> all;
  for (auto const value : values) all.emplace_back(name(value), value);
  return all;
}

Choices<Quantity> quantities() {
  auto all = by_name<Quantity>(measured_quantities());
  all.emplace_back(name(Quantity::K_v), Quantity::K_v);
  return all;
}

class RuleTable : public TomlTable {
 public:
  using TomlTable::TomlTable;

  bool has(std::string_view key) { return find(key) != nullptr; }

  void require(std::string_view key, std::string_view what) {
    if (!has(key)) complain(fmt::format("'{}' is missing", key), std::string(what));
  }
  void text(std::string_view key, std::string& target, std::size_t longest = longest_text) {
    value<std::string>(
        key, "text", [&](std::string const& found) { target = found; }, longest);
  }
  template <class Target>  // double or std::optional<double>
  void number(std::string_view key, Range const& range, Target& target) {
    value<double>(key, "a number", [&](double found) {
      refuse_outside(found, range);
      target = found;
    });
  }
  void count(std::string_view key, int lowest, int highest, int& target) {
    value<std::int64_t>(key, "a whole number", [&](std::int64_t found) {
      refuse_outside(static_cast<double>(found), {static_cast<double>(lowest), static_cast<double>(highest)});
      target = static_cast<int>(found);
    });
  }
  void numbers(std::string_view key, Range const& range, std::vector<double>& target) {
    auto const* node = find(key);
    if (node == nullptr) return;
    auto const* list = node->as_array();
    bool const right = list != nullptr && !list->empty() && list->size() <= most_items &&
                       std::ranges::all_of(*list, [](auto const& item) { return item.is_number(); });
    if (!right) return complain(*node, fmt::format("'{}' is not a list of numbers", key), "[0.1, 0.5]");
    for (auto const& item : *list)
      guarded(item, key, [&] {
        double const found = *item.template value<double>();
        refuse_outside(found, range);
        target.push_back(found);
      });
  }
  bool cycles(std::string_view key, int& first, int& last) {  // reads a range; false if there is no valid one
    auto const* node = find(key);
    if (node == nullptr) return false;
    std::vector<std::int64_t> ends;
    if (auto const* list = node->as_array(); list != nullptr && list->size() == 2)
      for (auto const& item : *list)
        if (item.is_integer()) ends.push_back(*item.value<std::int64_t>());
    auto const from = ends.size() == 2 ? ends[0] : 0, to = ends.size() == 2 ? ends[1] : 0;
    if (from < 1 || to <= from || to > last_cycle) {
      complain(*node, fmt::format("'{}' is not a range of cycles", key),
               fmt::format("[first, last], from 1 to {}, the last above the first", last_cycle));
      return false;
    }
    first = static_cast<int>(from);
    last = static_cast<int>(to);
    return true;
  }
  template <class Value>
  void choice(std::string_view key, Choices<Value> const& choices, Value& target) {
    value<std::string>(key, "text", [&](std::string const& found) {
      auto const chosen = std::ranges::find(choices, found, &std::pair<std::string_view, Value>::first);
      if (chosen != choices.end()) return void(target = chosen->second);
      auto const quoted = [](auto const& choice) { return fmt::format("\"{}\"", choice.first); };
      throw Error({.where = "", .found = in_quotes(found), .allowed = joined(choices | std::views::transform(quoted))});
    });
  }
  template <class Take>
  void tables(std::string_view key, Take&& take) {
    auto const* node = find(key);
    if (node == nullptr) return;
    if (!node->is_array_of_tables() || node->as_array()->size() > most_tables)
      return complain(*node, fmt::format("'{}' is not a list of at most {} tables", key, most_tables),
                      fmt::format("[[{}]]", key));
    for (auto const& item : *node->as_array()) take(*item.as_table());
  }

 private:
  static void refuse_outside(double found, Range const& range) {
    if (!range.holds(found))
      throw Error({.where = "",
                   .found = fmt::format("{} is out of range", found),
                   .allowed = fmt::format("{:g} to {:g}", range.lower, range.upper)});
  }
};

class Reader {
 public:
  explicit Reader(std::string const& file) : file_(file) {}

  RuleSet read(toml::table const& root) {
    RuleTable top(root, file_, "", complaints_);
    set_.origin = file_;
    identity(top);
    section(top, "formulas", &Reader::formulas);
    section(top, "cycles", &Reader::cycles);
    section(top, "test", &Reader::conditions);
    section(top, "same_condition", &Reader::same_condition);
    section(top, "sample", &Reader::sample);
    section(top, "load_variation", &Reader::load_variation);
    section(top, "mean_analysis", &Reader::mean_analysis);
    section(top, "factors", &Reader::factors);
    sections(top, "limit", &Reader::limit);
    sections(top, "stability", &Reader::stability);
    sections(top, "factor", &Reader::property_factors);
    section(top, "combination", &Reader::combination);
    sections(top, "effect", &Reader::effect);
    sections(top, "dependence", &Reader::dependence);
    auto& how = set_.combination;
    if (!how && top.has("factors")) how = {.form = Form::asce, .clause = set_.factors.clause};
    if (how && how->form == Form::asce) how->adjust = set_.factors.system_factor;
    for (auto const key : {"formulas", "cycles"}) top.require(key, fmt::format("[{}]", key));
    auto const has = [&](std::string_view key) { return top.has(key); };
    if (std::ranges::none_of(std::array{"limit", "effect", "dependence", "combination"}, has))
      top.complain("no limits", "one [[limit]] table for each limit, or [[effect]] tables");
    top.refuse_unknown();
    throw_complaints(std::move(complaints_), file_);
    return std::move(set_);
  }

 private:
  using Read = void (Reader::*)(RuleTable&);
  void section(RuleTable& top, std::string_view key, Read fill) {
    if (auto const* found = top.table(key)) read_table(*found, fmt::format("[{}]", key), fill);
  }
  void sections(RuleTable& top, std::string_view key, Read fill) {
    top.tables(key, [&](toml::table const& found) { read_table(found, fmt::format("[[{}]]", key), fill); });
  }
  void read_table(toml::table const& found, std::string const& name, Read fill) {
    RuleTable table(found, file_, name, complaints_);
    (this->*fill)(table);
    table.refuse_unknown();
  }

  void identity(RuleTable& top) {
    top.value<std::string>("id", "text", [&](std::string const& id) {
      bool const plain = !id.empty() && id.size() <= 64 && std::ranges::all_of(id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
      });
      if (!plain)
        throw Error({.where = "", .found = in_quotes(id), .allowed = "1 to 64 of a to z, 0 to 9, '-' and '.'"});
      set_.id = id;
    });
    top.text("title", set_.title);
    top.text("edition", set_.edition);
    top.text("source", set_.source, longest_note);
    top.value<std::string>("verified_by", "text", [&](std::string const& who) {
      if (!who.empty() && who.find_first_not_of(' ') == std::string::npos)
        throw Error(
            {.where = "", .found = "blanks alone", .allowed = "\"\" while nobody has compared it with its text"});
      set_.verified_by = who;
    });
    for (auto const key : {"id", "title", "edition", "source", "verified_by"})
      top.require(key, "id, title, edition, source and verified_by, which may be \"\"");
  }

  void formulas(RuleTable& table) {
    Choices<Formula> const choices{{"peak_to_peak", Formula::peak_to_peak}, {"per_side", Formula::per_side}};
    table.choice("stiffness", choices, set_.stiffness_formula);
    table.choice("damping", choices, set_.damping_formula);
    for (auto const key : {"stiffness", "damping"}) table.require(key, "stiffness and damping");
  }

  void cycles(RuleTable& table) {
    auto& cycles = set_.cycles;
    table.count("one", 1, last_cycle, cycles.first);
    cycles.last = cycles.first;
    if (table.cycles("mean_of", cycles.first, cycles.last)) cycles.counting = Counting::mean;
    if (table.cycles("each_of", cycles.first, cycles.last)) cycles.counting = Counting::each;
    if (table.has("one") + table.has("mean_of") + table.has("each_of") != 1)
      table.complain("not exactly one way of counting cycles", "one = 3, or mean_of = [1, 3], or each_of = [2, 10]");
  }

  void conditions(RuleTable& table) {
    auto& test = set_.test;
    table.numbers("strains_percent", percent, test.strains_percent);
    table.number("strain_tolerance_percent", percent, test.strain_tolerance_percent);
    table.numbers("frequencies_Hz", frequency_Hz, test.frequencies_Hz);
    table.number("frequency_tolerance_percent", percent, test.frequency_tolerance_percent);
    table.number("displacement_tolerance_percent", percent, test.displacement_tolerance_percent);
    table.number("load_tolerance_percent", percent, test.load_tolerance_percent);
    table.text("clause", test.clause, longest_note);
    if (table.has("strains_percent") != table.has("strain_tolerance_percent"))
      table.complain("strains without their tolerance, or the reverse", "strains_percent and strain_tolerance_percent");
    // A tolerance without frequencies is allowed: it also limits the difference from the design frequency.
    if (table.has("frequencies_Hz") && !table.has("frequency_tolerance_percent"))
      table.complain("frequencies without their tolerance", "frequencies_Hz and frequency_tolerance_percent");
  }

  void same_condition(RuleTable& table) {
    auto& same = set_.same_condition;
    table.number("temperature_C", kelvins, same.temperature_C);
    table.number("frequency_percent", percent, same.frequency_percent);
    table.number("load_percent", percent, same.load_percent);
    table.number("amplitude_percent", percent, same.amplitude_percent);
    table.number("earlier_cycles", earlier, same.earlier_cycles);
    table.text("clause", same.clause, longest_note);
  }

  void sample(RuleTable& table) {
    SampleRule rule;
    table.number("share_percent", share, rule.share_percent);
    table.count("least", 1, 100'000, rule.least);
    table.text("clause", rule.clause, longest_note);
    table.require("share_percent", "share_percent, 100 for every device");
    set_.sample = rule;
  }

  void load_variation(RuleTable& table) {
    one_number(table, "largest_percent", &LoadVariation::largest_percent, set_.load_variation);
  }
  void mean_analysis(RuleTable& table) {
    one_number(table, "within_percent", &MeanAnalysisRule::within_percent, set_.mean_analysis);
  }
  template <class Rule>
  static void one_number(RuleTable& table, char const* key, double Rule::*number, std::optional<Rule>& rule) {
    rule.emplace();
    table.number(key, percent, (*rule).*number);
    table.text("clause", rule->clause, longest_note);
    table.require(key, key);
  }

  void factors(RuleTable& table) {
    auto& rule = set_.factors;
    table.number("system_factor", ratio, rule.system_factor);
    table.number("max_not_below", {1.0, factor.upper}, rule.max_not_below);
    table.number("min_not_above", {factor.lower, 1.0}, rule.min_not_above);
    table.text("clause", rule.clause, longest_note);
  }

  void limit(RuleTable& table) {
    Limit rule;
    std::optional<double> within;
    table.choice("quantity", quantities(), rule.quantity);
    table.choice("applies_to", {{"each", Scope::each}, {"mean", Scope::mean}}, rule.scope);
    table.number("within_percent", percent, within);
    table.number("lower_percent", deviation, rule.lower_percent);
    table.number("upper_percent", deviation, rule.upper_percent);
    table.text("clause", rule.clause, longest_note);
    table.require("quantity", "quantity");
    table.require("applies_to", "\"each\" device or the \"mean\" of the lot");
    bool const both_ways = table.has("lower_percent") || table.has("upper_percent");
    if (table.has("within_percent") == both_ways)
      table.complain(both_ways ? "within_percent beside lower_percent or upper_percent" : "a limit without a bound",
                     "within_percent = 20, or lower_percent = -25, upper_percent = 10, or one of them");
    if (within) {
      rule.lower_percent = -*within;
      rule.upper_percent = *within;
    }
    if (rule.lower_percent.value_or(0.0) > 0.0 || rule.upper_percent.value_or(0.0) < 0.0)
      table.complain("the design value itself is outside the limit", "lower_percent <= 0 <= upper_percent");
    for (auto const& other : set_.limits)
      if (other.quantity == rule.quantity && other.scope == rule.scope)
        table.complain(fmt::format("a second limit of {} for {}", name(rule.quantity),
                                   rule.scope == Scope::each ? "each device" : "the mean"),
                       "one limit, with both ends where it has two");
    set_.limits.push_back(std::move(rule));
  }

  void stability(RuleTable& table) {
    StabilityLimit rule;
    table.choice("quantity", quantities(), rule.quantity);
    table.choice("measure",
                 {{"min_over_max", Measure::min_over_max},
                  {"change_from_first", Measure::change_from_first},
                  {"loss_from_first", Measure::loss_from_first}},
                 rule.measure);
    table.cycles("cycles", rule.first, rule.last);
    bool const is_ratio = rule.measure == Measure::min_over_max;
    std::string_view const key = is_ratio ? "at_least" : "at_most_percent";
    table.number(key, is_ratio ? ratio : percent, rule.bound);
    table.text("clause", rule.clause, longest_note);
    for (auto const needed : {"quantity", "measure", "cycles"}) table.require(needed, "quantity, measure and cycles");
    table.require(key, "at_least for min_over_max, at_most_percent for the others");
    if (rule.quantity == Quantity::K_v) table.complain("K_v is not measured in cycles", "another quantity");
    set_.stability.push_back(std::move(rule));
  }

  void property_factors(RuleTable& table) {
    PropertyFactors given;
    Range const below{factor.lower, 1.0}, above{1.0, factor.upper};
    table.choice("quantity", quantities(), given.quantity);
    table.number("environment_min", below, given.environment_min);
    table.number("environment_max", above, given.environment_max);
    table.number("spec_min", below, given.spec_min);
    table.number("spec_max", above, given.spec_max);
    table.require("quantity", "quantity");
    if (table.has("spec_min") != table.has("spec_max"))
      table.complain("half a contract band", "spec_min and spec_max, or neither");
    if (set_.factors_of(given.quantity) != nullptr)
      table.complain(fmt::format("a second [[factor]] of {}", name(given.quantity)), "one for each quantity");
    set_.factors.properties.push_back(given);
  }

  void combination(RuleTable& table) {
    CombinationRule rule;
    table.choice("form", by_name(forms()), rule.form);
    table.number("adjust", ratio, rule.adjust);
    table.number("margin", factor, rule.margin);
    table.text("clause", rule.clause, longest_note);
    table.require("form", "form");
    if (table.has("adjust") && rule.form == Form::asce)
      table.complain("'adjust' with the form \"asce\"", "system_factor in [factors], which is f of this form");
    if (table.has("adjust") && rule.form == Form::sum)
      table.complain("'adjust' with the form \"sum\"", "margin = 1.0; a sum is not adjusted");
    if (table.has("margin") && rule.form != Form::sum)
      table.complain(fmt::format("'margin' with the form \"{}\"", name(rule.form)), "'margin' with the form \"sum\"");
    set_.combination = std::move(rule);
  }

  void effect(RuleTable& table) {
    EffectRule rule;
    table.choice("name", by_name(effects()), rule.effect);
    if (table.has("group")) table.choice("group", by_name(groups()), rule.group.emplace());
    // Damping needs no default factors, because it follows from K_eff and energy. K_v has none either.
    Choices<Quantity> combined;
    for (auto const& choice : by_name<Quantity>(measured_quantities()))
      if (choice.second != Quantity::damping) combined.push_back(choice);
    if (table.has("quantity")) table.choice("quantity", combined, rule.quantity.emplace());
    table.number("default_max", {1.0, factor.upper}, rule.default_max);
    table.number("default_min", {factor.lower, 1.0}, rule.default_min);
    table.text("clause", rule.clause, longest_note);
    table.require("name", "name");
    bool const whole = table.has("quantity") && table.has("default_max") && table.has("default_min");
    if (!whole && (table.has("quantity") || table.has("default_max") || table.has("default_min")))
      table.complain("half a default", "quantity, default_max and default_min, or none of them");
    for (auto const& other : set_.effects) {
      if (other.effect != rule.effect) continue;
      if (other.quantity == rule.quantity)
        table.complain(fmt::format("a second [[effect]] of {}{}", name(rule.effect),
                                   rule.quantity ? fmt::format(" on {}", name(*rule.quantity)) : ""),
                       "one for each effect and quantity");
      if (other.group && rule.group && other.group != rule.group)
        table.complain(fmt::format("{} is of group \"{}\" and of group \"{}\"", name(rule.effect), name(*other.group),
                                   name(*rule.group)),
                       "one group for each effect");
    }
    set_.effects.push_back(std::move(rule));
  }

  void dependence(RuleTable& table) {
    DependenceLimit rule;
    std::array<Effect, 4> constexpr tested{Effect::temperature, Effect::rate, Effect::load, Effect::ageing};
    table.choice("effect", by_name<Effect>(tested), rule.effect);
    table.choice("quantity", by_name<Quantity>(measured_quantities()), rule.quantity);
    table.number("within_percent", percent, rule.within_percent);
    table.numbers("levels",
                  rule.effect == Effect::temperature ? temperature_C
                  : rule.effect == Effect::rate      ? frequency_Hz
                                                     : load_kN,
                  rule.levels);
    table.text("clause", rule.clause, longest_note);
    for (auto const key : {"effect", "quantity", "within_percent"})
      table.require(key, "effect, quantity and within_percent");
    if (rule.effect == Effect::ageing && table.has("levels"))
      table.complain("'levels' of ageing", "no levels: the ageing of the design is taken");
    for (auto const& other : set_.dependence) {
      if (other.effect != rule.effect || other.quantity != rule.quantity) continue;
      bool const shared = std::ranges::any_of(
          rule.levels, [&](double level) { return std::ranges::find(other.levels, level) != other.levels.end(); });
      if (shared || rule.levels.empty() || other.levels.empty())
        table.complain(fmt::format("a second limit of {} on {}", name(rule.effect), name(rule.quantity)),
                       "one limit for each effect, quantity and level");
    }
    set_.dependence.push_back(std::move(rule));
  }

  std::string file_;
  std::vector<Complaint> complaints_;
  RuleSet set_;
};

}  // namespace

RuleSet read_rule_text(std::string_view text, std::string const& file) {
  TomlMessages const messages{.kind = "rule file", .advice = "isolaw rules template prints a commented one"};
  if (text.size() > largest_rule_file)
    throw Error({.where = file,
                 .found = fmt::format("{} bytes", text.size()),
                 .allowed = fmt::format("a rule file of at most {}", largest_rule_file),
                 .advice = std::string(messages.advice)});
  return Reader(file).read(parse_toml(text, file, messages));
}

}  // namespace isolaw::rules
