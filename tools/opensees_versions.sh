#!/usr/bin/env bash
# Runs the tests of exported scripts with several versions of OpenSees: tools/opensees_versions.sh BUILD [VERSIONS...]
#   BUILD   a build folder with tests, for example build/release
# If no Python on this machine can load a version, the script leaves it out and says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1
versions=("${@:2}")
[ ${#versions[@]} -gt 0 ] || versions=(3.4.0.8 3.6.0.3 3.7.1.2 3.8.0.0)
failed=0
for version in "${versions[@]}"; do
  folder=$PWD/build/opensees-$version
  python=/usr/bin/python3
  if [[ $version == 3.8.* ]]; then
    python=python3.12
    "$python" -c '' 2>/dev/null || { echo "$version: left out, it needs Python 3.12 and there is none"; continue; }
  fi
  if ! ISOLAW_OPENSEES_PYTHON=$python tools/opensees.sh "$folder" "$version"; then
    echo "$version: left out, it cannot be installed"
    continue
  fi
  echo "$version:"
  ISOLAW_OPENSEES=$folder ctest --test-dir "$build" --output-on-failure -j "$(nproc)" -R 'OpenSees|\.InTime\.' || failed=1
done
exit "$failed"
