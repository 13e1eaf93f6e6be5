// A test record in record units (kN, mm, s): as measured, and as laws are fitted to it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/data/corrections.hpp"
#include "isolaw/data/signal_faults.hpp"

namespace isolaw::data {

enum class Channel { time, disp, force, load };

enum class DateOrder { day_first, month_first };

// Rows of numbers, counted from 1 below the header; blank lines and comments do not count.
struct RowRange {
  std::size_t first = 1;
  std::optional<std::size_t> last;  // nullopt: to the end
  bool operator==(RowRange const&) const = default;
};

// `option` is the option that asked for the decision ("--units"), or empty.
inline Finding decision(FindingKind kind, std::string text, std::string option = {}) {
  Finding finding{.kind = kind, .words = {{"text", std::move(text)}}};
  if (!option.empty()) finding.words.push_back({"option", std::move(option)});
  return finding;
}

// Whatever is not given is recognised from the file.
struct ReadOptions {
  std::map<Channel, std::string> columns;  // name or 1-based number; "none": not read
  std::map<Channel, std::string> units;    // "cm", "tonf", ...; what is missing is read from the header
  std::optional<double> dt_s;              // sampling interval of a file without a time column
  std::optional<DateOrder> date_order;     // for time stamps whose order is unclear
  std::optional<RowRange> rows;            // the part of the file that is read
  std::optional<double> from_s, to_s;      // the part of the time that is read
  bool skip_footer = false;                // text below the rows is left out (option --footer skip)
  std::optional<char> thousands;           // groups the digits of numbers: , . ' or a blank
  bool flip_force = false;                 // multiply the force by -1 (option --flip-force)
  std::optional<std::string> sheet;        // sheet of a workbook, struct of a .mat file, key of JSON: name or number
  std::optional<std::string> test;         // if the file holds several: 1-based number, or "all", one after the other
  Corrections corrections;                 // options --skew-ms and so on

  bool operator==(ReadOptions const&) const = default;
};

// Raw values, only converted to record units. Equal lengths; `time_s` and `load_kN` are empty where the file has none.
struct TestRecord {
  std::string file;    // as the user named it, relative to the lot file
  std::string sha256;  // hash of the file's bytes
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> force_kN;
  std::vector<double> load_kN;
  // All choices made in reading: with these options the file is read in the same manner again.
  ReadOptions layout;
  // Facts about the device as the file writes them, by their keys in a lot file.
  std::vector<std::pair<std::string, std::string>> particulars;
  std::vector<Finding> recognised;   // each decision, made with decision(), and why
  std::vector<Finding> corrections;  // each correction asked for, also in `recognised`
  std::vector<Finding> warnings;
  std::vector<SignalFault> faults;  // faults of the recorded signals, except repaired spikes; not stored

  bool has_time() const { return !time_s.empty(); }
  std::size_t size() const { return disp_mm.size(); }
};

// Without a time channel `time_s` counts the samples, `vel_mm_s` is empty and only rate-independent laws apply (the
// objective does not depend on the time scale when sampling is uniform).
struct FitRecord {
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> vel_mm_s;
  std::vector<double> force_kN;
  std::vector<double> scored = {};  // 1 if a sample is scored, 0 if a law only runs through it; empty: all are scored
  std::vector<double> block = {};   // number of each sample's block, if some blocks are predicted; else empty
  double dead_band_mm = 0.0;        // play with which laws that remember turning points follow displacement
  std::vector<Finding> cleaning;    // each step applied, with its numbers

  bool has_time() const { return !vel_mm_s.empty(); }
  bool is_scored(std::size_t i) const { return scored.empty() || scored[i] != 0.0; }
  std::size_t size() const { return disp_mm.size(); }
  double largest_scored(std::vector<double> const& values) const;
};

}  // namespace isolaw::data
