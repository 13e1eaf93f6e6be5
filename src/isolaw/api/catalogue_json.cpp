#include "isolaw/api/catalogue_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "isolaw/base/json.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw {
namespace {

using Json = nlohmann::ordered_json;

Json interval_json(laws::Interval const& interval) {
  auto const bound = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  return Json::array({bound(interval.lower), bound(interval.upper)});
}

Json json_of(laws::LawEntry const& law) {
  Json json;
  json["id"] = law.info.id;
  json["name"] = law.info.name;
  json["title"] = law.info.title;
  json["source"] = law.info.source;
  json["units"] = {law.info.force.symbol, law.info.length.symbol, "s"};
  json["rate_independent"] = law.info.traits.rate_independent;
  json["memory"] = laws::memory_of(law.info);
  json["set"] = laws::name(law.info.set);
  json["formula"] = law.info.formula;
  json["note"] = law.info.note;
  json["parameters"] = Json::array();
  for (auto const& p : law.parameters)
    json["parameters"].push_back({{"name", p.name},
                                  {"unit", p.unit},
                                  {"meaning", p.meaning},
                                  {"physical", interval_json(p.physical)},
                                  {"published", p.published ? interval_json(*p.published) : Json(nullptr)},
                                  {"fixed", p.fixed_by_default ? Json(*p.fixed_by_default) : Json(nullptr)},
                                  {"paper_name", p.paper_name.empty() ? Json(nullptr) : Json(p.paper_name)}});
  json["together"] = Json::array();
  for (auto const& limit : law.joint_limits) json["together"].push_back(limit.statement);
  return json;
}

}  // namespace

std::string law_json(laws::LawEntry const& law) {
  return json_of(law).dump(2);
}

std::string catalogue_json() {
  Json all = Json::array();
  for (auto const& law : laws::catalogue()) all.push_back(json_of(law));
  return all.dump(2);
}

std::string rule_sets_json() {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_array();
  for (auto const& set : rules::built_in_rule_sets()) {
    out.begin_object().member("id", set.id).member("title", set.title).member("edition", set.edition);
    out.member("source", set.source).member("verified_by", set.verified_by).end_object();
  }
  out.end_array();
  return out.take();
}

std::string rule_text(std::string const& name) {
  if (name == "template") return std::string(rules::rule_set_text(name));
  rules::find_rule_set(name);  // throws Error if the file holds no rule set
  return rules::load_rule_text(name);
}

}  // namespace isolaw
