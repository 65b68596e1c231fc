/* Shaded pictures: against the evaluated boundary, drawn by a buffer of depths;
   the same solid said in other ways; looks, tones and ramps by rules. */
% covers: surface_look, surface_tone, surface_ramp, image, image_rows
% covers: shading_section, pixel_colour, face_owner, group_owner
:- module(test_shaded_picture, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(colour)).
:- use_module(rules(csg/csg)).
:- use_module(rules(decision)).
:- use_module(rules(kernel)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(shading/shading_section)).
:- use_module(rules(shading/surface_look)).
:- use_module(rules(shading/surface_ramp)).
:- use_module(rules(shading/surface_tone)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(shaded_model).
:- use_module(tests('rules/sample')).

bytes(Text, Options, Bytes) :-
    in_model(Text, shaded_bytes(Options, Bytes)).

%   The frame of all that are compared: 8 units, 96 dots.
frame([size(96-96), window(b(-4.0,-4.0,4.0,4.0)), smooth(2)]).

same(Term1, Term2) :-
    frame(Frame),
    text(Term1, Text1),
    text(Term2, Text2),
    bytes(Text1, Frame, Bytes1),
    bytes(Text2, Frame, Bytes2),
    Bytes1 == Bytes2.

text(Term, Text) :-
    format(string(Text),
           "segment(1, solid, ~q).\nlook(1, colour(red)).\nview(300, 60, 0).\n",
           [Term]).

a(box(size(3,3,3))).
b(at([translate(1,1,1)], sphere(radius(1.5), facets(48), bands(24)))).
c(at([rotate(y,90),translate(-3,0,1)],
     cylinder(radius(0.8), height(6), facets(48)))).

:- begin_tests(shaded_picture).

% ---- one solid, said in two ways -------------------------------------------

test(commuted, nondet) :-
    a(A), b(B), c(C),
    same(union([A,B,C]), union([C,A,B])),
    same(intersection([A,B,C]), intersection([B,C,A])).
test(twice, nondet) :-
    a(A), b(B), c(C),
    same(union([A,A]), union([A])),
    same(difference([union([A,B]),C]), difference([union([A,B,B,A]),C,C])).
test(away_from_both, nondet) :-
    a(A), b(B), c(C),
    same(difference([difference([A,B]),C]), difference([A,union([B,C])])),
    same(difference([A,union([B,C])]),
         intersection([difference([A,B]),difference([A,C])])).
test(halves_united, nondet) :-
    a(A), b(B),
    same(union([split(A, plane(1,0,0,-0.3), below),
                split(A, plane(1,0,0,-0.3), above), B]),
         union([A,B])).
test(from_itself, [nondet, true(Bytes == nothing)]) :-
    a(A), b(B),
    text(difference([union([A,B]),A,B]), Text),
    bytes(Text, [size(96-96)], Bytes).

% ---- against the boundary --------------------------------------------------

%   Of convex and other solids whose faces are flat: their leaf at each dot's
%   middle, not at edges, is the leaf of the triangle that is nearest there.
case(l, union([box(size(3,3,1)),at([translate(-1,0,1)], box(size(1,3,2)))])).
case(flush, union([difference([box(size(4,4,2)),box(size(2,2,2))]),
                   at([translate(0,0,2)], box(size(4,4,1)))])).
case(notch, difference([box(size(4,3,2)),
                        at([rotate(z,30),translate(1.1,-1,1)],
                           box(size(2,2,3)))])).
case(pyramid, intersection([at([rotate(x,20)],
                               pyramid(base(4,3), height(4))),
                           box(size(3,3,3))])).
case(mirrored, at([scale(-1,1,1.5),rotate(y,25)],
                  difference([box(size(3,2,2)),
                              at([translate(1,0.4,0.7)],
                                 box(size(1.5,1,2)))]))).
case(round, difference([sphere(radius(2), facets(96), bands(48)),
                        at([translate(1,0,-3)],
                           cylinder(radius(0.7), height(6), facets(96)))])).

look_at(parallel, "view(300, 60, 0).").
look_at(below, "view(20, 130, 0).").
look_at(central, "view(300, 60, 14). projection(central).").

test(buffer, [ forall(sampled([Name,How],
                              ( case(Name, Term), look_at(How, View) ))),
               true(Wrong =< Allowed) ]) :-
    format(string(Text), "segment(1, solid, ~q).\n~s\n", [Term,View]),
    in_model(Text, compared(Wrong, Seen)),
    (   Name == round                   % the boundary has facets
    ->  Allowed is Seen//50
    ;   Allowed is Seen//1000
    ),
    Seen > 400,
    assertion(memberchk(How, [parallel,below,central])).

%   compared(Wrong, Seen): dots of 100 x 100 whose middle is seen otherwise
%   than in the buffer: something or nothing, or deeper by more than a part of
%   a dot that the slope does not explain.
compared(Wrong, Seen) :-
    Size = 100-100,
    shaded_scene_of([size(Size)], Scene),
    evaluate,
    triangles(Scene, Triangles),
    buffer_dots(Triangles, 100, 100, _, Dots),
    aggregate_all(count, arg(_, Dots, t(_,_,_)), Seen),
    scene_handle(Scene, Handle),
    aggregate_all(count,
                  ( between(0, 99, Row), between(0, 99, Column),
                    I is Row*100 + Column + 1,
                    arg(I, Dots, Seen0),
                    inner(Dots, I, Seen0),
                    X is Column+0.5, Y is Row+0.5,
                    \+ agrees(Handle, X, Y, Seen0) ),
                  Wrong).

%   A dot all of whose neighbours show the same plane, or nothing.
inner(Dots, I, Seen) :-
    forall(member(D, [-101,-100,-99,-1,1,99,100,101]),
           ( J is I+D,
             (   J >= 1,
                 J =< 10000
             ->  arg(J, Dots, Other),
                 alike(Seen, Other)
             ;   true
             ) )).

alike(none, none).
alike(t(X,Y,Z), t(A,B,C)) :-
    X*A + Y*B + Z*C > 0.9.

agrees(Handle, X, Y, none) :-
    \+ shading_point(Handle, X, Y, _, _, _).
agrees(Handle, X, Y, t(A,B,C)) :-
    shading_point(Handle, X, Y, _, _, vector(NX,NY,NZ)),
    A*NX + B*NY + C*NZ > 0.995.

%   The triangles of root 1 in the picture, each with its normal.
triangles(Scene, Triangles) :-
    Scene = scene(_, _, _),
    shaded_place(Place, Eye),
    findall(tri(t(NX,NY,NZ),A,B,C),
            ( t(1, P, _, V1, V2, V3),
              plane(1, P, NX, NY, NZ, _),
              seen(Place, Eye, V1, A),
              seen(Place, Eye, V2, B),
              seen(Place, Eye, V3, C) ),
            Triangles).

%   Where shaded_picture/4 puts it, from the boundary alone.
shaded_place(place(Scale,Left,Top), frame) :-
    project_world,
    aggregate_all(r(min(X),max(X),min(Y),max(Y)),
                  ( t(1, _, _, V1, V2, V3), member(V, [V1,V2,V3]),
                    screen(1, V, X, Y, _) ),
                  r(X1,X2,Y1,Y2)),
    Scale is min(80/(X2-X1), 80/(Y2-Y1)),
    Left is (X1+X2)/2 - 50/Scale,
    Top is (Y1+Y2)/2 + 50/Scale.

seen(place(Scale,Left,Top), _, V, p(X,Y,Z)) :-
    screen(1, V, X0, Y0, Z),
    X is (X0-Left)*Scale,
    Y is (Top-Y0)*Scale.

% ---- looks -----------------------------------------------------------------

%   The colours that are seen of a box with a hole.
hole("segment(9, solid, difference([2,3])). segment(2, solid, box(size(4,4,2))).
      segment(3, solid, at([translate(0,0,-1)],
                           cylinder(radius(1), height(4), facets(48)))).
      view(300, 40, 0).\n").

flat_colours(Looks, Options, Colours) :-
    hole(Hole),
    string_concat(Hole, Looks, Text),
    in_model(Text, shaded_dots([shade(flat),smooth(1),size(60-40)|Options],
                               Dots)),
    Dots =.. [_|List],
    common(List, Colours).

%   Colours are those that 60 dots have or more: not those of edges.
common(List, Colours) :-
    msort(List, Sorted),
    clumped_of(Sorted, Clumps),
    findall(C, ( member(C-N, Clumps), N >= 60 ), Colours).

clumped_of(Sorted, Clumps) :-
    findall(C-x, member(C, Sorted), Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(C-N, ( member(C-Xs, Groups), length(Xs, N) ), Clumps).

white(rgb(255,255,255)).
red(rgb(170,0,0)).
blue(rgb(0,60,170)).

% A piece of a torus, behind which on some lines another piece of it would be if
% it were there: no line is in its face.
test(no_line_in_a_face, Black == []) :-
    in_model("segment(1, solid, intersection([torus(radius(3),tube(1)),
                  at([translate(-0.6,-9,-9)], box(size(1.2,18,18)))])).
              view(270, 80, 0).",
             shaded_dots([size(60-100),window(b(-0.3,-1,0.3,0)),edges(true),
                          smooth(1)], Dots)),
    findall(Column-Row,
            ( member(Column, [10,30,50]),
              between(1, 98, Row),
              I is Row*60+Column+1,
              arg(I, Dots, rgb(R,G,B)),
              R+G+B < 60 ),
            Black).
