// Finds dropouts: three or more samples in a row that have one value, and begin and end with a jump, while the other
// channel moves.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signals/signal_pair.hpp"

namespace isolaw::data {

struct Dropout {
  SampleRange samples;
  double level = 0.0;                // the channel's value during the dropout, in the channel's unit
  double before = 0.0, after = 0.0;  // the channel's values at the samples just before and after the dropout
};

// Whether the other channel must move during a dropout, or may also stand still. It must move if dropouts of a force
// are searched, because a force may truly vanish while the device rests.
enum class OtherChannel { moves, may_stand };
// bridged() draws a straight line across each dropout. docs/properties.md has the rates of missed and false dropouts.
std::vector<Dropout> dropouts(std::span<double const> values, std::span<double const> other, OtherChannel does);
std::vector<double> bridged(std::span<double const> values, std::vector<Dropout> const& gone);

}  // namespace isolaw::data
