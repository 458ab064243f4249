#!/usr/bin/env bash
# write_files.sh PROGRAM FOLDER: a small build in FOLDER/model, and all that `foramen convert` makes of it.
set -euo pipefail
program=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$program" synth -n 4 --seed 7 --vertices 2500 -o synth
"$program" build synth/shapes --method icp --landmarks 300 --samples 20 --quiet -o model
"$program" convert model -o model.h5.json
"$program" convert model -o study/model.swproj
"$program" convert model -o landmarks.tps
"$program" convert model -o landmarks.csv
"$program" convert model --to scores -o scores.csv
"$program" convert model --to vtp -o vtp
"$program" convert model --to landmarks -o landmarks
"$program" convert model/corresponding -o from_meshes.h5
"$program" convert study/model.swproj --triangles model/mean.ply -o from_shapeworks.h5
