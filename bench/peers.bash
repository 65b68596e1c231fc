# peers.bash -- the peers of ../shared/peers/boolean, made once; sourced by
# bench/curves and bench/booleans in the project's root.
#
# They and their inputs are made outside the project, in $work: PEERS_DIR, a
# folder under /tmp unless told. Needs python3 and, for the peers, the packages
# g++ libcgal-dev libgts-dev; a peer that cannot be built is left out, and with
# NO_PEERS=1 all are, and inputs of a million triangles. Two more are built from
# their sources, if they stand in $work: trueform (its headers; libtbb-dev) in
# $work/trueform, Manifold (cmake, libtbb-dev) in $work/manifold. $found lists
# those of ../shared that are there, comma before each, $built the two. Their
# clock is the processor's.
peers=$PWD/../shared/peers/boolean
[ -e "$peers/bench.py" ] || { echo "skipped: no ../shared/peers"; exit 0; }
work=${PEERS_DIR:-${TMPDIR:-/tmp}/sanggwan_peers}
mkdir -p "$work/bin" "$work/in"
make_peer() { # make_peer NAME COMMAND...
  [ -x "$work/bin/$1" ] || "${@:2}" -o "$work/bin/$1" "${last[@]}" \
    2>"$work/$1.log" || echo "left out: $1 ($work/$1.log)"
}
last=(-lm)
make_peer gen cc -O2 "$peers/gen.c"
make_peer check cc -O2 "$peers/check.c"
[ -e "$work/in/cyl1600_b.off" ] || swipl bench/cylinders.pl -- "$work/in"
found= built=
if [ -n "${NO_PEERS:-}" ]; then
  [ -e "$work/in/sph330k_b.off" ] || "$work/bin/gen" "$work/in"
  return
fi
read -ra last <<<"$(pkg-config --cflags --libs gts 2>/dev/null) -lm"
make_peer d_gts cc -O3 -include bench/processor_time.h "$peers/d_gts.c"
last=(-lgmp -lmpfr)
make_peer d_cgal g++ -O3 -DNDEBUG -frounding-math -std=c++17 \
  -include bench/processor_time.h "$peers/d_cgal.cpp"
last=(-ltbb)
make_peer d_trueform g++ -O3 -DNDEBUG -std=c++17 \
  -include bench/processor_time.h -I"$peers" -I"$work/trueform/include" \
  bench/trueform_driver.cpp
make_manifold() { # make_manifold ...: the library, then the driver
  local build=$work/manifold/build
  { [ -e "$build/src/libmanifold.a" ] ||
    { cmake -S "$work/manifold" -B "$build" -DCMAKE_BUILD_TYPE=Release \
        -DMANIFOLD_PAR=ON -DMANIFOLD_TEST=OFF -DMANIFOLD_CBIND=OFF \
        -DMANIFOLD_CROSS_SECTION=OFF -DMANIFOLD_DOWNLOADS=OFF \
        -DBUILD_SHARED_LIBS=OFF && make -C "$build" manifold; }; } >&2 &&
    g++ -O3 -DNDEBUG -std=c++17 -include bench/processor_time.h -I"$peers" \
      -I"$work/manifold/include" -I"$build/include" \
      bench/manifold_driver.cpp "$build/src/libmanifold.a" "$@"
}
make_peer d_manifold make_manifold
[ -e "$work/in/sph1300k_b.off" ] || "$work/bin/gen" "$work/in" big
for peer in cgal gts; do
  [ -x "$work/bin/d_$peer" ] && found=$found,$peer
done
for peer in manifold trueform; do
  [ -x "$work/bin/d_$peer" ] && built="$built $peer"
done
