// A finding is whatever the program has to say besides numbers: a warning, a doubt, an answer, a piece of advice. It
// travels as fields. The module `wording` holds one table with a row for each kind, which makes the sentence when it is
// printed; no code reads a sentence back.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw {

// The table in wording/table.cpp has its rows in the same order, which is the order in which findings are shown: the
// most serious first.
enum class FindingKind {
  // [campaign]
  runs_missing,
  analyses_missing,
  device_refused,
  rule_set_not_kept_by_device,
  rule_set_not_kept_by_lot,
  devices_not_in_lot_law,
  same_record,
  same_compression_test,
  energy_falls,
  law_refused,
  runs_failed,
  evaluations_failed,
  law_inadequate,
  held_by_box,
  prediction_poor,
  prediction_unusable,
  searches_disagree,
  not_determined,
  prediction_not_asked,
  outlier,
  at_bound,
  lot_law_at_bound,
  integration_coarse,
  integration_not_finite,
  // [records]
  no_cyclic_properties,
  stated_by_older_store,  // the text of a store written before findings had fields
};

struct FindingNumber {
  std::string name;  // with its unit: "offset_mm"
  double value = 0.0;

  bool operator==(FindingNumber const&) const = default;
};

struct FindingWord {
  std::string name, text;

  bool operator==(FindingWord const&) const = default;
};

struct Finding {
  FindingKind kind = FindingKind::stated_by_older_store;
  std::string law = {};  // its id; empty: the finding is about no single law
  std::vector<std::string> devices = {}, parameters = {};
  std::vector<int> blocks = {};
  std::vector<FindingNumber> numbers = {};
  std::vector<FindingWord> words = {};

  bool operator==(Finding const&) const = default;

  // `fallback` where the finding has no number of that name.
  double number(std::string_view name, double fallback = 0.0) const {
    auto const found = std::ranges::find(numbers, name, &FindingNumber::name);
    return found == numbers.end() ? fallback : found->value;
  }
  bool has_number(std::string_view name) const {
    return std::ranges::find(numbers, name, &FindingNumber::name) != numbers.end();
  }
  // Empty where the finding has no word of that name.
  std::string_view word(std::string_view name) const {
    auto const found = std::ranges::find(words, name, &FindingWord::name);
    return found == words.end() ? std::string_view() : found->text;
  }
};

}  // namespace isolaw
