#!/usr/bin/env bash
# Installs versions of OpenSees from PyPI. Tests run the scripts that isolaw exports in them.
#   tools/opensees.sh FOLDER [VERSION]
#   FOLDER/openseespy   OpenSees as a module of Python; the default version is the newest that Python 3.11 can load
#   FOLDER/xara         xara, a fork of OpenSees that reads Tcl; not installed if VERSION is given
# The licence of OpenSees allows research, education and internal use. Only tests use OpenSees, and isolaw contains no
# part of it.
set -euo pipefail
folder=$1
version=${2:-3.7.1.2}
python=${ISOLAW_OPENSEES_PYTHON:-/usr/bin/python3}
xara=0.1.32

# environment NAME MARK PACKAGES... makes a virtual environment FOLDER/NAME with the packages and writes MARK to its
# file `installed`. If that file already says MARK, nothing is done.
environment() {
  [ "$(cat "$folder/$1/installed" 2>/dev/null)" = "$2" ] && return
  echo "installing: $2 (PyPI, into $folder/$1)" >&2
  rm -rf "${folder:?}/$1"
  "$python" -m venv "$folder/$1"
  "$folder/$1/bin/pip" install --quiet --disable-pip-version-check "${@:3}"
  echo "$2" >"$folder/$1/installed"
}

environment openseespy "openseespy $version" "openseespy==$version"
# xara also requires packages for plots and services, which the tests do not need. --no-deps leaves them out.
[ $# -gt 1 ] || environment xara "opensees $xara, numpy 1" --no-deps "opensees==$xara" "numpy<2" platformdirs shps prompt_toolkit wcwidth
