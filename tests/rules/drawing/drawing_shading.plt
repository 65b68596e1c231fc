/* Shading under the lines: strokes where a ball is dark, in the frame of its
   lines; pictures as text. */
% covers: image_text, png, verbs_shading, shading_words
:- module(test_drawing_shading, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(csg/csg_matrix)).
:- use_module(rules(decision)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(drawing/drawing_shading)).
:- use_module(rules(drawing/image_text)).
:- use_module(rules(kernel)).
:- use_module(rules(picture/view)).
:- use_module(rules(store)).
:- use_module(tests('rules/drawing/png_reader')).
:- use_module(tests('rules/polyhedron')).


%   strokes(Facts, Away, Strokes): of segment 1, seen from above, 10 mm a unit,
%   its origin in the middle of 100 x 100.
strokes(Facts, Away, Strokes) :-
    in_new_world(
        ( maplist(assert_fact, Facts),
          set_view(270, 0, 0),
          identity_matrix(Matrix),
          shading_taken([1], Matrix, Shading),
          shaded_view(Shading, hatch, place(10000,0,0,50000,50000), Away,
                      Shaded),
          shading_strokes(Shaded, Strokes) )).

ball([ segment(1, solid, sphere(radius(4),facets(64))),
       light(0, strength(0.0)), light(1, strength(1.0)),
       light(1, picture(0,0,1)) ]).

ink(Strokes, Length) :-
    findall(L,
            ( member(stroke(visible,shading,0,[],[X1-Y1,X2-Y2],joint,joint),
                     Strokes),
              L is sqrt((X1-X2)**2 + (Y1-Y2)**2) ),
            Ls),
    sum_list(Ls, Length).

%   png(Options, Png): of a sheet of 100 x 70 mm without lines.
png(Options, Png) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary), extension(png)]),
        ( write_drawing_stream(png, Out,
              [ drawing(drawing(sheet(100000,70000,1.0),[view('',[],[])]))
              | Options ]),
          close(Out),
          read_file_to_codes(File, Codes, [type(binary)]) ),
        delete_file(File)),
    read_png(Codes, Png).

