// A table whose columns are arrays of numbers, as MATLAB variables or JSON arrays are.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "isolaw/data/files/table.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {

struct NumberColumn {
  std::string name = {};  // UTF-8
  std::string unit = {};  // as written beside the column; may be empty
  std::size_t length = 0;
  std::vector<double> values = {};                    // may stay empty until a channel needs the column
  std::map<std::size_t, std::string> odd_cells = {};  // texts of the first cells that are no number, by row from 0
  std::vector<Stamp> stamps = {};                     // one for each value if all cells are time stamps, else fewer
  bool datenum = false;                               // the numbers are days in MATLAB's calendar (datenum)

  StampKind kind() const;  // StampKind::none if the stamps differ in kind
};

class NumberTable : public Table {
 public:
  // `row` is the word for a row in messages: "row" or "element". `recognised` says how the table was found.
  NumberTable(std::string place, std::vector<NumberColumn> columns, std::string_view row, std::string recognised,
              std::string title = {});

  void add_units_elsewhere(std::vector<std::string> units) { header_.units_elsewhere = std::move(units); }

  std::vector<Finding> recognised() const override { return {decision(FindingKind::file_format, recognised_)}; }
  Rows read(ChannelColumns const& columns, RowChoice const& choice, std::vector<Complaint>& complaints) const override;

 protected:
  virtual std::vector<double> values(std::size_t column) const { return list_[column].values; }

  std::vector<NumberColumn> list_;

 private:
  void report_odd(std::size_t column, RawChannel const& raw, RowChoice const& choice,
                  std::vector<Complaint>& complaints) const;
  std::vector<Stamp> stamps_of(Column const& column, std::vector<Complaint>& complaints) const;
  void check_lengths(ChannelColumns const& columns, std::vector<Complaint>& complaints) const;

  std::string recognised_;
};

}  // namespace isolaw::data
