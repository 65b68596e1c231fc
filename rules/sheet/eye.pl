:- module(sg_eye,
          [ eye_view/3,                 % +Eye, +Target, -View
            eye_target/2,               % +Target0, -Target
            set_eye/3                   % +Eye, +Target, +Kind
          ]).
:- use_module('../picture/section', [model_box/1]).
:- use_module(sheet_view, [view_towards/3]).
:- use_module('../picture/view', [set_view/3, move_origin/1]).
:- use_module(library(apply), [maplist/4]).
/** <module> An eye that stands somewhere and looks at something.

view/3 is an eye that looks at the origin. To look at another point from a
certain distance the model is moved so that the point comes there.
*/

%!  eye_view(+Eye, +Target, -View) is det.
%
%   View (sheet_view.pl) looks from Eye to Target, each [X,Y,Z]; Target may be
%   `middle`: that of the model.
%
%   @error usage_error(sheet(no_direction('--eye', Text))): they are the same

eye_view(Eye, Target0, View) :-
    eye_target(Target0, Target),
    maplist(difference, Target, Eye, [X,Y,Z]),
    (   view_towards(d(X,Y,Z), view, View0)
    ->  View = View0
    ;   atomic_list_concat(Eye, ',', Text),
        throw(error(usage_error(sheet(no_direction('--eye', Text))), _))
    ).

%!  eye_target(+Target0, -Target) is det.
%
%   Target is the point Target0, or of `middle` that of the model.

eye_target(middle, Target) :-
    !,
    (   model_box(box(X1,Y1,Z1,X2,Y2,Z2))
    ->  maplist(middle, [X1,Y1,Z1], [X2,Y2,Z2], Target)
    ;   Target = [0.0,0.0,0.0]
    ).
eye_target(Target, Target).

difference(A, B, C) :-
    C is A-B.

middle(A, B, C) :-
    C is (A+B)/2.

%!  set_eye(+Eye, +Target, +Kind) is det.
%
%   Look from Eye to Target. If Kind, the projection, is `central`, the current
%   world is moved so that Target is the origin, rounded.
%
%   @error as for eye_view/3

set_eye(Eye, Target0, Kind) :-
    eye_view(Eye, Target0, view(_,Theta,Phi,_)),
    (   Kind == central
    ->  eye_target(Target0, Target),
        maplist(difference, Eye, Target, [X,Y,Z]),
        Rho is sqrt(X*X + Y*Y + Z*Z),
        move_origin(Target)
    ;   Rho = 0
    ),
    set_view(Theta, Phi, Rho).
