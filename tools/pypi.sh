#!/usr/bin/env bash
# Makes a virtual environment of PYTHON (default /usr/bin/python3) in FOLDER, with exact versions of packages from PyPI.
#   tools/pypi.sh FOLDER PATTERN [PYTHON [LIST]]    installs the packages of LIST whose line begins with PATTERN;
#                                                   LIST is pypi.txt or another file beside it
set -euo pipefail
needed=$(grep "^$2" "$(dirname "${BASH_SOURCE[0]}")/${4:-pypi.txt}")
python=${3:-/usr/bin/python3}
[ "$(cat "$1/installed.txt" 2>/dev/null)" = "$needed" ] && exit
echo "installing: $(echo "$needed" | sed 's/[ ;].*//' | paste -sd ' ') (PyPI, into $1)" >&2
"$python" -m venv --clear "$1"
echo "$needed" > "$1/needed.txt"
"$1/bin/pip" install --quiet --disable-pip-version-check -r "$1/needed.txt"
mv "$1/needed.txt" "$1/installed.txt"
