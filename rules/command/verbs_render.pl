:- module(sg_verbs_render,
          [ render_run/2,               % +Files, +Options
            wanted_scene/4              % +Options, :Load, -Scene, -Wanted
          ]).
:- use_module('../colour', [colour_name/2, colour_rgb/2]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../csg/csg_term', [is_node_term/1, plain_name/2]).
:- use_module('../kernel', [image_png/3, image_ppm/2]).
:- use_module('../model/look_file', [look_file_added/2]).
:- use_module('../model/model', [load_model/2]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../output', [when_written/1, writing/3]).
:- use_module('../picture/view',
              [current_view/4, set_projection/1, set_view/3, view_matrix/3]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../shading/shaded_picture',
              [ shaded_picture/4, empty_picture/3, picture_image/3,
                line_shows/2, picture_is_large/1, picture_written/5,
                scene_shows/1, shade_has_shadows/1, solid_box/2 ]).
:- use_module('../shading/shading_buffer', [write_buffer/3]).
:- use_module('../shading/shading_facets', [faceted_model/2, facets_off/2]).
:- use_module('../shading/shading_leaf', [bent_faces/2]).
:- use_module('../shading/shading_scan',
              [scan/1, write_shading_facts/1, write_spans/1]).
:- use_module('../shading/shading_scene',
              [ is_shaded/1, scene_leaf/2, scene_model/2, scene_scale/2,
                shaded_eye/3, shaded_model/3 ]).
:- use_module('../shading/shading_section', [sectioned_model/3]).
:- use_module('../picture/section', [section_plane/4]).
:- use_module('../sheet/sheet_view', [view_towards/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ segment/3, light/2, look/2, view/3, assert_fact/1,
                retractall_facts/1
              ]).
:- use_module(shading_words, [shade_named/3, up_matrix/2]).
:- use_module(scan_line_file, [scan_line_files/2, scan_line_written/2]).
:- use_module(sheet_options, [looking/2]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, may_be_written/1, some_outputs/1,
                no_model_replaced/2, output_written/2, usage_error/1
              ]).
:- use_module(library(apply),
              [ foldl/4, include/3, maplist/2, maplist/3, maplist/4,
                partition/4 ]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(solution_sequences), [distinct/2]).
/** <module> The verb render: a shaded picture of solids.

No boundary is evaluated. What is seen follows from the trees of the roots,
whose leaves are as their terms say.
*/

%!  render_run(+Files, +Options) is det.
%
%   As verb_run/4.

render_run(Files, Options) :-
    some_files(Files, 'MODEL'),
    outputs(Options, [png,ppm,pl], Outputs),
    buffers(Options, Buffers),
    spans_file(Options, Spans),
    scan_line_files(Options, ScanLines),
    (   Buffers-Spans-ScanLines == []-[]-[]
    ->  some_outputs(Outputs)
    ;   true
    ),
    no_model_replaced(Files, Outputs),
    findall(Option, render_option(Options, Option), Wanted),
    alpha_formats(Wanted, Outputs),
    may_have_shadows(Wanted),
    may_be_large(Wanted),
    ignore(looking(Options, _)),        % says what is wrong with it
    per_metre(Options, PerMetre),
    load_model(Files, [evaluate(false),rows(false)|Options]),
    looks_read(Options),
    stage(shade, sg_verbs_render:shaded_scene_of(Options, Wanted, Scene)),
    shown_told(Wanted, Scene),
    maplist(buffer_written(Scene), Buffers),
    maplist(scan_line_written(Scene), ScanLines),
    spans_scanned(Outputs, Spans, Wanted, Scene),
    (   \+ ( member(output(_,Format), Outputs), Format \== pl )
    ->  Made = none
    ;   is_large(Wanted)
    ->  Made = scene(Scene,Wanted)
    ;   stage(shade, picture_image(Scene, Wanted, Image)),
        Made = image(Image)
    ),
    maplist(output_written(image_output(Made, PerMetre)), Outputs).

is_large(Wanted) :-
    option(size(Size), Wanted),
    picture_is_large(Size).

%!  wanted_scene(+Options, :Load, -Scene, -Wanted) is det.
%
%   Scene is the picture that render would make with Options of the model that
%   Load brings into the world; Wanted are its options as shaded_picture/4 and
%   picture_image/3 have them.

:- meta_predicate wanted_scene(+, 0, -, -).

wanted_scene(Options, Load, Scene, Wanted) :-
    findall(Option, render_option(Options, Option), Wanted),
    ignore(looking(Options, _)),
    call(Load),
    looks_read(Options),
    shaded_scene_of(Options, Wanted, Scene).

%   shaded_scene_of(Options, Wanted, Scene)

shaded_scene_of(Options, Wanted, Scene) :-
    shown_roots(Options, Roots),
    up_matrix(Options, Turned),
    shaded_model(Roots, Turned, Model00),
    surfaces_wanted(Wanted, Model00, Model0),
    forall(bent_leaf(Model0, S, Count, P, Off),
           print_message(warning, sanggwan(not_flat(S, Count, P, Off)))),
    placed(Options, Roots, Turned, Model0, Model1, Away, Eye),
    sections_cut(Options, Model0, Away, Eye, Model1, Model),
    (   shaded_picture(Model, Eye, Wanted, Scene)
    ->  facets_told(Wanted, Scene),
        see_through_told(Wanted, Scene)
    ;   print_message(warning, sanggwan(nothing_seen)),
        empty_picture(Eye, Wanted, Scene)
    ).

%   surfaces_wanted(Wanted, Model0, Model): true surfaces, or facets.

surfaces_wanted(Wanted, Model0, Model) :-
    (   option(surface(facets), Wanted)
    ->  faceted_model(Model0, Model)
    ;   Model = Model0
    ).

%   shown_told(Wanted, Scene): a window beside all that is seen is told, and
%   that no line of the picture goes through what is there.

shown_told(Wanted, Scene) :-
    option(smooth(Lines), Wanted, 4),
    (   \+ scene_leaf(Scene, _)
    ->  true
    ;   line_shows(Scene, Lines)
    ->  true
    ;   scene_shows(Scene)
    ->  print_message(warning, sanggwan(thinner_than_lines))
    ;   ( member(window(_), Wanted) ; member(window(_,_), Wanted) )
    ->  print_message(warning, sanggwan(nothing_in_window))
    ;   true
    ).

%   facets_told(Wanted, Scene): files have facets. By more than a dot that is
%   told.

facets_told(Wanted, Scene) :-
    (   \+ option(surface(facets), Wanted),
        scene_facets_off(Scene, Dots),
        Dots > 1
    ->  print_message(informational, sanggwan(facets_off(Dots)))
    ;   true
    ).

scene_facets_off(Scene, Dots) :-
    scene_model(Scene, Model),
    facets_off(Model, Off),
    scene_scale(Scene, Scale),
    Dots is Off*Scale.

%   bent_leaf(Model, S, Count, P, Off): a leaf of segment S, or of a term in
%   root S, has Count faces that are not flat, the worst P, by Off.

bent_leaf(model(Leaves,_,_), S, Count, P, Off) :-
    member(leaf(_,Root,Own,Term,_), Leaves),
    callable(Term),
    bent_faces(Term, bent(Count,P,Off)),
    (   Own =:= 0
    ->  S = Root
    ;   S = Own
    ).

%   shown_roots(Options, Roots): the solids and surfaces among what is asked
%   for; a section has no surfaces, which have no inside.

shown_roots(Options, Roots) :-
    (   option(segment(Texts), Options)
    ->  maplist(segment_asked('--segment', 'N'), Texts, All)
    ;   findall(S, root_segment(S), All)
    ),
    include(is_shaded, All, Shaded),
    partition(not_cut(Options), Shaded, Uncut, Roots),
    forall(member(S, Uncut),
           print_message(warning, sanggwan(surface_uncut(S)))),
    forall(( member(S, All), \+ memberchk(S, Shaded) ),
           ( segment(S, Kind, _),
             print_message(warning, sanggwan(not_shaded(S, Kind))) )).

not_cut(Options, S) :-
    option(section([_|_]), Options),
    segment(S, surface, _).

%   see_through_told(Wanted, Scene): behind the faces of a root with an open
%   surface nothing else of that root is seen.

see_through_told(Wanted, Scene) :-
    forall(( distinct(R, scene_leaf(Scene, leaf(_,R,_,_,_))),
             segment(R, surface, Term),
             is_node_term(Term),
             once(( option(shade(xray), Wanted)
                  ; ( Of = R ; scene_leaf(Scene, leaf(_,R,Of,_,_)) ),
                    look(Of, opacity(A)),
                    A < 1 )) ),
           print_message(warning, sanggwan(surface_see_through(R)))).

%   segment_asked(Option, Form, Text, S): S, as Option says, which takes a Form.

segment_asked(Option, Form, Text, S) :-
    (   atom_number(Text, S),
        integer(S),
        S > 0
    ->  (   segment(S, _, _)
        ->  true
        ;   findall(Known, segment(Known, _, _), All),
            usage_error(no_segment(S, All))
        )
    ;   usage_error(bad_value(Option, Text, Form))
    ).

%   placed(Options, Roots, Turned, Model0, Model, Away, Eye): an eye looks at
%   the origin, so what --eye looks at is moved there, from Away.

placed(Options, Roots, Turned, Model0, Model, Away, Eye) :-
    (   option(projection(Kind0), Options)
    ->  set_projection(Kind0)
    ;   true
    ),
    (   looking(Options, View)
    ->  true
    ;   View = model
    ),
    looked(View, Options, Roots, Turned, Model0, Model, Away),
    current_view(Theta, Phi, Rho0, Kind),
    (   Kind == central,
        \+ ( view(_, _, Given), Given > 0.0 )
    ->  far_enough(Model, Rho0, Rho)
    ;   Rho = Rho0
    ),
    shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye).

