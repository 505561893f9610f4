#!/usr/bin/env bash
# check_cohort.sh BUILD_FOLDER CMAKE
# Installs the build to a temporary prefix and runs its workflow for many cases on the table of
# three that comes with it, of which one fails: it is reported, and the others finish. Skipped (77)
# without Snakemake.
set -euo pipefail

build=$1 cmake=$2
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-cohort-XXXXXX")
trap 'rm -rf "$work"' EXIT

die() {
  echo "$*" >&2
  exit 1
}

command -v snakemake >/dev/null || { echo "There is no snakemake; skipped."; exit 77; }
"$cmake" --install "$build" --prefix "$work/prefix" >"$work/install.log" || die "$(cat "$work/install.log")"
cohort=$work/prefix/share/doc/prosup/examples/cohort
cp "$cohort/cases.csv" "$cohort/mine.csv"

# workflow: on few voxels and a coarse mesh; prints Snakemake's exit code.
workflow() {
  local code=0
  (cd "$work" && HOME=$work snakemake --snakefile "$cohort/Snakefile" --profile "$cohort/profiles/local" \
    --config "cases=$cohort/mine.csv" "prosup=$work/prefix/bin/prosup" "results=$work/results" \
    'options=--set "Images/Voxel edge=3" --set "Meshing/Edge length=12" --set "Material update/Levels=6" --set "Image forces/Levels=6"') \
    >"$work/snakemake.log" 2>&1 || code=$?
  echo "$code"
}
# row NAME TEXT: the table says so of a case.
row() {
  grep -q "^$1,$2" "$work/results/cohort.csv" || die "The table is: $(cat "$work/results/cohort.csv" "$work/snakemake.log")"
}

code=$(workflow)
((code == 1)) || die "Of three cases one fails, but Snakemake ends with $code: $(cat "$work/snakemake.log")"
row fixed finished,
row correlation finished,
row exchanged unfinished,
grep -q "prone and supine are exchanged" "$work/results/logs/exchanged.txt" || die "The log does not say what failed."
for name in fixed correlation; do
  grep -q "href=\"$name/report.html\"" "$work/results/cohort.html" || die "The page leads to no report of '$name'."
  [[ ! -s $work/results/logs/$name.txt ]] || die "$name complains: $(cat "$work/results/logs/$name.txt")"
done

# Without the case that fails the others are not run again.
sed -i '/^exchanged,/d' "$cohort/mine.csv"
date=$(stat -c %Y "$work/results/fixed/summary.json")
code=$(workflow)
((code == 0)) || die "Two cases that are done end with $code: $(cat "$work/snakemake.log")"
(($(wc -l <"$work/results/cohort.csv") == 3)) || die "The table is: $(cat "$work/results/cohort.csv")"
[[ $(stat -c %Y "$work/results/fixed/summary.json") == "$date" ]] || die "A case that was done was run again."
echo "Of three cases one failed as it should, and the others finished."
