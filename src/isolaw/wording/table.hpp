// The table of everything that isolaw says besides numbers. It has a row for each kind of finding. Findings become
// sentences only here. Its models are ccache's table of statistics and simdjson's table of errors.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/base/unit_system.hpp"

namespace isolaw::wording {

enum class Severity {
  note,     // worth knowing
  caution,  // a number may be less certain than it looks
  serious   // a number may be wrong, or something is missing
};
std::string_view name(Severity severity);

// Findings of one kind share a sentence if they agree in the fields named here. With each_alone, each finding has a
// sentence of its own.
enum Grouping : unsigned { one_sentence = 0, by_law = 1, by_device = 2, by_words = 4, each_alone = 8 };

// The places where a kind of finding may appear. JSON holds every kind. In a row, `anywhere` means that the kind
// appears only where code asks for this kind. As the argument `place` of a function such as grouped(), it has another
// meaning: findings of every kind are wanted.
enum Appearance : unsigned {
  anywhere = 0,
  in_report = 1,       // terminal and page
  on_certificate = 2,  // the certificate to be signed
  with_law = 4,        // wherever a law is taken from the campaign: exports, `simulate`
  with_building = 8,   // the output of `building`
};

// The first words of the sentence: the names of the devices, the name of the law, or neither.
enum class Subject { none, devices, law };

// The findings of one kind that share a sentence; never empty.
using Group = std::span<Finding const>;

struct Row {
  FindingKind kind;
  std::string_view key;    // "kind" in JSON and in stores
  std::string_view topic;  // "topic" in JSON, such as "record", which several kinds share
  Severity severity;
  std::string_view action;  // tells the reader what to do
  unsigned grouping;
  unsigned appearance;
  Subject subject;
  std::string_view text;  // the sentence without its subject, with fields in braces (wording/fill.hpp)
  std::string (*compose)(Group, UnitSystem const&) = nullptr;  // makes the sentence if `text` is not enough
};

std::span<Row const> rows();
Row const& row(FindingKind kind);
Row const* find_row(std::string_view key);  // nullptr if no kind has this key

// "device-01 and device-02: noise of 0.1 to 0.3 mm ..."; names at most `most_names` devices. This function and those
// below convert numbers to `units`.
std::string sentence(Group group, UnitSystem const& units = record_units, std::size_t most_names = 5);
std::string sentence(Finding const& finding, UnitSystem const& units = record_units);
// sentence() without the devices or the law at its start, for a place that names them already.
std::string remark(Group group, UnitSystem const& units = record_units);
std::string remark(Finding const& finding, UnitSystem const& units = record_units);
// remarks() returns one remark for each finding, for a list. reasons() joins the remarks into one text, to be printed
// after a colon.
std::vector<std::string> remarks(std::vector<Finding> const& findings, UnitSystem const& units = record_units);
std::string reasons(std::vector<Finding> const& findings, UnitSystem const& units = record_units);

// The findings that may appear in `place`, in the order of the table. Each inner list makes one sentence.
std::vector<std::vector<Finding>> grouped(std::vector<Finding> const& findings, unsigned place = in_report);
std::vector<std::string> sentences(std::vector<Finding> const& findings, unsigned place = in_report,
                                   UnitSystem const& units = record_units);

// The texts of sentences() as lines of a terminal: "warning: ...", or "note: ..." if the finding is a note. `opening`
// stands before each sentence.
std::vector<std::string> lines(std::vector<Finding> const& findings, unsigned place = in_report,
                               UnitSystem const& units = record_units, std::string_view opening = {});

// One sentence for each finding, in the order given, joined by `between`. `with_subject` is false for a place that
// names the devices or the law already.
std::string paragraph(std::vector<Finding> const& findings, UnitSystem const& units = record_units,
                      std::string_view between = " ", bool with_subject = true);

// The devices, parameters or blocks that the findings of a group name, each once, in the order of first appearance.
std::vector<std::string> devices_of(Group group);
std::vector<std::string> parameters_of(Group group);
std::vector<int> blocks_of(Group group);

}  // namespace isolaw::wording
