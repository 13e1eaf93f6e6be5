#include "isolaw/campaign/maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "isolaw/base/version.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/fit/kernels.hpp"

namespace isolaw::campaign {

extern char const* const sources_hash;  // the build generates it, see CMakeLists.txt

Maker this_maker() {
  return {.version = std::string(version()),
          .build = sources_hash,
          .instruction_set = std::string(fit::name(fit::instruction_set()))};
}

bool same_build(Maker const& a, Maker const& b) {
  return a.version == b.version && a.build == b.build && !a.build.empty();
}

std::vector<Maker> builds(std::span<Maker const> makers) {
  std::vector<Maker> found;
  for (auto const& maker : makers) {
    Maker const plain{.version = maker.version, .build = maker.build, .instruction_set = {}};
    if (std::ranges::find(found, plain) == found.end()) found.push_back(plain);
  }
  if (found.empty()) found.push_back({.version = std::string(version()), .build = sources_hash, .instruction_set = {}});
  return found;
}

std::string text(Maker const& maker) {
  return fmt::format("{}, build {}", maker.version, maker.build.empty() ? "not known" : maker.build);
}

std::string text(std::span<Maker const> makers) {
  return joined(builds(makers) | std::views::transform([](Maker const& maker) { return text(maker); }), " and ");
}

}  // namespace isolaw::campaign
