#!/usr/bin/env bash
# check_own_law.sh SOURCE_FOLDER CMAKE COMPILER NM
# Configures prosup with the law of examples/law, and compiles what declares the parameters of laws and
# one of the kernels: the law has to be in both. A header that does not exist is refused.
set -euo pipefail

source=$1 cmake=$2 compiler=$3 nm=$4
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-law-XXXXXX")
trap 'rm -rf "$work"' EXIT

die() {
  echo "$*" >&2
  exit 1
}

# configure HEADER
configure() {
  "$cmake" -S "$source" -B "$work/build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPROSUP_TESTS=OFF \
    -DPROSUP_BENCHMARKS=OFF -DPROSUP_OWN_LAW="$1" >"$work/log" 2>&1
}
! configure "$work/none.h" || die "A header that does not exist is taken."
[[ $(tr -s " \n" " " <"$work/log") == *"there is no such file"* ]] || die "$(<"$work/log")"
configure "$source/examples/law/saturating.h" || die "$(<"$work/log")"

folder=CMakeFiles/prosup_mechanics.dir/src/mechanics
objects=("$folder/laws/tissue_material.cc.o" "$folder/element/element_kernel_baseline.cc.o")
"$cmake" --build "$work/build" --target "${objects[@]}" >"$work/log" || die "$(<"$work/log")"
grep -qa "stretched tissue is" "$work/build/${objects[0]}" || die "The parameters of the law are not declared."
"$nm" -C "$work/build/${objects[1]}" >"$work/symbols"
grep -q OwnLaw "$work/symbols" || die "There is no kernel for the law."
grep -q own_law.h "$work/build/cmake_install.cmake" || die "The header of the law is not installed."
