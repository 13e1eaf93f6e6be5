#include "isolaw/campaign/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/grow.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::campaign {
namespace {

using Path = std::filesystem::path;

std::string again(std::optional<Part> const& part) {
  return part ? fmt::format("isolaw calibrate ... --part {} --fresh, which computes it again", text(*part))
              : std::string("the command that computed it, with --fresh");
}

void require_sound(Path const& file, std::optional<Part> const& part) {
  auto const faults = Store::integrity(file);
  if (!faults.empty())
    throw Error({.where = file.string(),
                 .found = fmt::format("is damaged: {}", faults.front()),
                 .allowed = "stores as isolaw left them",
                 .advice = "copying it once more, or " + again(part)});
}

// All numbers must come from one build and instruction set, or they would depend on which machine computed a part.
void require_one_maker(Path const& file, Contents const& part, Maker const& me) {
  for (auto const& maker : part.makers) {
    if (!same_build(maker, me))
      throw Error(
          {.where = file.string(),
           .found = fmt::format("computed by isolaw {}; this is {}, whose numbers may differ", text(maker), text(me)),
           .allowed = "parts and merge of one build",
           .advice =
               "the isolaw that computed all of them (isolaw --version tells its build), or " + again(part.part)});
    if (maker.instruction_set != me.instruction_set)
      throw Error(
          {.where = file.string(),
           .found = fmt::format("computed with instruction set {}; the merge runs with {}", maker.instruction_set,
                                me.instruction_set),
           .allowed = "one instruction set in all parts and in the merge, for one machine's numbers",
           .advice = fmt::format("ISOLAW_SIMD={} isolaw merge ..., where all parts are of it; or ISOLAW_SIMD={} {}",
                                 maker.instruction_set, me.instruction_set, again(part.part))});
  }
}

struct First {  // the first store, with which all others must agree
  Path file;
  Contents contents;  // without series
  std::vector<std::pair<std::string, std::string>> hashes;
};

void require_same_campaign(First const& first, Path const& file, Contents const& part) {
  auto const hashes = Store::hashes_of_beginning(file);
  if (hashes == first.hashes) return;
  auto there = first.contents, now = part;
  there.part = now.part = std::nullopt;
  auto found = obstacles(there, now, {.one = "in " + first.file.string(), .other = "in " + file.string()});
  if (found.empty())
    for (auto const& more : growth(there, now)) found.push_back("larger by " + more);
  if (found.empty())
    for (std::size_t i = 0; i < hashes.size(); ++i)
      if (hashes[i] != first.hashes[i])
        found.push_back(fmt::format("another {}", hashes[i].first == "meta" ? "title, or other rules or design values"
                                                                            : "table '" + hashes[i].first + "'"));
  throw Error({.where = file.string(),
               .found = fmt::format("of another campaign than {}: {}", first.file.string(), joined(found, "; ")),
               .allowed = "parts of one campaign: the same lot, settings and records",
               .advice = "leaving it out, or --part again with the command of the others"});
}

std::size_t runs_in(Path const& file) {
  std::size_t count = 0;
  Store::for_each_run(file, [&](std::size_t, std::string const&, int) { ++count; });
  return count;
}

void tell_missing(Path const& out, Merged& merged, MergeOptions const& options) {
  // The keys tell which runs are missing; the records are not needed for that.
  auto const campaign = Store::read_beginning(out);
  auto const runs = static_cast<std::size_t>(campaign.settings.runs);
  std::map<std::pair<std::size_t, std::string_view>, std::size_t> places;
  for (std::size_t s = 0; s < campaign.searches.size(); ++s)
    if (campaign.searches[s].refusal.empty()) places[{campaign.searches[s].device, campaign.searches[s].law}] = s;
  std::vector<bool> there(campaign.searches.size() * runs);
  std::size_t count = 0;
  Store::for_each_run(out, [&](std::size_t device, std::string const& law, int number) {
    there.at(places.at({device, law}) * runs + static_cast<std::size_t>(number) - 1) = true;
    ++count;
  });
  merged.missing = campaign.expected_runs() - count;
  if (merged.missing == 0) return;
  std::optional<RunAssignment> deal;
  if (merged.parts > 0) deal.emplace(Store::read_beginning_and_series(out), merged.parts);
  for (auto const& [key, place] : places)
    for (std::size_t run = 0; run < runs; ++run) {
      if (there[place * runs + run]) continue;
      int const number = static_cast<int>(run) + 1, part = deal ? deal->part_of(place, number) : 0;
      ++merged.missing_of[part];
      if (options.missing)
        options.missing({.device = campaign.devices.at(key.first).name,
                         .law = std::string(key.second),
                         .number = number,
                         .part = part});
    }
}

// The result of read(), or `otherwise` if it throws: a file that is to be replaced may be damaged or no store at all.
template <class Value, class Read>
Value value_or(Value otherwise, Read&& read) {
  try {
    return read();
  } catch (Error const&) {
    return otherwise;
  }
}

// A merge replaces no part, since that may be the only copy of its runs.
void refuse_part(Path const& out, std::optional<Part> const& part) {
  if (part)
    throw Error({.where = out.string(),
                 .found = fmt::format("is part {} itself", text(*part)),
                 .allowed = "a directory of its own for the whole campaign",
                 .advice = "another directory"});
}

bool has_every_run(Path const& file) {
  return runs_in(file) == Store::read_beginning(file).expected_runs();
}

}  // namespace

