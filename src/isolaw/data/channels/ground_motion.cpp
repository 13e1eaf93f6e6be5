#include "isolaw/data/channels/ground_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/header.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

using LineList = std::vector<std::string_view>;

constexpr std::size_t fewest_accelerations = 10;
constexpr std::string_view columns_allowed =
    "a file of PEER (AT2), ESM, K-NET, CESMD (CSMIP volume 2) or USGS (SMC), or columns of text with a header that names their units: 'time [s], acceleration [m/s2]'";

// The number after a word, such as 0.005 after "dt" in "DT= .0050 SEC".
std::optional<double> number_behind(std::string_view line, std::string_view word) {
  auto const at = lower(line).find(word);
  if (at == std::string::npos) return std::nullopt;
  line.remove_prefix(at + word.size());
  auto const first = line.find_first_not_of(" \t=:");
  if (first == std::string_view::npos) return std::nullopt;
  line.remove_prefix(first);
  return number_in<double>(line.substr(0, line.find_first_of(" \t,;")));
}

// Facts that the head of an agency's file (PEER, ESM, ...) states about the acceleration values below it.
struct Agency {
  std::string_view format;
  std::size_t first = 0;             // index of the first line after the head
  std::optional<std::size_t> count;  // number of values; nullopt if the head does not state it
  bool more_follows = false;         // velocity and displacement may follow the values
  double step_s = 0.0;
  std::optional<double> unit_mm_s2;
  std::size_t width = 0;  // width of a value in characters; 0 if blanks separate the values
  bool off_zero = false;  // the values are uncorrected: their mean is the instrument's zero, not an acceleration
  std::string_view unit_stated = {};  // for messages: the text in the head that would state the unit
};

