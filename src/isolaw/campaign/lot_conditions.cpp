#include "isolaw/campaign/lot_conditions.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
// An oven hotter than the limit in `ovens` damages rubber instead of ageing it.
Limits const temperatures{.least = -100.0, .most = 200.0, .words = "degrees Celsius, -100 to 200"},
    ovens{.least = 0.0,
          .most = 100.0,
          .words = "degrees Celsius, 0 to 100: in a hotter oven rubber is damaged, not aged"},
    positive{.least = std::numeric_limits<double>::min(), .most = largest, .words = "above 0"},
    not_negative{.least = 0.0, .most = largest, .words = "0 or more"}, within_10{.least = 0.0, .most = 10.0},
    within_25{.least = 0.0, .most = 25.0};

std::vector<Option<StatedTest>> make_test_table() {
  using T = StatedTest;
  std::vector<Option<T>> table{
      number<T>("order", "place among all tests of the device", at(&T::order),
                {.least = 1, .most = 1'000'000, .words = "a whole number from 1"}),
      number<T>("temperature-C", "temperature of the rubber at the start", at(&T::temperature_C), temperatures),
      number<T>("load-kN", "mean vertical load, if the record has no channel for it", at(&T::load_kN), not_negative),
      number<T>("rest-h", "rest since the test before", at(&T::rest_h), not_negative),
      number<T>("conditioned-h", "time in a chamber at this temperature before the test", at(&T::conditioned_h),
                not_negative),
      number<T>("scale", "scale of the specimen, if it is a scaled one", at(&T::scale), positive),
      flag<T>("fit", "whether laws are fitted to this test too", at(&T::takes_part_in_fit))};
  constexpr std::pair<std::string_view, bool> specimens[]{{"full", false}, {"scaled", true}};
  table.push_back(
      word<T>("specimen", "whether the specimen is a device or a scaled one", at(&T::is_scaled), specimens));
  table.push_back({{.key = "started", .help = "when the test began"},
                   [](T const& test) { return test.started.empty() ? Json() : Json(test.started); },
                   [](T& test, Json const& value) {
                     if (!start_h(text_in(value))) refuse(value, "a date with a time of day: \"2026-03-01T09:00:00\"");
                     test.started = text_in(value);
                   }});
  constexpr std::pair<std::string_view, bool> stands_for[]{{"dependence", false}, {"acceptance", true}};
  table.push_back(
      word<T>("stands-for", "which record stands for the device elsewhere", at(&T::is_acceptance), stands_for));
  Option<T> place{{.key = "temperature-of", .help = "where the temperature was measured"}, {}, {}};
  place.words = {"core", "surface", "chamber"};
  place.get = [](T const& test) { return test.temperature_of.empty() ? Json() : Json(test.temperature_of); };
  place.set = [allowed = place.words](T& test, Json const& value) {
    auto const text = text_in(value);
    if (std::ranges::find(allowed, text) == allowed.end()) refuse(value, joined(allowed));
    test.temperature_of = text;
  };
  table.push_back(std::move(place));
  return table;
}

std::vector<Option<StatedAgeing>> make_aged_table() {
  auto const row = [](std::string_view key, std::string help, double StatedAgeing::*member,
                      Limits const& limits) -> Option<StatedAgeing> {
    return {{.key = key, .kind = Kind::real, .help = help_of(std::move(help), limits.text(), {}), .limits = limits},
            [=](StatedAgeing const& aged) { return Json(aged.*member); },
            [=](StatedAgeing& aged, Json const& value) { aged.*member = real_of(value, limits); }};
  };
  return {row("days", "days in an oven before the test, in total", &StatedAgeing::days, positive),
          row("at-C", "temperature of the oven", &StatedAgeing::at_C, ovens)};
}

std::vector<Option<StatedDevice>> make_device_table() {
  using D = StatedDevice;
  auto const text = [](std::string_view key, std::string help, std::string D::*member) -> Option<D> {
    return {{.key = key, .help = std::move(help)},
            [=](D const& device) { return (device.*member).empty() ? Json() : Json(device.*member); },
            [=](D& device, Json const& value) { device.*member = text_in(value); }};
  };
  return {text("compound", "rubber compound; devices are compared within one compound only", &D::compound),
          text("size", "size of the device; devices are compared within one size only", &D::size)};
}

