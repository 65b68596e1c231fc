# layers.sh -- tools/check_layers.pl finds calls that go up.
. "$(dirname "$0")/../check.sh"

here=$PWD tree=$TMP/tree
mkdir -p "$tree/engine"
cp -r rules c_kernels "$tree"
mkdir "$tree/tests"
cp -r tests/c_kernels "$tree/tests"
cp engine/*.{c,h,def} "$tree/engine"

layers() { (cd "$tree" && swipl -f none "$here/tools/check_layers.pl"); }

check "this tree is in order" layers

# tools/house.pl finds files that say nothing of themselves, folders that nobody
# listed, and a drawing of another tree.
house() {
  (cd "$tree" && swipl -f none "$here/tools/house.pl" -- check "$1")
}
check "the drawing is of this tree" house "$here/docs/architecture.svg"
mkdir "$tree/rules/cellar"
echo ':- module(sg_mute, []).' >"$tree/rules/cellar/mute.pl"
sed 's/hidden lines/lines/' docs/architecture.svg >"$TMP/old.svg"
check "another tree is not" status 1 house "$TMP/old.svg"
cp "$TMP/check.log" "$TMP/found"
for line in 'rules/cellar/mute.pl: its first lines do not say what it is' \
  'rules/cellar: not in tools/folders.pl' \
  "$TMP/old.svg: not as the tree is; make docs"; do
  check "$line" grep -qxF "$line" "$TMP/found"
done
rm -r "$tree/rules/cellar"

# plant FILE NAME: an #include that should be found.
planted=()
plant() {
  printf '#include %s\n' "$2" >>"$tree/$1"
  local name=${2//\"/}
  [ -e "$tree/c_kernels/$name" ] && name=c_kernels/$name
  [ -e "$tree/${1%/*}/${name##*/}" ] && name=${1%/*}/${name##*/}
  planted+=("$1: may not include $name")
}

for file in c_kernels/join/cut.c c_kernels/join/near_rows.c engine/store.c \
  engine/sanggwan.h; do
  plant $file '<SWI-Prolog.h>'
done
plant c_kernels/join/cut.c '"engine/store.h"'
plant c_kernels/join/cut.c '"picture/scene.h"'
plant c_kernels/join/cut.c '"door.h"'
plant engine/store.c '"c_kernels/join/cut.h"'
plant engine/store.c '"store4pl.h"'
plant engine/store4pl.c '"c_kernels/join/cut.h"'
for file in main.c engine.c question.c host.h install.c boot.c start.c; do
  plant engine/$file '"store.h"'
  plant engine/$file '"c_kernels/join/cut.h"'
  plant engine/$file '"c_kernels/penetration/cut_rows.h"'
done

# plant_import FILE OTHER: an import that should be found.
plant_import() {
  printf ':- use_module(%s).\n' "$2" >>"$tree/rules/$1"
  local name=${2//\'/}
  planted+=("rules/$1: may not import ${name#../}.pl")
}
plant_import model/model.pl "'../command/cli'"
plant_import picture/view.pl "'../sheet/sheet'"
plant_import vector.pl picture/view
plant_import model/model.pl "'../sanggwan'"
plant_import store.pl model/model
plant_import model/model.pl "'../kernel/work'"
plant_import kernel/work.pl "'../model/model'"
sed -i "s|^:- reexport(\[ kernel/world,.*|&\n              command/cli, % a door|" \
  "$tree/rules/kernel.pl"
planted+=('rules/kernel.pl: may not import command/cli.pl')
check "faults are an error" status 1 layers
cp "$TMP/check.log" "$TMP/found"
for line in "${planted[@]}"; do
  check "$line" grep -qxF "$line" "$TMP/found"
done
check "they make a circle" grep -q ': imports go round: .* -> ' "$TMP/found"
check "nothing else" test "$(wc -l <"$TMP/found")" = $((${#planted[@]} + 1))
check_report
