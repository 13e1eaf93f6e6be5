#include "isolaw/render/page/html.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/json/results_json.hpp"
#include "isolaw/render/page/page_data.hpp"
#include "isolaw/study/law_look.hpp"

namespace isolaw::render {
namespace {

std::string html_escaped(std::string_view text) {
  constexpr std::string_view signs = "&<>\"'";
  constexpr std::string_view escaped[]{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string safe;
  for (char const c : text) {
    auto const sign = signs.find(c);
    sign == std::string_view::npos ? safe += c : safe += escaped[sign];
  }
  return safe;
}

std::string asked_json(campaign::Acceptance const& asked) {
  JsonWriter out;
  out.begin_object();
  write_members(out, "rules_file", asked.rules_file, "rules", asked.rules, "design", asked.design, "lot_size",
                asked.lot_size);
  for (auto const& option : campaign::alike_table())
    if (auto const value = option.get(asked); !value.is_null()) write_members(out, option.key, value.get<double>());
  out.end_object();
  return out.take();
}

std::string law_colours() {
  std::string light, dark;
  for (std::size_t i = 0; i < law_look_count; ++i) {
    light += fmt::format(" --law-{}: {};", i + 1, law_looks[i].colour);
    dark += fmt::format(" --law-{}: {};", i + 1, law_looks[i].on_dark);
  }
  return fmt::format(":root {{{} }}\n@media (prefers-color-scheme: dark) {{ :root:not([data-printing]) {{{} }} }}",
                     light, dark);
}

std::string page_of(std::string_view title, std::string_view asked, std::string_view data, std::string_view script) {
  auto const file = [](std::string_view name) { return std::string(embedded_text(page_files(), name)); };
  std::map<std::string_view, std::string> const contents{
      {"title", html_escaped(title)},
      {"style", file("page.css")},
      {"law_colours", law_colours()},
      {"errors", file("errors.js")},
      {"plotly", file("plotly-basic.min.js")},
      {"asked", script_safe(asked)},
      {"data", script_safe(data)},
      {"script", file(script)},
  };
  // Goes through the template only once, so that a placeholder's name inside an inserted text is not replaced.
  std::string_view rest = embedded_text(page_files(), "page.html");
  std::string page;
  for (auto at = rest.find("{{"); at != std::string_view::npos; at = rest.find("{{")) {
    auto const end = rest.find("}}", at);
    page += rest.substr(0, at);
    page += contents.at(rest.substr(at + 2, end - at - 2));
    rest.remove_prefix(end + 2);
  }
  return page += rest;
}

}  // namespace

std::string html(Summary const& summary) {
  return page_of(summary.title.empty() ? "isolaw report" : summary.title + " – isolaw report",
                 asked_json(summary.asked), page_data_json(summary), "page.js");
}

std::string building_html(building::Study const& study, building::Answers const& answers) {
  JsonWriter out;
  out.begin_object();
  write_building(out, study, answers, Digits::shown);
  out.member("motions_for_a_mean", std::uint64_t{building::motions_for_a_mean});
  write_units(out, study.units());
  write_notation(out, {});
  out.end_object();
  auto const& title = study.file.settings.title;
  return page_of(title.empty() ? "isolaw building" : title + " – isolaw building", "{}", out.take(), "building.js");
}

std::optional<campaign::Acceptance> asked_in(std::string_view page) {
  constexpr std::string_view opening = R"(<script type="application/json" id="isolaw-asked">)";
  auto const start = page.find(opening);
  if (start == std::string_view::npos) return std::nullopt;
  page.remove_prefix(start + opening.size());
  auto const json = nlohmann::json::parse(page.substr(0, page.find("</script>")), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  campaign::Acceptance asked;
  auto const text = [&](char const* key, std::string& target) {
    auto const found = json.find(key);
    bool const is_text = found != json.end() && found->is_string();
    if (is_text) target = found->get<std::string>();
    return is_text;
  };
  bool const whole = text("rules_file", asked.rules_file) && text("rules", asked.rules) && text("design", asked.design);
  if (auto const size = json.find("lot_size"); size != json.end() && size->is_number_integer())
    asked.lot_size = size->get<int>();
  for (auto const& option : campaign::alike_table())
    if (auto const value = json.find(option.key); value != json.end() && value->is_number())
      option.set(asked, value->get<double>());
  return whole ? std::optional(asked) : std::nullopt;
}

}  // namespace isolaw::render
