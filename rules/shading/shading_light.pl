:- module(sg_shading_light,
          [ light_scene/3,              % +Scene, +Way, -Handle
            light_layers/4              % +Scene, +Way, +Point, -Layers
          ]).
:- use_module('../kernel', [shading_box/3]).
:- use_module(seen, [met_layers/4]).
:- use_module(shading_scene,
              [ depth_tolerance/3, other_sight/4, scene_model/2, scene_opened/4,
                scene_scale/2 ]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, member/2]).
/** <module> What a light sees of a shaded picture: for shadows.
*/

%!  light_scene(+Scene, +Way, -Handle) is semidet.
%
%   Handle is a picture, for the kernel, of the solids of Scene from where a
%   light comes, a unit vector Way = [X,Y,Z] of the model: all of it, with dots
%   as large as those of Scene, or larger. Fails if there is nothing.

light_scene(Scene, Way, Handle) :-
    light_picture(Scene, Way, _, _, Handle).

%!  light_layers(+Scene, +Way, +Point, -Layers) is det.
%
%   Layers (met_layers/4) are what of Scene is between the light of
%   light_scene/3 and Point = [X,Y,Z], the first one what the light meets first.

light_layers(Scene, Way, [X,Y,Z], Layers) :-
    light_picture(Scene, Way, Matrix, Tolerance, Handle),
    other_sight(Scene, Handle, Tolerance, Seen),
    length(Rows, 12),
    append(Rows, _, Matrix),
    places(Rows, [X,Y,Z], [XL,YL,ZL]),
    met_layers(Seen, XL, YL, All),
    findall(layer(Depth,R,Leaf,F),
            ( member(layer(Depth,R,Leaf,F), All), Depth < ZL ),
            Layers).

places([], _, []).
places([A,B,C,D|Rows], [X,Y,Z], [Place|Places]) :-
    Place is A*X + B*Y + C*Z + D,
    places(Rows, [X,Y,Z], Places).

light_picture(Scene, Way, Matrix, Tolerance, Handle) :-
    scene_model(Scene, model(_, Facts, Roots)),
    scene_scale(Scene, Scale0),
    maplist(negative, Way, Away),
    across(Away, Right),
    cross(Away, Right, Down),
    light_rows([Right,Down,Away], 1.0, [0.0,0.0,0.0], Unit),
    shading_box(frame(Unit,1,1,0.0), Facts, box(X1,Y1,Z1,X2,Y2,_)),
    most_dots(Most),
    Scale is min(Scale0, Most/max(max(X2-X1, Y2-Y1), 1.0e-300)),
    light_rows([Right,Down,Away], Scale, [X1,Y1,Z1], Matrix),
    Width is ceiling((X2-X1)*Scale) + 2,
    Height is ceiling((Y2-Y1)*Scale) + 2,
    depth_tolerance(Matrix, Facts, Tolerance),
    scene_opened(frame(Matrix,Width,Height,Tolerance), Facts, Roots, Handle).

most_dots(1048576).

%   across([X,Y,Z], Unit): across the axis along which the vector is shortest.

across([X,Y,Z], Unit) :-
    (   abs(X) =< abs(Y),
        abs(X) =< abs(Z)
    ->  Axis = [1.0,0.0,0.0]
    ;   abs(Y) =< abs(Z)
    ->  Axis = [0.0,1.0,0.0]
    ;   Axis = [0.0,0.0,1.0]
    ),
    cross([X,Y,Z], Axis, [A,B,C]),
    Length is sqrt(A*A + B*B + C*C),
    maplist(divided(Length), [A,B,C], Unit).

cross([A,B,C], [D,E,F], [X,Y,Z]) :-
    X is B*F - C*E,
    Y is C*D - A*F,
    Z is A*E - B*D.

%   light_rows(Axes, Scale, From, Matrix): From is one dot from the corner.

light_rows(Axes, Scale, From, Matrix) :-
    maplist(light_row(Scale), Axes, From, Rows),
    append(Rows, Matrix0),
    append(Matrix0, [0.0,0.0,0.0,1.0], Matrix).

light_row(Scale, [X,Y,Z], From, [A,B,C,D]) :-
    A is Scale*X,
    B is Scale*Y,
    C is Scale*Z,
    D is 1.0 - Scale*From.

negative(X, Y) :-
    Y is -X.

divided(Divisor, X, Quotient) :-
    Quotient is X/Divisor.
