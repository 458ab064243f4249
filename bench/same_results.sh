#!/usr/bin/env bash
# Whether two commits make the same results: both are built on this machine and run in turn on the same inputs. The
# bytes that they write, their CPU seconds and their peak memory are compared. A commit that moves code must write the
# same bytes. The message of a commit that joins two copies of something quotes the shift and the metrics printed here.
#
#   bench/same_results.sh main HEAD                                      every job once
#   bench/same_results.sh --jobs "truth project" --cpu 0 HEAD worktree   before committing: the working tree as it is
#   bench/same_results.sh --shift 1e-3 --repeat 3 main HEAD              points may move by 0.001 mm; less noise in CPU
set -euo pipefail
shopt -s inherit_errexit
export LC_ALL=C  # a point in numbers

usage() {
  cat <<'TEXT'
usage: bench/same_results.sh [option VALUE ...] OLD NEW
  OLD NEW                   commits, built once each in build/same_results/COMMIT without viewer and Python; or the word
                            worktree: the working tree, built in build/release as that is configured
  --jobs "..."              some of: lumbar labels truth paper icp project complete large; default: all but large
  --large                   large too: 200 shapes of 40000 vertices (3.3 GB, an hour and more)
  --shift 0                 no corresponding point may move by more [mm], the triangles being the same; 0: the bytes
                            must be the same
  --cpu 1.03                no job's CPU seconds may grow by more than this ratio; 0: not judged
  --memory 1.05             nor its peak memory; 0: not judged
  --repeat 1                runs of each job on each side; the least CPU seconds and peak memory of them count
  --threads 0               of every run; 0: all; with 1 the peak memory varies least
  --samples 20              random shapes for specificity
  --worst 12                changed metrics to print of each job; changed.csv of the kept folder has all
  --keep FOLDER             keeps what both sides wrote as FOLDER/JOB/old and FOLDER/JOB/new
  -j N                      compilers at once; default: as many as processors
Jobs: lumbar, the 14 real L1 to L3; labels, the label map verse004; truth, four synthetic shapes with --truth; paper and
icp, the same with --paper and with --method icp; project and complete, one shape and a part of it with a model that has
not seen it. Synthetic inputs and that model are made once, by OLD. The real data are looked for in ../shared/data.
Exit code: 0 within the bounds, 1 not (the reasons come last), 2 usage.
TEXT
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
python=/usr/bin/python3
data=$root/../shared/data
jobs="lumbar labels truth paper icp project complete"
large="" shift=0 cpu=1.03 memory=1.05 repeat=1 threads=0 samples=20 worst=12 keep="" j=$(nproc)
revisions=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h|--help) usage; exit 0 ;;
    --large) large=yes; shift ;;
    --jobs|--shift|--cpu|--memory|--repeat|--threads|--samples|--worst|--keep|-j)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      name=${1#-}
      printf -v "${name#-}" %s "$2"
      shift 2 ;;
    -*) usage >&2; exit 2 ;;
    *) revisions+=("$1"); shift ;;
  esac
done
[ ${#revisions[@]} -eq 2 ] || { usage >&2; exit 2; }
[ -z "$large" ] || jobs+=" large"
for job in $jobs; do
  case " lumbar labels truth paper icp project complete large " in
    *" $job "*) ;;
    *) echo "--jobs: $job is none of lumbar labels truth paper icp project complete large" >&2; exit 2 ;;
  esac
done

# compiled TREE CMAKE-OPTION...: builds TREE/build/release/bin/foramen. The compiler's messages are shown if it fails.
compiled() {
  local tree=$1 log
  shift
  mkdir -p "$tree/build"
  log=$tree/build/same_results.log
  echo "building $tree" >&2
  (cd "$tree" && cmake --preset release "$@" && cmake --build --preset release --target foramen -j "$j") >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2; exit 1; }
}

