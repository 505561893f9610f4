#!/usr/bin/env bash
# check_sensitivity.sh PROJECT PROGRAM: one offset of the small sample, which the
# alignment of the chests takes back. Coarser than the sample's own parameters.
set -euo pipefail
project=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

PROSUP=$program "$project/scripts/sensitivity" --align --offsets 10 --directions x --output "$folder" \
  "$project/prm/tests/small.prm" --set "Image forces/Levels=6" --set "Image forces/Updates per level=3" \
  --set Results/Pictures=false | tee "$folder/out.md"
grep -q '^| LR: x 10 mm |' "$folder/out.md"
awk -F, 'NR == 1 { next }
  { mean[$1] = $5; back[$1] = $8; if ($4 < 100) exit 1 }
  END {
    if (NR != 3) { print "not two rows"; exit 1 }
    if (back[10] < -10.5 || back[10] > -9.5) { print "moved back by", back[10]; exit 1 }
    difference = mean[10] - mean[0]
    if (difference < -0.3 || difference > 0.3) { print "errors differ by", difference; exit 1 }
  }' "$folder/sensitivity.csv"
