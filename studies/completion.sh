#!/usr/bin/env bash
# Completes real vertebrae whose posterior elements are removed, by models without shapes of their subject. Prints a
# Markdown table, with the average over shapes for every method.
set -euo pipefail
export LC_ALL=C  # a point in numbers

usage() {
  cat <<'TEXT'
usage: studies/completion.sh [option VALUE ...] SHAPE...
  SHAPE...                  surfaces in LPS, named SUBJECT_LEVEL.ply
  --program FILE            foramen (default build/release/bin/foramen)
  --study FILE              completion_study (default build/release/bin/completion_study; needs -DFORAMEN_BUILD_BENCH=ON)
  --models FOLDER           keeps the models here, and takes those that are there (default: made and removed)
  --study-options "..."     passed on, see completion_study --help
TEXT
}

here=$(cd "$(dirname "$0")/.." && pwd)
program=$here/build/release/bin/foramen study=$here/build/release/bin/completion_study models="" options="" shapes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --program) program=$2; shift 2 ;;
    --study) study=$2; shift 2 ;;
    --models) models=$2; shift 2 ;;
    --study-options) options=$2; shift 2 ;;
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *) shapes+=("$1"); shift ;;
  esac
done
[ ${#shapes[@]} -gt 0 ] || { usage >&2; exit 2; }
if [ -z "$models" ]; then
  models=$(mktemp -d)
  trap 'rm -rf "$models"' EXIT
fi

subject_of() { basename "$1" | sed 's/_.*//'; }

{
  for subject in $(for shape in "${shapes[@]}"; do subject_of "$shape"; done | sort -u); do
    of_subject=() others=()
    for shape in "${shapes[@]}"; do
      if [ "$(subject_of "$shape")" = "$subject" ]; then of_subject+=("$shape"); else others+=("$shape"); fi
    done
    model=$models/without_$subject
    [ -e "$model/run.json" ] || "$program" build "${others[@]}" --samples 2 -o "$model" --quiet
    # shellcheck disable=SC2086
    "$study" $options "$model" "${of_subject[@]}"
  done
} | awk -F' *[|] *' '
  BEGIN { print "| shape | method | mean | true to it | it to true | p95 | largest | landmarks |\n| --- | --- | --- | --- | --- | --- | --- | --- |" }
  { print
    if (!($3 in count)) order[++methods] = $3
    ++count[$3]
    for (k = 4; k <= 8; ++k) sum[$3, k] += $k }
  END {
    for (m = 1; m <= methods; ++m) {
      method = order[m]
      printf "| average of %d | %s |", count[method], method
      for (k = 4; k <= 8; ++k) printf " %.2f |", sum[method, k] / count[method]
      print " |" } }'
