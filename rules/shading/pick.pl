:- module(sg_pick,
          [ pick/3                      % ?Pixel, +Options, ?Picked
          ]).
:- use_module('../kernel', [shading_place/5]).
:- use_module(seen, [seen_layers/4]).
:- use_module(shaded_picture, [world_scene/2]).
:- use_module(shading_scene,
              [named_face/3, scene_handle/2, scene_leaf/2, scene_size/2]).
:- use_module(surface_look, [layer_shares/3, line_layers/3, scene_opacities/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [member/2, numlist/3]).
/** <module> What is at a dot of a shaded picture.
*/

%!  pick(?Pixel, +Options, ?Picked) is nondet.
%
%   True when Picked is seen in the middle of the dot Pixel = pixel(X, Y), X of
%   row Y, counted from 0 from the upper left, of the picture of the current
%   world: picked(R, S, Face, Share, Point), this Face, as in face_of/3, of
%   segment S (0: of none), a leaf of the root R, at Point = point(PX, PY, PZ)
%   of the model. Share, to 1.0, is how much of the light there is its own;
%   behind what is see-through comes more, the nearest first. Options are those
%   of shaded_picture/4, such as size(640-400). Where Pixel is not known it is
%   each dot at which something is seen, row by row.
%
%   @error as of shaded_model/2 and shaded_eye/3

pick(Pixel, Options, Picked) :-
    must_be(list, Options),
    Pixel = pixel(X,Y),
    must_be_dot(X),
    must_be_dot(Y),
    world_scene(Options, Scene),
    scene_size(Scene, Width-Height),
    LastX is Width-1,
    LastY is Height-1,
    scene_opacities(Scene, Opaque),
    between(0, LastY, Y),
    row_dot(Scene, Y, LastX, X),
    dot_picked(Scene, Opaque, X, Y, Picked).

must_be_dot(X) :-
    (   var(X)
    ->  true
    ;   must_be(integer, X)
    ).

%   row_dot(Scene, Y, Last, X) is nondet: in the middle of dot X, up to Last, of
%   row Y something may be seen.

row_dot(_, _, Last, X) :-
    integer(X),
    !,
    X >= 0,
    X =< Last.
row_dot(Scene, Y, Last, X) :-
    Middle is Y+0.5,
    line_layers(Scene, Middle, Layers),
    findall(Dot,
            ( member(layer(X1,X2,_,_,_,_), Layers),
              From is max(0, (X1-128)//256),    % ends are rounded
              To is min(Last, (X2+128)//256),
              From =< To,
              numlist(From, To, Dots),
              member(Dot, Dots) ),
            All),
    sort(All, Each),
    member(X, Each).

dot_picked(Scene, Opaque, X, Y, picked(R,S,Face,Share,Point)) :-
    XM is X+0.5,
    YM is Y+0.5,
    seen_layers(Scene, XM, YM, Layers),
    layer_shares(Layers, Opaque, Shares),
    scene_handle(Scene, Handle),
    member(share(Z,R,Leaf,F,_,Share), Shares),
    once(scene_leaf(Scene, leaf(Leaf,_,S,_,Faces))),
    named_face(F, Faces, Face),
    shading_place(Handle, XM, YM, Z, Point).
