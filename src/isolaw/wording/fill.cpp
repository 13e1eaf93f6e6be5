#include "isolaw/wording/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

// A finding has words, each with a name and a value. If its word `name` has the value `word`, `text` is printed in
// place of {name}. Without a phrase for the value, the value itself is printed.
struct Phrase {
  std::string_view name, word, text;
};
constexpr Phrase phrases[]{
    {"weights", "swing", "by swing: a sample counts by half the range over the duration of its swing, rest by nothing"},
    {"weights", "travel", "by travel: a sample counts by the way that the device moves about it"},
    {"weights", "time", "by time, because the record has no two turning points between which it swings"},
    {"kept", "pass", "PASS"},
    {"kept", "not assessed", "NOT ASSESSED"},
    {"kept", "information", "no verdict, since nobody has verified the rule set"},
    {"changes", "reference", "it differs from its value at reference by "},
    {"changes", "loads", "it differs between the least and the largest load of the design by "},
    {"because", "no condition", "; the design does not state this condition"},
    {"because", "no test", "; no device was tested there and at reference too"},
    {"because", "extrapolated", "; a device was not tested as far as this condition"},
    {"because", "scaled", "; the specimens are scaled"},
    {"because", "other tests", "; the reference tests are not those that the rule set asks for"},
    {"mean_properties", "no", "NOT PERMITTED, so that upper and lower bounds are needed"},
    {"mean_properties", "yes", "permitted as far as the design conditions go"},
    {"mean_properties", "open", "open, because tests do not show all factors"},
    {"partial", "upper", "at least"},
    {"partial", "lower", "at most"},
    {"unverified", "yes", ""},
    {"unknown", "yes", ""},
    {"role", "combined", "more than one condition differs from the reference"},
    {"role", "another strain", "the amplitude is not that of the reference"},
    {"role", "no reference cycle", "there are fewer cycles than the reference needs"},
    {"role", "another history", "the device had another history in the reference cycle than in its reference tests"},
    {"role", "no reference test", "the device has no reference test, and devices with one show the effect"},
    {"role", "another compound or size", "[conditions] names another compound or size"},
    {"role", "scaled specimen", "devices of full size show the effect"},
    {"lack", "no-test", "no test that can be compared shows it"},
    {"lack", "no-design", "the rule set asks for it, and the design states no range of it"},
    {"lack", "too-far",
     "the devices with a reference test were tested too far from it, for a line goes on by 10 degrees, a factor of 2 in frequency or 20 % of the load at most"},
    {"lack", "no-level", "no test that can be compared has the ageing of the design"},
    {"lack", "no-energy", "a life in years needs activation-energy-kJ-mol with its source"},
    {"lack", "too-long", "the life of the design is more than twice that for which the ageing test stands"},
    {"lack", "no-new-device", "no reference test of a new device has its first cycle"},
    {"lack", "no-rest", "no reference tests after a shorter and a longer rest show how much comes back"},
    {"lack", "no-cycle", "no reference test has so many cycles"},
    {"lack", "unknown-scatter",
     "only devices without a reference test were tested, and a single reference test does not show how devices differ"},
    {"among", "adequate", " of those that describe the devices"},
    {"among", "all", ""},
    {"least", "all", "the least of all"},
    {"least", "adequate", "the least of those that describe the devices"},
    {"least", "predicting", "the least of those that describe the devices and predict"},
    {"least", "unboxed", "the least that no search box decides"},
    {"none_between", "no", ""},
    {"none_between", "yes",
     " No law between them holds up: each leaves the front when the optimiser's noise is taken out, is held by its search box, or does not predict."},
    {"same", "yes", "the same: "},
    {"same", "no", ""},
    {"nominal_outside", "yes", "since the nominal building itself is outside them"},
    {"more", "law", "The choice of the law"},
    {"more", "lot", "The scatter of the lot"},
    {"less", "law", "the choice of the law"},
    {"less", "lot", "the scatter of the lot"},
    {"fitted_to", "tests", "what it was fitted to"},
    {"fitted_to", "devices", "a device that it was not fitted to"},
    {"larger", "unknown", " Nothing shows how it goes on to a larger amplitude."},
    {"larger", "known", ""},
    {"rule", "not-finite", "its force is not finite in cycles of {amplitude_mm:4}"},
    {"rule", "not-finite-larger",
     "fitted to the smaller swings of the tests, its force is not finite in the larger ones"},
    {"rule", "gives-energy", "it gives back energy in cycles of {amplitude_mm:4}"},
    {"rule", "not-stiff", "its stiffness is not positive in cycles of {amplitude_mm:4}"},
    {"rule", "stiffness",
     "its stiffness at {amplitude_mm:4} is {value:.2f} times that at {tested_mm:4}, where the tests end"},
    {"rule", "damping",
     "its damping at {amplitude_mm:4} is {value:.2f} times that at {tested_mm:4}, where the tests end"},
    {"rule", "overdamped",
     "its damping in cycles of {amplitude_mm:4} and {period_s:3} s is {value:%}[, but {measured:%} in the tests]"},
    {"rule", "overshoots",
     "in cycles of {amplitude_mm:4} its largest force is {value:.1f} times its force at the peaks"},
    {"rule", "jumps", "in cycles of {amplitude_mm:4} its force jumps by {value:%} of that at the peaks"},
    {"rule", "speed",
     "in cycles of {amplitude_mm:4} and {period_s:3} s its damping is {value:.2f} times that at the tested speed"},
    {"sure", "weak", ", with care"},
    {"sure", "tie", ""},
    {"sure", "clear", ""},
    {"verdict_same", "yes", " The verdict would be the same."},
    {"beyond", "yes", ", where nothing was tested"},
    {"beyond", "no", ""},
    {"several_laws", "yes", ""},
    {"only_law", "yes", ""},
    {"some", "yes", ""},
    {"up_to", "yes", ""},
    {"altered", "yes", ""},
    {"reduced", "yes", ", in its reduced form"},
    {"fit_cycles", "open", " To fit the first or the last cycles, use --fit-cycles."},
    {"objectives", "",
     "objective {predicted_objective:3} on blocks it was not fitted to ({worst_predicted:3} at worst), {fitted_objective:3} on the fitted ones"},
    {"collapse", "no", ""},
    {"collapse", "constant",
     " It misses one of the predicted blocks by more than the force's standard deviation, as a constant force would."},
    {"collapse", "far", " Its error on the predicted blocks is {times_as_far:.0f} times its error on the fitted ones."},
    {"collapse", "far_from_exact", " It misses the predicted blocks, but not the fitted ones."},
    {"factors", "none", "no factors up to {grid_low:.2f} and {grid_high:.2f} would cover {wanted:0%}"},
    {"factors", "near", "factors within {grid_step:0%} of 1, the step of the search, would cover {wanted:0%}"},
    {"factors", "found", "factors of {factor_low:.2f} and {factor_high:.2f} would cover {wanted:0%}"},
    {"than_any", "longer", "no isolator goes that far"},
    {"than_any", "stiffer", "{stiffness_kN_per_mm:4} is stiffer than any isolator"},
    {"than_any", "softer", "{stiffness_kN_per_mm:4} is softer than any isolator"},
    {"holds", "yes", "Yes: with {law} the building keeps every limit that is set"},
    {"holds", "no", "No: with {law} the building does not keep its limit on {which}"},
    {"holds", "open",
     "No answer yet: {draws:,} draws do not tell whether the building with {law} keeps its limit on {which}[; {wanted:,} do if the share that keeps it stays as it is]"},
    {"holds", "untested",
     "No answer yet: with {law} the building keeps every limit that is set, but its bearings move further than they were tested"},
    {"holds", "unlimited", "The building file sets no limits, so this says only how far the building moves with {law}"},
    {"alone", "yes",
     "; this is the nominal building alone, and neither the bound analyses nor the scatter of the lot were looked at"},
    {"where", "nominal", " in the nominal building"},
    {"where", "bounds", " in the bound analyses"},
    {"where", "both", " in the nominal building and in the bound analyses"},
    {"also", "alone", ""},
    {"also", "too", ", and"},
    {"answer", "Yes", "Yes: with"},
    {"answer", "No", "No: with"},
    {"answer", "No answer yet", "No answer yet: with"},
    {"answer", "of another law", "With"},
    {"how", "along axes",
     ": it acts once along each axis, what is positive in the tests is positive along it, and the two axes do not know of each other"},
    {"how", "in a model",
     ": an isolator that follows it does so once along each of its axes, positive where the tests are, and the two axes do not know of each other; an element that couples them cannot follow it"},
    {"how", "springs", ", so its springs also give a force across the motion, which depends on the axes"},
    {"tested", "within", "they were tested to {tested_mm:3}"},
    {"tested", "beyond", "they were tested to only {tested_mm:3}, and beyond that the law is extrapolated"},
    {"bearings", "one", "The bearing stands at {place}"},
    {"bearings", "alike", "On average over {over} all bearings move alike, within {alike:0%}"},
    {"bearings", "unlike",
     "Bearing {number} at {place} moves most, {most_mm:3} on average over {over}, against {least_mm:3} of the one that moves least"},
    {"over", "draws", "buildings and motions"},
    {"over", "motions", "the motions"},
    {"motions", "several", "{motion_std_ln:0%}"},
    {"of", "draws", "95 % of the draws, under the strongest motion"},
    {"made", "parts",
     "the elastic part of the force times {elastic_factor:.3f}, the hysteretic part times {hysteretic_factor:.3f}"},
    {"made", "whole",
     "the whole force times {elastic_factor:.3f}, since {since}; damping unchanged: energy is off by {energy_off_percent:+.1f} %"},
    {"since", "inseparable", "no parameters of this law change one part of its force alone"},
    {"since", "not-positive", "no positive factors on the two parts give both"},
    {"since", "limits", "parameters would leave their limits"},
    {"since", "not-reached", "the two parts of this law act on each other"},
    {"because", "no-table", "the lot file has no table of conditions"},
    {"because", "no-design", "the design in the table of conditions names none"},
    {"because", "not-covered", "no test covers {effects}"},
    {"because", "no-frequency", "this law depends on velocity, and the frequency of the reference tests is not known"},
    {"because", "no-loop", "K_eff or energy of this law is not above 0 in cycles of {amplitude_mm:4}"},
    {"whole", "yes", "the whole record, which has no cycle to report"},
};

