# rules.sh -- what docs/rules.md and docs/unfolding.md show works and answers as
# it stands there; the gallery is that of its list.
. "$(dirname "$0")/../check.sh"

root=$PWD
cp -r docs facts "$TMP"
ln -s "$B/sanggwan" "$TMP/sanggwan"
cd "$TMP" || exit 1

# shown COMMAND: the lines under it, up to the next empty one.
shown() {
  awk -v command="    \$ $1" '
    on && /^$/ { exit }
    on { print substr($0, 5) }
    $0 == command { on = 1 }' "$page"
}

# answers COMMAND: it prints what the page shows.
answers() {
  bash -c "$1" >answer </dev/null && shown "$1" >wanted && diff wanted answer
}

for page in docs/unfolding.md docs/rules.md; do
  commands=$(sed -n 's/^    \$ //p' "$page")
  check "there are commands" test "$(wc -l <<<"$commands")" -ge 7
  while read -r command; do
    check "$command" answers "$command"
  done <<<"$commands"
done

# The pictures are those of the gallery, and they differ.
for picture in pipes pipes_rules glass; do
  check "$picture is the gallery's" \
    cmp "docs/gallery/$picture.svg" "$root/docs/gallery/$picture.svg"
done
paths() { grep -c 'class="visible penetration"' "docs/gallery/$1.svg"; }
check "rules leave fewer lines" \
  test "$(paths pipes_rules)" -lt "$(paths pipes)"

# The page of the gallery shows the commands of its list: no picture is drawn.
rm docs/gallery/index.html
check "the page is written" \
  swipl -p foreign="$B" "$root/tools/gallery.pl" -- /bin/true
check "the page is the gallery's" \
  cmp docs/gallery/index.html "$root/docs/gallery/index.html"

# The rule files shown are those in the folder.
for file in docs/{pipes,pieces,glass,back,weld,machined,inlay}_rules.pl; do
  check "$file is what the page shows" \
    eval "sed '1,/^\*\//d; /^%/d; /^$/d' $file |
          while IFS= read -r line; do
            grep -qxF -- \"    \$line\" $page || exit 1; done"
done

check_report
