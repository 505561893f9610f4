#!/usr/bin/env bash
# check_tests.sh FOLDER: fails when a source under FOLDER that holds tests is not named
# *_test.cc, or when code of the tests is outside namespace prosup::tests.
set -euo pipefail

cd "$1"
n_wrong=0
complain() {
  echo "$1" >&2
  n_wrong=$((n_wrong + 1))
}

mapfile -t with_tests < <(grep -rlE '^ *(TEST|TEST_F|TEST_P|TYPED_TEST)\(' --include='*.cc' --include='*.h' .)
((${#with_tests[@]})) || complain "No file with tests is under $PWD."
for file in "${with_tests[@]}"; do
  [[ $file == *_test.cc ]] || complain "$file holds tests, so that its name has to end in _test.cc."
done

# main.cc starts GoogleTest and holds nothing else; wrong_layers is what another check fails on.
mapfile -t sources < <(find . \( -name '*.cc' -o -name '*.h' \) -not -name main.cc -not -path '*/wrong_layers/*')
for file in "${sources[@]}"; do
  opened=$(grep -E '^namespace [a-z]' "$file" | grep -vE '^namespace [a-z]+ = ' | sort -u | tr -d '\n') || true
  [[ $opened == 'namespace prosup::tests {' ]] ||
    complain "$file: code of tests belongs to namespace prosup::tests${opened:+, not to '$opened'}."
done
for file in "${with_tests[@]}"; do
  grep -qx 'namespace {' "$file" ||
    complain "$file: tests belong to an anonymous namespace in prosup::tests."
done
((n_wrong == 0)) || exit 1
echo "${#with_tests[@]} files with tests, ${#sources[@]} in all, have one suffix and one namespace."
