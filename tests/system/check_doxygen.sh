#!/usr/bin/env bash
# check_doxygen.sh FOLDER DOXYGEN: fails when docs/Doxyfile gives a warning on the public
# headers of FOLDER.
set -euo pipefail

cd "$1"
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-doxygen-XXXXXX")
trap 'rm -rf "$work"' EXIT
[[ -f docs/Doxyfile ]] || { echo "$PWD has no docs/Doxyfile." >&2; exit 1; }
run() {
  { cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $work"; printf '%s\n' "${@:2}"; } | "$1" -
}
run "$2"
[[ -f $work/reference/index.html ]] || { echo "doxygen wrote no reference." >&2; exit 1; }

# The check itself, on a header with a parameter that does not exist.
printf '/** @file */\n/// Nothing.\n/// @param b is not there\nvoid f(int a);\n' >"$work/wrong.h"
! run "$2" "INPUT = $work/wrong.h" 2>/dev/null ||
  { echo "A wrong docstring gave no warning." >&2; exit 1; }
echo "The docstrings give no warning."
