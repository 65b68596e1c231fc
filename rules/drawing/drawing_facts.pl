:- module(sg_drawing_facts,
          [ write_facts/3               % +Out, +Inked, +Options
          ]).
:- use_module(ink,
              [ inked_inks/2, line_of/2, ink_width/2, ink_colour/3,
                ink_runs/2, ink_pen/2, ink_layer/2
              ]).
:- use_module('../output', [write_fact/2]).
:- use_module('../store',
              [ segment/3, view/3, projection/1, screen/5, e/5, contour/13,
                drawn/7, origin/3, line/9
              ]).
:- use_module(library(apply), [maplist/3]).
:- use_module('../sheet/dash', [plain_end/2]).
:- use_module(library(lists), [member/2, nth1/3]).
:- use_module(library(option), [option/2]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys/2]).
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
    group_pairs_by_key(Lines, Drawn),
    forall(member(Name, [segment,view,projection,screen,e,contour,origin,line,
                         drawn]),
           forall(picture_row(Name, Drawn, Row), write_fact(Out, Row))).

%   picture_row(Name, Drawn, Row): a row of the relation Name that the picture
%   needs, in the order of its key; Drawn has S-Es, what is drawn of segment S.
%   Rows are looked up one by one, so that no list of them is ever made.

picture_row(segment, Drawn, segment(S,Kind,Name)) :-
    member(S-_, Drawn),
    segment(S, Kind, Name).
picture_row(view, _, view(Theta,Phi,Rho)) :-
    view(Theta, Phi, Rho).
picture_row(projection, _, projection(Kind)) :-
    projection(Kind).
picture_row(screen, Drawn, screen(S,V,X,Y,Z)) :-
    drawn_vertex(Drawn, S, V),
    screen(S, V, X, Y, Z).
picture_row(e, Drawn, e(S,E,V1,V2,Et)) :-
    member(S-Es, Drawn),
    member(E, Es),
    E > 0,
    e(S, E, V1, V2, Et).
picture_row(contour, Drawn,
            contour(S,K,T,I1,F1,I2,F2,Seen,Ts,X1,Y1,X2,Y2)) :-
    member(S-Es, Drawn),
    findall(K, ( member(E, Es), E < 0, K is -E ), Ks0),
    sort(Ks0, Ks),
    member(K, Ks),
    contour(S, K, T, I1, F1, I2, F2, Seen, Ts, X1, Y1, X2, Y2).
picture_row(origin, Drawn, origin(S,v(V),Origin)) :-
    drawn_vertex(Drawn, S, V),
    origin(S, v(V), Origin).
picture_row(line, Drawn, line(L,S1,P1,A1,B1,S2,P2,A2,B2)) :-
    pairs_keys(Drawn, Ss),
    findall(N, ( line(N, T1, _, _, _, T2, _, _, _),
                 ( ord_memberchk(T1, Ss) -> true ; ord_memberchk(T2, Ss) ) ),
            Ls0),
    sort(Ls0, Ls),
    member(L, Ls),
    line(L, S1, P1, A1, B1, S2, P2, A2, B2).
picture_row(drawn, _, drawn(D,S,E,From,To,Visibility,Role)) :-
    findall(N, drawn(N, _, _, _, _, _, _), Ds0),
    sort(Ds0, Ds),
    member(D, Ds),
    drawn(D, S, E, From, To, Visibility, Role).

%   drawn_vertex(Drawn, S, V): V is an end of an edge that is drawn.

drawn_vertex(Drawn, S, V) :-
    member(S-Es, Drawn),
    findall(End, ( member(E, Es), E > 0, e(S, E, V1, V2, _),
                   ( End = V1 ; End = V2 ) ),
            Vs0),
    sort(Vs0, Vs),
    member(V, Vs).

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
    line_of(Lines, line(Ink,stroke(Visibility,Role,S,Edges,Points0,Start,
                                   End0))),
    plain_end(End0, End),
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
