#!/usr/bin/env bash
# The figures of the paper (Becker et al. 2011, Figs. 1-4) again, from real vertebrae: pictures, curves, and a page with
# the numbers beside them.
set -euo pipefail
export LC_ALL=C  # a point in numbers, one order of files
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
  cat <<'TEXT'
usage: tests/figures/make_figures.sh [option VALUE ...] [SHAPE ...]
  SHAPE                surfaces to use instead of the 14 real vertebrae L1 to L3, ../shared/data/lumbar/*_L[123].ply
  --output FOLDER      default: docs/figures
  --models FOLDER      keeps the two models there, as default/ and icp/, and takes those that are there already;
                       default: they are made and not kept
  --samples 100        random shapes for specificity
  --landmarks 4000
  --threads 0          0: all
  --program PATH       default: build/release/bin/foramen
TEXT
}

fail() { echo "make_figures.sh: $1" >&2; exit 1; }

output=docs/figures
models=""
samples=100
landmarks=4000
threads=0
program=build/release/bin/foramen
shapes=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h|--help) usage; exit 0 ;;
    --output|--models|--samples|--landmarks|--threads|--program)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      printf -v "${1#--}" %s "$2"
      shift 2 ;;
    -*) usage >&2; exit 2 ;;
    *) shapes+=("$1"); shift ;;
  esac
done

real=no
if [ ${#shapes[@]} -eq 0 ]; then
  real=yes
  shopt -s nullglob
  shapes=(../shared/data/lumbar/*_L[123].ply)
  [ ${#shapes[@]} -eq 14 ] || fail "../shared/data/lumbar holds ${#shapes[@]} of the 14 vertebrae *_L[123].ply: put the data \
beside the project, or name surfaces of your own"
fi
[ -x "$program" ] || fail "$program: not there; ./dev build makes it"
display=()
if [ -z "${DISPLAY:-}" ]; then
  command -v xvfb-run >/dev/null || fail "there is no display, and no xvfb-run: install xvfb and xauth"
  display=(xvfb-run -a)
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ -n "$models" ] || models=$work/models

# build_model NAME OPTION...
build_model() {
  local name=$1
  shift
  [ ! -f "$models/$name/metrics.json" ] || { echo "taking $models/$name" >&2; return 0; }
  echo "building $models/$name" >&2
  "$program" build "${shapes[@]}" "$@" -o "$models/$name" --samples "$samples" --landmarks "$landmarks" \
    --threads "$threads" --quiet
}
build_model default
build_model icp --method icp

"${display[@]}" "$program" render "$models/default" --baseline "$models/icp" -o "$work/pictures" > "$work/captions"
"$program" compare "$models/default" "$models/icp" -o "$work/comparison" > "$work/tables"

# caption FILE: what `foramen render` says of it.
caption() { grep -F "/$1: " "$work/captions" | sed "s|^.*/$1: ||"; }
# tables TITLE...: the tables of `foramen compare` whose first line begins so, which blank lines part.
tables() {
  local title
  for title in "$@"; do
    printf '```\n'
    awk -v RS= -v title="$title" 'index($0, title) == 1 { gsub(/ +\n/, "\n"); sub(/ +$/, ""); print; found = 1; exit }
      END { if (!found) exit 1 }' "$work/tables" ||
      fail "\`foramen compare\` printed no table \"$title\""
    printf '```\n\n'
  done
}
# picture FILE: under what was said of it.
picture() { printf '![%s](%s)\n\n' "$(tr _ ' ' <<< "${1%.*}")" "$1"; }
# prose TEXT: in lines that an editor shows whole.
prose() { fold -s -w 118 <<< "$1" | sed 's/ *$//'; echo; }
figure() { printf '## %s\n\n' "$1"; prose "$2"; }

files=(overview.png flips.png first_mode_beside.png generalization.svg specificity.svg ensemble_generalization.svg modes.png
  distances_mean.png distances_worst.png)
page() {
  printf '# The paper'"'"'s figures again\n\n'
  prose "The script \`tests/figures/make_figures.sh\` (target \`figures\`) makes this page and its pictures from ${#shapes[@]} \
vertebrae. Nothing here is edited by hand."
  prose "Two models of $landmarks landmarks are compared: \`default\` (\`foramen build\`) and \`icp\`, the closest-point \
baseline (\`foramen build --method icp\`), with $samples random shapes for specificity. The numbers are those of their \
metrics.json, as \`foramen compare\` prints them. [Measures](../evaluation.md) defines each of them."
  if [ "$real" = yes ]; then
    prose "**Licence.** The shapes are real lumbar vertebrae L1 to L3 of five patients from the VerSe data set. These pictures \
are adaptations of it and stay under [CC BY-SA 4.0](https://creativecommons.org/licenses/by-sa/4.0/). The Apache-2.0 licence \
of the project does not cover this folder."
    prose "Please cite: Sekuboyina et al., \"VerSe: A vertebrae labelling and segmentation benchmark for multi-detector CT \
images\", Medical Image Analysis 73, 2021; Loeffler et al., \"A vertebral segmentation dataset with fracture grading\", \
Radiology: Artificial Intelligence, 2020."
  fi
  figure "Fig. 1: overview" "$(caption overview.png)."
  picture overview.png
  figure "Fig. 2: flipped triangles" "$(caption flips.png)."
  picture flips.png
  tables "Representation and flips"
  figure "Fig. 3: the first mode" "$(caption first_mode_beside.png). Each triangle is shaded flat, so that folds show."
  picture first_mode_beside.png
  figure "Fig. 4: generalization and specificity" "Bars are standard errors of the mean. The third chart is the paper's own form \
of generalization, the distance to the closest of the random shapes. It gets worse with variance, so it is not the figure to \
choose a model by."
  picture generalization.svg
  picture specificity.svg
  picture ensemble_generalization.svg
  tables "Generalization, Hausdorff (leave one out)" "Specificity, Hausdorff" "Specificity beside what it may have cost"
  figure "Beyond the paper: the modes" "$(caption modes.png)."
  picture modes.png
  figure "Beyond the paper: distance to the inputs" "$(caption distances_mean.png)."
  picture distances_mean.png
  prose "$(caption distances_worst.png)."
  picture distances_worst.png
}
page > "$work/README.md"

mkdir -p "$output"
for file in "${files[@]}"; do cp "$work/pictures/$file" "$output/$file"; done
cp "$work/README.md" "$output/README.md"
echo "wrote $output/README.md"
