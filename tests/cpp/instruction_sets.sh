#!/bin/sh
# Object files compiled for one instruction set each (arguments) must not hold an inline function that the linker could
# take for the whole program: every such symbol bears the name of its instruction set.
set -eu
common=$(nm -C "$@" | grep -E '^[0-9a-f]+ [WVu] ' | grep -vE '(Eigen_|simd::)(v[234]|single|pair)' || true)
[ -z "$common" ] && exit 0
echo "inline functions shared between instruction sets:"
echo "$common"
exit 1
