:- module(sg_pattern_scale,
          [ height_scale/4,             % +Ds, +Axis, +Millimetres, -Scale
            fitting_scale/4,            % +Pieces, +Paper, +Options, -Scale
            pages_scale/4,              % +Area, +Room, :Pages, -Scale
            scale_text/2                % +Scale, -Text
          ]).
:- use_module('../bisection', [bisection/5]).
:- use_module(pattern_fit, [joint_depth/3, joint_is_wide/5]).
:- use_module(pattern_nest, [fits_on/2]).
:- use_module(pattern_piece, [piece_points/2]).
:- use_module('../store', [v/5]).
:- use_module('../unfolding/unfold', [pattern_of/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2, min_list/2]).
/** <module> The scale of a pattern, from what should come of it.

A paper model is to be 200 mm high, or to take five pages, and nobody knows the
scale for that. A scale is how many millimetres a unit of the model is.
*/

:- set_prolog_flag(optimise, true).

% How near to the best scale one is that has to be searched for.
steps(12).
worse(0.97).

%!  height_scale(+Ds:list, +Axis, +Millimetres, -Scale) is det.
%
%   What the patterns Ds are of is Millimetres high at Scale, from its lowest
%   vertex to its highest along Axis, `x`, `y` or `z`.
%
%   @error usage_error(pattern(no_height)): it is flat, or nobody knows of what
%          these patterns are

height_scale(Ds, Axis, Millimetres, Scale) :-
    (   aggregate_all(r(min(H), max(H)),
                      ( member(D, Ds),
                        pattern_of(D, T),
                        v(T, _, X, Y, Z),
                        along(Axis, X, Y, Z, H) ),
                      r(Low, High)),
        High > Low
    ->  Scale is Millimetres/(High-Low)
    ;   throw(error(usage_error(pattern(no_height)), _))
    ).

along(x, X, _, _, X).
along(y, _, Y, _, Y).
along(z, _, _, Z, Z).

%!  fitting_scale(+Pieces, +Paper, +Options, -Scale) is det.
%
%   Scale is the largest at which each of Pieces, in units of the model, fits on
%   Paper (pattern_nest.pl) with what joins it all round: tabs(W), lap(W) or
%   lock(W) (pattern_fit.pl); within a hundredth.

fitting_scale(Pieces, room(RoomW,RoomH,Gap), Options, Scale) :-
    joint_depth(Options, Joint, Deep),
    W is RoomW-2*Deep,
    H is RoomH-2*Deep,
    (   min(W, H) > 0
    ->  maplist(piece_scale(room(W,H,Gap)), Pieces, Scales),
        min_list(Scales, Scale)
    ;   Most is min(RoomW, RoomH)/4,
        joint_is_wide(Joint, Most, Deep, RoomW, RoomH)
    ).

%   A piece that is as long as the diagonal of the page might just fit; half of
%   that, or less, may be the most.

piece_scale(Paper, Piece, Scale) :-
    Paper = room(W, H, _),
    piece_points(Piece, Points),
    points_reach(Points, Reach),
    High is sqrt(W*W+H*H)/Reach,
    steps(Steps),
    bisection(Steps, points_fit(Points, Paper), 0.0, High, Scale).

points_reach(Points, Reach) :-
    aggregate_all(r(min(X), max(X), min(Y), max(Y)), member(X-Y, Points),
                  r(X1,X2,Y1,Y2)),
    Reach is max(X2-X1, Y2-Y1).

points_fit(Points, Paper, Scale) :-
    maplist(scaled(Scale), Points, Scaled),
    fits_on(Scaled, Paper).

scaled(Scale, X0-Y0, X-Y) :-
    X is Scale*X0,
    Y is Scale*Y0.

:- meta_predicate pages_scale(+, +, 1, -).

%!  pages_scale(+Area, +Room, :Pages, -Scale) is det.
%
%   Scale is the largest, within three parts of a hundred, at which call(Pages,
%   Scale) is true: the pattern takes no more pages than wanted. Area is that of
%   the pattern in units of the model, Room that of all these pages, in square
%   millimetres.

pages_scale(Area, Room, Pages, Scale) :-
    Most is sqrt(Room/Area),
    (   member(Share-Above, [0.8-1.0,0.65-0.8,0.5-0.65,0.3-0.5,0.1-0.3]),
        Low is Share*Most,
        call(Pages, Low)
    ->  High is Above*Most,
        nearer(Pages, Low, High, Scale)
    ;   throw(error(usage_error(pattern(no_scale)), _))
    ).

:- meta_predicate nearer(1, +, +, -).

nearer(Pages, Low, High, Scale) :-
    worse(Worse),
    (   Low >= Worse*High
    ->  Scale = Low
    ;   Middle is (Low+High)/2,
        (   call(Pages, Middle)
        ->  nearer(Pages, Middle, High, Scale)
        ;   nearer(Pages, Low, Middle, Scale)
        )
    ).

%!  scale_text(+Scale, -Text) is det.
%
%   Text, a string, is how Scale, N:M or a number, is written: 1:2, 70:1.

scale_text(N:M, Text) :-
    !,
    format(string(Text), '~w:~w', [N,M]).
scale_text(Factor, Text) :-
    (   Factor >= 1
    ->  format(string(Text), '~4g:1', [Factor])
    ;   M is 1/Factor,
        format(string(Text), '1:~4g', [M])
    ).
