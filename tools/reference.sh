#!/usr/bin/env bash
# Lets the program write the files that describe it. `tools/reference.sh ISOLAW DIR` writes DIR/docs/laws.md,
# DIR/docs/cli.md and the Python stub DIR/python/isolaw/__init__.pyi, which lists the program's settings as keywords.
set -euo pipefail
shopt -s inherit_errexit
isolaw=$1 docs=$2/docs stub=python/isolaw/__init__.pyi
mkdir -p "$docs" "$2/${stub%/*}"
"$isolaw" laws --markdown >"$docs/laws.md"
"$isolaw" reference >"$docs/cli.md"

# In the stub, a comment `# isolaw keywords ...` holds a command, and a second comment marks the end of its output. The
# lines from the first comment to the second are replaced by the new output of the command.
written=$(
  keep=yes
  while IFS= read -r line; do
    case $line in *'# end of the keywords that the command above wrote') keep=yes ;; esac
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
