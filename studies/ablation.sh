#!/usr/bin/env bash
# Measures what each part of the correspondence contributes: builds the same sets of shapes with parts left out or
# replaced, and prints a Markdown table for each set.
set -euo pipefail
export LC_ALL=C  # a point in numbers

usage() {
  cat <<'TEXT'
usage: studies/ablation.sh [option VALUE ...] [COHORT ...]
  COHORT                    folders with shapes/ and truth/, as `foramen synth` writes them; none: makes --seeds and
                            --free-seeds
  --seeds "201 202 203"     synthetic cohorts of four true modes; "" for none
  --free-seeds "204"        synthetic cohorts whose shapes have each their own deformation (--modes 0); "" for none
  --shapes 14               of a synthetic cohort
  --vertices 10000          of a synthetic shape
  --real FOLDER             shapes without known correspondence as one more set; may be repeated
  --variants "..."          some of: icp neighbours paper rigid plane single smooth default description; all but paper
  --paper                   paper too (slow)
  --landmarks 4000
  --samples 1               random shapes for specificity, which the table does not show
  --threads 0               0: all
  --output FOLDER           keeps run.json and metrics.json of every build as SET/VARIANT/; default: nothing is kept
  --program PATH            default: build/release/bin/foramen
TEXT
}

seeds="201 202 203"
free_seeds="204"
shapes=14
vertices=10000
variants="icp neighbours rigid plane single smooth default description"
landmarks=4000
samples=1
threads=0
output=""
program="$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/foramen"
real=()
cohorts=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h|--help) usage; exit 0 ;;
    --paper) with_paper=yes; shift ;;
    --seeds|--free-seeds|--shapes|--vertices|--real|--variants|--landmarks|--samples|--threads|--output|--program)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      name=${1#--}
      if [ "$name" = real ]; then real+=("$2"); else printf -v "${name//-/_}" %s "$2"; fi
      shift 2 ;;
    -*) usage >&2; exit 2 ;;
    *) cohorts+=("$1"); shift ;;
  esac
done
[ -z "${with_paper:-}" ] || variants+=" paper"
[ -x "$program" ] || { echo "$program: not there; ./dev build makes it" >&2; exit 1; }
for folder in "${cohorts[@]}"; do
  if [ ! -d "$folder/shapes" ] || [ ! -d "$folder/truth" ]; then
    echo "$folder: holds no shapes/ and truth/; for shapes of unknown correspondence give --real $folder" >&2
    exit 1
  fi
done

# options_of VARIANT: prints the options of `foramen build` for the variant.
options_of() {
  case "$1" in
    icp) echo "--method icp" ;;
    neighbours) echo "--objective neighbours" ;;
    paper) echo "--paper" ;;
    rigid) echo "--bending rigid --rounds 0" ;;
    plane) echo "--rounds 0 --distortion plane" ;;
    single) echo "--rounds 0" ;;
    smooth) echo "--bending smooth" ;;
    default) echo "" ;;
    description) echo "--objective description" ;;
    *) echo "--variants: $1 is not one of icp neighbours paper rigid plane single smooth default description" >&2; return 2 ;;
  esac
}
for variant in $variants; do options_of "$variant" >/dev/null; done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# flattened FILE: prints a line with path and value for every number of a JSON file that foramen wrote. The path names
# an element of an array by its number of modes.
flattened() {
  awk '
    { value = $0; gsub(/^ +|,$/, "", value); key = "" }
    match(value, /^"[^"]*": /) { key = substr(value, 2, RLENGTH - 4); value = substr(value, RLENGTH + 1) }
    { first = substr(value, 1, 1) }
    first == "]" || first == "}" { --depth; next }
    value == "{" || value == "[" { path[++depth] = key; next }
    key == "modes" { path[depth] = value }
    { text = ""; for (i = 2; i <= depth; ++i) text = text path[i] "/"; print text key, value }' "$1"
}

# number FLATTENED PATH [FORMAT]: prints the number, or - if it does not exist.
number() {
  awk -v path="$2" -v format="${3:-%.3f}" '
    $1 == path { printf format, $2; found = 1; exit }
    END { if (!found) printf "-" }' "$1"
}

