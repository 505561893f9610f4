#!/usr/bin/env bash
# check_tidy.sh FOLDER CLANG_TIDY BUILD_FOLDER [FILE...]: fails when clang-tidy with the list
# of .clang-tidy finds something in these source files of FOLDER; in all of src without any.
# One file with deal.II's headers takes some 20 s. Exit code 77 with another version than 14: each
# finds more than the one before.
set -euo pipefail

clang_tidy=$2
"$clang_tidy" --version | grep -q 'version 14\.' ||
  { echo "This test needs clang-tidy 14, but $clang_tidy is another version." >&2; exit 77; }
build=$(realpath "$3")
cd "$1"
shift 3
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(find src -name '*.cc' | sort)
fi
database=$(mktemp -d "${TMPDIR:-/tmp}/prosup-tidy-XXXXXX")
trap 'rm -rf "$database"' EXIT
# The precompiled header is GCC's, which clang cannot read.
sed -E 's/-Winvalid-pch//g; s/-fpch-preprocess//g; s/-include [^ "]*cmake_pch\.hxx//g' \
  "$build/compile_commands.json" >"$database/compile_commands.json"
for file in "${files[@]}"; do
  grep -q "\"file\": \".*/$file\"" "$database/compile_commands.json" ||
    { echo "$file is not among what is compiled." >&2; exit 1; }
done
"$clang_tidy" --quiet -p "$database" "${files[@]}"
echo "clang-tidy finds nothing in ${#files[@]} files."
