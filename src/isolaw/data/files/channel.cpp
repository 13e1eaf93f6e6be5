#include "isolaw/data/files/channel.hpp"

#include <cstddef>

namespace isolaw::data {
namespace {

struct ChannelInfo {
  std::string_view name, quantity;
  Dimension dimension;
};

ChannelInfo const& info_of(Channel channel) {
  static constexpr ChannelInfo table[]{{"time", "time", Dimension::time},
                                       {"disp", "horizontal displacement", Dimension::length},
                                       {"force", "horizontal force", Dimension::force},
                                       {"load", "vertical load", Dimension::force},
                                       {"cycle", "number of the cycle", Dimension::count},
                                       {"second-disp", "displacement in a second direction", Dimension::length}};
  return table[static_cast<std::size_t>(channel)];
}

}  // namespace

std::string_view name(Channel channel) {
  return info_of(channel).name;
}

std::string_view quantity(Channel channel) {
  return info_of(channel).quantity;
}

Dimension dimension(Channel channel) {
  return info_of(channel).dimension;
}

}  // namespace isolaw::data
