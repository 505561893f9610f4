#!/usr/bin/env bash
# check_layers.sh FOLDER "MODULE: USED..."...
# Fails when a file of a module under FOLDER (include/prosup/MODULE, src/MODULE)
# includes a header of a module that is not among those its module uses,
# directly or through others, or when a public header shows a library that the
# modules hide from programs outside.
set -euo pipefail

folder=$1
shift
declare -A uses
for arrow in "$@"; do
  uses[${arrow%%:*}]=${arrow#*:}
done
((${#uses[@]})) || { echo "No modules are given." >&2; exit 1; }

# A module and all it uses, each as " name ".
reachable() {
  local used
  printf ' %s ' "$1"
  for used in ${uses[$1]}; do
    reachable "$used"
  done
}

# includes PATTERN FOLDER...: lines "file:text" of matching includes.
includes() {
  local pattern=$1 existing=() path
  shift
  for path in "$@"; do
    [[ ! -d $path ]] || existing+=("$path")
  done
  ((${#existing[@]})) || return 0
  grep -rHoE "^ *# *include *[<\"]($pattern)[^>\"]*" "${existing[@]}" || true
}

n_includes=0
n_wrong=0
complain() {
  echo "$1" >&2
  n_wrong=$((n_wrong + 1))
}

cd "$folder"
for path in include/prosup/*/ src/*/; do
  [[ -d $path ]] || continue
  module=$(basename "$path")
  [[ -v uses[$module] ]] || complain "$path belongs to no module that CMakeLists.txt names."
done

for module in "${!uses[@]}"; do
  allowed=$(reachable "$module")
  while IFS=: read -r file line; do
    n_includes=$((n_includes + 1))
    if [[ $line == *..* ]]; then
      complain "$file: includes by a path with '..'; write \"prosup/<module>/<file>.h\"."
      continue
    fi
    other=${line##*prosup/}
    other=${other%%/*}
    [[ $allowed == *" $other "* ]] ||
      complain "$file: module $module may not include module $other, which it does not use."
  done < <(includes 'prosup/|\.\./' "include/prosup/$module" "src/$module")
done

while IFS=: read -r file line; do
  complain "$file: a public header shows ${line##*[<\"]}; include it in the source file only."
done < <(includes 'itk|vtk|gmsh|nlohmann/|CLI/' include/prosup)

((n_includes > 0)) || complain "No include of a module was found under $folder."
((n_wrong == 0)) || exit 1
echo "$n_includes includes of ${#uses[@]} modules all point down."
