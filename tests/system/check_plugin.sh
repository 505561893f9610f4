#!/usr/bin/env bash
# check_plugin.sh SOURCE_FOLDER BUILD_FOLDER CMAKE COMPILER MPIRUN...
# Installs the build to a temporary prefix, builds the examples against it and runs
# them on one and two ranks. Fails when the package lacks a header.
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

# build_example NAME: a copy, so that nothing of the source tree is found by a relative path.
build_example() {
  cp -r "$prefix/share/doc/prosup/examples/$1" "$work/$1"
  "$cmake" -S "$work/$1" -B "$work/build_$1" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" >"$work/configure.log" ||
    die "$(cat "$work/configure.log")"
  grep -q "prosup_DIR:PATH=$prefix" "$work/build_$1/CMakeCache.txt" || die "Another prosup was found."
  "$cmake" --build "$work/build_$1" --parallel 2
}

# The front door says of a point what the command says.
build_example register
data=$source/tests/data/small
cat >"$work/quick.prm" <<'PRM'
subsection Images
  set Voxel edge = 2
end
subsection Meshing
  set Edge length = 10
end
subsection Material update
  set Levels = 6
end
subsection Image forces
  set Levels = 6, 4
end
PRM
files=("$data/prone.nii.gz" "$data/prone_labels.nii.gz" "$data/supine.nrrd" "$data/supine_labels.mha")
IFS=, read -r id x y z _ < <(sed -n 2p "$data/landmarks.csv")
"$work/build_register/register" "${files[@]}" "$x" "$y" "$z" "$work/quick.prm" | tee "$work/one.txt"
"${mpirun[@]}" "$work/build_register/register" "${files[@]}" "$x" "$y" "$z" "$work/quick.prm" | tee "$work/two.txt"
printf 'id,x,y,z\n%s,%s,%s,%s\n' "$id" "$x" "$y" "$z" >"$work/point.csv"
"$prefix/bin/prosup" register "$work/quick.prm" --chest fixed --output "$work/result" \
  --prone-image "${files[0]}" --prone-labels "${files[1]}" \
  --supine-image "${files[2]}" --supine-labels "${files[3]}" >"$work/register.log"
"$prefix/bin/prosup" map --result "$work/result" --from prone --to supine "$work/point.csv" -o "$work/mapped.csv"
# near FILE: the numbers of the file are those of the command, to 0.05 mm; two ranks settle
# a little differently, and have to agree with one to the same distance.
near() {
  paste <(tr ' ' '\n' <"$1" | head -3) <(sed -n 2p "$work/mapped.csv" | cut -d, -f2-4 | tr , '\n') |
    awk '{ n += 1; if (($1 - $2)^2 > 0.05^2) wrong = 1 } END { exit wrong || n != 3 }'
}
near "$work/one.txt" || die "The example maps a point to $(cat "$work/one.txt"), the command to $(sed -n 2p "$work/mapped.csv")."
near "$work/two.txt" || die "Two ranks map a point to $(cat "$work/two.txt"), one to $(cat "$work/one.txt")."

# A metric of the host's own. The sample is 10 mm apart.
build_example metric
"$work/build_metric/metric" "${files[@]}" "$data/landmarks.csv" "$work/quick.prm" | tee "$work/metric.txt"
awk '{ n += 1; if (!($1 > 9 && $2 < 0.15 * $1)) wrong = 1 } END { exit wrong || n != 1 }' "$work/metric.txt" ||
  die "With a metric of its own the example leaves $(cat "$work/metric.txt") mm."

# The laws. Of a neo-Hookean block the stress is mu (stretch - 1/stretch^2), mu = 300 Pa.
build_example law
"$work/build_law/law" | tee "$work/law.csv"
awk -F, 'NR == 1 { named = $2 == "neo-hookean" }
  NR > 1 { n += 1; if (($2 - 300 * ($1 - 1 / $1 ^ 2))^2 > 0.01^2) wrong = 1 }
  END { exit wrong || !named || n != 9 }' "$work/law.csv" || die "The stresses of the laws are wrong."

# Breasts of the host's own.
build_example plugin
"$work/build_plugin/plugin" "$work/plugin/plugin.prm" | tee "$work/one.txt"
"${mpirun[@]}" "$work/build_plugin/plugin" "$work/plugin/plugin.prm" | tee "$work/two.txt"
# Simulations stop at 0.02 mm, which is half a percent of the distances.
paste <(grep -oE '[0-9.]+ mm' "$work/one.txt") <(grep -oE '[0-9.]+ mm' "$work/two.txt") |
  awk '{ n += 1; if (($1 - $3)^2 > (0.005 * $1)^2) wrong = 1 } END { exit wrong || n != 4 }' ||
  die "Two ranks give another result than one."

# That all this would notice a header missing from the package:
rm "$prefix/include/prosup/unloading/unloading_parameters.h"
! "$cmake" --build "$work/build_plugin" >"$work/broken.log" || die "A missing header went unnoticed."
grep -q "unloading_parameters.h" "$work/broken.log" || die "$(cat "$work/broken.log")"
