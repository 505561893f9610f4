#!/usr/bin/env bash
# check_doxygen.sh FOLDER DOXYGEN: fails when docs/Doxyfile gives a warning on the public
# headers of FOLDER, or a class, structure or enumeration there has no docstring.
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

# Short members say themselves what they are; a type does not.
undocumented=$(run "$2" "EXTRACT_ALL = NO" "WARN_IF_UNDOCUMENTED = YES" "WARN_AS_ERROR = NO" 2>&1 |
  grep -E 'warning: (Compound .*|Member .*\(enumeration\).*) is not documented' || true)
[[ -z $undocumented ]] || { printf 'A type without a docstring:\n%s\n' "$undocumented" >&2; exit 1; }

# The check itself, on a header with a parameter that does not exist.
printf '/** @file */\n/// Nothing.\n/// @param b is not there\nvoid f(int a);\n' >"$work/wrong.h"
! run "$2" "INPUT = $work/wrong.h" 2>/dev/null ||
  { echo "A wrong docstring gave no warning." >&2; exit 1; }
echo "The docstrings give no warning."
