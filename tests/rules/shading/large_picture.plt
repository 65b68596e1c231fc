/* Pictures that are written as they are made: the bytes are those of a picture
   that is there as a whole. */
% covers: shaded_picture, image_file_rows, image_png, buffer, shaded_rows
:- module(test_large_picture, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(option)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(decision)).
:- use_module(rules(kernel)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(shading/surface_look)).
:- use_module(shaded_model).

:- begin_tests(large_picture).

model("segment(1, solid, difference([box(size(4,4,4)), 2])).
       segment(2, solid, cylinder(radius(1), height(9), facets(48))).
       segment(3, solid, at([translate(0,0,4)], torus(radius(1),tube(0.5)))).
       look(2, colour(red)). look(3, opacity(0.4)). view(300, 60, 0).").

:- meta_predicate written(1, -).

written(Goal, Bytes) :-
    tmp_file_stream(File, Out, [encoding(binary)]),
    call(Goal, Out),
    close(Out),
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        read_string(In, _, Bytes),
        close(In)),
    delete_file(File).

whole(png, Image, Out) :- image_png(Image, 3937, Out).
whole(ppm, Image, Out) :- image_ppm(Image, Out).

%   both(Format, Options, Blocks, Whole, Parts): the bytes, as a whole, and in
%   parts of so many Blocks.
both(Format, Options, Blocks, Whole, Parts) :-
    model(Text),
    in_model(Text,
             ( shaded_scene_of(Options, Scene),
               picture_image(Scene, Options, Image),
               written(whole(Format, Image), Whole),
               scene_looks(Scene, root, Looks0, Leaves),
               looks_for_kernel(Looks0, Options, Looks),
               picture_how(Scene, Options, How),
               scene_handle(Scene, Handle),
               File = file(Format,3937,[],Blocks),
               written(sg_kernel:image_written(Handle, How, Looks, Leaves,
                                               File),
                       Parts) )).

test(parts,
     [ forall(( member(Format, [png,ppm]),
                member(More, [[],[background(none)],[edges(true)],
                              [shadows(true)]]),
                \+ ( Format \== png, More == [background(none)] ),
                member(Height, [1,64,150,192]), member(Blocks, [0,1,2]) )),
       true(Whole == Parts)
     ]) :-
    both(Format, [size(70-Height),smooth(2)|More], Blocks, Whole, Parts).
test(palette, true(Whole == Parts)) :-
    Options = [size(90-80),palette(17)],
    model(Text),
    in_model(Text,
             ( shaded_scene_of(Options, Scene),
               picture_image(Scene, Options, Image),
               written(whole(ppm, Image), Whole),
               written(sg_shaded_picture:picture_written(Scene, Options, ppm,
                                                         0),
                       Parts) )).
test(rule_of_owners, true(Whole == Parts)) :-
    Options = [size(60-50)],
    in_model("segment(1, solid, union([2,3])). view(300, 60, 0).
              segment(2, solid, box(size(2,2,2))). look(2, colour(red)).
              segment(3, solid, at([translate(1,0,0)], box(size(2,2,2)))).
              look(3, colour(blue)).",
             ( by_rule("owner(_, Group, Owner) :- lists:last(Group, Owner)."),
               shaded_scene_of(Options, Scene0),
               picture_image(Scene0, Options, Image),
               shaded_scene_of(Options, Scene),
               written(whole(ppm, Image), Whole),
               written(sg_shaded_picture:picture_written(Scene, Options, ppm,
                                                         0),
                       Parts) )).
test(too_large, error(domain_error(picture_size, _))) :-
    model(Text),
    in_model(Text,
             ( shaded_scene_of([size(1048577-1)], Scene),
               written(sg_shaded_picture:picture_written(Scene, [], ppm, 0),
                       _) )).
test(no_alpha, error(domain_error(image_without_alpha, _))) :-
    model(Text),
    in_model(Text,
             ( shaded_scene_of([size(9-9)], Scene),
               Options = [background(none)],
               written(sg_shaded_picture:picture_written(Scene, Options, ppm,
                                                         0),
                       _) )).
test(large, [forall(member(Size-Large, [16384-4096 - no, 16385-1 - yes,
                                        1-16385 - yes, 8193-8192 - yes]))]) :-
    (   picture_is_large(Size)
    ->  Large == yes
    ;   Large == no
    ).

by_rule(Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        use_rules(File),
        delete_file(File)).

:- end_tests(large_picture).
