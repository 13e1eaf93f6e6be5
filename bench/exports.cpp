// Writes the table of docs/export.md. For each law of a campaign it says what each target of `isolaw export` gets (the
// law itself, or another material that is fitted to the law), how far the fitted material is from the law, and by how
// much it changes the response of a building.
// Usage: exports CAMPAIGN DEVICE [--update FILE]
//   --update   replaces the table in FILE, between its comments "exports table" and "end of the exports table"
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/realise.hpp"
#include "isolaw/study/build_summary.hpp"

using namespace isolaw;

namespace {

constexpr std::string_view begins = "<!-- exports table -->\n", ends = "<!-- end of the exports table -->\n";

std::string percent(std::optional<double> value) {
  return value ? fmt::format("{:+.1f}", *value) : "-";
}

std::string in_a_building(Finding const& response) {
  return fmt::format("{} | {}", percent(response.number("disp_percent")), percent(response.number("shear_percent")));
}

// Returns why the export to the target is refused, or "" if it is not.
std::string refusal(programs::Subject const& subject, std::string_view target) {
  try {
    programs::write_export(subject, programs::find_target(target), unit_systems[0], false);
    return "";
  } catch (Error const& error) {
    std::vector<std::string> reasons;
    for (auto const& complaint : error.complaints()) reasons.push_back(complaint.found);
    return joined(reasons, "; ");
  }
}

// Returns whether the export to `target` is refused. If it is, adds the reason to `reasons`, a list below the table,
// because it is too long for a cell.
bool refused(programs::Subject const& subject, std::string_view target, std::string& reasons) {
  auto const why = refusal(subject, target);
  if (!why.empty()) reasons += fmt::format("- `{}`, {}: {}.\n", subject.law->info.id, target, why);
  return !why.empty();
}

std::string script_cells(programs::Subject const& subject, std::string& reasons) {
  if (refused(subject, "opensees", reasons)) return "refused | - | - | - | - | -";
  auto const realisation = programs::realise(subject);
  auto const& form = realisation.forms.front();
  auto const& off = form.from_law;
  auto const& response = realisation.response.finding;
  auto const title = std::string_view(form.nominal.title);
  return fmt::format("{}: {} | {:.1f} | {} | {} | {}", name(realisation.fidelity), title.substr(title.rfind(' ') + 1),
                     off.rms, percent(off.K_eff), percent(off.energy), response ? in_a_building(*response) : "- | -");
}

std::string sheet_cell(programs::Subject const& subject, std::string& reasons) {
  if (refused(subject, "sheet", reasons)) return "refused";
  std::vector<std::string> links;
  auto const sheet = programs::write_export(subject, programs::find_target("sheet"), unit_systems[0], false);
  for (auto const& response : sheet.responses)
    links.push_back(fmt::format("{} {} and {}", response.word("refit"), percent(response.number("disp_percent")),
                                percent(response.number("shear_percent"))));
  return links.empty() ? "exact" : joined(links, "; ");
}

std::string table(std::filesystem::path const& campaign, std::string_view device) {
  auto const contents = campaign::Store::read(campaign / "campaign.sqlite");
  auto const summary = study::build_summary(contents);
  std::string reasons;
  std::string text =
      "| law | script for OpenSees | rms of the force, % | K_eff, % | energy, % | displacement, % | shear, % | sheet: displacement and shear, % | export of the law itself |\n"
      "|---|---|---:|---:|---:|---:|---:|---|---|\n";
  for (auto const& law : summary.laws) {
    auto const subject = programs::make_subject(contents, summary, law.id, device);
    auto const script = script_cells(subject, reasons), sheet = sheet_cell(subject, reasons);
    auto const itself = refused(subject, "cpp", reasons) ? "refused" : "exact";
    text += fmt::format("| `{}` | {} | {} | {} |\n", law.id, script, sheet, itself);
  }
  return reasons.empty() ? text : fmt::format("{}\nThe reasons for refusals:\n\n{}", text, reasons);
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string_view> const words(argv + 1, argv + argc);
  bool const update = words.size() == 4 && words[2] == "--update";
  if (words.size() != 2 && !update)
    throw Error({.where = "exports", .found = "other arguments", .allowed = "CAMPAIGN DEVICE [--update FILE]"});
  auto const written = table(words[0], words[1]);
  if (!update) {
    fmt::print("{}", written);
    return 0;
  }
  auto text = read_file(words[3], {.largest_bytes = 1 << 20, .allowed = "a page in Markdown", .when_too_large = ""});
  auto const first = text.find(begins), last = text.find(ends);
  if (first == std::string::npos || last == std::string::npos)
    throw Error({.where = std::string(words[3]), .found = "no place for the table", .allowed = std::string(begins)});
  text.replace(first + begins.size(), last - first - begins.size(), written);
  write_file(words[3], text);
  return 0;
} catch (Error const& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