looked(model, _, _, _, Model, Model, [0,0,0]).
looked(view(_,Theta,Phi,_), Options, _, _, Model, Model, [0,0,0]) :-
    (   option(view(Text), Options),
        split_string(Text, ",", " ", [_,_,RhoText])
    ->  number_string(Rho, RhoText)
    ;   Rho = 0
    ),
    set_view(Theta, Phi, Rho).
looked(eye(At,Target0), Options, Roots, Turned, Model0, Model, Away) :-
    (   Target0 == middle
    ->  solid_middle(Model0, Target)
    ;   Target = Target0
    ),
    maplist(difference, Target, At, Way),
    Way = [X,Y,Z],
    (   view_towards(d(X,Y,Z), view, view(_,Theta,Phi,_))
    ->  true
    ;   option(eye(Text), Options),
        usage_error(sheet(no_direction('--eye', Text)))
    ),
    (   option(projection(central), Options)
    ->  maplist(moved_row, Turned, Target, Matrix),
        shaded_model(Roots, Matrix, Model),
        Away = Target,
        Rho is sqrt(X*X + Y*Y + Z*Z)
    ;   Model = Model0,
        Away = [0,0,0],
        Rho = 0
    ),
    set_view(Theta, Phi, Rho).

difference(A, B, C) :-
    C is A-B.