%   dark_box(Rows, Box): round all dots of Rows, lists of RGB, that are not
%   white; up to behind the last.
dark_box(Rows, box(X1,Y1,X2,Y2)) :-
    findall(X-Y,
            ( nth0(Y, Rows, Row),
              nth0(I, Row, Byte),
              Byte < 255,
              X is I//3 ),
            Places),
    findall(X, member(X-_, Places), Xs),
    findall(Y, member(_-Y, Places), Ys),
    min_list(Xs, X1),
    min_list(Ys, Y1),
    max_list(Xs, X3),
    max_list(Ys, Y3),
    X2 is X3+1,
    Y2 is Y3+1.

:- begin_tests(drawing_shading).

%   Lit from the eye, what is darker than t is a ring of the area pi (r t)^2.
test(ink_is_tone) :-
    ball(Facts),
    strokes(Facts, [0,0,0], Strokes),
    ink(Strokes, Length),
    Area is pi*40000**2*(0.75**2 + 0.5**2 + 0.3**2),
    abs(Length*1200/Area - 1) < 0.03.
test(strokes_are_on_the_ball) :-
    ball(Facts),
    strokes(Facts, [0,0,0], Strokes),
    forall(( member(stroke(_,_,_,_,Points,_,_), Strokes),
             member(X-Y, Points) ),
           sqrt((X-50000)**2 + (Y-50000)**2) < 40100).
test(moved, Length1-Length2 == Length-Length) :-
    ball(Facts),
    strokes(Facts, [0,0,0], Strokes1),
    strokes(Facts, [0,0,7], Strokes2),  % along the line of sight
    ink(Strokes1, Length1),
    ink(Strokes2, Length2),
    Length = Length1.
test(moved_aside) :-
    ball(Facts),
    strokes(Facts, [1,0,0], Strokes),
    findall(X, ( member(stroke(_,_,_,_,Points,_,_), Strokes),
                 member(X-_, Points) ), Xs),
    min_list(Xs, Least),
    max_list(Xs, Most),
    abs((Least+Most)/2 - 40000) < 200.
test(ways, Ways == [45,135,0]) :-
    ball(Facts),
    strokes(Facts, [0,0,0], Strokes),
    findall(Way,
            ( member(stroke(_,_,_,_,[X1-Y1,X2-Y2],_,_), Strokes),
              abs(X1-X2) > 3000,
              Way0 is round(atan2(Y1-Y2, X2-X1)*180/pi),
              Way is (Way0+180) mod 180 ),
            Ways0),
    list_to_set(Ways0, Ways).
test(image_in_place, Place == [10000,10000,80000,80000]) :-
    in_new_world(
        ( ball(Facts),
          maplist(assert_fact, Facts),
          set_view(270, 0, 0),
          identity_matrix(Matrix),
          shading_taken([1], Matrix, Shading),
          shaded_view(Shading, lambert, place(10000,0,0,50000,50000),
                      [0,0,0],
                      Shaded),
          shading_images([Shaded], sheet(100000,100000,10), 2, none,
                         [Image]) )),
    Image = image(X,Y,W,H,Dots),
    maplist([A,B]>>(B is round(A)), [X,Y,W,H], Place),
    image_size(Dots, 160, 160).
%   In a PNG it lies where its middle is, whatever the dots; and a picture with
%   shading has as many dots to a metre as one without.
test(png_in_place, [ forall(member(Dots, [4,5,8])),
                     true(Box-PerMetre == box(X1,Y1,X2,Y2)-Wanted) ]) :-
    in_new_world(
        ( ball(Facts),
          maplist(assert_fact, Facts),
          set_view(270, 0, 0),
          identity_matrix(Matrix),
          shading_taken([1], Matrix, Shading),
          shaded_view(Shading, lambert, place(3000,0,0,62000,21000), [0,0,0],
                      Shaded),
          png([shading([Shaded]),style([line(any,any,any,[colour(black)])]),
               dots(Dots)], Png) )),
    X1 is 50*Dots,
    Y1 is 9*Dots,
    X2 is 74*Dots,
    Y2 is 33*Dots,
    Png = png(W,H,8,2,Chunks,Rows),
    assertion(( W =:= 100*Dots, H =:= 70*Dots )),
    dark_box(Rows, Box),
    memberchk("pHYs"-[A,B,C,D,A,B,C,D,1], Chunks),
    PerMetre is ((A*256+B)*256+C)*256+D,
    Wanted is 1000*Dots,
    in_new_world(png([dots(Dots)], png(W,H,_,_,Chunks0,_))),
    memberchk("pHYs"-[A,B,C,D,A,B,C,D,1], Chunks0).
%   A rule is asked as if operands were not put aside; afterwards they are.
test(owner_by_segment, Dot-Left == [0,0,170]-[3]) :-
    in_new_world(
        ( maplist(assert_fact,
                  [ segment(1, solid, box(size(6,6,1))),
                    segment(2, solid, named(inlay,box(size(4,4,1)))),
                    segment(3, solid, union([1,2])),
                    look(1, colour(red)), look(2, colour(rgb(0,0,255))),
                    light(0, strength(0.4)), light(1, strength(0.0)) ]),
          by_rule("owner(_, Group, S-Face) :- lists:member(S-Face, Group), \c
                   segment(S, _, named(inlay,_))."),
          set_view(270, 0, 0),
          identity_matrix(Matrix),
          shading_taken([3], Matrix, Shading),
          retractall_facts(segment(1,_,_)),
          retractall_facts(segment(2,_,_)),
          shaded_view(Shading, lambert, place(10000,0,0,50000,50000), [0,0,0],
                      Shaded),
          shading_images([Shaded], sheet(100000,100000,10), 2, white,
                         [image(_,_,_,_,Image)]),
          image_dot(Image, 60, 60, Dot),
          findall(S, segment(S, _, _), Left) )).

by_rule(Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        use_rules(File),
        delete_file(File)).

test(base_64, Head == "iVBORw0KGgo") :- % the signature of PNG
    image_blank(3, 2, rgb(1,2,3), Image),
    image_base64(Image, Text),
    sub_string(Text, 0, 11, _, Head).
test(flate, Head-End == [0x78]-"~>") :-
    image_blank(50, 40, rgb(1,2,3), Image),
    image_flate(Image, Text),
    string_codes(Text, [A,B,C,D,E|_]),
    foldl([Code,N0,N]>>(N is N0*85 + Code - 0'!), [A,B,C,D,E], 0, Number),
    First is Number >> 24,
    Head = [First],
    sub_string(Text, _, 2, 0, End).

:- end_tests(drawing_shading).
