#!/usr/bin/env bash
# Puts the libraries that the page is compiled with into FOLDER. C sources come from Debian's source packages, because
# Debian does not compile them for WebAssembly. Headers of installed packages are linked into FOLDER, so that the
# compiler does not search /usr/include.
#   tools/page_libraries.sh FOLDER
# FOLDER/licences/NAME gets the copyright file of each library, and FOLDER/versions gets a line `NAME VERSION` for each.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
sources=(expat minizip nettle sqlite3 zlib)
headers=(libboost1.74-dev libcli11-dev libeigen3-dev libfmt-dev librandom123-dev libtomlplusplus-dev nlohmann-json3-dev)
# Emscripten links its own runtime into every program, so the page must also contain the licence of emscripten.
compiled_in=(emscripten)
stamp="$folder/complete"
[ -e "$stamp" ] && [ "$stamp" -nt "${BASH_SOURCE[0]}" ] && exit 0

# apt gets a list of package sources of its own, so that the machine's list stays as it is.
apt=$folder/apt
mkdir -p "$apt/lists/partial" "$apt/archives"
. /etc/os-release
for at in "debian $VERSION_CODENAME" "debian-security $VERSION_CODENAME-security"; do
  set -- $at
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/$1 $2 main"
done > "$apt/sources.list"
options=(-qq -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$apt/lists"
  -o "Dir::Cache::srcpkgcache=$apt/srcpkgcache.bin" -o "Dir::Cache::pkgcache=$apt/pkgcache.bin" -o APT::Sandbox::User=root)
echo "fetching the sources of ${sources[*]} (apt-get source, into $apt)" >&2
apt-get "${options[@]}" update
rm -f "$folder/versions"
mkdir -p "$folder/licences"
cd "$apt/archives"
for name in "${sources[@]}"; do
  # The server may no longer have a version that Debian's list names, so the loop tries all versions, newest first.
  fetched=
  for version in $(apt-cache "${options[@]}" showsrc "$name" | sed -n 's/^Version: //p' | sort -rVu); do
    apt-get "${options[@]}" source --only-source --download-only "$name=$version" >/dev/null 2>&1 && fetched=$version && break
  done
  [ -n "$fetched" ] || { echo "tools/page_libraries.sh: no source package of $name could be fetched" >&2; exit 1; }
  rm -rf "${folder:?}/$name"
  dpkg-source --no-check -x "$name"_"${fetched#*:}".dsc "$folder/$name" >/dev/null 2>&1 ||
    dpkg-source --no-check -x "$name"_*"${fetched#*:}".dsc "$folder/$name" >/dev/null
  echo "$name $fetched" >> "$folder/versions"
  cp "$folder/$name/debian/copyright" "$folder/licences/$name"
done
# SQLite's own build joins all its sources into the one file sqlite3.c.
mkdir -p "$folder/sqlite3/made"
(cd "$folder/sqlite3/made" && ../configure --disable-tcl && make sqlite3.c) > "$folder/sqlite3.log" 2>&1 ||
  { tail -20 "$folder/sqlite3.log" >&2; exit 1; }

rm -rf "$folder/include"
mkdir -p "$folder/include"
for name in boost CLI eigen3 fmt nlohmann toml++ Random123; do
  [ -e "/usr/include/$name" ] || { echo "tools/page_libraries.sh: /usr/include/$name is not there" >&2; exit 1; }
  ln -s "/usr/include/$name" "$folder/include/$name"
done
for name in "${headers[@]}" "${compiled_in[@]}"; do
  version=$(dpkg-query -W -f '${Version}' "$name")
  echo "$name $version" >> "$folder/versions"
  cp "/usr/share/doc/$name/copyright" "$folder/licences/$name"
done
rm -f "$folder"/*.tar.*  # apt-get and dpkg-source left these archives
touch "$stamp"