test(palette, Colours == [rgb(118,160,208),White]) :-
    white(White),
    flat_colours("", [], Colours).
test(palette_by_leaf, Colours == [rgb(118,160,208),rgb(222,158,78),White]) :-
    white(White),
    flat_colours("", [colours(leaf)], Colours).
test(root, Colours == [Red,White]) :-
    white(White), red(Red),
    flat_colours("look(9, colour(red)).", [], Colours).
test(leaves, Colours == [Blue,Red,White]) :-
    white(White), red(Red), blue(Blue),
    flat_colours("look(2, colour(red)). look(3, colour(blue)).", [], Colours).
test(hole_is_of_the_body, Colours == [Red,White]) :-
    white(White), red(Red),
    flat_colours("look(2, colour(red)).", [], Colours).
test(hole_is_of_the_body_before_the_root, Colours == [Red,White]) :-
    white(White), red(Red),
    flat_colours("look(2, colour(red)). look(9, colour(blue)).", [], Colours).
test(tool_alone, Colours == [Blue,rgb(118,160,208),White]) :-
    white(White), blue(Blue),
    flat_colours("look(3, colour(blue)).", [], Colours).
test(faces, Colours == [Blue,rgb(118,160,208),White]) :-
    white(White), blue(Blue),
    flat_colours("look(2, face(top, colour(blue))). look(9, shine(0.1,3)).",
                 [], Colours).
