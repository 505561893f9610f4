#!/usr/bin/env bash
# check_install.sh BUILD_FOLDER CMAKE
# Installs the build to a temporary prefix and uses what is there as somebody does who has nothing
# else: help, manual pages, completion, and a registration of the sample.
set -euo pipefail

build=$1 cmake=$2
work=$(mktemp -d "${TMPDIR:-/tmp}/prosup-install-XXXXXX")
trap 'rm -rf "$work"' EXIT

die() {
  echo "$*" >&2
  exit 1
}

"$cmake" --install "$build" --prefix "$work/prefix" >"$work/install.log" || die "$(cat "$work/install.log")"
# Elsewhere than it was installed, it works as well.
mv "$work/prefix" "$work/moved"
prosup=$work/moved/bin/prosup
share=$work/moved/share

# completed WORD...: what the completion offers for the last of these words.
completed() {
  bash -c 'source "$1"; shift; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _prosup; echo "${COMPREPLY[*]}"' _ \
    "$share/bash-completion/completions/prosup" prosup "$@"
}
# options TEXT: those that a help or a page names.
options() {
  grep -oE -e '(^|[^-[:alnum:]])--[a-z][-a-z]*' <<<"$1" | grep -oE -e '--.*' | sort -u
}
# All that the help tells is on the page.
same_words() {
  local page=$share/man/man1/$1.1
  [[ -f $page ]] || die "There is no manual page $1."
  diff <(options "$2") <(options "$(sed 's/\\f[BIR]//g; s/\\-/-/g' "$page")") ||
    die "The page $1 has other options than the help."
}
help=$("$prosup" --help)
same_words prosup "$help"
mapfile -t commands < <(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' <<<"$help")
((${#commands[@]} > 10)) || die "The help lists ${#commands[@]} commands."
for command in "${commands[@]}"; do
  help=$("$prosup" "$command" --help)
  same_words "prosup-$command" "$help"
  diff <(options "$help") <(options "$(completed "$command" --)") ||
    die "$command has other options than its completion."
done
[[ " $(completed '') " == *" ${commands[0]} "*" ${commands[-1]} "* ]] || die "Commands are completed to $(completed '')."
[[ $(completed map --from s) == supine ]] || die "A state is completed to '$(completed map --from s)'."
[[ -z $(completed map --result '') ]] || die "A folder is completed to '$(completed map --result '')'."

# The sample on few voxels and a coarse mesh.
"$prosup" register "$share/prosup/prm/quickstart.prm" --output "$work/result" --quiet \
  --set "Images/Voxel edge=3" --set "Meshing/Edge length=12" --set "Material update/Levels=6" \
  --set "Image forces/Levels=6"
grep -q '"tre"' "$work/result/summary.json" || die "The sample has no errors at its landmarks."
echo "The installed program registers its sample; ${#commands[@]} commands have pages and completions."
