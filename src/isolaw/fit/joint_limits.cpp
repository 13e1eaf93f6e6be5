#include "isolaw/fit/joint_limits.hpp"

#include <fmt/format.h>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::fit {
namespace {

// True if a point of the box meets the limit. Limits are monotonic in each parameter, so testing the corners is enough.
bool met_somewhere(laws::JointLimitEntry const& limit, SearchBox const& box) {
  std::vector<double> values;
  for (auto const& p : box.parameters) values.push_back(p.free ? p.lower : p.value);
  for (std::size_t corner = 0; corner >> limit.parameters.size() == 0; ++corner) {
    for (std::size_t k = 0; k < limit.parameters.size(); ++k) {
      auto const& p = box.parameters[limit.parameters[k]];
      if (p.free) values[limit.parameters[k]] = (corner >> k & 1U) != 0 ? p.upper : p.lower;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
      if (box.parameters[i].tied_to) values[i] = values[*box.parameters[i].tied_to];
    if (limit.holds(values)) return true;
  }
  return false;
}

}  // namespace

void require_joint_limits(laws::LawEntry const& law, SearchBox const& box, std::span<Override const> overrides) {
  for (auto const& limit : law.joint_limits) {
    if (met_somewhere(limit, box)) continue;
    std::string asked;
    std::vector<std::string> found;
    for (auto const i : limit.parameters) {
      auto const& p = box.parameters[i];
      auto const value = p.tied_to ? fmt::format(" = {}", box.parameters[*p.tied_to].name)
                         : p.free  ? fmt::format(" from {:.6g} to {:.6g}", p.lower, p.upper)
                                   : fmt::format(" = {:.6g}", p.value);
      found.push_back(p.name + value);
      if (auto const* change = last_override(overrides, law, p.name)) asked += ' ' + change->text();
    }
    throw Error({.where = asked.empty() ? fmt::format("law {}", law.info.id) : "--set" + asked,
                 .found = joined(found),
                 .allowed = std::string(limit.statement),
                 .advice = fmt::format("isolaw laws {}", law.info.id)});
  }
}

void require_joint_limits(laws::LawEntry const& law, std::span<Override const> overrides) {
  auto box = make_box(law, BoxKind::scaled, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, overrides);
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto& p = box.parameters[i];
    auto const* change = last_override(overrides, law, p.name);
    if (!p.free || (change != nullptr && change->interval)) continue;
    p.lower = law.parameters[i].physical.lower;
    p.upper = law.parameters[i].physical.upper;
  }
  require_joint_limits(law, box, overrides);
}

}  // namespace isolaw::fit
