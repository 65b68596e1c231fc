:- module(sg_surface_tone,
          [ tone/3,                     % +Look, +Normal, -Tone
            tone_sum/3,                 % +Shade, -Constant, -Ways
            picture_normal/2,           % +Normal, -InPicture
            look_tones/2,               % +Look, -Tones
            light_ways/1,               % -Ways
            look_shine/2                % +Look, -Shine
          ]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../kernel', [image_normals/1]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../picture/view', [current_view/4, view_matrix/3]).
:- use_module('../store', [light/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2, sum_list/2]).
/** <module> How light a side of a solid is (CB-8).

A tone is a number from 0 to 1. It is a constant and, for each light, a factor
times the product of two unit vectors, where the light comes from and where the
side looks, but at least so much:

    lambert, cel   what comes from everywhere, and each light, at least 0
    gooch, zebra   half of the first light, and a half
    flat           1
    xray           1 less the cosine of the angle to the line of sight

Light 0 comes from everywhere, its strength is 0.25 if no fact says another
one. Light 1 comes from the upper left in front of the picture, with 0.75, if
no fact says where any light comes from.
*/

:- decision(tone/3, "How light a side of a solid is, by where it looks").

%!  tone(+Look, +Normal, -Tone) is semidet.
%
%   True when a side that has Look, properties as of surface_look/4 with
%   shade(Shade), and looks along the unit vector Normal, has this Tone; Normal
%   is vector(Right, Up, Towards), in the picture, towards the eye. A decision;
%   where a rule has no answer, this one holds.

tone(Look, vector(X,Y,Z), Tone) :-
    memberchk(shade(Shade), Look),
    tone_sum(Shade, Constant, Ways),
    maplist(way_tone(X, Y, Z), Ways, Tones),
    sum_list([Constant|Tones], Sum),
    Tone is max(0.0, min(1.0, Sum)).

way_tone(X, Y, Z, way(A,B,C,Factor,Least), Tone) :-
    Tone is max(Least, Factor*(A*X + B*Y + C*Z)).

%!  tone_sum(+Shade, -Constant, -Ways) is det.
%
%   A tone is Constant and, for each way(X, Y, Z, Factor, Least), Factor times
%   the product of the unit vector (X, Y, Z), in the axes of the picture, and
%   the normal, but at least Least.

tone_sum(flat, 1.0, []) :-
    !.
tone_sum(xray, 1.0, [way(0.0,0.0,1.0,-1.0,-1.0)]) :-
    !.
tone_sum(Shade, 0.5, [way(X,Y,Z,0.5,-0.5)]) :-
    memberchk(Shade, [gooch,zebra(_)]),
    !,
    lights([lit(X,Y,Z,_)|_]).
tone_sum(_, Constant, Ways) :-
    light_strength(0, Constant),
    lights(Lights),
    findall(way(X,Y,Z,Strength,0.0), member(lit(X,Y,Z,Strength), Lights), Ways).

%   lights(Lights): lit(X, Y, Z, Strength) by number: a unit vector to where
%   each comes from, in the axes of the picture.

lights(Lights) :-
    findall(N, ( light(N, _), N > 0 ), Ns0),
    sort([1|Ns0], Ns),
    (   member(N, Ns),
        light_way(N, _)
    ->  Shining = Ns
    ;   Shining = [1]
    ),
    findall(lit(X,Y,Z,Strength),
            ( member(N, Shining),
              (   light_way(N, Way)
              ->  true
              ;   N =:= 1,
                  Shining == [1],
                  Way = [-5,6,8]
              ),
              unit(Way, [X,Y,Z]),
              light_strength(N, Strength) ),
            Lights).

light_way(N, [X,Y,Z]) :-
    light(N, picture(X,Y,Z)),
    !.
light_way(N, Way) :-
    light(N, direction(X,Y,Z)),
    view_axes([Right,Up,Towards]),
    Back = [-X,-Y,-Z],
    maplist(product(Back), [Right,Up,Towards], Way).

light_strength(N, Strength) :-
    (   light(N, strength(F))
    ->  Strength is float(F)
    ;   N =:= 0
    ->  Strength = 0.25
    ;   Strength = 0.75
    ).

unit(Vector, Unit) :-
    findall(A, ( member(X, Vector), A is abs(X) ), Sizes),
    max_of(Sizes, Most),
    findall(Y, ( member(X, Vector), Y is float(X)/Most ), Scaled),
    product(Scaled, Scaled, Square),
    findall(Y, ( member(X, Scaled), Y is X/sqrt(Square) + 0.0 ), Unit).

