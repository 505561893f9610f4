#!/usr/bin/env bash
# check_links.sh FOLDER: fails when a page of FOLDER links to a file or heading that is not there, when
# docs/README.md does not list a page of docs, or when docs/theory.md names a file, or a class or function
# with its namespace, that the sources do not have.
set -euo pipefail

cd "$1"
n_wrong=0
complain() {
  echo "$1" >&2
  n_wrong=$((n_wrong + 1))
}

# As GitHub makes them: lower case, no punctuation, blanks to hyphens.
anchors() {
  sed -n '/^```/,/^```/d; s/^##* //p' "$1" | tr 'A-Z ' 'a-z-' | sed 's/[^a-z0-9_-]//g'
}

mapfile -t pages < <(find . -name '*.md' -not -path './build/*' -not -path './results/*' -not -path '*/wrong_links/*' | sort)
n_links=0
for page in "${pages[@]}"; do
  while read -r link; do
    n_links=$((n_links + 1))
    file=${link%%#*}
    [[ -z $file ]] && target=$page || target=$(dirname "$page")/$file
    [[ -e $target ]] || { complain "$page links to $link, which is not there."; continue; }
    [[ $link != *'#'* ]] || grep -qxF -- "${link#*#}" <(anchors "$target") ||
      complain "$page links to the heading $link, which is not there."
  done < <(sed '/^```/,/^```/d' "$page" | grep -oE '\]\([^) ]+\)' | sed 's/^](//; s/)$//' | grep -vE '^[a-z]+:' || true)
done
((n_links)) || complain "No page under $PWD has a link."

if [[ -f docs/README.md ]]; then
  for page in docs/*.md; do
    [[ $page == docs/README.md ]] || grep -qF "($(basename "$page"))" docs/README.md ||
      complain "docs/README.md does not list $page."
  done
fi

# What theory.md names as code; a file may be without its folder.
if [[ -f docs/theory.md ]]; then
  mapfile -t names < <(awk '/\*Code\*/,/^$/' docs/theory.md | grep -oE '`[^` ]+`' | tr -d '`()' | sort -u)
  for name in "${names[@]}"; do
    if [[ $name == *.* || $name == */ ]]; then
      [[ -e $name || -n $(find include src -name "$name") ]] || complain "docs/theory.md names $name, which is not there."
    else
      grep -rqwF "${name##*::}" include src || complain "docs/theory.md names $name, which no source has."
    fi
  done
fi
((n_wrong == 0)) || exit 1
echo "$n_links links of ${#pages[@]} pages lead somewhere."
