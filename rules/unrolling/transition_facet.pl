:- module(sg_transition_facet,
          [ transition_facets/2,        % +S, -Facets
            takes_turns/1,              % +S
            facet_in_direction/3,       % +Facets, +G, -P
            facet_borders/2             % +Facets, -Directions
          ]).
:- use_module('../near', [whole_turns/2]).
:- use_module('../csg/placed_surface', [placed_face/3, placed_surface/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, last/2, member/2]).
/** <module> The facets of a transition, by direction.

Where cones take turns finer facets are parts of other cones than those that are
drawn. So what a fine facet stands for goes by the direction in which it is seen
(primitive_transition.pl), in which both kinds follow each other.
*/

%!  transition_facets(+S, -Facets) is semidet.
%
%   Facets are those of the primitive S, a transition, round it: G1-G2-P,
%   polygon P between the directions G1 < G2, 0.0 =< G1 < 360.0. In order of G1.
%   Fails if S is no transition.

transition_facets(S, Facets) :-
    once(placed_surface(S, _, transition(pieces(Places)))),
    findall(Name-Place,
            ( member(Place, Places), arg(1, Place, Name) ),
            Pairs),
    list_to_assoc(Pairs, Named),
    findall(Facet,
            ( placed_face(S, P, What), facet_seen(What, Named, P, Facet) ),
            Facets0),
    sort(0, @=<, Facets0, Facets).

facet_seen(side(I), Named, P, Facet) :-
    get_assoc(side(I), Named, piece(_, _, _, G1-G2)),
    facet_from(G1, G2, P, Facet).
facet_seen(curved(Name, [T1-T2]), Named, P, Facet) :-
    get_assoc(Name, Named, piece(_, _, From-To, G1-G2)),
    F is (G2-G1)/(To-From),
    Turns is -floor(((T1+T2)/2.0 - From)/360.0),
    G3 is G1 + F*(T1 + 360.0*Turns - From),
    G4 is G1 + F*(T2 + 360.0*Turns - From),
    facet_from(G3, G4, P, Facet).

facet_from(G1, G2, P, G3-G4-P) :-
    whole_turns(G1, By),
    G3 is G1-By,
    G4 is G2-By.

%!  takes_turns(+S) is semidet.
%
%   The primitive S is a transition, and in it a cone follows another one: so
%   they may stand for a smooth surface that is none.

takes_turns(S) :-
    once(placed_surface(S, _, transition(pieces(Places)))),
    last(Places, Last),
    append(_, [piece(cone(_),_,_,_),piece(cone(_),_,_,_)|_], [Last|Places]),
    Places = [_,_|_],
    !.

%!  facet_in_direction(+Facets, +G, -P) is det.
%
%   P of Facets is the one that is seen in direction G, or nearest to it.

facet_in_direction(Facets, G, P) :-
    findall(Off-P0,
            ( member(G1-G2-P0, Facets),
              Away0 is G - (G1+G2)/2.0,
              Away is Away0 - 360.0*round(Away0/360.0),
              Off is max(0.0, abs(Away) - (G2-G1)/2.0) ),
            Offs),
    keysort(Offs, [_-P|_]).

%!  facet_borders(+Facets, -Directions) is det.
%
%   Directions are those between polygons of Facets, which may be several times
%   there, one after the other.

facet_borders(Facets, Directions) :-
    last(Facets, _-Last),
    borders(Facets, Last, Directions).

borders([], _, []).
borders([G-_-P|Facets], Last, Directions) :-
    (   P == Last
    ->  Directions = Rest
    ;   Directions = [G|Rest]
    ),
    borders(Facets, P, Rest).
