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
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

using LineList = std::vector<std::string_view>;

constexpr std::size_t fewest_accelerations = 10;
constexpr std::string_view columns_allowed =
    "an AT2 file of the PEER database, or columns of text with a header that names their units: 'time [s], acceleration [m/s2]'";

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

struct PeerHeader {
  std::size_t line = 0;  // the line that holds count and step, from 0
  std::size_t count = 0;
  double step_s = 0.0;
  std::optional<double> unit_mm_s2;
};

// Finds a line such as "NPTS=  4000, DT= .01000 SEC" or "4000 .01000 NPTS, DT", and "IN UNITS OF G" above it.
std::optional<PeerHeader> peer_header(LineList const& lines) {
  constexpr std::size_t head = 10;
  PeerHeader header;
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
    if (!count || !step || !(*count >= 1.0) || !(*count <= static_cast<double>(most_lines)) || !(*step > 0.0)) continue;
    header.line = i;
    header.count = static_cast<std::size_t>(*count);
    header.step_s = *step;
    return header;
  }
  return std::nullopt;
}

std::string not_numbers(std::size_t bad, std::string_view first) {
  return bad == 1 ? fmt::format("{} is no number", in_quotes(first))
                  : fmt::format("{} values that are no numbers, the first of them {}", bad, in_quotes(first));
}

