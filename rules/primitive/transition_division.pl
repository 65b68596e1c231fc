:- module(sg_transition_division,
          [ steps_divided/5             % +N, +Rings0, +Steps0, -Rings, -Steps
          ]).
:- use_module(transition_outline, [arc_point/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2]).
/** <module> Finer facets of the same transition.

Which parts a transition consists of hangs on its facets, where they touch arcs
that are not similar (primitive_transition.pl). So finer facets of the same
parts are not those of finer outlines: each step along an arc is divided, after
the outlines have been walked round.
*/

%!  steps_divided(+N, +Rings0, +Steps0, -Rings, -Steps) is det.
%
%   Rings0 is Ring1-Ring2, terms ring(Node, ...) of the nodes of both outlines;
%   Steps0 are step(Kind, I, J) between them, round both, as
%   primitive_transition.pl has them. In Rings and Steps those along arcs are N,
%   in equal parts of the parameter; N >= 1.

steps_divided(1, Rings, Steps, Rings, Steps) :-
    !.
steps_divided(N, Ring1-Ring2, Steps0, Divided1-Divided2, Steps) :-
    ring_divided(N, Ring1, Places1, Divided1),
    ring_divided(N, Ring2, Places2, Divided2),
    maplist(step_divided(Ring1-Places1, Ring2-Places2), Steps0, Lists),
    append(Lists, Steps).

%   ring_divided(N, Ring, Places, Divided): node I of Ring is in Divided where
%   arg I of Places says; the last arg is one more than all of these.

ring_divided(N, Ring, Places, Divided) :-
    Ring =.. [ring|Nodes],
    maplist(node_divided(N), Nodes, Lists),
    append(Lists, All),
    Divided =.. [ring|All],
    first_places(Lists, 1, Firsts),
    Places =.. [places|Firsts].

node_divided(N, node(P, Step), Nodes) :-
    (   Step = arc(Arc, T1, T2)
    ->  findall(node(P1, arc(Arc, T3, T4)),
                ( between(1, N, I),
                  arc_part(I, N, T1, T2, T3, T4),
                  part_start(I, P, Arc, T3, P1) ),
                Nodes)
    ;   Nodes = [node(P, Step)]
    ).

%   arc_part(I, N, T1, T2, T3, T4): the Ith of N equal parts.

arc_part(I, N, T1, T2, T3, T4) :-
    T3 is T1 + (T2-T1)*(I-1)/N,
    (   I =:= N
    ->  T4 = T2
    ;   T4 is T1 + (T2-T1)*I/N
    ).

part_start(1, P, _, _, P) :-
    !.
part_start(_, _, Arc, T, P) :-
    arc_point(Arc, T, P).

first_places([], Place, [Place]).
first_places([List|Lists], Place, [Place|Places]) :-
    length(List, Count),
    Next is Place+Count,
    first_places(Lists, Next, Places).

%   step_divided(Base, Top, Step, Steps): Base and Top are Ring-Places.

step_divided(Base, Top, step(Kind, I0, J0), Steps) :-
    place(Base, I0, I),
    place(Top, J0, J),
    (   Kind == top
    ->  parts(Top, J0, Count)
    ;   parts(Base, I0, Count)
    ),
    Most is Count-1,
    findall(step(Kind, I1, J1),
            ( between(0, Most, K), step_end(Kind, I, J, K, I1, J1) ),
            Steps).

step_end(base, I0, J, K, I, J) :-
    I is I0+K.
step_end(top, I, J0, K, I, J) :-
    J is J0+K.
step_end(both, I0, J0, K, I, J) :-
    I is I0+K,
    J is J0+K.

%   place(Ring-Places, I, Place): where node I, which may be one of a later
%   turn, is in the divided ring.

place(Ring-Places, I, Place) :-
    functor(Ring, _, N),
    Node is (I-1) mod N + 1,
    arg(Node, Places, Place0),
    Last is N+1,
    arg(Last, Places, End),
    Place is Place0 + (I-1)//N*(End-1).

%   parts(Ring-Places, I, Count): the step from node I has Count parts.

parts(Ring, I, Count) :-
    Next is I+1,
    place(Ring, I, From),
    place(Ring, Next, To),
    Count is To-From.
