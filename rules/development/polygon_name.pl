:- module(sg_polygon_name,
          [ polygons_named/3,           % +S, +Name, -Ps
            edges_named/3,              % +S, +Name, -Es
            polygon_name/3,             % +S, +P, -Name
            segments_named/2,           % +Name, -Ss
            segment_title/2,            % +S, -Title
            joined_by/4,                % +S, +P, +Q, -E
            known_polygons/3,           % +S, -Ps, -Names
            neighbours/3                % +S, +P, -Qs
          ]).
:- use_module(leaf_face, [leaf_face/5]).
:- use_module('../plain', [plain_text/2]).
:- use_module('../csg/placed_surface', [drawn_polygon/4]).
:- use_module('../primitive/primitive_face', [face_of/3]).
:- use_module('../store',
              [e/5, p/3, segment/3, origin/3, from_p/5, edge_polygon/3]).
:- use_module('../solid/trimmed', [trimmed_from/2]).
:- use_module(library(lists), [list_to_set/2, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Polygons, edges and segments by the names that people give them.

A polygon is named by its number, or by what it is of the primitive that made
its segment (face_of/3): all of `side(3)`, `base`, curved(side, [0-15]); or by
the first words of that, `cap` for all caps, curved(side) for all facets of a
curved part, or just `side`. A name may be that of several polygons. In results
of CSG trees it is what a polygon is of a leaf: Leaf/Name, where Leaf is the
name or the number of that, can/top or 2/side(3); or Name, of any leaf.

An edge is named by its number; by two polygons, `4-7` or `base-side(3)`, which
are all edges between polygons of these names; or by its ends, v(3)-v(8).
*/

%!  polygons_named(+S, +Name, -Ps:list) is det.
%
%   Ps are the polygons of segment S that Name names, ascending: [] if there are
%   none. A list of names is all of them.

polygons_named(S, Names, Ps) :-
    is_list(Names),
    !,
    findall(P, ( member(Name, Names), polygons_named(S, Name, Ps1),
                 member(P, Ps1) ),
            Ps0),
    sort(Ps0, Ps).
polygons_named(S, P, Ps) :-
    integer(P),
    !,
    (   once(p(S, P, _))
    ->  Ps = [P]
    ;   Ps = []
    ).
polygons_named(S, Name, Ps) :-
    findall(P, ( polygon_face(S, P, Leaf, What),
                 names_leaf(Name, Leaf, Face),
                 names(Face, What) ),
            Ps0),
    sort(Ps0, Ps).

%   polygon_face(S, P, Leaf, What): also of a segment that was trimmed. Leaf is
%   `none`, or leaf(S0, Called) in a result of a CSG tree.

polygon_face(S, P, Leaf, What) :-
    trimmed_from(S, S0),
    (   S0 == S
    ->  own_face(S, P, Leaf, What)
    ;   integer(P)
    ->  once(from_p(S, P, S0, P0, _)),
        own_face(S0, P0, Leaf, What)
    ;   own_face(S0, P0, Leaf, What),
        from_p(S, P, S0, P0, _)
    ).

own_face(S1, P1, none, What) :-
    drawn_polygon(S1, P1, S, P),
    face_of(S, P, What).
own_face(S, P, none, What) :-
    \+ origin(S, node(S), plate(_)),
    face_of(S, P, What).
own_face(S, P, leaf(S0, Called), What) :-
    leaf_face(S, P, S0, Called, What).

%   names_leaf(Name, Leaf, Face): Name may be of Leaf, and is Face there.

names_leaf(Name, Leaf, Face) :-
    (   Name = Of/Face0
    ->  Leaf = leaf(S0, Called),
        memberchk(Of, [S0,Called]),
        Face = Face0
    ;   Face = Name
    ).

%   names(Name, What): Name is What, or begins it. Numbers may be whole.

names(Name, What) :-
    atom(Name),
    !,
    (   functor(What, Name, _)
    ->  true
    ;   What =.. [curved,Name|_]
    ).
names(Name, What) :-
    compound(Name),
    compound(What),
    compound_name_arguments(Name, Functor, Parts),
    compound_name_arguments(What, Functor, All),
    all_named(Parts, All).

all_named([], _).
all_named([Part|Parts], [Value|Values]) :-
    same_value(Part, Value),
    all_named(Parts, Values).

same_value(A, B) :-
    number(A),
    number(B),
    !,
    A =:= B.
same_value(A, B) :-
    compound(A),
    compound(B),
    !,
    compound_name_arguments(A, Name, As),
    compound_name_arguments(B, Name, Bs),
    same_values(As, Bs).
same_value(A, A).

same_values([], []).
same_values([A|As], [B|Bs]) :-
    same_value(A, B),
    same_values(As, Bs).

%!  polygon_name(+S, +P, -Name) is det.
%
%   Name is what polygon P of segment S is of a primitive, Leaf/What of a leaf
%   if S is the result of a CSG tree, or P.

polygon_name(S, P, Name) :-
    (   polygon_face(S, P, Leaf, What)
    ->  qualified(Leaf, What, Name)
    ;   Name = P
    ).

qualified(none, What, What).
qualified(leaf(_, Called), What, Called/What).

%!  edges_named(+S, +Name, -Es:list) is semidet.
%
%   Es are the edges of segment S that Name names, ascending, of two partners
%   the one with the smaller number; [] if there are none. Fails if Name is no
%   name of an edge.

edges_named(S, E, Es) :-
    integer(E),
    !,
    (   first_of_pair(S, E, E1)
    ->  Es = [E1]
    ;   Es = []
    ).
edges_named(S, v(A)-v(B), Es) :-
    !,
    integer(A),
    integer(B),
    findall(E, ( edge_between(S, A, B, E0), first_of_pair(S, E0, E) ), Es0),
    sort(Es0, Es).
edges_named(S, Name1-Name2, Es) :-
    is_name(Name1),
    is_name(Name2),
    polygons_named(S, Name1, Ps),
    polygons_named(S, Name2, Qs),
    findall(E, ( member(P, Ps), joined_by(S, P, Q, E), memberchk(Q, Qs) ),
            Es0),
    sort(Es0, Es).

is_name(Name) :-
    (   integer(Name)
    ;   callable(Name),
        Name \= v(_),
        Name \= _-_
    ),
    !.

edge_between(S, A, B, E) :-
    (   e(S, E, A, B, _)
    ;   e(S, E, B, A, _)
    ).

first_of_pair(S, E0, E) :-
    once(e(S, E0, A, B, _)),
    findall(F, edge_between(S, A, B, F), Fs),
    sort(Fs, [E|_]).

%!  joined_by(+S, +P, ?Q, -E) is nondet.
%
%   True when polygons P and Q of segment S, different ones, have an edge in
%   common, of whose partners E is the one with the smaller number.

joined_by(S, P, Q, E) :-
    p(S, P, Es),
    member(E1, Es),
    once(e(S, E1, A, B, _)),
    e(S, E2, B, A, _),
    edge_polygon(S, E2, Q),
    Q \== P,
    E is min(E1, E2).

%!  neighbours(+S, +P, -Qs:list) is det.
%
%   Qs are the polygons of S that have an edge in common with P, ascending.

neighbours(S, P, Qs) :-
    findall(Q, joined_by(S, P, Q, _), Qs0),
    sort(Qs0, Qs).

%!  known_polygons(+S, -Ps:list, -Names:list) is det.
%
%   Ps are the polygons of segment S, ascending; Names what these are of a
%   primitive, or of leaves, each kind once: base, top, side(1..4).

known_polygons(S, Ps, Names) :-
    findall(P, p(S, P, _), Ps0),
    sort(Ps0, Ps),
    findall(Leaf-What, polygon_face(S, _, Leaf, What), Whats0),
    list_to_set(Whats0, Whats1),
    keysort(Whats1, Whats),
    group_pairs_by_key(Whats, Groups),
    findall(Name,
            ( member(Leaf-Of, Groups),
              kinds(Of, Kinds),
              member(Kind, Kinds),
              qualified(Leaf, Kind, Name) ),
            Names).

%   kinds(Whats, Kinds): the numbered ones of a name as 'side(1..4)'.

kinds([], []).
kinds([What|Whats], [Kind|Kinds]) :-
    (   What =.. [Name, I],
        integer(I)
    ->  run(Whats, Name, I, Last, Rest),
        (   Last == I
        ->  Kind = What
        ;   format(atom(Kind), '~w(~d..~d)', [Name, I, Last])
        )
    ;   What =.. [curved, Part|_]
    ->  Kind = curved(Part),
        facets(Whats, Part, Rest)
    ;   Kind = What,
        Rest = Whats
    ),
    kinds(Rest, Kinds).

run([What|Whats], Name, I0, Last, Rest) :-
    What =.. [Name, I],
    I =:= I0+1,
    !,
    run(Whats, Name, I, Last, Rest).
run(Whats, _, I, I, Whats).

facets([What|Whats], Part, Rest) :-
    What =.. [curved, Part|_],
    !,
    facets(Whats, Part, Rest).
facets(Whats, _, Whats).

%!  segments_named(+Name, -Ss:list) is det.
%
%   Ss are the segments of this number or name, ascending. If none has the name,
%   they are those whose name is printed so (plain_text/2).

segments_named(S, Ss) :-
    integer(S),
    !,
    (   segment(S, _, _)
    ->  Ss = [S]
    ;   Ss = []
    ).
segments_named(Name, Ss) :-
    findall(S, ( segment(S, _, Term), called(Term, Name) ), Ss0),
    (   Ss0 == [],
        atom(Name)
    ->  findall(S, ( segment(S, _, Term), shown_as(Term, Name) ), Ss1)
    ;   Ss1 = Ss0
    ),
    sort(Ss1, Ss).

shown_as(Term, Name) :-
    title(Term, Title),
    atom(Title),
    plain_text(Title, Shown),
    atom_string(Name, Shown).

called(Name, Name) :-
    !.
called(named(Name, _), Name) :-
    !.
called(at(_, Term), Name) :-
    called(Term, Name).

%!  segment_title(+S, -Title) is det.
%
%   Title is what people call segment S: its name, or that of its primitive; of
%   what was trimmed or unfolded, of what it was made.

segment_title(S, Title) :-
    (   segment(S, _, Term)
    ->  title(Term, Title)
    ;   Title = S
    ).

title(named(Name, _), Title) :-
    !,
    Title = Name.
title(at(_, Term), Title) :-
    !,
    title(Term, Title).
title(trimmed(S, _, _), Title) :-
    integer(S),
    !,
    segment_title(S, Title).
title(development(S), Title) :-
    integer(S),
    !,
    segment_title(S, Title).
title(S, Title) :-
    integer(S),
    segment(S, _, Term),
    !,
    title(Term, Title).
title(Term, Title) :-
    (   compound(Term)
    ->  functor(Term, Title, _)
    ;   Title = Term
    ).
