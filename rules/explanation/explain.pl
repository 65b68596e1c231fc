:- module(sg_explain,
          [ explain/1,                  % ?Item
            explain/2,                  % ?Item, +Options
            explanation/2,              % ?Item, -Because
            explanation/3,              % ?Item, +Options, -Because
            print_explanations/1,       % +Explanations
            statement_text/2,           % +Statement, -Text
            contact_statement/3         % +Seat1, +Seat2, -Statement
          ]).
:- use_module('../penetration/chain', [chain/5]).
:- use_module('../penetration/contact',
              [ line_end/4, vertex_seats/3, contact_kind/3, edge_part/4 ]).
:- use_module('../exact', [vertex_exact/5, vertex_side/4]).
:- use_module(explain_glue,
              [glued_because/3, region_because/3, unglued_because/3]).
:- use_module(explain_hidden, [hidden_because/4]).
:- use_module(explain_pair, [pair_because/3, segments_because/3,
                             line_pieces/2, decided_by/2,
                             leaf_corners/3]).
:- use_module(explain_parameter,
              [ parameter_because/2, segment_because/3, sizes_because/2,
                pair_sizes/3, place_because/3 ]).
:- use_module(explain_piece, [piece_asked/2, piece_because/3]).
:- use_module(explain_pixel, [pixel_because/4, unseen_because/3]).
:- use_module(explain_seam, [joint_explained/5, pattern_explained/4]).
:- use_module('../message/explain_words', [statement_keys/2, in_order/4]).
:- use_module('../message/messages', []).
:- use_module('../message/messages_ko', []).
:- use_module('../plain', [plain_json/2, plain_text/2]).
:- use_module('../penetration/joints', [merge_line/2]).
:- use_module('../csg/provenance', [vertex_from/4, vertex_on/4]).
:- use_module('../store',
              [ v/5, e/5, leaf_v/5, leaf_e/5, p/3, segment/3, origin/3, line/9,
                edge_polygon/3, param/2
              ]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(http/json), [json_write/3]).
:- use_module(library(lists), [append/2, append/3, member/2, nth1/3]).
:- use_module(library(solution_sequences), [distinct/2]).

/** <module> Explain: why a line, a vertex or an edge is there, or none is.

An *item* is one of

    line(L)              a piece of a penetration line
    vertex(S, V)         a vertex
    edge(S, E)           an edge
    pair(S1-P1, S2-P2)   two polygons: why they give a line, or none
    pair(S1, S2)         two segments
    piece(S, P)          polygon P of the boundary of a node: why it stayed
    piece(S, S0-P0)      what became of polygon P0 of its operand S0
    seam(S, E), fold(S, E)   an edge in the pattern of segment S: why it is
                         one, and what another choice costs; seam(E), fold(E)
    pattern(S, K)        piece K of that pattern: why it is joined to no other
    segment(S)           a segment: which of its sizes come from parameters
    param(Name)          a parameter: its value, and what is made from it
    hidden(S, E)         a line of the picture: where it is hidden, by what
    hidden(Name)         the same: `s1e7` is what drawings call the line
    why_not(hidden(...)) where such a line is visible, and why
    glued(S, v(V)), glued(S, e(E)), glued(S, p(P))   what the glue S has there:
                         of which operands, in what order, between what
    region(S, R)         a region of segment S: inside what, beside what
    why_not(glued(S1-P1, S2-P2))   why polygons of two operands of a glue have
                         no face in common
    pixel(X, Y)          a dot of the shaded picture: what is seen there, and
                         why it has its colour
    why_not(seen(S))     why nothing of segment S is seen in that picture

Nothing is stored for it: the rule that decided runs again for the one item,
with exact signs. What comes out is a tree of because(Statement, Because), the
statements listed in explain_words.pl, said in English and Korean by
explain_en.pl and explain_ko.pl.
*/

