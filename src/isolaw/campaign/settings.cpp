#include "isolaw/campaign/settings.hpp"

#include <algorithm>
#include <map>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {

void Settings::complete() {
  if (runs == 0) runs = method == Method::genetic ? 20 : 2;
  bool const as_published = method == Method::genetic || box == fit::BoxKind::published;
  if (as_published && !clean.weights) clean.weights = data::Weighting::time;
}

void Settings::validate() const {
  auto completed = *this;
  completed.complete();
  judge_each(setting_table(), [&](Setting const& setting) {
    if (setting.belongs_to(method)) setting.set(completed, setting.get(completed));
  });
  std::vector<Complaint> complaints;
  auto const require = [&](bool holds, char const* key, Json const& found, char const* allowed) {
    if (!holds) about(find_setting(key)->where(), complaints, [&] { refuse(found, allowed); });
  };
  require(multistart.starts >= multistart.least_starts, "starts", multistart.starts, "the least starts or more");
  require(multistart.hits <= multistart.least_starts, "hits", multistart.hits, "the least starts or fewer");
  require(!clean.scored.blocks.all() || clean.scored.predicted.all(), "score-blocks", clean.scored.predicted.text(),
          "together with --fit-blocks, the numbers of the blocks that laws are fitted to");
  if (!complaints.empty()) throw Error(std::move(complaints));
  for (auto const& id : laws) fit::make_box(laws::find_law(id), box, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, overrides);
}

std::vector<std::pair<std::string, std::string>> to_pairs(Settings const& settings) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (auto const& setting : setting_table())
    if (setting.belongs_to(settings.method)) pairs.emplace_back(setting.key, setting.get(settings).dump());
  return pairs;
}

Settings settings_from_pairs(std::vector<std::pair<std::string, std::string>> const& pairs) {
  std::map<std::string, std::string, std::less<>> const stored(pairs.begin(), pairs.end());
  Settings settings;
  judge_each(setting_table(), [&](Setting const& setting) {
    if (!setting.belongs_to(settings.method)) return;
    auto const found = stored.find(setting.key);
    auto const value = found == stored.end() ? setting.value_if_absent : Json::parse(found->second);
    if (value.is_null()) throw Error({.where = {}, .found = "is missing in the store"});
    // A value that `settings` already has is not set again. A store may hold 0 runs, if the user left the number open,
    // and set() would refuse this 0.
    if (value != setting.get(settings)) setting.set(settings, value);
  });
  return settings;
}

std::vector<std::string> parse_laws(std::string_view text) {
  std::vector<std::string> ids;
  auto const add = [&](std::string_view id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
  };
  while (true) {
    auto const comma = text.find(',');
    auto const word = trimmed(text.substr(0, comma));
    if (auto const set = std::ranges::find(laws::law_sets, word, [](auto& s) { return s.first; });
        set != std::end(laws::law_sets)) {
      for (auto const& law : laws::catalogue())
        if (law.info.set <= set->second) add(law.info.id);
    } else {
      add(laws::find_law(word).info.id);
    }
    if (comma == std::string_view::npos) return ids;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace isolaw::campaign
