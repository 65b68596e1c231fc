:- module(sg_svg,
          [ write_svg/3                 % +Out, +Drawing, +Options
          ]).
:- use_module('../sheet/dash', [stroke_runs/4]).
:- use_module(drawing_shading, [shading_images/5]).
:- use_module(image_text, [image_base64/2]).
:- use_module('../kernel',
              [points_text/2, points_written/4, thousandths_text/2]).
:- use_module(ink,
              [ fold_lines/4, ink_width/2, ink_colour/3, ink_runs/2,
                ink_lines/4, dashes_option/3
              ]).
:- use_module('../sheet/lettering', [lettering/2]).
:- use_module('../sheet/stroke', [stroke_key/4]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [list_to_set/2, member/2]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(rbtrees),
              [rb_insert_new/4, rb_lookup/3, rb_new/1, rb_update/4]).
/** <module> SVG: strokes as polylines that say what they are.

One user unit is one millimetre. A group for each visibility and role, in
painting order; in it a polyline for each stroke:

    <polyline id="s1e7" class="hidden crease" data-segment="1"
              data-edge="7 8" points="10,20 30,20 38,24"/>

The class list begins with `visible` or `hidden`, then the role. The k-th
number of data-edge is the edge that the k-th straight piece belongs to; of a
pattern the k-th of data-joint is the joint of that edge, 0 if it has none. An
id names segment and first edge; when an edge is drawn in several parts, `-2`,
`-3` follow. How things look is in the style block alone, except for dashes,
which are fitted to each line (dash.pl): a property of the polyline, or, with
dashes(geometry), the pieces of a `path` in its place.
*/

:- set_prolog_flag(optimise, true).