std::optional<std::size_t> count_of(std::optional<double> number) {
  if (!number || !(*number >= 1.0) || !(*number <= static_cast<double>(most_lines))) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

// PEER: the head has a line such as "NPTS=  4000, DT= .01000 SEC" or "4000 .01000 NPTS, DT", and "IN UNITS OF G" above
// it.
std::optional<Agency> peer_header(LineList const& lines) {
  constexpr std::size_t head = 10;
  Agency header{.format = "PEER AT2", .count = {}, .unit_mm_s2 = {}, .unit_stated = "a line with 'IN UNITS OF G'"};
  for (std::size_t i = 0; i < std::min(head, lines.size()); ++i) {
    auto const small = lower(lines[i]);
    constexpr std::string_view before_unit = "units of ";
    if (auto const at = small.find(before_unit); at != std::string::npos) {
      auto const text = std::string_view(small).substr(at + before_unit.size());
      header.unit_mm_s2 = parse_acceleration(text.substr(0, text.find_first_of(" .,;")));
    }
    if (small.find("npts") == std::string::npos || small.find("dt") == std::string::npos) continue;
    auto count = number_behind(small, "npts"), step = number_behind(small, "dt");
    if (!count || !step) {
      std::vector<std::string_view> cells;
      split_cells(lines[i], ' ', cells);
      if (cells.size() < 2) continue;
      count = number_in<double>(cells[0]);
      step = number_in<double>(cells[1]);
    }
    header.count = count_of(count);
    if (!header.count || !step || !(*step > 0.0)) continue;
    header.first = i + 1;
    header.step_s = *step;
    return header;
  }
  return std::nullopt;
}

// The text after `key`, in the first line of the head that starts with this key.
std::optional<std::string_view> value_of(LineList const& lines, std::string_view key) {
  constexpr std::size_t head = 100;
  for (std::size_t i = 0; i < std::min(head, lines.size()); ++i)
    if (lines[i].starts_with(key)) return trimmed(lines[i].substr(key.size()));
  return std::nullopt;
}
std::optional<double> number_of(LineList const& lines, std::string_view key) {
  auto const text = value_of(lines, key);
  return text ? number_in<double>(text->substr(0, text->find_first_not_of("+-.0123456789eE"))) : std::nullopt;
}
std::size_t line_after(LineList const& lines, std::string_view key) {
  std::size_t i = 0;
  while (i < lines.size() && !lines[i].starts_with(key)) ++i;
  return i + 1;
}

// ESM and DYNA (INGV): the head has lines "KEY: VALUE", the last of them USER5.
std::optional<Agency> esm_header(LineList const& lines) {
  auto const step = number_of(lines, "SAMPLING_INTERVAL_S:");
  auto const unit = value_of(lines, "UNITS:");
  if (!step || !(*step > 0.0) || !value_of(lines, "DATA_TYPE:")) return std::nullopt;
  return Agency{.format = "ESM",
                .first = line_after(lines, "USER5:"),
                .count = count_of(number_of(lines, "NDATA:")),
                .step_s = *step,
                .unit_mm_s2 = unit ? parse_acceleration(*unit) : std::nullopt,
                .unit_stated = "a line 'UNITS: cm/s^2'"};
}

// K-NET and KiK-net (NIED): the values are counts of the instrument. The head has a line such as "Scale Factor
// 3920(gal)/6182761", which gives the size of a count, and ends with the key "Memo."
std::optional<Agency> knet_header(LineList const& lines) {
  auto const rate = number_of(lines, "Sampling Freq(Hz)");
  auto const scale = value_of(lines, "Scale Factor");
  if (!rate || !(*rate > 0.0) || !scale) return std::nullopt;
  auto const bracket = scale->find('('), slash = scale->find('/');
  Agency header{.format = "K-NET",
                .first = line_after(lines, "Memo."),
                .count = {},
                .step_s = 1.0 / *rate,
                .unit_mm_s2 = {},
                .off_zero = true,
                .unit_stated = "a line 'Scale Factor 3920(gal)/6182761'"};
  if (bracket == std::string_view::npos || slash == std::string_view::npos || slash < bracket) return header;
  auto const above = number_in<double>(scale->substr(0, bracket)), below = number_in<double>(scale->substr(slash + 1));
  auto const unit = parse_acceleration(scale->substr(bracket, slash - bracket));
  if (above && below && *below > 0.0 && unit) header.unit_mm_s2 = *above / *below * *unit;
  return header;
}

// CSMIP volume 2 (CESMD): above each component stands a line such as "4000 points of accel data equally spaced at .020
// sec, in cm/sec2. (8f10.3)", or with "(units: cm/sec/sec)" at its end. A file may hold several components.
std::vector<Agency> csmip_headers(LineList const& lines) {
  std::vector<Agency> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    constexpr std::string_view spaced = "points of accel data equally spaced at";
    if (lines[i].size() > 200 || lines[i].find_first_of("pP") == std::string_view::npos) continue;
    auto const small = lower(lines[i]);
    auto const points = small.find(spaced);
    if (points == std::string::npos) continue;
    auto const step = number_behind(small, spaced);
    auto const count = count_of(number_in<double>(trimmed(std::string_view(small).substr(0, points))));
    if (!step || !(*step > 0.0) || !count) continue;
    auto unit = std::string_view(small).substr(points + spaced.size());
    for (std::string_view const before : {"units:", " in "})
      if (auto const at = unit.find(before); at != std::string_view::npos)
        unit = trimmed(unit.substr(at + before.size()));
    found.push_back({.format = "CSMIP volume 2",
                     .first = i + 1,
                     .count = count,
                     .more_follows = true,
                     .step_s = *step,
                     .unit_mm_s2 = parse_acceleration(unit.substr(0, unit.find_first_of(" .,;()"))),
                     .width = 10,
                     .unit_stated = "'in cm/sec2' behind the step"});
  }
  return found;
}

// SMC (USGS). The head begins with 11 lines of text, the first of which says whether the values are corrected. 48 whole
// numbers follow in 6 lines: the 16th is the number of comment lines, the 17th the number of values. 50 real numbers
// follow in 10 lines: the second is the rate in Hz. The comment lines end the head. Accelerations are in cm/s2.
std::optional<Agency> smc_header(LineList const& lines) {
  constexpr std::size_t text = 11, whole = 6, real = 10, width_of_whole = 10, width_of_real = 15;
  if (lines.size() <= text + whole + real) return std::nullopt;
  auto const kind = trimmed(lines[0]);
  bool const as_recorded = kind == "1 UNCORRECTED ACCELEROGRAM";
  if (!as_recorded && kind != "2 CORRECTED ACCELEROGRAM") return std::nullopt;
  auto const number = [&](std::size_t first, std::size_t in_a_line, std::size_t width, std::size_t which) {
    auto const line = lines[first + which / in_a_line];
    auto const at = which % in_a_line * width;
    return at < line.size() ? number_in<double>(trimmed(line.substr(at, width))) : std::nullopt;
  };
  auto const comments = number(text, 8, width_of_whole, 15);
  auto const count = count_of(number(text, 8, width_of_whole, 16));
  auto const rate = number(text + whole, 5, width_of_real, 1);
  if (!comments || !(*comments >= 0.0 && *comments < 1e4) || !count || !rate || !(*rate > 0.0)) return std::nullopt;
  return Agency{.format = "SMC",
                .first = text + whole + real + static_cast<std::size_t>(*comments),
                .count = count,
                .step_s = 1.0 / *rate,
                .unit_mm_s2 = 10.0,
                .width = 10,
                .off_zero = as_recorded};
}