test(face_before_its_leaf, Colours == [Blue,Red,White]) :-
    white(White), red(Red), blue(Blue),
    flat_colours("look(2, colour(red)). look(2, face(top, colour(blue))).",
                 [], Colours).
test(face_of_none, error(model_error(look(no_face(2,lid,[base,top|_]))))) :-
    flat_colours("look(2, face(lid, colour(blue))).", [], _).
% ---- see-through, sections -------------------------------------------------

%   Red glass before white: both sides of it, each of half of what comes.
test(see_through, true(Apart =< 0.006)) :-
    in_model("segment(1, solid, box(size(4,4,4))). view(270, 0, 0).
              look(1, colour(red)). look(1, opacity(0.5)).",
             shaded_dots([shade(flat),smooth(1),size(40-40)], Dots)),
    arg(820, Dots, RGB),
    red(rgb(R0,G0,B0)),
    maplist([C,L]>>(srgb_light(C, L0), L is 0.75*L0 + 0.25*65535),
            [R0,G0,B0], [R,G,B]),
    light_apart(RGB, R, G, B, Apart).
test(clear, Colours == [White]) :-
    white(White),
    flat_colours("look(9, opacity(0)).", [], Colours).
test(nearest_of_each_property, true(Look == [colour(red),opacity(0.5)])) :-
    hole(Hole),
    string_concat(Hole, "look(9, opacity(0.2)). look(9, colour(blue)).
                         look(2, colour(red)). look(3, opacity(0.5)).", Text),
    in_model(Text, once(surface_look(9, 3, any, Look0))),
    msort(Look0, Look).
test(opaque_in_glass, Colours == [Blue,White]) :-
    white(White), blue(Blue),
    in_model("segment(1, solid, box(size(4,4,2))). view(300, 40, 0).
              segment(2, solid, box(size(3,2,1))).
              look(1, opacity(0)). look(2, colour(blue)).",
             shaded_bytes([shade(flat),smooth(1),size(60-60)], Bytes)),
    colours(Bytes, Colours).

test(layers_by_looks, Parts == [0.25,0.1875]) :-
    in_model("segment(1, solid, box(size(4,4,4))). view(270, 0, 0).
              look(1, opacity(0.25)).",
             ( shading_scene(40-40, Scene), line_layers(Scene, 20.3, Layers) )),
    findall(Part, member(layer(_,_,1,1,_,Part), Layers), Parts).

%   A section is what the part below its plane is, but for its stripes.
test(section, [forall(member(Plane, [plane(1,0,0,-0.3),plane(1,2,3,0.5)])),
               true(Sectioned == Split)]) :-
    hole(Hole),
    in_model(Hole, sections_spans([Plane], 9, Sectioned)),
    format(string(Text), "segment(10, solid, split(9, ~q, below)).~n~w",
           [Plane,Hole]),
    in_model(Text, sections_spans([], 10, Split)).
test(section_kept_whole, true(Whole == Kept)) :-
    hole(Hole),
    in_model(Hole, sections_spans([], 9, Whole)),
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, "may_section(S, _) :- S > 9.\n"),
          close(Out) ),
        in_model(Hole,
                 ( use_rules(File),
                   shaded_model([9], Model),
                   (   sectioned_model([plane(1,0,0,0)], Model, _)
                   ->  Kept = cut
                   ;   sections_spans([], 9, Kept)
                   ) )),
        delete_file(File)).
