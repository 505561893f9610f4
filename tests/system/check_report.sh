#!/usr/bin/env bash
# check_report.sh SOURCE_FOLDER PROSUP
# Registers the small sample, and once with prone and supine exchanged, which fails by its verdict;
# check_report.py opens the reports of both in Chromium. Skipped (77) without Chromium and Python.
set -euo pipefail

source=$1 prosup=$2
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-report-XXXXXX")
trap 'rm -rf "$work"' EXIT

for program in python3 chromium; do
  command -v "$program" >/dev/null || { echo "There is no $program; skipped."; exit 77; }
done

data=$source/tests/data/small
prone=("$data/prone.nii.gz" "$data/prone_labels.nii.gz")
supine=("$data/supine.nrrd" "$data/supine_labels.mha")
# run NAME PRONE PRONE_LABELS SUPINE SUPINE_LABELS OPTION...: on few voxels and a coarse mesh.
run() {
  "$prosup" register --prone-image "$2" --prone-labels "$3" --supine-image "$4" --supine-labels "$5" \
    --chest fixed --output "$work/$1" --quiet --set "Images/Voxel edge=2" \
    --set "Meshing/Edge length=10" --set "Material update/Levels=6" --set "Image forces/Levels=6, 4" "${@:6}"
}
run good "${prone[@]}" "${supine[@]}" --landmarks "$data/landmarks.csv"
code=0
run failed "${supine[@]}" "${prone[@]}" --set "Checks/Errors stop the run=false" 2>"$work/failed.log" || code=$?
((code == 3)) || { cat "$work/failed.log" >&2; echo "Exchanged positions end with $code." >&2; exit 1; }
grep -q "Verdict: failed" "$work/failed/report.html"
python3 "$source/tests/system/check_report.py" chromium "$work/good/report.html" "$work/failed/report.html"