%!  explain(?Item) is semidet.
%!  explain(?Item, +Options) is semidet.
%
%   Print why Item is what it is, in the language of the messages. Unbound
%   parts of Item stand for every one there is: explain(line(_)). True if there
%   was something to explain; otherwise a message says what can be asked.
%   Options: those of picture/1 that the picture was made with; of seams, folds
%   and pieces what is wanted of the pattern (explain_seam.pl); of shaded
%   pictures those of explain_pixel.pl.
%
%   @error instantiation_error: of Options, anything unbound
%
%       ?- penetrate, explain(line(1)).

explain(Item) :-
    explain(Item, []).

explain(Item, Options) :-
    findall(Item-Because, explanation(Item, Options, Because), All),
    (   All == []
    ->  print_message(informational, sanggwan(nothing_to_explain(Item))),
        fail
    ;   forall(nth1(I, All, _-Because),
               ( ( I > 1 -> nl ; true ),
                 maplist(print_because(0), Because) ))
    ).

%!  explanation(?Item, -Because) is nondet.
%!  explanation(?Item, +Options, -Because) is nondet.
%
%   True when Because is the list of because(Statement, Because) that explains
%   Item. Of an Item with unbound parts, every one: lines, vertices that were
%   made, edges that were made, polygons and segments that share a line, lines
%   of the picture. Options as for explain/2.
%
%   @error instantiation_error: of Options, anything unbound

explanation(Item, Because) :-
    explanation(Item, [], Because).

explanation(Item, Options, Because) :-
    must_be(list, Options),
    must_be(ground, Options),
    item_because(Item, Options, Because).

item_because(line(L), _, Because) :-
    line(L, _, _, _, _, _, _, _, _),
    line_because(L, Because).
item_because(vertex(S, V), _, [because(Statement, Because)]) :-
    vertex_asked(S, V),
    vertex_because(S, V, Statement, Because).
item_because(edge(S, E), _, Because) :-
    edge_asked(S, E),
    edge_because(S, E, Because).
item_because(pair(A, B), _, Because) :-
    pair_asked(A, B),
    pair_explained(A, B, Because).
item_because(segment(S), _, [because(Statement, Because)]) :-
    segment_because(S, Statement, Because).
item_because(param(Name), _, [because(parameter(Name, Value), Because)]) :-
    param(Name, Value),
    parameter_because(Name, Because).
item_because(piece(S, Piece), _, Because) :-
    piece_asked(S, Piece),
    piece_because(S, Piece, Because).
item_because(seam(S, E), Options, Because) :-
    joint_explained(S, E, seam, Options, Because).
item_because(seam(E), Options, Because) :-
    joint_explained(_, E, seam, Options, Because).
item_because(fold(S, E), Options, Because) :-
    joint_explained(S, E, fold, Options, Because).
item_because(fold(E), Options, Because) :-
    joint_explained(_, E, fold, Options, Because).
item_because(pattern(S, K), Options, Because) :-
    pattern_explained(S, K, Options, Because).
item_because(hidden(S, E), Options, Because) :-
    hidden_because(S-E, all, Options, Because).
item_because(hidden(Name), Options, Because) :-
    nonvar(Name),
    hidden_because(Name, all, Options, Because).
item_because(glued(S, Item), _, Because) :-
    glued_because(S, Item, Because).
item_because(region(S, R), _, Because) :-
    region_because(S, R, Because).
item_because(why_not(glued(Facet1, Facet2)), _, Because) :-
    unglued_because(Facet1, Facet2, Because).
item_because(pixel(X, Y), Options, Because) :-
    pixel_because(X, Y, Options, Because).
item_because(why_not(seen(S)), Options, Because) :-
    unseen_because(S, Options, Because).
item_because(why_not(hidden(S, E)), Options, Because) :-
    hidden_because(S-E, visible, Options, Because).
item_because(why_not(hidden(Name)), Options, Because) :-
    nonvar(Name),
    hidden_because(Name, visible, Options, Because).

