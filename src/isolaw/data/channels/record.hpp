// A test record in kN, mm and s: as measured (TestRecord), and as laws are fitted to it (FitRecord).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/data/channels/read_options.hpp"

namespace isolaw::data {

enum class FaultKind { clipped, stuck, spike, rectified, dropout, wrapped };

// Samples of a measured signal that cannot be true. signals/signal_faults.hpp finds such faults.
struct SignalFault {
  FaultKind kind = FaultKind::clipped;
  std::string channel;               // "displacement" or "force"
  std::vector<std::size_t> samples;  // rising indices: each spike or peak, or the first sample of each plateau
  Finding finding = {};              // numbers samples from 1; gives times too if the record has time

  std::size_t longest() const;  // length of its longest plateau in samples; 1 if it has no plateau
  bool is_outside() const { return !finding.word("outside").empty(); }  // it lies outside all blocks of cycles
};

struct TestSource {  // one of several tests of a device
  std::string name, file, sha256;

  bool operator==(TestSource const&) const = default;
};

// Values as measured, in mm, kN and s. All channels are of one length, but `time_s`, `load_kN`, `logged_cycle` and
// `second_disp_mm` may be empty.
struct TestRecord {
  std::string file;    // as the user named it, relative to the lot file
  std::string sha256;  // hash of the file's bytes
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> force_kN;
  std::vector<double> load_kN;
  std::vector<double> logged_cycle = {};    // the logger's cycle number at each sample; usually empty
  std::vector<double> second_disp_mm = {};  // at right angles to disp_mm, in tests in two directions; only plotted
  // All choices made in reading. If the file is read with these options, it gives the same record.
  ReadOptions layout;
  // Facts that the file states about the device: pairs of a key as in lot files, such as "serial", and the stated text.
  std::vector<std::pair<std::string, std::string>> device_facts;
  std::vector<Finding> recognised;   // each choice made in reading, and why
  std::vector<Finding> corrections;  // corrections made; also in `recognised`
  std::vector<Finding> warnings;
  std::vector<SignalFault> faults;  // faults of the measured signals, except repaired spikes
  // A device may have several tests. They stand one after another in the channels, and each starts from rest. `starts`
  // holds the first sample of each test, and `tests` says which test it is. Both are empty if there is one test.
  std::vector<std::size_t> starts = {};
  std::vector<TestSource> tests = {};

  bool has_time() const { return !time_s.empty(); }
  std::size_t size() const { return disp_mm.size(); }
  bool counts_half_cycles() const;  // whether a finding in `recognised` says that half cycles count
};

// True if a correction that the user asked for changed the record. A factor of the force does not count, because it
// says what the rig measures, such as two devices in double shear. A repair that found no spikes does not count either.
bool is_corrected(TestRecord const& record);

// The record that laws are fitted to. Without a time channel, `time_s` counts the samples and `vel_mm_s` is empty. Only
// rate-independent laws can then be fitted. With uniform sampling, their objective does not depend on the time scale.
struct FitRecord {
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> vel_mm_s;
  std::vector<double> force_kN = {};
  std::vector<double> scored = {};  // 1 if the objective counts a sample, 0 if a law only runs through it; empty: all 1
  std::vector<double> weights = {};      // relative weight of each sample in the objective; empty: the time around it
  std::vector<double> block = {};        // number of each sample's block if only some blocks are fitted, else empty
  std::vector<std::size_t> starts = {};  // as in TestRecord: laws begin anew at each test
  double dead_band_mm = 0.0;             // laws that remember turning points ignore reversals below this
  std::vector<Finding> cleaning = {};    // each step of cleaning, with its numbers

  bool has_time() const { return !vel_mm_s.empty(); }
  bool is_scored(std::size_t i) const { return scored.empty() || scored[i] != 0.0; }
  std::size_t size() const { return disp_mm.size(); }
  double largest_scored(std::vector<double> const& values) const;
};

struct TestRange {  // the samples of one test, from `first` to before `end`
  std::size_t first = 0, end = 0;

  std::size_t size() const { return end - first; }
  template <class T>
  std::span<T> slice(std::span<T> values) const {  // empty for a channel without values
    return values.empty() ? values : values.subspan(first, size());
  }
  std::span<double const> slice(std::vector<double> const& values) const { return slice(std::span(values)); }
};
// The tests of a record with `samples` samples, whose tests begin at `starts`; empty `starts` stand for one test.
std::vector<TestRange> test_ranges(std::span<std::size_t const> starts, std::size_t samples);

// The faults that lie in `range`. Their sample numbers count from the first sample of the range.
std::vector<SignalFault> faults_in(TestRange const& range, std::span<SignalFault const> faults);

// Splits a record into one record for each test. Each has all options and findings of `record`, and the faults in its
// test.
std::vector<TestRecord> tests_of(TestRecord const& record);
std::vector<FitRecord> tests_of(FitRecord const& record);

}  // namespace isolaw::data
