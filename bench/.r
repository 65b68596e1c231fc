#!/bin/bash
# render -- scenes of ../shared/peers/render as shaded pictures, by Sanggwan and by
# POV-Ray 3.7 at the same size: processor seconds, least of three (POV-Ray: once
# where it takes long). `picture` is that of the dots alone: a whole process with
# a PPM, less one with a picture of 8x5 dots; `whole` is a process with its PNG.
# The ratios are to a whole process of POV-Ray. Both with smooth edges (POV-Ray:
# +A0.3) but for c_plate1000, where POV-Ray's are not.
#
#   bench/render [WIDTHxHEIGHT]       1920x1080 unless told
set -eu
cd "$(dirname "$0")/.."
export B=${B:-build}
size=${1:-1920x1080}
peers=$PWD/../shared/peers/render
[ -e "$peers/scenes.py" ] || { echo "skipped: no ../shared/peers"; exit 0; }
command -v povray >/dev/null ||
  { echo "skipped: no povray (apt-get install povray)"; exit 0; }
make -s B="$B" all
work=$(realpath -m "$B")/bench/render
mkdir -p "$work"
python3 "$peers/scenes.py" "$work" >/dev/null

least() { # least TIMES COMMAND...: processor seconds
  local times=$1 i
  shift
  for ((i = 0; i < times; i++)); do
    { TIMEFORMAT='%U %S'; time "$@" >/dev/null 2>&1 </dev/null; } 2>&1
  done | awk '{ t = $1 + $2; if (NR == 1 || t < m) m = t } END { printf "%.2f", m }'
}

printf '%s dots\n%-14s %8s %8s %8s %8s %8s %8s\n' "$size" scene picture whole \
  POV-Ray ratio wanted whole
row() { # row SCENE AA WANTED TIMES
  local start dots whole peer
  start=$(least 3 ./sanggwan render -q "$work/$1.pl" --size 8x5 \
    -o "$work/$1.ppm")
  dots=$(least 3 ./sanggwan render -q "$work/$1.pl" --size "$size" \
    -o "$work/$1.ppm")
  whole=$(least 3 ./sanggwan render -q "$work/$1.pl" --size "$size" \
    -o "$work/$1.png")
  peer=$(least "$4" povray "+I$work/$1.pov" -D "+W${size%x*}" "+H${size#*x}" \
    "$2" +FN "+O$work/$1.pov.png")
  awk -v s="$1" -v a="$start" -v d="$dots" -v w="$whole" -v p="$peer" \
    -v g="$3" 'BEGIN { printf "%-14s %8.2f %8.2f %8.2f %8.3f %8s %8.3f\n",
      s, d - a, w, p, (d - a) / p, g, w / p }'
}


row c_plate1000 -A 0.03 1
row d_steinmetz +A0.3 0.15 3
row e_mix +A0.3 0.3 3
