:- module(sg_shading_facets,
          [ faceted_model/2,            % +Model0, -Model
            facets_off/2                % +Model, -Off
          ]).
:- use_module('../primitive/primitive',
              [primitive_faces/3, primitive_parts/3, primitive_shape/4]).
:- use_module(shading_leaf, [chain_loops/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2, nth1/3]).
/** <module> A shaded model as files have it: facets, no true surfaces.
*/

%!  faceted_model(+Model0, -Model) is det.
%
%   Model is Model0 (shading_scene.pl), where each primitive is the facets that
%   its term says, and each facet is a face.

faceted_model(model(Leaves0,Facts0,Roots), model(Leaves,Facts,Roots)) :-
    faceted_leaves(Leaves0, Facts0, Leaves, Facts).

%   faceted_leaves(Leaves0, Facts0, Leaves, Facts): the facts of a leaf stand
%   together, in the order of leaves. A second one, the inside of a tube, is
%   nothing now.

faceted_leaves([], [], [], []).
faceted_leaves([Leaf0|Leaves0], Facts0, [Leaf|Leaves], Facts) :-
    Leaf0 = leaf(Number,Root,S,Term,_),
    own_facts(Facts0, Number, Own0, Facts1),
    (   Own0 = [Fact|More],
        is_curved(Fact)
    ->  facets(Term, Points, Polygons, Faces),
        Leaf = leaf(Number,Root,S,Term,Faces),
        maplist(no_fact(Number), More, Nothing),
        Own = [flat(Number,Points,[],Polygons)|Nothing]
    ;   Leaf = Leaf0,
        Own = Own0
    ),
    with_own(Own, Facts2, Facts),
    faceted_leaves(Leaves0, Facts1, Leaves, Facts2).

own_facts([Fact|Facts0], Number, [Fact|Own], Facts) :-
    arg(1, Fact, Number),
    !,
    own_facts(Facts0, Number, Own, Facts).
own_facts(Facts, _, [], Facts).

with_own([], Facts, Facts).
with_own([Fact|Own], Facts, [Fact|Facts1]) :-
    with_own(Own, Facts, Facts1).

no_fact(Number, _, flat(Number,[],[],[])).

is_curved(round(_,_)).
is_curved(ring(_,_,_,_)).
is_curved(net(_,_)).
is_curved(flat(_,_,[_|_],_)).

facets(Term, Points, Polygons, Faces) :-
    primitive_shape(Term, _, Points, Chains),
    primitive_faces(Term, Whats, _),
    findall(polygon(F,0,Loops),
            ( nth1(F, Chains, Chain), chain_loops(Chain, Loops) ),
            Polygons),
    findall(F-Name, ( nth1(F, Whats, What), face_name(What, Name) ), Faces).

face_name(What, Name) :-
    (   What = curved(Part,_)
    ->  Name = curved(Part)
    ;   Name = What
    ).

%!  facets_off(+Model, -Off) is semidet.
%
%   Off is how far facets, of which files of Model's round primitives would
%   have, are from what is round at most, in units of the model. Fails if there
%   is nothing round.

facets_off(model(Leaves,Facts,_), Off) :-
    aggregate_all(max(Off0), fact_off(Leaves, Facts, Off0), Off).

%   fact_off(Leaves, Facts, Off): of one of Facts, which stand in the order of
%   Leaves.

fact_off(Leaves0, [Fact|Facts], Off) :-
    arg(1, Fact, Number),
    leaf_from(Leaves0, Number, Term, Leaves),
    (   facets_of_fact(Fact, Term, Off)
    ;   fact_off(Leaves, Facts, Off)
    ).

leaf_from([Leaf|Leaves0], Number, Term, Leaves) :-
    (   Leaf = leaf(Number,_,_,Term0,_)
    ->  Term = Term0,
        Leaves = [Leaf|Leaves0]
    ;   leaf_from(Leaves0, Number, Term, Leaves)
    ).

facets_of_fact(Fact, Term, Off) :-
    callable(Term),
    aggregate_all(max(R), fact_radius(Fact, R), Radius),
    primitive_parts(Term, Parts, _),
    aggregate_all(max(Turn), member(part(_,curved(_,Turn)), Parts), Turn),
    Off is Radius*(1 - cos(Turn/360*pi)).

fact_radius(round(_,Pieces), R) :-
    member(Piece, Pieces),
    arg(2, Piece, Frame),
    frame_radius(Frame, R).
fact_radius(ring(_,Frame,K,_), R) :-
    frame_radius(Frame, R0),
    R is R0*(1+K).

frame_radius([_,_,_,UX,UY,UZ,VX,VY,VZ|_], R) :-
    R is sqrt(max(UX*UX + UY*UY + UZ*UZ, VX*VX + VY*VY + VZ*VZ)).