moved_row([A,B,C,D0], X, [A,B,C,D]) :-
    D is D0-rational(X).

solid_middle(Model, [X,Y,Z]) :-
    (   solid_box(Model, box(X1,Y1,Z1,X2,Y2,Z2))
    ->  X is (X1+X2)/2,
        Y is (Y1+Y2)/2,
        Z is (Z1+Z2)/2
    ;   X = 0.0, Y = 0.0, Z = 0.0
    ).

%   sections_cut(Options, Model0, Away, Eye, Model1, Model): --section says
%   planes of Model0, which has been moved from Away and is Model1. What is on
%   the side of the eye goes; of a plane with four numbers what is above it.

sections_cut(Options, Model0, Away, Eye, Model1, Model) :-
    option(section(Texts), Options, []),
    foldl(section_cut(Model0, Away, Eye), Texts, Model1, Model).

section_cut(Whole, Away, Eye, Text, Model0, Model) :-
    (   section_plane(Text, solid_box(Whole), Plane0, Axis)
    ->  Plane0 = plane(A,B,C,D0),
        Away = [X,Y,Z],
        D is D0 + A*X + B*Y + C*Z,
        to_eye(Axis, plane(A,B,C,D), Eye, Plane)
    ;   usage_error(sheet(section(Text)))
    ),
    (   sectioned_model([Plane], Model0, Model)
    ->  true
    ;   solid_box(Whole, Box)
    ->  usage_error(sheet(section_past(Text, Box)))
    ;   usage_error(sheet(section_past(Text, none)))
    ).

