#!/usr/bin/env bash
# The pages that the program writes of itself: tools/reference.sh ISOLAW DIR makes DIR/laws.md and DIR/cli.md.
set -euo pipefail
isolaw=$1 out=$2
mkdir -p "$out"
"$isolaw" laws --markdown >"$out/laws.md"
{
  printf '# The command line\n\nWhat `isolaw COMMAND --help` prints, by `./isolaw.sh docs`. Exit codes: 0 done; 1 done, with something refused, failed,\n'
  printf 'interrupted or outside a limit; 2 wrong usage or nothing usable; 3 internal error. Results go to standard output, messages and progress\nto standard error.\n'
  printf '\n```\n%s\n```\n' "$("$isolaw" --help)"
  for command in calibrate init inspect report rules check sample export simulate laws example bench; do
    printf '\n## %s\n\n```\n%s\n```\n' "$command" "$("$isolaw" "$command" --help)"
  done
} | sed -E 's/[[:space:]]+$//' >"$out/cli.md"