%!  write_svg(+Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out. Options: title(Text), dashes(How),
%   shading(Shadeds), as for write_drawing/2; joints(Joints): an assoc of S-E
%   to the number of a
%   joint.

write_svg(Out, inked(Sheet,Paper,Views), Options) :-
    dashes_option(Options, fitted, How),
    emit(Out, svg_head(How, inked(Sheet,Paper,Views), Options)),
    option(shading(Shadeds), Options, []),
    option(dots(Dots), Options, 8),
    shading_images(Shadeds, Sheet, Dots, none, Images),
    forall(member(Image, Images), write_image(Out, Image)),
    option(joints(Joints), Options, none),
    forall(member(View, Views), write_view(Out, How, Joints, View)),
    emit(Out, svg_end).

%   write_image(Out, Image): of shading_images/5.

write_image(Out, image(X,Y,W,H,Image)) :-
    image_base64(Image, Text),
    maplist(millimetres, [X,Y,W,H], [X1,Y1,W1,H1]),
    format(Out, '<image class="shading" x="~w" y="~w" width="~w" height="~w" \c
                 preserveAspectRatio="none" \c
                 xlink:href="data:image/png;base64,~s"/>~n',
           [X1,Y1,W1,H1,Text]).

millimetres(Thousandths, Text) :-
    N is round(Thousandths),
    format(atom(Text), '~3d', [N]).

%   A view alone needs no group of its own; of several each has one, and its
%   name before all its ids.

write_view(Out, How, Joints, view(Name,Lines,Texts)) :-
    view_prefix(Name, Prefix),
    emit(Out, view_head(Name)),
    fold_lines(write_line(Out, look(Prefix,How,Joints)), Lines,
               state(none,ids,none), State),
    emit(Out, strokes_tail(State)),
    forall(member(Text, Texts), emit(Out, text(How, Text))),
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

%   emit(Out, Body): phrase/2 would translate Body each time.

emit(Out, Body) :-
    call(Body, Codes, []),
    format(Out, '~s', [Codes]).

svg_end -->
    "</svg>\n".

%   each(Body, Items), spaced(Body, Items): call//1 with each of Items; with a
%   space between them. sequence//3 would translate the space each time.

:- meta_predicate each(3, +, ?, ?), spaced(3, +, ?, ?).

each(_, []) -->
    "".
each(Body, [Item|Items]) -->
    call(Body, Item),
    each(Body, Items).

spaced(_, []) -->
    "".
spaced(Body, [Item|Items]) -->
    call(Body, Item),
    spaced_rest(Items, Body).

:- meta_predicate spaced_rest(+, 3, ?, ?).

spaced_rest([], _) -->
    "".
spaced_rest([Item|Items], Body) -->
    " ",
    call(Body, Item),
    spaced_rest(Items, Body).

svg_head(How, inked(sheet(W,H,Scale),Paper,Views), Options) -->
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
    "<svg xmlns=\"http://www.w3.org/2000/svg\"", link_names(Options),
    " class=\"sanggwan\" width=\"",
    thousandths(W), "mm\" height=\"", thousandths(H), "mm\" viewBox=\"0 0 ",
    thousandths(W), " ", thousandths(H), "\" data-scale=\"", scale(Scale),
    "\">\n",
    title(Options),
    "<style>\n", style(How, Paper, Views), "</style>\n",
    "<rect class=\"paper\" width=\"", thousandths(W), "\" height=\"",
    thousandths(H), "\"/>\n".

link_names(Options) -->
    { option(shading([_|_]), Options) },
    !,
    " xmlns:xlink=\"http://www.w3.org/1999/xlink\"".
link_names(_) -->
    "".

title(Options) -->
    { option(title(Title), Options) },
    !,
    { text_to_string(Title, String), string_codes(String, Codes) },
    "<title>", escaped(Codes), "</title>\n".
title(_) -->
    "".

/* - - - looks - - - */

%   A rule for each visibility and role, by the ink that comes first, and one
%   for each segment whose lines have another.

style(How, Paper, Views) -->
    { findall(Look, view_look(Views, Look), Looks0),
      list_to_set(Looks0, Looks),
      style_rules(Looks, [], Rules)
    },
    ".sanggwan .paper{fill:", colour(Paper), "}\n",
    ".sanggwan polyline,.sanggwan path{fill:none;stroke-linecap:round;",
    "stroke-linejoin:round}\n",
    each(style_rule, Rules),
    text_style(How, Views),
    print_style(Rules).

%   look(Visibility,Role,Segment,Ink) of neighbours that differ.

view_look(Views, Look) :-
    member(view(_,Lines,_), Views),
    differing(Lines, none, Look).

differing([line(Ink,Strokes)|Lines], Last, Look) :-
    stroke_key(Strokes, Visibility, Role, S),
    Next = look(Visibility, Role, S, Ink),
    (   Next == Last
    ->  differing(Lines, Last, Look)
    ;   Look = Next
    ;   differing(Lines, Next, Look)
    ).

style_rules([], _, []).
style_rules([look(Visibility,Role,S,Ink)|Looks], Known, Rules) :-
    (   memberchk(Visibility-Role-First, Known)
    ->  (   First == Ink
        ->  Rules = Rules1
        ;   Rules = [rule(Visibility,Role,S,Ink)|Rules1]
        ),
        style_rules(Looks, Known, Rules1)
    ;   Rules = [rule(Visibility,Role,any,Ink)|Rules1],
        style_rules(Looks, [Visibility-Role-Ink|Known], Rules1)
    ).

style_rule(Rule) -->
    { Rule = rule(_, _, _, Ink),
      ink_colour(screen, Ink, Colour),
      ink_width(Ink, Width)
    },
    selector(Rule),
    "{stroke:", colour(Colour), ";stroke-width:", thousandths(Width),
    line_cap(Ink), "}\n".

selector(rule(Visibility,Role,S,_)) -->
    ".sanggwan .", name(Visibility), ".", name(Role), selected_segment(S).

selected_segment(any) -->
    !,
    "".
selected_segment(S) -->
    "[data-segment=\"", number(S), "\"]".

%   Round ends would fill the gaps.

line_cap(Ink) -->
    { ink_runs(Ink, [_|_]) },
    !,
    ";stroke-linecap:butt".
line_cap(_) -->
    "".

text_style(How, Views) -->
    { member(view(_,_,[text(Ink,_)|_]), Views),
      !,
      ink_colour(screen, Ink, Colour)
    },
    text_rule(How, Colour).
text_style(_, _) -->
    "".

text_rule(geometry, Colour) -->
    !,
    ".sanggwan .text{stroke:", colour(Colour), "}\n".
text_rule(_, Colour) -->
    ".sanggwan text{fill:", colour(Colour), ";stroke:none;white-space:pre;",
    "font-family:'Noto Sans','Noto Sans CJK KR','Noto Sans KR',",
    "'DejaVu Sans',sans-serif}\n".

%   Colours that are others in print.

print_style(Rules) -->
    { findall(Rule, other_in_print(Rules, Rule), Others),
      Others \== []
    },
    !,
    "@media print{", each(print_rule, Others), "}\n".
print_style(_) -->
    "".

other_in_print(Rules, Rule) :-
    member(Rule, Rules),
    Rule = rule(_, _, _, Ink),
    ink_colour(screen, Ink, Screen),
    ink_colour(print, Ink, Print),
    Screen \== Print.

print_rule(Rule) -->
    { Rule = rule(_, _, _, Ink),
      ink_colour(print, Ink, Colour)
    },
    selector(Rule), "{stroke:", colour(Colour), "}".

colour(rgb(R,G,B)) -->
    { format(codes(Codes), '#~|~`0t~16r~2+~`0t~16r~2+~`0t~16r~2+', [R,G,B]) },
    list(Codes).

strokes_tail(state(none,_,_)) -->
    !,
    "".
strokes_tail(_) -->
    "</g>\n".

/* - - - strokes - - - */

%   state(Group,Ids,Same): the open group, how often each id was given, and the
%   Head of the last line that shows no edge, same(S,Head).

write_line(Out, Look, Line, State0, State) :-
    Line = line(Ink, stroke(Visibility,Role,S,Edges,Points,_,_)),
    State0 = state(Group0, Ids0, Same0),
    Group = Visibility-Role,
    (   Edges == [],
        ink_runs(Ink, [])               % letters: many, with the same head
    ->  (   Same0 = same(S, Head),
            Group == Group0
        ->  State = State0
        ;   group_opened(Out, Look, Group0, Group),
            line_head(Line, Look, none, _, _, Codes, []),
            atom_codes(Head, Codes),
            State = state(Group, Ids0, same(S,Head))
        ),
        points_written(Out, Head, Points, '"/>\n')
    ;   group_opened(Out, Look, Group0, Group),
        line_id(Edges, S, Ids0, Ids, N),
        line_head(Line, Look, N, Pointss, Before, Head, []),
        format(Out, '~s', [Head]),
        foldl(write_points(Out), Pointss, Before, _),
        format(Out, '"/>~n', []),
        State = state(Group, Ids, Same0)
    ).

group_opened(Out, Look, Group0, Group) :-
    (   Group == Group0
    ->  true
    ;   Look = look(Prefix, _, _),
        emit(Out, group(Prefix, Group0, Group))
    ).

line_id([], _, Ids, Ids, none).
line_id([E|_], S, Ids0, Ids, N) :-
    new_id(S, E, Ids0, Ids, N).

write_points(Out, Points, Before, 'M') :-
    points_written(Out, Before, Points, '').

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

%   line_head(Line, Look, N, Pointss, Before): all before the points; Pointss
%   are the lines that are drawn of it, the first after Before.

line_head(line(Ink,Stroke), look(Prefix,How,Joints), N, Pointss, Before) -->
    { Stroke = stroke(Visibility, Role, S, Edges, _, _, _),
      drawn_as(How, Ink, Element),
      ink_lines(How, Ink, Stroke, Pointss)
    },
    "<", name(Element), id(Edges, Prefix, S, N),
    " class=\"", name(Visibility), " ", name(Role), "\"",
    shown(Edges, S), joints(Edges, S, Joints),
    way(Element, Ink, Stroke, Before).

drawn_as(How, Ink, Element) :-
    (   How == geometry,
        ink_runs(Ink, [_|_])
    ->  Element = path
    ;   Element = polyline
    ).

way(polyline, Ink, Stroke, '') -->
    dashes(Ink, Stroke), " points=\"".
way(path, _, _, 'M') -->
    " d=\"".

subpath(Points) -->
    { points_text(Points, Text),
      string_codes(Text, Codes) },
    "M", list(Codes).

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
    "\" data-edge=\"", numbers(Edges), "\"".

%   With a space between them.

numbers(Ns) -->
    { atomic_list_concat(Ns, ' ', Text),
      atom_codes(Text, Codes) },
    list(Codes).

joints([], _, _) -->
    !,
    "".
joints(_, _, none) -->
    !,
    "".
joints(Edges, S, Joints) -->
    " data-joint=\"", spaced(joint_of(S, Joints), Edges), "\"".

joint_of(S, Joints, E) -->
    { get_assoc(S-E, Joints, J) },
    !,
    number(J).
joint_of(_, _, _) -->
    "0".

id_count(1) -->
    !,
    "".
id_count(N) -->
    "-", number(N).

%   In the element itself: its dashes are its own.

dashes(Ink, Stroke) -->
    { ink_runs(Ink, Runs),
      Runs = [_|_]
    },
    !,
    { stroke_runs(Stroke, Runs, Fitted, Offset),
      thousandths_text(Fitted, Text),
      string_codes(Text, Codes) },
    " style=\"stroke-dasharray:", list(Codes), dash_offset(Offset), "\"".
dashes(_, _) -->
    "".

dash_offset(0) -->
    !,
    "".
dash_offset(Offset) -->
    ";stroke-dashoffset:", thousandths(Offset).

/* - - - text - - - */

%   Drawn, if dashes are. A capital is about 0.72 of the size of a font.

text(geometry, text(Ink, Text)) -->
    !,
    { lettering(Text, Lines),
      Text = text(_, _, _, _, String),
      string_codes(String, Codes),
      ink_width(Ink, Width)
    },
    "<path class=\"visible text\" aria-label=\"", escaped(Codes),
    "\" stroke-width=\"", thousandths(Width),
    "\" d=\"", each(subpath, Lines), "\"/>\n".
text(_, text(_, text(X,Y,Height,Anchor,Text))) -->
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
