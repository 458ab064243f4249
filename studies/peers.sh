#!/usr/bin/env bash
# Correspondences of several methods side by side, ours and other tools', on the same shapes with the same number of
# landmarks: how far they carry marks and regions of people astray, how well they lie on the shapes, whether triangles
# are flipped or cross, and the time. Prints a Markdown table with one row a correspondence.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: studies/peers.sh --shapes FOLDER [option VALUE ...] [NAME=FOLDER ...]
  NAME=FOLDER               a model of foramen, or a folder of corresponding meshes of any tool under the names of the
                            shapes. A folder of another tool may hold a file seconds.txt with its computing time.
                            The row "default" comes first: the default model of the shapes is built for it, unless
                            default=FOLDER names one. Its mean.ply is a template for other tools.
  --shapes FOLDER           the surfaces
  --marks PATH              a file or folder with marks of people on them (docs/evaluation.md, Marks)
  --regions PATH            a file or folder with labels of their vertices
  --groups "ALL CL"         prefixes of names of curves: a column each, the mean over these curves
  --subject-regex PATTERN   the part of a file name that names its subject
  --landmarks 4000          of the default model
  --threads 0               0: all
  --output FOLDER           keeps the default model as default/, and metrics.json of every row as NAME.metrics/
  --program PATH            default: build/release/bin/foramen
TEXT
}

here=$(dirname "${BASH_SOURCE[0]}")
shapes="" marks="" regions="" groups="" subject_regex="" output=""
landmarks=4000
threads=0
program="$here/../build/release/bin/foramen"
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
[ -n "$shapes" ] || { usage >&2; exit 2; }
[ -x "$program" ] || { echo "$program: not there; ./dev build makes it" >&2; exit 1; }

work=$output
if [ -z "$work" ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$work"
subjects=()
[ -z "$subject_regex" ] || subjects=(--subject-regex "$subject_regex")
measured=()
[ -z "$marks" ] || measured+=(--marks "$marks")
[ -z "$regions" ] || measured+=(--regions "$regions")

case " ${rows[*]-}" in
  *" default="*) ;;
  *)
    echo "building the default model" >&2
    "$program" build "$shapes" -o "$work/default" --samples 1 --landmarks "$landmarks" "${subjects[@]}" --threads "$threads" --quiet
    rows=("default=$work/default" "${rows[@]}") ;;
esac

measures=()
for row in "${rows[@]}"; do
  name=${row%%=*}
  echo "measuring $name" >&2
  "$program" evaluate "${row#*=}" --shapes "$shapes" "${measured[@]}" "${subjects[@]}" --samples 1 --threads "$threads" \
    --quiet -o "$work/$name.metrics" >/dev/null
  measures+=("$name=$work/$name.metrics/metrics.json=${row#*=}")
done
/usr/bin/python3 "$here/peers_table.py" --groups "$groups" "${measures[@]}"