class Filler {
 public:
  Filler(Group group, UnitSystem const& units) : group_(group), units_(units) {}

  std::string operator()(std::string_view text) {
    std::string out;
    while (!text.empty()) {
      auto const open = text.find_first_of("{[<~");
      out += text.substr(0, open);
      if (open == text.npos) break;
      char const close = text[open] == '{' ? '}' : text[open] == '[' ? ']' : text[open] == '<' ? '>' : '~';
      auto const end = text.find(close, open + 1);
      auto const inner = text.substr(open + 1, end - open - 1);
      if (close == '}')
        out += field(inner);
      else if (close == ']')
        out += has_all(inner) ? (*this)(inner) : std::string();
      else if (close == '>')
        out += each(group_, [&](Finding const& finding) { return Filler(Group(&finding, 1), units_)(inner); });
      else
        out += each_part(inner);
      text.remove_prefix(end + 1);
    }
    return out;
  }

 private:
  Finding const& first() const { return group_.front(); }

  bool has_all(std::string_view text) const {
    for (auto open = text.find('{'); open != text.npos; open = text.find('{', open + 1)) {
      auto const end = text.find_first_of(":|}", open);
      auto const name = text.substr(open + 1, end - open - 1);
      bool const is_count = text[end] == '}';
      if (text[end] != '|' && (!has(name) || (is_count && first().has_number(name) && first().number(name) == 0.0)))
        return false;
    }
    return true;
  }
  bool has(std::string_view name) const {
    if (name == "law") return !first().law.empty();
    if (name == "laws") return !first().other_laws.empty();
    if (name == "devices") return !first().devices.empty();
    if (name == "block") return !first().blocks.empty();
    if (name == "parameters") return !first().parameters.empty() || first().has_number(name);
    return first().has_number(name) || !first().word(name).empty();
  }

