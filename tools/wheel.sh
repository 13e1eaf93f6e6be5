#!/usr/bin/env bash
# Packs the sources of the last commit (sdist), makes a wheel from them that needs only the C library, and tests the
# wheel in a virtual environment without other packages. Both files are in build/wheel afterwards.
#   tools/wheel.sh PROGRAM [PYTHON]
# PROGRAM: the program isolaw, whose results the wheel must have. PYTHON (default /usr/bin/python3): the wheel runs with
# its version, and with later ones too from 3.12 on.
set -euo pipefail
program=$(realpath "$1")
python=${2:-/usr/bin/python3}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$PWD/build/wheel
step() { printf '+ %s\n' "$*" >&2; "$@"; }

version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
tools/pypi.sh "$folder/tools-$version" '[a-z]' "$python"
export PATH=$folder/tools-$version/bin:$PATH
rm -rf "$folder/source" "$folder/built" "$folder"/isolaw-*.tar.gz
mkdir -p "$folder/source"
git archive HEAD | tar x -C "$folder/source"
plotly=node_modules/plotly.js-basic-dist-min
mkdir -p "$folder/source/$plotly"
cp "$plotly"/{plotly-basic.min.js,LICENSE} "$folder/source/$plotly"
(cd "$folder/source" && step python -c 'import sys, scikit_build_core.build as b; b.build_sdist(sys.argv[1])' "$folder")
rm -rf "$folder/source"
mkdir "$folder/source"
tar x -C "$folder/source" --strip-components 1 -f "$folder"/isolaw-*.tar.gz
step pip wheel --quiet --disable-pip-version-check --no-index --no-deps --no-build-isolation --wheel-dir "$folder/built" \
  --config-settings cmake.define.ISOLAW_BUNDLED=ON --config-settings "cmake.define.ISOLAW_LIBRARIES=$folder/libraries" \
  --config-settings install.strip=true "$folder/source"
step auditwheel repair --wheel-dir "$folder" "$folder"/built/isolaw-*.whl
wheel=$(ls -t "$folder"/isolaw-*.whl | head -1)
ls -l "$wheel"

step "$python" -m venv --clear "$folder/test"
step "$folder/test/bin/pip" install --quiet --disable-pip-version-check "$wheel"
for name in command commands records laws shown stubs conditions; do
  step env -C tests/python -u PYTHONPATH ISOLAW_BINARY="$program" ISOLAW_SOURCE_DIR="$PWD" PYTHONDONTWRITEBYTECODE=1 \
    "$folder/test/bin/python" -m unittest "test_$name"
done
for packages in build/opensees/openseespy/lib/"python$version"/site-packages; do
  [ ! -e "$packages" ] || step env -C tests/python PYTHONPATH="$PWD/$packages" ISOLAW_BINARY="$program" ISOLAW_SOURCE_DIR="$PWD" \
    "$folder/test/bin/python" -m unittest test_opensees_steps
done
