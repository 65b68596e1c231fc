:- module(test_pattern_checker, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(yall)).
:- use_module(tests('rules/development/laid_flat')).
:- use_module(tests('rules/pattern_checked')).
:- use_module(tests('rules/polyhedron'), [box_points/3, box_faces/1]).

/* The checker of patterns is checked itself: on patterns that are right, and
on the same spoiled in one way after the other. */

%   box_pattern(+Folds, -Lines): of the box from 0,0,0 to 1,2,3. Its faces are
%   bottom, top, front, back, left, right.

box_pattern(Folds, Lines) :-
    box_points(p(0,0,0), p(1,2,3), Points),
    box_faces(Faces),
    laid_flat(Points, Faces, Folds, Lines).

good(Lines) :-
    box_pattern([3-1,3-2,3-6,6-4,3-5], Lines).

%   said(+Lines, +Told, -Result): what the checker says of it.

said(Lines, Told, Result) :-
    append(Lines, Told, All),
    append(All, [end(pattern)], Ended),
    patterns_checked(written(Ended), [Result]).

written(Lines, Out) :-
    maplist(write_line(Out), Lines).

said(Lines, Result) :-
    said(Lines, [reported(13.0,1)], Result).

%   spoiled(+Old, :Change, -Result): what it says of the good pattern when
%   call(Change, Old, New) has made New of the first line like Old.

:- meta_predicate spoiled(+, 2, -).

spoiled(Old, Change, Result) :-
    good(Lines0),
    once(append(Before, [Old|After], Lines0)),
    changed(Change, Old, Changed),
    append([Before, Changed, After], Lines),
    said(Lines, Result).

%   everywhere(:Change, -Result): the same, of all lines that Change changes.

:- meta_predicate everywhere(2, -).

everywhere(Change, Result) :-
    good(Lines0),
    maplist(changed_or_not(Change), Lines0, Lines),
    said(Lines, Result).

:- meta_predicate changed(2, ?, -), changed_or_not(2, ?, -).

changed(Change, Old, [New]) :-
    call(Change, Old, New),
    !.
changed(_, _, []).

changed_or_not(Change, Old, New) :-
    (   call(Change, Old, New0)
    ->  New = New0
    ;   New = Old
    ).

left_out(_, _) :-
    fail.

one_piece('P'(P,P0,2,Es), 'P'(P,P0,1,Es)).

joint_of(Es, 'J'(A,B,_,_)) :-
    (   memberchk(A, Es)
    ;   memberchk(B, Es)
    ),
    !.

has(Result, Wanted) :-
    Wanted :< Result.

%   two_squares(+X, +Y, +Degrees, -Lines): two unit squares, each a piece; the
%   second has its first corner at X-Y in the pattern, and is turned about it.

square(V0, E0, P, Corners, Lines) :-
    numlist(0, 3, Is),
    maplist(plus(V0), Is, Vs),
    maplist(plus(E0), Is, Es),
    Vs = [A,B,C,D],
    findall(v(V,X,Y,0.0),
            ( member(I-X-Y, [0-0.0-0.0,1-1.0-0.0,2-1.0-1.0,3-0.0-1.0]),
              nth0(I, Vs, V) ),
            L1),
    findall(Line,
            ( member(I, Is),
              J is (I+1) mod 4,
              maplist(nth0, [I,J,I], [Vs,Vs,Es], [V,W,E]),
              nth0(I, Corners, X-Y),
              member(Line, [e(E,V,W), 'V'(V,X,Y,V)]) ),
            L2),
    findall('E'(E,V,W,E), member(e(E,V,W), L2), L3),
    append([L1, L2, L3, [p(P,Es), t(P,A,B,C), t(P,A,C,D), 'P'(P,P,P,Es)]],
           Lines).

two_squares(X0, Y0, Degrees, Lines) :-
    square(1, 1, 1, [0.0-0.0,1.0-0.0,1.0-1.0,0.0-1.0], Lines1),
    C is cos(Degrees*pi/180),
    S is sin(Degrees*pi/180),
    findall(X-Y,
            ( member(A-B, [0-0,1-0,1-1,0-1]),
              X is X0+A*C-B*S,
              Y is Y0+A*S+B*C ),
            Corners),
    square(5, 5, 2, Corners, Lines2),
    append(Lines1, Lines2, Lines).

