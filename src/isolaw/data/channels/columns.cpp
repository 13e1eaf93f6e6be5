#include "isolaw/data/channels/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/unit_text.hpp"

namespace isolaw::data {
namespace {

class Resolver {
 public:
  Resolver(std::string where, Header const& header, std::size_t count, ReadOptions const& options, Wanted wanted)
      : file_(std::move(where)), header_(header), count_(count), options_(options), wanted_(wanted) {}

  Columns run() {
    if (header_.mismatch) complain_about_mismatch();
    for (auto const channel : all_channels)
      if (wanted_.has(channel)) take_option(channel);
    for (auto const channel : all_channels)
      if (wanted_.has(channel) && !asked_for(channel) && channel != Channel::second_disp) recognise(channel);
    join_date();
    look_for_second_direction();
    refuse_shared_columns();
    for (auto& [channel, column] : result_.channels) resolve_unit(channel, column);
    std::erase_if(result_.channels, [](auto const& entry) {
      return entry.first == Channel::load && !entry.second.unit;  // resolve_unit() has reported the missing unit
    });
    say_given_units();
    say_unused();
    return std::move(result_);
  }

 private:
  std::string_view meaning_text(Channel channel) const {
    return wanted_.vertical && channel == Channel::disp ? "vertical displacement" : quantity(channel);
  }
  bool both_wanted() const { return wanted_.disp && wanted_.force; }
  bool has_names() const { return !header_.names.empty(); }
  bool asked_for(Channel channel) const { return options_.columns.contains(channel); }

  std::string header_place() const {
    return header_.name_line ? fmt::format("{}:{}", file_, *header_.name_line + 1) : file_;
  }
  std::string label(std::size_t index) const {
    return header_.lettered ? column_letters(index) : std::to_string(index + 1);
  }

  std::string columns_found() const {
    if (!header_.listing.empty()) return header_.listing;
    if (!has_names()) return counted(count_, "column") + " without names";
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count_; ++i)
      texts.push_back(fmt::format("{} {}", label(i), in_quotes(header_.names[i])));
    return "columns " + shortened(std::move(texts), 30);
  }

  void complain(std::string place, std::string found, std::string allowed, std::string advice) {
    result_.complaints.push_back({std::move(place), std::move(found), std::move(allowed), std::move(advice)});
  }

  void complain_about_mismatch() {
    auto const& [line, names, commas] = *header_.mismatch;
    complain(fmt::format("{}:{}", file_, line + 1),
             fmt::format("{} names, but the rows have {} columns{}", names, count_,
                         commas ? ": commas seem to be both delimiter and decimal separator" : ""),
             "one name per column",
             commas ? "export with semicolons or tabs between the columns" : "give every column one name");
  }

  void take_option(Channel channel) {
    auto const wanted = options_.columns.find(channel);
    if (wanted == options_.columns.end()) return;
    bool const optional_channel = channel == Channel::time || channel == Channel::cycle ||
                                  channel == Channel::second_disp || (channel == Channel::load && !wanted_.vertical);
    if (optional_channel && lower(wanted->second) == "none" && !find_named(wanted->second)) {
      result_.recognised.push_back(decision(
          FindingKind::column_taken,
          fmt::format("{}: not read, as asked for (--columns {}=none)", name(channel), name(channel)), "--columns"));
      return;
    }
    if (auto const index = find_column(channel, wanted->second)) {
      result_.channels[channel].index = *index;
      why_[channel] = "as asked for";
      if (channel == Channel::time) take_stamps(result_.channels[channel]);
    }
  }

  StampKind stamps_of(std::size_t index) const {
    return index < header_.stamps.size() ? header_.stamps[index] : StampKind::none;
  }
  bool holds_stamps(std::size_t index) const {
    auto const kind = stamps_of(index);
    return kind == StampKind::date_time || kind == StampKind::clock;
  }