// Reads the head with the format of each agency in turn; nullopt if none fits. `component` counts from 1. The user
// writes it at the end of the file's name, as in FILE#2.
std::optional<Agency> agency_header(LineList const& lines, std::string const& name,
                                    std::optional<std::size_t> component) {
  std::vector<Agency> found;
  for (auto const header : {peer_header, esm_header, knet_header, smc_header})
    if (auto one = header(lines)) found.push_back(*one);
  if (found.empty()) found = csmip_headers(lines);
  if (found.size() > 1 && !component)
    throw Error({.where = name,
                 .found = fmt::format("{} components of acceleration", found.size()),
                 .allowed = "one component",
                 .advice = fmt::format("the number of a component behind the name, such as {}#1", name)});
  if (component && (*component == 0 || *component > found.size()))
    throw Error({.where = fmt::format("{}#{}", name, *component),
                 .found = fmt::format("{} of an agency's file", counted(found.size(), "component")),
                 .allowed = "the number of one of them"});
  if (!found.empty()) return found[component.value_or(1) - 1];
  auto const title = lower(lines.empty() ? "" : lines.front().substr(0, 100));
  bool const as_recorded = title.find("uncorrected accelerogram data") != std::string::npos;
  if (as_recorded || title.starts_with("corrected acceleration    (format v01.20"))
    throw Error({.where = name,
                 .found = as_recorded ? "an uncorrected accelerogram (volume 1), whose samples are not equally spaced"
                                      : "a file in the format of COSMOS (V2c), which isolaw does not read",
                 .allowed = std::string(columns_allowed),
                 .advice = as_recorded ? "the corrected accelerogram (volume 2) of the same record"
                                       : "the same record in one of these formats"});
  return std::nullopt;
}

std::string not_numbers(std::size_t bad, std::string_view first) {
  return bad == 1 ? fmt::format("{} is no number", in_quotes(first))
                  : fmt::format("{} values that are no numbers, the first of them {}", bad, in_quotes(first));
}

// Cuts a line into values of `width` characters each, or at blanks if `width` is 0.
void cut(std::string_view line, std::size_t width, std::vector<std::string_view>& cells) {
  if (width == 0) return split_cells(line, ' ', cells);
  cells.clear();
  for (std::size_t at = 0; at < line.size(); at += width) cells.push_back(trimmed(line.substr(at, width)));
}

// Text for messages: the options or keys by which the user can state the step, the unit or both, for example
// "--motion-dt SECONDS and --motion-unit UNIT".
std::string to_state(StatedMotion const& stated, bool step, bool unit) {
  if (stated.how_step.empty()) return {};
  return fmt::format("{}{}{}{}", step ? stated.how_step : "", step && unit ? " and " : "", unit ? stated.how_unit : "",
                     stated.where);
}

// The unit that the user states, in mm/s2. Complains if the file states another one.
std::optional<double> stated_unit(StatedMotion const& stated, std::optional<double> of_file_mm_s2,
                                  std::string const& name, std::vector<Complaint>& complaints) {
  if (!stated.unit) return std::nullopt;
  auto const unit_mm_s2 = parse_acceleration(*stated.unit);
  if (!unit_mm_s2)
    complaints.push_back(
        {.where = name, .found = "the unit " + in_quotes(*stated.unit), .allowed = std::string(known_accelerations)});
  else if (of_file_mm_s2 && *of_file_mm_s2 != *unit_mm_s2)
    complaints.push_back(
        {.where = name,
         .found = "the file states the unit of its acceleration, and it is not the stated " + in_quotes(*stated.unit),
         .allowed = "the unit of the file, or none for a file that states one"});
  return unit_mm_s2;
}

