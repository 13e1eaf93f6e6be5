// The common form of all file formats before their values are read: named columns, and rows with their line numbers.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/columns.hpp"
#include "isolaw/data/header.hpp"
#include "isolaw/data/particulars.hpp"

namespace isolaw::data {
inline constexpr std::size_t most_columns = 1000;
inline constexpr std::size_t most_tests = 1000;

// The rows that were read, in the units of the file.
struct Rows {
  std::vector<RawChannel> channels;
  std::vector<std::size_t> numbers;  // number of each sample's line, sheet row or element, from 1
  std::size_t comments = 0;          // comment lines among the rows
  std::size_t of = 0;                // number of all rows in the file, also of those not asked for
  std::vector<Finding> recognised;
  std::optional<double> origin_s;  // time stamp at time zero, if the file has time stamps
  bool dated = false;              // origin_s is in s from 1970; else from midnight
};
struct RowChoice {
  RowRange range;
  bool skip_footer = false;
  std::optional<DateOrder> date_order;
  bool all() const { return range == RowRange{}; }
  bool contains(std::size_t number) const { return number >= range.first && (!range.last || number <= *range.last); }
};
class Table {
 public:
  explicit Table(std::string place) : place_(std::move(place)) {}
  virtual ~Table() = default;
  Table(Table const&) = delete;
  Table& operator=(Table const&) = delete;

  // The table's place for messages, which add a row's number: "d01.csv", "d01.xlsx:Sheet1", "d01.json:data".
  std::string const& place() const { return place_; }
  Header const& header() const { return header_; }
  std::size_t columns() const { return columns_; }
  // Number of the line or row at which the test starts, its header included.
  std::size_t start() const { return start_; }
  // The test's name in messages, as in "tests(2) 'B'", if a file's tests have no line number that tells them apart.
  std::string const& title() const { return title_; }
  ParticularList const& particulars() const { return particulars_; }

  // The place of a column for messages, such as "d01.mat:dist".
  virtual std::string place_of(std::size_t /*column*/) const { return place_; }
  virtual std::vector<Finding> recognised() const = 0;
  // Adds complaints about the table as a whole.
  virtual void check(std::vector<Complaint>& /*complaints*/) const {}
  // Adds complaints about cells that are no number. Throws Error if it can read nothing at all.
  virtual Rows read(Columns const& columns, RowChoice const& choice, std::vector<Complaint>& complaints) const = 0;

 protected:
  std::string place_;
  Header header_;
  std::size_t columns_ = 0;
  std::size_t start_ = 1;
  std::string title_;
  ParticularList particulars_;
};

struct Tests {
  std::vector<std::unique_ptr<Table>> tables;   // one for each test; at least one if a file was read
  std::vector<std::string> sheets;              // names of the file's parts with tables, if it has parts
  std::optional<std::string> sheet;             // the part that `tables` are from, if the file has several
  std::vector<Finding> recognised;              // findings about the file as a whole
  ParticularList particulars;                   // facts about the device from sheets without tables
  std::vector<std::string> sheets_passed_over;  // sheets with rows of numbers that name no channel
};

}  // namespace isolaw::data
