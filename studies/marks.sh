#!/usr/bin/env bash
# Measures correspondences against what people marked on the shapes (docs/evaluation.md, Marks and Regions), and prints
# a Markdown table: one row a correspondence, ours or another tool's.
set -euo pipefail
export LC_ALL=C  # a point in numbers

usage() {
  cat <<'TEXT'
usage: studies/marks.sh --shapes FOLDER --marks FILES [option VALUE ...] [NAME=FOLDER ...]
  NAME=FOLDER               a model, or corresponding meshes of any tool under the names of the shapes; none: builds the
                            default model of all shapes
  --shapes FOLDER           the surfaces
  --marks PATH              a file or folder with their marks
  --regions PATH            a file or folder with labels of their vertices
  --groups "ALL CL"         prefixes of names of curves: a column each, the mean over these curves
  --subject-regex PATTERN   the part of a file name that names its subject
  --landmarks 4000
  --threads 0               0: all
  --output FOLDER           keeps metrics.json of every row as NAME/; default: nothing is kept
  --program PATH            default: build/release/bin/foramen
TEXT
}

shapes="" marks="" regions="" groups="" subject_regex="" output=""
landmarks=4000
threads=0
program="$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/foramen"
rows=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h|--help) usage; exit 0 ;;
    --shapes|--marks|--regions|--groups|--subject-regex|--landmarks|--threads|--output|--program)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      name=${1#--}
      printf -v "${name//-/_}" %s "$2"
      shift 2 ;;
    *=*) rows+=("$1"); shift ;;
    *) usage >&2; exit 2 ;;
  esac
done
if [ -z "$shapes" ] || [ -z "$marks$regions" ]; then usage >&2; exit 2; fi
[ -x "$program" ] || { echo "$program: not there; ./dev build makes it" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
subjects=()
[ -z "$subject_regex" ] || subjects=(--subject-regex "$subject_regex")
measured=()
[ -z "$marks" ] || measured+=(--marks "$marks")
[ -z "$regions" ] || measured+=(--regions "$regions")

if [ ${#rows[@]} -eq 0 ]; then
  echo "building the default model" >&2
  "$program" build "$shapes" -o "$work/model" --samples 1 --landmarks "$landmarks" "${subjects[@]}" --threads "$threads" --quiet
  rows=("default=$work/model")
fi

# figures FILE: prints NAME MEAN SE P95 for points, curves, every curve as curve/NAME, and dice. SE and P95 may be -.
figures() {
  awk '
    function flush() { if (name != "") print name, mean, error, p95; name = "" }
    { line = $0; gsub(/^ +|,$/, "", line); indent = match($0, /[^ ]/) - 1 }
    indent == 2 { section = line; part = ""; flush() }
    section !~ /^"(marks|regions)"/ { next }
    indent == 4 { flush(); part = line; if (line ~ /^"(points|curves|dice)": \{/) { split(line, word, "\""); name = word[2]; error = p95 = "-" } }
    part ~ /^"by_curve"/ && line == "{" { flush(); error = p95 = "-" }
    part ~ /^"by_curve"/ && line ~ /^"mark": / { split(line, word, "\""); name = "curve/" word[4] }
    line ~ /^"mean": / { mean = substr(line, 9) }
    line ~ /^"standard_error": [0-9]/ { error = substr(line, 19) }
    line ~ /^"p95": / { p95 = substr(line, 8) }
    END { flush() }' "$1"
}

# cell FIGURES NAME DIGITS: the mean and its standard error.
cell() {
  awk -v name="$2" -v digits="$3" '
    $1 == name { found = 1; printf "%.*f", digits, $2; if ($3 != "-") printf " ± %.*f", digits, $3 }
    END { if (!found) printf "-" }' "$1"
}
p95() { awk -v name="$2" '$1 == name { found = 1; printf "%.2f", $4 } END { if (!found) printf "-" }' "$1"; }
group() {
  awk -v prefix="curve/$2" 'index($1, prefix) == 1 { sum += $2; ++count }
    END { if (count) printf "%.2f", sum / count; else printf "-" }' "$1"
}

echo "mm and Dice coefficients, ± standard error over subjects where there are three"
printf '\n| correspondence | points mean | p95 | curves mean | p95 |'
for g in $groups; do printf ' %s |' "$g"; done
printf ' regions |\n| --- | --- | --- | --- | --- |'
for g in $groups; do printf ' --- |'; done
printf ' --- |\n'
for row in "${rows[@]}"; do
  name=${row%%=*}
  "$program" evaluate "${row#*=}" --shapes "$shapes" "${measured[@]}" "${subjects[@]}" --samples 1 --threads "$threads" \
    --quiet -o "$work/metrics" >/dev/null
  figures "$work/metrics/metrics.json" > "$work/figures"
  [ -z "$output" ] || { mkdir -p "$output/$name"; cp "$work/metrics/metrics.json" "$output/$name"; }
  printf '| %s | %s | %s | %s | %s |' "$name" "$(cell "$work/figures" points 2)" "$(p95 "$work/figures" points)" \
    "$(cell "$work/figures" curves 2)" "$(p95 "$work/figures" curves)"
  for g in $groups; do printf ' %s |' "$(group "$work/figures" "$g")"; done
  printf ' %s |\n' "$(cell "$work/figures" dice 4)"
done
