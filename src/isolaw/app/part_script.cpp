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

// Estimated times are multiplied by this factor, because the processors may be slower, searches may take longer, and
// other jobs may run on the same machine.
constexpr double time_margin = 3.0;
constexpr double least_minutes = 10.0;

std::string quoted(std::string const& word) {
  return shell_quoted({word});
}

std::string parts_of(PartScript const& script) {
  return script.out.string() + ".parts";
}

int minutes(double seconds) {
  return static_cast<int>(std::ceil(std::max(least_minutes, time_margin * seconds / 60.0)));
}

std::string in_words(double seconds) {
  return seconds < 120.0    ? fmt::format("{:.0f} s", std::max(1.0, seconds))
         : seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                            : fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string heading(PartScript const& script, std::string_view how) {
  auto const& needs = script.needs;
  return fmt::format(
      "# {} of {}, merged into {}. {}\n"
      "# After an interruption run the same again: finished work of a part is kept if it belongs to these settings and\n"
      "# records. If it does not, nothing is merged.\n"
      "# Estimated on the machine that printed this: {} for each part on {}, {} for the analyses on as many.\n",
      counted(script.parts, "part"), printable(script.title), printable(script.out.string()), how,
      in_words(needs.part_s), counted(script.jobs, "thread"), in_words(needs.merge_s));
}

std::string program_line(PartScript const& script, std::vector<std::string> words) {
  words.insert(words.begin(), script.program);
  return shell_quoted(words);
}

std::string fingerprint(PartScript const& script) {
  return sha256(shell_quoted(script.words) + script.directory.string() + script.out.string() +
                std::to_string(script.parts))
      .substr(0, 12);
}

std::string shell_functions(PartScript const& script) {
  auto merge = script.merge;
  merge.insert(merge.begin(), "merge");
  return fmt::format(
      R"sh(set -eu
ISOLAW_SCRIPT=$(cd "$(dirname "$0")" && pwd)/$(basename "$0")
export ISOLAW_SCRIPT
# The same instruction set on all machines: otherwise last digits differ, and the parts cannot be merged.
export ISOLAW_SIMD={instruction_set}
cd {directory}
out={out}
parts={parts}
case $parts in /*) ;; *) parts=$PWD/$parts ;; esac
count={count}
jobs=${{ISOLAW_JOBS:-{jobs}}}  # threads of a part, and of the merge
# A local disk of the machine.
scratch=${{ISOLAW_SCRATCH:-${{SLURM_TMPDIR:-${{TMPDIR:-/tmp}}}}}}/isolaw-$(id -u)-{fingerprint}

# Clears the local disk, unless another process works there.
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
  while kill -0 "$child" 2>/dev/null; do  # a signal ended the wait but not yet the child
    code=0
    wait "$child" || code=$?
  done
  trap - TERM INT HUP
  return "$code"
}}

# Computes part $1 on the local disk, starting from whatever exists of it: only the program can tell whether that is
# complete and belongs to these settings and records. For a complete part this takes as long as reading the lot. The
# store carries its name only while it is known to be complete; before that it is called unfinished.
part() {{
  kept=$parts/$1
  disk=$scratch/$1
  mkdir -p "$kept" || return 1
  rm -f "$kept/refused"
  if [ -e "$kept/{store}" ]; then
    mv "$kept/{store}" "$kept/unfinished" || return 1
    clear_disk  # a killed attempt left nothing more complete here
  fi
  (umask 077 && {{ mkdir -p "$disk" 2>/dev/null || mkdir -p "$disk"; }}) || return 1
  [ -O "$scratch" ] || {{ echo "$scratch belongs to another user; set ISOLAW_SCRATCH to another disk" >&2; return 1; }}
  from=disk  # a killed attempt left work there
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
    echo "part $1 was refused for the reason above, and nothing is merged. Fix that and run the same again; if its files" \
      "are damaged or belong to other settings or records, rm -r '$kept' has it computed anew" >&2
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

# The numbers of all parts, of the missing ones, and of those that the program refused.
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
      fmt::arg("instruction_set", quoted(script.instruction_set)),
      fmt::arg("directory", quoted(script.directory.string())), fmt::arg("out", quoted(script.out.string())),
      fmt::arg("parts", quoted(parts_of(script))), fmt::arg("count", script.parts), fmt::arg("jobs", script.jobs),
      fmt::arg("fingerprint", fingerprint(script)), fmt::arg("program", quoted(script.program)),
      fmt::arg("command", script.command), fmt::arg("store", script.store),
      fmt::arg("words", shell_quoted(script.words)), fmt::arg("merge", program_line(script, std::move(merge))));
}

std::string for_slurm(PartScript const& script) {
  constexpr std::uint64_t mebibyte = 1 << 20;
  return "#!/bin/sh\n" + heading(script, "On a machine that submits jobs: sh THIS_FILE") +
         "# $ISOLAW_SBATCH: options of sbatch for every job, such as an account; $ISOLAW_SCRATCH: a disk of the nodes.\n" +
         shell_functions(script) +
         fmt::format(R"sh(
# Submits the array of these parts and, to run after it however it ends, the merge, which resubmits missing parts.
submit() {{
  mkdir -p "$parts"
  array=$1
  set -- --parsable --mem={memory} --cpus-per-task="$jobs" --chdir="$parts" ${{ISOLAW_SBATCH:-}}
  job=$(sbatch "$@" --job-name=isolaw --array="$array" --requeue --open-mode=append --time={part_minutes} \
    --signal=B:TERM@120 --output=%a.log --wrap 'exec sh "$ISOLAW_SCRIPT" part "$SLURM_ARRAY_TASK_ID"')
  echo "parts $array: job ${{job%%;*}}"
  job=$(sbatch "$@" --dependency=afterany:"${{job%%;*}}" --job-name=isolaw-merge --requeue --open-mode=append \
    --time={merge_minutes} --output=merge.log --wrap 'exec sh "$ISOLAW_SCRIPT" merge')
  echo "merge: job ${{job%%;*}}, whose messages go to $parts/merge.log"
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
                     fmt::arg("memory", (script.needs.memory_bytes + mebibyte - 1) / mebibyte),
                     fmt::arg("part_minutes", minutes(script.needs.part_s)),
                     fmt::arg("merge_minutes", minutes(script.needs.merge_s)));
}

std::string for_parallel(PartScript const& script) {
  return "#!/bin/sh\n" + heading(script, "With GNU parallel: sh THIS_FILE [options of parallel, such as --jobs 8]") +
         shell_functions(script) +
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
    # The merge lists what parts leave undone.
    all | PARALLEL_SHELL=/bin/sh parallel "$@" sh '"$ISOLAW_SCRIPT"' part {} || echo "not every part is there" >&2
    merge
    ;;
esac
)sh";
}

std::string for_make(std::string const& text) {
  std::string escaped;
  for (char const c : text) escaped += c == '$' ? std::string("$$") : std::string(1, c);
  return escaped;
}

std::string makefile(PartScript const& script) {
  auto merge = script.merge;
  merge.insert(merge.begin(), {"merge", script.out.string(), "--jobs", std::to_string(script.jobs)});
  auto const cd = "cd " + for_make(quoted(script.directory.string()));
  std::string names;
  for (int number = 1; number <= script.parts; ++number) {
    names += fmt::format(" {}part-{}", number % 16 == 0 ? "\\\n  " : "", number);
    merge.push_back(fmt::format("{}/{}", parts_of(script), number));
  }
  return heading(script, "With make: make -f THIS_FILE -j 8 -k") +
         fmt::format(R"make(SHELL = /bin/sh
# The same instruction set on all machines: otherwise last digits differ, and the parts cannot be merged.
export ISOLAW_SIMD = {instruction_set}
parts ={names}
.PHONY: merge $(parts)
merge: $(parts)
	{cd} && {merge}
# A finished part ends at once; one of other settings or records is refused, and nothing is merged.
$(parts): part-%:
	{cd} && {program} {command} --jobs {jobs} --part $*/{count} --out {out}/$* {words}
)make",
                     fmt::arg("instruction_set", script.instruction_set), fmt::arg("names", names), fmt::arg("cd", cd),
                     fmt::arg("merge", for_make(program_line(script, merge))),
                     fmt::arg("program", for_make(quoted(script.program))), fmt::arg("command", script.command),
                     fmt::arg("words", for_make(shell_quoted(script.words))), fmt::arg("jobs", script.jobs),
                     fmt::arg("count", script.parts), fmt::arg("out", for_make(quoted(parts_of(script)))));
}

}  // namespace

std::string part_script(std::string_view kind, PartScript const& script) {
  auto words = script.words;
  words.insert(words.end(), {script.program, script.directory.string(), script.out.string()});
  for (auto const& word : words)
    if (word.find('\n') != std::string::npos)
      throw Error({.where = in_quotes(word), .found = "holds a line break", .allowed = "names of one line"});
  if (kind == "slurm") return for_slurm(script);
  if (kind == "parallel") return for_parallel(script);
  if (kind == "make") return makefile(script);
  throw Error({.where = "--to", .found = in_quotes(kind), .allowed = joined(part_script_kinds)});
}

}  // namespace isolaw::app
