/* Buffers of a shaded picture: depths, normals and spans against closed
   forms. */
% covers: depth_buffer_rows
:- module(test_shading_buffer, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(decision)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_buffer)).
:- use_module(rules(shading/shading_scene)).
:- use_module(shaded_model).

%   buffer(Kind, View, Codes): a ball of radius 3 in a frame of 8 units, 80
%   dots.
buffer(Kind, View, Codes) :-
    ball(Text),
    in_model(Text,
             ( shaded_model([1], Model),
               shaded_eye(Model, View, Eye),
               shaded_picture(Model, Eye,
                              [size(80-80),window(b(-4.0,-4.0,4.0,4.0))],
                              Scene),
               setup_call_cleanup(
                   tmp_file_stream(octet, File, Out),
                   ( write_buffer(Kind, Scene, Out),
                     close(Out),
                     read_file_to_codes(File, Codes, [encoding(octet)]) ),
                   delete_file(File)) )).

ball("segment(1, solid, sphere(radius(3),facets(64))).
      view(270, 0, 0).").

top(view(270.0,0.0,0.0,parallel)).

%   pfm(Codes, Head, Floats): Floats is a compound.
pfm(Codes, Head, Floats) :-
    append(Head0, [0'-,0'1,0'.,0'0,0'\n|Bytes], Codes),
    !,
    atom_codes(Head, Head0),
    floats(Bytes, List),
    Floats =.. [floats|List].

floats([], []).
floats([A,B,C,D|Bytes], [F|Fs]) :-
    Bits is A + B<<8 + C<<16 + D<<24,
    float_of(Bits, F),
    floats(Bytes, Fs).

float_of(Bits, F) :-
    Sign is 1 - 2*(Bits>>31),
    Exponent is (Bits>>23) /\ 255,
    Part is Bits /\ 0x7fffff,
    (   Exponent =:= 255
    ->  F = infinite
    ;   Exponent =:= 0
    ->  F is Sign * Part * 2.0** -149
    ;   F is Sign * (Part + 0x800000) * 2.0**(Exponent-150)
    ).

:- begin_tests(shading_buffer).

test(depth, Head-Wrong == 'Pf\n80 80\n'-[]) :-
    top(View),
    buffer(depth, View, Codes),
    pfm(Codes, Head, Floats),
    findall(Row-Column-F,
            ( between(0, 79, Row), between(0, 79, Column),
              I is Row*80+Column+1,
              arg(I, Floats, F),
              X is (Column+0.5)/10-4,
              Y is (Row+0.5)/10-4,      % rows from below
              Square is 9-X*X-Y*Y,
              (   Square > 0.05
              ->  \+ ( number(F), abs(F+sqrt(Square)) < 1.0e-5 )
              ;   Square < -0.05,
                  F \== infinite
              ) ),
            Wrong).
test(depth_from_the_eye) :-       % the nearest point is 7 - 3 away
    buffer(depth, view(270.0,0.0,7.0,central), Codes),
    pfm(Codes, _, Floats),
    Floats =.. [_|All],
    include(number, All, Numbers),
    min_list(Numbers, Least),
    abs(Least-4.0) < 0.01.
test(normals, Head-Wrong == 'PF\n80 80\n'-[]) :-
    top(View),
    buffer(normal, View, Codes),
    pfm(Codes, Head, Floats),
    findall(Row-Column,
            ( between(0, 79, Row), between(0, 79, Column),
              I is 3*(Row*80+Column)+1,
              J is I+1,
              arg(I, Floats, NX),
              arg(J, Floats, NY),
              X is (Column+0.5)/10-4,
              Y is (Row+0.5)/10-4,
              Square is 9-X*X-Y*Y,
              (   Square > 0.05
              ->  \+ ( abs(NX-X/3) < 1.0e-5, abs(NY-Y/3) < 1.0e-5 )
              ;   Square < -0.05,
                  \+ ( NX =:= 0, NY =:= 0 )
              ) ),
            Wrong).
% The middle of a dot counts, as for depths and normals, also where it is
% covered in part.
test(tones, Head-Wrong == "P5\n80 80\n255\n"-[]) :-
    top(View),
    buffer(tone, View, Codes),
    length(Head0, 13),
    append(Head0, Bytes, Codes),
    string_codes(Head, Head0),
    findall(Row-Column-Byte,
            ( nth0(I, Bytes, Byte),
              Row is I//80,
              Column is I mod 80,
              X is (Column+0.5)/10-4,
              Y is 4-(Row+0.5)/10,      % rows from above
              Square is 9-X*X-Y*Y,
              (   Square > 0.05
              ->  Light is max(0, (-5*X+6*Y+8*sqrt(Square))/3/sqrt(125)),
                  abs(Byte-255*(0.25+0.75*Light)) > 1.5
              ;   Square < -0.05,
                  Byte =\= 0
              ) ),
            Wrong).
test(id, First-Count == "40.5,"-60) :-
    top(View),
    buffer(id, View, Codes),
    string_codes(Text, Codes),
    split_string(Text, "\n", "", [Head|Rows0]),
    assertion(Head == "y,x1,x2,root,leaf,segment,face,part"),
    exclude(==(""), Rows0, Rows),
    length(Rows, Count),
    member(Row, Rows),
    sub_string(Row, 0, _, _, "40.5,"),
    !,
    First = "40.5,",
    split_string(Row, ",", "", [_,X1,X2,"1","1","1","1","1.0"]),
    number_string(A, X1),
    number_string(B, X2),
    assertion(abs(B-A-60) < 0.05).
test(id_by_rule, Leaves-Front == ["2"]-"top") :-
    in_model("segment(1, solid, box(size(4,4,3))).
              segment(2, solid, box(size(4,4,3))).
              segment(3, solid, union([1,2])). view(270, 0, 0).",
             ( setup_call_cleanup(
                   ( tmp_file_stream(File, Rules, [encoding(utf8),
                                                   extension(pl)]),
                     write(Rules, "owner(_, [_,Owner|_], Owner)."),
                     close(Rules) ),
                   use_rules(File),
                   delete_file(File)),
               shaded_scene_of([size(40-40)], Scene),
               with_output_to(string(Text),
                              ( current_output(Out),
                                write_buffer(id, Scene, Out) )),
               seen_face(Scene, Front) )),
    split_string(Text, "\n", "", [_|Rows]),
    findall(Segment,
            ( member(Row, Rows),
              split_string(Row, ",", "", [_,_,_,"3",_,Segment|_]) ),
            Segments),
    sort(Segments, Leaves).

seen_face(Scene, Front) :-
    seen_at(Scene, 20, 20, seen(3,2,F)),
    scene_leaf(Scene, leaf(2,_,_,_,Faces)),
    memberchk(F-Face, Faces),
    atom_string(Face, Front).

:- end_tests(shading_buffer).
