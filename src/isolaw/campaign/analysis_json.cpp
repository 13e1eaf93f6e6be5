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

// Names the stored members of each struct. each(key, member) writes or reads a member; if several members have one key,
// they become a list.
void members(auto const& each, A<analysis::Profile> auto& p) {
  each("value", p.value)("objective", p.objective);
}
void members(auto const& each, A<analysis::ParameterDetermination> auto& p) {
  each("parameter", p.parameter)("verdict", p.verdict)("lower", p.lower)("upper", p.upper);
  each("open_below", p.open_below)("open_above", p.open_above)("profile", p.profile);
}
void members(auto const& each, A<analysis::TradeOff> auto& t) {
  each("parameters", t.parameters)("change", t.change)("force_change", t.force_change)("sentence", t.sentence);
}
void members(auto const& each, A<analysis::Determination> auto& d) {
  each("optimum", d.optimum)("objective", d.objective)("rise", d.rise)("singular_values", d.singular_values);
  each("parameters", d.parameters)("trade_offs", d.trade_offs)("evaluations", d.evaluations);
}
void members(auto const& each, A<analysis::ParameterInterval> auto& p) {
  each("parameter", p.parameter)("linear", p.linear_lower, p.linear_upper);
  each("bootstrap", p.bootstrap_lower, p.bootstrap_upper);
}
void members(auto const& each, A<analysis::Intervals> auto& i) {
  each("level", i.level)("samples", i.samples)("block", i.block)("replicates", i.replicates);
  each("parameters", i.parameters)("covariance", i.covariance)("evaluations", i.evaluations);
}
void members(auto const& each, A<analysis::OneLaw> auto& law) {
  each("parameters", law.parameters)("objectives", law.objectives);
  each("mean", law.mean)("worst", law.worst)("evaluations", law.evaluations);
}
void members(auto const& each, A<analysis::LargerSwings> auto& l) {
  each("parameters", l.parameters)("fitted", l.fitted)("predicted", l.predicted);
  each("least_predicted", l.least_predicted)("evaluations", l.evaluations);
}
void members(auto const& each, A<fit::SpringsFit> auto& s) {
  each("parameters", s.parameters)("law", s.law)("given", s.given)("fitted", s.fitted);
}
void members(auto const& each, A<DeviceAnalysis> auto& a) {
  each("refinement", a.refinement)("determination", a.determination)("intervals", a.intervals);
  each.where_there("springs", a.springs);
  each.where_there("larger_swings", a.larger_swings);
}
void members(auto const& each, A<LotAnalysis> auto& a) {
  each("refinement", a.refinement)("devices", a.devices);
  each("mean", a.mean)("worst", a.worst.law)("bound", a.worst.bound);
  each.where_there("springs", a.springs);
}
void members(auto const& each, A<LeftOutAnalysis> auto& a) {
  auto& left_out = a.left_out;
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
Json written(T const& object);
template <class T>
Json written(std::vector<T> const& values) {
  Json array = Json::array();
  for (auto const& value : values) array.push_back(written(value));
  return array;
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
Json written(T const& object) {
  Json json;
  members(Writer{json}, object);
  return json;
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
void read(Json const& json, T& object);
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
void read(Json const& json, T& object) {
  members(Reader{json}, object);
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
