// Reads the input as a rule file and assesses tests by it. All texts of the rule set must be printable. A rule set that
// nobody has verified must not give a verdict.
#include "harness.hpp"
#include "isolaw/rules/lot_view.hpp"

namespace {

using namespace isolaw;

rules::BlockValues block() {
  rules::BlockValues values{.number = 1,
                            .amplitude_mm = 100.0,
                            .frequency_Hz = 0.5,
                            .shear_strain_percent = 100.0,
                            .load_mean_kN = 1000.0,
                            .cycles = {}};
  for (int number = 1; number <= 11; ++number) {
    data::Cycle& cycle = values.cycles.emplace_back();
    cycle.number = number;
    cycle.d_plus_mm = 100.0;
    cycle.d_minus_mm = -100.0;
    cycle.F_plus_kN = 120.0;
    cycle.F_minus_kN = -115.0;
    cycle.K_eff_kN_per_mm = 1.175;
    cycle.damping_percent = 15.0;
    cycle.energy_kN_mm = 11074.0;
    cycle.Q_d_kN = 30.0;
    cycle.K_d_kN_per_mm = 0.875;
  }
  return values;
}

void require_plain(std::string const& text) {
  fuzz::require(is_printable(text), "a text of a rule set is printable");
}

void require_line(rules::RuleSet const& set, rules::Assessment const& line) {
  bool const verdict = line.verdict == rules::Verdict::pass || line.verdict == rules::Verdict::fail;
  fuzz::require(set.verified() || !verdict, "a set that nobody verified gives no verdict");
  fuzz::require(verdict == line.reason.empty(), "there is a verdict, or a reason why not");
  require_plain(line.clause);
  require_plain(line.limit);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  try {
    auto const set = rules::read_rule_text(fuzz::as_text(data, size), "rules.toml");
    for (auto const* text : {&set.id, &set.title, &set.edition, &set.source, &set.verified_by}) require_plain(*text);
    auto const design = rules::parse_design("K_eff=1.2,damping=15,energy=11000,Q_d=30,K_d=0.9,disp=100,load=1000");
    for (auto const& line : rules::assess(set, block(), design)) require_line(set, line);
    for (auto const& line : rules::assess(set, block(), design, rules::LoadPair{block(), block()}))
      require_line(set, line);
    // The statistics of a lot of several devices take 5 ms, so only some inputs get more than one device.
    std::vector<rules::DeviceValues> const devices(size % 16 == 0 ? 2 : 1, rules::DeviceValues{"A", block()});
    auto const lot = rules::lot_view(set, devices, design, 28);
    require_line(set, lot.sample);
    for (auto const& quantity : lot.quantities)
      for (auto const& line : quantity.mean_limits) require_line(set, line);
    if (lot.required) fuzz::require(*lot.required >= 1 && *lot.required <= 28, "a sample is part of its lot");
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