GroundMotion read_agency(LineList const& lines, Agency header, std::string const& name, StatedMotion const& stated) {
  GroundMotion motion{.file = name, .step_s = header.step_s, .acceleration_mm_s2 = {}, .recognised = {}};
  auto& values = motion.acceleration_mm_s2;
  std::vector<Complaint> complaints;
  auto const unit_mm_s2 = stated_unit(stated, header.unit_mm_s2, name, complaints);
  if (!header.unit_mm_s2) header.unit_mm_s2 = unit_mm_s2;
  if (!header.unit_mm_s2)
    complaints.push_back({.where = name,
                          .found = "no unit of the acceleration above its values",
                          .allowed = fmt::format("{} ({})", header.unit_stated, known_accelerations),
                          .advice = to_state(stated, false, true)});
  std::size_t bad = 0, bad_line = 0;
  std::string first_bad;
  std::vector<std::string_view> cells;
  auto const all_there = [&] { return header.more_follows && values.size() + bad >= header.count; };
  for (auto i = header.first; i < lines.size() && !all_there(); ++i) {
    cut(lines[i], header.width, cells);
    for (auto const cell : cells) {
      if (cell.empty() || all_there()) continue;
      auto const value = number_in<double>(cell);
      if (value && std::isfinite(*value)) {
        values.push_back(*value * header.unit_mm_s2.value_or(1.0));
        continue;
      }
      if (bad++ == 0) {
        bad_line = i + 1;
        first_bad = cell;
      }
    }
  }
  if (bad > 0)
    complaints.push_back({.where = fmt::format("{}:{}", name, bad_line),
                          .found = not_numbers(bad, first_bad),
                          .allowed = "finite numbers"});
  else if (header.count && values.size() != *header.count)
    complaints.push_back({.where = name,
                          .found = counted(values.size(), "value"),
                          .allowed = fmt::format("{} values, as the head of the file says", *header.count),
                          .advice = "the file as it was downloaded: it may have been cut short"});
  if (!complaints.empty()) throw Error(std::move(complaints));
  motion.recognised = fmt::format("{}, {} samples every {:.6g} s", header.format, values.size(), header.step_s);
  if (header.off_zero && !values.empty()) {
    double const mean = num::moments(values).mean;
    for (double& value : values) value -= mean;
    motion.zero_mm_s2 = mean;
    motion.recognised += fmt::format(", less their mean of {:.3g} cm/s2, which is the instrument's zero", mean / 10.0);
  }
  return motion;
}

struct MotionColumns {
  std::optional<std::size_t> time, acceleration;
  double time_s = 1.0, unit_mm_s2 = 1.0;  // the sizes of the file's units, in s and in mm/s2
};

// Finds the columns of time and acceleration, and their units. `first_is_time` says that the first of two columns
// without a header is time.
MotionColumns motion_columns(Header const& header, std::size_t count, bool first_is_time, std::string const& name,
                             StatedMotion const& stated) {
  MotionColumns columns;
  std::vector<Complaint> complaints;
  std::vector<std::string> accelerations;
  std::vector<std::size_t> others;
  std::optional<double> of_file_mm_s2;
  auto names = header.names;
  if (first_is_time) names = {"time [s]", ""};
  names.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto const unit =
        i < header.units.size() && !header.units[i].empty() ? header.units[i] : dissect_name(names[i]).unit;
    if (auto const in_mm_s2 = parse_acceleration(unit)) {
      columns.acceleration = i;
      columns.unit_mm_s2 = *in_mm_s2;
      of_file_mm_s2 = in_mm_s2;
      accelerations.push_back(in_quotes(names[i]));
    } else if (!columns.time && meaning_of(names[i]).channel == Channel::time) {
      columns.time = i;
      auto const time = parse_unit(unit);
      if (time && time->dimension == Dimension::time)
        columns.time_s = time->in_record_units;
      else if (!stated.step_s)
        complaints.push_back({.where = name,
                              .found = fmt::format("column {} has no unit of time", in_quotes(names[i])),
                              .allowed = known_units(Dimension::time),
                              .advice = to_state(stated, true, false)});
    } else {
      others.push_back(i);
    }
  }
  auto const unit_mm_s2 = stated_unit(stated, of_file_mm_s2, name, complaints);
  if (accelerations.empty() && unit_mm_s2 && others.size() == 1) {
    columns.acceleration = others.front();
    columns.unit_mm_s2 = *unit_mm_s2;
  } else if (accelerations.empty()) {
    complaints.push_back(
        {.where = name,
         .found = unit_mm_s2 ? fmt::format("{} that may be the acceleration", counted(others.size(), "column"))
                             : std::string("no column with a unit of acceleration"),
         .allowed = std::string(columns_allowed) + "; " + std::string(known_accelerations),
         .advice = unit_mm_s2 ? "" : to_state(stated, !columns.time && !stated.step_s, true)});
  } else if (accelerations.size() > 1) {
    complaints.push_back({.where = name,
                          .found = "several columns of acceleration: " + joined(accelerations),
                          .allowed = "one component in a file",
                          .advice = "a file for each component"});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return columns;
}

