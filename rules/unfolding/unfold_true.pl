:- module(sg_unfold_true,
          [ true_patterns/4             % +S, +Wanted, +Options, -Ds
          ]).
:- use_module('../csg/placed_surface',
              [asked_once/1, placed_surface/3, placed_term/2]).
:- use_module('../development/bend', [pattern_bent/2]).
:- use_module('../development/polygon_name', [polygon_name/3]).
:- use_module('../primitive/primitive_pipe', [is_mitred/1]).
:- use_module('../store',
              [e/5, p/3, origin/3, edge_polygon/3, facts_transaction/1]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module('../unrolling/sphere_facet', [has_sphere/1, sphere_cut/2]).
:- use_module('../unrolling/transition_facet', [takes_turns/1]).
:- use_module('../stage', [stage/2]).
:- use_module('../unrolling/true_development',
              [true_development/4, developable_part/3]).
:- use_module('../unrolling/true_leaf', [composed_leaves/2]).
:- use_module('../unrolling/true_parts',
              [drawn_wanted/4, parts_made/3, polygon_drawn/4]).
:- use_module('../unrolling/true_plate',
              [plate_alone/4, plate_fits/2, plate_parts/5]).
:- use_module('../unrolling/true_rim', [pattern_measured/1, rims_rounded/3]).
:- use_module('../unrolling/true_shape', [part_facet/5]).
:- use_module('../unrolling/true_sphere',
              [ sphere_development/4, sphere_part/2, sphere_part_polygon/3
              ]).
:- use_module(unfold, [trimmed_part/3, other_parts/3, part_developed/4]).
:- use_module(unfold_wish, [wanted_in/4]).
:- use_module(library(apply), [include/3, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets),
              [ord_memberchk/2, ord_subtract/3, ord_union/3]).
/** <module> True patterns: what is round is unrolled, the rest laid flat.
*/

%!  true_patterns(+S, +Wanted, +Options:list, -Ds:list) is det.
%
%   Ds are the patterns of segment S, trimmed if Options say so (unfold/3): one
%   of each part that can be unrolled (true_development/4, which has the other
%   options), then one of all polygons that are left, if there are any, as is
%   Wanted (unfolded_part/4). What is round is unrolled as a whole, or left out
%   if all of it is to be removed; an edge between its facets that should be cut
%   is its seam. A warning if edges should be kept between what is unrolled and
%   what is flat. If the plate has a thickness, what is trimmed are the surfaces
%   that touch (plate_parts/5). One transaction.
%
%   @error as plate_fits/2, plate_parts/5, trimmed/4 (of S);
%   geometry_error(true(no_option(S, Option))): of a sphere half(true), and
%   generators(N) of zones, say nothing

true_patterns(S, Wanted, Options, Ds) :-
    asked_once(facts_transaction(
                   sg_unfold_true:patterns(S, Wanted, Options, Ds))).

patterns(S, Wanted, Options0, Ds) :-
    plate_fits(S, Options0),
    trimmed_as_cut(S, Options0, Options, S1, T),
    drawn_wanted(S1, S, Wanted, Wanted1),
    wanted_in(T, S1, Wanted1, Manual),
    option(removed(Removed0), Manual, []),
    sort(Removed0, Removed),
    findall(Part,
            ( true_part(T, Part), \+ part_removed(T, Part, Removed) ),
            Parts),
    option(cut(Cut), Manual, []),
    stage(develop, maplist(unrolled(S, T, Cut, Options), Parts, Unrolled)),
    unrolled_polygons(T, Parts, Ps),
    ord_union(Removed, Ps, Done),
    findall(P, ( p(T, P, _), polygon_drawn(T, P, _, _) ), All0),
    sort(All0, All),
    ord_subtract(All, Done, Rest),
    (   Rest == [],
        Unrolled \== []
    ->  Ds = Unrolled
    ;   flat_wishes(T, Rest, Manual, FlatManual),
        kept_apart_told(T, Rest, Ps, Manual),
        findall(P, ( p(T, P, _), \+ ord_memberchk(P, Rest) ), Others),
        flat_developed(T, [removed(Others)|FlatManual], Options, D),
        append(Unrolled, [D], Ds)
    ).

%   flat_developed(T, Manual, Options, D): what bends take off is taken off true
%   rims and holes.

flat_developed(T, Manual, Options, D) :-
    part_developed(T, Manual, [thickness(0.0)|Options], D),
    rims_rounded(D, T, Options),
    pattern_bent(D, Options),
    (   once(origin(D, e(_), e(_)))
    ->  pattern_measured(D)
    ;   true
    ).

true_part(T, Part) :-
    developable_part(T, Part, _).
true_part(T, Part) :-
    sphere_part(T, Part).

part_polygon(T, Part, P) :-
    part_facet(T, Part, P, _, _).
part_polygon(T, Part, P) :-
    sphere_part_polygon(T, Part, P).

part_removed(T, Part, Removed) :-
    Removed \== [],
    forall(part_polygon(T, Part, P), ord_memberchk(P, Removed)).

%   unrolled_polygons(T, Parts, Ps): Ps are those of Parts, which need no other
%   pattern.

unrolled_polygons(T, Parts, Ps) :-
    findall(P, ( member(Part, Parts), part_polygon(T, Part, P) ), Ps0),
    sort(Ps0, Ps).

%   flat_wishes(T, Rest, Manual, Wishes): what of Manual is of Rest alone.

flat_wishes(T, Rest, Manual, Wishes) :-
    findall(Wish,
            ( member(Option, Manual), flat_wish(T, Rest, Option, Wish) ),
            Wishes).

flat_wish(_, Rest, root(P), root(P)) :-
    ord_memberchk(P, Rest).
flat_wish(T, Rest, cut(Es0), cut(Es)) :-
    include(edge_within(T, Rest), Es0, Es).
flat_wish(T, Rest, keep(Es0), keep(Es)) :-
    include(edge_within(T, Rest), Es0, Es).

edge_within(T, Ps, E) :-
    \+ ( edge_side(T, E, P),
         \+ ord_memberchk(P, Ps)
       ).

%   edge_side(T, E, P) is nondet: P is a polygon of edge E or of its partner.

edge_side(T, E, P) :-
    edge_polygon(T, E, P).
edge_side(T, E, P) :-
    once(e(T, E, A, B, _)),
    e(T, F, B, A, _),
    edge_polygon(T, F, P).

%   kept_apart_told(T, Rest, Ps, Manual): edges that are to be kept between Rest
%   and Ps.

kept_apart_told(T, Rest, Ps, Manual) :-
    option(keep(Es0), Manual, []),
    findall(E,
            ( member(E, Es0),
              edge_side(T, E, P), ord_memberchk(P, Rest),
              edge_side(T, E, Q), ord_memberchk(Q, Ps)
            ),
            Es1),
    sort(Es1, Es),
    length(Es, N),
    (   N =:= 0
    ->  true
    ;   print_message(warning, sanggwan(unfold(kept_apart(T, N))))
    ).

%   trimmed_as_cut(S, Options0, Options, S1, T): T is what is left of S1, which
%   is cut instead of S; S itself if nothing is cut off, and its facets stand
%   for the surface themselves.

trimmed_as_cut(S, Options0, Options, S1, T) :-
    parts_cut(S, Options0, Options1, S2),
    catch(trimmed_part(S2, Options1, T2),
          error(geometry_error(trim(nothing_left(S2, Side))), Context),
          throw(error(geometry_error(trim(nothing_left(S, Side))), Context))),
    (   T2 == S2,
        \+ takes_turns(S),
        \+ has_sphere(S),
        \+ composed_of_plate(S, Options0)
    ->  S1 = S,
        T = S,
        Options = Options0
    ;   S1 = S2,
        T = T2,
        Options = Options1
    ).

%   parts_cut(S, Options0, Options, S1): S1 is S, or what is cut instead: what
%   of its plate touches the others, which are then among Options, in fine
%   facets. What stands for a smooth surface only as its facets are fine has
%   such ones also where nothing is cut, a sphere those of its gores or
%   zones; and the leaves of a CSG tree cut each other by the middle of their
%   plate.

parts_cut(S, Options0, [by(Others)|Options], S1) :-
    option(trim(_), Options0),
    !,
    other_parts(S, Options0, Others0),
    plate_parts(S, Others0, Options0, Options, S1-Others),
    complete_segments.
parts_cut(S, Options0, Options, S1) :-
    composed_of_plate(S, Options0),
    !,
    plate_alone(S, Options0, Options, S1),
    complete_segments.
parts_cut(S, Options, Options, S1) :-
    ( takes_turns(S) ; has_sphere(S) ),
    !,
    parts_made([S-0.0], Options, [S1]),
    complete_segments.
parts_cut(S, Options, Options, S).

%   composed_of_plate(S, Options): where the leaves or pieces of S meet depends
%   on the side of their plate.

composed_of_plate(S, Options) :-
    option(thickness(T), Options),
    T =\= 0,
    (   placed_term(S, Term)
    ->  is_mitred(Term)
    ;   composed_leaves(S, Leaves),
        once(( member(Leaf, Leaves), placed_surface(Leaf, _, _) ))
    ).

%   unrolled(S, T, Cut, Options, Part, D): the seam is where an edge of it is to
%   be cut, if nothing else is said. Errors are those of S, of which T was made.

unrolled(S, T, Cut, Options, Part, D) :-
    (   sphere_part_polygon(T, Part, _)
    ->  sphere_checked(S, Options),
        sphere_development(T, Part, Options, D)
    ;   seam_options(T, Part, Cut, Options, Options1),
        catch(true_development(T, Part, Options1, D),
              error(geometry_error(true(nothing_left(T, Part))), Context),
              nothing_left(S, Part, Context))
    ).

seam_options(T, Part, Cut, Options, Options1) :-
    (   \+ option(seam(_), Options),
        member(E, Cut),
        generator_at(T, Part, E, Degrees)
    ->  Options1 = [seam(Degrees)|Options]
    ;   Options1 = Options
    ).

nothing_left(S, Part, Context) :-
    (   Part = _/Name
    ->  true
    ;   Name = Part
    ),
    throw(error(geometry_error(true(nothing_left(S, Name))), Context)).

%   sphere_checked(S, Options): what would say nothing is refused.

sphere_checked(S, Options) :-
    sphere_cut(Options, Cut),
    member(Option0, [half(true),generators(_)]),
    memberchk(Option0, Options),
    ( Option0 = half(_) ; Cut = zones(_) ),
    !,
    functor(Option0, Option, _),
    throw(error(geometry_error(true(no_option(S, Option))), _)).
sphere_checked(_, _).

%   generator_at(T, Part, E, Degrees): edge E is between two facets of Part.

generator_at(T, Part, E, Degrees) :-
    (   Part = _/Name
    ->  true
    ;   Name = Part
    ),
    once(e(T, E, A, B, _)),
    once(( edge_polygon(T, E, P),
           e(T, F, B, A, _),
           edge_polygon(T, F, Q) )),
    facet_name(T, P, curved(Name, [From1-To1|_])),
    facet_name(T, Q, curved(Name, [From2-To2|_])),
    (   same_direction(To1, From2)
    ->  Degrees = To1
    ;   same_direction(To2, From1)
    ->  Degrees = To2
    ).

%   facet_name(T, P, What): also of a leaf.

facet_name(T, P, What) :-
    polygon_name(T, P, Name),
    (   Name = _/What0
    ->  What = What0
    ;   What = Name
    ).

same_direction(A, B) :-
    Off is abs(A-B),
    ( Off =:= 0 ; Off =:= 360 ),
    !.