  // Sets the kind of time stamps in a time column. Plain numbers count as a spreadsheet's dates, in days, only if they
  // have no unit and the column's name means a date: in a column "Time" they may be seconds.
  void take_stamps(Column& time) {
    auto const kind = stamps_of(time.index);
    bool const has_unit = options_.units.contains(Channel::time) || !written_units(Channel::time, time.index).empty();
    if (kind == StampKind::date_time || kind == StampKind::clock ||
        (kind == StampKind::serial_number && !has_unit && names_a_calendar(time.index)))
      time.stamp = kind;
  }
  void join_date() {
    auto const time = result_.channels.find(Channel::time);
    if (time == result_.channels.end() || time->second.stamp != StampKind::clock) return;
    std::vector<std::size_t> dates;
    for (std::size_t i = 0; i < count_; ++i)
      if (stamps_of(i) == StampKind::date) dates.push_back(i);
    if (dates.size() == 1) time->second.date_column = dates.front();
  }

  // Takes the column whose name means time, or else the only one that holds time stamps.
  void recognise_time() {
    auto found = candidates_of_any(Channel::time);
    // If several columns are named like a time and only one of them holds plain numbers, that column is the time.
    if (found.size() > 1) {
      auto numbers = found;
      std::erase_if(numbers, [&](auto i) { return stamps_of(i) != StampKind::none; });
      if (numbers.size() == 1) found = numbers;
    }
    if (found.size() > 1) {
      report_ambiguity(Channel::time, found);
      return;
    }
    std::string why = "by its name";
    if (found.empty()) {
      for (std::size_t i = 0; i < count_; ++i)
        if (!is_taken(i) && (holds_stamps(i) || (stamps_of(i) == StampKind::serial_number && names_a_calendar(i))))
          found.push_back(i);
      why = "by its values";
    }
    if (found.size() > 1) {
      std::vector<std::string> texts;
      for (auto const index : found) texts.push_back(column_text(index, header_));
      complain(header_place(), fmt::format("{} each hold times of day", shortened(std::move(texts), 10)),
               "one column for time", options_for(Channel::time, found));
      return;
    }
    if (found.empty()) return report_objects();
    auto& time = result_.channels[Channel::time];
    time.index = found.front();
    why_[Channel::time] = why;
    take_stamps(time);
  }

  // Complains of a time variable that only MATLAB can read, such as a datetime. Without a complaint the record would be
  // read without time, and nobody would notice.
  void report_objects() {
    if (options_.dt_s) return;
    for (auto const& variable : header_.objects)
      if (meaning_of(variable).channel == Channel::time || data::names_a_calendar(variable))
        complain(
            header_place(), fmt::format("{} holds dates or times, but no numbers", in_quotes(variable)),
            "seconds, or days of datenum",
            fmt::format(
                "save seconds({0} - {0}(1)), or datenum({0}) under that name; --columns time=none, or --dt SECONDS",
                printable(variable)));
  }

  bool names_a_calendar(std::size_t index) const {
    return index < header_.names.size() && data::names_a_calendar(header_.names[index]);
  }

  // Notes units that only --units gives, because a reader of the results cannot find them in the file.
  void say_given_units() {
    std::vector<std::string> given;
    for (auto const& [channel, column] : result_.channels)
      if (options_.units.contains(channel) && column.unit && column.stamp == StampKind::none &&
          stated_unit(column.index) != column.unit->symbol)
        given.push_back(fmt::format("{}={}", name(channel), column.unit->symbol));
    if (!given.empty())
      result_.recognised.push_back(decision(FindingKind::units_given,
                                            fmt::format("units given with the file (--units {})", joined(given, ",")),
                                            "--units"));
  }

  void say_unused() {
    std::vector<std::string> texts;
    bool const timed = result_.channels.contains(Channel::time);
    for (std::size_t i = 0; i < count_; ++i) {
      bool const date = timed && result_.channels.at(Channel::time).date_column == i;
      // A column that counts samples is left out here, because recognise_columns() reports it.
      bool const counter = !timed && i < header_.names.size() && is_counter(header_.names[i]);
      if (is_taken(i) || date || counter) continue;
      texts.push_back(column_text(i, header_));
      if (!wanted_.force && !wanted_.part && i < header_.names.size() && names_a_velocity(header_.names[i]))
        warn(FindingKind::velocity_unused, {{"column", column_text(i, header_)}});
    }
    constexpr std::size_t shown = 10;
    if (!texts.empty())
      result_.recognised.push_back(
          decision(FindingKind::columns_unused, "not used: " + shortened(std::move(texts), shown)));
  }