vertex_asked(S, V) :-
    nonvar(S),
    nonvar(V),
    !,
    once(v(S, V, _, _, _)).
vertex_asked(S, V) :-
    v(S, V, _, _, _),
    origin(S, v(V), _).

edge_asked(S, E) :-
    nonvar(S),
    nonvar(E),
    !,
    (   e(S, E, _, _, _)
    ->  true
    ;   leaf_e(S, E, _, _, _)
    ->  true
    ).
edge_asked(S, E) :-
    e(S, E, _, _, _),
    origin(S, e(E), _).

pair_asked(A, B) :-
    ground(A-B),
    !,
    place_there(A),
    place_there(B).
pair_asked(S1-P1, S2-P2) :-
    distinct(S1-P1-S2-P2, line(_, S1, P1, _, _, S2, P2, _, _)).

place_there(S-P) :-
    !,
    once(p(S, P, _)).
place_there(S) :-
    once(segment(S, _, _)).

pair_explained(S1-P1, S2-P2, Because) :-
    !,
    (   S1 =< S2
    ->  pair_because(S1-P1, S2-P2, Because)
    ;   pair_because(S2-P2, S1-P1, Because)
    ).
pair_explained(S1, S2, Because) :-
    S1 =< S2,
    !,
    segments_because(S1, S2, Because).
pair_explained(S1, S2, Because) :-
    segments_because(S2, S1, Because).

/* - - - a line - - - */

line_because(L, [because(Statement, Because)]) :-
    line(L, S1, P1, A, B, S2, P2, _, _),
    (   A == B
    ->  Statement = touch(L, S1, P1, S2, P2),
        findall(End, end_because(L, point, End), Ends)
    ;   Statement = line(L, S1, P1, S2, P2),
        findall(End, ( end_because(L, start, End)
                     ; end_because(L, end, End) ), Ends)
    ),
    line_pieces(L, Pieces),
    chain_because(L, Chain),
    pair_sizes(S1, S2, Sizes),
    append([Ends, Pieces, Chain, Sizes], Because).

end_because(L, End,
            because(point(End, point(X,Y,Z), S1, V1, S2, V2), Because)) :-
    (   End == point
    ->  line_end(L, start, Seat1, Seat2)
    ;   line_end(L, End, Seat1, Seat2)
    ),
    !,
    Seat1 = seat(S1, V1, _),
    Seat2 = seat(S2, V2, _),
    v(S1, V1, X, Y, Z),
    contact(Seat1, Seat2, Contact),
    vertex_seats_of(Seat1, Seat2, Seats),
    findall(because(also(S,V,Place), []),
            ( member(seat(S,V,Place), Seats), S \== S1, S \== S2 ),
            Also),
    exact_because(Seat1, Seat2, Exact),
    merge_refused(L, V1, Refused),
    append([[Contact], Exact, Also, Refused], Because).

%   merge_refused(+L, +V, -Because): the line of the same two polygons that
%   goes on there, but must not be merged.

merge_refused(L, V, Because) :-
    findall(because(not_merged(Other,By), []), not_merged(L, V, Other, By),
            Because).

not_merged(L, V, Other, By) :-
    line(L, S1, P1, _, _, S2, P2, _, _),
    vertex_lines(S1, V, Ls),
    member(Other, Ls),
    Other =\= L,
    line(Other, S1, P1, _, _, S2, P2, _, _),
    Piece = piece(S1, P1, S2, P2),
    \+ merge_line(Piece, Piece),
    decided_by(merge_line/2, By).

%   What the features are; under it the exact signs that prove it, and what
%   made the point if it was not these features.

