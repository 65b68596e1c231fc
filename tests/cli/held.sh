# held.sh -- every verb and every format, again and again in one process: what
# our library holds of memory does not grow; also where they are stopped, or
# refused memory.
. "$(dirname "$0")/../check.sh"

say() { local IFS=$'\t'; printf '%s\n' "$*"; }
o=$TMP/out
mkdir "$o"
sed '/^4 3 2 1 0/d; s/^8 6/8 5/' >"$o/open.off" <<'END'
OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END
echo 'OFF 4 oops' >"$o/bad.off"
echo 'v(1,1,0,0,0). p(1,1,[1,2,3]).' >"$o/bad.pl"
cat >"$o/m.csg" <<'END'
difference() { cube(size = [2, 2, 2], center = false); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,-1],[0,0,0,1]]) { cylinder($fn = 12, $fa = 12, $fs = 2, h = 5, r1 = 0.5, r2 = 0.5, center = false); } }
END
{
  say check facts/cube.pl facts/two_cubes.pl
  say check facts/wire_and_roof.pl --strict
  say check facts/hollow_block.pl --json
  say convert facts/primitives.pl -o "$o/all.pl"
  for ending in stl off obj ply; do
    say convert facts/two_cubes.pl -o "$o/two.$ending"
    say check "$o/two.$ending"
  done
  say convert "$o/m.csg" -o "$o/m.stl"
  say check "$o/m.stl"
  say check "$o/bad.off"
  say check "$o/bad.pl"
  say check "$o/open.off"
  say union "$o/open.off" facts/cube.pl -o "$o/u.off"
  say union "$o/open.off" --repair -o "$o/u.off"
  say union facts/two_cubes.pl -o "$o/u.off"
  say intersection facts/figures/fig13.pl facts/cube.pl -o "$o/i.off"
  say difference facts/two_cubes.pl facts/hollow_block.pl -o "$o/d.pl"
  say split facts/hollow_block.pl --plane 0,0,1,-0.5 -o "$o/s.obj"
  say split facts/hollow_block.pl --by facts/cube.pl -o "$o/s.obj"
  say eval facts/pipe_tee.pl -o "$o/e.stl"
  say penetrate facts/two_cubes.pl --format csv
  say penetrate facts/figures/fig13.pl --exact --format csv
  say penetrate facts/wire_and_roof.pl --tolerance 0.01
  say penetrate facts/pipes.pl --format csv
  for ending in svg pdf dxf hpgl png json eps; do
    say draw facts/two_cubes.pl --view iso -o "$o/d.$ending"
  done
  say draw facts/pipe_tee.pl --lines all --hidden removed -o "$o/t.svg"
  say draw facts/smooth.pl --view top -o "$o/c.svg"
  say draw facts/two_cubes.pl --sheet A4 --section y -o "$o/s.pdf"
  say draw facts/hollow_block.pl --style facts/styles/ghost.pl -o "$o/g.svg"
  say draw facts/primitives.pl --view top -o "$o/p.svg"
  say unfold facts/cube.pl --cut 1-3 -o "$o/f.pl"
  say unfold facts/patterns/house.pl --page A3 --tabs 5 -o "$o/h.svg"
  say unfold facts/patterns/elbow.pl --true -o "$o/w.dxf"
  say unfold facts/patterns/hopper.pl --thickness 0.1 -o "$o/w.svg"
  say query facts/cube.pl 'retract_fact(v(1,1,_,_,_), [cascade(true)]), e(1,E,A,B,_)'
  say query facts/two_cubes.pl 'penetrate, line(L,A,P,U,V,B,Q,X,Y)' --limit 2
  say explain facts/two_cubes.pl 'line(1)'
  say explain facts/two_cubes.pl 'hidden(_,_)' --view iso
  say explain facts/two_cubes.pl 'pair(1,2)' --lang ko
  say explain facts/cube.pl 'seam(_)' --minimize pieces
  for name in crossing cycles face mixed; do
    say cells "facts/figures/glue_$name.pl" --neighbours
  done
  for ending in csv dot poly geo obj off json stl pl; do
    say cells facts/two_rooms.pl -o "$o/c.$ending"
  done
  say check "$o/c.json"
  say convert "$o/c.obj" --faces 10 -o "$o/less.off"
  say glue facts/cube.pl facts/hollow_block.pl -o "$o/g.pl"
  say unglue "$o/g.pl" -o "$o/n.pl"
  say unglue "$o/g.pl" --region 1 -o "$o/r.pl"
  for ending in png ppm pl; do
    say render facts/shaded_block.pl --size 60x40 -o "$o/r.$ending"
  done
  say render facts/smooth.pl --size 60x40 -o "$o/r.png"
  say problems facts/problems/fig08.pl -o "$o/sheets"
  say explain facts/shaded_block.pl 'pixel(30,20)' --size 60x40
} >"$TMP/commands"
# Verbs that run others, or that wait, have tests of their own.
verbs=$("$SANGGWAN" --help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p' |
  grep -vx 'batch\|repl\|serve')
for verb in $verbs; do
  check "$verb is among them" grep -q "^$verb	" "$TMP/commands"
done

LD_PRELOAD="$B/tests/failing_malloc.so" timeout ${TEST_ALL:+3}580 swipl -p foreign="$B" \
  tests/memory/held.pl -- "$TMP/commands" >"$TMP/log" 2>&1
check "nothing more is held" grep -q '^[1-9][0-9]* passed, 0 failed$' "$TMP/log"
[ "$check_failed" = 0 ] || cat "$TMP/log"
check_report
