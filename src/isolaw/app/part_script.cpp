#include "isolaw/app/part_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/shell.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::app {
namespace {

// Slower processors, searches that take longer than others, a share of the machine.
constexpr double time_margin = 3.0;
constexpr double least_minutes = 10.0;

std::string quoted(std::string const& word) {
  return shell_quoted({word});
}

std::string parts_of(PartScript const& of) {
  return of.out.string() + ".parts";
}

int minutes(double seconds) {
  return static_cast<int>(std::ceil(std::max(least_minutes, time_margin * seconds / 60.0)));
}

std::string in_words(double seconds) {
  return seconds < 120.0    ? fmt::format("{:.0f} s", std::max(1.0, seconds))
         : seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                            : fmt::format("{:.1f} h", seconds / 3600.0);
}

// What is said of the whole, as comments of shell and make alike.
std::string heading(PartScript const& of, std::string_view how) {
  auto const& needs = of.needs;
  return fmt::format(
      "# {} of {}, merged into {}. {}\n"
      "# After any loss the same again: what is there of a part is not computed again, but seen to be of these settings and\n"
      "# records. Where it is not, nothing is merged.\n"
      "# In all likelihood, as measured where this was printed: {} a part on {}, {} for the analyses on as many.\n",
      counted(of.parts, "part"), printable(of.title), printable(of.out.string()), how, in_words(needs.part_s),
      counted(of.jobs, "thread"), in_words(needs.merge_s));
}

std::string program_line(PartScript const& of, std::vector<std::string> words) {
  words.insert(words.begin(), of.program);
  return shell_quoted(words);
}

// Scratch directories of one campaign are its own.
std::string fingerprint(PartScript const& of) {
  return sha256(shell_quoted(of.words) + of.directory.string() + of.out.string() + std::to_string(of.parts))
      .substr(0, 12);
}

// What both shell scripts do.
std::string shell_functions(PartScript const& of) {
  auto merge = of.merge;
  merge.insert(merge.begin(), "merge");
  return fmt::format(
      R"sh(set -eu
ISOLAW_SCRIPT=$(cd "$(dirname "$0")" && pwd)/$(basename "$0")
export ISOLAW_SCRIPT
# One instruction set on all machines, or last digits would differ: parts of two are not merged.
export ISOLAW_SIMD={instruction_set}
cd {directory}
out={out}
parts={parts}
case $parts in /*) ;; *) parts=$PWD/$parts ;; esac
count={count}
jobs=${{ISOLAW_JOBS:-{jobs}}}  # threads of a part, and of the merge
# A disk of the machine itself.
scratch=${{ISOLAW_SCRATCH:-${{SLURM_TMPDIR:-${{TMPDIR:-/tmp}}}}}}/isolaw-$(id -u)-{fingerprint}

# What lies on the machine's disk, unless another process works there.
clear_disk() {{
  [ ! -d "$disk" ] || flock -n "$disk" rm -rf "$disk" 2>/dev/null || :
  rmdir "$scratch" 2>/dev/null || :
}}

compute() {{
  {program} {command} --part "$1/$count" --out "$disk" --jobs "$jobs" {words} &
  child=$!
  trap 'kill "$child" 2>/dev/null || :' TERM INT HUP
  code=0
  wait "$child" || code=$?
  while kill -0 "$child" 2>/dev/null; do  # a signal ended the wait, not yet the child
    code=0
    wait "$child" || code=$?
  done
  trap - TERM INT HUP
  return "$code"
}}

# Part $1, on the machine's own disk, whatever is there of it: the program alone can tell whether that is whole, and of
# these settings and records. Of a whole one it takes as long as to read the lot. It has its name while it is known to be
# whole, and is called unfinished before.
part() {{
  kept=$parts/$1
  disk=$scratch/$1
  mkdir -p "$kept" || return 1
  rm -f "$kept/refused"
  if [ -e "$kept/{store}" ]; then
    mv "$kept/{store}" "$kept/unfinished" || return 1
    clear_disk  # what a try that was killed left here is no more than that
  fi
  (umask 077 && {{ mkdir -p "$disk" 2>/dev/null || mkdir -p "$disk"; }}) || return 1
  [ -O "$scratch" ] || {{ echo "$scratch is somebody else's: ISOLAW_SCRATCH names another disk" >&2; return 1; }}
  from=disk  # where a try was killed
  if [ ! -s "$disk/{store}" ]; then
    from=kept
    rm -f "$disk/{store}" "$disk/{store}"-*
    [ ! -s "$kept/unfinished" ] || cp "$kept/unfinished" "$disk/{store}" || return 1
  fi
  code=0
  compute "$1" || code=$?
  if [ "$code" -eq 2 ] && [ "$from" = disk ] && flock -n "$disk" rm -rf "$disk" 2>/dev/null; then
    (umask 077 && mkdir -p "$disk") || return 1
    [ ! -s "$kept/unfinished" ] || cp "$kept/unfinished" "$disk/{store}" || return 1
    code=0
    compute "$1" || code=$?
  fi
  if [ "$code" -eq 2 ]; then
    clear_disk
    : >"$kept/refused"
    echo "part $1 was refused, as said above, and nothing is merged. Once that is mended the same again; where what is" \
      "there of it is damaged, or of other settings or records: rm -r '$kept' computes it anew" >&2
    return 2
  fi
  name={store}
  [ "$code" -eq 0 ] || name=unfinished
  if [ -e "$disk/{store}" ] && [ ! -e "$disk/{store}-wal" ] && [ ! -e "$disk/{store}-journal" ]; then
    cmp -s "$disk/{store}" "$kept/unfinished" ||
      {{ cp "$disk/{store}" "$kept/arriving.$$" && mv "$kept/arriving.$$" "$kept/unfinished"; }} || return 1
    [ "$name" = unfinished ] || mv "$kept/unfinished" "$kept/$name" || return 1
    clear_disk
  fi
  [ "$code" -ne 0 ] || rm -f "$kept"/arriving.*
  return "$code"
}}

# Numbers of all parts; of those that are not there; of those that the program refused.
all() {{
  number=1
  while [ "$number" -le "$count" ]; do
    echo "$number"
    number=$((number + 1))
  done
}}
missing() {{ all | while read -r number; do [ -e "$parts/$number/{store}" ] || echo "$number"; done; }}
refused() {{ all | while read -r number; do [ ! -e "$parts/$number/refused" ] || echo "$number"; done; }}

merge() {{
  turned_away=$(refused)
  if [ -n "$turned_away" ]; then
    echo "not merged, since parts were refused:" $turned_away >&2
    echo "why, and what to do:" >&2
    for number in $turned_away; do echo "  $parts/$number.log"; done | head -n 5 >&2
    return 2
  fi
  set --
  number=1
  while [ "$number" -le "$count" ]; do
    set -- "$@" "$parts/$number"
    number=$((number + 1))
  done
  {merge} "$out" --jobs "$jobs" "$@"
}}
)sh",
      fmt::arg("instruction_set", quoted(of.instruction_set)), fmt::arg("directory", quoted(of.directory.string())),
      fmt::arg("out", quoted(of.out.string())), fmt::arg("parts", quoted(parts_of(of))), fmt::arg("count", of.parts),
      fmt::arg("jobs", of.jobs), fmt::arg("fingerprint", fingerprint(of)), fmt::arg("program", quoted(of.program)),
      fmt::arg("command", of.command), fmt::arg("store", of.store), fmt::arg("words", shell_quoted(of.words)),
      fmt::arg("merge", program_line(of, std::move(merge))));
}

std::string for_slurm(PartScript const& of) {
  constexpr std::uint64_t mebibyte = 1 << 20;
  return "#!/bin/sh\n" + heading(of, "On a machine that submits jobs: sh THIS_FILE") +
         "# $ISOLAW_SBATCH: options of sbatch for every job, such as an account; $ISOLAW_SCRATCH: a disk of the nodes.\n" +
         shell_functions(of) +
         fmt::format(R"sh(
# The array of these parts, and after it, however it ends, the merge; which submits again what is missing still.
submit() {{
  mkdir -p "$parts"
  array=$1
  set -- --parsable --mem={memory} --cpus-per-task="$jobs" --chdir="$parts" ${{ISOLAW_SBATCH:-}}
  job=$(sbatch "$@" --job-name=isolaw --array="$array" --requeue --open-mode=append --time={part_minutes} \
    --signal=B:TERM@120 --output=%a.log --wrap 'exec sh "$ISOLAW_SCRIPT" part "$SLURM_ARRAY_TASK_ID"')
  echo "parts $array: job ${{job%%;*}}"
  job=$(sbatch "$@" --dependency=afterany:"${{job%%;*}}" --job-name=isolaw-merge --requeue --open-mode=append \
    --time={merge_minutes} --output=merge.log --wrap 'exec sh "$ISOLAW_SCRIPT" merge')
  echo "merge: job ${{job%%;*}}, which says in $parts/merge.log what became of it"
}}

case ${{1:-submit}} in
  submit) submit "1-$count" ;;
  part) part "$2" ;;
  merge)
    ISOLAW_TRY=$((${{ISOLAW_TRY:-0}} + 1))
    export ISOLAW_TRY
    left=$(missing | tr '\n' ',')
    if [ -n "$left" ] && [ -z "$(refused)" ] && [ "$ISOLAW_TRY" -le 3 ]; then
      echo "missing: parts ${{left%,}}, submitted again"
      submit "${{left%,}}"
    else
      merge
    fi
    ;;
  *) echo "sh $0 [submit | part NUMBER | merge]" >&2; exit 2 ;;
esac
)sh",
                     fmt::arg("memory", (of.needs.memory_bytes + mebibyte - 1) / mebibyte),
                     fmt::arg("part_minutes", minutes(of.needs.part_s)),
                     fmt::arg("merge_minutes", minutes(of.needs.merge_s)));
}

std::string for_parallel(PartScript const& of) {
  return "#!/bin/sh\n" + heading(of, "With GNU parallel: sh THIS_FILE [options of parallel, such as --jobs 8]") +
         shell_functions(of) +
         R"sh(
case ${1:-} in
  part)
    code=0
    part "$2" 2>"$parts/$2.log" || code=$?
    cat "$parts/$2.log" >&2
    exit "$code"
    ;;
  merge) merge ;;
  *)
    mkdir -p "$parts"
    # What a part leaves undone, the merge names.
    all | PARALLEL_SHELL=/bin/sh parallel "$@" sh '"$ISOLAW_SCRIPT"' part {} || echo "not every part is there" >&2
    merge
    ;;
esac
)sh";
}

// In a recipe.
std::string for_make(std::string const& text) {
  std::string made;
  for (char const c : text) made += c == '$' ? std::string("$$") : std::string(1, c);
  return made;
}

std::string makefile(PartScript const& of) {
  auto merge = of.merge;
  merge.insert(merge.begin(), {"merge", of.out.string(), "--jobs", std::to_string(of.jobs)});
  auto const cd = "cd " + for_make(quoted(of.directory.string()));
  std::string names;
  for (int number = 1; number <= of.parts; ++number) {
    names += fmt::format(" {}part-{}", number % 16 == 0 ? "\\\n  " : "", number);
    merge.push_back(fmt::format("{}/{}", parts_of(of), number));
  }
  return heading(of, "With make: make -f THIS_FILE -j 8 -k") +
         fmt::format(R"make(SHELL = /bin/sh
# One instruction set on all machines, or last digits would differ: parts of two are not merged.
export ISOLAW_SIMD = {instruction_set}
parts ={names}
.PHONY: merge $(parts)
merge: $(parts)
	{cd} && {merge}
# A part that is there ends at once; one of other settings or records is refused, and nothing merged.
$(parts): part-%:
	{cd} && {program} {command} --jobs {jobs} --part $*/{count} --out {out}/$* {words}
)make",
                     fmt::arg("instruction_set", of.instruction_set), fmt::arg("names", names), fmt::arg("cd", cd),
                     fmt::arg("merge", for_make(program_line(of, merge))),
                     fmt::arg("program", for_make(quoted(of.program))), fmt::arg("command", of.command),
                     fmt::arg("words", for_make(shell_quoted(of.words))), fmt::arg("jobs", of.jobs),
                     fmt::arg("count", of.parts), fmt::arg("out", for_make(quoted(parts_of(of)))));
}

}  // namespace

std::string part_script(std::string_view kind, PartScript const& of) {
  auto words = of.words;
  words.insert(words.end(), {of.program, of.directory.string(), of.out.string()});
  for (auto const& word : words)
    if (word.find('\n') != std::string::npos)
      throw Error({.where = in_quotes(word), .found = "holds a line break", .allowed = "names of one line"});
  if (kind == "slurm") return for_slurm(of);
  if (kind == "parallel") return for_parallel(of);
  if (kind == "make") return makefile(of);
  throw Error({.where = "--to", .found = in_quotes(kind), .allowed = joined(part_script_kinds)});
}

}  // namespace isolaw::app