%   deep(+X, +Y, +Degrees, -Deep)

deep(X, Y, Degrees, Deep) :-
    two_squares(X, Y, Degrees, Lines),
    said(Lines, [reported(0.0,2)], R),
    has(R, _{overlap:Relative, sheet:Sheet}),
    Deep is Relative*Sheet.

%   frame(+Size, -Lines): a plate of 3 by 3 with a hole of 1 by 1 in it, and a
%   square of Size in the middle of the hole.

frame(Size, Lines) :-
    Points = [ 1-0.0-0.0, 2-3.0-0.0, 3-3.0-3.0, 4-0.0-3.0,
               5-1.0-1.0, 6-1.0-2.0, 7-2.0-2.0, 8-2.0-1.0 ],
    Low is 1.5-Size/2,
    High is 1.5+Size/2,
    Others = [ 9-Low-Low, 10-High-Low, 11-High-High, 12-Low-High ],
    append(Points, Others, All),
    Edges = [ e(1,1,2), e(2,2,3), e(3,3,4), e(4,4,1),
              e(5,5,6), e(6,6,7), e(7,7,8), e(8,8,5),
              e(9,9,10), e(10,10,11), e(11,11,12), e(12,12,9) ],
    findall(v(V,X,Y,0.0), member(V-X-Y, All), L1),
    findall('V'(V,X,Y,V), member(V-X-Y, All), L2),
    findall('E'(E,A,B,E), member(e(E,A,B), Edges), L3),
    numlist(1, 8, Plate),
    L4 = [ p(1,Plate), p(2,[9,10,11,12]), t(1,1,2,8), t(1,1,8,5), t(1,2,3,7),
           t(1,2,7,8), t(1,3,4,6), t(1,3,6,7), t(1,4,1,5), t(1,4,5,6),
           t(2,9,10,11), t(2,9,11,12) ],
    append([ L1, Edges, L4, L2, L3,
             ['P'(1,1,1,Plate), 'P'(2,2,2,[9,10,11,12])] ], Lines).

:- begin_tests(pattern_checker).

test(box) :-
    good(Lines),
    said(Lines, R),
    has(R, _{exact:yes, faces:6, pieces:1, folds:5, seams:7, borders:0,
             turned:0, missing:0, unpaired:0, deep:0}),
    \+ bad_pattern(R, 1e-15, _).
test(lengths, [true(S-T-Square =@= 13.0-11.0-22.0)]) :-
    good(Lines),
    said(Lines, R),
    S is float(R.seam),
    T is float(R.tree),
    Square is round(R.sheet**2*1e9)/1e9.
test(several_patterns, [true(Names == [a,b])]) :-
    good(Lines),
    append([Lines, [end(a)|Lines], [end(b)]], All),
    patterns_checked(written(All), Rs),
    maplist(get_dict(name), Rs, Names).

% What is wrong is found.

test(corner_moved) :-
    spoiled('V'(_,_,_,_), ['V'(W,X,Y,V),'V'(W,X1,Y,V)]>>(X1 is X+3e-9), R),
    R.shape > 9e-10,
    R.fold > 9e-10.
test(angle) :-
    spoiled('J'(_,_,fold,_), ['J'(A,B,K,D),'J'(A,B,K,D1)]>>(D1 is D+1e-6), R),
    R.fold > 1e-9,
    R.angle > 1e-9,
    R.shape < 1e-15.
test(angle_of_a_seam) :-
    spoiled('J'(_,_,seam,_), ['J'(A,B,K,D),'J'(A,B,K,D1)]>>(D1 is -D), R),
    R.fold < 1e-15,
    R.angle > 0.1.
test(folded_forwards) :-
    everywhere(['J'(A,B,K,D),'J'(A,B,K,D1)]>>(D1 is -D), R),
    R.fold > 0.3.
