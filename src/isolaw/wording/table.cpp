#include "isolaw/wording/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "isolaw/wording/sentences.hpp"
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
  return names.empty() ? std::string() : enumerate(names, most_names) + ": ";
}

}  // namespace

std::string_view name(Severity severity) {
  constexpr std::string_view names[]{"note", "caution", "serious"};
  return names[static_cast<std::size_t>(severity)];
}

std::span<Row const> rows() {
  using enum FindingKind;
  using enum Severity;
  using enum Subject;
  static constexpr std::string_view records = "Look at the records", laws = "Do not rely on these laws",
                                    search = "Search longer or in finer steps",
                                    parameters = "Fix parameters, widen their boxes, or test more",
                                    go_on = "Continue the campaign",
                                    keep_blocks = "Keep blocks of the tests from the fit";
  static constexpr unsigned everywhere = in_report | with_law | with_building, reports = in_report;
  // In the order of FindingKind.
  static constexpr Row table[]{
      // [campaign]
      {runs_missing, "runs-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
       wording::runs_missing},
      {analyses_missing, "analyses-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
       wording::analyses_missing},
      {device_refused, "device-refused", "refused", serious, records, each_alone, reports, none,
       wording::device_refused},
      {rule_set_not_kept_by_device, "rule-set-not-kept-by-device", "rule set", serious, records, each_alone,
       with_law | with_building, none, wording::rule_set_not_kept_by_device},
      {rule_set_not_kept_by_lot, "rule-set-not-kept-by-lot", "rule set", serious, records, each_alone,
       with_law | with_building, none, wording::rule_set_not_kept_by_lot},
      {devices_not_in_lot_law, "devices-not-in-lot-law", "refused", caution, records, each_alone,
       with_law | with_building, none, wording::devices_not_in_lot_law},
      {same_record, "same-record", "copies", serious, records, each_alone, everywhere | on_certificate, none,
       wording::same_record},
      {same_compression_test, "same-compression-test", "copies", serious, records, each_alone,
       everywhere | on_certificate, none, wording::same_compression_test},
      {energy_falls, "energy-falls", "degradation", caution, records, each_alone, everywhere, devices,
       wording::energy_falls},
      {law_refused, "law-refused", "law not identified", serious, laws, by_law | by_words, everywhere, Subject::none,
       wording::law_refused},
      {runs_failed, "runs-failed", "failed runs", caution, search, by_law, everywhere, law, wording::runs_failed},
      {evaluations_failed, "evaluations-failed", "failed evaluations", note, search, by_law, reports, law,
       wording::evaluations_failed},
      {law_inadequate, "law-inadequate", "not adequate", serious, laws, each_alone, everywhere, none,
       wording::law_inadequate},
      {held_by_box, "held-by-box", "at bound", caution, parameters, each_alone, everywhere, law, wording::held_by_box},
      {prediction_poor, "prediction-poor", "prediction", serious, laws, each_alone, everywhere, law,
       wording::prediction_poor},
      {prediction_unusable, "prediction-unusable", "prediction", serious, laws, each_alone, everywhere, law,
       wording::prediction_unusable},
      {searches_disagree, "searches-disagree", "search", caution, search, by_words, everywhere, law,
       wording::searches_disagree},
      {not_determined, "not-determined", "undetermined", caution, parameters, by_law, everywhere, law,
       wording::not_determined},
      {prediction_not_asked, "prediction-not-asked", "not predicted", note, keep_blocks, one_sentence, everywhere, none,
       wording::prediction_not_asked},
      {outlier, "outlier", "outlier", caution, records, by_device, everywhere, none, wording::outlier},
      {at_bound, "at-bound", "at bound", caution, parameters, by_law, everywhere, law, wording::at_bound},
      {lot_law_at_bound, "lot-law-at-bound", "at bound", caution, parameters, by_law, everywhere, law,
       wording::lot_law_at_bound},
      {integration_coarse, "integration-coarse", "integration", caution, search, by_law, everywhere, law,
       wording::integration_coarse},
      {integration_not_finite, "integration-not-finite", "integration", serious, search, by_law, everywhere, law,
       wording::integration_not_finite},
      // [records]
      {no_cyclic_properties, "no-cyclic-properties", "record", serious, records, by_words, everywhere | on_certificate,
       devices, wording::no_cyclic_properties},
      {stated_by_older_store, "stated-by-older-store", "record", caution, records, by_words,
       everywhere | on_certificate, devices, wording::stated_by_older_store},
  };
  static_assert(
      [] {
        for (std::size_t i = 0; i < std::size(table); ++i)
          if (table[i].kind != static_cast<FindingKind>(i)) return false;
        return true;
      }(),
      "a row for each kind, in the order of FindingKind");
  return table;
}
Row const& row(FindingKind kind) {
  return rows()[static_cast<std::size_t>(kind)];
}
Row const* find_row(std::string_view key) {
  auto const found = std::ranges::find(rows(), key, &Row::key);
  return found == rows().end() ? nullptr : &*found;
}

std::string remark(Group group) {
  return row(group.front().kind).text(group);
}
std::string remark(Finding const& finding) {
  return remark(Group(&finding, 1));
}
std::string sentence(Group group, std::size_t most_names) {
  return subject_of(group, most_names) + remark(group);
}
std::string sentence(Finding const& finding) {
  return sentence(Group(&finding, 1));
}

std::vector<std::vector<Finding>> grouped(std::vector<Finding> const& findings, unsigned place) {
  std::vector<std::vector<Finding>> groups;
  for (auto const& finding : findings) {
    auto const& about = row(finding.kind);
    if ((about.appears & place) == 0) continue;
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

std::vector<std::string> sentences(std::vector<Finding> const& findings, unsigned place) {
  std::vector<std::string> all;
  for (auto const& group : grouped(findings, place)) all.push_back(sentence(group));
  return all;
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
