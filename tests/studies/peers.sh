#!/usr/bin/env bash
# peers.sh PROGRAM STUDIES: the table of studies/peers.sh for two models, a folder of another tool's meshes, and the
# truth, whose marks must be carried without error.
set -euo pipefail
program=$1
studies=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$program" synth -n 3 --vertices 1500 --quiet -o cohort
for method in torus icp; do
  "$program" build cohort/shapes --method $method --landmarks 400 --samples 1 --quiet -o $method
done
cp -r torus/corresponding other
echo 12.3 >other/seconds.txt

# The marks are the same few true vertices of every shape.
/usr/bin/python3 - <<'PYTHON'
import pathlib
import struct

lines = ["shape,landmark,kind,index,x,y,z"]
for file in sorted(pathlib.Path("cohort/truth").glob("*.ply")):
    header, data = file.read_bytes().split(b"end_header\n", 1)
    vertex = header.split(b"element vertex")[1].split(b"element")[0]
    kind, size = (b"d", 8) if b"double x" in vertex else (b"f", 4)
    for index in (0, 100, 700):
        at = struct.unpack_from("<3" + kind.decode(), data, 3 * size * index)
        lines.append(f"{file.stem},v{index},point,0," + ",".join(map(str, at)))
pathlib.Path("marks.csv").write_text("\n".join(lines) + "\n")
PYTHON

# The truth has another number of landmarks, which the table must say.
if "$studies/peers.sh" --program "$program" --shapes cohort/shapes --marks marks.csv \
    default=torus icp=icp other=other truth=cohort/truth >table 2>messages; then
  echo "different numbers of landmarks were not noticed"
  exit 1
fi
cat table messages
grep -q "numbers of landmarks differ" messages
column() { awk -F' *[|] *' -v name="$1" -v column="$2" '$2 == name { print $column }' table; }
[ "$(column truth 3)" = "0.00 ± 0.00" ]
[ "$(column other 3)" = "$(column default 3)" ]
[ "$(column other 8)" = "$(column default 8)" ]
[ "$(column other 13)" = 12 ]
[ "$(column icp 3)" != "$(column default 3)" ]
[ "$(column icp 13)" != - ]
