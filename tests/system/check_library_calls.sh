#!/usr/bin/env bash
# check_library_calls.sh NM PROGRAM LIBRARY...
# Fails when a library starts or ends MPI or ends the program. PROGRAM has to do
# so: it shows that such calls are seen.
set -euo pipefail

nm=$1
program=$2
shift 2
(($#)) || { echo "No libraries are given." >&2; exit 1; }

# reserved_calls FILE: functions that only a program may call, if FILE calls them.
reserved_calls() {
  "$nm" -D --undefined-only "$1" | awk '{ print $NF }' | sed 's/@.*//' |
    grep -xE 'P?MPI_(Init|Init_thread|Finalize)|exit|_exit|_Exit|quick_exit|abort' || true
}

[[ -n $(reserved_calls "$program") ]] ||
  { echo "$program shows no call of MPI_Init, so that this check sees nothing." >&2; exit 1; }

n_wrong=0
for library in "$@"; do
  calls=$(reserved_calls "$library")
  [[ -z $calls ]] || { echo "$library calls" $calls >&2; n_wrong=$((n_wrong + 1)); }
done
echo "$# libraries, $n_wrong with reserved calls"
((n_wrong == 0))
