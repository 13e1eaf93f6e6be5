#!/usr/bin/env bash
# Measures how much forces and objectives differ between compilers, optimisation levels and processors. The script
# builds the program tests/regression/sweep.cpp with each of them and compares its output with that of the build by g++
# -O3, as in the release preset. It prints a table for each build. The exit code is 1 if a difference exceeds
# fit::evaluation_tolerance. ISOLAW_DRAWS=N takes N candidates from each search box, by default 250. The script compiles
# only the few sources that the program needs, because configuring the whole project for each build would take ten times
# as long.
#   tools/compilers.sh                       runs all builds
#   tools/compilers.sh [--reference SWEEP] NAME...  runs only these, compared with SWEEP instead of g++ -O3's
set -euo pipefail
reference=
if [ "${1:-}" = --reference ]; then
  reference=$(realpath "$2")
  shift 2
fi
wanted=("$@")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=build/compilers
mkdir -p "$folder"
sources=(tests/regression/sweep.cpp src/isolaw/laws/{,*/}*.cpp src/isolaw/base/{error,printable,number_text,units}.cpp
  src/isolaw/num/{instruction_set,random,statistics}.cpp src/isolaw/data/{channels/record,signals/smoothing}.cpp src/isolaw/opt/problem.cpp
  src/isolaw/fit/{box,joint_limits,kernel_choice,kernels,objective}.cpp)

# Each entry has the form "name: compiler and flags".
variants=(
  "gcc-O0: g++ -O0"
  "gcc-O2-x86-64-v3: g++ -O2 -march=x86-64-v3"  # fuses products and sums (FMA)
  "gcc-O3-native: g++ -O3 -march=native"
  "gcc-O2-x87: g++ -O2 -mfpmath=387"            # x87 instructions: significands of intermediate results have 64 bits
  "clang-O2: clang++-16 -O2"
  "clang-O3-native: clang++-16 -O3 -march=native -ffp-contract=fast"
  "aarch64: aarch64-linux-gnu-g++ -O2 -static"  # runs with NEON in an emulator
)

make_sweep() { # name, compiler and flags...
  local name=$1 object=$folder/$1-objects source
  shift
  mkdir -p "$object"
  # The options -ffunction-sections and --gc-sections leave out functions that the sweep does not use. Such functions
  # may call sources that are not compiled here.
  for source in "${sources[@]}"; do
    printf '%s\0-o\0%s\0' "$source" "$object/${source//\//_}.o"
  done | xargs -0 -n 3 -P "$(nproc)" "$@" -w -DNDEBUG -DFMT_HEADER_ONLY -DISOLAW_KERNELS=kernels_portable -std=c++20 \
    -ffunction-sections -fdata-sections -Isrc -Itests -c
  "$@" -Wl,--gc-sections "$object"/*.o -o "$folder/$name"
  rm -r "$object"
}

broken=0
compare() { # title, command...
  printf '%s\n' "$1"
  "${@:2}" compare "$folder/reference.bin" || broken=1
}

if [ -z "$reference" ]; then
  reference=$folder/reference
  make_sweep reference g++ -O3
fi
"$reference" write "$folder/reference.bin"
for variant in "${variants[@]}"; do
  name=${variant%%: *}
  [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " = *" $name "* ]] || continue
  read -ra command <<<"${variant#*: }"
  emulator=()
  [ "$name" = aarch64 ] && emulator=(qemu-aarch64)
  if ! command -v "${command[0]}" >/dev/null; then
    printf '%s\n  left out: no %s here\n' "$name" "${command[0]}"
    continue
  fi
  # First compiles and runs an empty program. This fails if the processor lacks instructions that the compiler uses, or
  # if the compiler is for another kind of processor.
  if ! echo 'int main() {}' | "${command[@]}" -x c++ - -o "$folder/probe" 2>/dev/null ||
    ! "${emulator[@]}" "$folder/probe"; then
    printf '%s\n  left out: does not run here\n' "$name"
    continue
  fi
  make_sweep "$name" "${command[@]}"
  compare "$name (${command[*]})" "${emulator[@]}" "$folder/$name"
done
[ ${#wanted[@]} -eq 0 ] || { rm -f "$folder/reference.bin" "$folder/probe"; exit $broken; }
# glibc chooses its mathematical functions at run time, by the instructions that the processor has. In this run it must
# choose those for an old processor.
compare "reference without FMA in the mathematical library" \
  env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA,-FMA4 "$reference"
rm -f "$folder/reference.bin" "$folder/probe"
exit $broken