  std::string each_part(std::string_view inner) const {
    constexpr std::size_t most = 6;
    std::vector<std::string> parts;
    for (auto const& finding : group_) parts.push_back(Filler(Group(&finding, 1), units_)(inner));
    return enumerate(parts, most);
  }

  std::string list(std::vector<std::string> const& names) {
    count_ = static_cast<double>(names.size());
    return enumerate(names);
  }

  std::string field(std::string_view inner) {
    if (auto const bar = inner.find('|'); bar != inner.npos)
      return std::string(count_ == 1.0 ? inner.substr(0, bar) : inner.substr(bar + 1));
    auto const name = take_part(inner, ':');
    if (name == "law") return law_name(first());
    if (name == "devices") return printable(list(devices_of(group_)));
    if (name == "parameters" && !first().has_number(name)) return list(parameters_of(group_));
    if (name == "block") return std::to_string(first().blocks.empty() ? 0 : first().blocks.front());
    if (name == "laws") {
      std::vector<std::string> names;
      for (auto const& id : first().other_laws) names.emplace_back(laws::display_name(id));
      return list(names);
    }
    if (inner == "law") return std::string(laws::display_name(first().word(name)));
    bool const in_unit = inner.starts_with("unit");
    if (!in_unit && !first().has_number(name)) return word(name);
    auto const number = in_unit ? fmt::format("{}_{}", name, first().word("unit")) : std::string(name);
    if (in_unit) inner.remove_prefix(4);
    auto spec = take_part(inner, ' ');
    bool const is_bare = spec.ends_with('!');
    if (is_bare) spec.remove_suffix(1);
    count_ = first().number(number);
    auto const shown = shown_unit(in_unit || inner == "unit" ? first().word("unit") : unit_of_name(number), units_);
    auto const text = range(group_, number, [&](double value) { return print(value, spec, shown); });
    return is_bare || shown.unit.empty() ? text : text + " " + shown.unit;
  }

