// Gives sample values to tests that run once for each row of the table of settings (campaign/setting_table.hpp). A new
// row is therefore tested without further code.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::testing {

// Returns a valid value of the setting other than its default. setting_samples.json holds the values for the settings
// that hold free text and for some that hold numbers.
inline Json another(campaign::Setting const& setting) {
  auto const usual = setting.get({});
  for (auto const word : setting.words)
    if (word != usual) return word;
  if (setting.kind == Kind::flag) return !usual.get<bool>();
  static Json const texts = [] {
    std::ifstream file(ISOLAW_SOURCE_DIR "/tests/setting_samples.json");
    return Json::parse(file);
  }();
  if (auto const found = texts.find(setting.key); found != texts.end()) return *found;
  if (!setting.limits) throw std::logic_error("give an example of " + std::string(setting.key));
  if (setting.kind == Kind::real) return setting.limits->allow(0.25) ? 0.25 : setting.limits->least;
  campaign::Settings completed;
  completed.complete();
  int const next = static_cast<int>(setting.limits->least) + setting.limits->step;
  return setting.get(completed) == next ? next + setting.limits->step : next;
}

// Returns values that are not valid for the setting.
inline std::vector<Json> not_allowed(campaign::Setting const& setting) {
  std::vector<Json> values{"?"};
  if (!setting.limits) return values;
  auto const& [least, most, words, step, or_zero] = *setting.limits;
  auto const add = [&](double value) {
    if (setting.kind == Kind::real)
      values.push_back(value);
    else
      values.push_back(static_cast<std::int64_t>(value));
  };
  add(least - 1.0);
  add(most + 1.0);
  if (step > 1) add(least + 1.0);
  return values;
}

// Returns settings of a campaign in which `setting` has this value. The settings that it requires, such as its search
// method, are set too.
inline campaign::Settings with(campaign::Setting const& setting, Json const& value) {
  campaign::Settings settings;
  settings.laws = campaign::parse_laws("all");
  if (setting.key == "score-blocks") campaign::find_setting("fit-blocks")->set(settings, "1");
  if (setting.only_method) settings.method = *setting.only_method;
  setting.set(settings, value);
  settings.complete();
  return settings;
}

}  // namespace isolaw::testing
