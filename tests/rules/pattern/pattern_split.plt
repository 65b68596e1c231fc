:- module(test_pattern_split, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(assoc)).
:- use_module(rules(disjoint_sets)).
:- use_module(rules(pattern/pattern_nest), [fits_on/2]).
:- use_module(rules(pattern/pattern_piece), [piece_points/2]).
:- use_module(rules(pattern/pattern_split)).

% A strip of N faces, Wide x 10, one above the other, joined by folds; face P
% and the next have fold P.
strip(N, Wide, piece(name(2,1,0),Faces,Sides)) :-
    findall(face(P,[[A,B,C],[A,C,D]]),
            ( between(1, N, P), corners(P, Wide, A, B, C, D) ),
            Faces),
    findall(Side, ( between(1, N, P), strip_side(N, Wide, P, Side) ), Sides).

corners(P, Wide, A-(0.0-Y1), B-(Wide-Y1), C-(Wide-Y2), D-(0.0-Y2)) :-
    A is 2*P-1,
    B is 2*P,
    C is 2*P+2,
    D is 2*P+1,
    Y1 is 10.0*(P-1),
    Y2 is 10.0*P.

strip_side(N, Wide, P, side(E,P,From,To,Joint)) :-
    corners(P, Wide, A, B, C, D),
    Before is P-1,
    (   P =:= 1
    ->  Low = border
    ;   Low = fold(Before, 90.0, 2)
    ),
    (   P =:= N
    ->  High = border
    ;   High = fold(P, 90.0, 1)
    ),
    nth1(I, [ A-B-Low, B-C-border, C-D-High, D-A-border ], From-To-Joint),
    E is 10*P+I.

% The same faces in the order of a bit reversal, so that neighbours are far from
% each other in all lists.
mixed(piece(Name,Faces0,Sides), piece(Name,Faces,Sides)) :-
    length(Faces0, N),
    findall(Key-Face,
            ( nth1(I, Faces0, Face), Key is (I*7919) mod (N+1) ),
            Keyed0),
    keysort(Keyed0, Keyed),
    findall(Face, member(_-Face, Keyed), Faces).

faces(piece(_,Faces,_), N) :-
    length(Faces, N).

joints(Parts, Kind, N) :-
    findall(x, ( member(piece(_,_,Sides), Parts),
                 member(side(_,_,_,_,Joint), Sides),
                 functor(Joint, Kind, 3) ), Xs),
    length(Xs, N).

split_inferences(N, Room, Inferences) :-
    strip(N, 15.0, Piece0),
    mixed(Piece0, Piece),
    statistics(inferences, Before),
    split_piece(Piece, Room, -1.0, _),
    statistics(inferences, After),
    Inferences is After-Before.

:- begin_tests(pattern_split).

test(whole, [ Parts == [Piece] ]) :-
    strip(4, 15.0, Piece),
    split_piece(Piece, room(60,60,3), -1.0, Parts).
test(one_for_each_face, [ true(Counts == [1,1,1,1,1,1,1]) ]) :-
    strip(7, 15.0, Piece),
    split_piece(Piece, room(17,14,1), -1.0, Parts),
    maplist(faces, Parts, Counts).
% 64 faces, of which 5 go on a page: halves have 4, and are joined again as far
% as there is room.
test(all_fit, [ forall(member(N-High, [64-53, 64-75, 100-34, 33-120])) ]) :-
    strip(N, 15.0, Piece),
    Room = room(18,High,1),
    split_piece(Piece, Room, -1.0, Parts),
    forall(member(Part, Parts),
           ( piece_points(Part, Points), assertion(fits_on(Points, Room)) )),
    maplist(faces, Parts, Counts),
    sum_list(Counts, All),
    assertion(All =:= N).
% No two neighbours have room together.
test(no_two_fit, [ forall(member(N-High, [64-53, 64-75, 100-34])) ]) :-
    strip(N, 15.0, Piece),
    Room = room(18,High,1),
    split_piece(Piece, Room, -1.0, Parts),
    forall(( member(piece(_,_,Sides1), Parts),
             member(side(_,_,_,_,seam(J,_,1)), Sides1),
             member(piece(_,_,Sides2), Parts),
             memberchk(side(_,_,_,_,seam(J,_,2)), Sides2),
             findall(P, ( member(Sides, [Sides1,Sides2]),
                          member(side(_,_,_-P,_,_), Sides) ), Points)
           ),
           assertion(\+ fits_on(Points, Room))).