# program_of REVISION: prints the path of the revision's program, which is built first if it does not exist.
program_of() {
  local tree=$root commit
  if [ "$1" = worktree ]; then
    compiled "$tree"
  else
    commit=$(git -C "$root" rev-parse --verify --quiet "$1^{commit}") || { echo "$1: no such commit" >&2; exit 2; }
    tree=$root/build/same_results/${commit:0:12}
    # A folder that was removed by hand is still registered as a worktree, hence --force.
    [ -e "$tree/.git" ] || git -C "$root" worktree add --quiet --force --detach "$tree" "$commit" >&2
    [ -x "$tree/build/release/bin/foramen" ] || compiled "$tree" -DFORAMEN_VIEWER=OFF -DFORAMEN_PYTHON=OFF
  fi
  echo "$tree/build/release/bin/foramen"
}

old=$(program_of "${revisions[0]}")
new=$(program_of "${revisions[1]}")
if [ -n "$keep" ]; then
  mkdir -p "$keep"
  work=$(cd "$keep" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

# Inputs made by a program are kept for the next comparison with the same OLD.
inputs=$root/build/same_results/inputs/$(sha256sum "$old" | cut -c 1-12)
mkdir -p "$inputs"

# input NAME ARGUMENT...: makes a folder of inputs by running OLD with these arguments. The folder appears whole or not
# at all.
input() {
  local folder=$inputs/$1
  shift
  [ ! -e "$folder" ] || return 0
  rm -rf "$folder.part"
  "$old" "$@" --threads "$threads" --quiet -o "$folder.part" || exit 1
  mv "$folder.part" "$folder"
}

# prepare JOB: makes the inputs of the job and sets `arguments`, the arguments of the program. Fails with the reason if
# the data is missing.
prepare() {
  # After ;;& the following patterns are tried as well.
  local lumbar=("$data"/lumbar/*_L[123].ply)
  case "$1" in
    lumbar)
      [ -e "${lumbar[0]}" ] || { echo "no $data/lumbar"; return 1; }
      arguments=(build "${lumbar[@]}" --samples "$samples") ;;
    labels)
      [ -e "$data/labels/verse004.nii.gz" ] || { echo "no $data/labels/verse004.nii.gz"; return 1; }
      arguments=(build "$data/labels/verse004.nii.gz" --labels 20-24 --samples "$samples") ;;
    truth|paper|icp|project|complete)
      input cohort synth -n 4 --seed 101
      arguments=(build "$inputs/cohort/shapes" --truth "$inputs/cohort/truth" --samples "$samples") ;;&
    paper) arguments+=(--paper) ;;
    icp) arguments+=(--method icp) ;;
    project|complete)
      input model build "$inputs/cohort/shapes" --samples 2
      input other synth -n 1 --seed 102
      # The copy has a name that no shape of the model has, because `project` leaves out a shape with the same name.
      cp "$inputs/other/shapes/synth001.ply" "$inputs/stranger.ply" || exit 1
      arguments=("$1" "$inputs/model" "$inputs/stranger.ply") ;;&
    complete)
      "$python" "$root/bench/same_results.py" cut "$inputs/stranger.ply" "$inputs/part.ply" || exit 1
      arguments[2]=$inputs/part.ply ;;
    large)
      input large synth -n 200 --seed 101 --vertices 40000
      arguments=(build "$inputs/large/shapes" --samples 10) ;;
  esac
}

version_of() { "$1" --version | sed 's/.* //'; }

for job in $jobs; do
  rm -rf "${work:?}/$job"
  mkdir -p "$work/$job"
  prepare "$job" >"$work/$job/skipped" || { echo "skipped: $job, $(cat "$work/$job/skipped")" >&2; continue; }
  rm "$work/$job/skipped"
  for ((run = 1; run <= repeat; ++run)); do
    for side in old new; do
      echo "running $job, $side" >&2
      rm -rf "${work:?}/$job/$side"
      "$python" "$root/bench/measured_run.py" "$work/$job/$side.figures" "$work/$job/$side.log" \
        "${!side}" "${arguments[@]}" --threads "$threads" --quiet -o "$work/$job/$side"
    done
  done
done

echo "old: ${revisions[0]}, new: ${revisions[1]}; threads $threads (0: all), runs of each: $repeat"
echo
# shellcheck disable=SC2086
"$python" "$root/bench/same_results.py" report "$work" $jobs --versions "$(version_of "$old")" "$(version_of "$new")" \
  --shift "$shift" --cpu "$cpu" --memory "$memory" --worst "$worst"
