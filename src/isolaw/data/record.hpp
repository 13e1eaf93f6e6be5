// A test record in record units (kN, mm, s): as measured, and as the identification sees it.
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

// Of dates whose year does not come first.
enum class DateOrder { day_first, month_first };

// Rows of numbers, counted from 1 below the header; blank lines and comments do not count.
struct RowRange {
  std::size_t first = 1;
  std::optional<std::size_t> last;  // nullopt: to the end
  bool operator==(RowRange const&) const = default;
};

// A decision in reading a file, in one sentence; `option` is the one that asked for it ("--units"), empty where none did.
inline Finding decision(FindingKind kind, std::string text, std::string option = {}) {
  Finding finding{.kind = kind, .words = {{"text", std::move(text)}}};
  if (!option.empty()) finding.words.push_back({"option", std::move(option)});
  return finding;
}

// How to read a file. What is missing is recognised.
struct ReadOptions {
  std::map<Channel, std::string> columns;  // name or 1-based number; "none": not read
  std::map<Channel, std::string> units;    // "cm", "tonf", ...; what is missing is read from the header
  std::optional<double> dt_s;              // sampling interval of a file without a time column
  std::optional<DateOrder> date_order;     // of time stamps that do not tell
  std::optional<RowRange> rows;            // the part of the file that is read
  std::optional<double> from_s, to_s;      // the part of the time that is read
  bool skip_footer = false;                // text below the rows is left out (option --footer skip)
  std::optional<char> thousands;           // what groups the digits of numbers: , . ' or a blank
  bool flip_force = false;                 // multiply the force by -1 (option --flip-force)
  std::optional<std::string> sheet;        // sheet of a workbook, struct of a .mat file, key of JSON: name or number
  std::optional<std::string> test;  // of a file that holds several: 1-based number, or "all", one after the other
  Corrections corrections;          // of what the rig did to the record (options --skew-ms and so on)

  bool operator==(ReadOptions const&) const = default;
};

// What a laboratory's file holds after reading: raw values, only converted to record units. Equal lengths;
// `time_s` is empty when the file has no time column and no sampling interval was given, `load_kN` when there is none.
struct TestRecord {
  std::string file;    // as the user named it, relative to the lot file
  std::string sha256;  // of the file's bytes
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> force_kN;
  std::vector<double> load_kN;
  // The choices that reading came to, which read the file the same way: a column's name where it is unique, else its
  // number; sheet and test only where the file holds several.
  ReadOptions layout;
  // What the file says of its device, by the key of a lot file, as it is written.
  std::vector<std::pair<std::string, std::string>> particulars;
  std::vector<Finding> recognised;   // each decision, made with decision(), and why
  std::vector<Finding> corrections;  // each correction asked for, also in `recognised`
  std::vector<Finding> warnings;     // what a careful reader would want to know
  std::vector<SignalFault> faults;   // of the signals as they were recorded, but for spikes repaired; not stored

  bool has_time() const { return !time_s.empty(); }
  std::size_t size() const { return disp_mm.size(); }
};

// What the laws are fitted to. Without a time channel `time_s` counts the samples of the file, `vel_mm_s` is empty and
// only rate-independent laws apply (the objective does not depend on the time scale when sampling is uniform).
struct FitRecord {
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> vel_mm_s;
  std::vector<double> force_kN;
  std::vector<double> scored = {};  // 1 where a law is judged, 0 where it only runs along; empty: everywhere
  std::vector<double> block = {};  // number of the block that a sample belongs to, where some are predicted; else empty
  double dead_band_mm = 0.0;  // displacement is followed with this much play by laws that remember its turning points
  std::vector<Finding> cleaning;  // each step applied, with its numbers

  bool has_time() const { return !vel_mm_s.empty(); }
  bool is_scored(std::size_t i) const { return scored.empty() || scored[i] != 0.0; }
  std::size_t size() const { return disp_mm.size(); }
  // The largest magnitude among the samples that laws are judged by; 0 of none.
  double largest_scored(std::vector<double> const& values) const;
};

}  // namespace isolaw::data
