#!/usr/bin/env bash
# Writes the reference that the program generates: tools/reference.sh ISOLAW DIR makes DIR/docs/laws.md, DIR/docs/cli.md
# and, with the keywords of the option tables, DIR/python/isolaw/__init__.pyi.
set -euo pipefail
shopt -s inherit_errexit
isolaw=$1 docs=$2/docs stub=python/isolaw/__init__.pyi
mkdir -p "$docs" "$2/${stub%/*}"
"$isolaw" laws --markdown >"$docs/laws.md"
{
  printf '# The command line\n\nWhat `isolaw COMMAND --help` prints, by `./isolaw.sh docs`. Exit codes: 0 done; 1 done, with something refused, failed,\n'
  printf 'interrupted or outside a limit; 2 wrong usage or nothing usable; 3 internal error. Results go to standard output, messages and progress\nto standard error.\n'
  printf '\n```\n%s\n```\n' "$("$isolaw" --help)"
  for command in calibrate init inspect report merge parts rules check sample export simulate building laws example bench; do
    printf '\n## %s\n\n```\n%s\n```\n' "$command" "$("$isolaw" "$command" --help)"
  done
} | sed -E 's/[[:space:]]+$//' >"$docs/cli.md"

# In the stub, replaces the text below each comment `isolaw keywords ...` by the output of that command.
written=$(
  keep=yes
  while IFS= read -r line; do
    case $line in *'# the end of what it wrote') keep=yes ;; esac
    [ $keep = yes ] && printf '%s\n' "$line"
    case $line in *'# isolaw keywords '*)
      keep=no
      read -ra words <<<"${line#*# isolaw }"
      "$isolaw" "${words[@]}" | sed "s/^/${line%%#*}/"
      ;;
    esac
  done <"$(dirname "${BASH_SOURCE[0]}")/../$stub"
)
printf '%s\n' "$written" >"$2/$stub"
