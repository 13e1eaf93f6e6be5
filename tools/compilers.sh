#!/usr/bin/env bash
# How far compilers, optimisation levels and processors move forces and objectives: the sweep of tests/regression, kept
# by g++ -O3 (the release preset), is repeated by other builds and compared. Prints a table for each of them; exit code
# 1 where one is beyond the bound (fit::evaluation_tolerance).  ISOLAW_DRAWS=N: N candidates of each box, else 250.
# Compiles the few modules that matter itself: a configured tree for each build would take ten times as long.
#   tools/compilers.sh                       all of them
#   tools/compilers.sh [--reference SWEEP] NAME...  these alone; SWEEP: the sweep as another build has it, for g++ -O3
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
sources=(tests/regression/sweep.cpp src/isolaw/laws/*.cpp src/isolaw/base/{error,printable,number_text,units}.cpp
  src/isolaw/num/{instruction_set,random,statistics}.cpp src/isolaw/data/clean.cpp src/isolaw/opt/problem.cpp
  src/isolaw/fit/{box,joint_limits,kernel_choice,kernels,objective,work_counter}.cpp)

# name: compiler and flags
variants=(
  "gcc-O0: g++ -O0"
  "gcc-O2-x86-64-v3: g++ -O2 -march=x86-64-v3"  # contracts products and sums (FMA)
  "gcc-O3-native: g++ -O3 -march=native"
  "gcc-O2-x87: g++ -O2 -mfpmath=387"            # intermediate results of 64 bits
  "clang-O2: clang++ -O2"
  "clang-O3-native: clang++ -O3 -march=native -ffp-contract=fast"
  "aarch64: aarch64-linux-gnu-g++ -O2 -static"  # NEON, in an emulator
)

make_sweep() { # name, compiler and flags...
  local name=$1 object=$folder/$1-objects source
  shift
  mkdir -p "$object"
  # What the modules mention and the sweep does not use is left out by the linker.
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
  # A processor without the instructions, or another architecture's compiler, cannot run the variant.
  if ! echo 'int main() {}' | "${command[@]}" -x c++ - -o "$folder/probe" 2>/dev/null ||
    ! "${emulator[@]}" "$folder/probe"; then
    printf '%s\n  left out: does not run here\n' "$name"
    continue
  fi
  make_sweep "$name" "${command[@]}"
  compare "$name (${command[*]})" "${emulator[@]}" "$folder/$name"
done
[ ${#wanted[@]} -eq 0 ] || { rm -f "$folder/reference.bin" "$folder/probe"; exit $broken; }
# glibc chooses its elementary functions by the processor; this is what an old one gets.
compare "reference without FMA in the mathematical library" \
  env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA,-FMA4 "$reference"
rm -f "$folder/reference.bin" "$folder/probe"
exit $broken
