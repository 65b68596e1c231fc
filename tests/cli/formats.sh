# formats.sh -- each format as another program sees it, beside the SVG.
#
# All become pictures of 150 dots to the inch; dark.py compares them. Colours
# are those for print where there is a choice: red is dark too.
. "$(dirname "$0")/../check.sh"

here=$(dirname "$0")
draw() { "$SANGGWAN" draw -q "$@"; }
has() { command -v "$1" >/dev/null; }

rastered() { # FILE.pdf|ps|eps PICTURE.pgm
  local crop=
  case $1 in *.eps) crop=-dEPSCrop ;; esac
  gs -q -dBATCH -dNOPAUSE -dSAFER -sDEVICE=pgmraw -r150 $crop \
    -dGraphicsAlphaBits=4 -dTextAlphaBits=4 -sOutputFile="$2" "$1"
}

svg_rastered() { # FILE.svg PICTURE.pgm
  rsvg-convert -f pdf "$1" -o "$2.pdf" && rastered "$2.pdf" "$2"
}

same() { # [--crop] TOLERANCE A B
  python3 "$here/dark.py" "$@"
}

differ() { ! same "$@"; }

if ! has rsvg-convert || ! has gs || ! has python3; then
  skip "formats" "rsvg-convert, gs and python3 are wanted"
  check_report
  exit
fi

# compare NAME WIDTH HEIGHT ARGUMENT...: a drawing in all formats.
compare() {
  local name=$1 width=$2 height=$3 at=$TMP/$1
  shift 3
  check "$name: all formats" draw "$@" -o "$at.svg" -o "$at.pdf" -o "$at.eps" \
    -o "$at.ps" -o "$at.hpgl" -o "$at.png" --dpi 150
  check "$name: rsvg-convert" svg_rastered "$at.svg" "$at.pgm"
  for format in pdf eps ps; do
    check "$name: gs opens $format" rastered "$at.$format" "$at.$format.pgm"
    check "$name: $format as svg" same 2 "$at.pgm" "$at.$format.pgm"
  done
  check "$name: png as svg" same 2 "$at.pgm" "$at.png"
  if has pdftoppm; then
    check "$name: poppler opens pdf" pdftoppm -r 150 -gray -singlefile \
      "$at.pdf" "$at.poppler"
    check "$name: pdf by poppler as svg" same 2 "$at.pgm" "$at.poppler.pgm"
  else
    skip "$name: poppler" "poppler-utils is not installed"
  fi
  compare_hpgl "$name"
  compare_cut "$name" "$width" "$height" "$@"
}

# hp2xx draws in true size, but leaves the margin out.
compare_hpgl() {
  local name=$1 at=$TMP/$1
  if ! has hp2xx; then
    skip "$name: hpgl" "hp2xx is not installed"
    return
  fi
  check "$name: hp2xx plots hpgl" hp2xx -q -t -p 527 -m eps \
    -f "$at.hp.eps" "$at.hpgl"
  check "$name: plot as picture" rastered "$at.hp.eps" "$at.hp.pgm"
  check "$name: hpgl as svg" same --crop 4 "$at.pgm" "$at.hp.pgm"
}

# Dashes as lines of their own, as cutters want them.
compare_cut() {
  local name=$1 width=$2 height=$3 at=$TMP/$1
  shift 3
  check "$name: dashes as lines" draw "$@" --dashes geometry \
    -o "$at.cut.svg" -o "$at.cut.pdf" -o "$at.cut.dxf"
  check "$name: no dashes in it" eval "! grep -q dasharray '$at.cut.svg'"
  check "$name: rsvg-convert, lines" svg_rastered "$at.cut.svg" "$at.cut.pgm"
  check "$name: svg of lines as svg" same 2 "$at.pgm" "$at.cut.pgm"
  check "$name: gs, lines" rastered "$at.cut.pdf" "$at.cut.pdf.pgm"
  check "$name: pdf of lines as svg" same 2 "$at.pgm" "$at.cut.pdf.pgm"
  if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
    check "$name: ezdxf opens dxf" eval "/usr/bin/python3 '$here/dxf_svg.py' \
      '$at.cut.dxf' $width $height >'$at.dxf.svg'"
    check "$name: dxf as picture" svg_rastered "$at.dxf.svg" "$at.dxf.pgm"
    check "$name: dxf as svg" same 3 "$at.pgm" "$at.dxf.pgm"
  else
    skip "$name: dxf" "python3-ezdxf is not installed"
  fi
}

compare dashed 210 148 facts/figures/fig13.pl
compare shown 210 148 facts/figures/fig13.pl --hidden shown
cat >"$TMP/style.pl" <<'FACTS'
line(visible, any, 1, [dashes(chain), width(0.35)]).
line(hidden, any, 1, [dashes(dashed)]).
line(hidden, any, 2, [dashes([1.5, 1.0, 0.5, 1.0])]).
FACTS
compare chain 150 100 facts/figures/fig12.pl --size 150x100 \
  --style "$TMP/style.pl"
compare solids 280 200 facts/primitives.pl --size 280x200

# A sheet with texts: drawn letters are the same in all but SVG and DXF.
check "sheet" draw facts/pipe_tee.pl --sheet A4 --unit cm --language ko \
  --dpi 150 -o "$TMP/sheet.pdf" -o "$TMP/sheet.ps" -o "$TMP/sheet.png"
check "sheet: gs opens pdf" rastered "$TMP/sheet.pdf" "$TMP/sheet.pgm"
check "sheet: gs opens ps" rastered "$TMP/sheet.ps" "$TMP/sheet.ps.pgm"
check "sheet: ps as pdf" same 1 "$TMP/sheet.pgm" "$TMP/sheet.ps.pgm"
check "sheet: svg with drawn letters" draw facts/pipe_tee.pl --sheet A4 \
  --unit cm --language ko --dashes geometry -o "$TMP/sheet.svg"
check "sheet: rsvg-convert" svg_rastered "$TMP/sheet.svg" "$TMP/sheet.svg.pgm"
check "sheet: svg as pdf" same 2 "$TMP/sheet.pgm" "$TMP/sheet.svg.pgm"
check "sheet: png as pdf" same 2 "$TMP/sheet.pgm" "$TMP/sheet.png"

# The comparison does notice what is missing, and what is elsewhere.
draw facts/figures/fig13.pl --hidden removed -o "$TMP/removed.pdf"
rastered "$TMP/removed.pdf" "$TMP/removed.pgm"
check "a picture without its hidden lines differs" \
  differ 2 "$TMP/dashed.pgm" "$TMP/removed.pgm"
check "hidden lines shown differ from dashes" \
  differ 1 "$TMP/dashed.pgm" "$TMP/shown.pgm"

# The paper's dots, without hidden lines, whose dots are elsewhere.
check "dots" draw facts/figures/fig13.pl --hidden removed --png dots \
  --size 1240x874 -o "$TMP/dots.png"
check "dots as pdf" same 4 "$TMP/removed.pgm" "$TMP/dots.png"

check_report
