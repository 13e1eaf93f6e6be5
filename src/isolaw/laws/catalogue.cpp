#include "isolaw/laws/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <ranges>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/all_laws.hpp"

namespace isolaw::laws {
namespace {

// Indices of the parameters whose names occur in the text as whole words.
std::vector<std::size_t> named_in(std::string_view text, std::vector<ParameterInfo> const& parameters) {
  auto const padded = fmt::format(" {} ", text);
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (padded.find(fmt::format(" {} ", parameters[i].name)) != std::string::npos) named.push_back(i);
  return named;
}

template <class Law, std::size_t I>
bool holds(std::span<double const> values) {
  return Law::joint_limits[I].holds(unpack<Law, double>(values));
}

template <class Law, std::size_t... I>
std::vector<JointLimitEntry> joint_limits(std::vector<ParameterInfo> const& parameters, std::index_sequence<I...>) {
  return {{.statement = Law::joint_limits[I].statement,
           .parameters = named_in(Law::joint_limits[I].statement, parameters),
           .holds = holds<Law, I>}...};
}

template <class Law>
void store(ParamsOf<Law, double> const& params, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = params.*members<Law, double>[i];
}

// Whether the law itself has with_factor() or with_factors(). An inherited one does not count: it returns the
// parameters of the base law and would lose those that the law adds.
template <class Law>
concept HasOneFactor = requires(ParamsOf<Law, double> const& p) {
  { Law::with_factor(p, 1.0) } -> std::same_as<ParamsOf<Law, double>>;
};
template <class Law>
concept HasTwoFactors = requires(ParamsOf<Law, double> const& p) {
  { Law::with_factors(p, 1.0, 1.0) } -> std::same_as<ParamsOf<Law, double>>;
};

template <class Law>
LawEntry entry() {
  static_assert(HasOneFactor<Law> != HasTwoFactors<Law>,
                "a law has with_factors(params, a, b) or, if its parts cannot be told apart, with_factor(params, f)");
  LawEntry law{.info = Law::info, .index = 0, .parameters = {}, .evaluate = nullptr};
  if constexpr (requires(ParamsOf<Law, double> const& p) { Law::reduced(p); }) {
    law.redundant = Law::redundant;
    law.redundant_with.assign(Law::redundant_with.begin(), Law::redundant_with.end());
    law.redundant_value = Law::redundant_value;
    law.reduce = [](std::span<double> parameters) {
      store<Law>(Law::reduced(unpack<Law, double>(parameters)), parameters);
    };
  }
  for (auto const& row : Law::template rows<double>) law.parameters.push_back(row.info);
  if constexpr (requires { Law::joint_limits; })
    law.joint_limits = joint_limits<Law>(law.parameters, std::make_index_sequence<Law::joint_limits.size()>());
  law.canonical = [](std::span<double const> parameters) -> Canonical {
    if constexpr (requires { Law::canonical(unpack<Law, double>(parameters)); })
      return Law::canonical(unpack<Law, double>(parameters));
    return NoForm{};
  };
  law.one_factor = HasOneFactor<Law>;
  law.with_factors = [](std::span<double> parameters, double a, [[maybe_unused]] double b) {
    auto const p = unpack<Law, double>(parameters);
    if constexpr (HasOneFactor<Law>)
      store<Law>(Law::with_factor(p, a), parameters);
    else
      store<Law>(Law::with_factors(p, a, b), parameters);
  };
  law.evaluate = [](std::span<double const> parameters, Path const& path, Integration integration,
                    std::span<double> force) {
    // A law may give finite forces although a parameter is infinite: an infinite yield displacement means no yielding,
    // and some paths never use a certain parameter. Such forces are not valid results.
    if (!std::ranges::all_of(parameters, [](double value) { return std::isfinite(value); })) {
      std::ranges::fill(force, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    run<Law, double>(unpack<Law, double>(parameters), path, integration,
                     [&](std::size_t i, double value) { force[i] = value; });
  };
  return law;
}

}  // namespace

std::size_t LawEntry::index_of(std::string_view parameter) const {
  auto const found = std::ranges::find(parameters, parameter, &ParameterInfo::name);
  if (found != parameters.end()) return static_cast<std::size_t>(found - parameters.begin());
  throw Error({.where = "law " + std::string(info.id),
               .found = "unknown parameter '" + std::string(parameter) + "'",
               .allowed = joined(parameters | std::views::transform(&ParameterInfo::name)),
               .advice = "isolaw laws " + std::string(info.id)});
}

std::optional<LawEntry::Unmet> LawEntry::unmet(std::span<double const> values) const {
  auto const limit = std::ranges::find_if(joint_limits, [&](auto const& each) { return !each.holds(values); });
  if (limit == joint_limits.end()) return std::nullopt;
  auto const text = [&](std::size_t i) { return fmt::format("{} = {:.6g}", parameters[i].name, values[i]); };
  return Unmet{.found = joined(limit->parameters | std::views::transform(text)), .statement = limit->statement};
}

std::string_view memory_of(LawInfo const& law) {
  if (law.traits.masing) return "turning points";
  return law.traits.remembers ? "peaks or travel" : "its own state, or none";
}

std::span<LawEntry const> catalogue() {
  static std::vector<LawEntry> const all = [] {
    std::vector<LawEntry> entries;
    for_each_law([&]<class Law>() {
      entries.push_back(entry<Law>());
      entries.back().index = entries.size() - 1;
    });
    return entries;
  }();
  return all;
}

namespace {

constexpr auto id_of = [](LawEntry const& law) { return law.info.id; };

}  // namespace

std::string_view display_name(std::string_view id) {
  auto const found = std::ranges::find(catalogue(), id, id_of);
  return found == catalogue().end() ? id : found->info.name;
}

LawEntry const& find_law(std::string_view id) {
  auto const found = std::ranges::find(catalogue(), id, id_of);
  if (found != catalogue().end()) return *found;
  throw Error({.where = "law '" + std::string(id) + "'",
               .found = "no such law",
               .allowed = joined(catalogue() | std::views::transform(id_of)),
               .advice = "isolaw laws"});
}

}  // namespace isolaw::laws
