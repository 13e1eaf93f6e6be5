#!/usr/bin/env bash
# Puts the libraries into FOLDER that are compiled from source into the page or into a wheel. C sources come from
# Debian's source packages, in the versions of library_sources.txt. Headers of installed packages are linked into
# FOLDER, so that a compiler for another system does not search /usr/include.
#   tools/library_sources.sh FOLDER NAME...    NAME: a source in library_sources.txt, or the package of a compiler whose
#                                              licence holds for what it compiles
# FOLDER/licences/NAME gets the copyright file of each library, and FOLDER/versions gets a line `NAME VERSION` for each.
set -euo pipefail
script=$(realpath "${BASH_SOURCE[0]}")
list=${script%.sh}.txt
folder=$(mkdir -p "$1" && cd "$1" && pwd)
names=("${@:2}")
packages=(libboost1.74-dev libcli11-dev libeigen3-dev libfmt-dev librandom123-dev libtomlplusplus-dev nlohmann-json3-dev)
complete="${names[*]} $(cat "$script" "$list" | sha256sum)"
[ "$(cat "$folder/complete" 2>/dev/null)" = "$complete" ] && exit

# apt gets a list of package sources of its own, so that the machine's list stays as it is. This list names the
# servers of the machine's list. apt takes a version from the first server that lists it. The server of security updates
# may list versions that it no longer has, so the server of the release comes first.
apt=$folder/apt
mkdir -p "$apt/lists/partial" "$apt/archives"
. /etc/os-release
apt-get indextargets --format 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $(REPO_URI) $(RELEASE) main' \
  'Created-By: Packages' 'Component: main' | grep -E " $VERSION_CODENAME(-security|-updates)? main\$" | sort -u -k4,4 > "$apt/sources.list" ||
  { echo "tools/library_sources.sh: apt knows no server of Debian $VERSION_CODENAME" >&2; exit 1; }
options=(-qq -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$apt/lists"
  -o "Dir::Cache::srcpkgcache=$apt/srcpkgcache.bin" -o "Dir::Cache::pkgcache=$apt/pkgcache.bin" -o APT::Sandbox::User=root)
echo "fetching the sources of ${names[*]} (apt-get source, into $apt)" >&2
apt-get "${options[@]}" update
rm -f "$folder/versions"
mkdir -p "$folder/licences"
cd "$apt/archives"
for name in "${names[@]}"; do
  read -r upstream hash < <(sed -n "s/^$name  *//p" "$list") || { packages+=("$name"); continue; }
  # The server may no longer have a version that Debian's list names, so the loop tries all versions, newest first.
  fetched=
  echo "apt knows no version $upstream" >"$folder/apt.log"
  for version in $(apt-cache "${options[@]}" showsrc "$name" | sed -n 's/^Version: //p' | sort -rVu); do
    plain=${version#*:}
    [ "${plain%-*}" = "$upstream" ] || continue
    apt-get "${options[@]}" source --only-source --download-only "$name=$version" >"$folder/apt.log" 2>&1 && fetched=$plain && break
  done
  [ -n "$fetched" ] || { echo "tools/library_sources.sh: no source package of $name $upstream could be fetched:" >&2; cat "$folder/apt.log" >&2; exit 1; }
  archive=$(ls "${name}_$upstream".orig.tar.?z*)
  echo "$hash  $archive" | sha256sum --check --quiet
  rm -rf "${folder:?}/$name"
  dpkg-source --no-check -x "${name}_$fetched.dsc" "$folder/$name" >/dev/null 2>&1
  echo "$name $fetched" >> "$folder/versions"
  cp "$folder/$name/debian/copyright" "$folder/licences/$name"
done
# SQLite's own build joins all its sources into the one file sqlite3.c.
mkdir -p "$folder/sqlite3/made"
(cd "$folder/sqlite3/made" && ../configure --disable-tcl && make sqlite3.c) > "$folder/sqlite3.log" 2>&1 ||
  { tail -20 "$folder/sqlite3.log" >&2; exit 1; }
# HDF5's own build writes its header of settings and makes two static libraries. During this it runs programs that
# write to the current folder, so the script changes to a build folder.
if [[ " ${names[*]} " = *" hdf5 "* ]]; then
  mkdir -p "$folder/hdf5/made"
  (cd "$folder/hdf5/made" &&
    cmake -G Ninja .. -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS="-ffile-prefix-map=$folder/=" -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
      -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF -DHDF5_BUILD_TOOLS=OFF -DHDF5_BUILD_EXAMPLES=OFF -DHDF5_BUILD_CPP_LIB=OFF \
      -DHDF5_ENABLE_Z_LIB_SUPPORT=ON -DZLIB_INCLUDE_DIR="$folder/zlib" -DZLIB_LIBRARY=z &&
    cmake --build . --target hdf5-static hdf5_hl-static) > "$folder/hdf5.log" 2>&1 ||
    { tail -20 "$folder/hdf5.log" >&2; exit 1; }
fi

rm -rf "$folder/include"
mkdir -p "$folder/include"
for name in boost CLI eigen3 fmt nlohmann toml++ Random123; do
  [ -e "/usr/include/$name" ] || { echo "tools/library_sources.sh: /usr/include/$name is not there" >&2; exit 1; }
  ln -s "/usr/include/$name" "$folder/include/$name"
done
for name in "${packages[@]}"; do
  version=$(dpkg-query -W -f '${Version}' "$name")
  echo "$name $version" >> "$folder/versions"
  cp "/usr/share/doc/$name/copyright" "$folder/licences/$name"
done
rm -f "$folder"/*.tar.*  # archives that apt-get and dpkg-source left behind
echo "$complete" > "$folder/complete"
