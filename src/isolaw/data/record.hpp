// A test record in kN, mm and s: as measured (TestRecord), and as laws are fitted to it (FitRecord).
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

// A range of rows of numbers, counted from 1 below the header without blank lines and comments.
struct RowRange {
  std::size_t first = 1;
  std::optional<std::size_t> last;  // nullopt: up to the last row
  bool operator==(RowRange const&) const = default;
};

// A finding about a choice made in reading. `option` is the option that asked for it ("--units"), or empty.
inline Finding decision(FindingKind kind, std::string text, std::string option = {}) {
  Finding finding{.kind = kind, .words = {{"text", std::move(text)}}};
  if (!option.empty()) finding.words.push_back({"option", std::move(option)});
  return finding;
}

// How to read a file. What is not given here is recognised from the file.
struct ReadOptions {
  std::map<Channel, std::string> columns;  // name or number from 1; "none": leave the channel out
  std::map<Channel, std::string> units;    // "cm", "tonf", ...; others are read from the header
  std::optional<double> dt_s;              // sampling interval of a file without a time column
  std::optional<DateOrder> date_order;     // for dates like 03/04/2024
  std::optional<RowRange> rows;            // rows to read
  std::optional<double> from_s, to_s;      // time interval to read
  bool skip_footer = false;                // ignore text below the rows (option --footer skip)
  std::optional<char> thousands;           // mark that groups digits: , . ' or a blank
  bool flip_force = false;                 // multiply the force by -1 (option --flip-force)
  std::optional<std::string> sheet;        // name or number of a workbook's sheet, a .mat file's struct or a JSON key
  std::optional<std::string> test;         // which test of several: a number from 1, or "all" to join them
  Corrections corrections;                 // options --skew-ms and so on

  bool operator==(ReadOptions const&) const = default;
};

// Values as measured, in mm, kN and s. All channels are of one length, but `time_s` and `load_kN` may be empty.
struct TestRecord {
  std::string file;    // as the user named it, relative to the lot file
  std::string sha256;  // hash of the file's bytes
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> force_kN;
  std::vector<double> load_kN;
  // All choices made in reading. Read with these options, the file gives the same record.
  ReadOptions layout;
  // Facts about the device, such as its serial number, as pairs of a lot file's key and the text in the record's file.
  std::vector<std::pair<std::string, std::string>> particulars;
  std::vector<Finding> recognised;   // each choice made in reading, and why
  std::vector<Finding> corrections;  // corrections made; also in `recognised`
  std::vector<Finding> warnings;
  std::vector<SignalFault> faults;  // faults of the measured signals, except repaired spikes; not stored

  bool has_time() const { return !time_s.empty(); }
  std::size_t size() const { return disp_mm.size(); }
};

// Without a time channel, `time_s` counts the samples and `vel_mm_s` is empty. Then only rate-independent laws apply.
// Their objective does not depend on the time scale if sampling is uniform.
struct FitRecord {
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> vel_mm_s;
  std::vector<double> force_kN = {};
  std::vector<double> scored = {};  // 1 if the objective counts a sample, 0 if a law only runs through it; empty: all 1
  std::vector<double> block = {};   // number of each sample's block if only some blocks are fitted, else empty
  double dead_band_mm = 0.0;        // laws that remember turning points ignore smaller reversals
  std::vector<Finding> cleaning = {};  // each step of cleaning, with its numbers

  bool has_time() const { return !vel_mm_s.empty(); }
  bool is_scored(std::size_t i) const { return scored.empty() || scored[i] != 0.0; }
  std::size_t size() const { return disp_mm.size(); }
  double largest_scored(std::vector<double> const& values) const;
};

}  // namespace isolaw::data
