// The common form of all file formats before their values are read: named columns, and rows with a place in the file.
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

// Values are in the units of the file.
struct Rows {
  std::vector<RawChannel> channels;
  std::vector<std::size_t> numbers;  // place of each sample, counted from 1: line, row of the sheet, element
  std::size_t comments = 0;          // comment lines among the rows
  std::size_t of = 0;                // number of all rows, also of those not asked for
  std::vector<Finding> recognised;
  std::optional<double> origin_s;  // zero of the time, if it was read from stamps
  bool dated = false;              // origin_s counts from 1970; else from midnight
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

  // "d01.csv", "d01.xlsx:Sheet1", "d01.json:data"; messages put a row's number behind it.
  std::string const& place() const { return place_; }
  Header const& header() const { return header_; }
  std::size_t columns() const { return columns_; }
  // Number of the test's first row, the header included.
  std::size_t start() const { return start_; }
  // Names the test among others of its file, if the start row is not enough: "tests(2) 'B'".
  std::string const& title() const { return title_; }
  ParticularList const& particulars() const { return particulars_; }

  // "d01.mat:dist", if columns have places of their own.
  virtual std::string place_of(std::size_t /*column*/) const { return place_; }
  virtual std::vector<Finding> recognised() const = 0;
  // Complaints about the table as a whole.
  virtual void check(std::vector<Complaint>& /*complaints*/) const {}
  // Complains of cells that are no number. Throws Error if nothing can be read at all.
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
  std::vector<std::unique_ptr<Table>> tables;   // at least one if a file was read
  std::vector<std::string> sheets;              // the parts of the file that hold tables, if it has parts
  std::optional<std::string> sheet;             // the sheet of these tables, if there are several
  std::vector<Finding> recognised;              // about the file as a whole
  ParticularList particulars;                   // from sheets without tables
  std::vector<std::string> sheets_passed_over;  // with rows of numbers, but without the name of any channel
};

}  // namespace isolaw::data
