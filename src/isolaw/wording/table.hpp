// The one table of everything the program says besides numbers, with a row for each kind of finding: only here does a
// finding become a sentence. After ccache's table of statistics and simdjson's table of errors.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"

namespace isolaw::wording {

enum class Severity {
  note,     // worth knowing
  caution,  // a number may be less certain than it looks
  serious   // a number may be wrong, or something is missing
};
std::string_view name(Severity severity);

// The fields in which findings of one kind must agree to be said in one sentence.
enum Grouping : unsigned { one_sentence = 0, by_law = 1, by_device = 2, by_words = 4, each_alone = 8 };

// The places where a kind of finding may appear. JSON holds every kind.
enum Appearance : unsigned {
  anywhere = 0,        // as a place, every kind appears in it; in a row, the kind appears only where code asks for it
  in_report = 1,       // terminal and page
  on_certificate = 2,  // the page that is signed
  with_law = 4,        // wherever the law is taken from the campaign: exports, `simulate`
  with_building = 8,   // the answers of `building`
};

// How the sentence begins: with the devices or the law that it is about, or with itself.
enum class Subject { none, devices, law };

// Findings of one kind that are said in one sentence; never empty.
using Group = std::span<Finding const>;

struct Row {
  FindingKind kind;
  std::string_view key;    // "kind" in JSON and in stores
  std::string_view topic;  // "topic" in JSON: several kinds may share one
  Severity severity;
  std::string_view action;  // what the reader should do about it
  unsigned grouping;
  unsigned appears;
  Subject subject;
  std::string_view text;  // the sentence without its subject, with fields in braces (wording/fill.hpp)
  std::string (*compose)(Group) = nullptr;  // makes the sentence if `text` alone cannot
};

std::span<Row const> rows();
Row const& row(FindingKind kind);
Row const* find_row(std::string_view key);  // nullptr: there is no such kind

// "device-01 and device-02: noise of 0.1 to 0.3 mm ..."; at most `most_names` devices are named.
std::string sentence(Group group, std::size_t most_names = 5);
std::string sentence(Finding const& finding);
// The same without the subject, for a place that names the subject already.
std::string remark(Group group);
std::string remark(Finding const& finding);
// remarks() gives one remark for each finding, for a list. reasons() joins them into one text, to follow a colon.
std::vector<std::string> remarks(std::vector<Finding> const& findings);
std::string reasons(std::vector<Finding> const& findings);

// The findings that may appear in `place`, in the order of the table, with one group for each sentence.
std::vector<std::vector<Finding>> grouped(std::vector<Finding> const& findings, unsigned place = in_report);
// One sentence for each group.
std::vector<std::string> sentences(std::vector<Finding> const& findings, unsigned place = in_report);

// The sentences of single findings, in the order given, joined by `between`. `with_subject` is false if the place names
// the subject already.
std::string paragraph(std::vector<Finding> const& findings, std::string_view between = " ", bool with_subject = true);

// Devices, parameters or blocks of all findings of a group, each once, in the order of their first appearance.
std::vector<std::string> devices_of(Group group);
std::vector<std::string> parameters_of(Group group);
std::vector<int> blocks_of(Group group);

}  // namespace isolaw::wording