to_eye(none, Plane, _, Plane) :-
    !.
to_eye(_, plane(A,B,C,D), eye(Theta,Phi,Rho,Kind,_), Plane) :-
    view_matrix(Theta, Phi, [_,_,r(X,Y,Z)]),
    Towards is -(A*X + B*Y + C*Z),
    (   Kind == central
    ->  Height is Rho*Towards + D
    ;   Height = Towards
    ),
    (   Height < 0,
        \+ is_rounding(Height, 1)
    ->  maplist(negative, [A,B,C,D], Turned),
        Plane =.. [plane|Turned]
    ;   Plane = plane(A,B,C,D)
    ).

negative(X, Y) :-
    Y is -X.

%   far_enough(Model, Rho0, Rho): three times as far as the farthest corner of
%   the box round all.

far_enough(Model, Rho0, Rho) :-
    (   solid_box(Model, box(X1,Y1,Z1,X2,Y2,Z2))
    ->  X is max(abs(X1), abs(X2)),
        Y is max(abs(Y1), abs(Y2)),
        Z is max(abs(Z1), abs(Z2)),
        Rho is 3*sqrt(X*X + Y*Y + Z*Z)
    ;   Rho = Rho0
    ).


                /*******************************
                *            OPTIONS           *
                *******************************/

%   render_option(Options, Option): of shaded_picture/4 and picture_image/3.

render_option(Options, size(W-H)) :-
    option(size(Text), Options),
    size_dots(Text, W, H).
render_option(Options, Window) :-
    option(window(Text), Options),
    window_told(Text, Window).
render_option(Options, smooth(N)) :-
    option(smooth(Text), Options),
    atom_number(Text, N).
render_option(Options, shade(Shade)) :-
    option(shade(Text), Options),
    shade_named(Text, [], Shade).
render_option(Options, colours(By)) :-
    option(colours(By), Options).
render_option(Options, edges(true)) :-
    option(edges(true), Options).
render_option(Options, shadows(true)) :-
    option(shadows(true), Options).
render_option(Options, surface(Surface)) :-
    option(surface(Surface), Options).
render_option(Options, background(Colour)) :-
    option(background(Text), Options),
    background_named(Text, Colour).

render_option(Options, palette(N)) :-
    option(palette(Text), Options),
    (   atom_number(Text, N),
        integer(N),
        N >= 2,
        N =< 256
    ->  true
    ;   usage_error(bad_value('--palette', Text, 'N (2..256)'))
    ).

size_dots(Text, W, H) :-
    (   split_string(Text, "xX", " ", [TextW,TextH]),
        whole(TextW, W),
        whole(TextH, H),
        W >= 1, W =< 1<<20,
        H >= 1, H =< 1<<20,
        W*H =< 1<<31
    ->  true
    ;   usage_error(bad_value('--size', Text,
                              'WxH (W, H: 1..1048576, W*H: 1..2147483648)'))
    ).

whole(Text, N) :-
    catch(number_string(N, Text), error(_, _), fail),
    integer(N).

%   window_told(Text, Option): as of shaded_picture/4.

