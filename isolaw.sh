#!/usr/bin/env bash
# Sets up, builds, tests and measures isolaw with the presets of CMake. It prints every command before it runs it.
#   ./isolaw.sh setup        install what is missing: Debian packages, one npm package, one package of PyPI
#   ./isolaw.sh build        configure and build (preset `release`, or ISOLAW_PRESET=developer|sanitize|sanitize-thread)
#   ./isolaw.sh run          setup, build, identify the example lot and the example tests into out/
#   ./isolaw.sh test         setup, build, run all tests (installs the npm package axe-core too)
#   ./isolaw.sh sanitize     the tests of bad input, of the fuzz corpora and of all output files under the address and
#                            undefined-behaviour sanitizers; tools/reliability.sh runs all tests under them
#   ./isolaw.sh fuzz [SECONDS [TARGET...]]  run every fuzz target, or those named, for SECONDS (60), with clang; fails if
#                            one finds a fault. ISOLAW_PRESET=fuzz-fast runs them without sanitizers, several times as fast;
#                            ISOLAW_FUZZ_RUNS=N ends a target after N inputs
#   ./isolaw.sh bench        setup, build and run the benchmarks
#   ./isolaw.sh study [--quick]  time the published study, its scaling and other programs; see docs/performance.md
#   ./isolaw.sh format       check the format with clang-format (format --fix changes the files)
#   ./isolaw.sh lint         format, clang-tidy, and eslint for JavaScript
#   ./isolaw.sh compilers    compare results across compilers and processors: prints the largest differences
#   ./isolaw.sh page         build the program as one HTML file, build/page/isolaw.html, and test it; see docs/page.md
#   ./isolaw.sh wheel [PYTHON]  make the Python package as a wheel that runs on other Linux machines, and test it
#   ./isolaw.sh deb          make a Debian package of the command, and test it in a new Debian (as root)
#   ./isolaw.sh windows      compile the command for Windows, build/windows/cli/isolaw.exe, and test it under wine
#   ./isolaw.sh docs         let the program write docs/laws.md, docs/cli.md, the keywords of the Python stub, and what
#                            the tutorials print and draw
#   ./isolaw.sh site         make the documentation as a site that needs no server: build/site/index.html
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
preset=${ISOLAW_PRESET:-release}
# ctest runs one test more at a time than there are processors, because the tests of the page, of faults and of
# interruption mostly wait.
one_waits=$(($(nproc) + 1))

step() { printf '+ %s\n' "$*" >&2; "$@"; }
as_root() { if [ "$(id -u)" -eq 0 ]; then step "$@"; else step sudo "$@"; fi; }

build_packages=(ca-certificates cmake g++ gnuplot-nox libboost-dev libcli11-dev libeigen3-dev libexpat1-dev libfmt-dev libgtest-dev libhdf5-dev
  libmatio-dev libminizip-dev librandom123-dev libsqlite3-dev libbearssl-dev libtomlplusplus-dev libxlsxwriter-dev
  ninja-build nlohmann-json3-dev npm python3-dev python3-numpy python3-venv zlib1g-dev)
test_packages=(chromium g++-aarch64-linux-gnu gfortran make munge parallel python3-distributed python3-lmfit python3-matplotlib python3-pandas python3-scipy python3-tk qemu-user slurm-client slurmctld slurmd tcl xz-utils)

