#include "isolaw/wording/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "isolaw/base/printable.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

template <class T>
void add_once(std::vector<T>& all, std::vector<T> const& more) {
  for (auto const& each : more)
    if (std::ranges::find(all, each) == all.end()) all.push_back(each);
}

bool belongs(Finding const& finding, Finding const& first, unsigned grouping) {
  if (finding.kind != first.kind || (grouping & each_alone) != 0) return false;
  if (finding.word("part") != first.word("part")) return false;
  return ((grouping & by_law) == 0 || finding.law == first.law) &&
         ((grouping & by_device) == 0 || finding.devices == first.devices) &&
         ((grouping & by_words) == 0 || finding.words == first.words);
}

std::string subject_of(Group group, std::size_t most_names) {
  std::vector<std::string> names;
  switch (row(group.front().kind).subject) {
    case Subject::none:
      return {};
    case Subject::devices:
      names = devices_of(group);
      break;
    case Subject::law:
      for (auto const& finding : group) add_once(names, {law_name(finding)});
      break;
  }
  return names.empty() ? std::string() : printable(enumerate(names, most_names)) + ": ";
}

}  // namespace

std::string_view name(Severity severity) {
  constexpr std::string_view names[]{"note", "caution", "serious"};
  return names[static_cast<std::size_t>(severity)];
}

Row const& row(FindingKind kind) {
  return rows()[static_cast<std::size_t>(kind)];
}
Row const* find_row(std::string_view key) {
  auto const found = std::ranges::find(rows(), key, &Row::key);
  return found == rows().end() ? nullptr : &*found;
}

std::string remark(Finding const& finding, UnitSystem const& units) {
  return remark(Group(&finding, 1), units);
}
std::string sentence(Group group, UnitSystem const& units, std::size_t most_names) {
  return subject_of(group, most_names) + remark(group, units);
}
std::string sentence(Finding const& finding, UnitSystem const& units) {
  return sentence(Group(&finding, 1), units);
}

std::vector<std::string> remarks(std::vector<Finding> const& findings, UnitSystem const& units) {
  std::vector<std::string> all;
  for (auto const& finding : findings) all.push_back(remark(finding, units));
  return all;
}
std::string reasons(std::vector<Finding> const& findings, UnitSystem const& units) {
  std::vector<std::vector<Finding>> groups;
  for (auto const& finding : findings) {
    auto const group = std::ranges::find_if(
        groups, [&](auto const& other) { return belongs(finding, other.front(), row(finding.kind).grouping); });
    if (group == groups.end())
      groups.push_back({finding});
    else
      group->push_back(finding);
  }
  std::string text;
  for (auto const& group : groups)
    text += text.empty() ? remark(group, units) : " " + capitalised(remark(group, units));
  return text;
}

std::vector<std::vector<Finding>> grouped(std::vector<Finding> const& findings, unsigned place) {
  std::vector<std::vector<Finding>> groups;
  for (auto const& finding : findings) {
    auto const& about = row(finding.kind);
    if (place != anywhere && (about.appearance & place) == 0) continue;
    auto const group = std::ranges::find_if(
        groups, [&](auto const& other) { return belongs(finding, other.front(), about.grouping); });
    if (group == groups.end())
      groups.push_back({finding});
    else if (std::ranges::find(*group, finding) == group->end())
      group->push_back(finding);
  }
  std::ranges::stable_sort(groups, {}, [](auto const& group) { return group.front().kind; });
  return groups;
}

std::vector<std::string> sentences(std::vector<Finding> const& findings, unsigned place, UnitSystem const& units) {
  std::vector<std::string> all;
  for (auto const& group : grouped(findings, place)) all.push_back(sentence(group, units));
  return all;
}

std::vector<std::string> lines(std::vector<Finding> const& findings, unsigned place, UnitSystem const& units,
                               std::string_view opening) {
  std::vector<std::string> all;
  for (auto const& group : grouped(findings, place))
    all.push_back(
        printable(fmt::format("{}: {}{}", row(group.front().kind).severity == Severity::note ? "note" : "warning",
                              opening, sentence(group, units))));
  return all;
}

std::string paragraph(std::vector<Finding> const& findings, UnitSystem const& units, std::string_view between,
                      bool with_subject) {
  std::string text;
  for (auto const& finding : findings) {
    if (!text.empty()) text += between;
    text += with_subject ? sentence(finding, units) : remark(finding, units);
  }
  return text;
}

std::vector<std::string> devices_of(Group group) {
  std::vector<std::string> all;
  for (auto const& finding : group) add_once(all, finding.devices);
  return all;
}
std::vector<std::string> parameters_of(Group group) {
  std::vector<std::string> all;
  for (auto const& finding : group) add_once(all, finding.parameters);
  return all;
}
std::vector<int> blocks_of(Group group) {
  std::vector<int> all;
  for (auto const& finding : group) add_once(all, finding.blocks);
  return all;
}

}  // namespace isolaw::wording
