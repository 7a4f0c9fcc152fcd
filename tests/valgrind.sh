#!/bin/sh
# Small models under valgrind, by the instructions of x86-64-v2 and v3 (it knows no wider ones): no value that was never
# set, nothing read or written where there is nothing, nothing lost. Argument: the folder of the build. Not for what is
# compared with long double, which valgrind computes as double.
set -eu
build=$1
status=0
for path in x86-64-v2 x86-64-v3; do
  for program in runge_kutta half_explicit multistep semi_implicit_euler adaptive_simulation events formulation \
    body_forces sparse_qr interruption; do
    printf '%s, %s\n' "$program" "$path" >&2
    LINKWORK_INSTRUCTION_SET=$path valgrind -q --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite \
      "$build/test_$program" --minimal || status=1
  done
done
exit $status
