#include "isolaw/data/cycles/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ranges>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::data {
namespace {

std::optional<int> whole_number(std::string_view text) {
  text = trimmed(text);
  auto const value = text.starts_with('+') ? std::nullopt : number_in<int>(text);
  return value && *value >= 1 && *value <= Numbers::largest ? value : std::nullopt;
}

std::optional<Numbers::Range> parse_range(std::string_view text) {
  auto const dash = text.find('-');
  auto const first = whole_number(text.substr(0, dash));
  if (!first) return std::nullopt;
  if (dash == std::string_view::npos) return Numbers::Range{*first, *first};
  auto const rest = trimmed(text.substr(dash + 1));
  auto const last = rest.empty() ? std::optional(Numbers::largest) : whole_number(rest);
  if (!last || *last < *first) return std::nullopt;
  return Numbers::Range{*first, *last};
}

// Lists the record's cycles for messages: "block 1: cycles 1 to 7; block 2: ..."
std::string what_there_is(Segmentation const& segmentation) {
  std::map<int, int> counted;
  for (auto const& cycle : segmentation.cycles) {
    auto& last = counted[cycle.block];
    last = std::max(last, cycle.number);
  }
  std::vector<std::string> texts;
  for (auto const& [block, last] : counted)
    texts.push_back(fmt::format("block {}: {}", block,
                                last == 0   ? std::string("no complete cycle")
                                : last == 1 ? std::string("cycle 1")
                                            : fmt::format("cycles 1 to {}", last)));
  return joined(texts, "; ");
}

void mark(std::vector<double>& scored, double first, double last, double value = 1.0) {
  auto const begin = static_cast<std::size_t>(std::max(0.0, std::ceil(first)));
  auto const end = std::min(scored.size(), static_cast<std::size_t>(std::max(0.0, std::floor(last))) + 1);
  for (auto i = begin; i < end; ++i) scored[i] = value;
}

}  // namespace

bool Numbers::contains(int number) const {
  return all() || std::ranges::any_of(ranges, [&](Range const& r) { return r.first <= number && number <= r.last; });
}

std::string Numbers::text() const {
  if (all()) return "all";
  auto const text_of = [](Range const& r) {
    return r.last == largest   ? fmt::format("{}-", r.first)
           : r.last == r.first ? fmt::format("{}", r.first)
                               : fmt::format("{}-{}", r.first, r.last);
  };
  return joined(ranges | std::views::transform(text_of), ",");
}

std::string Selection::text() const {
  auto const part = [](std::string_view what, Numbers const& numbers) {
    auto const text = numbers.text();
    return fmt::format("{}{} {}", what, text.find_first_of(",-") == std::string::npos ? "" : "s", text);
  };
  if (all()) return {};
  if (cycles.all()) return part("block", blocks);
  return part("cycle", cycles) + " of " + (blocks.all() ? "every block" : part("block", blocks));
}

Numbers parse_numbers(std::string_view option, std::string_view text) {
  Numbers numbers;
  if (trimmed(text) == "all") return numbers;
  constexpr std::size_t most_ranges = 1000;
  auto rest = text;
  while (true) {
    auto const comma = rest.find(',');
    auto const range = parse_range(rest.substr(0, comma));
    if (!range || numbers.ranges.size() == most_ranges)
      throw Error({.where = std::string(option),
                   .found = fmt::format("'{}'", printable(text.substr(0, 200))),
                   .allowed = "all, or numbers from 1 and ranges of them, separated by commas: 3, 2-5, 4-",
                   .advice = fmt::format("{} 2-", option)});
    numbers.ranges.push_back(*range);
    if (comma == std::string_view::npos) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

std::vector<double> scored_samples(Selection const& selection, Segmentation const& segmentation, std::size_t samples) {
  if (selection.all()) return {};
  auto const where = fmt::format("--fit-blocks {} --fit-cycles {}", selection.blocks.text(), selection.cycles.text());
  if (!segmentation.cyclic)
    throw Error({.where = where,
                 .found = "the record is not cyclic: it has no cycles to choose among",
                 .allowed = "all",
                 .advice = "leave out --fit-blocks and --fit-cycles for this record"});
  std::vector<double> scored(samples, 0.0);
  for (auto const& cycle : segmentation.cycles) {
    bool const chosen = selection.blocks.contains(cycle.block) &&
                        (selection.cycles.all() || (cycle.number > 0 && selection.cycles.contains(cycle.number)));
    if (chosen) mark(scored, cycle.first, cycle.last);
  }
  if (std::ranges::count(scored, 1.0) < 2)
    throw Error({.where = where,
                 .found = "no cycle of the record is among them",
                 .allowed = what_there_is(segmentation),
                 .advice = "isolaw inspect FILE, which numbers blocks and cycles"});
  return scored;
}

std::vector<double> block_numbers(Selection const& selection, Segmentation const& segmentation, std::size_t samples) {
  if (selection.blocks.all()) return {};
  std::vector<double> numbers(samples, 0.0);
  bool any = false;
  // Marks fitted blocks last: if two blocks meet in a sample, it belongs to the fitted block.
  for (bool const fitted : {false, true})
    for (auto const& cycle : segmentation.cycles) {
      bool const wanted = fitted || selection.predicted.contains(cycle.block);
      if (selection.blocks.contains(cycle.block) != fitted || !wanted) continue;
      any = any || !fitted;
      mark(numbers, cycle.first, cycle.last, cycle.block);
    }
  if (!any && !selection.predicted.all())
    throw Error({.where = fmt::format("--score-blocks {}", selection.predicted.text()),
                 .found = fmt::format("no block of the record is among them beside those of --fit-blocks {}",
                                      selection.blocks.text()),
                 .allowed = what_there_is(segmentation),
                 .advice = "isolaw inspect FILE, which numbers blocks and cycles"});
  return numbers;
}

}  // namespace isolaw::data
