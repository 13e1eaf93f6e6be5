// Merges the parts of a campaign or of a building study into one store. Before that it checks that the parts belong to
// the same campaign or study and were computed by one build with one instruction set.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/campaign/store_kind.hpp"

namespace isolaw::campaign {

struct MergeResult {
  std::size_t added = 0, already_there = 0;  // `already_there`: runs that were in `out` before or came twice
  std::size_t analyses = 0;                  // the number of analyses copied
  std::size_t missing = 0;
  int parts = 0;                          // the number of parts; 0 if no store states it
  std::vector<std::string> absent;        // given paths that do not exist
  std::string lost = {};                  // a sentence if `fresh` replaced a damaged or empty file; else empty
  std::map<int, std::size_t> missing_of;  // missing runs by the part that should hold them; part 0 if that is not known
};
// Text such as "5 runs are missing, of part 4/7 (4 runs), 5/7 (1 run)"; empty if no run is missing.
std::string missing_text(MergeResult const& merged);
// Throws Error for a file in which SQLite finds faults. `again` tells the user how to compute the file once more.
void require_sound(std::filesystem::path const& file, std::string const& again);

class Merge {
 public:
  using Path = std::filesystem::path;

  Merge(StoreKind const& kind, Maker me) : kind_(kind), me_(std::move(me)) {}
  Merge(Merge const&) = delete;
  Merge& operator=(Merge const&) = delete;
  virtual ~Merge() = default;

  // Adds the runs of the stores `parts`, in any order and possibly repeated, to the store `out`, and creates `out` if
  // it is missing. If `fresh`, a new store replaces `out` after all parts were checked and copied. Calls
  // before_replacing() before a new store takes the name `out`. All parts are checked before the first is copied. Each
  // part is copied in one transaction, so the same call completes a merge that was stopped. Throws Error for a store
  // that is damaged or of another campaign or study, build or instruction set, for runs that contradict each other, and
  // if `out` is a part itself or would lose runs.
  MergeResult run(Path const& out, std::vector<Path> const& parts, bool fresh,
                  std::function<void()> const& before_replacing);

 protected:
  // Returns a text for each difference between the campaigns or studies in `first` and `file`.
  virtual std::vector<std::string> differences(Path const& first, Path const& file) = 0;
  // Makes a store with the settings and inputs of the store `first`. It belongs to no part and has no runs.
  virtual void create(Path const& file, Path const& first, std::function<void()> const& before_replacing) = 0;
  virtual void copy_runs(Path const& to, std::vector<Path> const& parts, MergeResult& merged) = 0;
  virtual void tell_missing(Path const& file, MergeResult& merged) = 0;  // sets `missing` and `missing_of`
  virtual bool has_every_run(Path const& file) = 0;
  // Called when no run is missing, to complete the merged store `file`, for example with analyses. `whole` lists the
  // given stores that are not parts.
  virtual void complete(Path const& file, std::vector<Path> const& whole, MergeResult& merged) = 0;

 private:
  void refuse_part(Path const& out, std::optional<Part> const& part) const;

  StoreKind const& kind_;
  Maker me_;
};

}  // namespace isolaw::campaign
