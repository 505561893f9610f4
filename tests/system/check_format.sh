#!/usr/bin/env bash
# check_format.sh FOLDER CLANG_FORMAT: fails when a C++ file of the project is
# not formatted by .clang-format; exit code 77 with another version of clang-format, as they differ.
set -euo pipefail

clang_format=$2
cd "$1"
"$clang_format" --version | grep -q 'version 14\.' ||
  { echo "This test needs clang-format 14, but $clang_format is another version." >&2; exit 77; }
mapfile -d '' files < <(find src include tests examples benchmarks \
  \( -name '*.cc' -o -name '*.h' \) -print0 2>/dev/null)
((${#files[@]})) || { echo "No C++ files under $PWD." >&2; exit 1; }
"$clang_format" --dry-run -Werror "${files[@]}"
echo "${#files[@]} files are formatted."
