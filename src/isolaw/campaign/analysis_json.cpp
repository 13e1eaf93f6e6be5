#include "isolaw/campaign/analysis_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "isolaw/base/error.hpp"

namespace isolaw::campaign {
namespace {

using Json = nlohmann::ordered_json;
using analysis::Verdict;

template <class T, class Of>
concept A = std::same_as<std::remove_const_t<T>, Of>;

// What of each struct is stored: `each(key, member)` writes a member, or reads it; several of one key are a list.
void members(auto const& each, A<analysis::Profile> auto& of) {
  each("value", of.value)("objective", of.objective);
}
void members(auto const& each, A<analysis::ParameterDetermination> auto& of) {
  each("parameter", of.parameter)("verdict", of.verdict)("lower", of.lower)("upper", of.upper);
  each("open_below", of.open_below)("open_above", of.open_above)("profile", of.profile);
}
void members(auto const& each, A<analysis::TradeOff> auto& of) {
  each("parameters", of.parameters)("change", of.change)("force_change", of.force_change)("sentence", of.sentence);
}
void members(auto const& each, A<analysis::Determination> auto& of) {
  each("optimum", of.optimum)("objective", of.objective)("rise", of.rise)("singular_values", of.singular_values);
  each("parameters", of.parameters)("trade_offs", of.trade_offs)("evaluations", of.evaluations);
}
void members(auto const& each, A<analysis::ParameterInterval> auto& of) {
  each("parameter", of.parameter)("linear", of.linear_lower, of.linear_upper);
  each("bootstrap", of.bootstrap_lower, of.bootstrap_upper);
}
void members(auto const& each, A<analysis::Intervals> auto& of) {
  each("level", of.level)("samples", of.samples)("block", of.block)("replicates", of.replicates);
  each("parameters", of.parameters)("covariance", of.covariance)("evaluations", of.evaluations);
}
void members(auto const& each, A<analysis::OneLaw> auto& of) {
  each("parameters", of.parameters)("objectives", of.objectives);
  each("mean", of.mean)("worst", of.worst)("evaluations", of.evaluations);
}
void members(auto const& each, A<fit::AsSprings> auto& of) {
  each("parameters", of.parameters)("law", of.law)("given", of.given)("fitted", of.fitted);
}
void members(auto const& each, A<DeviceAnalysis> auto& of) {
  each("refinement", of.refinement)("determination", of.determination)("intervals", of.intervals);
  each.where_there("springs", of.springs);
}
void members(auto const& each, A<LotAnalysis> auto& of) {
  each("refinement", of.refinement)("devices", of.devices);
  each("mean", of.mean)("worst", of.worst.law)("bound", of.worst.bound);
  each.where_there("springs", of.springs);
}
void members(auto const& each, A<LeftOutAnalysis> auto& of) {
  auto& left_out = of.left_out;
  each("parameters", left_out.parameters)("objective", left_out.objective)("evaluations", left_out.evaluations);
}

template <class T>
concept Plain = std::integral<T> || std::same_as<T, std::string>;

template <Plain T>
Json written(T const& value) {
  return value;
}
Json written(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}
Json written(std::optional<double> const& value) {
  return value ? written(*value) : Json();
}
Json written(Verdict verdict) {
  return name(verdict);
}
template <class T>
Json written(T const& of);
template <class T>
Json written(std::vector<T> const& values) {
  Json made = Json::array();
  for (auto const& value : values) made.push_back(written(value));
  return made;
}
struct Writer {
  Json& json;
  Writer const& operator()(char const* key, auto const&... member) const {
    if constexpr (sizeof...(member) == 1)
      json[key] = (written(member), ...);
    else
      json[key] = Json::array({written(member)...});
    return *this;
  }
  void where_there(char const* key, auto const& member) const {
    if (member) json[key] = written(*member);
  }
};
template <class T>
Json written(T const& of) {
  Json made;
  members(Writer{made}, of);
  return made;
}

template <Plain T>
void read(Json const& json, T& value) {
  value = json.get<T>();
}
void read(Json const& json, double& value) {
  value = json.is_null() ? std::nan("") : json.get<double>();
}
void read(Json const& json, std::optional<double>& value) {
  value = json.is_null() ? std::nullopt : std::optional(json.get<double>());
}
void read(Json const& json, Verdict& verdict) {
  auto const& text = json.get_ref<std::string const&>();
  constexpr std::array all{Verdict::determined, Verdict::weakly_determined, Verdict::undetermined, Verdict::at_bound};
  auto const found = std::ranges::find(all, text, analysis::name);
  if (found == all.end())
    throw Error({.where = "stored analysis", .found = "'" + text + "'", .allowed = "a verdict on a parameter"});
  verdict = *found;
}
template <class T>
void read(Json const& json, T& of);
template <class T>
void read(Json const& json, std::vector<T>& values) {
  values.clear();
  for (auto const& item : json.get_ref<Json::array_t const&>()) read(item, values.emplace_back());
}
struct Reader {
  Json const& json;
  Reader const& operator()(char const* key, auto&... member) const {
    std::size_t place = 0;
    auto const& found = json.at(key);
    (read(sizeof...(member) == 1 ? found : found.at(place++), member), ...);
    return *this;
  }
  void where_there(char const* key, auto& member) const {
    member.reset();
    if (auto const found = json.find(key); found != json.end()) read(*found, member.emplace());
  }
};
template <class T>
void read(Json const& json, T& of) {
  members(Reader{json}, of);
}

}  // namespace

template <class Analysis>
std::string analysis_json(Analysis const& analysis) {
  return written(analysis).dump();
}

template <class Analysis>
void read_analysis(std::string_view json, Analysis& analysis) {
  read(Json::parse(json), analysis);
}

template std::string analysis_json(DeviceAnalysis const&);
template std::string analysis_json(LotAnalysis const&);
template std::string analysis_json(LeftOutAnalysis const&);
template void read_analysis(std::string_view, DeviceAnalysis&);
template void read_analysis(std::string_view, LotAnalysis&);
template void read_analysis(std::string_view, LeftOutAnalysis&);

}  // namespace isolaw::campaign