contact(Seat1, Seat2, because(Contact, Because)) :-
    contact_statement(Seat1, Seat2, Contact),
    Contact = contact(Kind, _, _),
    (   Kind == 'edge-face'
    ->  edge_sides(Seat1, Seat2, Because)
    ;   seat_origin(Seat1, Seat2, Origin)
    ->  origin_because(Origin, Facts),
        (   made_here(Kind, Origin)
        ->  Because = Facts
        ;   Because = [because(made(Origin), Facts)]
        )
    ;   Because = []
    ).

%!  contact_statement(+Seat1, +Seat2, -Statement) is det.
%
%   Statement is contact(Kind, Seat1, Seat2), Kind as of contact_kind/3, but
%   `edge-in-face` where the edge does not pierce the face but runs in it.

contact_statement(Seat1, Seat2, contact(Kind, Seat1, Seat2)) :-
    arg(3, Seat1, Place1),
    arg(3, Seat2, Place2),
    contact_kind(Place1, Place2, Kind0),
    (   Kind0 == 'edge-face',
        \+ edge_sides(Seat1, Seat2, _)
    ->  Kind = 'edge-in-face'
    ;   Kind = Kind0
    ).

%   edge_sides(+Seat1, +Seat2, -Because) is semidet: the ends of the edge are on
%   different sides of a triangle of the face, the one that made the point if
%   it is known.

edge_sides(Seat1, Seat2, [because(FactA, []), because(FactB, [])]) :-
    in_order(Seat1, Seat2, seat(S1,_,edge(A,B)), seat(S2,_,face(P,Corners))),
    face_triangle(Corners, S2, P, Triangle),
    FactA = side(S1, A, PointA, SideA, Triangle),
    FactB = side(S1, B, PointB, SideB, Triangle),
    vertex_side(S1, A, Triangle, SideA),
    vertex_side(S1, B, Triangle, SideB),
    msort([SideA,SideB], [above,below]),
    !,
    point(S1, A, PointA),
    point(S1, B, PointB).

face_triangle(triangle(A, B, C), S, _, S-(A,B,C)).
face_triangle(diagonal(A, B), S, P, S-(C,D,E)) :-
    leaf_corners(S, P, S-(C,D,E)),
    memberchk(A, [C,D,E]),
    memberchk(B, [C,D,E]).
face_triangle(none, S, P, Triangle) :-
    leaf_corners(S, P, Triangle).

%   seat_origin(+Seat1, +Seat2, -Origin) is nondet.

seat_origin(seat(S1,V1,_), seat(S2,V2,_), Origin) :-
    (   origin(S1, v(V1), Origin)
    ;   origin(S2, v(V2), Origin)
    ).

made_here('edge-edge', ll(_, _)).
made_here('vertex-edge', v(_, _)).
made_here('vertex-face', v(_, _)).

vertex_seats_of(seat(S1,V1,vertex(_)), seat(S2,V2,Place), Seats) :-
    Place \= vertex(_),
    !,
    vertex_seats(S2, V2, Seats0),
    (   memberchk(seat(S1,V1,_), Seats0)
    ->  Seats = Seats0
    ;   vertex_seats(S1, V1, Seats)
    ).
vertex_seats_of(seat(S,V,_), _, Seats) :-
    vertex_seats(S, V, Seats).

origin_because(Origin, Because) :-
    findall(because(Statement, []), origin_fact(Origin, Statement), Because).

%   origin_fact(+Origin, -Statement) is nondet: where the places named in Origin
%   are, and on which side of a triangle its line's ends lie.

origin_fact(lpi(S1-(A,B), Triangle), Statement) :-
    member(V, [A,B]),
    vertex_side(S1, V, Triangle, Side),
    point(S1, V, Point),
    Statement = side(S1, V, Point, Side, Triangle).
origin_fact(near(Origin), Statement) :-
    Origin =.. [_|Places],
    member(S-(A,B), Places),
    member(V, [A,B]),
    integer(V),
    point(S, V, Point),
    Statement = at(S, V, Point).