% Each fold is one still, or two sides of a seam.
test(joints_stay, [ true(Folds+Seams =:= 2*63) ]) :-
    strip(64, 15.0, Piece),
    split_piece(Piece, room(18,53,1), -1.0, Parts),
    joints(Parts, fold, Folds),
    joints(Parts, seam, Seams),
    length(Parts, N),
    assertion(Seams =:= 2*(N-1)).
test(folds_join_inside_only) :-
    strip(64, 15.0, Piece),
    split_piece(Piece, room(18,53,1), -1.0, Parts),
    forall(( member(piece(_,_,Sides), Parts),
             member(side(_,_,_,_,fold(J,_,1)), Sides) ),
           assertion(memberchk(side(_,_,_,_,fold(J,_,2)), Sides))).
test(same_in_any_order, [ Same == true ]) :-
    strip(64, 15.0, Piece),
    mixed(Piece, Mixed),
    maplist(part_faces, [Piece,Mixed], [Parts1,Parts2]),
    (   Parts1 == Parts2
    ->  Same = true
    ;   Same = Parts1-Parts2
    ).
% Two folds, and room for two of three faces: the longer fold stays.
test(longest_fold_first, [ forall(member(Below-Above-Left,
                                         [15.0-12.0-[1,2], 12.0-15.0-[2,3]])),
                           true(Pair == Left) ]) :-
    steps(Below, Above, Piece),
    split_piece(Piece, room(20,24,1), -1.0, Parts),
    member(piece(_,[face(A,_),face(B,_)],_), Parts),
    !,
    msort([A,B], Pair).
% A strip askew, with faces longer than the page: halves of a fold are parted
% and joined in one place only.
test(askew, [ forall(member(Degrees, [0,30,90,147])) ]) :-
    strip(12, 90.0, Piece0),
    turned(Degrees, Piece0, Piece),
    Room = room(48,48,1),
    split_piece(Piece, Room, -1.0, Parts),
    forall(member(Part, Parts),
           ( piece_points(Part, Points), assertion(fits_on(Points, Room)) )),
    forall(( member(piece(_,_,Sides), Parts),
             member(side(_,_,_-A,_-B,fold(J,_,1)), Sides) ),
           assertion(( member(side(_,_,_-C,_-D,fold(J,_,2)), Sides),
                       near(A, D),
                       near(B, C) ))),
    joints(Parts, fold, Folds),
    assertion(Folds > 0),
    maplist(part_area, Parts, Areas),
    sum_list(Areas, Area),
    assertion(abs(Area-90*120) < 1.0e-6).
% Twice the faces take little more than twice the time.
test(near_linear, [ forall(member(Room, [room(17,14,1),room(18,95,1)])),
                    true(Exponent < 1.25) ]) :-
    split_inferences(300, Room, Inferences1),
    split_inferences(1200, Room, Inferences4),
    Exponent is log(Inferences4/Inferences1)/log(4).
test(parted, [ Counts == [2,3,5] ]) :-
    strip(10, 15.0, Piece),
    parted_piece(Piece, [2,5], Parts),
    maplist(faces, Parts, Counts).
test(parted_near_linear, [ true(Exponent < 1.25) ]) :-
    findall(Inferences,
            ( member(N, [300,1200]),
              strip(N, 15.0, Piece),
              findall(J, ( between(1, N, J), J mod 3 =:= 0 ), Js),
              statistics(inferences, Before),
              parted_piece(Piece, Js, _),
              statistics(inferences, After),
              Inferences is After-Before ),
            [I1,I4]),
    Exponent is log(I4/I1)/log(4).

:- end_tests(pattern_split).

part_faces(Piece, Faces) :-
    split_piece(Piece, room(18,53,1), -1.0, Parts),
    findall(Ps, ( member(piece(_,Own,_), Parts),
                  findall(P, member(face(P,_), Own), Ps0),
                  sort(Ps0, Ps) ),
            Faces0),
    sort(Faces0, Faces).

:- begin_tests(disjoint_sets).

% Chains joined from either end, and by halves: the root is the same for all.
test(one_set, [ forall(member(Order, [up,down,halves])) ]) :-
    findall(I-J, pair(Order, I, J), Pairs),
    empty_assoc(Sets0),
    foldl(joined, Pairs, Sets0, Sets),
    findall(Root, ( between(1, 64, I), set_root(Sets, I, Root) ), Roots),
    sort(Roots, Distinct),
    assertion(Distinct = [_]).
test(short_ways,
     [ forall(member(Order, [up,down,halves])), true(Most =< 6) ]) :-
    findall(I-J, pair(Order, I, J), Pairs),
    empty_assoc(Sets0),
    foldl(joined, Pairs, Sets0, Sets),
    findall(L, ( between(1, 64, I), way(Sets, I, 0, L) ), Ls),
    max_list(Ls, Most).
