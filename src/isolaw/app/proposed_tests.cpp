#include "isolaw/app/proposed_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "isolaw/base/words.hpp"

namespace isolaw::app {
namespace {

constexpr double usual_C = 20.0;  // the temperature at which most tests are made

// Returns the test that suits best as the reference. It prefers tests of devices that are not aged, with counted cycles
// and a stated temperature. Among these it takes the one from which most other tests differ in at most one condition.
RecognisedTest const& reference_of(std::vector<RecognisedTest> const& tests,
                                   std::vector<campaign::ProposedTest> const& proposed) {
  conditions::Tolerance const tolerance;
  auto const rank = [&](std::size_t candidate) {
    auto const& reference = tests[candidate];
    auto const is_alike = [&](RecognisedTest const& test) {
      return conditions::agrees(test.amplitude_mm, reference.amplitude_mm, tolerance.strain_percent) &&
             conditions::differences(test.condition, reference.condition, tolerance).size() <= 1;
    };
    auto const& temperature_C = reference.condition.temperature_C;
    return std::tuple(!proposed[candidate].is_aged, reference.cycles > 0, temperature_C.has_value(),
                      std::ranges::count_if(tests, is_alike), -std::abs(temperature_C.value_or(usual_C) - usual_C));
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < tests.size(); ++i)
    if (rank(i) > rank(best)) best = i;
  return tests[best];
}

std::string text_of(RecognisedTest const& reference) {
  constexpr int usual_cycle = 3;
  auto const rounded = [](double value) { return std::stod(fmt::format("{:.4g}", value)); };
  auto const& at = reference.condition;
  auto text = fmt::format("{{ temperature-C = {:g}", at.temperature_C.value_or(usual_C));
  if (at.frequency_Hz) text += fmt::format(", frequency-Hz = {:g}", rounded(*at.frequency_Hz));
  if (at.load_kN && *at.load_kN > 0.0) text += fmt::format(", load-kN = {:g}", rounded(*at.load_kN));
  if (reference.amplitude_mm > 0.0) text += fmt::format(", disp-mm = {:g}", rounded(reference.amplitude_mm));
  return text + fmt::format(", cycle = {} }}", std::clamp(reference.cycles, 1, usual_cycle));
}

}  // namespace

void propose_conditions(campaign::Lot const& lot, std::vector<RecognisedTest> tests,
                        campaign::LotFileRemarks& remarks) {
  std::vector<std::string> names;
  for (auto const& device : lot.devices) names.push_back(device.name);
  auto proposed = campaign::propose_tests(names);
  std::map<std::string, int> records;
  bool any = false;
  for (std::size_t i = 0; i < proposed.size(); ++i) {
    ++records[proposed[i].device];
    any |= proposed[i].device != names[i];
  }
  if (!any || std::ranges::none_of(records, [](auto const& each) { return each.second > 1; })) return;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    auto& at = tests[i].condition;
    auto& test = proposed[i];
    if (!test.temperature_C) test.temperature_C = at.temperature_C;
    at.temperature_C = test.temperature_C;
    // A lot file states a load only for a record without a channel of the load.
    if (at.load_kN) test.load_kN.reset();
    if (test.load_kN) at.load_kN = test.load_kN;
    if (test.is_aged) at.ageing = conditions::Ageing{};
  }
  auto const& reference = reference_of(tests, proposed);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    auto const& at = tests[i].condition;
    proposed[i].lacks_load = reference.condition.load_kN.value_or(0.0) > 0.0 && !at.load_kN;
    proposed[i].is_near_reference = conditions::agree_in(conditions::Effect::temperature, at, reference.condition, {});
  }
  remarks.reference = text_of(reference);
  remarks.tests = std::move(proposed);
}

}  // namespace isolaw::app
