#!/usr/bin/env bash
# Installs from PyPI what exported scripts are tried in: tools/opensees.sh FOLDER [VERSION]
#   FOLDER/openseespy   OpenSees as a module of Python, by default the newest version that Python 3.11 loads
#   FOLDER/xara         xara, a fork that reads Tcl itself; not with a VERSION
# The licence of OpenSees allows research, education and internal use. Only tests use it; nothing of it is shipped.
set -euo pipefail
folder=$1
version=${2:-3.7.1.2}
python=${ISOLAW_OPENSEES_PYTHON:-/usr/bin/python3}
xara=0.1.32

# environment NAME MARK PACKAGES...: makes a virtual environment that holds the packages, unless it holds them already.
environment() {
  [ "$(cat "$folder/$1/installed" 2>/dev/null)" = "$2" ] && return
  echo "installing: $2 (PyPI, into $folder/$1)" >&2
  rm -rf "${folder:?}/$1"
  "$python" -m venv "$folder/$1"
  "$folder/$1/bin/pip" install --quiet --disable-pip-version-check "${@:3}"
  echo "$2" >"$folder/$1/installed"
}

environment openseespy "openseespy $version" "openseespy==$version"
# The other requirements of xara are for plots and services.
[ $# -gt 1 ] || environment xara "opensees $xara" --no-deps "opensees==$xara" numpy platformdirs shps prompt_toolkit wcwidth