// Reads the table [conditions] and the tables within it.
class ConditionsReader {
 public:
  ConditionsReader(toml::table const& table, std::string const& file, std::vector<Complaint>& complaints)
      : file_(file), complaints_(complaints), top_(table, file, "[conditions]", complaints) {}

  StatedConditions read() {
    StatedConditions all;
    inside("reference", true, [&](TomlTable& table) { reference(table, all); });
    inside("design", false, [&](TomlTable& table) { design(table, all); });
    inside("tolerance", false, [&](TomlTable& table) {
      auto& to = all.tolerance;
      take(table, "temperature-C", within_10, to.temperature_C);
      take(table, "frequency-percent", within_25, to.frequency_percent);
      take(table, "load-percent", within_25, to.load_percent);
      take(table, "strain-percent", within_25, to.strain_percent);
    });
    top_.value<std::string>("rules", "a built-in rule set", [&](std::string const& text) { all.rules = text; });
    for (auto const& option : compared_devices_table())
      top_.json(option.option(), [&](Json const& value) { option.set(all.compared, value); });
    top_.strings("assume", [&](std::string const& text) { all.assume.push_back(text); });
    take(top_, "activation-energy-kJ-mol", positive, all.activation_energy_kJ_per_mol);
    top_.value<std::string>("activation-energy-source", "text",
                            [&](std::string const& text) { all.activation_energy_source = text; });
    take(top_, "heat-capacity-MJ-m3K", positive, all.heat_capacity_MJ_per_m3K);
    if (all.activation_energy_kJ_per_mol.has_value() == all.activation_energy_source.empty())
      top_.complain("an activation energy without its source, or a source without the energy",
                    "activation-energy-kJ-mol and activation-energy-source = \"text\" together");
    top_.refuse_unknown();
    return all;
  }

 private:
  void inside(std::string_view key, bool required, auto const& read) {
    auto const* table = top_.table(key);
    if (table == nullptr) {
      if (required) top_.complain(fmt::format("no {}", key), "reference = { temperature-C = 20, frequency-Hz = 0.5 }");
      return;
    }
    TomlTable reader(*table, file_, fmt::format("{} in [conditions]", key), complaints_);
    read(reader);
    reader.refuse_unknown();
  }

  template <class To>
  static void take(TomlTable& table, std::string_view key, Limits const& limits, To& to) {
    table.value<double>(key, limits.text(), [&](double value) { to = real_of(value, limits); });
  }

  // Reads a range of values: a number, or a list of the two ends.
  void range(TomlTable& table, std::string_view key, Limits const& limits, std::optional<ConditionRange>& to) {
    auto const* node = table.find(key);
    if (node == nullptr) return;
    std::vector<double> ends;
    if (auto const* list = node->as_array(); list != nullptr) {
      for (auto const& item : *list) ends.push_back(item.value<double>().value_or(std::nan("")));
    } else if (auto const one = node->value<double>()) {
      ends = {*one, *one};
    }
    bool const is_allowed = std::ranges::all_of(ends, [&](double end) { return limits.allow(end); });
    if (ends.size() != 2 || ends[0] > ends[1] || !is_allowed) {
      std::ostringstream found;
      found << toml::toml_formatter(*node);
      return table.complain(
          *node,
          fmt::format("{} in design is {}, and that {}", key, printable(found.str()),
                      is_allowed ? "is no range from low to high" : "has a value that is not allowed"),
          fmt::format("[low, high], each {}", limits.text()));
    }
    to = {.low = ends[0], .high = ends[1]};
  }

  static void reference(TomlTable& table, StatedConditions& all) {
    auto& to = all.reference;
    if (table.find("temperature-C") == nullptr)
      table.complain("a reference without a temperature", "temperature-C = 20");
    take(table, "temperature-C", temperatures, to.temperature_C);
    take(table, "frequency-Hz", positive, to.frequency_Hz);
    take(table, "load-kN", positive, to.load_kN);
    take(table, "strain-percent", positive, to.strain_percent);
    take(table, "disp-mm", positive, to.disp_mm);
    if (to.strain_percent && to.disp_mm) table.complain("strain-percent and disp-mm", "one of them");
    table.json("cycle", [&](Json const& value) {
      auto const text = value.is_number() ? fmt::format("{}", value.get<double>()) : text_of(value);
      auto const dash = text.find('-');
      auto const whole = [](std::string_view digits, int& number) {
        auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        return error == std::errc() && end == digits.data() + digits.size();
      };
      bool const right = whole(text.substr(0, dash), to.first_cycle) &&
                         whole(dash == std::string::npos ? text : text.substr(dash + 1), to.last_cycle) &&
                         to.first_cycle >= 1 && to.first_cycle <= to.last_cycle;
      if (!right) refuse(value, "a number of a cycle from 1, or a range such as \"1-3\"");
    });
  }

