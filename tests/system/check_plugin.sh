#!/usr/bin/env bash
# check_plugin.sh SOURCE_FOLDER BUILD_FOLDER CMAKE COMPILER MPIRUN...
# Installs the build to a temporary prefix, builds examples/plugin against it and
# runs it on one and two ranks. Fails when the package lacks a header.
set -euo pipefail

source=$1 build=$2 cmake=$3 compiler=$4
shift 4
mpirun=("$@")
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-plugin-XXXXXX")
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

die() {
  echo "$*" >&2
  exit 1
}

"$cmake" --install "$build" --prefix "$prefix" >"$work/install.log" || die "$(cat "$work/install.log")"
diff <(cd "$source/include" && find . -name '*.h' | sort) \
  <(cd "$prefix/include" && find . -name '*.h' | sort) || die "The installed headers are not all headers."
"$prefix/bin/prosup" --version

# A copy, so that nothing of the source tree is found by a relative path.
cp -r "$source/examples/plugin" "$work/plugin"
"$cmake" -S "$work/plugin" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" >"$work/configure.log" ||
  die "$(cat "$work/configure.log")"
grep -q "prosup_DIR:PATH=$prefix" "$work/build/CMakeCache.txt" || die "Another prosup was found."
"$cmake" --build "$work/build" --parallel 2

"$work/build/plugin" "$work/plugin/plugin.prm" | tee "$work/one.txt"
"${mpirun[@]}" "$work/build/plugin" "$work/plugin/plugin.prm" | tee "$work/two.txt"
# Simulations stop at 0.02 mm, which is half a percent of the distances.
paste <(grep -oE '[0-9.]+ mm' "$work/one.txt") <(grep -oE '[0-9.]+ mm' "$work/two.txt") |
  awk '{ n += 1; if (($1 - $3)^2 > (0.005 * $1)^2) wrong = 1 } END { exit wrong || n != 4 }' ||
  die "Two ranks give another result than one."

# That all this would notice a header missing from the package:
rm "$prefix/include/prosup/unloading/unloading_parameters.h"
! "$cmake" --build "$work/build" >"$work/broken.log" || die "A missing header went unnoticed."
grep -q "unloading_parameters.h" "$work/broken.log" || die "$(cat "$work/broken.log")"
