#!/bin/sh
# Object files compiled for one instruction set each (arguments) must not hold an inline function that the linker could
# take for the whole program: every such symbol bears the name of its instruction set.
set -eu
common=$(nm -C "$@" | grep -E '^[0-9a-f]+ [WVu] ' | grep -vE '(Eigen_|simd::)(v[234]|single|pair)' || true)
if [ -n "$common" ]; then
  echo "inline functions shared between instruction sets:"
  echo "$common"
  exit 1
fi

# What is evaluated has the same bits by every one, so nothing in it is fused; GCC 12 fuses products and alternating
# sums of plain doubles in spite of -ffp-contract=off.
for object in "$@"; do
  case $object in *evaluation_*) ;; *) continue ;; esac
  if objdump -d "$object" | grep -qE '\b(vfn?m(add|sub)|fn?m(add|sub)|fml[as])'; then
    echo "fused operations in $object"
    exit 1
  fi
done
