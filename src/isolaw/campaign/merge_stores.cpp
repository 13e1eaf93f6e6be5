#include "isolaw/campaign/merge_stores.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"

namespace isolaw::campaign {
namespace {

using Path = std::filesystem::path;

// Throws Error unless one build and instruction set computed all numbers, since others may compute different ones.
void require_one_maker(Path const& file, std::vector<Maker> const& makers, Maker const& me, std::string const& again) {
  for (auto const& maker : makers) {
    if (!same_build(maker, me))
      throw Error(
          {.where = file.string(),
           .found = fmt::format("computed by isolaw {}; this is {}, whose numbers may differ", text(maker), text(me)),
           .allowed = "parts and merge of one build",
           .advice = "the isolaw that computed all of them (isolaw --version tells its build), or " + again});
    if (maker.instruction_set != me.instruction_set)
      throw Error(
          {.where = file.string(),
           .found = fmt::format("computed with instruction set {}; the merge runs with {}", maker.instruction_set,
                                me.instruction_set),
           .allowed = "one instruction set in all parts and in the merge, for one machine's numbers",
           .advice = fmt::format("ISOLAW_SIMD={} isolaw merge ..., where all parts are of it; or ISOLAW_SIMD={} {}",
                                 maker.instruction_set, me.instruction_set, again)});
  }
}

void refuse_absent(Path const& out, std::vector<std::string> const& absent) {
  if (absent.empty()) return;
  throw Error({.where = absent.front(),
               .found = "is not there, and " + out.string() + " was to be replaced",
               .allowed = "with --fresh, parts that are there",
               .advice = "its name as it is, or leaving it out"});
}

// Returns read(), or `otherwise` if read() throws: a file that is to be replaced may be damaged or no store at all.
template <class Value, class Read>
Value value_or(Value otherwise, Read&& read) {
  try {
    return read();
  } catch (Error const&) {
    return otherwise;
  }
}

}  // namespace

void require_sound(Path const& file, std::string const& again) {
  auto const faults = sqlite::integrity(file);
  if (!faults.empty())
    throw Error({.where = file.string(),
                 .found = fmt::format("is damaged: {}", faults.front()),
                 .allowed = "stores as isolaw left them",
                 .advice = "copying it once more, or " + again});
}

std::string missing_text(MergeResult const& merged) {
  if (merged.missing == 0) return {};
  std::vector<std::string> of_parts;
  for (auto const& [part, runs] : merged.missing_of)
    if (part > 0) of_parts.push_back(fmt::format("{} ({})", text(Part{part, merged.parts}), counted(runs, "run")));
  constexpr std::size_t shown = 20;
  return fmt::format("{} {} missing{}{}", counted(merged.missing, "run"), merged.missing == 1 ? "is" : "are",
                     of_parts.empty() ? "" : ", of part ", shortened(of_parts, shown));
}

// Refuses to merge into a part, since this may be the only copy of the part's runs.
void Merge::refuse_part(Path const& out, std::optional<Part> const& part) const {
  if (part)
    throw Error({.where = out.string(),
                 .found = fmt::format("is part {} itself", text(*part)),
                 .allowed = fmt::format("a directory of its own for the whole {}", kind_.words().whole),
                 .advice = "another directory"});
}

MergeResult Merge::run(Path const& out, std::vector<Path> const& parts, bool fresh,
                       std::function<void()> const& before_replacing) {
  auto const& words = kind_.words();
  MergeResult merged;
  Path first;               // the first store, with which all others must agree
  Path dealt;               // the first store that states the number of parts
  std::vector<Path> whole;  // stores that are not parts
  auto const part_in = [&](Path const& file) { return kind_.read(file, read_part); };
  auto const examine = [&](Path const& file) {
    auto const part = part_in(file);
    auto const again =
        part ? fmt::format("{} ... --part {} --fresh, which computes it again", words.command, text(*part))
             : "the command that computed it, with --fresh";
    require_sound(file, again);
    require_one_maker(file, kind_.read(file, read_makers), me_, again);
    if (first.empty()) first = file;
    if (auto const found = differences(first, file); !found.empty())
      throw Error({.where = file.string(),
                   .found = fmt::format("of another {} than {}: {}", words.whole, first.string(), joined(found, "; ")),
                   .allowed = fmt::format("parts of one {}: {}", words.whole, words.same),
                   .advice = "leaving it out, or --part again with the command of the others"});
    if (!part) {
      if (file != out) whole.push_back(file);
      return;
    }
    if (merged.parts != 0 && merged.parts != part->total)
      throw Error({.where = file.string(),
                   .found = fmt::format("is part {}; {} is one of {}", text(*part), dealt.string(), merged.parts),
                   .allowed = "parts of one deal",
                   .advice = "merging those of each deal into the same directory, one after the other"});
    merged.parts = part->total;
    if (dealt.empty()) dealt = file;
  };
  std::vector<Path> files;
  for (auto const& part : parts) {
    std::error_code unknown;
    if (std::filesystem::exists(part, unknown))
      files.push_back(part);
    else
      merged.absent.push_back(part.string());
  }
  bool const exists = std::filesystem::exists(out), continues = exists && !fresh, replaces = exists && fresh;
  if (!continues && files.empty())
    throw Error({.where = parts.empty() ? out.string() : parts.front().string(),
                 .found = "no part is there",
                 .allowed = fmt::format("directories of {} {} --part K/N --out DIR", words.command, words.input)});
  if (replaces) {
    merged.lost = kind_.lost_with(out);
    refuse_absent(out, merged.absent);
    refuse_part(out, value_or(std::optional<Part>(), [&] { return part_in(out); }));
  }
  sqlite::remove_unfinished(out);
  if (continues) {
    kind_.fold_log(out);
    examine(out);
    refuse_part(out, part_in(out));
  }
  for (auto const& file : files) examine(file);
  // With --fresh the old store stays until its replacement was checked and copied completely.
  auto const target = replaces ? sqlite::unfinished(out) : out;
  std::optional<sqlite::Unfinished> unfinished;
  if (replaces) unfinished.emplace(out);
  if (!continues) create(target, files.front(), replaces ? std::function<void()>() : before_replacing);
  copy_runs(target, files, merged);
  tell_missing(target, merged);
  if (merged.missing == 0) complete(target, whole, merged);
  if (replaces) {
    if (merged.missing > 0 && value_or(false, [&] { return has_every_run(out); }))
      throw Error({.where = out.string(),
                   .found = "has every run, and is left as it is: of what was to replace it " + missing_text(merged),
                   .allowed = "with --fresh, every part, where what is replaced is whole",
                   .advice = "the parts that are missing, or another directory"});
    if (before_replacing) before_replacing();
    sqlite::move_into_place(target, out);
  }
  return merged;
}

}  // namespace isolaw::campaign
