/* Pictures of what is scaled are the same, to the last byte: by a power of
   two because nothing is rounded otherwise then; by other factors, from 1e-8 to
   1e6, as long as no end of a slice lies within what is rounded of the middle
   between two places of 1/256 dot, which is so nowhere here.

covers: shading_body, shading_ring, shading_bezier, shading_point, extent
*/
:- module(test_scaled_picture, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(kernel)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

:- begin_tests(scaled_picture).

term(flush, difference([box(size(3,3,3)),
                        at([translate(1,1,1)], box(size(1,1,1))),
                        at([translate(0,0,1.5)],
                           cylinder(radius(1),height(1.5)))])).
term(bored, at([rotate(x,33),rotate(y,20),rotate(z,71)],
               difference([box(size(4,3,2)),
                           at([rotate(x,90),translate(0,2,1)],
                              cylinder(radius(0.6),height(5))),
                           at([translate(2,1.5,1)], sphere(radius(0.9)))]))).
term(tangent, intersection([cylinder(radius(1),height(4)),
                            at([translate(0,0,-2),rotate(x,90),
                                translate(0,0,2)],
                               cylinder(radius(1),height(4)))])).
term(torus, union([torus(radius(2),tube(0.7)),
                   at([translate(2,0,0)],
                      cone(radius(1),top(0.3),height(2)))])).
term(stretched, at([scale(0.1,-0.3,0.7),rotate(y,12)],
                   union([box(size(40,10,10)), egg(radius(6),up(9),down(5)),
                          hemisphere(radius(8))]))).
term(flat, union([prism(outline([[0,0],[3,0],[2,2]]),height(1.3)),
                  at([translate(1,1,0.5)], pyramid(base(2,2),height(2)))])).
term(net, at([mirror(x),rotate(z,40)], bezier(points(Points)))) :-
    findall([X,Y,Z],
            ( between(0, 3, Y), between(0, 3, X), Z is (X*7+Y*5) mod 4 - 1 ),
            Points).

scale(Scale) :-
    member(Power, [-27,-1,1,20]),
    Scale is 2.0**Power.
scale(Scale) :-
    member(Scale, [1.0e-8,0.001,0.3,7,1000,1.0e6]).

view(parallel, _, view(300.0,65.0,0.0,parallel)).
view(central, Scale, view(300.0,65.0,Far,central)) :-
    Far is 12*Scale.

bytes(Term, Kind, Scale, Bytes) :-
    view(Kind, Scale, View),
    in_new_world((
        assert_fact(segment(1, solid, at([scale(Scale,Scale,Scale)],Term))),
        shaded_model([1], Model),
        shaded_eye(Model, View, Eye),
        shaded_picture(Model, Eye, [size(160-100)], Scene),
        picture_image(Scene, [size(160-100)], Image),
        tmp_file_stream(binary, File, Out),
        image_ppm(Image, Out),
        close(Out),
        read_file_to_codes(File, Codes, [type(binary)]),
        delete_file(File),
        string_codes(Bytes, Codes)
    )).

test(same, [ forall(( term(Name, Term), member(Kind, [parallel,central]) )),
             true(Others-Name == []-Name) ]) :-
    bytes(Term, Kind, 1, Bytes),
    findall(Scale,
            ( scale(Scale), bytes(Term, Kind, Scale, Other), Other \== Bytes ),
            Others).
test(pictures_differ, true(A \== B)) :-
    once(term(torus, Torus)),
    once(term(flat, Flat)),
    bytes(Torus, parallel, 1, A),
    bytes(Flat, parallel, 1, B).

:- end_tests(scaled_picture).
