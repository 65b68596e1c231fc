:- module(sg_svg,
          [ write_svg/3                 % +Out, +Drawing, +Options
          ]).
:- use_module(dash, [stroke_dash/3]).
:- autoload(library(apply), [foldl/4]).
:- autoload(library(lists), [member/2]).
:- autoload(library(option), [option/2, option/3]).
:- autoload(library(dcg/high_order), [sequence//3]).
:- autoload(library(rbtrees),
            [rb_insert_new/4, rb_lookup/3, rb_new/1, rb_update/4]).
/** <module> SVG: strokes as polylines that say what they are.

One user unit is one millimetre. A group for each visibility and role, in
painting order; in it a polyline for each stroke:

    <polyline id="s1e7" class="hidden crease" data-segment="1"
              data-edge="7 8" points="10,20 30,20 38,24"/>

The class list begins with `visible` or `hidden`, then the role. The k-th
number of data-edge is the edge that the k-th straight piece belongs to. An id
names segment and first edge; when an edge is drawn in several parts, `-2`,
`-3` follow. How things look is in the style block alone, except for dashes,
which are fitted to each line (dash.pl).
*/

:- set_prolog_flag(optimise, true).

%!  write_svg(+Out, +Drawing, +Options) is det.
%
%   Write Drawing (sheet.pl) to stream Out. Options: title(Text), hidden(How),
%   as for write_drawing/2.

write_svg(Out, drawing(Sheet,Views), Options) :-
    option(hidden(Hidden), Options, dashed),
    emit(Out, svg_head(Sheet, Views, Options)),
    forall(member(View, Views), write_view(Out, Hidden, View)),
    emit(Out, "</svg>\n").

%   A view alone needs no group of its own; of several each has one, and its
%   name before all its ids.

write_view(Out, Hidden, view(Name,Strokes,Texts)) :-
    view_prefix(Name, Prefix),
    emit(Out, view_head(Name)),
    foldl(write_stroke(Out, Prefix-Hidden), Strokes, state(none,ids), State),
    emit(Out, strokes_tail(State)),
    forall(member(Text, Texts), emit(Out, text(Text))),
    emit(Out, view_tail(Name)).

view_prefix('', '') :-
    !.
view_prefix(Name, Prefix) :-
    atom_concat(Name, '-', Prefix).

view_head('') -->
    !,
    "".
view_head(Name) -->
    "<g id=\"", name(Name), "\" class=\"view\">\n".

view_tail('') -->
    !,
    "".
view_tail(_) -->
    "</g>\n".

:- meta_predicate emit(+, //).

emit(Out, Body) :-
    phrase(Body, Codes),
    format(Out, '~s', [Codes]).

svg_head(sheet(W,H,Scale), Views, Options) -->
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
    "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sanggwan\" width=\"",
    thousandths(W), "mm\" height=\"", thousandths(H), "mm\" viewBox=\"0 0 ",
    thousandths(W), " ", thousandths(H), "\" data-scale=\"", scale(Scale),
    "\">\n",
    title(Options),
    "<style>\n", style, sheet_style(Views), "</style>\n",
    "<rect class=\"paper\" width=\"", thousandths(W), "\" height=\"",
    thousandths(H), "\"/>\n".

title(Options) -->
    { option(title(Title), Options) },
    !,
    { text_to_string(Title, String), string_codes(String, Codes) },
    "<title>", escaped(Codes), "</title>\n".
title(_) -->
    "".

%   Line widths and their order: ISO 128-2, 0.5 and 0.25; a penetration line
%   is what the drawing is about, so it is wider, and red on a screen.

style -->
    ".sanggwan .paper{fill:#fff}\n",
    ".sanggwan polyline{fill:none;stroke:#000;stroke-width:.5;",
    "stroke-linecap:round;stroke-linejoin:round}\n",
    ".sanggwan .smooth,.sanggwan .mesh{stroke-width:.25}\n",
    ".sanggwan .penetration{stroke:#a00;stroke-width:.7}\n",
    ".sanggwan .hidden{stroke-width:.25;stroke-linecap:butt}\n",
    ".sanggwan .hidden.mesh,.sanggwan .hidden.smooth{stroke-width:.18}\n",
    ".sanggwan .hidden.penetration{stroke-width:.35}\n",
    "@media print{.sanggwan .penetration{stroke:#000}}\n".

%   Of what only a laid-out sheet has.

sheet_style([view('',_,_)]) -->
    !,
    "".
sheet_style(_) -->
    ".sanggwan .frame{stroke-width:.7;stroke-linecap:square;",
    "stroke-linejoin:miter}\n",
    ".sanggwan .field,.sanggwan .hatching,.sanggwan .cutting,",
    ".sanggwan .axis{stroke-width:.25;stroke-linecap:butt}\n",
    ".sanggwan .symbol{stroke-width:.35}\n",
    ".sanggwan text{fill:#000;stroke:none;white-space:pre;",
    "font-family:'Noto Sans','Noto Sans CJK KR','Noto Sans KR',",
    "'DejaVu Sans',sans-serif}\n".

strokes_tail(state(none,_)) -->
    !,
    "".
strokes_tail(_) -->
    "</g>\n".

/* - - - strokes - - - */

%   state(Group,Ids): the open group, and how often each id was given.

write_stroke(Out, Prefix-Hidden, Stroke, state(Group0,Ids0),
             state(Group,Ids)) :-
    Stroke = stroke(Visibility, Role, S, Edges, _, _, _),
    Group = Visibility-Role,
    (   Edges = [E|_]
    ->  new_id(S, E, Ids0, Ids, N)
    ;   Ids = Ids0,
        N = none
    ),
    (   Group == Group0
    ->  true
    ;   emit(Out, group(Prefix, Group0, Group))
    ),
    emit(Out, stroke(Stroke, Prefix, Hidden, N)).

new_id(S, E, Ids0, Ids, N) :-
    (   Ids0 == ids
    ->  rb_new(Ids1)
    ;   Ids1 = Ids0
    ),
    (   rb_lookup(S-E, N0, Ids1)
    ->  N is N0+1,
        rb_update(Ids1, S-E, N, Ids)
    ;   N = 1,
        rb_insert_new(Ids1, S-E, 1, Ids)
    ).

group(Prefix, Before, Visibility-Role) -->
    (   { Before == none }
    ->  ""
    ;   "</g>\n"
    ),
    "<g id=\"", name(Prefix), name(Visibility), "-", name(Role), "\">\n".

stroke(Stroke, Prefix, Hidden, N) -->
    { Stroke = stroke(Visibility, Role, S, Edges, Points, _, _) },
    "<polyline", id(Edges, Prefix, S, N),
    " class=\"", name(Visibility), " ", name(Role), "\"",
    shown(Edges, S),
    dashes(Stroke, Hidden),
    " points=\"", sequence(point, " ", Points), "\"/>\n".

id([], _, _, _) -->
    !,
    "".
id([E|_], Prefix, S, N) -->
    " id=\"", name(Prefix), "s", number(S), "e", number(E), id_count(N), "\"".

%   What a line shows: of its segment, and which edges.

shown(_, 0) -->
    !,
    "".
shown([], S) -->
    !,
    " data-segment=\"", number(S), "\"".
shown(Edges, S) -->
    " data-segment=\"", number(S),
    "\" data-edge=\"", sequence(number, " ", Edges), "\"".

id_count(1) -->
    !,
    "".
id_count(N) -->
    "-", number(N).

point(X-Y) -->
    thousandths(X), ",", thousandths(Y).

%   In the element itself: its dashes are its own.

dashes(Stroke, dashed) -->
    { Stroke = stroke(hidden, _, _, _, _, Start, _) },
    !,
    { stroke_dash(Stroke, Dash, Gap) },
    " style=\"stroke-dasharray:", thousandths(Dash), " ", thousandths(Gap),
    dash_start(Start, Dash),
    "\"".
dashes(_, _) -->
    "".

dash_start(cut, Dash) -->
    !,
    ";stroke-dashoffset:", thousandths(Dash).
dash_start(_, _) -->
    "".

/* - - - text - - - */

%   A capital is about 0.72 of the size of a font.

text(text(X,Y,Height,Anchor,Text)) -->
    { Size is Height*100//72,
      string_codes(Text, Codes) },
    "<text x=\"", thousandths(X), "\" y=\"", thousandths(Y),
    "\" font-size=\"", thousandths(Size), "\" text-anchor=\"", name(Anchor),
    "\">", escaped(Codes), "</text>\n".

%   An integer as thousandths: 12340 is `12.34`, never `-0`.

thousandths(N) -->
    { N < 0,
      !,
      Positive is -N
    },
    "-", thousandths(Positive).
thousandths(N) -->
    { Whole is N//1000,
      Part is N mod 1000
    },
    number(Whole),
    decimals(Part, 100, `.`).

%   The digits of Part from Place down, without zeros at the end.

decimals(0, _, _) -->
    !,
    "".
decimals(Part, Place, Before) -->
    { Digit is 0'0 + Part//Place,
      Rest is Part mod Place,
      Next is Place//10
    },
    list(Before), [Digit],
    decimals(Rest, Next, []).

number(N) -->
    { number_codes(N, Codes) },
    list(Codes).

scale(Scale) -->
    { format(codes(Codes), '~12g', [Scale]) },
    list(Codes).

list([]) -->
    [].
list([Code|Codes]) -->
    [Code],
    list(Codes).

name(Atom) -->
    { atom_codes(Atom, Codes) },
    list(Codes).

%   Text in XML: what XML cannot hold at all is left out.

escaped([]) -->
    "".
escaped([Code|Codes]) -->
    escaped_code(Code),
    escaped(Codes).

escaped_code(0'<) -->
    !,
    "&lt;".
escaped_code(0'>) -->
    !,
    "&gt;".
escaped_code(0'&) -->
    !,
    "&amp;".
escaped_code(0'") -->
    !,
    "&quot;".
escaped_code(Code) -->
    { xml_code(Code) },
    !,
    [Code].
escaped_code(_) -->
    "".

xml_code(9).
xml_code(10).
xml_code(Code) :-
    Code >= 32,
    \+ between(0xD800, 0xDFFF, Code),
    Code =\= 0xFFFE,
    Code =\= 0xFFFF.
