#!/usr/bin/env bash
# check_layers.sh FOLDER "MODULE: USED..."... "MODULE/WING: USED..."...
# Fails when a file of a module under FOLDER (include/prosup/MODULE, src/MODULE)
# includes a header of a module that is not among those its module uses,
# directly or through others, or when a public header shows a library that the
# modules hide from programs outside. The same holds between the wings
# (subfolders) of a module, if they are named.
set -euo pipefail

folder=$1
shift
declare -A uses wing_uses
for arrow in "$@"; do
  if [[ ${arrow%%:*} == */* ]]; then
    wing_uses[${arrow%%:*}]=${arrow#*:}
  else
    uses[${arrow%%:*}]=${arrow#*:}
  fi
done
((${#uses[@]})) || { echo "No modules are given." >&2; exit 1; }

# reachable ARROWS NAME: a module or wing and all it uses, each as " name ".
reachable() {
  local -n arrows=$1
  local used
  printf ' %s ' "$2"
  for used in ${arrows[$2]}; do
    reachable "$1" "$used"
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
  allowed=$(reachable uses "$module")
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

for wing in "${!wing_uses[@]}"; do
  module=${wing%/*}
  allowed=$(reachable wing_uses "$wing")
  while IFS=: read -r file line; do
    other=${line#*[<\"]}
    other=${other#prosup/}
    other=${other%/*}
    [[ $allowed == *" $other "* ]] ||
      complain "$file: wing $wing may not include wing $other, which it does not use."
  done < <(includes "(prosup/)?$module/" "include/prosup/$wing" "src/$wing")
done

while IFS=: read -r file line; do
  complain "$file: a public header shows ${line##*[<\"]}; include it in the source file only."
done < <(includes 'itk|vtk|gmsh|nlohmann/|CLI/' include/prosup)

((n_includes > 0)) || complain "No include of a module was found under $folder."
((n_wrong == 0)) || exit 1
echo "$n_includes includes of ${#uses[@]} modules all point down."