install_missing() {
  command -v dpkg-query >/dev/null || { echo "isolaw.sh: not a Debian system; install the packages listed here by other means" >&2; return; }
  local missing=()
  for package in "$@"; do
    # A Node.js that is not from Debian may bring its own npm. Debian's package npm is then not needed.
    [ "$package" = npm ] && command -v npm >/dev/null && continue
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "installing: ${missing[*]}" >&2
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

setup() {
  install_missing "${build_packages[@]}" "$@"
  if [ ! -e node_modules/plotly.js-basic-dist-min/plotly-basic.min.js ]; then
    echo "installing: plotly.js-basic-dist-min (npm, into node_modules/)" >&2
    step npm ci --omit=dev --no-audit --no-fund --loglevel=error
  fi
  tools/pypi.sh build/nanobind nanobind
}

# Checks the format of every C++ file, or with --fix corrects it.
format() {
  install_missing clang-format
  mapfile -t sources < <(find src cli opensees python examples tests bench fuzz -name '*.[ch]pp' | sort)
  if [ "${1:-}" = --fix ]; then
    printf '+ clang-format -i (%d files)\n' "${#sources[@]}" >&2
    clang-format -i "${sources[@]}"
  else
    printf '+ clang-format --dry-run --Werror (%d files)\n' "${#sources[@]}" >&2
    clang-format --dry-run --Werror "${sources[@]}" || { echo "isolaw.sh: run ./isolaw.sh format --fix" >&2; exit 1; }
    # clang-format does not break long comments, so this checks their width.
    if LC_ALL=C.UTF-8 grep -nE '^ *//.{119,}' "${sources[@]}" | LC_ALL=C.UTF-8 grep -E '^[^:]*:[0-9]*:.{121,}'; then
      echo "isolaw.sh: comments wider than 120 columns" >&2
      exit 1
    fi
  fi
}

build() {
  step cmake --preset "$preset"
  step cmake --build --preset "$preset" "$@"
}

case "${1:-help}" in
  setup) setup "${test_packages[@]}" ;;
  build) build ;;
  run)
    setup
    build --target isolaw_products
    # Identifies the two examples: the paper's lot, and the computed example tests. The second command ends with exit
    # code 1, because one of its records is refused and one bearing fails.
    isolaw=build/$preset/cli/isolaw
    step "$isolaw" calibrate examples/published-lot/lot.toml --out out/published-lot "${@:2}"
    step "$isolaw" example out/example-tests-files --tests
    step "$isolaw" calibrate out/example-tests-files/lot.toml --out out/example-tests "${@:2}" || [ $? -eq 1 ]
    ;;
  test)
    setup "${test_packages[@]}"
    # The test of the report's accessibility needs axe-core and is skipped without it.
    [ -e node_modules/axe-core/axe.min.js ] || step npm ci --no-audit --no-fund --loglevel=error
    step tools/opensees.sh build/opensees
    build
    step ctest --preset "$preset" -j "$one_waits" "${@:2}"
    ;;
  sanitize)
    setup "${test_packages[@]}"
    step cmake --preset sanitize
    step cmake --build --preset sanitize --target sanitized_share
    step ctest --preset sanitize -j "$one_waits" -L sanitized_share "${@:2}"
    ;;
  fuzz)
    setup clang-16 libclang-rt-16-dev
    case "$preset" in fuzz*) ;; *) preset=fuzz ;; esac
    step cmake --preset "$preset"
    step cmake --build --preset "$preset"
    seconds=${2:-60}
    targets=("${@:3}")
    [ ${#targets[@]} -gt 0 ] || { targets=("build/$preset/fuzz"/fuzz_*); targets=("${targets[@]##*/fuzz_}"); }
    findings=0
    for target in "${targets[@]}"; do
      # libFuzzer gets a largest input length, because short inputs run fast. Inputs of mat73 and store cannot be short,
      # because they are whole HDF5 and SQLite files.
      case "$target" in mat73 | store) longest=32768 ;; text | json | mat | motion) longest=1000 ;; *) longest=3000 ;; esac
      # libFuzzer writes new inputs to build/found, so that fuzz/corpus keeps only hand-made files and one minimised
      # input for each fault found. The presets fuzz and fuzz-fast share this folder: inputs that fuzz-fast found run
      # under the sanitizers in the next run of fuzz.
      mkdir -p "build/found/$target"
      # -entropic=0 turns off libFuzzer's statistics of rare features, which would take half of the time.
      step "build/$preset/fuzz/fuzz_$target" -max_total_time="$seconds" -runs="${ISOLAW_FUZZ_RUNS:--1}" -max_len="$longest" \
        -entropic=0 -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 -artifact_prefix="build/found/$target-" "build/found/$target" "fuzz/corpus/$target" ||
        findings=$((findings + 1))
    done
    [ "$findings" -eq 0 ] || { echo "isolaw.sh: $findings target(s) found a fault: build/found/" >&2; exit 1; }
    ;;
  bench)
    setup libbenchmark-dev
    step cmake --preset bench
    step cmake --build --preset bench
    step build/bench/cli/isolaw bench
    step build/bench/bench/laws_bench "${@:2}"
    step build/bench/bench/elementary_bench "${@:2}"
    ;;
  study)
    # The study times other programs too, but only if the user has installed them (python3-scipy, octave, libpagmo-dev).
    setup libbenchmark-dev python3 time
    step cmake --preset bench
    step cmake --build --preset bench
    step bench/study "${@:2}"
    ;;
  format) format "${@:2}" ;;
  lint)
    install_missing clang-tidy npm
    [ -e node_modules/eslint ] || step npm ci --no-audit --no-fund --loglevel=error
    format
    step node_modules/.bin/eslint src tests/browser tools page tests/page eslint.config.mjs
    mapfile -t units < <(find src cli -name '*.cpp' | sort)
    step cmake --preset developer
    step clang-tidy -p build/developer --quiet "${units[@]}"
    ;;
  compilers)
    install_missing "${build_packages[@]}" clang-16
    step tools/compilers.sh
    ;;
  page)
    # tools/library_sources.sh needs dpkg-dev to unpack the sources of libraries and tcl to build SQLite.
    setup chromium dpkg-dev emscripten firefox-esr tcl
    [ -e node_modules/axe-core/axe.min.js ] || step npm ci --no-audit --no-fund --loglevel=error
    step cmake --preset page
    step cmake --build --preset page
    ls -l build/page/isolaw.html
    # The tests compare the page's numbers with those of the native program, so this builds the native program too.
    step cmake --preset release
    step cmake --build --preset release --target isolaw_cli
    step ctest --test-dir build/page --output-on-failure "${@:2}"
    ;;
  wheel)
    setup dpkg-dev git tcl
    build --target isolaw_cli
    step tools/wheel.sh "build/$preset/cli/isolaw" "${@:2}"
    ;;
  deb)
    setup binutils debootstrap dpkg-dev help2man lintian tcl
    step tools/deb.sh "${@:2}"
    ;;
  windows)
    setup binutils-mingw-w64-x86-64 dpkg-dev g++-mingw-w64-x86-64-posix tcl wine wine64
    step cmake --preset windows
    step cmake --build --preset windows
    build --target isolaw_cli
    step tools/windows.sh build/windows/cli/isolaw.exe "build/$preset/cli/isolaw" build/windows/test
    ;;
  docs)
    setup python3-matplotlib python3-pandas python3-scipy
    build --target isolaw_products
    step tools/reference.sh "build/$preset/cli/isolaw" .
    step env PATH="$PWD/build/$preset/cli:$PATH" PYTHONPATH="build/$preset/python" /usr/bin/python3 tools/tutorials.py
    echo "written: docs/laws.md, docs/cli.md, the keywords of python/isolaw/__init__.pyi, docs/tutorial/" >&2
    ;;
  site)
    install_missing npm python3-venv
    [ -e node_modules/iframe-worker/shim/index.js ] || step npm ci --no-audit --no-fund --loglevel=error
    tools/pypi.sh build/mkdocs '[a-z]' /usr/bin/python3 site.txt
    NO_MKDOCS_2_WARNING=1 step build/mkdocs/bin/mkdocs build --strict
    ;;
  help | -h | --help) sed -n '2,23s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" ;;
  *)
    echo "isolaw.sh: unknown command '$1'; allowed: setup, build, run, test, sanitize, fuzz, bench, study, format, lint, compilers, page, wheel, deb, windows, docs, site" >&2
    exit 2
    ;;
esac