test(section_past, fail) :-
    hole(Hole),
    in_model(Hole, ( shaded_model([9], Model),
                     sectioned_model([plane(1,0,0,-9)], Model, _) )).
%   A quarter of a cut has a quarter of its light.
test(stripes, true(abs(Light/(240*240) - 0.8125) < 0.002)) :-
    in_model("segment(1, solid, box(size(4,4,4))). view(270, 90, 0).
              look(1, colour(white)).",
             ( shaded_model([1], Model0),
               sectioned_model([plane(0,-1,0,0)], Model0, Model),
               shaded_eye(Model, view(270,90,0,parallel), Eye),
               Options = [size(300-300),shade(flat),background(black)],
               shaded_picture(Model, Eye, Options, Scene),
               picture_image(Scene, Options, Image),
               image_lights(Image, Lights) )),
    sum_list(Lights, Sum),
    Light is Sum/65535.

image_lights(Image, Lights) :-
    setup_call_cleanup(
        tmp_file_stream(binary, File, Out),
        ( image_ppm(Image, Out), close(Out),
          read_file_to_codes(File, Codes, [type(binary)]) ),
        delete_file(File)),
    length(Codes, N),
    Head is N - 300*300*3,
    length(Before, Head),
    append(Before, Bytes, Codes),
    lights_of(Bytes, Lights).

lights_of([], []).
lights_of([R,_,_|Bytes], [Light|Lights]) :-
    srgb_light(R, Light),
    lights_of(Bytes, Lights).

