#!/usr/bin/env bash
# A build is killed at random moments and resumed; it must end with the bytes of a build that nobody disturbed.
#
# usage: kill_and_resume.sh PROGRAM WORK_FOLDER [--kills N] [--interrupts N] [--seed S] [--build "OPTIONS"] [SHAPES...]
#   --kills       builds ended by SIGKILL, each then resumed (default 2)
#   --interrupts  the same by SIGINT, which must end them with exit code 130 and nothing half-written (default 1)
#   --build       options of all builds
#   SHAPES        default: three small synthetic vertebrae
set -euo pipefail

program=$1 work=$2
shift 2
kills=2 interrupts=1 seed=1 options="--landmarks 300 --samples 20 --rounds 1" shapes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --kills) kills=$2 && shift 2 ;;
    --interrupts) interrupts=$2 && shift 2 ;;
    --seed) seed=$2 && shift 2 ;;
    --build) options=$2 && shift 2 ;;
    *) shapes+=("$1") && shift ;;
  esac
done

fail() { echo "FAILED: $*" >&2; exit 1; }
milliseconds() { echo $(($(date +%s%N) / 1000000)); }
build() { # in a subshell's place, so that $! is the program's
  # shellcheck disable=SC2086  # options are words
  exec "$program" build "${shapes[@]}" $options --quiet "$@"
}
# Every file of a model but run.json, hidden ones too, with its hash.
fingerprint() { (cd "$1" && find . -type f ! -name run.json -print0 | sort -z | xargs -0 sha256sum); }

rm -rf "$work" && mkdir -p "$work"
if [ "${#shapes[@]}" -eq 0 ]; then
  "$program" synth -n 3 --seed 4 --vertices 1500 --quiet -o "$work/synth"
  shapes=("$work/synth/shapes")
fi

start=$(milliseconds)
(build -o "$work/whole")
duration=$(($(milliseconds) - start))
[ ! -e "$work/whole/.resume" ] || fail "the store of finished stages is still there after success"
expected=$(fingerprint "$work/whole")
echo "undisturbed: $duration ms, $(wc -l <<<"$expected") files"

RANDOM=$seed
taken_up=0
disturbed_build() { # SIGNAL
  local signal=$1 model=$work/disturbed moment pid code stages
  while true; do
    code=0
    rm -rf "$model"
    moment=$((duration * (RANDOM % 1000) / 1000))
    build -o "$model" 2>"$work/messages" &
    pid=$!
    sleep "$((moment / 1000)).$(printf %03d $((moment % 1000)))"
    start=$(milliseconds)
    kill -s "$signal" "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || code=$?
    [ "$code" -eq 0 ] || break
    duration=$moment # it was done before: the machine is less busy than it was
  done
  echo -n "SIG$signal after $moment ms: exit code $code $(($(milliseconds) - start)) ms later"
  if [ "$signal" = INT ]; then
    [ "$code" -eq 130 ] || fail "exit code $code instead of 130: $(cat "$work/messages")"
    [ -z "$(find "$model" -name '*foramen-tmp*' 2>/dev/null)" ] || fail "left something half-written"
  fi
  (build --resume -o "$model") 2>"$work/messages" || fail "cannot be resumed: $(cat "$work/messages")"
  [ ! -s "$work/messages" ] || fail "$(cat "$work/messages")"
  stages=$(sed -n 's/.*"stages_taken_up": \([0-9]*\).*/\1/p' "$model/run.json")
  taken_up=$((taken_up + stages))
  echo ", resumed with $stages stages taken up"
  diff <(echo "$expected") <(fingerprint "$model") || fail "the resumed model differs from the undisturbed one"
}
for ((k = 0; k < interrupts; ++k)); do disturbed_build INT; done
for ((k = 0; k < kills; ++k)); do disturbed_build KILL; done
[ "$taken_up" -gt 0 ] || fail "no finished stage was ever taken up"
echo "all $((kills + interrupts)) resumed models are the undisturbed one; $taken_up stages taken up"
