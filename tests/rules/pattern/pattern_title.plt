/* What the pieces of several patterns are called, and where that is written. */
:- module(test_pattern_title, []).

:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(pattern/pattern_title)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unfolding/unfold)).
:- use_module(rules(unrolling/true_table)).
:- use_module(tests('rules/sample')).

:- meta_predicate in_new(0).

in_new(Goal) :-
    new_world(World),
    in_world(World, Goal).

%   patterns_of(Terms, Ds): the true patterns of what Terms stand for, open.

patterns_of(Terms, Ds) :-
    findall(S, ( member(Term, Terms), add_primitive(Term, S) ), Ss),
    complete_segments,
    findall(Own,
            ( member(S, Ss),
              wanted_of(S, [wish(removed([base,top]), fact)], Wanted),
              true_patterns(S, Wanted, [generators(24)], Own0),
              include(is_pattern, Own0, Own) ),
            Owns),
    append(Owns, Ds).

is_pattern(D) :-
    segment(D, _, true_development(_, _)).

elbow(Size, named(bend, elbow(diameter(Size), radius(R), pieces(4),
                              facets(24)))) :-
    R is 1.5*Size.

%   Letters of names and what else is drawn, as sides of a drawing.

name_and_other_sides(Drawing, Names, Others) :-
    Drawing = drawing(_, Views),
    findall(Is-Side,
            ( member(view(_, Strokes, _), Views),
              member(stroke(_, Role, _, _, Points, _, _), Strokes),
              role_is(Role, Is),
              append(_, [A,B|_], Points),
              Side = A-B ),
            Sides),
    findall(Side, member(name-Side, Sides), Names),
    findall(Side, member(other-Side, Sides), Others).

role_is(face_name, name).
role_is(cut, other).
role_is(number, other).
role_is(generator_number, other).

cross(A-B, C-D) :-
    side_of(A, B, C, S1),
    side_of(A, B, D, S2),
    S1*S2 =< 0,
    side_of(C, D, A, S3),
    side_of(C, D, B, S4),
    S3*S4 =< 0,
    boxes_meet(A, B, C, D).

side_of(XA-YA, XB-YB, X-Y, Sign) :-
    Sign is sign((XB-XA)*(Y-YA) - (YB-YA)*(X-XA)).

boxes_meet(XA-YA, XB-YB, XC-YC, XD-YD) :-
    max(XA, XB) >= min(XC, XD),
    max(XC, XD) >= min(XA, XB),
    max(YA, YB) >= min(YC, YD),
    max(YC, YD) >= min(YA, YB).

:- begin_tests(pattern_title).

test(pieces, Titles == ["bend/piece(1)","bend/piece(2)","bend/piece(3)",
                        "bend/piece(4)"]) :-
    elbow(100, Elbow),
    in_new(( patterns_of([Elbow], Ds),
             pattern_titles(Ds, Named),
             findall(Title, ( member(D, Ds), memberchk(D-Title, Named) ),
                     Titles) )).
test(alone, Titles == []) :-
    in_new(( patterns_of([cylinder(radius(20), height(60))], Ds),
             Ds = [_],
             pattern_titles(Ds, Titles) )).
test(told_apart, Titles == ["1 pipe","2 pipe","pole"]) :-
    Pipe = cylinder(radius(20), height(60)),
    in_new(( patterns_of([named(pipe,Pipe),named(pipe,Pipe),
                          named(pole,Pipe)], Ds),
             pattern_titles(Ds, Named),
             findall(Title, member(_-Title, Named), Titles) )).
%   The side and the caps of one segment are not told apart by its number.
test(of_one_segment, Titles == ["can","can"]) :-
    in_new(( add_primitive(named(can, cylinder(radius(20), height(60))), S),
             complete_segments,
             wanted_of(S, [], Wanted),
             true_patterns(S, Wanted, [], Ds),
             pattern_titles(Ds, Named),
             findall(Title, member(_-Title, Named), Titles) )).
test(piece_of_one, Titles == ["pipe","pipe (1.2)"]) :-
    findall(Title,
            ( member(Piece, [name(7,1,0),name(7,1,2),name(8,1,0)]),
              in_new(piece_title([7-"pipe"], Piece, Title)) ),
            Titles).
test(pieces_of_several, Title == "box (2)") :-
    in_new(( assert_fact(segment(7, pattern, a)),
             forall(between(1, 3, V),
                    assert_fact(v(7, V, V, 0.0, 0.0))),
             forall(between(1, 2, P),
                    ( assert_fact(p(7, P, [])),
                      assert_fact(piece(7, P, P)) )),
             piece_title([7-"box"], name(7,2,0), Title) )).

%   Each piece has its name, over no cut line and no number, where its
%   generators leave room for it and where they do not.
test(written, [forall(one_in(3, member(Size, [60,114.3,30])))]) :-
    elbow(Size, Elbow),
    in_new(( patterns_of([Elbow], Ds),
             pattern_drawing(Ds, [table(false)], Drawings) )),
    findall(View,
            ( member(drawing(_, Views), Drawings),
              member(view(View, Strokes, _), Views),
              memberchk(stroke(_, face_name, _, _, _, _, _), Strokes) ),
            Named),
    length(Named, Count),
    assertion(Count =:= 4),
    forall(member(Drawing, Drawings),
           ( name_and_other_sides(Drawing, Names, Others),
             forall(member(Name, Names),
                    \+ ( member(Other, Others), cross(Name, Other) )) )).

%   A table has it in a row of its own, over all columns and within them.
test(on_tables) :-
    in_new(( patterns_of([cylinder(radius(20), height(60))], [D]),
             true_length_marks(D, [], Marks0, Width-High0),
             true_length_marks(D, [title("a pipe")], Marks, Width-High) )),
    row_height(2.5, Row),
    assertion(abs(High-High0-Row) < 1.0e-9),
    findall(Text, member(text(_, _, _, Text), Marks0), Texts0),
    findall(Text, member(text(_, _, _, Text), Marks), Texts1),
    msort(["a pipe"|Texts0], Texts),
    assertion(msort(Texts1, Texts)),
    memberchk(text(X, Y, 2.5, "a pipe"), Marks),
    assertion(abs(X-Width/2) < 1.0e-9),
    assertion(( Y > High0, Y+2.5 < High )).
test(long_title) :-
    length(Codes, 300),
    maplist(=(0'W), Codes),
    string_codes(Title, Codes),
    in_new(( patterns_of([cylinder(radius(20), height(60))], [D]),
             true_length_marks(D, [title(Title)], Marks, _) )),
    memberchk(text(_, _, Height, Title), Marks),
    assertion(Height < 1).

:- end_tests(pattern_title).