%   sections_spans(Planes, S, Spans): where anything is seen, and how deep.
sections_spans(Planes, S, Spans) :-
    shaded_model([S], Model0),
    sectioned_model(Planes, Model0, Model),
    shaded_eye(Model, view(300,60,0,parallel), Eye),
    shaded_scene(Model, Eye, place(12.5,-4.0,4.0), 100-100, Scene),
    findall(Y-X1-X2-Depth,
            ( between(0, 99, Row), Y is Row+0.375,
              line_spans(Scene, Y, Line),
              member(span(X1,X2,_,_,_), Line),
              X is (X1+X2)/512,
              seen_side(Scene, X, Y, Depth0, _),
              Depth is round(Depth0*1.0e5) ),
            Spans).

% ---- tones and ramps -------------------------------------------------------

%   What the kernel shows of a flat face is what the rules say of its normal.
test(rules_of_faces,
     [forall(member(Shade, [lambert,gooch,cel(5),zebra(8)]))]) :-
    in_model("segment(1, solid, box(size(2,3,4))). look(1, colour(orange)).
              light(0, strength(0.23)). light(2, direction(1,2,-3)).
              light(3, picture(1,0,0.5)). light(3, strength(0.3)).",
             ( Size = [size(50-60), smooth(1), shade(Shade)],
               shaded_scene_of(Size, Scene),
               shaded_dots(Size, Dots),
               scene_handle(Scene, Handle),
               current_view(Theta, Phi, _, _),
               findall(Apart,
                       ( between(0, 59, Row), between(0, 49, Column),
                         X is Column+0.5, Y is Row+0.5,
                         shading_point(Handle, X, Y, Span, _, Normal),
                         Span = span(X1,X2,_,_,_),
                         X1 =< Column*256,
                         X2 >= Column*256 + 256,
                         eye_normal(Theta, Phi, Normal, Seen),
                         Look = [shade(Shade),colour(orange)],
                         once(tone(Look, Seen, Tone)),
                         once(ramp(Look, Tone, light(R,G,B))),
                         I is Row*50 + Column + 1,
                         arg(I, Dots, RGB),
                         light_apart(RGB, R, G, B, Apart) ),
                       Aparts),
               max_list(Aparts, Most) )),
    length(Aparts, N),
    assertion(N > 400),
    assertion(Most =< 0.012).

%   How far a byte's light is from a light, 0 to 1: half a byte is 0.0045 at
%   most.
light_apart(rgb(R0,G0,B0), R, G, B, Apart) :-
    maplist(srgb_light, [R0,G0,B0], [R1,G1,B1]),
    Apart is max(abs(R-R1), max(abs(G-G1), abs(B-B1)))/65535.

eye_normal(Theta, Phi, vector(X,Y,Z), vector(A,B,C)) :-
    view_matrix(Theta, Phi, Rows),
    maplist(along(X, Y, Z), Rows, [A,B,C0]),
    C is -C0.

along(X, Y, Z, r(A,B,C), Sum) :-
    Sum is float(A*X + B*Y + C*Z).

%   A rule that says what the default says goes by a table: nearly the same
%   bytes.
test(table_of_tones, true(Most =< 3)) :-
    with_rules("tone(L, N, T) :- default(tone(L, N, T)).", By),
    plain(Plain),
    apart(By, Plain, Most).
test(ramp_by_rule, Colours == [rgb(0,110,40),White]) :-
    white(White),
    with_rules("ramp(_, _, green).", By),
    colours(By, Colours).
test(ramp_without_answer, Colours == [rgb(0,0,0),White]) :-
    white(White),
    with_rules("ramp(_, _, nonsense).", By),
    colours(By, Colours).
test(look_by_rule, Colours == [rgb(0,60,170),rgb(170,0,0),White]) :-
    white(White),
    with_rules("surface_look(_, _, top, [colour(red)]).\n\c
                surface_look(_, _, side(_), [colour(blue)]).",
               [shade(flat)], By),
    colours(By, Colours).

