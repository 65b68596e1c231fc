:- module(sg_drawing_facts,
          [ write_facts/3               % +Out, +Inked, +Options
          ]).
:- use_module(ink,
              [ inked_inks/2, ink_width/2, ink_colour/3, ink_runs/2, ink_pen/2,
                ink_layer/2
              ]).
:- use_module(store,
              [ segment/3, view/3, projection/1, screen/5, e/5, contour/9,
                drawn/7, origin/3, line/9
              ]).
:- autoload(library(apply), [maplist/3]).
:- autoload(library(lists), [member/2, nth1/3]).
:- autoload(library(option), [option/2]).
/** <module> The picture as facts, for Prolog.

What was drawn, in the relations of the world, with what it comes from: the
segments, the eye, the vertices, edges and pieces of outlines that are drawn,
the penetration lines and origins of these, and drawn/7. Then the drawing, in
millimetres, x to the right and y DOWN from the upper left corner:

    sheet(Width, Height, Scale)
    style(N, Width, Colour, Dashes, Pen, Layer)
    stroke(N, View, Visibility, Role, S, Edges, Points, Start, End)
    text(N, View, X, Y, Height, Anchor, Text)

N is the style that a line or text has. Of a sheet of views there is only the
drawing: each view was a picture of its own. The file is no model file (the
picture is computed from the model); any Prolog can load it.
*/

%!  write_facts(+Out, +Inked, +Options) is det.
%
%   Write the picture of the current world, and Inked (ink.pl), to stream Out;
%   with drawing(_) in Options only Inked.

write_facts(Out, Inked, Options) :-
    format(Out, '% Sanggwan picture. Facts, each a line; for Prolog.~n', []),
    (   option(drawing(_), Options)
    ->  true
    ;   picture_written(Out)
    ),
    drawing_written(Out, Inked).

/* - - - the picture - - - */

picture_written(Out) :-
    findall(S-E, drawn(_, S, E, _, _, _, _), Lines0),
    sort(Lines0, Lines),
    findall(S-V, line_vertex(Lines, S, V), Vertices0),
    sort(Vertices0, Vertices),
    findall(S, member(S-_, Lines), Ss0),
    sort(Ss0, Ss),
    Picture = picture(Ss, Vertices, Lines),
    forall(member(Name, [segment,view,projection,screen,e,contour,origin,line,
                         drawn]),
           rows_written(Name, Out, Picture)).

rows_written(Name, Out, Picture) :-
    findall(Row, picture_row(Name, Picture, Row), Rows0),
    sort(Rows0, Rows),
    forall(member(Row, Rows), write_fact(Out, Row)).

line_vertex(Lines, S, V) :-
    member(S-E, Lines),
    E > 0,
    e(S, E, V1, V2, _),
    ( V = V1 ; V = V2 ).

%   picture_row(Name, picture(Segments,Vertices,Lines), Row): a row of the
%   relation Name that the picture needs.

picture_row(segment, picture(Ss,_,_), segment(S,Kind,Name)) :-
    member(S, Ss),
    segment(S, Kind, Name).
picture_row(view, _, view(Theta,Phi,Rho)) :-
    view(Theta, Phi, Rho).
picture_row(projection, _, projection(Kind)) :-
    projection(Kind).
picture_row(screen, picture(_,Vertices,_), screen(S,V,X,Y,Z)) :-
    member(S-V, Vertices),
    screen(S, V, X, Y, Z).
picture_row(e, picture(_,_,Lines), e(S,E,V1,V2,Et)) :-
    member(S-E, Lines),
    E > 0,
    e(S, E, V1, V2, Et).
picture_row(contour, picture(_,_,Lines), contour(S,K,T,I1,F1,I2,F2,To,Ts)) :-
    member(S-E, Lines),
    E < 0,
    K is -E,
    contour(S, K, T, I1, F1, I2, F2, To, Ts).
picture_row(origin, picture(_,Vertices,_), origin(S,v(V),Origin)) :-
    member(S-V, Vertices),
    origin(S, v(V), Origin).
picture_row(line, picture(Ss,_,_), line(L,S1,P1,A1,B1,S2,P2,A2,B2)) :-
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    ( memberchk(S1, Ss) -> true ; memberchk(S2, Ss) ).
picture_row(drawn, _, drawn(D,S,E,From,To,Visibility,Role)) :-
    drawn(D, S, E, From, To, Visibility, Role).

/* - - - the drawing - - - */

drawing_written(Out, Inked) :-
    Inked = inked(sheet(W0,H0,Scale), _, Views),
    maplist(millimetres, [W0,H0], [W,H]),
    write_fact(Out, sheet(W,H,Scale)),
    inked_inks(Inked, Inks),
    forall(( nth1(N, Inks, Ink), style_fact(N, Ink, Fact) ),
           write_fact(Out, Fact)),
    forall(drawing_row(Views, Inks, Row), write_fact(Out, Row)).

style_fact(N, Ink, style(N,Width,Colour,Dashes,Pen,Layer)) :-
    ink_width(Ink, Width0),
    millimetres(Width0, Width),
    ink_colour(screen, Ink, Colour),
    ink_runs(Ink, Runs),
    maplist(millimetres, Runs, Dashes),
    ink_pen(Ink, Pen),
    ink_layer(Ink, Layer).

drawing_row(Views, Inks, stroke(N,View,Visibility,Role,S,Edges,Points,
                                Start,End)) :-
    member(view(View,Lines,_), Views),
    member(line(Ink,stroke(Visibility,Role,S,Edges,Points0,Start,End)), Lines),
    once(nth1(N, Inks, Ink)),
    maplist(place, Points0, Points).
drawing_row(Views, Inks, text(N,View,X,Y,Height,Anchor,Text)) :-
    member(view(View,_,Texts), Views),
    member(text(Ink,text(X0,Y0,Height0,Anchor,Text)), Texts),
    once(nth1(N, Inks, Ink)),
    maplist(millimetres, [X0,Y0,Height0], [X,Y,Height]).

place(X0-Y0, X-Y) :-
    millimetres(X0, X),
    millimetres(Y0, Y).

millimetres(N, X) :-
    X is N/1000.0.

write_fact(Out, Fact) :-
    write_term(Out, Fact,
               [ quoted(true), spacing(next_argument), numbervars(false),
                 float_format(''), fullstop(true), nl(true)
               ]).