max_of([X,Y,Z], Most) :-
    Most is float(max(X, max(Y, Z))).

product([X,Y,Z], [A,B,C], Product) :-
    Product is A*X + B*Y + C*Z.

%   view_axes(Axes): what is to the right, up and towards the eye, in the
%   model.

view_axes(Axes) :-
    current_view(Theta, Phi, _, _),
    view_matrix(Theta, Phi, [r(A1,B1,C1), r(A2,B2,C2), r(A3,B3,C3)]),
    maplist(float_vector, [[A1,B1,C1], [A2,B2,C2], [-A3,-B3,-C3]], Axes).

float_vector(Vector, Floats) :-
    maplist(float_of, Vector, Floats).

float_of(X, F) :-
    F is float(X) + 0.0.

%!  picture_normal(+Normal, -InPicture) is det.
%
%   InPicture is the vector(X, Y, Z) Normal of the model to the right, up and
%   towards the eye.

picture_normal(vector(X,Y,Z), vector(Right,Up,Towards)) :-
    view_axes(Axes),
    maplist(product([X,Y,Z]), Axes, [Right,Up,Towards]).

%!  look_tones(+Look, -Tones) is det.
%
%   Tones are those of Look for image_shade/5: the sum, or, if a rule decides,
%   the table of what it says of all normals.

look_tones(Look, sum(Constant,Ways)) :-
    decision_is_default(tone/3),
    !,
    memberchk(shade(Shade), Look),
    tone_sum(Shade, Constant, Ways0),
    view_axes(Axes),
    maplist(model_way(Axes), Ways0, Ways).
look_tones(Look, table(Numbers,Tones)) :-
    view_axes([[A,B,C],[D,E,F],[G,H,I]]),
    Numbers = [A,B,C,D,E,F,G,H,I],
    image_normals(Normals),
    maplist(normal_tone(Look), Normals, Tones).

model_way([[A1,B1,C1],[A2,B2,C2],[A3,B3,C3]], way(X,Y,Z,Factor,Least),
          way(A,B,C,Factor,Least)) :-
    A is A1*X + A2*Y + A3*Z + 0.0,
    B is B1*X + B2*Y + B3*Z + 0.0,
    C is C1*X + C2*Y + C3*Z + 0.0.

normal_tone(Look, Normal, Tone) :-
    (   tone(Look, Normal, Tone0),
        number(Tone0)
    ->  Tone is max(0.0, min(1.0, float(Tone0))) + 0.0
    ;   Tone = 0.0
    ).

%!  light_ways(-Ways) is det.
%
%   Ways are where the lights of look_tones/2 and look_shine/2 come from, in
%   their order: [X,Y,Z], unit vectors of the model.

light_ways(Ways) :-
    lights(Lights),
    view_axes(Axes),
    findall([A,B,C],
            ( member(lit(X,Y,Z,_), Lights),
              model_way(Axes, way(X,Y,Z,0,0), way(A,B,C,_,_)) ),
            Ways).

%!  look_shine(+Look, -Shine) is det.
%
%   Shine is that of Look for image_shade/5: under `lambert` each light is
%   thrown back, half-way between it and the eye the most. The eye is where the
%   middle of the picture is seen from.

look_shine(Look, shine(Power,Ways)) :-
    (   memberchk(shine(Strength,Power0), Look),
        memberchk(shade(lambert), Look)
    ->  Power = Power0,
        lights(Lights),
        view_axes(Axes),
        findall(Way,
                ( member(Light, Lights),
                  halved(Light, Strength, Half),
                  model_way(Axes, Half, Way) ),
                Ways)
    ;   Power = 1,
        Ways = []
    ).

%   halved(Light, Strength, Way): half-way between Light and the eye; a light
%   behind everything is thrown back nowhere.

halved(lit(X,Y,Z,F), Strength, way(A,B,C,Factor,0.0)) :-
    Z1 is Z+1.0,
    (   is_rounding(X, 1),
        is_rounding(Y, 1),
        is_rounding(Z1, 1)
    ->  [A,B,C] = [0.0,0.0,1.0],
        Factor = 0.0
    ;   unit([X,Y,Z1], [A,B,C]),
        Factor is Strength*F
    ).