test(mirrored) :-
    everywhere(['V'(W,X,Y,V),'V'(W,X1,Y,V)]>>(X1 is -X), R),
    has(R, _{exact:no, turned:6}).
test(too_large) :-
    everywhere(['V'(W,X,Y,V),'V'(W,X1,Y1,V)]>>(X1 is X*1.001, Y1 is Y*1.001),
               R),
    R.shape > 9e-4,
    R.total > 9e-4.
test(seam_called_fold) :-
    spoiled('J'(_,_,seam,_), ['J'(A,B,_,D),'J'(A,B,fold,D)]>>true, R),
    has(R, _{exact:no, mismatch:1}).
test(fold_called_seam) :-
    spoiled('J'(_,_,fold,_), ['J'(A,B,_,D),'J'(A,B,seam,D)]>>true, R),
    has(R, _{exact:no, cut:1}),
    R.fold =:= inf.
test(no_joint) :-
    spoiled('J'(_,_,seam,_), left_out, R),
    has(R, _{exact:no, unpaired:2}).
test(wrong_partner) :-
    good(Lines0),
    selectchk('J'(A,B,seam,X), Lines0, Lines1),
    selectchk('J'(C,D,seam,Y), Lines1, Lines2),
    append(Lines2, ['J'(A,D,seam,X),'J'(C,B,seam,Y)], Lines),
    said(Lines, R),
    has(R, _{exact:no, mismatch:2}).
test(joint_twice) :-
    good(Lines),
    memberchk('J'(A,B,seam,Angle), Lines),
    append(Lines, ['J'(A,B,seam,Angle)], Lines1),
    said(Lines1, [reported(13.0,1)], R),
    has(R, _{exact:no, loose:2}).
test(no_polygon) :-
    good(Lines0),
    selectchk('P'(1,_,_,Es), Lines0, Lines1),
    exclude(joint_of(Es), Lines1,
            Lines),
    said(Lines, R),
    has(R, _{exact:no, missing:1, lost:4}).
test(polygon_removed_as_asked) :-
    box_pattern([3-2,3-6,6-4,3-5], Lines0),
    exclude(joint_of([1,2,3,4]), Lines0, Lines1),
    exclude(=@=('P'(1,_,_,_)), Lines1, Lines),
    said(Lines, [removed(1),reported(8.0,1)], R),
    has(R, _{exact:yes, faces:5, borders:4, missing:0, lost:0}).
test(polygon_twice) :-
    good(Lines),
    memberchk('P'(1,P0,K,Es), Lines),
    append(Lines, ['P'(7,P0,K,Es)], Lines1),
    said(Lines1, R),
    has(R, _{exact:no, missing:1, loose:4}).
test(other_seam_told) :-
    good(Lines),
    said(Lines, [reported(13.001,1)], R),
    has(R, _{exact:no}).
test(pieces_that_hang_together) :-
    everywhere(['P'(P,P0,1,Es),'P'(P,P0,K,Es)]>>( K is 1+P mod 2 ), R),
    has(R, _{exact:no}),
    R.cut > 0.
test(pieces_that_do_not_hang_together) :-
    box_pattern([root(3,0.0,0.0),3-1,3-2,3-5,root(6,9.0,0.0),6-4], Lines0),
    maplist(changed_or_not(one_piece), Lines0, Lines),
    said(Lines, [reported(16.0,1)], R),
    has(R, _{exact:no}),
    R.cut > 0,
    R.fold =:= inf.
test(two_pieces) :-
    box_pattern([root(3,0.0,0.0),3-1,3-2,3-5,root(6,9.0,0.0),6-4], Lines),
    said(Lines, [reported(16.0,2)], R),
    has(R, _{exact:yes, pieces:2}).
test(pieces_on_each_other) :-
    box_pattern([root(3,0.0,0.0),3-1,3-2,3-5,root(6,0.5,0.0),6-4], Lines),
    said(Lines, [reported(16.0,2)], R),
    has(R, _{exact:no}),
    R.deep > 0,
    R.overlap > 0.05.

