#include "isolaw/data/reading.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

#include "isolaw/base/words.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {
namespace {

// An option with a value for each channel: "disp=2,force=F" or {"disp": 2, "force": "F"}.
Reading by_channel(std::string_view key, std::string help, std::map<Channel, std::string> ReadOptions::*values,
                   std::map<Channel, std::string> (*parse)(std::string_view)) {
  bool const are_numbers = key == "channel-scale";
  auto const write = [values, are_numbers](ReadOptions const& from) {
    Json table;
    for (auto const& [channel, value] : from.*values)
      table[std::string(name(channel))] = are_numbers ? Json(number_in<double>(value).value_or(1.0)) : Json(value);
    return table;
  };
  auto const read = [key, parse, values, are_numbers](ReadOptions& to, Json const& value) {
    if (value.is_string()) {
      for (auto& [channel, text] : parse(value.get<std::string>())) (to.*values)[channel] = text;
      return;
    }
    if (!value.is_object()) refuse(value, "a table, or text: disp=...,force=...");
    for (auto const& [channel, item] : value.items()) {
      if (!item.is_string() && !(are_numbers ? item.is_number() : item.is_number_integer()))
        throw Error({.where = {},
                     .found = fmt::format("{}: {} is neither text nor a number", channel, shown(item)),
                     .allowed = are_numbers ? "a number" : "a name or a 1-based number"});
      auto const text = text_of(item);
      bool const comma = text.find(',') != std::string::npos;
      if (comma && key == "units")
        throw Error({.where = {},
                     .found = fmt::format("{}: '{}' is more than one unit", channel, text),
                     .allowed = "one unit for each channel",
                     .advice = "all units in one text: \"disp=mm,force=kN\""});
      // parse() splits text at commas, so it gets "1" instead of a column's name that contains a comma. The name itself
      // is stored afterwards.
      for (auto& [known, parsed] : parse(fmt::format("{}={}", channel, comma ? "1" : text)))
        (to.*values)[known] = comma ? text : parsed;
    }
  };
  return {
      {{.key = key, .kind = Kind::assignments, .help = std::move(help), .heading = Heading::everyday}, write, read}};
}

// `written` is the form in which lot files store the value: text or a number.
Reading name_or_number(std::string_view key, std::string help, Kind written,
                       std::optional<std::string> ReadOptions::*choice, std::string (*parse)(std::string const&)) {
  auto const write = [=](ReadOptions const& from) {
    return from.*choice ? value_of(written, {*(from.*choice)}) : Json();
  };
  auto const read = [=](ReadOptions& to, Json const& value) {
    if (!value.is_string() && !value.is_number_integer()) refuse(value, "a name or a whole number");
    to.*choice = parse(text_of(value));
  };
  return {{{.key = key, .help = std::move(help), .type = "str | int", .heading = Heading::reading}, write, read}};
}

Reading one_of(std::string_view key, std::string help, std::vector<std::string_view> words,
               std::optional<std::string_view> (*get)(ReadOptions const&),
               void (*set)(ReadOptions&, std::string_view)) {
  auto const write = [get](ReadOptions const& from) {
    auto const word = get(from);
    return word ? Json(*word) : Json();
  };
  auto const read = [words, set](ReadOptions& to, Json const& value) {
    for (auto const word : words)
      if (value == Json(word)) return set(to, word);
    std::vector<std::string> texts;
    for (auto const word : words) texts.push_back(fmt::format("'{}'", word));
    refuse(value, joined(texts, " or "));
  };
  return {{{.key = key, .help = std::move(help), .words = words, .heading = Heading::reading}, write, read}};
}

std::vector<std::string_view> group_words() {
  std::vector<std::string_view> words;
  for (auto const& group : digit_groups) words.push_back(group.word);
  return words;
}

Reading thousands() {
  return one_of(
      "thousands", "mark that groups digits, as in 12,345.6: the mark itself, which is , or . or ', or the word blank",
      group_words(),
      [](ReadOptions const& from) -> std::optional<std::string_view> {
        return from.thousands ? std::optional(digit_group(*from.thousands).word) : std::nullopt;
      },
      [](ReadOptions& to, std::string_view word) {
        to.thousands = std::ranges::find(digit_groups, word, &DigitGroup::word)->mark;
      });
}

Reading date_order() {
  return one_of(
      "date-order", "order of day and month in dates like 03/04/2024: dmy or mdy",
      {date_order_word(DateOrder::day_first), date_order_word(DateOrder::month_first)},
      [](ReadOptions const& from) -> std::optional<std::string_view> {
        return from.date_order ? std::optional(date_order_word(*from.date_order)) : std::nullopt;
      },
      [](ReadOptions& to, std::string_view word) {
        to.date_order = word == date_order_word(DateOrder::day_first) ? DateOrder::day_first : DateOrder::month_first;
      });
}

Reading footer() {
  return one_of(
      "footer", "the word skip: ignore text below the rows of numbers, such as statistics or a signature", {"skip"},
      [](ReadOptions const& from) -> std::optional<std::string_view> {
        return from.skip_footer ? std::optional<std::string_view>("skip") : std::nullopt;
      },
      [](ReadOptions& to, std::string_view) { to.skip_footer = true; });
}

Reading missing() {
  return one_of(
      "missing", "what to do with rows in which a channel has no value: leave-out or interpolate",
      {"leave-out", "interpolate"},
      [](ReadOptions const& from) -> std::optional<std::string_view> {
        if (from.missing == MissingValues::refused) return std::nullopt;
        return from.missing == MissingValues::left_out ? "leave-out" : "interpolate";
      },
      [](ReadOptions& to, std::string_view word) {
        to.missing = word == "leave-out" ? MissingValues::left_out : MissingValues::interpolated;
      });
}

Reading rows() {
  auto const write = [](ReadOptions const& from) { return from.rows ? Json(rows_text(*from.rows)) : Json(); };
  auto const read = [](ReadOptions& to, Json const& value) { to.rows = parse_rows(text_in(value)); };
  return {{{.key = "rows",
            .help = "read only rows A:B, such as 101:700, or 101: to the end; row 1 is the first below the header",
            .heading = Heading::reading},
           write,
           read}};
}

// In commands that read a motion, --from and --to are called --motion-from and --motion-to, because --from names a
// campaign there.
Reading time_limit(std::string_view key, std::string help, std::optional<double> ReadOptions::*value,
                   std::string_view keyword, std::string_view motion_option) {
  Reading row{number<ReadOptions>(key, std::move(help), at(value)).under(Heading::reading), false, motion_option};
  row.keyword = keyword;
  return row;
}

Reading correction(std::string_view key, std::string help, std::optional<double> Corrections::*value,
                   std::string_view keyword = {}) {
  Reading row{
      number<ReadOptions>(key, std::move(help), at(&ReadOptions::corrections, value)).under(Heading::corrections),
      true};
  row.keyword = keyword;
  return row;
}

Reading skew() {
  auto const place = at(&ReadOptions::corrections, &Corrections::skew_s);
  auto row = correction("skew-ms", "move the force earlier by this many milliseconds, if it lags the displacement",
                        &Corrections::skew_s);
  row.get = [place](ReadOptions const& from) { return place(from) ? Json(*place(from) / 1e-3) : Json(); };
  row.set = [place](ReadOptions& to, Json const& value) { place(to) = real_of(value, {}) / 1000.0; };
  return row;
}

constexpr std::string_view spikes_word = "spikes";

Reading repair() {
  auto row = one_of(
      "repair", "the word spikes: replace spikes of a single sample by interpolation", {spikes_word},
      [](ReadOptions const& from) -> std::optional<std::string_view> {
        return from.corrections.repair_spikes ? std::optional(spikes_word) : std::nullopt;
      },
      [](ReadOptions& to, std::string_view) { to.corrections.repair_spikes = true; });
  row.of_test = true;
  row.heading = Heading::corrections;
  return row;
}

std::vector<Reading> make_table() {
  using R = ReadOptions;
  using C = Corrections;
  return {
      by_channel(
          "columns",
          "column of each channel, by name or number: time=1,disp=Travel,force=3; FILE:COLUMN takes a column of another file",
          &R::columns, parse_columns),
      by_channel("units", "units that the files do not state: disp=cm,force=tonf,time=s", &R::units, parse_units),
      by_channel("channel-scale", "factor on the values of a channel: disp=0.01 if the file has hundredths of the unit",
                 &R::scales, parse_scales),
      {number<R>("dt", "sampling interval of files without a time column", at(&R::dt_s),
                 {.least = std::numeric_limits<double>::min(), .words = "a positive number of seconds"})
           .under(Heading::reading)},
      rows(),
      time_limit("from", "read only from this time on, in seconds of the file's own time", &R::from_s, "from_s",
                 "motion-from"),
      time_limit("to", "read only up to this time, in seconds of the file's own time", &R::to_s, "to_s", "motion-to"),
      footer(),
      missing(),
      thousands(),
      date_order(),
      name_or_number("sheet", "sheet of a workbook, struct of a .mat file or key of JSON, by name or number",
                     Kind::text, &R::sheet, [](std::string const& name) { return name; }),
      name_or_number(
          "test",
          "for a file that holds several tests: the number of the one to read, or all to join them one after another",
          Kind::whole, &R::test, [](std::string const& text) { return parse_test(text); }),
      {flag<R>("flip-force", "reverse the sign of the force", at(&R::flip_force)).under(Heading::reading), true},
      {flag<R>(
           "half-cycles",
           "count each swing (from one turning point to the next) that belongs to no full cycle as a half cycle, and take twice its energy",
           at(&R::half_cycles))
           .under(Heading::reading),
       true},
      repair(),
      skew(),
      correction("rig-friction", "subtract the friction force of the test rig, which has this size in kN",
                 &C::friction_kN, "rig_friction_kN"),
      correction("rig-friction-coefficient",
                 "subtract the friction force of the test rig, which is this share of the vertical load, such as 0.005",
                 &C::friction_coefficient),
      correction("moving-mass", "mass in kg that moves between device and load cell; its inertia force is subtracted",
                 &C::moving_mass_kg, "moving_mass_kg"),
      correction("force-factor", "multiply the force by this number, such as 0.5 if the rig shears two devices at once",
                 &C::force_factor),
  };
}

}  // namespace

std::span<Reading const> reading_table() {
  static std::vector<Reading> const table = make_table();
  return table;
}

}  // namespace isolaw::data