  void design(TomlTable& table, StatedConditions& all) {
    auto& to = all.design;
    range(table, "temperature-C", temperatures, to.temperature_C);
    range(table, "frequency-Hz", positive, to.frequency_Hz);
    range(table, "load-kN", not_negative, to.load_kN);
    table.json("rest", [&](Json const& value) {
      if (value == Json("full"))
        to.full_rest = true;
      else if (value.is_number() && value.get<double>() > 0.0)
        to.rest_h = value.get<double>();
      else
        refuse(value, "\"full\", or hours above 0");
    });
    table.value<int>("cycles", "a whole number from 1",
                     [&](int value) { to.cycles = whole_of(value, {.least = 1, .most = 1000}); });
    if (auto const* cycles = table.find("cycles"); to.cycles && *to.cycles < all.reference.last_cycle)
      table.complain(
          *cycles,
          fmt::format("cycles is {}, and the last cycle of the reference is {}", *to.cycles, all.reference.last_cycle),
          fmt::format("a whole number from {}: the last cycle of the longest motion", all.reference.last_cycle),
          "rest = \"full\", which counts the stiffer first cycles, or an earlier reference cycle");
    to.aged = read_aged(table, file_, complaints_);
    take(table, "years", positive, to.years);
    take(table, "service-temperature-C", temperatures, to.service_temperature_C);
    if (to.years && to.aged) table.complain("aged and years", "one of them");
    if (to.years.has_value() != to.service_temperature_C.has_value())
      table.complain("years without a service temperature, or the reverse", "years and service-temperature-C together");
  }

  std::string const& file_;
  std::vector<Complaint>& complaints_;
  TomlTable top_;
};

}  // namespace

std::optional<StatedAgeing> read_aged(TomlTable& table, std::string const& file, std::vector<Complaint>& complaints) {
  auto const* inside = table.table("aged");
  if (inside == nullptr) return std::nullopt;
  StatedAgeing aged;
  TomlTable reader(*inside, file, "aged", complaints);
  bool is_whole = true;
  for (auto const& option : aged_table()) {
    reader.json(option.option(), [&](Json const& value) { option.set(aged, value); });
    is_whole = is_whole && reader.find(option.option()) != nullptr;
  }
  if (!is_whole) reader.complain("days or at-C is missing", "aged = { days = 14, at-C = 70 }");
  reader.refuse_unknown();
  return aged;
}

std::span<Option<StatedTest> const> test_table() {
  static auto const table = make_test_table();
  return table;
}

std::span<Option<StatedAgeing> const> aged_table() {
  static auto const table = make_aged_table();
  return table;
}

std::span<Option<StatedDevice> const> compared_devices_table() {
  static auto const table = make_device_table();
  return table;
}

std::optional<double> start_h(std::string_view started) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, read = 0;
  double second = 0.0;
  std::string const text(started);
  bool const has_seconds =
      std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%lf%n", &year, &month, &day, &hour, &minute, &second, &read) == 6;
  if (!has_seconds &&
      std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d%n", &year, &month, &day, &hour, &minute, &read) < 5)
    return std::nullopt;
  std::chrono::year_month_day const date(std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  bool const right = static_cast<std::size_t>(read) == text.size() && date.ok() && hour >= 0 && hour < 24 &&
                     minute >= 0 && minute < 60 && second >= 0.0 && second < 60.0;
  if (!right) return std::nullopt;
  auto const days = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
  return 24.0 * days + hour + minute / 60.0 + second / 3600.0;
}

StatedConditions read_conditions(toml::table const& table, std::string const& file,
                                 std::vector<Complaint>& complaints) {
  auto stated = ConditionsReader(table, file, complaints).read();
  std::ostringstream text;
  text << toml::toml_formatter(table);
  stated.text = text.str();
  return stated;
}

}  // namespace isolaw::campaign