% Of faces that lie in one another a rule says which is seen; each group is
% asked once, in one order, however many threads meet it.
test(owner_by_rule, Colours-Asked == [rgb(0,60,170),rgb(170,0,0),White]-
                                     [9-[1-top,2-top],9-[1-top,2-top,3-top],
                                      9-[1-top,3-top]]) :-
    white(White),
    inlaid("owner(R, Group, _) :- recordz(test_owner, R-Group), fail.\n\c
            owner(_, Group, 2-top) :- memberchk(2-top, Group).", [], By, Asked),
    string_codes(By, Codes),
    triples(Codes, Dots),
    sort(Dots, Colours).
test(owner_without_answer, By == Plain) :-
    inlaid("owner(_, _, 7-top). owner(_, _, nonsense).", [], By, _),
    inlaid("spare_rule :- fail. owner(_, _, _) :- spare_rule.", [], Plain, _).
test(default_owner, By == Plain) :-
    inlaid("owner(R, Group, Owner) :- default(owner(R, Group, Owner)).",
           [smooth(4)], By, _),
    inlaid("tone(L, N, T) :- default(tone(L, N, T)).", [smooth(4)], Plain, _).
test(owner_of_pixels, By == Plain) :-
    Rule = "owner(_, Group, Owner) :- lists:last(Group, Owner).\n",
    inlaid(Rule, [smooth(1)], Plain, _),
    string_concat(Rule, "pixel_colour(_, _, [part(_,2,_,_,_)|_], blue).\n\c
                         pixel_colour(_, _, [part(_,1,_,_,_)|_], red).\n\c
                         pixel_colour(_, _, [part(_,3,_,_,_)|_], orange).\n",
                  Rules),
    inlaid(Rules, [smooth(1)], By, _).

inlaid(Rules, Options, Bytes, Asked) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Rules),
          close(Out) ),
        in_model("segment(1, solid, box(size(8,8,3))).
                  segment(2, solid, at([translate(-1,0,0)], box(size(4,4,3)))).
                  segment(3, solid, at([translate(1,0,0)], box(size(4,4,3)))).
                  segment(9, solid, union([1,2,3])).
                  look(1, colour(red)). look(2, colour(blue)).
                  look(3, colour(orange)). view(270, 0, 0).",
                 ( use_rules(File),
                   shaded_bytes([size(60-60),smooth(1),shade(flat),
                                 window(b(-5.0,-5.0,5.0,5.0))|Options],
                                Bytes),
                   findall(Group, recorded(test_owner, Group), Asked),
                   forall(recorded(test_owner, _, Ref), erase(Ref)) )),
        delete_file(File)).

test(pixel_colour_by_rule, Colours == [rgb(0,60,170),rgb(250,210,0)]) :-
    with_rules("pixel_colour(_, _, [part(0,0,background,_,_)], yellow).\n\c
                pixel_colour(_, _, [part(1,1,_,_,_)|_], rgb(0,60,170)).", By),
    string_codes(By, Codes),
    triples(Codes, Dots),
    sort(Dots, Colours).
test(pixel_colour_without_answer, By == Plain) :-
    with_rules("spare_rule :- fail. pixel_colour(_, _, _, nonsense) :- \c
                spare_rule.", By),
    with_rules("spare_rule :- fail. pixel_colour(_, _, _, _) :- spare_rule.",
               Plain).
test(default_pixel_colour, true(Most =< 1)) :-
    Text = "segment(1, solid, cylinder(radius(2), height(4), facets(48))).
            look(1, opacity(0.6)). look(1, colour(red)).
            light(0, strength(0.4)).
            segment(2, solid, at([translate(1,1,0)], box(size(1,1,3)))).",
    Options = [size(60-60),smooth(4),background(orange),shade(flat)],
    bytes(Text, Options, Plain),
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, "pixel_colour(X, Y, Parts, Colour) :- \c
                      default(pixel_colour(X, Y, Parts, Colour))."),
          close(Out) ),
        in_model(Text, ( use_rules(File), shaded_bytes(Options, By) )),
        delete_file(File)),
    apart(By, Plain, Most).
