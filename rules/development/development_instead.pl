:- module(sg_development_instead,
          [ seam_instead/4              % +D, +J, +Fold, -Result
          ]).
:- use_module(laid_joint, [joint_faces/4]).
:- use_module(development, [with_flattening/3]).
:- use_module(development_record, [recorded_development/4]).
:- use_module('../kernel',
              [ flattening_lay/2, flattening_measures/2, join_faces/3,
                join_folds/2
              ]).
:- use_module('../store', [joint/6, piece/3, edge_polygon/3]).
/** <module> A development with one of its seams joined and a fold cut instead.

It is really laid, since a fold more may bring sides together that are no fold
yet (all the parts of a divided edge), and may let faces overlap.
*/

%!  seam_instead(+D, +J, +Fold, -Result) is det.
%
%   Pattern D with its seam J joined and its joint Fold cut, which is on the way
%   between the faces of J, and whatever else is between the two polygons of
%   Fold, such as other parts of its edge. Result is
%
%     - seam(Length)
%       That is its whole seam.
%     - overlap(P1, P2)
%       Polygon P2 would lie on P1.
%     - none
%       J may not be joined, or its faces are connected in yet another way.
%
%   @error existence_error(development, D): see seam_reason/3

seam_instead(D, J, Fold, Result) :-
    recorded_development(D, S, Options, _),
    with_flattening(S, Options, joined_instead(D, J, Fold, Result)).

joined_instead(D, J, Fold, Result, Flattening) :-
    polygons_of(Flattening, Fold, Two),
    findall(J1,
            ( joint(D, J1, _, _, fold, _),
              \+ polygons_of(Flattening, J1, Two) ),
            Folds),
    join_folds(Flattening, Folds),
    join_faces(Flattening, J, Joined),
    (   Joined == joined
    ->  forall(joint_inside(D, J1), join_faces(Flattening, J1, _)),
        flattening_lay(Flattening, 0),
        flattening_measures(Flattening, Measures),
        arg(1, Measures, Seam),
        Result = seam(Seam)
    ;   Joined = overlap(_, _)
    ->  Result = Joined
    ;   Result = none
    ).

polygons_of(Flattening, J, Two) :-
    joint_faces(Flattening, J, P1, P2),
    sort([P1,P2], Two).

%   joint_inside(D, J): both sides of joint J are in one piece, so they may come
%   to lie on each other.

joint_inside(D, J) :-
    joint(D, J, E1, E2, Kind, _),
    Kind \== line,
    once(( edge_polygon(D, E1, P1), piece(D, P1, K) )),
    once(( edge_polygon(D, E2, P2), piece(D, P2, K) )).