window_told(Text, Option) :-
    (   split_string(Text, ",", " ", Parts),
        maplist(finite, Parts, [X1,Y1,X2,Y2|More]),
        X2-X1 >= 1.0e-90,
        Y2-Y1 >= 1.0e-90,
        window_option(More, b(X1,Y1,X2,Y2), Option0)
    ->  Option = Option0
    ;   usage_error(bad_value('--window', Text,
                              'X1,Y1,X2,Y2[,D] (X1 < X2, Y1 < Y2; \c
                               X2-X1, Y2-Y1, D: 1e-90..1e90)'))
    ).

window_option([], Box, window(Box)).
window_option([D], Box, window(Box,D)) :-
    D >= 1.0e-90.

finite(Text, X) :-
    catch(( number_string(X0, Text), X is float(X0) ), error(_, _), fail),
    abs(X) =< 1.0e90.

background_named(none, none) :-
    !.
background_named(Text, Colour) :-
    (   colour_named(Text, Colour)
    ->  true
    ;   findall(Name, colour_name(Name, _), Names),
        atomic_list_concat([none|Names], ', ', All),
        atomic_list_concat([All,', R,G,B (0..255)'], Form),
        usage_error(bad_value('--background', Text, Form))
    ).

colour_named(Text, RGB) :-
    (   split_string(Text, ",", " ", [R0,G0,B0])
    ->  maplist(whole, [R0,G0,B0], [R,G,B]),
        colour_rgb(rgb(R,G,B), RGB)
    ;   colour_rgb(Text, RGB)
    ).

alpha_formats(Wanted, _) :-
    option(background(none), Wanted),
    option(palette(_), Wanted),
    !,
    usage_error(both_options('--palette', '--background none')).
alpha_formats(Wanted, Outputs) :-
    (   option(background(none), Wanted),
        member(output(_, ppm), Outputs)
    ->  usage_error(no_clear_dots(ppm))
    ;   true
    ).

%   may_have_shadows(Wanted): with --shadows a shade that has light and dark.

may_have_shadows(Wanted) :-
    option(shade(Shade), Wanted, lambert),
    (   option(shadows(true), Wanted),
        \+ shade_has_shadows(Shade)
    ->  functor(Shade, Name, _),
        atom_concat('--shade ', Name, Other),
        usage_error(both_options('--shadows', Other))
    ;   option(shadows(true), Wanted),
        \+ decision_is_default(tone/3)
    ->  print_message(warning, sanggwan(shadows_in_vain))
    ;   true
    ).

%   may_be_large(Wanted): of each dot of a large picture no rule is asked.

may_be_large(Wanted) :-
    (   is_large(Wanted),
        \+ decision_is_default(pixel_colour/4)
    ->  usage_error(large_by_rule)
    ;   true
    ).

per_metre(Options, PerMetre) :-
    (   option(dpi(N), Options)
    ->  PerMetre is round(N/0.0254)
    ;   PerMetre = 0
    ).

%   looks_read(Options): --look and --light.

looks_read(Options) :-
    (   option(look(File), Options)
    ->  look_file_added(File, InVain),
        forall(member(Name, InVain), look_in_vain(Name))
    ;   true
    ),
    option('see-through'(Texts), Options, []),
    forall(member(Text, Texts), seen_through(Text)),
    (   option(light(Text), Options)
    ->  light_way(Text, Way),
        findall(F, light(1, strength(F)), Strengths),
        findall(N, ( light(N, _), N > 0 ), Ns),
        forall(member(N, Ns), retractall_facts(light(N, _))),
        forall(member(F, Strengths), assert_fact(light(1, strength(F)))),
        assert_fact(light(1, Way))
    ;   true
    ).

look_in_vain(Name) :-
    segment_names(Names),
    print_message(warning, sanggwan(look_in_vain(Name, Names))).

segment_names(Names) :-
    findall(Name, ( segment(_, _, Term), plain_name(Term, Name) ), Names0),
    sort(Names0, Names).

%   seen_through(Text): N or N=A; a segment or its name, and how opaque it is.

seen_through(Text) :-
    atomic_list_concat([Name|Value], =, Text),
    (   Value == []
    ->  A = 0.3
    ;   Value = [AText],
        atom_number(AText, A),
        A >= 0,
        A =< 1
    ),
    !,
    named_segments(Name, Ss),
    forall(member(S, Ss),
           ( retractall_facts(look(S, opacity(_))),
             assert_fact(look(S, opacity(A))) )).
seen_through(Text) :-
    see_through_form(Form),
    usage_error(bad_value('--see-through', Text, Form)).

see_through_form('N, N=A (A: 0..1)').

named_segments(Name, Ss) :-
    (   \+ atom_number(Name, _),
        findall(S, ( segment(S, _, Term), plain_name(Term, Name) ), Ss0),
        Ss0 = [_|_]
    ->  Ss = Ss0
    ;   atom_number(Name, _)
    ->  see_through_form(Form),
        segment_asked('--see-through', Form, Name, S),
        Ss = [S]
    ;   findall(S, segment(S, _, _), Numbers),
        segment_names(Names),
        append(Numbers, Names, Known),
        usage_error(no_segment(Name, Known))
    ).

light_way(Text, picture(X,Y,Z)) :-
    (   split_string(Text, ",", " ", Parts),
        maplist(finite, Parts, [X,Y,Z]),
        \+ maplist(=:=(0.0), [X,Y,Z])
    ->  true
    ;   usage_error(bad_value('--light', Text, 'X,Y,Z (X*X+Y*Y+Z*Z > 0)'))
    ).

%   image_output(Made, PerMetre, File): Made is image(Image), or scene(Scene,
%   Wanted): it is made as it is written.

image_output(Made, PerMetre, File) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    stage(write, writing(File, binary,
                         sg_verbs_render:image_bytes(Format, Made, PerMetre))).

image_bytes(pl, _, _, Out) :-
    set_stream(Out, encoding(utf8)),
    write_shading_facts(Out).
image_bytes(png, image(Image), PerMetre, Out) :-
    image_png(Image, PerMetre, Out).
image_bytes(ppm, image(Image), _, Out) :-
    image_ppm(Image, Out).
image_bytes(Format, scene(Scene,Wanted), PerMetre, Out) :-
    picture_written(Scene, Wanted, Format, PerMetre, Out).


                /*******************************
                *            BUFFERS           *
                *******************************/

%   spans_file(Options, Spans): [File] of --spans, or [].

spans_file(Options, Spans) :-
    (   option(spans(File), Options)
    ->  file_name_extension(_, Ending, File),
        (   downcase_atom(Ending, csv)
        ->  may_be_written(File),
            Spans = [File]
        ;   usage_error(ending(File, [csv]))
        )
    ;   Spans = []
    ).

%   spans_scanned(Outputs, Spans, Wanted, Scene): span/7, where something is
%   written of it.

spans_scanned(Outputs, Spans, Wanted, Scene) :-
    (   Spans == [],
        \+ memberchk(output(_,pl), Outputs)
    ->  true
    ;   option(smooth(Lines), Wanted, 4),
        stage(shade, scan(scene(Scene,Lines))),
        maplist(spans_written, Spans)
    ).

spans_written(File) :-
    stage(write, writing(File, text, sg_verbs_render:spans_bytes)),
    when_written(print_message(informational, sanggwan(wrote(File)))).

spans_bytes(Out) :-
    write_spans(Out).

%   buffers(Options, Buffers): Kind-File of each --buffer.

buffers(Options, Buffers) :-
    option(buffer(Texts), Options, []),
    maplist(buffer, Texts, Buffers).

buffer(Text, Kind-File) :-
    (   sub_atom(Text, Before, 1, _, =),
        sub_atom(Text, 0, Before, _, Kind0),
        buffer_kind(Kind0, Ending)
    ->  Kind = Kind0,
        After is Before+1,
        sub_atom(Text, After, _, 0, File),
        file_name_extension(_, Ending0, File),
        (   downcase_atom(Ending0, Ending)
        ->  may_be_written(File)
        ;   usage_error(ending(File, [Ending]))
        )
    ;   usage_error(bad_value('--buffer', Text,
                              'depth=FILE.pfm, normal=FILE.pfm, \c
                               tone=FILE.pgm, id=FILE.csv'))
    ).

buffer_kind(depth, pfm).
buffer_kind(normal, pfm).
buffer_kind(tone, pgm).
buffer_kind(id, csv).

buffer_written(Scene, Kind-File) :-
    buffer_type(Kind, Type),
    stage(write, writing(File, Type,
                         sg_verbs_render:buffer_bytes(Kind, Scene))),
    when_written(print_message(informational, sanggwan(wrote(File)))).

buffer_type(Kind, Type) :-
    (   Kind == id
    ->  Type = text
    ;   Type = binary
    ).

buffer_bytes(Kind, Scene, Out) :-
    write_buffer(Kind, Scene, Out).