origin_fact(ll(S1-(A,B), S2-(C,D)), at(S, V, Point)) :-
    member(S-V, [S1-A, S1-B, S2-C, S2-D]),
    point(S, V, Point).

point(S, V, point(X,Y,Z)) :-
    once(v(S, V, X, Y, Z)).

%   exact_because(+Seat1, +Seat2, -Because): exact coordinates, where the
%   doubles are not.

exact_because(Seat1, Seat2, Because) :-
    (   member(seat(S,V,_), [Seat1,Seat2]),
        origin(S, v(V), Origin)
    ->  findall(because(exact(X,Y,Z), []), inexact_at(S, V, Origin, X, Y, Z),
                Because)
    ;   Because = []
    ).

inexact_at(S, V, Origin, X, Y, Z) :-
    Origin \= v(_, _),
    Origin \= near(_),
    once(vertex_exact(S, V, X, Y, Z)),
    once(v(S, V, X1, Y1, Z1)),
    \+ ( X =:= rational(X1), Y =:= rational(Y1), Z =:= rational(Z1) ).

chain_because(L, Because) :-
    (   chain(C, _, _, Kind, Lines),
        nth1(I, Lines, Step),
        L =:= abs(Step)
    ->  length(Lines, N),
        Because = [because(chain(C, Kind, I, N), [])]
    ;   Because = []
    ).

/* - - - a vertex - - - */

vertex_because(S, V, Statement, Because) :-
    point(S, V, Point),
    vertex_lines(S, V, Ls),
    (   Ls == []
    ->  Lines = []
    ;   Lines = [because(vertex_lines(Ls), [])]
    ),
    vertex_seats(S, V, Seats),
    findall(because(also(S1,V1,Place), []),
            ( member(seat(S1,V1,Place), Seats), S1-V1 \== S-V ),
            Also),
    (   origin(S, v(V), Origin)
    ->  memberchk(seat(S,V,Place), Seats),
        (   Place = vertex(_)
        ->  Statement = moved(S, V, Point)
        ;   Statement = derived(S, V, Point, Place)
        ),
        origin_because(Origin, Facts),
        Seat = seat(S, V, Place),
        exact_because(Seat, Seat, Exact),
        findall(because(was_at(S,V,point(X,Y,Z)), []), leaf_v(S, V, X, Y, Z),
                Was),
        append([Was, [because(made(Origin), Facts)], Exact], Made)
    ;   Statement = original(S, V, Point),
        Made = []
    ),
    findall(because(vertex_of(S0,V0), []), vertex_from(S, V, S0, V0), From),
    findall(because(lies_on(S0,Feature), []), vertex_on(S, V, S0, Feature),
            On),
    place_because(S, V, Sizes),
    append([From, Made, On, Also, Lines, Sizes], Because).

vertex_lines(S, V, Ls) :-
    findall(L, vertex_line(S, V, L), Ls0),
    sort(Ls0, Ls).

vertex_line(S, V, L) :-
    line(L, S, _, V, _, _, _, _, _).
vertex_line(S, V, L) :-
    line(L, S, _, _, V, _, _, _, _).
vertex_line(S, V, L) :-
    line(L, _, _, _, _, S, _, V, _).
vertex_line(S, V, L) :-
    line(L, _, _, _, _, S, _, _, V).

/* - - - an edge - - - */

edge_because(S, E, [because(edge(S,E,V1,V2), [Why|Because])]) :-
    e(S, E, V1, V2, _),
    !,
    edge_origin(S, E, Why),
    findall(P, edge_polygon(S, E, P), Ps0),
    sort(Ps0, Ps),
    (   Ps == []
    ->  Polygons = []
    ;   Polygons = [because(edge_polygons(S,Ps), [])]
    ),
    places_because(S, V1, V2, Places),
    append(Polygons, Places, Because).
