#include "isolaw/data/reading.hpp"

#include <fmt/format.h>

namespace isolaw::data {
namespace {

// "disp=2,force=F", or {"disp": 2, "force": "F"}.
template <class Parse, class Member>
Reading by_channel(std::string_view key, std::string help, Parse parse, Member member) {
  auto const write = [member](ReadOptions const& from) {
    Json made;
    for (auto const& [channel, value] : member(from)) made[std::string(name(channel))] = value;
    return made;
  };
  auto const read = [parse, member, key](ReadOptions& to, Json const& value) {
    if (value.is_string()) {
      for (auto& [channel, text] : parse(value.get<std::string>())) member(to)[channel] = text;
      return;
    }
    if (!value.is_object()) refuse(value, "a table, or text: disp=...,force=...");
    for (auto const& [channel, item] : value.items()) {
      if (!item.is_string() && !item.is_number_integer())
        throw Error({.where = {},
                     .found = fmt::format("{}: {} is neither text nor a number", channel, shown(item)),
                     .allowed = "a name or a 1-based number"});
      // A column's name may hold a comma, which the command line's form could not carry.
      auto const text = text_of(item);
      bool const comma = text.find(',') != std::string::npos;
      for (auto& [known, parsed] : parse(fmt::format("{}={}", channel, comma ? "1" : text)))
        member(to)[known] = comma ? text : parsed;
    }
  };
  return {text<ReadOptions>(key, Kind::assignments, std::move(help), write, read)};
}

// A name, or a number without quotes. `written`: as which of them a lot file has it.
template <class Member, class Parse>
Reading name_or_number(std::string_view key, std::string help, Kind written, Member member, Parse parse) {
  auto const write = [member, written](ReadOptions const& from) {
    return member(from) ? value_of(written, {*member(from)}) : Json();
  };
  auto const read = [member, parse](ReadOptions& to, Json const& value) {
    if (!value.is_string() && !value.is_number_integer()) refuse(value, "a name or a whole number");
    member(to) = parse(text_of(value));
  };
  return {text<ReadOptions>(key, Kind::text, std::move(help), write, read)};
}

template <class Member>
Reading correction(std::string_view key, std::string help, Member member, std::string_view keyword = {}) {
  auto made = number<ReadOptions>(key, std::move(help), member);
  made.keyword = keyword;
  return {std::move(made), true};
}

Reading skew() {
  auto made = correction(
      "skew-ms", "correct: the force comes later than displacement by this",
      [](auto& r) -> auto& { return r.corrections.skew_s; });
  made.get = [](ReadOptions const& from) {
    return from.corrections.skew_s ? Json(*from.corrections.skew_s / 1e-3) : Json();
  };
  made.set = [](ReadOptions& to, Json const& value) { to.corrections.skew_s = real_of(value, {}) / 1000.0; };
  return made;
}

std::vector<Reading> make_table() {
  return {
      by_channel(
          "columns", "time=...,disp=...,force=...,load=...: column names or 1-based numbers", parse_columns,
          [](auto& r) -> auto& { return r.columns; }),
      by_channel(
          "units", "disp=cm,force=tonf,time=s: units the files do not state", parse_units,
          [](auto& r) -> auto& { return r.units; }),
      {number<ReadOptions>(
          "dt", "sampling interval in seconds of files without a time column",
          [](auto& r) -> auto& { return r.dt_s; })},
      name_or_number(
          "sheet", "sheet of a workbook, struct of a .mat file, key of JSON: name or number", Kind::text,
          [](auto& r) -> auto& { return r.sheet; }, [](std::string const& name) { return name; }),
      name_or_number(
          "test", "of files that hold several tests: a number, or all, one after the other", Kind::whole,
          [](auto& r) -> auto& { return r.test; }, parse_test),
      {flag<ReadOptions>(
           "flip-force", "reverse the sign of the force", [](auto& r) -> auto& { return r.flip_force; }),
       true},
      skew(),
      correction(
          "rig-friction", "correct: friction of the rig in the force, kN",
          [](auto& r) -> auto& { return r.corrections.friction_kN; }, "rig_friction_kN"),
      correction(
          "rig-friction-coefficient", "correct: the same as a share of the vertical load",
          [](auto& r) -> auto& { return r.corrections.friction_coefficient; }),
      correction(
          "moving-mass", "correct: mass between device and load cell, kg",
          [](auto& r) -> auto& { return r.corrections.moving_mass_kg; }, "moving_mass_kg"),
      correction(
          "force-factor", "correct: 0.5 where the rig shears two devices",
          [](auto& r) -> auto& { return r.corrections.force_factor; }),
  };
}

}  // namespace

std::span<Reading const> reading_table() {
  static std::vector<Reading> const table = make_table();
  return table;
}

}  // namespace isolaw::data
