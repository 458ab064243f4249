#!/usr/bin/env bash
# Measures how the time of each stage of a build grows with the number of shapes and with the number of vertices.
# Synthetic cohorts of one seed are built and evaluated; the wall times are those in run.json.
set -euo pipefail
export LC_ALL=C  # a point in numbers

usage() {
  cat <<'TEXT'
usage: studies/cohort_growth.sh [option VALUE ...]
  --shapes "14 28 56"       cohorts of these numbers of shapes, of 10000 vertices; "" for none
  --vertices "2500 5000 10000 20000 40000"
                            cohorts of 4 shapes of these numbers of vertices; "" for none
  --samples 100             random shapes for specificity (a build takes 1000)
  --landmarks 4000
  --seed 101
  --threads 0               0: all
  --program PATH            default: build/release/bin/foramen
TEXT
}

shapes="14 28 56"
vertices="2500 5000 10000 20000 40000"
samples=100
landmarks=4000
seed=101
threads=0
program="$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/foramen"
while [ $# -gt 0 ]; do
  case "$1" in
    -h|--help) usage; exit 0 ;;
    --shapes|--vertices|--samples|--landmarks|--seed|--threads|--program)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      printf -v "${1#--}" %s "$2"
      shift 2 ;;
    *) usage >&2; exit 2 ;;
  esac
done
[ -x "$program" ] || { echo "$program: not there; ./dev build makes it" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# build_cohort SHAPES VERTICES: writes SHAPESxVERTICES.json, the record of the build.
build_cohort() {
  local name="$1x$2"
  echo "building a cohort of $1 shapes of $2 vertices" >&2
  "$program" synth -n "$1" --vertices "$2" --seed "$seed" --threads "$threads" --quiet -o "$work/$name"
  "$program" build "$work/$name/shapes" -o "$work/$name/model" --samples "$samples" --landmarks "$landmarks" \
    --threads "$threads" --strict --json >/dev/null
  mv "$work/$name/model/run.json" "$work/$name.json"
  rm -rf "${work:?}/$name"
}

# seconds_of FILE STAGE: prints the seconds in the object seconds_by_stage. `all` is the whole run, including reading
# and writing.
seconds_of() {
  awk -v stage="\"$2\":" '
    /"seconds_by_stage"/ { inside = 1 }
    inside && $1 == stage { print $2 + 0; found = 1; exit }
    inside && /}/ { inside = 0 }
    stage == "\"all\":" && /^  "seconds":/ { print $2 + 0; found = 1; exit }
    END { exit !found }' "$1"
}

# table TITLE NAME...: prints a table of stages by cohorts, whose names are SHAPESxVERTICES.
table() {
  local title=$1 name stage
  shift
  printf '| %s |' "$title"
  for name in "$@"; do
    if [ "$title" = shapes ]; then printf ' %s |' "${name%x*}"; else printf ' %s |' "${name#*x}"; fi
  done
  printf '\n| --- |'
  printf ' --- |%.0s' "$@"
  printf '\n'
  for stage in reference register resample model evaluate all; do
    printf '| %s |' "$stage"
    for name in "$@"; do printf ' %.2f |' "$(seconds_of "$work/$name.json" "$stage")"; done
    printf '\n'
  done
  printf '\n'
}

echo "wall seconds; seed $seed, $landmarks landmarks, $samples random shapes for specificity, threads $threads (0: all)"
echo
names=()
for n in $shapes; do
  build_cohort "$n" 10000
  names+=("${n}x10000")
done
[ ${#names[@]} -eq 0 ] || table "shapes" "${names[@]}"
names=()
for v in $vertices; do
  build_cohort 4 "$v"
  names+=("4x$v")
done
[ ${#names[@]} -eq 0 ] || table "vertices" "${names[@]}"