edge_because(S, E, [because(edge_divided(S,E,V1,V2), Because)]) :-
    leaf_e(S, E, V1, V2, _),
    !,
    findall(because(edge_part(S,X,A,B), []),
            ( origin(S, e(X), e(E)), e(S, X, A, B, _) ),
            Parts),
    places_because(S, V1, V2, Places),
    append(Parts, Places, Because).

%   places_because(S, V1, V2, Because): the formulas of the ends of an edge, or
%   what sizes of its segment come from parameters, said once.

places_because(S, V1, V2, Because) :-
    findall(Place,
            ( member(V, [V1,V2]),
              place_because(S, V, Places),
              member(Place, Places),
              Place = because(vertex_place(_, _, _), _) ),
            Ends),
    (   Ends == []
    ->  sizes_because(S, Because)
    ;   Because = Ends
    ).

edge_origin(S, E, because(edge_of_line(L), Because)) :-
    origin(S, e(E), line(L)),
    !,
    findall(because(line(L,S1,P1,S2,P2), []),
            line(L, S1, P1, _, _, S2, P2, _, _), Because).
edge_origin(S, E, because(part_of(S,Root,V1,V2), [])) :-
    edge_part(S, E, Root, V1-V2),
    !.
edge_origin(S, E, because(edge_near(S,E), [])) :-
    origin(S, e(E), near),
    !.
edge_origin(S, E, because(edge_whole(S,E), [])).

/* - - - what is printed - - - */

%!  print_explanations(+Explanations) is det.
%
%   Print the list of Item-Because as JSON: objects with `item` and `because`, a
%   list of objects with `says` (the name of the statement), its parts by name
%   (explain_words.pl), the sentence as `text`, and `because` again.

print_explanations(Explanations) :-
    maplist(explanation_json, Explanations, Jsons),
    plain_json(current_output,
               json_write(current_output, Jsons, [width(72), tab(1000)])),
    nl.

explanation_json(Item-Because, json([item=Text, because=Jsons])) :-
    format(string(Text), '~q', [Item]),
    maplist(because_json, Because, Jsons).

print_because(Indent, because(Statement, Because)) :-
    statement_text(Statement, Text),
    format("~t~*|~w~n", [Indent, Text]),
    Indent1 is Indent+2,
    maplist(print_because(Indent1), Because).

%!  statement_text(+Statement, -Text) is det.
%
%   Text is the sentence of a statement, in the language of the messages.

statement_text(Statement, Text) :-
    phrase('$messages':translate_message(sanggwan(because(Statement))), Lines),
    with_output_to(string(Text0),
                   print_message_lines(current_output, '', Lines)),
    string_concat(Text1, "\n", Text0),  % split_string/4 parts at NUL too
    !,
    plain_text(Text1, Text).

because_json(because(Statement, Because), json(All)) :-
    Statement =.. [Name|Values0],
    statement_keys(Name, Keys),
    maplist(json_value, Values0, Values),
    maplist(json_pair, Keys, Values, Pairs),
    statement_text(Statement, Text),
    maplist(because_json, Because, Jsons),
    (   Jsons == []
    ->  Last = []
    ;   Last = [because=Jsons]
    ),
    append([[says=Name], Pairs, [text=Text], Last], All).

json_pair(Key, Value, Key=Value).

json_value(point(X,Y,Z), [X,Y,Z]) :-
    !.
json_value(seat(S,V,Place), json([segment=S, vertex=V, place=Text])) :-
    !,
    json_value(Place, Text).
json_value(none, @(null)) :-
    !.
json_value(Value, Value) :-
    ( float(Value) ; integer(Value) ; atom(Value) ; string(Value) ),
    !.
json_value(Value, Text) :-
    rational(Value, N, D),
    !,
    format(string(Text), '~d/~d', [N, D]).
json_value(Values, Jsons) :-
    is_list(Values),
    !,
    maplist(json_value, Values, Jsons).
json_value(Term, Text) :-
    format(string(Text), '~q', [Term]).
