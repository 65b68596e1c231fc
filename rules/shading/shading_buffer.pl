:- module(sg_shading_buffer,
          [ write_buffer/3              % +Kind, +Scene, +Out
          ]).
:- use_module('../kernel',
              [ image_written/6, shading_depth_pfm/3, shading_normal_pfm/2,
                shading_scan/5, srgb_light/2 ]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module(group_owner, [owners_asked/2]).
:- use_module(shaded_picture, [looks_for_kernel/3, picture_how/3]).
:- use_module(shading_scene,
              [scene_depth/2, scene_handle/2, scene_leaf/2, scene_size/2]).
:- use_module(surface_look, [line_layers/3, scene_looks/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> What a shaded picture knows of its dots, for other programs.

Of PFM files the rows run from below, numbers are 32-bit floats, the lowest byte
first.
*/

%!  write_buffer(+Kind, +Scene, +Out) is det.
%
%   Write to the stream Out what is seen of Scene. Kind is
%
%     - depth: PFM, in the middle of each dot: units of the model the way the
%       eye looks, from it, in a parallel picture from the origin; infinite
%       where nothing is
%     - normal: PFM, a unit vector of the model, 0 0 0 where nothing is
%     - tone: PGM, in the middle of each dot how light it is, 255 the lightest;
%       0 where nothing is
%     - id: CSV, a row for each span of the lines in the middle of each row of
%       dots: y, x1, x2 in dots, root, number and segment of the leaf (0: of no
%       segment), face, and the part of the light there that is its own

write_buffer(depth, Scene, Out) :-
    scene_handle(Scene, Handle),
    scene_depth(Scene, Plane),
    dots_asked(Scene),
    shading_depth_pfm(Handle, Plane, Out).
write_buffer(normal, Scene, Out) :-
    scene_handle(Scene, Handle),
    dots_asked(Scene),
    shading_normal_pfm(Handle, Out).
write_buffer(tone, Scene, Out) :-
    scene_looks(Scene, root, Looks0, Leaves),
    looks_for_kernel(Looks0, [shade(lambert)], Looks1),
    grey_ramp(Grey),
    maplist(tone_alone(Grey), Looks1, Looks),
    scene_handle(Scene, Handle),
    picture_how(Scene, [smooth(0),background(black)], How),
    dots_asked(Scene),
    image_written(Handle, How, Looks, Leaves, file(pgm,0,[],0), Out).
write_buffer(id, Scene, Out) :-
    format(Out, 'y,x1,x2,root,leaf,segment,face,part~n', []),
    findall(leaf(Number,S), scene_leaf(Scene, leaf(Number,_,S,_,_)), Leaves0),
    compound_name_arguments(Leaves, leaves, Leaves0),
    scene_size(Scene, _-Height),
    Last is Height-1,
    forall(between(0, Last, Row),
           ( Y is Row+0.5,
             line_layers(Scene, Y, Layers),
             forall(member(Layer, Layers), write_layer(Out, Y, Leaves, Layer))
           )).

%   dots_asked(Scene): of what is seen in the middle of each dot all is
%   answered, so nothing is written twice.

dots_asked(Scene) :-
    (   decision_is_default(owner/3)
    ->  true
    ;   scene_handle(Scene, Handle),
        findall([0], scene_leaf(Scene, _), Leaves),
        owners_asked(Scene, shading_scan(Handle, 1, [1], Leaves, _))
    ).

%   tone_alone(Grey, Look0, Look): without shine, opaque.

tone_alone(Grey, look(Tones,_,_,_,_),
           look(Tones,Grey,1,shine(1,[]),stripes(0,1))).

grey_ramp(Ramp) :-
    findall(light(L,L,L),
            ( between(0, 1024, K), Byte is round(K*255/1024),
              srgb_light(Byte, L) ),
            Ramp).

%   1/256 dot has eight digits.

write_layer(Out, Y, Leaves, layer(X1,X2,R,Leaf,F,Part)) :-
    arg(Leaf, Leaves, leaf(_,S)),
    From is X1/256.0,
    To is X2/256.0,
    format(Out, '~1f,~w,~w,~d,~d,~d,~d,~w~n', [Y,From,To,R,Leaf,S,F,Part]).