test(others_stay, [ Roots == [1,1,3,4] ]) :-
    empty_assoc(Sets0),
    sets_joined(1, 2, Sets0, Sets1),
    sets_joined(2, 1, Sets1, Sets),
    findall(Root, ( between(1, 4, I), set_root(Sets, I, Root) ), Roots).

% A face that is too wide: of both parts at a line the first side is that of the
% part to the right.
test(first_side, Firsts == [right,right]) :-
    strip(1, 500.0, Piece),
    split_piece(Piece, room(190,190,3), 0.5, Parts),
    findall(Line-at(Which,X),
            ( member(Part, Parts),
              Part = piece(_,_,Sides),
              member(side(_,_,_,_,seam(Line,_,Which)), Sides),
              Line = split(_,_),
              piece_points(Part, Points),
              aggregate_all(max(X0), member(X0-_, Points), X) ),
            Ends0),
    keysort(Ends0, Ends),
    group_pairs_by_key(Ends, Groups),
    findall(First,
            ( member(_-Two, Groups),
              msort(Two, [at(1,X1),at(2,X2)]),
              (   X1 > X2
              ->  First = right
              ;   First = left
              ) ),
            Firsts).

:- end_tests(disjoint_sets).

% Three faces one above the other, the folds between them of two lengths.
steps(Below, Above, piece(name(2,1,0),Faces,Sides)) :-
    Least is min(Below, Above),
    Faces = [ face(1,[[1-(0.0-0.0),2-(Least-0.0),4-(Below-10.0),3-(0.0-10.0)]]),
              face(2,[[3-(0.0-10.0),4-(Below-10.0),6-(Above-20.0),
                       5-(0.0-20.0)]]),
              face(3,[[5-(0.0-20.0),6-(Above-20.0),8-(Least-30.0),
                       7-(0.0-30.0)]]) ],
    Sides = [ side(2,1,4-(Below-10.0),3-(0.0-10.0),fold(1,90.0,1)),
              side(3,2,3-(0.0-10.0),4-(Below-10.0),fold(1,90.0,2)),
              side(4,2,6-(Above-20.0),5-(0.0-20.0),fold(2,90.0,1)),
              side(5,3,5-(0.0-20.0),6-(Above-20.0),fold(2,90.0,2)) ].

turned(Degrees, piece(Name,Faces0,Sides0), piece(Name,Faces,Sides)) :-
    findall(face(P,Shapes),
            ( member(face(P,Shapes0), Faces0),
              maplist(maplist(turned_corner(Degrees)), Shapes0, Shapes) ),
            Faces),
    findall(side(E,P,A,B,J),
            ( member(side(E,P,A0,B0,J), Sides0),
              maplist(turned_corner(Degrees), [A0,B0], [A,B]) ),
            Sides).

turned_corner(Degrees, W-(X0-Y0), W-(X-Y)) :-
    Angle is Degrees*pi/180,
    X is X0*cos(Angle) - Y0*sin(Angle),
    Y is X0*sin(Angle) + Y0*cos(Angle).

near(XA-YA, XB-YB) :-
    abs(XA-XB) + abs(YA-YB) < 1.0e-6.

part_area(piece(_,Faces,_), Area) :-
    findall(A, ( member(face(_,Shapes), Faces), member(Shape, Shapes),
                 shape_area(Shape, A) ), As),
    sum_list(As, Area).

shape_area([_-First|Corners], Area) :-
    findall(A, ( append(_, [_-P,_-Q|_], Corners), cross(First, P, Q, A) ), As),
    sum_list(As, Area).

cross(X0-Y0, X1-Y1, X2-Y2, Area) :-
    Area is ((X1-X0)*(Y2-Y0) - (X2-X0)*(Y1-Y0))/2.

joined(I-J, Sets0, Sets) :-
    sets_joined(I, J, Sets0, Sets).

pair(up, I, J) :-
    between(1, 63, I),
    J is I+1.
pair(down, I, J) :-
    between(1, 63, K),
    I is 64-K,
    J is I+1.
pair(halves, I, J) :-
    member(Step, [1,2,4,8,16,32]),
    Twice is 2*Step,
    between(1, 64, I),
    (I-1) mod Twice =:= 0,
    J is I+Step.

way(Sets, I, L0, L) :-
    (   get_assoc(I, Sets, on(J))
    ->  L1 is L0+1,
        way(Sets, J, L1, L)
    ;   L = L0
    ).
