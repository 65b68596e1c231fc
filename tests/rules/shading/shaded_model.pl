/* Pictures of models for the tests of shading: dots, and an oracle that shares
   nothing with what is tested: the evaluated boundary, projected and drawn
   triangle by triangle into a buffer of depths. */
:- module(shaded_model,
          [ in_model/2,                 % +Facts, :Goal
            shaded_dots/2,              % +Options, -Dots
            shaded_scene_of/2,          % +Options, -Scene
            shaded_bytes/2,             % +Options, -Bytes
            image_dots/2,               % +Image, -Bytes
            buffer_dots/5               % +Triangles, +W, +H, -Depths, -Dots
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(csg/csg)).
:- use_module(rules(kernel)).
:- use_module(rules(model/model)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(solid/csg_evaluate), []).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).
:- meta_predicate in_model(+, 0).

%   in_model(Text, Goal): in a new world that has read Text, nothing evaluated.

in_model(Text, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        in_new_world(( load_model(File, [evaluate(false),rows(false)]), Goal )),
        delete_file(File)).

shaded_scene_of(Options, Scene) :-
    findall(S, root_segment(S), Roots),
    shaded_model(Roots, Model),
    current_view(Theta, Phi, Rho, Kind),
    shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye),
    shaded_picture(Model, Eye, Options, Scene).

%   shaded_dots(Options, Dots): a compound of rgb(R,G,B), by rows; the
%   background if nothing is seen.

shaded_dots(Options, Dots) :-
    shaded_bytes(Options, Bytes),
    string_codes(Bytes, Codes),
    dots_of(Codes, List),
    Dots =.. [dots|List].

shaded_bytes(Options, Bytes) :-
    (   shaded_scene_of(Options, Scene)
    ->  picture_image(Scene, Options, Image),
        image_dots(Image, Bytes)
    ;   Bytes = nothing
    ).

%   image_dots(Image, Bytes): red, green, blue of each dot.

image_dots(Image, Bytes) :-
    setup_call_cleanup(
        tmp_file_stream(binary, File, Out),
        ( image_ppm(Image, Out),
          close(Out),
          read_file_to_codes(File, Codes0, [type(binary)]) ),
        delete_file(File)),
    phrase(( line, line, line ), Codes0, Codes),
    string_codes(Bytes, Codes).

line --> "\n", !.
line --> [_], line.

dots_of([], []).
dots_of([R,G,B|Codes], [rgb(R,G,B)|Dots]) :-
    dots_of(Codes, Dots).


                /*******************************
                *            ORACLE            *
                *******************************/

%   buffer_dots(Place, W, H, Triangles, Dots): Dots is a compound with, for
%   each dot, the nearest of Triangles that its middle lies in, `none` or its
%   Id. Triangles are tri(Id, A, B, C) of p(X, Y, Z), in dots, Y down.

buffer_dots(Triangles, W, H, Depths, Dots) :-
    N is W*H,
    functor(Depths, depths, N),
    functor(Dots, dots, N),
    forall(between(1, N, I),
           ( nb_setarg(I, Depths, inf), nb_setarg(I, Dots, none) )),
    forall(member(Triangle, Triangles),
           triangle_drawn(Triangle, W, H, Depths, Dots)).

triangle_drawn(tri(Id,p(X1,Y1,Z1),p(X2,Y2,Z2),p(X3,Y3,Z3)), W, H, Depths,
               Dots) :-
    Area is (X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1),
    (   abs(Area) < 1.0e-9
    ->  true
    ;   Low is max(0, floor(min(Y1, min(Y2, Y3))-0.5)),
        High is min(H-1, ceiling(max(Y1, max(Y2, Y3)))),
        Left is max(0, floor(min(X1, min(X2, X3))-0.5)),
        Right is min(W-1, ceiling(max(X1, max(X2, X3)))),
        forall(( between(Low, High, Row), between(Left, Right, Column) ),
               ( X is Column+0.5, Y is Row+0.5,
                 A is ((X2-X)*(Y3-Y) - (X3-X)*(Y2-Y))/Area,
                 B is ((X3-X)*(Y1-Y) - (X1-X)*(Y3-Y))/Area,
                 C is 1-A-B,
                 (   A >= 0, B >= 0, C >= 0
                 ->  Z is A*Z1 + B*Z2 + C*Z3,
                     I is Row*W + Column + 1,
                     arg(I, Depths, Z0),
                     (   Z < Z0
                     ->  nb_setarg(I, Depths, Z),
                         nb_setarg(I, Dots, Id)
                     ;   true
                     )
                 ;   true
                 ) ))
    ).
