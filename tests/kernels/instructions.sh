#!/bin/sh
# Code that is compiled for an instruction set must run only on processors that have this set. Other processors would
# stop with an illegal instruction.
#
#   instructions.sh symbols NM SET=OBJECT... -- OBJECT...   checks that every symbol that SET=OBJECT offers to the
#                                                           linker has the set in its name, and that no object of
#                                                           another set defines the same symbol
#   instructions.sh binary OBJDUMP PROGRAM                  checks that only functions with avx2 or avx512 in their
#                                                           names use instructions beyond the baseline, and only those
#                                                           with avx512 use 512-bit registers
#
# Dynamically linked libraries are not checked: they choose their instructions themselves.
set -eu
export LC_ALL=C
command=$1 tool=$2
shift 2

symbols() {
  set_name=
  report=$(
    for argument; do
      case $argument in
        --) set_name=-; continue ;;
        *=*) set_name=${argument%%=*} ;;
      esac
      # Prints one line "SET name" per symbol; SET is "-" for the objects after "--".
      "$tool" --defined-only --extern-only -P "${argument#*=}" | awk -v s="$set_name" 'NF >= 2 { print s, $1 }'
    done | awk '
      { seen[$2] = seen[$2] " " $1; if ($1 != "-") kernel[$2] = 1; total[$1]++ }
      $1 != "-" && index($2, $1) == 0 { print "compiled for " $1 ", without it in the name: " $2; bad = 1 }
      END {
        for (name in kernel) {
          shared = 0
          for (i = split(seen[name], sets, " "); i > 1; i--) if (sets[i] != sets[1]) shared = 1
          if (shared) { print "defined more than once (" seen[name] " ): " name; bad = 1 }
        }
        for (s in total) { kinds++; all += total[s] }
        if (kinds < 2 || !("-" in total)) { print "nothing to compare"; bad = 1 }
        if (!bad) print all " symbols of " kinds " sets, none shared"
        exit bad
      }'
  ) && status=0 || status=$?
  printf '%s\n' "$report" | c++filt
  exit $status
}

binary() {
  "$tool" -d -C --no-show-raw-insn -M att "$1" | awk '
    /^[0-9a-f]+ <.*>:$/ { name = substr($0, index($0, "<")); avx512 = name ~ /avx512/; avx2 = name ~ /avx2/; next }
    $1 !~ /^[0-9a-f]+:$/ { next }
    {
      zmm = /%zmm/; ymm = /%ymm/; mnemonic = $2
      # Code that is compiled for an instruction set and called from elsewhere need not use wide registers. AVX
      # encodings on 128-bit registers and BMI instructions therefore count as beyond the baseline too: not every x86-64
      # processor has them.
      beyond = zmm || ymm || (mnemonic ~ /^v/ && /%xmm/) || /%k[0-7]/ ||
               mnemonic ~ /^(andn|bextr|bls[ir]|blsmsk|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx)[lq]?$/
      if (zmm) wide512++
      if (ymm && avx2) wide256++
      if (beyond && !avx512 && (zmm || !avx2)) { sub(/^[^:]*:[ \t]*/, ""); print "in " name " " $0; if (++bad == 20) exit 1 }
    }
    END {
      if (bad) exit 1
      if (!wide512 || !wide256) { print "no wide instructions found at all"; exit 1 }
      print wide256 " instructions on 256 bits, " wide512 " on 512, all in functions of their own"
    }'
}

"$command" "$@"
