#!/usr/bin/env bash
# figures_test.sh PROGRAM FOLDER: the script on a small synthetic cohort makes every figure that its page shows.
set -euo pipefail
program=$1
folder=$2
script=$(dirname "${BASH_SOURCE[0]}")/make_figures.sh
if [ -z "${DISPLAY:-}" ] && ! command -v xvfb-run >/dev/null; then
  echo "skipped: needs a display or xvfb-run"
  exit 77
fi
rm -rf "$folder"
mkdir -p "$folder"
"$program" synth -n 4 --seed 7 --vertices 2500 -o "$folder/synth" --quiet
"$script" --program "$program" --output "$folder/figures" --landmarks 400 --samples 5 "$folder"/synth/shapes/*.ply

shown=$(sed -n 's/^!\[.*\](\(.*\))$/\1/p' "$folder/figures/README.md")
[ "$(wc -l <<< "$shown")" -eq 9 ] || { echo "the page shows: $shown" >&2; exit 1; }
for file in $shown; do [ -s "$folder/figures/$file" ] || { echo "$file: is not there" >&2; exit 1; }; done
grep -q '^plain  *[0-9]' "$folder/figures/README.md" || { echo "the page has no counts of flips" >&2; exit 1; }
if grep -q 'VerSe' "$folder/figures/README.md"; then echo "synthetic shapes are said to be real" >&2; exit 1; fi
