:- module(sg_shaded_picture,
          [ shaded_picture/4,           % +Model, +Eye, +Options, -Scene
            world_scene/2,              % +Options, -Scene
            picture_place/5,            % +Model, +Eye, +Options, -Size, -Place
            empty_picture/3,            % +Eye, +Options, -Scene
            scene_shows/1,              % +Scene
            line_shows/2,               % +Scene, +Lines
            solid_box/2,                % +Model, -Box
            picture_image/3,            % +Scene, +Options, -Image
            picture_image/5,            % +Scene, +KernelLooks, +Leaves,
                                        % +Options, -Image
            picture_written/5,          % +Scene, +Options, +Format, +PerMetre,
                                        % +Out
            picture_is_large/1,         % +Size
            picture_how/3,              % +Scene, +Options, -How
            picture_decided/6,          % +Scene, +How, +Looks, +Leaves,
                                        % +Options, +Image
            shade_has_shadows/1,        % +Shade
            looks_for_kernel/3          % +Looks, +Options, -KernelLooks
          ]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../kernel',
              [ image_colours/2, image_extent/2, image_parts/6, image_shade/5,
                image_written/6, light_srgb/2, shading_size/3,
                shading_spans/3, srgb_light/2
              ]).
:- use_module('../picture/view', [current_view/4]).
:- use_module(group_owner, [owners_asked/3]).
:- use_module(pixel_colour, [pixels_decided/3]).
:- use_module(shading_eye, [eye_axes/3]).
:- use_module(shading_light, [light_scene/3]).
:- use_module(shading_scene,
              [ is_shaded/1, named_face/3, scene_handle/2, scene_leaf/2,
                shaded_box/3, shaded_eye/3, shaded_model/2, shaded_scene/5 ]).
