#!/usr/bin/env bash
# Produces the numbers of docs/reliability.md by running the tests that take too long for every change. All parts
# together take about two hours on two cores. Arguments choose single parts. The script stops with an error at the first
# part that fails.
#   tools/reliability.sh [faults] [draws] [compilers] [sanitize] [sanitize-thread] [fuzz]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(faults draws compilers sanitize sanitize-thread fuzz)
: "${ISOLAW_KILLS:=200}" "${ISOLAW_DRAWS:=100000}" "${ISOLAW_FUZZ_SECONDS:=120}"
export ISOLAW_KILLS ISOLAW_DRAWS

# Runs a command and prints only those lines of its output that count tests. If the command fails, this also prints the
# last 50 lines.
run() {
  echo "== $*"
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  grep -E "tried|survived|draws|tests passed|FAILED|Failure" "$log" || true
  [ "$status" -eq 0 ] || { tail -50 "$log"; rm -f "$log"; return "$status"; }
  rm -f "$log"
}

for part in "${parts[@]}"; do
  case "$part" in
    faults)
      ./isolaw.sh build
      ISOLAW_FAULTS=all run build/release/tests/cli/cli_fault
      run build/release/tests/cli/cli --gtest_filter='Check*'
      ;;
    draws)
      ./isolaw.sh build
      run build/release/tests/laws/laws
      ;;
    compilers) run ./isolaw.sh compilers ;;
    sanitize | sanitize-thread)
      cmake --preset "$part"
      cmake --build --preset "$part"
      ISOLAW_KILLS=4 ISOLAW_DRAWS=200 run ctest --preset "$part" -j "$(nproc)"
      ;;
    fuzz)
      ISOLAW_PRESET=fuzz-fast ./isolaw.sh fuzz "$ISOLAW_FUZZ_SECONDS"
      ./isolaw.sh fuzz "$ISOLAW_FUZZ_SECONDS"
      ;;
    *)
      echo "reliability.sh: unknown part '$part'; allowed: faults, draws, compilers, sanitize, sanitize-thread, fuzz" >&2
      exit 2
      ;;
  esac
done