% Edges in parts, and joints inside a polygon.

test(edge_in_parts) :-
    good(Lines0),
    selectchk('E'(1,A,B,1), Lines0, Lines1),
    memberchk('V'(A,Xa,Ya,Va), Lines1),
    memberchk('V'(B,Xb,Yb,Vb), Lines1),
    memberchk(v(Va,X1,Y1,Z1), Lines1),
    memberchk(v(Vb,X2,Y2,Z2), Lines1),
    maplist([P,Q,M]>>(M is (P+Q)/2), [Xa,Ya,X1,Y1,Z1], [Xb,Yb,X2,Y2,Z2],
            [X,Y,Xv,Yv,Zv]),
    selectchk('P'(1,1,1,[1|Es]), Lines1, Lines2),
    selectchk('J'(1,_,_,_), Lines2, Lines3),
    append([ [v(9,Xv,Yv,Zv)|Lines3],
             ['V'(99,X,Y,9), 'E'(98,A,99,1), 'E'(99,99,B,1)] ], Lines4),
    append(Lines4, ['P'(1,1,1,[98,99|Es])], Whole),
    append(Lines4, ['P'(1,1,1,[98|Es])], Half),
    said(Whole, R1),
    has(R1, _{lost:0, missing:0}),
    said(Half, R2),
    has(R2, _{lost:1}).

% How deep polygons lie on each other.

test(side_on_side, [true(Deep < 1e-18)]) :-
    deep(1.0, 0.0, 0, Deep).
test(strip, [true(abs(Deep-0.001) < 1e-12)]) :-
    deep(0.999, 0.2, 0, Deep).
test(corner_in_side, [true(abs(Deep-0.01) < 1e-12)]) :-
    deep(0.99, 0.5, -45, Deep).
test(corner_at_side, [true(Deep < 1e-15)]) :-
    deep(1.0, 0.5, -45, Deep).
test(inside, [true(abs(Deep-1) < 1e-12)]) :-
    deep(0.0, 0.0, 0, Deep).
test(thin, [true(N == 0)]) :-
    two_squares(0.9999999995, 0.2, 0, Lines),
    said(Lines, [reported(0.0,2)], R),
    N = R.deep.
test(not_so_thin, [true(N == 1)]) :-
    two_squares(0.999999997, 0.2, 0, Lines),
    said(Lines, [reported(0.0,2)], R),
    N = R.deep.
test(in_the_hole) :-
    frame(0.999, Lines),
    said(Lines, [reported(0.0,2)], R),
    has(R, _{exact:yes, deep:0}).
test(over_the_hole) :-
    frame(1.001, Lines),
    said(Lines, [reported(0.0,2)], R),
    has(R, _{exact:no}),
    R.deep > 0.

% Tabs.

tab(Corners, Result) :-
    good(Lines0),
    memberchk('J'(E,_,seam,_), Lines0),
    append(Lines0, ['T'(E,Corners)], Lines),
    said(Lines, Result).

test(tab_on_a_polygon) :-
    tab([0.1-0.1,0.2-0.1,0.2-0.2,0.1-0.2], R),
    has(R, _{exact:no, deep:0}),
    R.deep_tabs > 0.
test(tab_beside) :-
    tab([50.1-0.1,50.1-0.2,50.2-0.2,50.2-0.1], R),
    has(R, _{exact:yes, deep_tabs:0}).

% Files that are none.

wrong(Lines) :-
    patterns_checked(written(Lines), _).

test(no_such_word, [throws(error(process_error(_, exit(2)), _))]) :-
    wrong([x(1)]).
test(no_such_id, [throws(error(process_error(_, exit(2)), _))]) :-
    wrong([v(1,0,0,0), e(1,1,2)]).
test(id_twice, [throws(error(process_error(_, exit(2)), _))]) :-
    wrong([v(1,0,0,0), v(1,0,0,0)]).
test(no_end, [throws(error(process_error(_, exit(2)), _))]) :-
    wrong([v(1,0,0,0)]).

:- end_tests(pattern_checker).
