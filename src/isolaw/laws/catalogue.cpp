#include "isolaw/laws/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/all_laws.hpp"

namespace isolaw::laws {
namespace {

template <class Law>
concept HasReducedForm = requires(ParamsOf<Law, double> const& p) {
  Law::reduced(p);
};

template <class Law>
LawEntry entry() {
  LawEntry made{.info = Law::info, .index = 0, .parameters = {}, .evaluate = nullptr};
  if constexpr (HasReducedForm<Law>) {
    made.redundant = Law::redundant;
    made.redundant_with.assign(Law::redundant_with.begin(), Law::redundant_with.end());
    made.redundant_value = Law::redundant_value;
    made.reduce = [](std::span<double> parameters) {
      auto const p = Law::reduced(unpack<Law, double>(parameters));
      for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i] = p.*members<Law, double>[i];
    };
  }
  for (auto const& row : Law::template rows<double>) made.parameters.push_back(row.info);
  made.evaluate = [](std::span<double const> parameters, Path const& path, Integration integration,
                     std::span<double> force) {
    // A law may have a limit there (no yielding for an infinite yield displacement) or not meet the parameter on this
    // path: either way a force would come out that nobody asked for.
    if (!std::ranges::all_of(parameters, [](double value) { return std::isfinite(value); })) {
      std::ranges::fill(force, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    run<Law, double>(unpack<Law, double>(parameters), path, integration,
                     [&](std::size_t i, double value) { force[i] = value; });
  };
  return made;
}

}  // namespace

std::size_t LawEntry::index_of(std::string_view parameter) const {
  std::string allowed;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == parameter) return i;
    allowed += (i == 0 ? "" : ", ") + std::string(parameters[i].name);
  }
  throw Error({.where = "law " + std::string(info.id),
               .found = "unknown parameter '" + std::string(parameter) + "'",
               .allowed = allowed,
               .advice = "isolaw laws " + std::string(info.id)});
}

std::span<LawEntry const> catalogue() {
  static std::vector<LawEntry> const all = [] {
    std::vector<LawEntry> made;
    for_each_law([&]<class Law>() {
      made.push_back(entry<Law>());
      made.back().index = made.size() - 1;
    });
    return made;
  }();
  return all;
}

LawEntry const& find_law(std::string_view id) {
  std::string allowed;
  for (auto const& law : catalogue()) {
    if (law.info.id == id) return law;
    allowed += (allowed.empty() ? "" : ", ") + std::string(law.info.id);
  }
  throw Error(
      {.where = "law '" + std::string(id) + "'", .found = "no such law", .allowed = allowed, .advice = "isolaw laws"});
}

}  // namespace isolaw::laws
