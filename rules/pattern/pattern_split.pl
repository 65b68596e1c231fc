:- module(sg_pattern_split,
          [ split_piece/4,              % +Piece, +Paper, +Flat, -Parts
            parted_piece/3              % +Piece, +Folds, -Parts
          ]).
:- use_module('../kernel', [shape_at/3]).
:- use_module('../near', [tolerance/2, is_straight/2]).
:- use_module(pattern_join, [joined_parts/4]).
:- use_module(pattern_nest, [fits_on/2, least_box/4]).
:- use_module(pattern_piece, [corner_map/2, piece_points/2]).
:- use_module(library(apply), [exclude/3, foldl/4, include/3, maplist/3]).
:- use_module(library(assoc),
              [ empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4 ]).
:- use_module(library(lists),
              [append/2, append/3, last/2, member/2, nth1/3, sum_list/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Pieces that are larger than a sheet, divided.

Along folds, which become seams, if there are any: across the longer side of the
least box round the piece, where few short folds are lost. A single face that is
too large is divided along a straight line; the new sides are a seam split(A,B),
named by the corners at its ends. What hangs together by folds that are not
drawn, as the triangles of a flat face of a mesh do, is a single face here. A
corner that a line made is x(W1,W2), between
W1 and W2.
*/

:- set_prolog_flag(optimise, true).

%!  split_piece(+Piece, +Paper, +Flat, -Parts) is det.
%
%   Parts is [Piece] (pattern_piece.pl) if that fits on Paper (pattern_nest.pl),
%   else parts of it that do; all of them have its name. Folds that bend by no
%   more than Flat degrees are none.

split_piece(Piece0, Paper, Flat, Parts) :-
    piece_points(Piece0, Points),
    (   fits_on(Points, Paper)
    ->  Parts = [Piece0]
    ;   flat_joined(Piece0, Flat, Piece),
        small_parts([Piece], Paper, Parts0),
        joined_parts(Piece, Parts0, Paper, Parts)
    ).

%   flat_joined(Piece0, Flat, Piece): the faces of Piece0 that hang together by
%   flat folds are one face, which has the number of the first of them.

flat_joined(piece(Name,Faces0,Sides0), Flat, piece(Name,Faces,Sides)) :-
    findall(J-P,
            ( member(side(_,P,_,_,fold(J,Angle,_)), Sides0),
              abs(Angle) =< Flat
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    findall(Step, ( member(_-[P1,P2], Grouped),
                    ( Step = P1-P2 ; Step = P2-P1 ) ), Steps),
    findall(P, member(face(P,_), Faces0), Ps),
    components(Ps, Steps, Groups),
    findall(P-First, ( member([First|Others], Groups),
                       member(P, [First|Others]) ), Firsts0),
    list_to_assoc(Firsts0, Firsts),
    findall(First-Shapes,
            ( member(face(P,Shapes), Faces0), get_assoc(P, Firsts, First) ),
            Shaped),
    grouped_values(Shaped, ShapesOf),
    findall(face(First,Shapes),
            ( member([First|_], Groups),
              values_of(First, ShapesOf, Shapess),
              append(Shapess, Shapes)
            ),
            Faces),
    findall(J, ( member(J-[P1,P2], Grouped),
                 get_assoc(P1, Firsts, First), get_assoc(P2, Firsts, First) ),
            Js),
    list_to_assoc_of(Js, Gone),
    findall(side(E,First,A,B,Joint),
            ( member(side(E,P,A,B,Joint), Sides0),
              \+ ( Joint = fold(J,_,_), get_assoc(J, Gone, _) ),
              get_assoc(P, Firsts, First)
            ),
            Sides).

small_parts([], _, []).
small_parts([Piece|Pieces], Paper, Parts) :-
    piece_points(Piece, Points),
    (   fits_on(Points, Paper)
    ->  Parts = [Piece|Parts1]
    ;   Piece = piece(_, [_,_|_], _)
    ->  split_at_folds(Piece, Points, Halves),
        small_parts(Halves, Paper, Own),
        append(Own, Parts1, Parts)
    ;   split_at_line(Piece, Points, Paper, Halves),
        small_parts(Halves, Paper, Own),
        append(Own, Parts1, Parts)
    ),
    small_parts(Pieces, Paper, Parts1).


                /*******************************
                *            FOLDS             *
                *******************************/

%   split_at_folds(Piece, Points, Parts): of several places the one that gives
%   the fewest parts, then the shortest seam.

split_at_folds(Piece, Points, Parts) :-
    least_box(Points, Degrees, _, _),
    Piece = piece(_, Faces, Sides),
    fold_pairs(Sides, Folds),
    findall(cost(Count,Seam,I)-Groups,
            ( nth1(I, [0.5,0.42,0.58,0.34,0.66], At),
              face_groups(Faces, Folds, Degrees, At, Groups, Seam),
              length(Groups, Count)
            ),
            Costs0),
    keysort(Costs0, [_-Groups|_]),
    group_parts(Piece, Groups, Parts).

%   fold(P1,P2,Length): the faces on both sides of each fold.

fold_pairs(Sides, Folds) :-
    findall(J-(P-Length),
            ( member(side(_,P,_-(XA-YA),_-(XB-YB),fold(J,_,_)), Sides),
              Length is sqrt((XB-XA)**2 + (YB-YA)**2)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    findall(fold(P1,P2,Length), member(_-[P1-Length,P2-_], Grouped), Folds).

%   The faces below and above the line, as far as folds hold them together.

face_groups(Faces, Folds, Degrees, At, Groups, Seam) :-
    maplist(face_height(Degrees), Faces, Heights0),
    msort(Heights0, Heights),
    length(Heights, N),
    Cut is min(N-1, max(1, round(N*At))),
    findall(P-Half,
            ( nth1(I, Heights, _-P), ( I =< Cut -> Half = low ; Half = high ) ),
            Halves0),
    list_to_assoc(Halves0, Halves),
    findall(P1-P2, held(Folds, Halves, P1, P2), Held0),
    findall(B-A, member(A-B, Held0), Held1),
    append(Held0, Held1, Held),
    findall(P, member(face(P,_), Faces), Ps),
    components(Ps, Held, Groups),
    findall(Length, lost(Folds, Halves, Length), Lengths),
    sum_list(Lengths, Seam).

face_height(Degrees, face(P,Shapes), Height-P) :-
    Angle is Degrees*pi/180,
    findall(Along,
            ( member(Shape, Shapes),
              member(_-(X-Y), Shape),
              Along is X*cos(Angle) - Y*sin(Angle)
            ),
            Alongs),
    length(Alongs, N),
    sum_list(Alongs, Sum),
    Height is Sum/max(1, N).

held(Folds, Halves, P1, P2) :-
    member(fold(P1,P2,_), Folds),
    get_assoc(P1, Halves, Half),
    get_assoc(P2, Halves, Half).

lost(Folds, Halves, Length) :-
    member(fold(P1,P2,Length), Folds),
    get_assoc(P1, Halves, Half1),
    get_assoc(P2, Halves, Half2),
    Half1 \== Half2.

%   components(Nodes, Edges, Groups): Groups of Nodes that Edges, A-B both ways,
%   hold together, in the order of their first ones.

components(Nodes, Edges0, Groups) :-
    keysort(Edges0, Edges),
    group_pairs_by_key(Edges, Next0),
    list_to_assoc(Next0, Next),
    empty_assoc(Seen),
    foldl(component(Next), Nodes, Seen-Groups, _-[]).

component(Next, Node, Seen0-Groups0, Seen-Groups) :-
    (   get_assoc(Node, Seen0, _)
    ->  Seen = Seen0,
        Groups0 = Groups
    ;   put_assoc(Node, Seen0, true, Seen1),
        reached([Node], Next, Seen1, Seen, Group),
        Groups0 = [Group|Groups]
    ).

reached([], _, Seen, Seen, []).
reached([Node|Nodes0], Next, Seen0, Seen, [Node|Group]) :-
    (   get_assoc(Node, Next, Near)
    ->  foldl(newly_seen, Near, Seen0-Nodes0, Seen1-Nodes)
    ;   Seen1 = Seen0,
        Nodes = Nodes0
    ),
    reached(Nodes, Next, Seen1, Seen, Group).

newly_seen(Node, Seen0-Nodes, Seen-All) :-
    (   get_assoc(Node, Seen0, _)
    ->  Seen = Seen0,
        All = Nodes
    ;   put_assoc(Node, Seen0, true, Seen),
        All = [Node|Nodes]
    ).

list_to_assoc_of(Keys, Assoc) :-
    findall(Key-true, member(Key, Keys), Pairs),
    list_to_assoc(Pairs, Assoc).

%!  parted_piece(+Piece, +Folds, -Parts) is det.
%
%   Parts are what is left of Piece where Folds, the numbers of joints, do not
%   hold it together; all of them have its name.

parted_piece(Piece, Folds, Parts) :-
    Piece = piece(_, Faces, Sides),
    list_to_assoc_of(Folds, Cut),
    findall(J-P,
            ( member(side(_,P,_,_,fold(J,_,_)), Sides),
              \+ get_assoc(J, Cut, _)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    findall(Step, ( member(_-[P1,P2], Grouped),
                    ( Step = P1-P2 ; Step = P2-P1 ) ), Steps),
    findall(P, member(face(P,_), Faces), Ps),
    components(Ps, Steps, Groups),
    group_parts(Piece, Groups, Parts).

%   group_parts(Piece, Groups, Parts): a part for each of Groups, lists of
%   faces. A fold whose other side is in another part becomes a seam.

group_parts(piece(Name,Faces,Sides), Groups, Parts) :-
    findall(P-I, ( nth1(I, Groups, Ps), member(P, Ps) ), Places0),
    list_to_assoc(Places0, Places),
    findall(I-Face,
            ( member(Face, Faces),
              Face = face(P, _),
              get_assoc(P, Places, I)
            ),
            Faced),
    grouped_values(Faced, FacesOf),
    findall(J-I,
            ( member(side(_,P,_,_,fold(J,_,_)), Sides),
              get_assoc(P, Places, I)
            ),
            Folded),
    grouped_values(Folded, Folds),
    findall(I-Side,
            ( member(Side0, Sides),
              parted_side(Places, Folds, Side0, I, Side)
            ),
            Sided),
    grouped_values(Sided, SidesOf),
    findall(piece(Name,Own,OwnSides),
            ( nth1(I, Groups, _),
              values_of(I, FacesOf, Own),
              values_of(I, SidesOf, OwnSides)
            ),
            Parts).

parted_side(Places, Folds, side(E,P,A,B,Joint0), I, side(E,P,A,B,Joint)) :-
    get_assoc(P, Places, I),
    (   Joint0 = fold(J, Angle, Which),
        \+ get_assoc(J, Folds, [I,I])
    ->  Joint = seam(J, Angle, Which)
    ;   Joint = Joint0
    ).

%   grouped_values(Pairs, Assoc): from each key to its values, in their order.

grouped_values(Pairs0, Assoc) :-
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Assoc).

values_of(Key, Assoc, Values) :-
    (   get_assoc(Key, Assoc, Values0)
    ->  Values = Values0
    ;   Values = []
    ).


                /*******************************
                *        STRAIGHT LINES        *
                *******************************/

%   cut(U, V, At): the line U*X + V*Y = At. All lines of a face go through all
%   of it, so that the parts on both sides have the same corners.

split_at_line(Piece, Points, Paper, Parts) :-
    cutting_lines(Points, Paper, Cuts),
    foldl(parts_cut, Cuts, [Piece], Parts0),
    maplist(merged_sides, Parts0, Parts).

parts_cut(even(U,V,At0,Size), Parts0, Parts) :-
    findall(Along,
            ( member(Part, Parts0),
              piece_points(Part, Points),
              member(X-Y, Points),
              Along is U*X + V*Y
            ),
            Alongs),
    beside_corners(At0, Size, Alongs, At),
    Cut = cut(U, V, At),
    findall(Part, ( member(Part0, Parts0), part_cut(Cut, Part0, Part) ),
            Parts).

part_cut(Cut, piece(Name,[face(P,Shapes)],Sides), Part) :-
    findall(W-true, ( member(Shape, Shapes), member(W-_, Shape) ), Old0),
    sort(Old0, Old1),
    list_to_assoc(Old1, Old),
    member(Sense, [1,-1]),
    clipped_shapes(Shapes, Cut, Sense, Kept),
    clipped_sides(Sides, Cut, Sense, Left),
    line_sides(Kept, Old, P, Sense, New),
    append(Left, New, Own),
    shape_part(Kept, Name, P, Own, Part).

cutting_lines(Points, room(RoomW,RoomH,_), Cuts) :-
    least_box(Points, Degrees, W, H),
    Angle is Degrees*pi/180,
    Along is max(2*sign(W-0.97*max(RoomW,RoomH)),
                 ceiling(W/(0.96*max(RoomW,RoomH)))),
    Across is ceiling(H/(0.96*min(RoomW,RoomH))),
    U is cos(Angle),
    V is sin(Angle),
    MinusV is -V,
    even_cuts(U, MinusV, Points, Along, Cuts1),
    even_cuts(V, U, Points, Across, Cuts2),
    append(Cuts1, Cuts2, Cuts).

%   even_cuts(U, V, Points, N, Cuts): into N parts as wide as each other, or
%   nearly: a line goes through no corner.

even_cuts(U, V, Points, N0, Cuts) :-
    N is integer(N0),
    findall(Along, ( member(X-Y, Points), Along is U*X + V*Y ), Alongs0),
    msort(Alongs0, Alongs),
    Alongs = [Low|_],
    last(Alongs, High),
    Last is N-1,
    Size is High-Low,
    findall(even(U,V,At,Size),
            ( between(1, Last, I), At is Low + Size*I/N ),
            Cuts).

beside_corners(At0, Size, Alongs, At) :-
    between(0, 1000, I),
    At is At0 - I*0.0037*Size*(1-2*(I mod 2))/8,
    tolerance(place, Of),
    Least is Of*Size,
    \+ ( member(Along, Alongs), abs(Along-At) < Least ),
    !.

%   How far a corner is above the line; below it if Sense is -1.

height(cut(U,V,At), Sense, _-(X-Y), Height) :-
    Height is Sense*(U*X + V*Y - At).

clipped_shapes(Shapes, Cut, Sense, Kept) :-
    findall(Shape,
            ( member(Shape0, Shapes),
              clipped_shape(Shape0, Cut, Sense, Shape),
              Shape = [_,_,_|_]
            ),
            Kept).

clipped_shape(Shape, Cut, Sense, Clipped) :-
    last(Shape, Last),
    foldl(clipped_corner(Cut, Sense), Shape, Last-Clipped, _-[]).

%   Corners are kept above the line; a step across it leaves a corner on it.

clipped_corner(Cut, Sense, B, A-Out0, B-Out) :-
    height(Cut, Sense, A, HeightA),
    height(Cut, Sense, B, HeightB),
    (   HeightA*HeightB < 0
    ->  crossing(A, B, Cut, X),
        Out0 = [X|Out1]
    ;   Out0 = Out1
    ),
    (   HeightB > 0
    ->  Out1 = [B|Out]
    ;   Out1 = Out
    ).

%   The same for both ways along an edge.

crossing(A0, B0, Cut, x(WA,WB)-(X-Y)) :-
    msort([A0,B0], [A,B]),
    A = WA-(XA-YA),
    B = WB-(XB-YB),
    height(Cut, 1, A, HeightA),
    height(Cut, 1, B, HeightB),
    T is HeightA/(HeightA-HeightB),
    X is XA + T*(XB-XA),
    Y is YA + T*(YB-YA).

clipped_sides(Sides, Cut, Sense, Left) :-
    findall(Side,
            ( member(Side0, Sides), clipped_side(Side0, Cut, Sense, Side) ),
            Left).

clipped_side(side(E,P,A0,B0,Joint0), Cut, Sense, side(E,P,A,B,Joint)) :-
    height(Cut, Sense, A0, HeightA),
    height(Cut, Sense, B0, HeightB),
    (   HeightA > 0
    ->  A = A0
    ;   HeightB > 0,
        crossing(A0, B0, Cut, A)
    ),
    (   HeightB > 0
    ->  B = B0
    ;   HeightA > 0,
        crossing(A0, B0, Cut, B)
    ),
    clipped_joint(Joint0, A, B, Joint).

%   Half of a seam that a line made is a seam of its own.

clipped_joint(seam(split(_,_),Angle,Which), WA-_, WB-_,
              seam(split(W1,W2),Angle,Which)) :-
    !,
    msort([WA,WB], [W1,W2]).
clipped_joint(Joint, _, _, Joint).

%   line_sides(Shapes, Old, P, Sense, Sides): the sides on the line, between
%   corners that are not Old; one for each shape that has one.

line_sides(Shapes, Old, P, Sense, Sides) :-
    (   Sense =:= 1
    ->  Which = 1
    ;   Which = 2
    ),
    findall(side(0,P,A,B,seam(split(W1,W2),0.0,Which)),
            ( line_step(Shapes, Old, A, B),
              A = WA-_,
              B = WB-_,
              msort([WA,WB], [W1,W2])
            ),
            Sides).

line_step(Shapes, Old, A, B) :-
    member(Shape, Shapes),
    last(Shape, Last),
    append(_, [A,B|_], [Last|Shape]),
    A = WA-_,
    B = WB-_,
    \+ get_assoc(WA, Old, _),
    \+ get_assoc(WB, Old, _).

%   Where no line crosses it, a side goes on straight across the shapes of its
%   face, on both sides alike.

merged_sides(piece(Name,Faces,Sides0), piece(Name,Faces,Sides)) :-
    exclude(line_side, Sides0, Sides1),
    findall(WA-Side,
            ( member(Side, Sides0),
              line_side(Side),
              Side = side(_, _, WA-_, _, _)
            ),
            Pairs),
    list_to_assoc(Pairs, From),
    findall(W, ( member(_-Side, Pairs), straight_on(Side, From, Next),
                 Next = side(_,_,W-_,_,_) ),
            Inner0),
    sort(Inner0, Inner1),
    list_to_assoc_of(Inner1, Inner),
    findall(Side,
            ( member(W-Side0, Pairs),
              \+ get_assoc(W, Inner, _),
              run_side(Side0, From, Side)
            ),
            Sides2),
    append(Sides1, Sides2, Sides).

line_side(side(0,_,_,_,seam(split(_,_),_,_))).

straight_on(side(_,_,_-A,W-B,_), From, Next) :-
    get_assoc(W, From, Next),
    Next = side(_, _, _, _-C, _),
    A = XA-YA,
    B = XB-YB,
    C = XC-YC,
    Cross is (XB-XA)*(YC-YB) - (YB-YA)*(XC-XB),
    Size is (XC-XA)**2 + (YC-YA)**2,
    is_straight(Cross, Size).

run_side(Side0, From, side(0,P,A,B,seam(split(W1,W2),0.0,Which))) :-
    Side0 = side(_, P, A, _, seam(_,_,Which)),
    run_end(Side0, From, B),
    A = WA-_,
    B = WB-_,
    msort([WA,WB], [W1,W2]).

run_end(Side, From, End) :-
    (   straight_on(Side, From, Next)
    ->  run_end(Next, From, End)
    ;   Side = side(_, _, _, End, _)
    ).

%   shape_part(Shapes, Name, P, Sides, Part): a component of them.

shape_part(Shapes, Name, P, Sides, piece(Name,[face(P,Own)],Left)) :-
    findall(I, nth1(I, Shapes, _), Is),
    findall(Key-I, shape_key(Shapes, I, Key), Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(A-B, ( member(_-[I,J], Groups), ( A-B = I-J ; A-B = J-I ) ),
            Edges),
    components(Is, Edges, Components),
    member(Component, Components),
    findall(Shape, ( member(I, Component), nth1(I, Shapes, Shape) ), Own),
    findall(W-true, ( member(Shape, Own), member(W-_, Shape) ), Known0),
    sort(Known0, Known1),
    list_to_assoc(Known1, Known),
    corner_map(Own, Map),
    include(of_part(Known, Map), Sides, Left).

of_part(_, Map, side(_,_,_-(XA-YA),_-(XB-YB),generator(_))) :-
    !,
    X is (XA+XB)/2,
    Y is (YA+YB)/2,
    shape_at(Map, X-Y, _).
of_part(Known, _, side(_,_,WA-_,WB-_,_)) :-
    get_assoc(WA, Known, _),
    get_assoc(WB, Known, _).

shape_key(Shapes, I, Key) :-
    nth1(I, Shapes, Shape),
    last(Shape, Last),
    append(_, [A-_,B-_|_], [Last|Shape]),
    msort([A,B], Key).