GroundMotion read_peer(LineList const& lines, PeerHeader const& header, std::string const& name) {
  GroundMotion motion{.file = name, .step_s = header.step_s, .acceleration_mm_s2 = {}, .recognised = {}};
  std::vector<Complaint> complaints;
  if (!header.unit_mm_s2)
    complaints.push_back({.where = name,
                          .found = "no unit of the acceleration above its values",
                          .allowed = fmt::format("a line with 'IN UNITS OF G' ({})", known_accelerations)});
  std::size_t bad = 0, bad_line = 0;
  std::string first_bad;
  std::vector<std::string_view> cells;
  for (auto i = header.line + 1; i < lines.size(); ++i) {
    split_cells(lines[i], ' ', cells);
    for (auto const cell : cells) {
      if (cell.empty()) continue;
      auto const value = number_in<double>(cell);
      if (value && std::isfinite(*value)) {
        motion.acceleration_mm_s2.push_back(*value * header.unit_mm_s2.value_or(1.0));
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
  else if (motion.acceleration_mm_s2.size() != header.count)
    complaints.push_back({.where = name,
                          .found = counted(motion.acceleration_mm_s2.size(), "value"),
                          .allowed = fmt::format("NPTS = {}, as line {} says", header.count, header.line + 1),
                          .advice = "the file as it was downloaded: it may have been cut short"});
  if (!complaints.empty()) throw Error(std::move(complaints));
  motion.recognised = fmt::format("PEER AT2, {} samples every {} s", header.count, header.step_s);
  return motion;
}

struct MotionColumns {
  std::optional<std::size_t> time, acceleration;
  double time_s = 1.0, unit_mm_s2 = 1.0;  // the file's units, in s and in mm/s2
};

MotionColumns motion_columns(Header const& header, std::size_t count, std::string const& name) {
  MotionColumns columns;
  std::vector<Complaint> complaints;
  std::vector<std::string> accelerations;
  for (std::size_t i = 0; i < std::min(count, header.names.size()); ++i) {
    auto const unit =
        i < header.units.size() && !header.units[i].empty() ? header.units[i] : dissect_name(header.names[i]).unit;
    if (auto const in_mm_s2 = parse_acceleration(unit)) {
      columns.acceleration = i;
      columns.unit_mm_s2 = *in_mm_s2;
      accelerations.push_back(in_quotes(header.names[i]));
    } else if (!columns.time && meaning_of(header.names[i]).channel == Channel::time) {
      columns.time = i;
      auto const time = parse_unit(unit);
      if (time && time->dimension == Dimension::time)
        columns.time_s = time->in_record_units;
      else
        complaints.push_back({.where = name,
                              .found = fmt::format("column {} has no unit of time", in_quotes(header.names[i])),
                              .allowed = known_units(Dimension::time)});
    }
  }
  if (accelerations.empty())
    complaints.push_back({.where = name,
                          .found = "no column with a unit of acceleration",
                          .allowed = std::string(columns_allowed) + "; " + std::string(known_accelerations)});
  if (accelerations.size() > 1)
    complaints.push_back({.where = name,
                          .found = "several columns of acceleration: " + joined(accelerations),
                          .allowed = "one component in a file",
                          .advice = "a file for each, the second as --ground-motion-y"});
  if (!complaints.empty()) throw Error(std::move(complaints));
  return columns;
}

// The step of equally spaced times. A file may round each time, for example to three decimals.
double step_of(std::vector<double> const& time_s, std::string const& name) {
  double const step = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
  constexpr double allowed = 0.1;  // a time may be off by this fraction of a step
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    double const expected = time_s.front() + static_cast<double>(i) * step;
    if (step > 0.0 && std::abs(time_s[i] - expected) <= allowed * step) continue;
    throw Error(
        {.where = name,
         .found =
             step > 0.0
                 ? fmt::format(
                       "the times are not equally spaced: sample {} is at {} s, {:.6g} s in equal steps of {:.4g} s",
                       i + 1, time_s[i], expected, step)
                 : std::string("the time does not increase"),
         .allowed = "equal steps",
         .advice = "the motion interpolated to equal steps"});
  }
  return step;
}

GroundMotion read_columns(LineList const& lines, std::string const& name, std::optional<double> step_s) {
  auto dialect = recognise_dialect(lines);
  if (!dialect) dialect = one_column_dialect(lines);
  if (!dialect) throw Error({.where = name, .found = "no rows of numbers", .allowed = std::string(columns_allowed)});
  auto const header = recognise_header(lines, *dialect);
  auto const columns = motion_columns(header, dialect->columns, name);
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
  if (!columns.time && !step_s)
    throw Error({.where = name,
                 .found = "no column of time",
                 .allowed = "a column such as 'time [s]'",
                 .advice = "--ground-motion-dt SECONDS, the step between two samples"});
  if (!columns.time) motion.step_s = *step_s;
  motion.recognised =
      fmt::format("column {}, {} samples every {:.6g} s", in_quotes(header.names[*columns.acceleration]),
                  motion.acceleration_mm_s2.size(), motion.step_s);
  return motion;
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

GroundMotion read_ground_motion(std::filesystem::path const& file, std::optional<double> step_s) {
  return read_ground_motion_text(load_text(file), file.generic_string(), step_s);
}

GroundMotion read_ground_motion_text(std::string_view bytes, std::string const& name, std::optional<double> step_s) {
  check_text(name, bytes);
  auto const lines = split_lines(bytes).lines;
  auto const peer = peer_header(lines);
  auto motion = peer ? read_peer(lines, *peer, name) : read_columns(lines, name, step_s);
  if (step_s && !(std::abs(*step_s - motion.step_s) <= 1e-3 * motion.step_s))
    throw Error({.where = "--ground-motion-dt",
                 .found = fmt::format("{} s, and {} has samples every {:.6g} s", *step_s, name, motion.step_s),
                 .allowed = "the step of the file, or none for a file that has one"});
  if (motion.acceleration_mm_s2.size() < fewest_accelerations)
    throw Error({.where = name,
                 .found = counted(motion.acceleration_mm_s2.size(), "sample"),
                 .allowed = fmt::format("{} or more", fewest_accelerations)});
  if (std::ranges::all_of(motion.acceleration_mm_s2, [](double a) { return a == 0.0; }))
    throw Error({.where = name, .found = "an acceleration of zero throughout", .allowed = "a motion of the ground"});
  return motion;
}

}  // namespace isolaw::data
