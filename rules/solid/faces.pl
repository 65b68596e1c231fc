:- module(sg_faces,
          [ faces_merged/2,             % +Solid, +Options
            region_faces_merged/3,      % +Solid, +Region, +Options
            merge_faces/2               % +Part1, +Part2
          ]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../kernel',
              [ model_tolerance/1, solid_merge/4, solid_neighbours/3 ]).
:- use_module('../penetration/resolve', [moved_said/2, tight_said/1]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_union/3]).
/** <module> Faces: coplanar neighbours become one (CB-5).

A face is what a flat, connected part of a boundary looks like to people: no
line where two operands met, no corner in the middle of an edge. Pieces that
are next to each other and lie in one plane within the tolerance become one
face, with holes; then vertices that lie straight between the only two edges
left at them vanish. Bodies that touch in an edge keep it.

@see c_kernels/solid/face_merge.h
*/

%!  faces_merged(+Solid, +Options:list) is det.
%
%   Merges the faces of Solid, a handle. Options:
%
%     - tolerance(Tolerance)
%     What is not farther than this (model units) from a plane or a line lies in
%     it (tolerance_reach/2). Default: model_tolerance/1.
%     - by_size(Bool)
%     No more than 2^-13 of the size of Solid, which may be a small part of the
%     model. Default: `true` if no number is given, else `false`.
%     - origins(Which)
%     `separate`: faces that come from different segments never become one.
%     Default: `together`.
%     - cells(Bool)
%     `true`: an edge of other faces in the middle of one, or between two,
%     stays. Default: `false`.
%     - apart(Pairs)
%     Never these become one, as of solid_neighbours/3. Default: none.
%
%   Others are ignored.

faces_merged(Solid, Options) :-
    merge_options(Options, Tolerance, BySize, Origins),
    option(cells(Cells), Options, false),
    option(apart(Apart0), Options, []),
    kept_apart(Solid, Tolerance, Apart1),
    ord_union(Apart0, Apart1, Apart),
    solid_merge(Solid, Tolerance,
                [ origins(Origins), apart(Apart), by_size(BySize), cells(Cells)
                ], Moved),
    flattened(Moved, Tolerance).

%   flattened(Moved, Tolerance): what solid_merge/4 says of moves.

flattened(none, _).
flattened(move(How, S, p(X,Y,Z), Move, Beside, N), Tolerance) :-
    Flattened = flattened(S, [X,Y,Z], Move, Beside, N),
    (   How == tight
    ->  tight_said(Flattened)
    ;   moved_said(as_rounded(Flattened), Tolerance)
    ).

merge_options(Options, Tolerance, BySize, Origins) :-
    (   option(tolerance(Tolerance), Options)
    ->  (   Tolerance = own(_)
        ->  BySize0 = true
        ;   BySize0 = false
        )
    ;   model_tolerance(Reach),
        Tolerance = own(Reach),
        BySize0 = true
    ),
    option(by_size(BySize), Options, BySize0),
    option(origins(Origins), Options, together).

%!  region_faces_merged(+Solid, +Region, +Options:list) is semidet.
%
%   Solid is a part of a larger solid: what comes from the leaves of Region (of
%   solid_region/3) and from those near them. Merges its faces as faces_merged/2
%   would those of all of it, and leaves those of Region. Fails where a face of
%   Region and another might become one, or others might become one otherwise
%   than before. The default of merge_faces/2 holds.

region_faces_merged(Solid, Region, Options) :-
    merge_options(Options, Tolerance, BySize, Origins),
    solid_merge(Solid, Tolerance,
                [origins(Origins), by_size(BySize), region(Region)], Moved),
    flattened(Moved, Tolerance).

kept_apart(_, _, []) :-
    decision_is_default(merge_faces/2),
    !.
kept_apart(Solid, Tolerance, Apart) :-
    solid_neighbours(Solid, Tolerance, Pairs),
    exclude(become_one, Pairs, Apart).

become_one(Part1-Part2) :-
    merge_faces(Part1, Part2).

:- decision(merge_faces/2, "Which coplanar neighbours become one face (CB-5)").

%!  merge_faces(+Part1, +Part2) is semidet.
%
%   Decision: neighbours in one plane that are part(S, P, Sense) of polygon P of
%   segment S (Sense -1: it looks the other way) become one face. Part1 is
%   before Part2 in the order of S, P and Sense, 1 before -1. The default: all
%   do.

merge_faces(part(_, _, _), part(_, _, _)).
