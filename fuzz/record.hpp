// Reads the bytes of a record as `isolaw inspect` and `isolaw calibrate` do. Every fuzz target for a kind of record
// file includes this header.
#pragma once

#include <cmath>

#include "harness.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::fuzz {

inline void read_record(std::string_view bytes, std::string const& name, data::ReadOptions const& options) {
  try {
    auto const record = data::read_record_text(bytes, name, options);
    auto const length = record.size();
    require(length >= 3 && record.force_kN.size() == length, "channels have one length");
    require(record.time_s.empty() || record.time_s.size() == length, "time has the length of the others");
    require(record.load_kN.empty() || record.load_kN.size() == length, "load has the length of the others");
    for (auto const* findings : {&record.recognised, &record.warnings})
      for (auto const& sentence : wording::remarks(*findings))
        require(is_printable(sentence), "a sentence is printable");
    for (std::size_t i = 0; i < length; ++i)
      require(std::isfinite(record.disp_mm[i]) && std::isfinite(record.force_kN[i]), "values are finite");
    auto const properties = data::cyclic_properties(record);
    for (auto const& block : properties.blocks)
      for (auto const& cycle : block.cycles)
        require(cycle.first >= 0.0 && cycle.last <= static_cast<double>(length), "a cycle lies in the record");
    for (bool const plain : {true, false}) try {
        auto cleaning = data::CleanOptions{};
        if (plain) cleaning = {.smooth = 5, .samples_per_cycle = std::nullopt, .center = true};
        auto const clean = data::clean(record, cleaning);
        require(clean.force_kN.size() == clean.size() && clean.time_s.size() == clean.size(), "clean channels fit");
      } catch (Error const& error) {
        require_plain_message(error);
      }
  } catch (Error const& error) {
    require_plain_message(error);
  }
}

}  // namespace isolaw::fuzz