  std::string word(std::string_view name) {
    auto const word = first().word(name);
    auto const found =
        std::ranges::find_if(phrases, [&](Phrase const& phrase) { return phrase.name == name && phrase.word == word; });
    return found != std::end(phrases) ? (*this)(found->text) : on_one_line(std::string(word));
  }

  static std::string print(double value, std::string_view spec, ShownUnit const& shown) {
    value *= shown.factor;
    if (spec.empty()) return fmt::format("{}", value);
    if (spec == "%") return percent(value);
    if (spec == "few%") return value == 0.0 ? "none" : "only " + percent(value);
    if (spec == "%1") return with_decimals(100.0 * value, 1) + " %";
    if (spec == "0%") return fmt::format("{:.0f} %", 100.0 * value);
    if (spec == ",") {
      auto text = fmt::format("{:.0f}", value);
      for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
      return text;
    }
    if (auto const digits = number_in<int>(spec)) return number_text(value, *digits);
    if (shown.factor != 1.0 && spec.starts_with('.') && spec.ends_with('f'))
      if (auto const decimals = number_in<int>(spec.substr(1, spec.size() - 2)))
        return fmt::format("{:.{}f}", value, shown.decimals(*decimals));
    return fmt::format(fmt::runtime(fmt::format("{{:{}}}", spec)), value);
  }

  Group group_;
  UnitSystem const& units_;
  double count_ = 0.0;  // the last number printed, or the length of the last list
};

}  // namespace

std::string fill(std::string_view text, Group group, UnitSystem const& units) {
  return Filler(group, units)(text);
}

std::string remark(Group group, UnitSystem const& units) {
  auto const part = group.front().word("part");
  auto const& about = row(group.front().kind);
  return (part.empty() ? std::string() : std::string(part) + ": ") +
         (about.compose != nullptr ? about.compose(group, units) : fill(about.text, group, units));
}
}  // namespace isolaw::wording
