// A table whose columns are arrays of numbers: MATLAB variables, arrays of JSON.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "isolaw/data/table.hpp"
#include "isolaw/data/time_stamp.hpp"

namespace isolaw::data {

struct NumberColumn {
  std::string name = {};  // UTF-8
  std::string unit = {};  // as written beside the column; may be empty
  std::size_t length = 0;
  std::vector<double> values = {};                    // may be read only when the column is asked for
  std::map<std::size_t, std::string> odd_cells = {};  // the first few that are no number, by position from 0
  std::vector<Stamp> stamps = {};                     // time stamps of the column: as many as values, or none
  bool datenum = false;                               // numbers are MATLAB's days

  StampKind kind() const;  // none if the stamps differ in kind
};

class NumberTable : public Table {
 public:
  // `row` is what a row is called in messages: "row", "element"; `recognised` says how the table was found.
  NumberTable(std::string place, std::vector<NumberColumn> columns, std::string_view row, std::string recognised,
              std::string title = {});

  std::vector<Finding> recognised() const override { return {decision(FindingKind::file_format, recognised_)}; }
  Rows read(Columns const& columns, RowChoice const& choice, std::vector<Complaint>& complaints) const override;

 protected:
  virtual std::vector<double> values(std::size_t column) const { return list_[column].values; }

  std::vector<NumberColumn> list_;

 private:
  void report_odd(std::size_t column, RawChannel const& raw, RowChoice const& choice,
                  std::vector<Complaint>& complaints) const;
  std::vector<Stamp> stamps_of(Column const& column, std::vector<Complaint>& complaints) const;
  void check_lengths(Columns const& columns, std::vector<Complaint>& complaints) const;

  std::string recognised_;
};

}  // namespace isolaw::data
