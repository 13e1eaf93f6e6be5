// Finds faults in a record's values, such as overloads, or a negative stiffness, which no device has.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/columns.hpp"
#include "isolaw/data/properties.hpp"

namespace isolaw::data {
class Findings {
 public:
  // Reports the first five complaints and counts the others, which messages call `rest` ("cells that are no number").
  Findings(std::string file, std::string_view rest) : file_(std::move(file)), rest_(rest) {}
  void add(std::size_t line, std::string found, std::string allowed, std::string advice);
  void append_to(std::vector<Complaint>& complaints) const;

 private:
  static constexpr std::size_t shown = 5;
  std::string file_;
  std::string_view rest_;
  std::size_t count_ = 0;
  std::vector<Complaint> first_;
};

// One column of the file. In the functions below `lines` holds the line number of each value.
struct RawChannel {
  Channel channel;
  std::string column;  // "column 2 'Force [kN]'"
  std::string unit;    // symbol; may be empty
  std::vector<double> values;
};

void check_channel(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                   std::vector<Complaint>& complaints);
// Throws Error if force and displacement seem to be exchanged, or the force's sign to be flipped. `exchange_advice`
// tells the user how to exchange the columns.
void check_physics(TestRecord const& record, Properties const& properties, std::string const& exchange_advice);

void add_warnings(TestRecord& record, Properties const& properties);

}  // namespace isolaw::data
