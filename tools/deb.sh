#!/usr/bin/env bash
# Makes a Debian package of the command isolaw, build/deb/isolaw_VERSION-1_ARCHITECTURE.deb, and tests it. The program
# contains its libraries (ISOLAW_BUNDLED), so one package serves every Debian and Ubuntu with glibc 2.35 or later. The
# man pages and the completion of bash are made from the program's help.
#   tools/deb.sh [--no-test]
# The test installs the package in a new Debian (debootstrap, as root) and calibrates the example lot there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$PWD/build/deb
root=$folder/root
step() { printf '+ %s\n' "$*" >&2; "$@"; }

step cmake --preset release -B build/deb -DISOLAW_BUNDLED=ON -DISOLAW_TESTS=OFF -DISOLAW_PYTHON=OFF
step cmake --build build/deb --target isolaw_cli
version=$(sed -n 's/^project(isolaw VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
architecture=$(dpkg --print-architecture)
maintainer='The isolaw authors <isolaw@example.invalid>'

rm -rf "$root"
bin=$root/usr/bin docs=$root/usr/share/doc/isolaw man=$root/usr/share/man/man1
completions=$root/usr/share/bash-completion/completions overrides=$root/usr/share/lintian/overrides
mkdir -p "$bin" "$docs" "$man" "$completions" "$overrides" "$root/DEBIAN"
strip -o "$bin/isolaw" build/deb/cli/isolaw
commands=$("$bin/isolaw" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')

page() {  # NAME OPTIONS-OF-HELP2MAN...
  help2man --no-info --section 1 --manual "User Commands" --version-string "$1 $version" "${@:2}" -o "$man/$1.1"
  gzip -9n "$man/$1.1"
}
page isolaw --name "fit hysteretic laws to tests of seismic isolators" "$bin/isolaw"
for command in $commands; do
  printf '#!/bin/sh\nexec "%s" %s "$@"\n' "$bin/isolaw" "$command" >"$folder/isolaw-$command"
  chmod +x "$folder/isolaw-$command"
  page "isolaw-$command" --name "$("$bin/isolaw" "$command" --help | head -1)" "$folder/isolaw-$command"
done

{
  echo '# Completes the commands and options of isolaw, and names of files.'
  echo '_isolaw() {'
  echo '  local words'
  echo '  case ${COMP_WORDS[1]} in'
  for command in $commands; do
    options=$("$bin/isolaw" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+' | sort -u | xargs)
    echo "    $command) words=\"$options\" ;;"
  done
  echo "    *) words=\"$(echo "$commands" | xargs) --help --version\" ;;"
  echo '  esac'
  echo '  [ "$COMP_CWORD" -gt 1 ] || words="'"$(echo "$commands" | xargs)"' --help --version"'
  echo '  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$2")'
  echo '}'
  echo 'complete -o default -F _isolaw isolaw'
} >"$completions/isolaw"

{
  echo "isolaw is under the MIT licence:"
  echo
  cat LICENSE
  for licence in build/deb/libraries/licences/*; do
    printf '\n\n==== The program contains %s:\n\n' "$(basename "$licence")"
    cat "$licence"
  done
  printf '\n\n==== The program contains plotly.js:\n\n'
  cat node_modules/plotly.js-basic-dist-min/LICENSE
} >"$docs/copyright"
gzip -9nc CHANGELOG.md >"$docs/changelog.gz"
printf 'isolaw (%s-1) unstable; urgency=medium\n\n  * Version %s. changelog.gz says what is new.\n\n -- %s  %s\n' "$version" "$version" \
  "$maintainer" "$(git log -1 --format=%cD)" | gzip -9n >"$docs/changelog.Debian.gz"
# Debian's checker lintian objects to libraries inside a program. Here they are inside on purpose.
printf 'isolaw: embedded-library *\n' >"$overrides/isolaw"

glibc=$(objdump -T "$bin/isolaw" | grep -oE 'GLIBC_[0-9.]+' | sort -Vu | tail -1)
cat >"$root/DEBIAN/control" <<EOF
Package: isolaw
Version: $version-1
Architecture: $architecture
Maintainer: $maintainer
Installed-Size: $(du -sk "$root/usr" | cut -f1)
Depends: libc6 (>= ${glibc#GLIBC_})
Recommends: gnuplot-nox
Section: science
Priority: optional
Description: hysteretic laws of seismic isolators, fitted to test records
 isolaw reads the cyclic tests of a production lot of rubber bearings, fits
 hysteretic laws to every device, and reports how accurate each law is and how
 its parameters differ from device to device.
EOF
package=$folder/isolaw_$version-1_$architecture.deb
step dpkg-deb --root-owner-group --build "$root" "$package"
ls -l "$package"
step lintian --fail-on error --allow-root "$package"
[ "${1-}" = --no-test ] && exit

test=$folder/test
rm -rf "$test"
. /etc/os-release
step debootstrap --variant=minbase "$VERSION_CODENAME" "$test" >"$folder/debootstrap.log"
cp "$package" "$test/"
step chroot "$test" sh -ec "dpkg -i /${package##*/}
  isolaw --version
  isolaw example /root/lot
  isolaw calibrate /root/lot/study.toml --laws bilinear --runs 1 --analysis none --figures none --out /root/out
  test -s /root/out/report.html"