test(palette, First-Few == rgb(255,255,255)-true) :-
    bytes("segment(1, solid, sphere(radius(2),facets(48))).
           segment(2, solid, at([translate(3,0,0)], box(size(1,1,3)))).",
          [size(60-60),palette(12)], Bytes),
    string_codes(Bytes, Codes),
    triples(Codes, Dots),
    Dots = [First|_],
    sort(Dots, Colours),
    length(Colours, Count),
    (   Count > 6, Count =< 12
    ->  Few = true
    ;   Few = Count
    ).
test(palette_of_one_tone, Colours == [rgb(170,0,0),rgb(255,255,255)]) :-
    bytes("segment(1, solid, sphere(radius(2),facets(48))).
           look(1, colour(red)).",
          [size(60-60),palette(2),shade(flat)], Bytes),
    string_codes(Bytes, Codes),
    triples(Codes, Dots),
    sort(Dots, Colours).

plain(Bytes) :-
    with_rules("spare_rule :- fail. surface_look(R, S, F, L) :- spare_rule, \c
                default(surface_look(R, S, F, L)).", Bytes).

with_rules(Rules, Bytes) :-
    with_rules(Rules, [], Bytes).
with_rules(Rules, Options, Bytes) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Rules),
          close(Out) ),
        in_model("segment(1, solid, box(size(2,3,4))). view(300, 50, 0).",
                 ( use_rules(File),
                   shaded_bytes([size(60-60),smooth(1)|Options], Bytes) )),
        delete_file(File)).

apart(Bytes1, Bytes2, Most) :-
    string_codes(Bytes1, Codes1),
    string_codes(Bytes2, Codes2),
    maplist([A,B,D]>>(D is abs(A-B)), Codes1, Codes2, Apart),
    max_list(Apart, Most).

colours(Bytes, Colours) :-
    string_codes(Bytes, Codes),
    triples(Codes, Dots),
    common(Dots, Colours).

triples([], []).
triples([R,G,B|Codes], [rgb(R,G,B)|Dots]) :-
    triples(Codes, Dots).

% ---- shadows ---------------------------------------------------------------

%   A cube of 2 on a plate, lit along (1,0,-1), seen from above: its shadow is 2
%   long, 4 units of area. The light comes from light 1 alone.
shadow_dark(Options, Dark) :-
    in_model("segment(1, solid, union([
                  at([translate(0,0,-1)], box(size(12,12,1))),
                  box(size(2,2,2))])).
              look(1, colour(white)). view(270, 0, 0).
              light(0, strength(0)). light(1, strength(1)).
              light(1, direction(1,0,-1)).",
             shaded_dots([size(120-120),window(b(-6.0,-6.0,6.0,6.0))|Options],
                         Dots)),
    arg(1, Dots, rgb(R1,_,_)),          % the plate in the light
    srgb_light(R1, Lit),
    Dots =.. [_|List],
    aggregate_all(sum(Part),
                  ( member(rgb(R,_,_), List), srgb_light(R, Light),
                    Part is 1 - Light/Lit ),
                  Sum),
    Dark is Sum/100.

test(shadow, true(abs(Dark-4) < 0.05)) :-
    shadow_dark([shadows(true)], Dark).
test(no_shadow, true(abs(Dark) < 0.05)) :-
    shadow_dark([], Dark).
test(shadow_and_windows, true(Same == true)) :-
    Text = "segment(1, solid, difference([box(size(4,4,2)),
                 at([translate(0,0,1)], sphere(radius(1.5),facets(48)))])).
            view(300, 50, 0).",
    in_model(Text, shaded_dots([size(40-40),window(b(-3.0,-3.0,3.0,3.0)),
                                shadows(true)], Whole)),
    in_model(Text, shaded_dots([size(40-20),window(b(-3.0,0.0,3.0,3.0)),
                                shadows(true)], Upper)),
    Whole =.. [_|All],
    Upper =.. [_|Part],
    length(Part, N),
    length(First, N),
    append(First, _, All),
    (   maplist(near_dot, First, Part)
    ->  Same = true
    ;   Same = false
    ).

near_dot(rgb(A,_,_), rgb(B,_,_)) :-
    abs(A-B) =< 1.

:- end_tests(shaded_picture).
