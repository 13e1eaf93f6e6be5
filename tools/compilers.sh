#!/usr/bin/env bash
# How far compilers, optimisation levels and processors move forces and objectives: the sweep of tests/regression, kept
# by g++ -O3 (the release preset), is repeated by other builds and compared. Prints a table for each of them; exit code
# 1 where one is beyond the bound (fit::evaluation_tolerance).  ISOLAW_DRAWS=N: N candidates of each box, else 250.
# Compiles the few modules that matter itself: a configured tree for each build would take ten times as long.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=build/compilers
mkdir -p "$folder"
sources=(tests/regression/sweep.cpp src/isolaw/{base,laws}/*.cpp
  src/isolaw/num/{random,statistics,tolerance_factor}.cpp
  src/isolaw/fit/{box,instruction_set,kernels,objective}.cpp)

# name: compiler and flags
variants=(
  "gcc-O0: g++ -O0"
  "gcc-O2-x86-64-v3: g++ -O2 -march=x86-64-v3"  # contracts products and sums (FMA)
  "gcc-O3-native: g++ -O3 -march=native"
  "gcc-O2-x87: g++ -O2 -mfpmath=387"            # intermediate results of 64 bits
  "clang-O2: clang++ -O2"
  "clang-O3-native: clang++ -O3 -march=native -ffp-contract=fast"
)

make_sweep() { # name, compiler and flags...
  local name=$1
  shift
  "$@" -DNDEBUG -std=c++20 -Isrc -Itests "${sources[@]}" -lfmt -lcrypto -o "$folder/$name"
}

broken=0
compare() { # title, command...
  printf '%s\n' "$1"
  "${@:2}" compare "$folder/reference.bin" || broken=1
}

make_sweep reference g++ -O3
"$folder/reference" write "$folder/reference.bin"
for variant in "${variants[@]}"; do
  name=${variant%%: *}
  read -ra command <<<"${variant#*: }"
  if ! command -v "${command[0]}" >/dev/null; then
    printf '%s\n  left out: no %s here\n' "$name" "${command[0]}"
    continue
  fi
  # A processor without the instructions, or another architecture's compiler, cannot run the variant.
  if ! echo 'int main() {}' | "${command[@]}" -x c++ - -o "$folder/probe" 2>/dev/null || ! "$folder/probe"; then
    printf '%s\n  left out: does not run here\n' "$name"
    continue
  fi
  make_sweep "$name" "${command[@]}"
  compare "$name (${command[*]})" "$folder/$name"
done
# glibc chooses its elementary functions by the processor; this is what an old one gets.
compare "reference without FMA in the mathematical library" \
  env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA,-FMA4 "$folder/reference"
rm -f "$folder/reference.bin" "$folder/probe"
exit $broken
