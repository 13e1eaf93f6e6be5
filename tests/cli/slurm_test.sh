#!/usr/bin/env bash
# Runs a campaign on a real Slurm with the script that `isolaw parts --to slurm` writes. The test submits the array of
# jobs and kills the node midway. Slurm must queue the lost jobs again, and the merged campaign must equal byte by byte
# one from one machine. The test then deletes parts: the script, or its merge job alone, must submit them again. At last
# the test offers parts with other settings, which must be refused.
# Usage: slurm_test.sh ISOLAW TOOLS. Exit code 77 means skipped; the reason is printed.
set -euo pipefail
isolaw=$1 cluster=$2/slurm_here.sh
if ! why=$("$cluster" possible); then
  echo "SKIPPED, Slurm was not tested: $why"
  exit 77
fi
work=$(mktemp -d)
trap '"$cluster" stop "$work/slurm" || true; rm -rf "$work"' EXIT
cd "$work"
fail() {
  echo "FAILED: $*" >&2
  squeue >&2 || true
  tail -n 20 slurm/slurmctld.log out*.parts/*.log "out 'put.parts"/*.log >&2 || true
  exit 1
}
# Repeats a command every half second until it succeeds or the given seconds have passed.
wait_for() {
  local seconds=$1 asked
  shift
  for ((asked = 0; asked < 2 * seconds; ++asked)); do
    "$@" && return
    sleep 0.5
  done
  fail "not within $seconds s: $*"
}

campaign=(--laws 'abe,hwang-wu' --method ga --runs 4 --population 60 --generations 150 --samples-per-cycle 60
  --analysis none --figures none)
out="out 'put"
"$isolaw" example lot >/dev/null
"$isolaw" parts lot/lot.toml 8 --to slurm "${campaign[@]}" --out "$out" >"the script"
"$cluster" start "$work/slurm"
. slurm/env
export ISOLAW_SCRATCH=$work/disk
sh "the script"

some_are_done_and_some_are_not() {
  [ -e "$(find "$out.parts" -name campaign.sqlite | head -n 1)" ] && squeue -h -t running -o %j | grep -q -x isolaw
}
wait_for 120 some_are_done_and_some_are_not
"$cluster" kill-node "$work/slurm"
[ -z "$(squeue -h -t running)" ] || fail "the node is lost, and something runs"
[ ! -e "$out/summary.json" ] || fail "merged before it was computed"
before=$(find "$out.parts" -name campaign.sqlite | wc -l)
[ "$before" -lt 8 ] || fail "nothing was left to lose"
"$cluster" start-node "$work/slurm"
# Slurm may wait two minutes before it starts a job that it queued again. This function makes Slurm start the job at
# once.
sooner() {
  local job
  for job in $(squeue -h -r -t pending -n isolaw -o %A); do
    scontrol update "jobid=$job" starttime=now 2>/dev/null || true
  done
}
merged() {
  sooner
  [ -z "$(squeue -h)" ]
}
wait_for 240 merged
grep -q '80 runs copied' "$out.parts/merge.log" || fail "not merged"
"$isolaw" calibrate lot/lot.toml "${campaign[@]}" --out one >/dev/null || fail "one machine"
for file in campaign.sqlite summary.json report.html; do
  cmp "$out/$file" "one/$file" || fail "$file is not that of one machine"
done

# The test deletes parts 3 and 7 and runs the script again. The script submits a job for every part, and the jobs of
# existing parts end at once. Later the test deletes part 5 and runs only the merge job, which must submit only part 5.
rm -r "$out" "$out.parts/3" "$out.parts/7"
again=$(sh "the script")
case $again in *"parts 1-8: job "*) ;; *) fail "not every part: $again" ;; esac
wait_for 120 merged
cmp "$out/campaign.sqlite" one/campaign.sqlite || fail "not that of one machine"
rm -r "$out" "$out.parts/5"
sbatch --parsable --chdir="$out.parts" --output=merge.log --wrap "exec sh '$work/the script' merge" >/dev/null
wait_for 120 merged
cmp "$out/campaign.sqlite" one/campaign.sqlite || fail "a merge did not submit what was missing"
grep -q 'missing: parts 5, submitted again' "$out.parts/merge.log" || fail "more than what was missing"

# A script with another seed finds parts of the campaign with seed 1 under the same names and must refuse them.
"$isolaw" parts lot/lot.toml 8 --to slurm "${campaign[@]}" --seed 9 --out "$out" >"another script"
sh "another script" >/dev/null
wait_for 120 merged
[ -z "$(find "$work/disk" -mindepth 1)" ] || fail "left on the node: $(find "$work/disk" -mindepth 1)"
grep -q -F "$out.parts/2.log" "$out.parts/merge.log" || fail "a merge of refused parts does not name their logs"
grep -q 'seed: 1 there, 9 now' "$out.parts/2.log" || fail "why a part was refused"
cmp "$out/campaign.sqlite" one/campaign.sqlite || fail "parts of other settings were merged"
echo "8 parts, $before of them done when the node was lost: merged to the bytes of one machine"