// Returns a text that says between which two samples the step first differs clearly from the usual one (the median). If
// it differs nowhere, the text names the step that ends at the sample with index `otherwise`.
std::string unequal_step(std::vector<double> const& time_s, std::size_t otherwise) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time_s.size(); ++i) steps.push_back(time_s[i] - time_s[i - 1]);
  double const usual = num::median(steps);
  constexpr double off = 0.2;  // twice the tolerance of equally_spaced(), because a step is the difference of two times
  auto const found = std::ranges::find_if(steps, [&](double s) { return std::abs(s - usual) > off * std::abs(usual); });
  auto const i = found == steps.end() ? otherwise : static_cast<std::size_t>(found - steps.begin()) + 1;
  return fmt::format(
      "the times are not equally spaced: sample {} is at {:.6g} s and sample {} at {:.6g} s, "
      "and most are {:.4g} s apart",
      i, time_s[i - 1], i + 1, time_s[i], usual);
}

// Compares the times with equal steps from the first time on. Returns the index of the first time that is off, or
// time_s.size() if none is. A time may be slightly off, because a file may round it, for example to three decimals.
std::size_t equally_spaced(std::vector<double> const& time_s, double step) {
  constexpr double allowed = 0.1;  // a time may be off by this fraction of a step
  for (std::size_t i = 0; i < time_s.size(); ++i)
    if (!(step > 0.0 && std::abs(time_s[i] - time_s.front() - static_cast<double>(i) * step) <= allowed * step))
      return i;
  return time_s.size();
}
double mean_step(std::vector<double> const& time_s) {
  return (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
}

double step_of(std::vector<double> const& time_s, std::string const& name) {
  double const step = mean_step(time_s);
  auto const equal = equally_spaced(time_s, step);
  if (equal == time_s.size()) return step;
  throw Error({.where = name,
               .found = step > 0.0 ? unequal_step(time_s, std::max<std::size_t>(equal, 1))
                                   : std::string("the time does not increase"),
               .allowed = "equal steps",
               .advice = "the motion interpolated to equal steps"});
}

// Whether the first column of a file without a header holds equally spaced times.
bool begins_with_time(LineList const& lines, std::size_t first_data, Dialect const& dialect) {
  std::vector<double> values;
  std::vector<std::string_view> cells;
  for (auto i = first_data; i < lines.size(); ++i) {
    if (is_comment(lines[i]) || is_blank(lines[i], dialect.delimiter)) continue;
    split_row(lines[i], dialect, cells);
    auto const cell = parse_cell(cells.empty() ? std::string_view() : cells.front(), dialect.format());
    if (cell.kind != CellKind::number) return false;
    values.push_back(cell.value);
  }
  return values.size() >= fewest_accelerations && equally_spaced(values, mean_step(values)) == values.size();
}

GroundMotion read_columns(LineList const& lines, std::string const& name, StatedMotion const& stated) {
  auto dialect = recognise_dialect(lines);
  if (!dialect) dialect = one_column_dialect(lines);
  if (!dialect) throw Error({.where = name, .found = "no rows of numbers", .allowed = std::string(columns_allowed)});
  auto const header = recognise_header(lines, *dialect);
  bool const first_is_time = header.names.empty() && dialect->columns == 2 &&
                             (stated.step_s || begins_with_time(lines, header.first_data, *dialect));
  auto const columns = motion_columns(header, dialect->columns, first_is_time, name, stated);
  GroundMotion motion{.file = name, .step_s = 0.0, .acceleration_mm_s2 = {}, .recognised = {}};
  std::vector<double> time_s;
  std::vector<std::string_view> cells;
  std::size_t bad = 0, bad_line = 0;
  std::string first_bad;
  for (auto i = header.first_data; i < lines.size(); ++i) {
    if (is_comment(lines[i]) || is_blank(lines[i], dialect->delimiter)) continue;
    split_row(lines[i], *dialect, cells);
    auto const number = [&](std::size_t column) -> std::optional<double> {
      auto const text = column < cells.size() ? cells[column] : std::string_view();
      auto const cell = parse_cell(text, dialect->format());
      if (cell.kind == CellKind::number && std::isfinite(cell.value)) return cell.value;
      if (bad++ == 0) {
        bad_line = i + 1;
        first_bad = text;
      }
      return std::nullopt;
    };
    if (columns.time)
      if (auto const t = number(*columns.time)) time_s.push_back(*t * columns.time_s);
    if (auto const a = number(*columns.acceleration)) motion.acceleration_mm_s2.push_back(*a * columns.unit_mm_s2);
  }
  if (bad > 0)
    throw Error({.where = fmt::format("{}:{}", name, bad_line),
                 .found = not_numbers(bad, first_bad),
                 .allowed = "finite numbers"});
  if (motion.acceleration_mm_s2.size() >= 2 && columns.time) motion.step_s = step_of(time_s, name);
  if (!columns.time && !stated.step_s)
    throw Error({.where = name,
                 .found = "no column of time",
                 .allowed = "a column such as 'time [s]'",
                 .advice = to_state(stated, true, false)});
  if (!columns.time) motion.step_s = *stated.step_s;
  auto const at = *columns.acceleration;
  motion.recognised = fmt::format(
      "column {}, {} samples every {:.6g} s",
      at < header.names.size() ? in_quotes(header.names[at]) : fmt::format("{} in {}", at + 1, *stated.unit),
      motion.acceleration_mm_s2.size(), motion.step_s);
  return motion;
}

// Calls read(). If an error lists the file formats of test records, replaces that list by the formats of ground
// motions.
template <class Read>
auto as_motion(Read const& read) {
  try {
    return read();
  } catch (Error const& error) {
    auto complaints = error.complaints();
    for (auto& complaint : complaints)
      if (complaint.allowed == accepted_formats) complaint.allowed = columns_allowed;
    throw Error(std::move(complaints));
  }
}

std::string text_of(std::filesystem::path const& file) {
  return as_motion([&] { return load_text(file); });
}

}  // namespace

