// A test record in record units (kN, mm, s): as measured, and as the identification sees it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/data/corrections.hpp"

namespace isolaw::data {

enum class Channel { time, disp, force, load };

// The choices that reading one file came to. Given back through ReadOptions they read the file the same way.
struct Layout {
  std::map<Channel, std::string> columns;  // the column's name where it is unique, else its 1-based number
  std::map<Channel, std::string> units;    // symbols of base/units
  std::optional<double> dt_s;              // sampling interval, only where it was given
  bool flip_force = false;                 // the force was multiplied by -1
  std::optional<std::string> sheet;        // part of the file, only where it has several
  std::optional<std::string> test;         // "all" or a 1-based number, only where the file holds several tests
  Corrections corrections;                 // that were asked for
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
  Layout layout;                         // columns and units as resolved
  std::vector<std::string> recognised;   // one sentence per decision: dialect, columns, units, sampling, and why
  std::vector<std::string> corrections;  // one sentence per correction asked for, also in `recognised`
  std::vector<std::string> warnings;     // what a careful reader would want to know

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
  std::vector<std::string> cleaning;  // one sentence per step applied, with its numbers

  bool has_time() const { return !vel_mm_s.empty(); }
  bool is_scored(std::size_t i) const { return scored.empty() || scored[i] != 0.0; }
  std::size_t size() const { return disp_mm.size(); }
};

}  // namespace isolaw::data
