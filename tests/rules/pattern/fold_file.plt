:- encoding(utf8).
:- module(test_fold_file, []).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/fold_file)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

/* Texts in a FOLD file: whatever a title has in it, another reader of JSON has
   the same, and what can be read in the file is not spelled. Faces with holes:
   each side of a triangle is an edge, once. */

%   spoken(Code): it can stand in a title.

spoken(Code) :-
    (   between(0, 0x2ff, Code)
    ;   member(Code, [0x20ac,0x2028,0x2029,0xac00,0xd55c,0xfeff,0xffff,
                      0x10000,0x1f600,0x10ffff])
    ).

titled(Title, Text) :-
    tmp_file(titled, Base),
    atom_concat(Base, '.fold', File),
    setup_call_cleanup(
        in_new_world(write_fold(File, [], [title(Title)])),
        read_file_to_string(File, Text, [encoding(utf8)]),
        delete_file(File)).

read_title(Text, Title) :-
    setup_call_cleanup(open_string(Text, In),
                       json_read_dict(In, Dict),
                       close(In)),
    string(Dict.file_title),
    string_codes(Dict.file_title, Title).

%   raw_control(Text): it has one that is not at the end of a line; the reader
%   here lets them pass.

raw_control(Text) :-
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    string_codes(Line, Codes),
    member(Code, Codes),
    Code < 32.

%   fold_of(Term, Dict): the file of what Term unfolds to, as JSON.

fold_of(Term, Dict) :-
    fold_of(Term, [], Dict).

fold_of(Term, Options, Dict) :-
    tmp_file(fold, Base),
    atom_concat(Base, '.fold', File),
    setup_call_cleanup(
        in_new_world(( add_primitive(Term, S), complete_segments,
                       develop(S, D), write_fold(File, [D], Options) )),
        setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                           json_read_dict(In, Dict),
                           close(In)),
        delete_file(File)).

face_sides(Vs, Sides) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    maplist([A,B,[Low,High]]>>msort([A,B], [Low,High]), Vs, Nexts, Sides).

turned("M", "V").
turned("B", "B").

:- begin_tests(fold_file).

test(edges, [ forall(member(Term-Js, [ box(size(1,2,3))-0,
                                       hollow_cylinder(radius(2),inner(1),
                                                       height(1),facets(6))-24
                                     ])),
              Assigned == Js ]) :-
    fold_of(Term, Dict),
    maplist(msort, Dict.edges_vertices, Edges0),
    msort(Edges0, Edges),
    maplist(face_sides, Dict.faces_vertices, Sidess),
    append(Sidess, Sides0),
    sort(Sides0, Sides),
    assertion(Edges == Sides),
    findall(x, member("J", Dict.edges_assignment), Xs),
    length(Xs, Assigned),
    assertion(( Assigned =:= 0
              -> Dict.frame_attributes == ["2D"]
              ;  Dict.frame_attributes == ["2D","joins"] )).

% Seen from inside: x the other way, faces round the other way, a mountain is a
% valley. The 2D of a prism has folds of many angles, and seams.
test(inside) :-
    Term = prism(outline([[0,0],[4,0],[5,3],[2,5],[0,3]]), height(2)),
    fold_of(Term, [], Out),
    fold_of(Term, [inside(true)], In),
    maplist([[X0,Y],[X,Y]]>>(X is 0.0-X0), Out.vertices_coords, Coords),
    assertion(Coords == In.vertices_coords),
    maplist(reverse, Out.faces_vertices, Faces),
    assertion(Faces == In.faces_vertices),
    assertion(Out.edges_vertices == In.edges_vertices),
    maplist(turned, Out.edges_assignment, Assigned),
    assertion(Assigned == In.edges_assignment),
    maplist([A0,A]>>(A is -A0), Out.edges_foldAngle, Angles),
    assertion(Angles == In.edges_foldAngle),
    sort(Out.edges_assignment, Kinds),
    assertion(Kinds == ["B","M"]),
    forall(( nth1(I, Out.edges_assignment, Kind),
             nth1(I, Out.edges_foldAngle, Angle) ),
           assertion(( Kind == "M" -> Angle < 0 ; Angle =:= 0 ))).
test(title, Read == Codes) :-
    findall(Code, spoken(Code), Codes),
    string_codes(Title, Codes),
    titled(Title, Text),
    \+ raw_control(Text),
    read_title(Text, Read).
test(not_spelled, true(sub_string(Text, _, _, _, "\"박공 roof~ /2\""))) :-
    titled("박공 roof~ /2", Text).
test(no_title, true(\+ sub_string(Text, _, _, _, "file_title"))) :-
    titled("", Text).
test(units, [forall(member(Unit-Name, [mm-"mm",cm-"cm",m-"m",inch-"in",
                                       none-"unit"])),
             Found == Name]) :-
    tmp_file(unit, Base),
    atom_concat(Base, '.fold', File),
    setup_call_cleanup(
        in_new_world(write_fold(File, [], [unit(Unit)])),
        setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                           json_read_dict(In, Dict),
                           close(In)),
        delete_file(File)),
    Found = Dict.frame_unit.

:- end_tests(fold_file).