# quoted_modes FLATTENED: prints 8, or the largest number of modes below 8 if there is no 8.
quoted_modes() {
  awk '$1 ~ /^generalization\/by_modes\/[0-9]+\/modes$/ && $2 <= 8 { modes = $2 }
       END { print modes }' "$1"
}

# build_variant SET VARIANT OPTION...: builds the variant and writes SET.VARIANT, the flattened run.json and
# metrics.json.
build_variant() {
  local set=$1 variant=$2 model="$work/model"
  shift 2
  echo "building $set: $variant" >&2
  rm -rf "$model"
  # shellcheck disable=SC2046
  "$program" build "$@" $(options_of "$variant") -o "$model" --samples "$samples" --landmarks "$landmarks" \
    --threads "$threads" --quiet || return 1
  { flattened "$model/metrics.json"; flattened "$model/run.json"; } > "$work/$set.$variant"
  [ -z "$output" ] || { mkdir -p "$output/$set/$variant"; cp "$model/run.json" "$model/metrics.json" "$output/$set/$variant"; }
}

# ratio FLATTENED BASELINE PATH
ratio() {
  local a b
  a=$(number "$1" "$3" %.9g)
  b=$([ -e "$2" ] && number "$2" "$3" %.9g || echo -)
  awk -v a="$a" -v b="$b" 'BEGIN { if (a == "-" || b == "-") printf "-"; else printf "%.2f", a / b }'
}

row() {
  local file="$work/$1.$2" g
  g="generalization/by_modes/$(quoted_modes "$file")"
  printf '| %s |' "$2"
  printf ' %s |' "$(grep -c '^shapes//status "\(used\|reference\)"' "$file" || true)" \
    "$(number "$file" truth/error/mean)" "$(number "$file" truth/error/p95)" "$(ratio "$file" "$work/$1.icp" truth/error/mean)" \
    "$(number "$file" representation/mean_mm/mean)" "$(number "$file" representation/hausdorff_mm/mean)" \
    "$(number "$file" "$g/hausdorff_mm/mean")" "$(number "$file" "$g/mean_surface_mm/mean")" \
    "$(number "$file" representation/plain_flips/mean %.1f)" "$(number "$file" representation/confirmed_flips/mean %.1f)" \
    "$(number "$file" total_variance_mm2)" "$(number "$file" seconds_by_stage/register %.1f)"
  printf '\n'
}

# table SET OPTION...
table() {
  local set=$1 variant
  shift
  printf '\n%s\n\n' "$set"
  printf '| variant | shapes used | truth error mean | p95 | mean to that of icp | representation mean | Hausdorff '
  printf '| generalization Hausdorff | mean surface | plain flips | confirmed | total variance | registration s |\n'
  printf '| ---%.0s ' 1 2 3 4 5 6 7 8 9 10 11 12 13
  printf '|\n'
  for variant in $variants; do
    if build_variant "$set" "$variant" "$@"; then row "$set" "$variant"; else printf '| %s | failed | | | | | | | | | | | |\n' "$variant"; fi
  done
}

# synthetic SET SEED OPTION...
synthetic() {
  local set=$1 seed=$2
  shift 2
  "$program" synth -n "$shapes" --vertices "$vertices" --seed "$seed" "$@" --threads "$threads" --quiet -o "$work/$set"
  table "$set" "$work/$set/shapes" --truth "$work/$set/truth"
}

echo "mm, mm^2 a landmark, wall seconds; $landmarks landmarks, generalization at 8 modes (or the most there are), threads $threads (0: all)"
if [ ${#cohorts[@]} -gt 0 ]; then
  for folder in "${cohorts[@]}"; do table "$(basename "$folder")" "$folder/shapes" --truth "$folder/truth"; done
else
  for seed in $seeds; do synthetic "seed$seed" "$seed"; done
  for seed in $free_seeds; do synthetic "free$seed" "$seed" --modes 0; done
fi
for folder in "${real[@]}"; do table "$(basename "$folder")" "$folder"; done
