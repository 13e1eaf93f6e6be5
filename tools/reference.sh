#!/usr/bin/env bash
# The program writes the files that describe it: tools/reference.sh ISOLAW DIR makes DIR/docs/laws.md, DIR/docs/cli.md
# and DIR/python/isolaw/__init__.pyi, the stub with the keywords of the option tables.
set -euo pipefail
shopt -s inherit_errexit
isolaw=$1 docs=$2/docs stub=python/isolaw/__init__.pyi
mkdir -p "$docs" "$2/${stub%/*}"
"$isolaw" laws --markdown >"$docs/laws.md"
"$isolaw" reference >"$docs/cli.md"

# Below each comment `isolaw keywords ...` of the stub, the lines are replaced by what this command prints.
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
