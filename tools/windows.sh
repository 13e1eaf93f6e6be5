#!/usr/bin/env bash
# Runs the program for Windows under wine and compares it with the native program: the files of `isolaw example`, the
# example campaign, and a short campaign with each instruction set that this processor has.
#   tools/windows.sh ISOLAW_EXE ISOLAW FOLDER
set -euo pipefail
exe=$(realpath "$1") native=$(realpath "$2")
folder=$(mkdir -p "$3" && cd "$3" && pwd)
foreign=$(x86_64-w64-mingw32-objdump -p "$exe" | sed -n 's/.*DLL Name: //p' | grep -viE '^(kernel32|msvcrt|shell32)\.dll$' || true)
[ -z "$foreign" ] || { echo "tools/windows.sh: $exe needs libraries that Windows may lack: $foreign" >&2; exit 1; }
command -v wine >/dev/null || { echo "tools/windows.sh: nothing was run, because wine is not installed" >&2; exit; }
export WINEPREFIX=$folder/wine WINEDEBUG=-all LC_ALL=C.UTF-8
# The folder has this name to test that names with a space and with letters outside ASCII work.
lots="$folder/Prüfung 日"
rm -rf "$lots" && mkdir "$lots" && cd "$lots"
"$native" example native
wine "$exe" example windows
diff -r native windows

compare() { # name, options of calibrate...
  local options=(--figures none "${@:2}")
  echo "$1:"
  "$native" calibrate native/lot.toml --out "native-$1" "${options[@]}" >/dev/null 2>&1
  wine "$exe" calibrate windows/lot.toml --out "windows-$1" "${options[@]}" >/dev/null 2>&1
  # The native program makes the report again from the store of the Windows program, and computes the objectives again.
  cp "windows-$1/summary.json" "windows-$1.json"
  "$native" report "windows-$1" --figures none >/dev/null 2>&1
  "$native" check "windows-$1"
  python3 - "windows-$1.json" {windows,native}"-$1/summary.json" <<'END'
import json, math, sys

def differences(a, b, at):
    """Yields for each value its relative difference, infinity for other words, and where it stands."""
    if isinstance(a, dict) and isinstance(b, dict) and list(a) == list(b):
        for key in a:
            yield from differences(a[key], b[key], f"{at}.{key}")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for i, (x, y) in enumerate(zip(a, b)):
            yield from differences(x, y, f"{at}[{i}]")
    elif type(a) in (int, float) and type(b) in (int, float):
        yield (abs(a - b) / max(abs(a), abs(b)) if a != b else 0.0), f"{at}: {a} and {b}"
    else:
        yield (0.0 if a == b else math.inf), f"{at}: {a} and {b}"

windows, again, native = (json.load(open(file, encoding="utf-8")) for file in sys.argv[1:])
report = list(differences(windows, again, ""))
size, where = max(report)
print(f"  one store, two programs: {sum(d == 0.0 for d, _ in report)} of {len(report)} values of summary.json are equal; "
      f"the largest relative difference is {size:.2g}, at {where}")
# The two searches may end in different local minima, because the programs round differently.
law = max((d, law["id"]) for law, other in zip(windows["laws"], native["laws"])
          for d, _ in differences(law["objective"]["best"], other["objective"]["best"], ""))
print(f"  two campaigns: the best objectives of the laws differ by {law[0]:.2g} at most, at {law[1]}")
sys.exit(size > 1e-4 or law[0] > 1e-3)
END
}

for set in scalar sse2 avx2 avx512; do
  export ISOLAW_SIMD=$set
  if "$native" --version >/dev/null 2>&1; then
    compare "$set" --laws bilinear,bouc-wen --runs 1
  else
    echo "$set: not run, because this processor lacks it"
  fi
done
unset ISOLAW_SIMD
compare whole