std::optional<double> parse_acceleration(std::string_view unit) {
  std::string text;
  for (char const c : unit)
    if (std::string_view(" \t[](){}").find(c) == std::string_view::npos) text += c;
  auto const small = lower(text);
  if (small == "g") return gravity_mm_s2;
  if (small == "gal") return 10.0;
  auto const slash = small.find('/');
  if (slash == std::string::npos) return std::nullopt;
  auto const length = parse_unit(std::string_view(text).substr(0, slash));
  auto const time = std::string_view(small).substr(slash + 1);
  constexpr std::string_view squares[]{"s2", "s^2", "s**2", "s/s", "sec2", "sec^2", "sec**2", "sec/sec", "s\xC2\xB2"};
  if (!length || length->dimension != Dimension::length || std::ranges::find(squares, time) == std::end(squares))
    return std::nullopt;
  return length->in_record_units;
}

GroundMotion read_ground_motion(std::filesystem::path const& file, StatedMotion const& stated) {
  auto const name = file.generic_string();
  std::error_code unknown;
  if (auto const mark = name.rfind('#'); mark != std::string::npos && !std::filesystem::exists(file, unknown))
    if (auto const component = number_in<std::size_t>(std::string_view(name).substr(mark + 1))) {
      auto const whole = name.substr(0, mark);
      return read_ground_motion_text(text_of(whole), whole, stated, *component);
    }
  return read_ground_motion_text(text_of(file), name, stated);
}

GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name, StatedMotion const& stated,
                                     std::optional<std::size_t> component) {
  as_motion([&] { return check_text(name, bytes), true; });
  auto const lines = split_lines(bytes).lines;
  auto const agency = agency_header(lines, name, component);
  auto motion = agency ? read_agency(lines, *agency, name, stated) : read_columns(lines, name, stated);
  if (stated.step_s && !(std::abs(*stated.step_s - motion.step_s) <= 1e-3 * motion.step_s))
    throw Error(
        {.where = name,
         .found = fmt::format("samples every {:.6g} s, and a step of {} s is stated", motion.step_s, *stated.step_s),
         .allowed = "the step of the file, or none for a file that states one"});
  if (motion.acceleration_mm_s2.size() < fewest_accelerations)
    throw Error({.where = name,
                 .found = counted(motion.acceleration_mm_s2.size(), "sample"),
                 .allowed = fmt::format("{} or more", fewest_accelerations)});
  if (std::ranges::all_of(motion.acceleration_mm_s2, [](double a) { return a == 0.0; }))
    throw Error({.where = name, .found = "an acceleration of zero throughout", .allowed = "a motion of the ground"});
  return motion;
}

}  // namespace isolaw::data