void refuse_absent(Path const& out, std::vector<std::string> const& absent) {
  if (absent.empty()) return;
  throw Error({.where = absent.front(),
               .found = "is not there, and " + out.string() + " was to be replaced",
               .allowed = "with --fresh, parts that are there",
               .advice = "its name as it is, or leaving it out"});
}

void refuse_to_replace_whole(Path const& out, Merged const& merged) {
  throw Error({.where = out.string(),
               .found = "has every run, and is left as it is: of what was to replace it " + missing_text(merged),
               .allowed = "with --fresh, every part, where what is replaced is whole",
               .advice = "the parts that are missing, or another directory"});
}

std::string missing_text(Merged const& merged) {
  if (merged.missing == 0) return {};
  std::vector<std::string> of_parts;
  for (auto const& [part, runs] : merged.missing_of)
    if (part > 0) of_parts.push_back(fmt::format("{} ({})", text(Part{part, merged.parts}), counted(runs, "run")));
  constexpr std::size_t shown = 20;
  return fmt::format("{} {} missing{}{}", counted(merged.missing, "run"), merged.missing == 1 ? "is" : "are",
                     of_parts.empty() ? "" : ", of part ", shortened(of_parts, shown));
}

Merged merge(Path const& out, std::vector<Path> const& parts, MergeOptions const& options) {
  auto const me = this_maker();
  Merged merged;
  std::optional<First> first;
  Path dealt;               // the first store that states the number of parts
  std::vector<Path> whole;  // stores that are not parts: their analyses are copied too
  auto const examine = [&](Path const& file) {
    auto const campaign = Store::read_beginning(file);
    require_sound(file, campaign.part);
    require_one_maker(file, campaign, me);
    if (first)
      require_same_campaign(*first, file, campaign);
    else
      first = First{file, campaign, Store::hashes_of_beginning(file)};
    if (!campaign.part) {
      if (file != out) whole.push_back(file);
      return;
    }
    if (merged.parts != 0 && merged.parts != campaign.part->of)
      throw Error(
          {.where = file.string(),
           .found = fmt::format("is part {}; {} is one of {}", text(*campaign.part), dealt.string(), merged.parts),
           .allowed = "parts of one deal",
           .advice = "merging those of each deal into the same directory, one after the other"});
    merged.parts = campaign.part->of;
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
  bool const exists = std::filesystem::exists(out), continues = exists && !options.fresh,
             replaces = exists && options.fresh;
  if (!continues && files.empty())
    throw Error({.where = parts.empty() ? out.string() : parts.front().string(),
                 .found = "no part is there",
                 .allowed = "directories of isolaw calibrate LOT --part K/N --out DIR"});
  if (replaces) {
    refuse_absent(out, merged.absent);
    refuse_part(out, value_or(std::optional<Part>(), [&] { return Store::read_beginning(out).part; }));
  }
  Store::remove_unfinished(out);
  if (continues) {
    if (!Store::is_plain(out)) Store::open(out).finish();
    examine(out);
    refuse_part(out, first->contents.part);
  }
  for (auto const& file : files) examine(file);
  // With --fresh the old store stays until everything that replaces it was checked and copied.
  auto const target = replaces ? sqlite::unfinished(out) : out;
  std::optional<sqlite::Unfinished> unfinished;
  if (replaces) unfinished.emplace(out);
  if (!continues) {
    auto beginning = Store::read_beginning_and_series(files.front());
    beginning.part.reset();
    Store::create(target, beginning, replaces ? std::function<void()>() : options.before_replacing).finish();
  }
  {
    auto store = Store::open(target);
    std::size_t done = 0;
    for (auto const& file : files) {
      auto const taken = store.take_runs(file);
      merged.added += taken.added;
      merged.there += taken.there;
      if (options.progress) options.progress(++done, files.size());
    }
    store.finish();
  }
  tell_missing(target, merged, options);
  if (merged.missing == 0) {
    // Analyses start from the best of all runs, so only analyses from complete stores are copied.
    auto const runs = whole.empty() ? 0 : runs_in(target);
    std::erase_if(whole, [&](Path const& file) { return runs_in(file) < runs; });
    if (!whole.empty()) {
      auto store = Store::open(target);
      for (auto const& file : whole) merged.analyses += store.take_analyses(file);
      store.finish();
    }
  }
  if (replaces) {
    if (merged.missing > 0 && value_or(false, [&] { return has_every_run(out); })) refuse_to_replace_whole(out, merged);
    if (options.before_replacing) options.before_replacing();
    sqlite::move_into_place(target, out);
  }
  return merged;
}

}  // namespace isolaw::campaign