:- use_module(surface_look, [look_opacity/2, scene_looks/4]).
:- use_module(surface_ramp, [look_ramp/2, ramp_step/3]).
:- use_module(surface_tone, [light_ways/1, look_shine/2, look_tones/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, memberchk/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> A shaded picture in dots.

Its frame is that of a drawing: what is seen fills it, with a tenth of the
shorter side free all round. Or a window of the picture fills it, in its own
units.
*/

%!  shaded_picture(+Model, +Eye, +Options, -Scene) is semidet.
%
%   Scene (shading_scene.pl) is Model in its frame. Fails if nothing is seen.
%   Options:
%
%     - size(Width-Height): dots, default 1260-888
%     - window(b(X1,Y1,X2,Y2)): what fills the frame, in units of the
%       picture, the longer way; without it all that is seen
%     - window(Box, Distance): the same; in a central picture Box is measured in
%       the plane that is so far from the eye, not in that of what is nearest

shaded_picture(Model, Eye, Options, Scene) :-
    picture_place(Model, Eye, Options, Size, Place),
    shaded_scene(Model, Eye, Place, Size, Scene).

%!  world_scene(+Options, -Scene) is semidet.
%
%   Scene is the picture of the roots of the current world in its view; Options
%   are those of shaded_picture/4. Fails if nothing is seen.
%
%   @error as of shaded_model/2 and shaded_eye/3

world_scene(Options, Scene) :-
    findall(S, ( root_segment(S), is_shaded(S) ), Roots),
    shaded_model(Roots, Model),
    current_view(Theta, Phi, Rho, Kind),
    shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye),
    shaded_picture(Model, Eye, Options, Scene).

%!  picture_place(+Model, +Eye, +Options, -Size, -Place) is semidet.
%
%   Size and Place are those of shaded_scene/5 for shaded_picture/4.

picture_place(Model, Eye, Options, Size, Place) :-
    option(size(Size), Options, 1260-888),
    (   option(window(Window), Options)
    ->  Margin = 0
    ;   memberchk(window(Box,Distance), Options)
    ->  window_nearest(Eye, Distance, Box, Window),
        Margin = 0
    ;   seen_box(Model, Eye, Window),
        Size = Width-Height,
        Margin is min(Width, Height)/10
    ),
    frame_place(Window, Size, Margin, Place).

%   window_nearest(Eye, Distance, Box, Window): Box in the plane of what is
%   nearest.

window_nearest(Eye, Distance, b(X1,Y1,X2,Y2), b(X3,Y3,X4,Y4)) :-
    eye_axes(Eye, eye(_,_,_,Kind,Nearest), _),
    (   Kind == central
    ->  Factor is Nearest/Distance
    ;   Factor = 1
    ),
    maplist(times(Factor), [X1,Y1,X2,Y2], [X3,Y3,X4,Y4]).

times(Factor, X0, X) :-
    X is X0*Factor.

%   seen_box(Model, Eye, Box): round what is seen. Where leaves are is mostly
%   more, so it is looked at once in dots.

seen_box(Model, Eye, b(X1,Y1,X2,Y2)) :-
    shaded_box(Model, Eye, Leaves),
    Size = 1024-1024,
    frame_place(Leaves, Size, 1, Place),
    shaded_scene(Model, Eye, Place, Size, Scene),
    scene_handle(Scene, Handle),
    image_extent(Handle, extent(Left,Top,Right,Bottom)),
    Place = place(Scale,X0,Y0),
    X1 is X0 + Left/Scale,
    X2 is X0 + Right/Scale,
    Y1 is Y0 - Bottom/Scale,
    Y2 is Y0 - Top/Scale.

%   frame_place(Box, Size, Margin, Place): Box in the middle.

frame_place(b(X1,Y1,X2,Y2), Width-Height, Margin, place(Scale,Left,Top)) :-
    Wide is max(X2-X1, 1.0e-300),
    High is max(Y2-Y1, 1.0e-300),
    Scale is min((Width-2*Margin)/Wide, (Height-2*Margin)/High),
    Left is (X1+X2)/2.0 - Width/Scale/2.0,
    Top is (Y1+Y2)/2.0 + Height/Scale/2.0.

%!  empty_picture(+Eye, +Options, -Scene) is det.
%
%   Scene, of the same size, has nothing in it.

empty_picture(Eye, Options, Scene) :-
    option(size(Size), Options, 1260-888),
    shaded_scene(model([],[],[]), Eye, place(1.0,0.0,0.0), Size, Scene).

%!  scene_shows(+Scene) is semidet.
%
%   True when something is seen in the frame of Scene, also between lines.

scene_shows(Scene) :-
    scene_handle(Scene, Handle),
    image_extent(Handle, _).

%!  line_shows(+Scene, +Lines) is semidet.
%
%   True when one of the lines, so many to a dot, shows something.

line_shows(Scene, Lines) :-
    scene_handle(Scene, Handle),
    shading_size(Handle, _, Height),
    All is Height*Lines,
    Last is All-1,
    (   member(Part, [1r2,1r4,3r4]),    % mostly there is something there
        I is floor(All*Part)
    ;   between(0, Last, I)
    ),
    Y is (I+0.5)/Lines,
    shading_spans(Handle, Y, [_|_]),
    !.

%!  solid_box(+Model, -Box) is semidet.
%
%   Box is box(X1,Y1,Z1,X2,Y2,Z2) round the solids of Model, as far as it is
%   seen from the front and from above. Fails if there are none.

solid_box(Model, box(X1,Y1,Z1,X2,Y2,Z2)) :-
    shaded_eye(Model, view(270.0,90.0,1.0,parallel), Front),
    seen_box(Model, Front, b(X1,Z1,X2,Z2)),
    shaded_eye(Model, view(270.0,0.0,1.0,parallel), Top),
    seen_box(Model, Top, b(_,Y1,_,Y2)).

%!  picture_image(+Scene, +Options, -Image) is det.
%
%   Image (kernel/image.pl) is Scene in dots. Options:
%
%     - smooth(N): lines of a dot: 1, 2, 4 (default), 8 or 16
%     - shade(Shade): lambert (default), or as in surface_tone.pl
%     - colours(By): the palette goes by `root` (default) or `leaf`
%     - background(Colour): default white; `none`: dots have an alpha
%     - palette(N): no more than N colours, 2 to 256; not without background
%     - edges(Bool): a black line is where other faces begin (default false)
%     - shadows(Bool): what is behind something, seen from a light, has none of
%       that light (default false); of the shades lambert and cel

picture_image(Scene, Options, Image) :-
    option(colours(Colours), Options, root),
    scene_looks(Scene, Colours, Looks, Leaves),
    looks_for_kernel(Looks, Options, KernelLooks),
    picture_image(Scene, KernelLooks, Leaves, Options, Image).

%!  picture_image(+Scene, +KernelLooks, +Leaves, +Options, -Image) is det.
%
%   The same with looks of looks_for_kernel/3, and of scene_looks/4 the Leaves.

picture_image(Scene, Looks, Leaves, Options, Image) :-
    picture_how(Scene, Options, How),
    How = how(_,_,_,Shadows),
    scene_handle(Scene, Handle),
    owners_asked(Scene, Shadows,
                 image_shade(Handle, How, Looks, Leaves, Image)),
    picture_decided(Scene, How, Looks, Leaves, Options, Image).

%!  picture_is_large(+Size) is semidet.
%
%   A picture of Size is not kept: it is written as it is made.

picture_is_large(Width-Height) :-
    (   max(Width, Height) > 16384
    ;   Width*Height > 1<<26
    ),
    !.

%!  picture_written(+Scene, +Options, +Format, +PerMetre, +Out) is det.
%
%   Writes to the stream Out what picture_image/3 makes of Scene, part after
%   part, so that it may be as large as image_written/6 says. Format is png or
%   ppm, PerMetre that of image_png/3. No rule is asked of dots.

picture_written(Scene, Options, Format, PerMetre, Out) :-
    option(colours(By), Options, root),
    scene_looks(Scene, By, Looks0, Leaves),
    looks_for_kernel(Looks0, Options, Looks),
    picture_how(Scene, Options, How),
    How = how(_,Background,_,Shadows),
    (   option(palette(Most), Options)
    ->  palette(Most, Looks, Background, Colours)
    ;   Colours = []
    ),
    scene_handle(Scene, Handle),
    Written = image_written(Handle, How, Looks, Leaves,
                            file(Format,PerMetre,Colours,0)),
    all_answered(Scene, Shadows, Written),
    call(Written, Out).

%   all_answered(Scene, Others, Written): what a rule is asked while a picture
%   is written is asked before, so nothing is written twice.

all_answered(Scene, Others, Written) :-
    (   decision_is_default(owner/3)
    ->  true
    ;   setup_call_cleanup(
            open_null_stream(Null),
            ( set_stream(Null, type(binary)),
              owners_asked(Scene, Others, call(Written, Null)) ),
            close(Null))
    ).

%!  picture_how(+Scene, +Options, -How) is det.
%
%   How is that of image_shade/5, by Options as of picture_image/3.

picture_how(Scene, Options, how(Lines,Background,Edges,Shadows)) :-
    option(smooth(Lines), Options, 4),
    option(background(Background0), Options, white),
    (   Background0 == none
    ->  Background = none
    ;   colour_rgb(Background0, Background)
    ),
    (   option(edges(true), Options)
    ->  Edges = 1
    ;   Edges = 0
    ),
    option(shade(Shade), Options, lambert),
    (   option(shadows(true), Options),
        shade_has_shadows(Shade),
        decision_is_default(tone/3)
    ->  light_ways(Ways),
        (   maplist(light_scene(Scene), Ways, Shadows0)
        ->  Shadows = Shadows0
        ;   Shadows = []                % there is nothing
        )
    ;   Shadows = []
    ).

%!  shade_has_shadows(+Shade) is semidet.

shade_has_shadows(lambert).
shade_has_shadows(cel(_)).

%!  picture_decided(+Scene, +How, +Looks, +Leaves, +Options, +Image) is det.
%
%   What rules and the option palette(N) change in Image.

picture_decided(Scene, How, Looks, Leaves, Options, Image) :-
    How = how(_,Background,_,_),
    (   decision_is_default(pixel_colour/4)
    ->  true
    ;   by_pixels(Scene, How, Looks, Leaves, Background, Image)
    ),
    (   option(palette(Most), Options)
    ->  palette(Most, Looks, Background, Colours),
        image_colours(Image, Colours)
    ;   true
    ).

%!  looks_for_kernel(+Looks, +Options, -KernelLooks) is det.
%
%   KernelLooks are Looks of scene_looks/4 as image_shade/5 has them, in the
%   current view; Options as for picture_image/3.

looks_for_kernel(Looks, Options, KernelLooks) :-
    option(shade(Shade), Options, lambert),
    option(size(Size), Options, 1260-888),
    stripes_step(Size, Step),
    maplist(kernel_look(Shade, Step), Looks, KernelLooks).

%   by_pixels(Scene, How, Looks, Leaves, Background, Image): each dot as the
%   rule pixel_colour/4 says. A clear one has no colour to decide of.

by_pixels(_, _, _, _, none, _) :-
    !,
    print_message(warning, sanggwan(pixel_colour_in_vain)).
by_pixels(Scene, How, Looks, Leaves, rgb(R0,G0,B0), Image) :-
    maplist(srgb_light, [R0,G0,B0], [R,G,B]),
    scene_handle(Scene, Handle),
    shading_size(Handle, Width, Height),
    Dots is Width*Height,
    print_message(informational, sanggwan(pixel_colour_asked(Dots))),
    findall(leaf(Number,S,Faces), scene_leaf(Scene, leaf(Number,_,S,_,Faces)),
            Numbered),
    compound_name_arguments(Named, leaves, Numbered),
    pixels_decided(sg_shaded_picture:row_parts(row(Handle,How,Looks,Leaves),
                                               Named),
                   light(R,G,B), Image).

row_parts(row(Handle,How,Looks,Leaves), Named, Y, Parts) :-
    image_parts(Handle, How, Looks, Leaves, Y, Parts0),
    maplist(named_part(Named), Parts0, Parts).

named_part(Named, part(X,R,Leaf,F,Share,Light),
           dot(X,part(R,S,Face,Share,Light))) :-
    arg(Leaf, Named, leaf(_,S,Faces)),
    named_face(F, Faces, Face).

%   palette(Most, Looks, Background, Colours): the background, and of each look
%   as many tones as there is room for.

palette(Most, Looks, Background, Colours) :-
    length(Looks, Count),
    Each is max(1, (Most-1)//max(1, Count)),
    findall(RGB,
            ( member(look(_,Ramp,_,_,_), Looks),
              ramp_colour(Ramp, Each, RGB) ),
            Tones),
    length(Tones, All),
    (   All < Most
    ->  Kept = Tones
    ;   Room is Most-1,
        length(Kept, Room),
        append(Kept, _, Tones)
    ),
    Colours = [Background|Kept].

ramp_colour(Ramp, Each, rgb(R,G,B)) :-
    between(1, Each, K),
    (   Each =:= 1
    ->  At = 768
    ;   At is round(1024*(K-1)/(Each-1))
    ),
    ramp_step(Ramp, At, light(R0,G0,B0)),
    maplist(light_srgb, [R0,G0,B0], [R,G,B]).

%   stripes_step(Size, Step): how far stripes of sections are apart, in 1/256
%   dot.

stripes_step(Width-Height, Step) :-
    Step is 256*max(5, min(Width, Height)//60).

kernel_look(Shade, Step, Look0, look(Tones,Ramp,Opacity,Shine,Stripes)) :-
    Look = [shade(Shade)|Look0],
    look_tones(Look, Tones),
    look_ramp(Look, Ramp),
    look_shine(Look, Shine),
    look_opacity(Look, Opacity),
    (   memberchk(hatched(Way), Look)
    ->  Stripes = stripes(Step,Way)
    ;   Stripes = stripes(0,1)
    ).