  void warn(FindingKind kind, std::vector<FindingWord> words) {
    result_.warnings.push_back({.kind = kind, .words = std::move(words)});
  }

  template <class Matches>
  std::vector<std::size_t> columns_where(Matches matches) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < header_.names.size(); ++i)
      if (matches(header_.names[i])) found.push_back(i);
    return found;
  }

  std::optional<std::size_t> lettered(std::string_view wanted) const {
    auto const index = header_.lettered ? letters_column(trimmed(wanted)) : std::nullopt;
    return index && *index < count_ ? index : std::nullopt;
  }

  std::optional<std::vector<std::size_t>> find_named(std::string_view wanted) const {
    auto const small = lower(trimmed(wanted));
    auto const base = lower(dissect_name(wanted).base);
    auto found = columns_where([&](auto const& text) { return text == wanted; });
    // In a workbook "F" means column F, even beside a column named "F [kN]", unless a column is named exactly "F".
    if (auto const letter = found.empty() ? lettered(wanted) : std::nullopt) return std::vector{*letter};
    if (found.empty()) found = columns_where([&](auto const& text) { return lower(text) == small; });
    if (found.empty()) found = columns_where([&](auto const& text) { return lower(dissect_name(text).base) == small; });
    if (found.empty()) found = columns_where([&](auto const& text) { return lower(dissect_name(text).base) == base; });
    if (found.empty()) return std::nullopt;
    return found;
  }

  std::optional<std::size_t> find_column(Channel channel, std::string const& wanted) {
    if (auto const named = find_named(wanted)) {
      if (named->size() == 1) return named->front();
      complain(header_place(), fmt::format("{} columns are named {}", named->size(), in_quotes(wanted)),
               "a unique column", options_for(channel, *named));
      return std::nullopt;
    }
    auto const number = number_in<std::size_t>(wanted);
    if (number && *number >= 1 && *number <= count_) return *number - 1;
    if (std::ranges::find(header_.complex, wanted) != header_.complex.end()) return report_complex(wanted);
    complain(header_place(), fmt::format("no column {} for {}", number ? wanted : in_quotes(wanted), name(channel)),
             number ? fmt::format("1 to {}; {}", count_, columns_found()) : columns_found(),
             fmt::format("--columns {}={}", name(channel), any_column()));
    return std::nullopt;
  }

  std::nullopt_t report_complex(std::string_view variable) {
    complain(header_place(), fmt::format("variable {} is complex", in_quotes(variable)),
             "real numbers; " + columns_found(),
             fmt::format("save real({}), or the part that was measured", printable(variable)));
    return std::nullopt;
  }

  std::string_view any_column() const { return header_.by_name ? "NAME" : header_.lettered ? "LETTER" : "NUMBER"; }

  std::string options_for(Channel channel, std::vector<std::size_t> const& candidates) const {
    std::vector<std::string> texts;
    constexpr std::size_t shown = 10;
    for (auto const index : std::span(candidates).first(std::min(candidates.size(), shown)))
      texts.push_back(fmt::format("--columns {}={}", name(channel), option_key(index, header_)));
    return joined(texts, " or ");
  }

  bool is_taken(std::size_t index) const {
    return std::ranges::any_of(result_.channels, [&](auto const& entry) { return entry.second.index == index; });
  }

  std::vector<std::size_t> candidates(Channel channel, Certainty certainty) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < header_.names.size(); ++i) {
      if (is_taken(i)) continue;
      auto const meaning = meaning_of(header_.names[i]);
      bool const unsure = meaning.plain_load && !result_.channels.contains(Channel::force);
      if (meaning.channel == channel && meaning.certainty == certainty && !unsure) found.push_back(i);
    }
    return found;
  }

  // Finds the column of a channel by the names of the columns and stores it in result_, or else reports why there is
  // none. In a shear test, a missing cycle column or vertical load is not reported, because both are optional.
  void recognise(Channel channel) {
    if (channel == Channel::time) return recognise_time();
    auto found = wanted_.vertical ? compression_candidates(channel) : candidates_of_any(channel);
    if (found.empty() && header_.own_axis && !wanted_.vertical) found = own_axis_candidates(channel);
    if (channel == Channel::disp && found.empty() && count_ == 1 && !wanted_.force) {
      result_.channels[channel].index = 0;
      why_[channel] = "the only column";
      return;
    }
    if (found.size() == 1) {
      result_.channels[channel].index = found.front();
      why_[channel] = "by its name";
    } else if (found.size() > 1 && channel != Channel::cycle) {
      report_ambiguity(channel, found);
    } else if (found.size() > 1) {
      std::vector<std::string> texts;
      for (auto const index : found) texts.push_back(column_text(index, header_));
      result_.recognised.push_back(
          decision(FindingKind::columns_unused,
                   fmt::format("{} may each number the cycles, so neither is read: {}, or --columns cycle=none",
                               shortened(std::move(texts), 10), options_for(channel, found))));
    } else if (channel != Channel::cycle && (channel != Channel::load || wanted_.vertical)) {
      report_missing(channel);
    }
  }

  void report_ambiguity(Channel channel, std::vector<std::size_t> const& found) {
    std::vector<std::string> texts;
    for (auto const index : found) texts.push_back(column_text(index, header_));
    if (channel == Channel::load && !wanted_.vertical) {
      warn(FindingKind::loads_ambiguous, {{"columns", shortened(std::move(texts), 10)},
                                          {"channel", std::string(meaning_text(channel))},
                                          {"options", options_for(channel, found)}});
      return;
    }
    complain(header_place(),
             fmt::format("{} may each be the {}", shortened(std::move(texts), 10), meaning_text(channel)),
             fmt::format("one column for {}", name(channel)), options_for(channel, found));
  }

  void report_missing(Channel channel) {
    for (auto const& variable : header_.complex)
      if (meaning_of(variable).channel == channel) {
        report_complex(variable);
        return;
      }
    if (!has_names()) {
      report_nameless(channel);
      return;
    }
    if (header_.by_name && !asked_for(Channel::disp) && !asked_for(Channel::force)) {
      report_variables(channel);
      return;
    }
    std::string found = fmt::format("no column is recognised as the {}", meaning_text(channel));
    auto const loads = columns_where([](auto const& text) { return meaning_of(text).plain_load; });
    if (channel == Channel::force && !loads.empty())
      found +=
          fmt::format(" ({} may be the horizontal force or the vertical load)", column_text(loads.front(), header_));
    complain(header_place(), std::move(found), columns_found(),
             fmt::format("--columns {}={}", name(channel),
                         loads.empty() ? any_column() : option_key(loads.front(), header_)));
  }

  void report_variables(Channel channel) {
    bool const no_disp = !result_.channels.contains(Channel::disp) && candidates_of_any(Channel::disp).empty();
    bool const both = both_wanted() && no_disp && candidates_of_any(Channel::force).empty();
    if (both && channel == Channel::force) return;  // the complaint about displacement also names force
    complain(header_place(),
             fmt::format("no variable is recognised as the {}{}", meaning_text(channel),
                         both ? fmt::format(", none as the {}", quantity(Channel::force)) : ""),
             columns_found(),
             both
                 ? "--columns time=NAME,disp=NAME,force=NAME --units time=s,disp=mm,force=kN, with your names and units"
                 : fmt::format("--columns {}=NAME", name(channel)));
  }

  // Takes a column named by a symbol only if none is named by a word: beside "Force", a column "F" is something else.
  std::vector<std::size_t> candidates_of_any(Channel channel) const {
    auto found = candidates(channel, Certainty::word);
    return found.empty() ? candidates(channel, Certainty::symbol) : found;
  }

  // Some machines name their channels after their own axis, as in "Axial Force". Takes such a column if no column has
  // the name of a horizontal channel: the machine's only actuator must then be the one that shears the device.
  std::vector<std::size_t> own_axis_candidates(Channel channel) {
    if (channel != Channel::disp && channel != Channel::force) return {};
    auto found = columns_where([&](auto const& text) {
      auto const meaning = meaning_of(text);
      return channel == Channel::disp ? meaning.vertical_disp
                                      : meaning.channel == Channel::load && meaning.certainty == Certainty::word;
    });
    std::erase_if(found, [&](auto index) { return is_taken(index); });
    if (found.size() == 1)
      warn(FindingKind::axis_taken_for_channel,
           {{"column", column_text(found.front(), header_)}, {"channel", std::string(meaning_text(channel))}});
    return found;
  }

  // In a compression test, prefers columns named "vertical". A rig that also shears has columns for two directions. A
  // press has one direction only, so its names need not say which.
  std::vector<std::size_t> compression_candidates(Channel channel) const {
    auto const find = [&](auto matches) {
      auto found = columns_where([&](auto const& text) { return matches(meaning_of(text)); });
      std::erase_if(found, [&](auto index) { return is_taken(index); });
      return found;
    };
    auto const is = [](Meaning const& m, Channel c, Certainty certainty) {
      return m.channel == c && m.certainty == certainty;
    };
    std::vector<std::size_t> found;
    if (channel == Channel::disp) {
      found = find([](Meaning const& m) { return m.vertical_disp; });
      if (found.empty()) found = find([&](Meaning const& m) { return is(m, Channel::disp, Certainty::word); });
      if (found.empty()) found = find([&](Meaning const& m) { return is(m, Channel::disp, Certainty::symbol); });
      return found;
    }
    found = find([&](Meaning const& m) { return is(m, Channel::load, Certainty::word) && !m.plain_load; });
    for (auto const certainty : {Certainty::word, Certainty::symbol})
      if (found.empty())
        found =
            find([&](Meaning const& m) { return is(m, Channel::load, certainty) || is(m, Channel::force, certainty); });
    return found;
  }

  // Complains that the columns have no names: without names, displacement cannot be distinguished from force, nor time
  // from a counter.
  void report_nameless(Channel channel) {
    bool const both = both_wanted() && !asked_for(Channel::disp) && !asked_for(Channel::force);
    if (both && channel == Channel::force) return;  // the complaint about displacement also names force
    auto const what = both ? std::string("displacement and which the force") : std::string(meaning_text(channel));
    complain(
        file_,
        fmt::format("no {} names the {} columns, so isolaw cannot know which is the {}", header_.row, count_, what),
        header_.lettered ? fmt::format("columns A to {}", label(count_ - 1))
                         : fmt::format("column numbers 1 to {}", count_),
        !both         ? fmt::format("--columns {}={}", name(channel), any_column())
        : count_ >= 3 ? "--columns time=1,disp=2,force=3 --units time=s,disp=mm,force=kN, with your numbers and units"
                      : "--columns disp=1,force=2 --units disp=mm,force=kN, with your numbers and units");
  }

  // Looks for a second horizontal direction: columns whose names differ from those of displacement and force only by y
  // in place of x, or x in place of y. The user must then choose the direction with an option, because nobody would
  // notice which direction isolaw had taken.
  void look_for_second_direction() {
    auto const disp = result_.channels.find(Channel::disp), force = result_.channels.find(Channel::force);
    if (!has_names() || disp == result_.channels.end() || force == result_.channels.end()) return;
    auto const other_disp = along_other_axis(disp->second.index), other_force = along_other_axis(force->second.index);
    if (!other_disp || !other_force) return;
    auto const text = [&](std::size_t one, std::size_t other) {
      return fmt::format("{} and {}", column_text(one, header_), column_text(other, header_));
    };
    auto const option = [&](std::size_t of_disp, std::size_t of_force, std::size_t across) {
      return fmt::format("disp={},force={},second-disp={}", option_key(of_disp, header_), option_key(of_force, header_),
                         option_key(across, header_));
    };
    if (asked_for(Channel::disp) || asked_for(Channel::force)) {
      warn(FindingKind::direction_unread, {{"columns", text(*other_disp, *other_force)}});
      if (!result_.channels.contains(Channel::second_disp))
        result_.warnings.back().words.push_back(
            {"option", option(disp->second.index, force->second.index, *other_disp)});
      return;
    }
    complain(header_place(),
             fmt::format("{} are one horizontal direction, {} another", text(disp->second.index, force->second.index),
                         text(*other_disp, *other_force)),
             "one direction",
             fmt::format("--columns {}, or {}", option(disp->second.index, force->second.index, *other_disp),
                         option(*other_disp, *other_force, disp->second.index)));
  }

  std::optional<std::size_t> along_other_axis(std::size_t index) const {
    auto words = name_words(dissect_name(header_.names[index]).base);
    bool turned = false;
    for (auto& word : words)
      if (char& last = word.back(); word.size() <= 2 && (last == 'x' || last == 'y')) {
        last = last == 'x' ? 'y' : 'x';
        turned = true;
      }
    if (!turned) return std::nullopt;
    auto const found = columns_where([&](auto const& text) { return name_words(dissect_name(text).base) == words; });
    return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
  }

  void refuse_shared_columns() {
    for (auto const& [channel, column] : result_.channels)
      for (auto const& [other, other_column] : result_.channels)
        if (channel < other && column.index == other_column.index)
          complain(header_place(),
                   fmt::format("{} is asked for as {} and as {}", column_text(column.index, header_), name(channel),
                               name(other)),
                   "one column per channel",
                   fmt::format("--columns {}={},{}={}", name(channel), any_column(), name(other), any_column()));
  }

  struct WrittenUnit {
    std::string text;
    std::string source;
    std::string place;
  };

  std::string_view stated_unit(std::size_t index) const {
    auto const written = units_in_file(index);
    auto const unit = written.empty() ? std::nullopt : parse_unit_text(written.front().text);
    return unit ? unit->unit.symbol : std::string_view{};
  }

  // A unit that the user gives for the displacement holds for the second direction too.
  std::vector<WrittenUnit> written_units(Channel channel, std::size_t index) const {
    if (auto const given = options_.units.find(channel); given != options_.units.end())
      return {{given->second, "as asked for", "--units " + std::string(name(channel))}};
    return channel == Channel::second_disp && options_.units.contains(Channel::disp)
               ? written_units(Channel::disp, index)
               : units_in_file(index);
  }

  std::vector<WrittenUnit> units_in_file(std::size_t index) const {
    std::vector<WrittenUnit> written;
    if (has_names()) {
      auto const unit = dissect_name(header_.names[index]).unit;
      if (!unit.empty()) written.push_back({unit, "from its name", header_place()});
    }
    if (header_.units.empty() || trimmed(header_.units[index]).empty()) return written;
    if (header_.unit_line)
      written.push_back({header_.units[index], fmt::format("from {} {}", header_.row, *header_.unit_line + 1),
                         fmt::format("{}:{}", file_, *header_.unit_line + 1)});
    else
      written.push_back({header_.units[index], "as the file states beside it", file_});
    return written;
  }

  static std::string unit_text(Unit const& unit, double scale) {
    return scale == 1.0 ? std::string(unit.symbol) : fmt::format("{:.6g} {}", scale, unit.symbol);
  }

  // Returns the unit of this dimension that the file states without naming a column, as in a list of units. Returns an
  // empty text if the file states no such unit or several.
  std::string unit_elsewhere(Dimension dimension) const {
    std::string found;
    for (auto const& text : header_.units_elsewhere) {
      auto const unit = parse_unit(text);
      if (!unit || unit->dimension != dimension || found == unit->symbol) continue;
      if (!found.empty()) return {};
      found = unit->symbol;
    }
    return found;
  }

  // Warns if the options give another unit or scale than the file. The column is read as the options say.
  void warn_of_other_unit(Channel channel, Column const& column) {
    auto const written = units_in_file(column.index);
    auto const stated = written.empty() ? std::nullopt : parse_unit_text(written.front().text);
    if (!stated || !stated->is_certain || (!options_.units.contains(channel) && !options_.scales.contains(channel)))
      return;
    auto const told = unit_text(stated->unit, stated->factor), used = unit_text(*column.unit, column.scale);
    if (told != used)
      warn(FindingKind::unit_overridden,
           {{"column", column_text(column.index, header_)},
            {"stated", told},
            {"used", used},
            {"option", options_.units.contains(channel) ? "--units" : "--channel-scale"}});
  }

  void resolve_unit(Channel channel, Column& column) {
    auto const text = column_text(column.index, header_);
    bool const takes_no_scale = column.stamp != StampKind::none || channel == Channel::cycle;
    if (takes_no_scale && options_.scales.contains(channel))
      complain(fmt::format("--channel-scale {}", name(channel)),
               fmt::format("a factor, but {} holds {}", text,
                           channel == Channel::cycle ? "numbers of cycles" : "time stamps"),
               "a column with a unit", "leave it out");
    if (column.stamp != StampKind::none) {
      if (auto const given = options_.units.find(channel); given != options_.units.end() && given->second != s.symbol)
        complain(fmt::format("--units {}", name(channel)),
                 fmt::format("{}, but {} holds time stamps", given->second, text), "s, or no unit", "leave it out");
      column.unit = s;
      auto const date =
          column.date_column ? fmt::format(" with the dates of {}", column_text(*column.date_column, header_)) : "";
      return take(channel, column,
                  fmt::format("{}: {}{}, {}; {}, read in s", name(channel), text, date, why_.at(channel),
                              column.stamp == StampKind::serial_number ? "days of a spreadsheet" : "time stamps"),
                  s.symbol);
    }
    if (channel == Channel::cycle) {
      column.unit = counts;
      return take(channel, column, fmt::format("{}: {}, {}", name(channel), text, why_.at(channel)), {});
    }
    auto const allowed = known_units(dimension(channel));
    auto const key = name(channel);
    auto const first_unit = allowed.substr(0, allowed.find(','));
    auto const elsewhere = unit_elsewhere(dimension(channel));
    auto const unit_advice =
        elsewhere.empty() ? fmt::format("--units {}={}, with the column's unit", key, first_unit)
                          : fmt::format("--units {}={}, which the file states in a list of units", key, elsewhere);
    auto const scale_advice =
        fmt::format("--units {0}={1} --channel-scale {0}=FACTOR, if a value of 1 is FACTOR {1}", key, first_unit);
    auto const scale = options_.scales.find(
        channel == Channel::second_disp && !options_.scales.contains(channel) ? Channel::disp : channel);
    bool const is_scaled = scale != options_.scales.end();
    auto written = written_units(channel, column.index);
    bool const may_be_left =
        channel == Channel::load && !wanted_.vertical && !asked_for(channel) && !options_.units.contains(channel);
    auto const refuse = [&](std::string place, std::string found, std::string const& allows,
                            std::string const& advice) {
      if (may_be_left)
        warn(FindingKind::load_unit_unclear, {{"reason", std::move(found)}, {"options", advice}});
      else
        complain(std::move(place), std::move(found), allows, advice);
    };
    // In a name, a number before the unit, as in "Force [10 kN]", may be a factor or a sensor's range. If a row of
    // plain units follows, the unit in the name is ignored.
    auto const is_plain = [](WrittenUnit const& unit) { return parse_unit(unit.text).has_value(); };
    if (written.size() > 1 && is_plain(written[1])) {
      auto const by_name = parse_unit_text(written[0].text);
      if (by_name && !by_name->is_certain) written.erase(written.begin());
    }
    if (written.empty())
      return refuse(header_place(), fmt::format("{} ({}) has no unit", text, key), allowed, unit_advice);
    auto const& first = written.front();
    auto unit = parse_unit_text(first.text);
    if (!unit && has_names()) unit = sensitivity_in(header_.names[column.index], first.text);
    if (!unit)
      return refuse(first.place, fmt::format("unknown unit {} of {} ({})", in_quotes(first.text), text, key), allowed,
                    scale_advice);
    if (unit->unit.dimension != dimension(channel))
      return refuse(first.place,
                    fmt::format("unit {} of {} is a {}, not a {}", unit->unit.symbol, text,
                                isolaw::name(unit->unit.dimension), isolaw::name(dimension(channel))),
                    allowed, unit_advice);
    if (written.size() > 1) {
      auto const second = parse_unit_text(written[1].text);
      if (second && unit_text(second->unit, second->factor) != unit_text(unit->unit, unit->factor))
        return refuse(written[1].place,
                      fmt::format("{} is in {} by its name and in {} by the row of units", text,
                                  unit_text(unit->unit, unit->factor), unit_text(second->unit, second->factor)),
                      allowed, unit_advice);
    }
    auto const stated = units_in_file(column.index);
    if (!is_scaled && options_.units.contains(channel) && !stated.empty() && is_other_quantity(stated.front().text))
      return refuse(first.place,
                    fmt::format("{}, but the unit of {} is {}, which is no {}", first.text, text,
                                in_quotes(stated.front().text), isolaw::name(dimension(channel))),
                    "a factor from that unit", scale_advice);
    auto const factor_advice = fmt::format(
        "--units {0}={1} --channel-scale {0}=FACTOR, if a value of 1 is FACTOR {1}; "
        "--channel-scale {0}=1, if it is 1 {1}",
        key, unit->unit.symbol);
    if (!is_scaled && !unit->is_certain)
      return refuse(
          first.place,
          fmt::format("{} of {} may be a factor of its values or the range of a sensor", in_quotes(first.text), text),
          "a unit without a number", factor_advice);
    auto const base = has_names() ? dissect_name(header_.names[column.index]).base : std::string();
    auto const other = options_.units.contains(channel) ? std::string() : other_unit_in(base, unit->unit);
    if (!other.empty())
      return refuse(first.place, fmt::format("{} states two units, {} and {}", text, other, unit->unit.symbol), allowed,
                    unit_advice);
    bool const is_factor_stated = channel == Channel::force && options_.corrections.force_factor;
    auto const hint =
        channel != Channel::time && !is_factor_stated ? scale_hint(base, dimension(channel)) : std::string();
    if (!is_scaled && !hint.empty())
      return refuse(header_place(),
                    fmt::format("{} in the name of {} leaves open whether its values are the {} of one device",
                                in_quotes(hint), text, quantity(channel)),
                    "a stated factor", factor_advice);
    column.unit = unit->unit;
    column.scale = is_scaled ? number_in<double>(scale->second).value_or(1.0) : unit->factor;
    warn_of_other_unit(channel, column);
    auto const factor = column.scale == 1.0 ? std::string()
                                            : fmt::format(", each value times {:.6g}{}", column.scale,
                                                          is_scaled ? " as asked for (--channel-scale)" : "");
    take(channel, column,
         fmt::format("{}: {}, {}; unit {} {}{}", key, text, why_.at(channel), unit->unit.symbol, first.source, factor),
         stated_unit(column.index));
  }

  // Notes the column that was taken for a channel. `stated` is the unit that the file states for the column, or empty.
  void take(Channel channel, Column const& column, std::string text, std::string_view stated) {
    auto taken = decision(FindingKind::column_taken, std::move(text));
    taken.words.push_back({"channel", std::string(name(channel))});
    taken.words.push_back({"column_by", column_by(channel, column.index)});
    taken.words.push_back({"stated_unit", std::string(stated)});
    result_.recognised.push_back(std::move(taken));
  }

  // Says what in the file shows that a column holds this channel: its name, its values, or nothing but an option. A
  // column that an option names is judged in the same way, because the options in a lot file may be guesses that `init`
  // wrote there.
  std::string column_by(Channel channel, std::size_t index) const {
    if (index < header_.names.size()) {
      auto const meaning = meaning_of(header_.names[index]);
      auto const same = [&](auto const& text) {
        return meaning_of(text).channel == channel && meaning_of(text).certainty == meaning.certainty;
      };
      if (meaning.channel == channel)
        return columns_where(same).size() > 1 ? "choice" : meaning.certainty == Certainty::word ? "name" : "symbol";
      if (channel != Channel::time && header_.own_axis) return "axis";
    }
    return channel == Channel::time && holds_stamps(index) ? "values" : "option";
  }

  std::string file_;
  Header const& header_;
  std::size_t count_;
  ReadOptions const& options_;
  Wanted wanted_;
  std::map<Channel, std::string> why_;
  Columns result_;
};

}  // namespace

Columns recognise_columns(std::string const& where, Header const& header, std::size_t count, ReadOptions const& options,
                          Wanted wanted) {
  auto columns = Resolver(where, header, count, options, wanted).run();
  if (!columns.channels.contains(Channel::time))
    for (std::size_t i = 0; i < header.names.size(); ++i)
      if (is_counter(header.names[i]))
        columns.recognised.push_back(
            decision(FindingKind::columns_unused, column_text(i, header) + " counts samples, it is no time"));
  for (auto& complaint : columns.complaints) complaint.names = header.names;
  return columns;
}

}  // namespace isolaw::data
