:- module(sg_true_parts,
          [ parts_made/3,               % +Sizes, +Options, -Parts
            polygon_drawn/4,            % +T, +P, -S, -P0
            drawn_wanted/4,             % +S1, +S, +Wanted, -Wanted1
            drawn_borders/2,            % +Leaf, -Directions
            pieces_as_drawn/3,          % +S, +Facets0, -Facets
            facets_as_drawn/4,          % +S, +Facets0, +Shape, -Facets
            facet_chord/3,              % +Options, +Surface, -Chord
            surface_radius/2            % +Surface, -Radius
          ]).
:- use_module('../csg/csg', [is_node/1]).
:- use_module('../csg/placed_surface',
              [ drawn_polygon/4, placed_face/3, placed_polygon/4,
                placed_surface/3, placed_term/2
              ]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module('../primitive/primitive', [primitive_parts/3]).
:- use_module('../primitive/primitive_rows', [add_primitive/2]).
:- use_module('../solid/boolean', [boolean/3]).
:- use_module('../solid/csg_flat',
              [flat_expression/2, flat_leaves/2, is_half/1]).
:- use_module('../store', [origin/3, from_p/5, assert_fact/1, fresh_id/3]).
:- use_module(sphere_facet,
              [ grid_term/3, round_sphere/3, sphere_faces_known/3, sphere_grid/3
              ]).
:- use_module(transition_facet,
              [facet_borders/2, facet_in_direction/3, transition_facets/2]).
:- use_module(true_flat, [flat_resized/3]).
:- use_module(true_join,
              [ facets_between/3, facets_connected/2, facets_joined/2,
                outer_halves/2
              ]).
:- use_module(true_leaf,
              [ composed_known/4, composed_tolerance/2, large_enough/3,
                leaves_replaced/3, plate_leaves/2
              ]).
:- use_module(true_parallel, [parallel_made/4]).
:- use_module(true_resized, [term_enlarged/3]).
:- use_module(true_part_loop, [facet_parted/3]).
:- use_module(true_tip, [tips_cancelled/2]).
:- use_module(library(apply),
              [foldl/4, include/3, maplist/2, maplist/3, partition/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [ append/2, append/3, max_list/2, member/2, memberchk/2,
                min_list/2, selectchk/3
              ]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> The parts of a scene as they are cut for a true pattern.

Facets meet elsewhere than the surfaces they stand for: they may miss an edge
that the true surface goes over, or meet two in another order. So what is cut
are not the parts that are drawn, but the same ones in facets so fine that they
are within the chord tolerance, and as large as the sides of their plates that
touch (true_plate.pl). A part S1 that was made for this has

    origin(S1, node(S1), plate(S))      S is what is drawn
    origin(S1, p(P1), p(P))             its polygon P1 stands for polygon P of S

and facets that stand for one facet are put together again when they are
unrolled (facets_as_drawn/4): a pattern has the facets that are drawn.

Which of two coincident faces a part keeps goes by the numbers of segments; so
all parts are made again, in the order they had.
*/

%!  parts_made(+Sizes, +Options, -Parts:list) is det.
%
%   Sizes is a list of S-By, first the part that is unfolded, then the others.
%   Parts are new segments, each By larger than S all round (model units), of
%   fine facets; or the segments S, if nothing has to be changed, and those of
%   them that cannot be made again without being resized. Results of CSG trees
%   are made again of the primitives they are made of.
%   Of Options: chord(Tolerance); layer(Layer), how far outside of what is drawn
%   that layer of the first part is that is unrolled.
%
%   @error geometry_error(true(no_offset(S))): no other side of its plate is
%          known

parts_made(Sizes, Options, Parts) :-
    pairs_keys_values(Sizes, Ss, Bys),
    fineness(Ss, Options, Finers),
    (   changes_nothing(Bys, Finers)
    ->  Parts = Ss
    ;   triples(Sizes, Finers, Triples0),
        sort(1, @=<, Triples0, Triples),
        Ss = [First|_],
        option(layer(Layer), Options, 0.0),
        foldl(part_made(First-Layer), Triples, [], Made),
        findall(S1, ( member(S, Ss), memberchk(S-S1, Made) ), Parts)
    ).

changes_nothing(Bys, Finers) :-
    \+ ( member(By, Bys), By =\= 0 ),
    \+ ( member(Finer, Finers), changes(Finer) ).

changes(times(_)).
changes(within(_)).
changes(grid(_, _, _)).
changes(composed(Finers)) :-
    once(( member(_-Finer, Finers), changes(Finer) )).

triples([], [], []).
triples([S-By|Sizes], [Finer|Finers], [part(S, By, Finer)|Triples]) :-
    triples(Sizes, Finers, Triples).

part_made(First-Layer, part(S, By, Finer), Made, [S-S1|Made]) :-
    (   By =:= 0,
        Finer == kept
    ->  S1 = S
    ;   inmost(S, By, First-Layer, Inmost),
        made(By, Inmost, Finer, S, S1)
    ->  polygons_known(S, S1),
        assert_fact(origin(S1, node(S1), plate(S)))
    ;   throw(error(geometry_error(true(no_offset(S))), _))
    ).

inmost(S, By, First-Layer, Inmost) :-
    (   S == First
    ->  Inmost is min(By, Layer)
    ;   Inmost = By
    ).

made(By, Inmost, composed(Finers), S, S1) :-
    !,
    composed_again(S, By, Inmost, Finers, S1).
made(By, _, _, S, S1) :-
    \+ placed_surface(S, _, _),
    flat_resized(S, By, S1).
made(By, Inmost, Finer, S, S1) :-
    placed_term(S, Term0),
    term_finer(Finer, Term0, Term),
    (   term_enlarged(Term, By, Term1)
    ->  add_primitive(Term1, S1)
    ;   parallel_made(Term, By, Inmost, S1)
    ).

%   composed_again(S, By, Inmost, Finers, S1): S1 is the result of the same
%   operations as S, on leaves made again: those of plate By larger. What only
%   takes away, a half-space or what is subtracted, is a tool, and stays.

composed_again(S, By, Inmost, Finers, S1) :-
    flat_expression(S, Expression0),
    plate_leaves(Expression0, Plates),
    large_enough(S, By, Plates),
    foldl(leaf_again(S, Plates, By, Inmost), Finers, [], Made),
    leaves_replaced(Made, Expression0, Expression),
    complete_segments,
    composed_tolerance(Expression, Options),
    fresh_id(segment, 0, S1),
    boolean(Expression, S1, Options),
    complete_segments.

leaf_again(S, Plates, By0, Inmost0, Leaf-Finer, Made0, Made) :-
    (   ord_memberchk(Leaf, Plates)
    ->  By = By0,
        Inmost = Inmost0
    ;   By = 0,
        Inmost = 0
    ),
    (   By =:= 0,
        \+ changes(Finer)
    ->  Made = [Leaf-Leaf|Made0]
    ;   made(By, Inmost, Finer, Leaf, Leaf1)
    ->  polygons_known(Leaf, Leaf1),
        assert_fact(origin(Leaf1, node(Leaf1), plate(Leaf))),
        Made = [Leaf-Leaf1|Made0]
    ;   throw(error(geometry_error(true(no_offset(S))), _))
    ).

%   polygons_known(S, S1): which polygon of S each of S1 stands for: of the
%   facets of a part of which another side is wanted, the nearest; of those of a
%   transition that in the same direction.

polygons_known(S, S1) :-
    (   transition_facets(S, Drawn)
    ->  transition_facets(S1, Fine),
        forall(member(G1-G2-P1, Fine),
               ( G is (G1+G2)/2.0,
                 facet_in_direction(Drawn, G, P),
                 assert_fact(origin(S1, p(P1), p(P))) )),
        findall(What-P,
                ( member(What, [base,top]), placed_face(S, P, What) ),
                Ends),
        forall(( member(What-P, Ends), placed_face(S1, P1, What) ),
               assert_fact(origin(S1, p(P1), p(P))))
    ;   once(round_sphere(S, _, _))
    ->  sphere_faces_known(S, S1, Pairs),
        forall(member(P1-P, Pairs), assert_fact(origin(S1, p(P1), p(P)))),
        forall(( placed_face(S, P, base), placed_face(S1, P1, base) ),
               assert_fact(origin(S1, p(P1), p(P))))
    ;   placed_surface(S, _, _)
    ->  drawn_faces(S, Drawn),
        forall(( placed_face(S1, P1, What1),
                 drawn_face(Drawn, What1, P) ),
               assert_fact(origin(S1, p(P1), p(P))))
    ;   is_node(S),
        \+ placed_term(S, _)
    ->  forall(composed_known(S, S1, P1, P),
               assert_fact(origin(S1, p(P1), p(P))))
    ;   true
    ).

%   drawn_faces(S, Drawn): an assoc from what the faces of S are to their
%   polygons, and from part(Name) to the facets From-To-P of that part.

drawn_faces(S, Drawn) :-
    findall(What-P, placed_face(S, P, What), Faces0),
    sort(1, @<, Faces0, Faces),
    findall(part(Name)-(From-To-P),
            member(curved(Name, [From-To])-P, Faces0),
            Facets0),
    keysort(Facets0, Facets1),
    group_pairs_by_key(Facets1, Facets),
    append(Faces, Facets, Pairs0),
    keysort(Pairs0, Pairs),
    list_to_assoc(Pairs, Drawn).

drawn_face(Drawn, What1, P) :-
    (   get_assoc(What1, Drawn, P0)
    ->  P = P0
    ;   What1 = curved(Name, [A-B]),
        get_assoc(part(Name), Drawn, Facets),
        Middle is (A+B)/2.0,
        (   member(From-To-P, Facets),
            Middle >= From,
            Middle =< To
        ->  true
        ;   findall(Off-P0,
                    ( member(From-To-P0, Facets),
                      Off is max(0.0, max(From-Middle, Middle-To)) ),
                    Found),
            keysort(Found, [_-P|_])
        )
    ).


                /*******************************
                *           FINENESS           *
                *******************************/

%   fineness(Ss, Options, Finers): what is done with the facets of each: `kept`,
%   the segment stays as it is; `copied`, the same facets; times(N), N for each;
%   within(Chord), others, no farther than that from the true surface;
%   grid(Facets, Bands, Turn), those of sphere_grid/3;
%   composed(Finers), the result of a CSG tree, of leaves Leaf-Finer. All are
%   kept if one cannot be made again, or if the first has facets that are laid
%   flat.

fineness([S|Others], Options, Finers) :-
    (   first_finer(Options, S, Finer),
        maplist(finer_or_composed(Options), Others, FinersOfOthers)
    ->  Finers = [Finer|FinersOfOthers]
    ;   maplist(kept, [S|Others], Finers)
    ).

%   first_finer(Options, S, Finer): what is unfolded itself has nothing round
%   that does not unroll.

first_finer(Options, S, Finer) :-
    finer_or_composed([first(true)|Options], S, Finer),
    (   Finer = composed(Finers)
    ->  forall(member(Leaf-_, Finers), can_be_cut(Leaf)),
        spheres_alone(S)
    ;   can_be_cut(S)
    ).

%   spheres_alone(S): beside a sphere nothing else that is round is plate in S,
%   whose facets might meet those of its gores in slivers.

spheres_alone(S) :-
    flat_expression(S, Expression),
    plate_leaves(Expression, Plates),
    findall(Kind,
            ( member(Leaf, Plates),
              placed_surface(Leaf, _, Surface),
              functor(Surface, Kind, _) ),
            Kinds0),
    sort(Kinds0, Kinds),
    (   memberchk(sphere, Kinds)
    ->  Kinds == [sphere]
    ;   true
    ).

can_be_cut(S) :-
    (   unrolls_or_flat(S)
    ->  true
    ;   once(round_sphere(S, _, _))
    ).

finer_or_composed(Options, S, Finer) :-
    (   made_alone(S)
    ->  finer(Options, S, Finer)
    ;   is_node(S),
        flat_expression(S, Expression),
        flat_leaves(Expression, Leaves),
        Leaves = [_|_],
        maplist(finer_leaf([cut(true)|Options]), Leaves, Finers0),
        pairs_keys_values(Finers, Leaves, Finers0),
        Finer = composed(Finers)
    ).

finer_leaf(Options, Leaf, Finer) :-
    (   is_half(Leaf)
    ->  Finer = kept
    ;   placed_term(Leaf, _),
        finer(Options, Leaf, Finer)
    ).

kept(_, kept).

made_alone(S) :-
    (   is_node(S)
    ->  placed_term(S, _)
    ;   \+ from_p(S, _, _, _, _)
    ).

unrolls_or_flat(S) :-
    forall(placed_surface(S, _, Surface),
           ( functor(Surface, Kind, _),
             memberchk(Kind, [cylinder,cone,fan,transition]) )).

finer(Options, S, Finer) :-
    option(first(true), Options),
    once(round_sphere(S, _, _)),
    !,
    sphere_grid(S, Options, Finer).
finer(Options, S, Finer) :-
    findall(Surface, placed_surface(S, _, Surface), Surfaces),
    findall(Radius,
            ( member(Surface, Surfaces), surface_radius(Surface, Radius) ),
            Radii),
    (   Radii == []
    ->  Finer = copied
    ;   max_list(Radii, Greatest),
        chord(Options, Greatest, Chord),
        placed_term(S, Term),
        widest_facet(Term, Width),
        Wanted is 360.0/acos(1.0 - Chord/Greatest)*pi/360.0,
        N is ceiling(Wanted*Width/360.0),
        (   N =< 1
        ->  Finer = copied
        ;   unrolls_or_flat(S)
        ->  Finer = times(N)
        ;   Finer = within(Chord)
        )
    ).

%!  facet_chord(+Options, +Surface, -Chord) is det.
%
%   How far facets of Surface may be from it, of Options chord(Tolerance).

facet_chord(Options, Surface, Chord) :-
    surface_radius(Surface, Radius),
    chord(Options, Radius, Chord).

%   chord(Options, Radius, Chord): as for rims of flat faces, but no less than
%   720 facets go round.

chord(Options, Radius, Chord) :-
    Usual is 2.0e-4*Radius,
    option(chord(Chord0), Options, Usual),
    Least is Radius*(1.0 - cos(pi/720.0)),
    Chord is min(Radius, max(Least, Chord0)).

%!  surface_radius(+Surface, -Radius) is semidet.
%
%   Radius is the largest of a round Surface; of a torus that of its centre.

surface_radius(Surface, Radius) :-
    Surface =.. [Kind,_,vector(A,B,C),vector(D,E,F)|More],
    Kind \== fan,
    Base is max(sqrt(A*A + B*B + C*C), sqrt(D*D + E*E + F*F)),
    (   Kind == cone,
        More = [_,K]
    ->  Radius is Base*max(1.0, K)
    ;   Radius = Base
    ).

widest_facet(Term, Width) :-
    primitive_parts(Term, Parts, _),
    findall(W, member(part(_, curved(_, W)), Parts), Widths),
    max_list(Widths, Width).

%   term_finer(Finer, Term0, Term): with other facets.

term_finer(copied, Term, Term).
term_finer(kept, Term, Term).
term_finer(Grid, Term0, Term) :-
    Grid = grid(_, _, _),
    innermost(Term0, Inner0, Inner, Term),
    grid_term(Grid, Inner0, Inner).
term_finer(times(N), Term0, Term) :-
    innermost(Term0, Inner0, Inner, Term),
    is_transition(Inner0),
    !,
    argument_replaced(Inner0, [divided], divided(N), Inner).
term_finer(times(N), Term0, Term) :-
    innermost(Term0, Inner0, Inner, Term),
    primitive_parts(Inner0, Parts, _),
    once(member(part(Count, curved(_, _)), Parts)),
    Facets is N*Count,
    facets_replaced(Inner0, facets(Facets), Inner).
term_finer(within(Chord), Term0, Term) :-
    innermost(Term0, Inner0, Inner, Term),
    facets_replaced(Inner0, tolerance(Chord), Inner).

innermost(at(Steps, Term0), Inner0, Inner, at(Steps, Term)) :-
    !,
    innermost(Term0, Inner0, Inner, Term).
innermost(named(Name, Term0), Inner0, Inner, named(Name, Term)) :-
    !,
    innermost(Term0, Inner0, Inner, Term).
innermost(Inner0, Inner0, Inner, Inner).

%   The parts of a transition hang on its facets; so these are divided.

is_transition(Term) :-
    functor(Term, Name, _),
    memberchk(Name, [transition,open_transition]).

facets_replaced(Term0, Fineness, Term) :-
    argument_replaced(Term0, [facets,tolerance,bands,sides], Fineness, Term).

argument_replaced(Term0, Names, New, Term) :-
    Term0 =.. [Name|Arguments0],
    findall(Argument,
            ( member(Argument, Arguments0),
              functor(Argument, Of, _),
              \+ memberchk(Of, Names) ),
            Arguments),
    Term =.. [Name,New|Arguments].


                /*******************************
                *           AS DRAWN           *
                *******************************/

%!  polygon_drawn(+T, +P, -S, -P0) is semidet.
%
%   Polygon P of segment T, which is a part that parts_made/3 made, or was
%   trimmed of one, stands for polygon P0 of S, which is drawn; S-P0 is T-P if T
%   is neither. Fails for the tip of a moved cone, which stands for nothing.

polygon_drawn(T, P, S, P0) :-
    (   from_p(T, P, _, _, _)
    ->  once(placed_polygon(T, P, S1, P1))
    ;   S1-P1 = T-P
    ),
    (   origin(S1, node(S1), plate(_))
    ->  once(drawn_polygon(S1, P1, S, P0))
    ;   S-P0 = T-P
    ).

%!  drawn_wanted(+S1, +S, +Wanted, -Wanted1) is det.
%
%   What is Wanted of segment S (unfold_wish.pl), said of S1, made of it.

drawn_wanted(S, S, Wanted, Wanted) :-
    !.
drawn_wanted(S1, S, wanted(Root0, Cut0, Keep0, Removed0),
             wanted(Root, Cut, Keep, Removed)) :-
    (   Root0 \== none,
        drawn_polygon(S1, Root, S, Root0)
    ->  true
    ;   Root = none
    ),
    maplist(edges_made(S1, S), [Cut0,Keep0], [Cut,Keep]),
    findall(P1, ( member(P, Removed0), drawn_polygon(S1, P1, S, P) ), Removed).

edges_made(S1, S, Edges0, Edges) :-
    findall(edge(E, P1, Q1),
            ( member(edge(E, P, Q), Edges0),
              drawn_polygon(S1, P1, S, P),
              drawn_polygon(S1, Q1, S, Q) ),
            Edges).

%!  facets_as_drawn(+S, +Facets0, +Shape, -Facets) is det.
%
%   Facets of segment S and their Shape (true_shape.pl): those that stand for
%   one facet of what is drawn are one, with the smallest of their numbers: the
%   half-edges between them are left out.

facets_as_drawn(S, Facets0, Shape, Facets) :-
    findall(drawn(D, P)-Facet,
            ( member(Facet, Facets0),
              Facet = facet(P0, _, _, _),
              polygon_drawn(S, P0, D, P) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(D, member(drawn(D, _)-_, Groups), Ds0),
    sort(Ds0, Ds),
    include(stands_for_transition, Ds, Transitions),
    maplist(put_together(Transitions), Groups, Lists),
    append(Lists, Facets2),
    maplist(facet_parted(Shape), Facets2, Parted),
    append(Parted, Facets1),
    sort(1, @=<, Facets1, Facets).

%   put_together(Transitions, Drawn-Group, Facets): one for each
%   connected part of the facet. Transitions are the segments of that kind.

put_together(_, _-[Facet], [Facet]) :-
    !.
put_together(Transitions, drawn(D, PD)-Group, Facets) :-
    (   memberchk(D, Transitions)
    ->  facets_between(Group, T1, T2)
    ;   placed_face(D, PD, curved(_, [T1-T2|_]))
    ->  true
    ;   Group = [facet(_, T1, T2, _)|_]         % of a flat part
    ),
    facets_connected(Group, Parts),
    maplist(one_facet(T1, T2), Parts, Facets).

%   Facets of a transition may stand for one that is a part of another cone.

stands_for_transition(S) :-
    placed_term(S, Term),
    innermost(Term, Inner, _, _),
    is_transition(Inner).

%   one_facet(T1, T2, Part, Facet): a facet that is no plane is two triangles,
%   one of which has a corner alone on the rim; so what goes along the rim in
%   place of what was beyond it (true_border.pl) may be in one, and that piece
%   of the rim in the other.

one_facet(T1, T2, Part, facet(P, T1, T2, Halves)) :-
    findall(P0, member(facet(P0, _, _, _), Part), Ps),
    min_list(Ps, P),
    outer_halves(Part, Halves0),
    tips_cancelled(Halves0, Halves).


                /*******************************
                *      PIECES OF ONE FACET     *
                *******************************/

%!  drawn_borders(+Leaf, -Directions) is det.
%
%   Directions are those between facets of the transition Leaf, or of what it
%   was made for (parts_made/3).

drawn_borders(Leaf, Directions) :-
    transition_facets(Leaf, Facets0),
    findall(G1-G2-P,
            ( member(G1-G2-P0, Facets0), polygon_drawn(Leaf, P0, _, P) ),
            Facets),
    facet_borders(Facets, Directions).

%!  pieces_as_drawn(+S, +Facets0, -Facets) is det.
%
%   As facets_as_drawn/4 of the facets of several parts of segment S, between
%   directions, when their keys are the same on both sides of a generator.

pieces_as_drawn(S, Facets0, Facets) :-
    findall(drawn(D, P)-Facet,
            ( member(Facet, Facets0),
              Facet = facet(P0, _, _, _),
              whole(P0, Whole),
              polygon_drawn(S, Whole, D, P) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    maplist(pieces_together, Groups, Lists),
    append(Lists, Facets1),
    sort(1, @=<, Facets1, Facets).

whole(P0/_, P) :-
    !,
    whole(P0, P).
whole(P, P).

pieces_together(_-Group, Facets) :-
    facets_joined(Group, Facets).
