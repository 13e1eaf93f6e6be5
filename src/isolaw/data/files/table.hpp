// A table holds a test of any file format before its values are read: named columns, and rows with their line numbers.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/finding.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/data/files/channel.hpp"
#include "isolaw/data/files/device_facts.hpp"
#include "isolaw/data/files/header.hpp"
#include "isolaw/data/files/row_range.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {
inline constexpr std::size_t most_columns = 1000;
inline constexpr std::size_t most_tests = 1000;

// A finding about a choice made in reading. `option` is the option that asked for it ("--units"), or empty.
inline Finding decision(FindingKind kind, std::string text, std::string option = {}) {
  Finding finding{.kind = kind, .words = {{"text", std::move(text)}}};
  if (!option.empty()) finding.words.push_back({"option", std::move(option)});
  return finding;
}

// The column of a table that holds a channel.
struct Column {
  std::size_t index = 0;                        // from 0
  std::optional<Unit> unit;                     // empty if the unit is missing or wrong; a complaint says so
  double scale = 1.0;                           // a value of 1 in the file is `scale` units
  StampKind stamp = StampKind::none;            // kind of time stamps in the column
  std::optional<std::size_t> date_column = {};  // for times of day: the column with their dates

  double in_record_units() const { return scale * unit->in_record_units; }
};
using ChannelColumns = std::map<Channel, Column>;

// The values of one channel, as one column of the file holds them.
struct RawChannel {
  Channel channel;
  std::string column;  // "column 2 'Force [kN]'"
  std::string unit;    // symbol; may be empty
  std::vector<double> values;
};

// Keeps the first five complaints about rows of a file, and counts the others. Messages call the others `rest`: "cells
// that are no number".
class FirstComplaints {
 public:
  FirstComplaints(std::string file, std::string_view rest) : file_(std::move(file)), rest_(rest) {}
  void add(std::size_t line, std::string found, std::string allowed, std::string advice);
  void append_to(std::vector<Complaint>& complaints) const;

 private:
  static constexpr std::size_t shown = 5;
  std::string file_;
  std::string_view rest_;
  std::size_t count_ = 0;
  std::vector<Complaint> first_;
};

// The rows that were read, in the units of the file.
struct Rows {
  std::vector<RawChannel> channels;
  std::vector<std::size_t> numbers;  // number of each sample's line, sheet row or element, from 1
  std::size_t comments = 0;          // comment lines among the rows
  std::size_t rows_in_file = 0;      // number of all rows in the file, with those that the user does not want
  std::vector<Finding> recognised;
  std::optional<double> origin_s;  // time stamp at time zero, if the file has time stamps
  bool dated = false;              // origin_s is in s from 1970; else from midnight
};
struct RowChoice {
  RowRange range;
  bool skip_footer = false;
  std::optional<DateOrder> date_order;
  MissingValues missing = MissingValues::refused;  // if not refused, read() returns NaN for a missing value
  bool all() const { return range == RowRange{}; }
  bool contains(std::size_t number) const { return number >= range.first && (!range.last || number <= *range.last); }
};
class Table {
 public:
  explicit Table(std::string place) : place_(std::move(place)) {}
  virtual ~Table() = default;
  Table(Table const&) = delete;
  Table& operator=(Table const&) = delete;

  // The table's place in messages: "d01.csv", "d01.xlsx:Sheet1" or "d01.json:data". Messages append a row's number.
  std::string const& place() const { return place_; }
  Header const& header() const { return header_; }
  std::size_t columns() const { return columns_; }
  // Number of the line or row at which the test starts, its header included.
  std::size_t start() const { return start_; }
  // The test's name in messages, such as "tests(2) 'B'". Empty if messages name the test by its line number.
  std::string const& title() const { return title_; }
  DeviceFacts const& device_facts() const { return device_facts_; }

  // A column's place in messages, such as "d01.mat:dist".
  virtual std::string place_of(std::size_t /*column*/) const { return place_; }
  virtual std::vector<Finding> recognised() const = 0;
  // Adds complaints about the table as a whole.
  virtual void check(std::vector<Complaint>& /*complaints*/) const {}
  // Adds complaints about cells that are no number. Throws Error if it can read nothing at all.
  virtual Rows read(ChannelColumns const& columns, RowChoice const& choice,
                    std::vector<Complaint>& complaints) const = 0;

 protected:
  std::string place_;
  Header header_;
  std::size_t columns_ = 0;
  std::size_t start_ = 1;
  std::string title_;
  DeviceFacts device_facts_;
};

struct Tests {
  std::vector<std::unique_ptr<Table>> tables;   // one for each test; at least one if a file was read
  std::vector<std::string> sheets;              // names of the file's parts with tables, if it has parts
  std::optional<std::string> sheet;             // the part that `tables` are from, if the file has several
  std::vector<Finding> recognised;              // findings about the file as a whole
  DeviceFacts device_facts;                     // facts about the device from sheets without tables
  std::vector<std::string> sheets_passed_over;  // sheets with rows of numbers that name no channel
};

}  // namespace isolaw::data
