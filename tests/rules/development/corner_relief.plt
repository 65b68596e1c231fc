/* Corners of bent plates: rules/development/corner_relief.pl. */
% covers: corner_cut, flat_faces
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(development/bend)).
:- use_module(rules(development/corner_relief)).
:- use_module(rules(drawing/drawing), [write_drawing_stream/3]).
:- use_module(rules(pattern/pattern_drawing), [pattern_drawing/3]).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(unfolding/unfold)).
:- use_module(tests('rules/drawing/drawing_reader')).
:- use_module(tests('rules/sample')).

:- begin_tests(corner_relief).

:- meta_predicate plate(+, +, -, 0).

%   plate(Term, Options, D, Goal): Goal in a world where D is the pattern of
%   Term.

plate(Term, Options, D, Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(Term, S),
               complete_segments,
               unfold(S, Options, D),
               Goal )).

near(X, Y) :-
    abs(X-Y) =< 1.0e-9*(1+abs(Y)).

area(D, Area) :-
    aggregate_all(sum(Part),
                  ( t(D, _, _, A, B, C), triangle_area(D, A, B, C, Part) ),
                  Area).

triangle_area(D, A, B, C, Area) :-
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   How far the drawn side is from the inside of the bend, over the thickness.
drawn(outside, 1.0).
drawn(middle, 0.5).
drawn(inside, 0.0).

%   A tray A by B, its flanges H high: of each corner a square of W of the
%   base is cut out, and of each flange its end beyond the bends, R long and W
%   deep.
tray(100, 60, 20).
tray(81.5, 33.25, 12.0).
bends(2, 2, 0.44).
bends(1.5, 4, 0.33).
bends(3, 1, 0.5).

tray_sizes(T, R, K, Size, S, W, H) :-
    drawn(Size, Part),
    S is T*Part,
    W is pi/4*(R + K*T),
    H is R + S - W.

test(square_of_a_tray,
     [ forall(( tray(A, B, Z), bends(T, R, K), drawn(Size, _) )),
       true(near(Area, (A-2*H)*(B-2*H) - 4*W*W
                       + 2*(A+B-4*S)*(Z-H) - 8*W*R)) ]) :-
    tray_sizes(T, R, K, Size, S, W, H),
    plate(box(size(A,B,Z)),
          [removed(top),root(base),thickness(T),bend_radius(R),k_factor(K),
           size(Size)], D, area(D, Area)).

%   Without reliefs each flange is as long as between the inner sides of the
%   others. Where bends are wide they would cross (R > W): the corner of both
%   that lies on each other belongs to each by half.
test(no_relief,
     [ forall(( tray(A, B, Z), bends(T, R, K), drawn(Size, _) )),
       true(near(Area, (A-2*H)*(B-2*H) + 2*(A+B-4*S)*(Z-H) - 4*Off*Off)) ]) :-
    tray_sizes(T, R, K, Size, S, W, H),
    Off is max(0.0, R-W),
    plate(box(size(A,B,Z)),
          [removed(top),root(base),thickness(T),bend_radius(R),k_factor(K),
           size(Size),relief(none)], D, area(D, Area)).

%   All that is new in a round corner is on the circle through Q, and steps are
%   of 5 degrees at most.
test(round_of_a_tray, [forall(( bends(T, R, K), drawn(Size, _) ))]) :-
    tray_sizes(T, R, K, Size, _, W, H),
    Far is W*sqrt(2),
    plate(box(size(100,60,20)),
          [removed(top),root(base),thickness(T),bend_radius(R),k_factor(K),
           size(Size),relief(round)], D,
          findall(X-Y, ( p(D, 1, Es), member(E, Es), e(D, E, A, _, _),
                         v(D, A, X, Y, _) ), Points)),
    length(Points, N),
    N =:= 4*19,
    aggregate_all(max(X), member(X-_, Points), X1),
    aggregate_all(min(X), member(X-_, Points), X0),
    aggregate_all(max(Y), member(_-Y, Points), Y1),
    aggregate_all(min(Y), member(_-Y, Points), Y0),
    Sides = [L1,L2],
    msort([X1-X0,Y1-Y0], _),
    A1 is X1-X0,
    B1 is Y1-Y0,
    msort([A1,B1], Sides),
    near(L1, 60-2*H),
    near(L2, 100-2*H),
    forall(member(X-Y, Points),
           ( aggregate_all(min(Off),
                           ( member(CX, [X0,X1]), member(CY, [Y0,Y1]),
                             Off is sqrt((X-CX)**2 + (Y-CY)**2) ), Least),
             near(Least, Far) )).

%   Q of a corner between bends of other angles, by its distances from the two
%   bend lines; and no bend is over another one: what one takes, in the middle
%   of which its line is, is a rectangle on the straight part of both faces.
test(bends_apart, [forall(member(Relief, [square,round]))]) :-
    set_random(seed(27)),
    few(12, 80, N),
    forall(between(1, N, _),
           ( random_plate(_, Term, Removed, T, R, Size),
             options(Removed, [thickness(T),bend_radius(R),size(Size),
                               k_factor(0.4),relief(Relief)], Options),
             plate(Term, Options, D,
                   zones_apart(D, R+0.4*T, Term)) )).

zones_apart(D, Layer, Term) :-
    findall(Zone, ( joint(D, _, E, _, fold, Degrees),
                    abs(Degrees) >= 10,
                    zone(D, E, Degrees, Layer, Zone) ), Zones),
    forall(( append(_, [Zone1|Zones1], Zones), member(Zone2, Zones1) ),
           (   apart(Zone1, Zone2)
           ->  true
           ;   print_message(error, format("~q: ~q ~q", [Term,Zone1,Zone2])),
               fail
           )).

zone(D, E, Degrees, Layer, Zone) :-
    e(D, E, A, B, _),
    v(D, A, XA, YA, _),
    v(D, B, XB, YB, _),
    L is sqrt((XB-XA)**2 + (YB-YA)**2),
    W is abs(Degrees)*pi/360*Layer,
    NX is (YA-YB)/L*W,
    NY is (XB-XA)/L*W,
    findall(X-Y, ( member(Far-Out, [0-(-1),1-(-1),1-1,0-1]),
                   X is (1-Far)*XA + Far*XB + Out*NX,
                   Y is (1-Far)*YA + Far*YB + Out*NY ), Zone).

%   Convex outlines, counter-clockwise, are apart if a side of one of them has
%   all of the other beyond it.
apart(Zone1, Zone2) :-
    ( Sides = Zone1, Others = Zone2 ; Sides = Zone2, Others = Zone1 ),
    last(Sides, Last),
    append(_, [XA-YA,XB-YB|_], [Last|Sides]),
    \+ ( member(X-Y, Others),
         (XB-XA)*(Y-YA) - (YB-YA)*(X-XA) > 1.0e-7 ),
    !.

                /*******************************
                *           OUTLINES           *
                *******************************/

%   random_plate(Kind, Term, Removed, Thickness, Radius, Size)

random_plate(Kind, Term, Removed, T, R, Size) :-
    random_member(Kind, [tray,pyramid,stump,hopper,prism,box]),
    random_member(Size, [inside,middle,outside]),
    maplist(random_between, [600,500,300,5,3], [1200,1100,800,30,40], Tenths),
    findall(X, ( member(I, Tenths), X is I/10.0 ), [A,B,H,T,R]),
    random_term(Kind, A, B, H, Term, Removed).

options(none, Options, Options) :-
    !.
options(Removed, Options, [removed(Removed)|Options]).

random_term(tray, A, B, H, box(size(A,B,H)), top).
random_term(box, A, B, H, box(size(A,B,H)), side(1)).
random_term(pyramid, A, B, H, pyramid(base(A,B), height(H)), base) :-
    maybe,
    !.
random_term(pyramid, A, B, H, pyramid(base(A,B), height(H)), none).
random_term(stump, A, B, H,
            transition(base(rectangle(A,B)), top(rectangle(C,E)), height(H)),
            top) :-
    C is A*(0.6+random_float),
    E is B*(0.6+random_float).
random_term(hopper, A, B, H,
            transition(base(rectangle(C,E)), top(rectangle(A,B)), height(H),
                       shift(X,0)), top) :-
    C is A*0.6,
    E is B*0.5,
    X is H*0.5*random_float.
random_term(prism, A, B, H,
            prism(outline([[0,0],[A,0],[A,C],[E,C],[E,B],[0,B]]), height(H)),
            none) :-
    C is B*0.5,
    E is A*0.5.

%   Whatever is cut is one closed line a loop, in every format that says so,
%   and crosses neither itself nor another one. What is open are slits: lines
%   that lie apart from all closed ones, but for their ends.
test(outlines, [forall(member(Relief, [square,round,none]))]) :-
    set_random(seed(18)),
    few(20, 150, N),
    forall(between(1, N, I),
           ( random_plate(Kind, Term, Removed, T, R, Size),
             options(Removed, [thickness(T),bend_radius(R),size(Size),
                               relief(Relief)], Options),
             plate(Term, Options, D,
                   drawn_texts(D, Svg, Dxf)),
             read_svg(Svg, svg(_,_,_,_,_,Lines,_)),
             findall(Points,
                     member(line(_,visible,cut,_,_,_,_,_,Points), Lines),
                     Cuts),
             told(right_cuts(Cuts, Loops), I-Kind-Term-T-R-Size),
             read_dxf(Dxf, dxf(_,_,_,Entities)),
             findall(Closed-Count,
                     ( member(line("CUT",_,_,Closed,Vs), Entities),
                       length(Vs, Count) ), Closeds),
             findall(Count, ( member(Loop, Loops), length(Loop, M),
                              Count is M-1 ), Counts),
             findall(Count, member(closed-Count, Closeds), DxfCounts),
             told(DxfCounts == Counts, I-Kind-Closeds-Counts) )).

drawn_texts(D, Svg, Dxf) :-
    pattern_drawing([D], [], [Drawing]),
    with_output_to(string(Svg),
                   ( current_output(Out),
                     write_drawing_stream(svg, Out, [drawing(Drawing)]) )),
    with_output_to(string(Dxf),
                   ( current_output(Out2),
                     write_drawing_stream(dxf, Out2, [drawing(Drawing)]) )).

:- meta_predicate told(0, +).

told(Goal, What) :-
    (   call(Goal)
    ->  true
    ;   print_message(error, format("~q", [What])),
        fail
    ).

right_cuts(Cuts, Loops) :-
    partition(closed, Cuts, Loops, Slits),
    Loops \== [],
    findall(side(L, A-B), ( nth1(L, Loops, Loop), append(_, [A,B|_], Loop) ),
            Sides),
    findall(side(0, A-B), ( member(Slit, Slits), append(_, [A,B|_], Slit) ),
            Ends),
    append(Sides, Ends, All),
    \+ ( append(_, [side(_, Side1)|Rest], All),
         member(side(_, Side2), Rest),
         cross(Side1, Side2) ),
    %  no corner of an outline is there twice
    forall(member([_|Corners], Loops),
           ( sort(Corners, Sorted), same_length(Sorted, Corners) )).

closed([P|Points]) :-
    last(Points, P).

cross(A-B, C-D) :-
    turn(A, B, C, S1), turn(A, B, D, S2), S1*S2 < 0,
    turn(C, D, A, S3), turn(C, D, B, S4), S3*S4 < 0,
    deep(A, B, C), deep(A, B, D), deep(C, D, A), deep(C, D, B).

turn(XA-YA, XB-YB, XC-YC, Sign) :-
    Sign is sign((XB-XA)*(YC-YA) - (YB-YA)*(XC-XA)).

%   More than two thousandths of a millimetre.
deep(XA-YA, XB-YB, XC-YC) :-
    Area is abs((XB-XA)*(YC-YA) - (YB-YA)*(XC-XA)),
    Area*Area > 9*((XB-XA)**2 + (YB-YA)**2).

%   Many bends that end in one place, as those round the corners of a square
%   that becomes round, do not make the outline cross itself, whether it is
%   closed or not.

fan(open_transition(base(rectangle(120,80)), top(circle(30)), height(70),
                    shift(15,-5))).
fan(open_transition(base(rectangle(100,100)), top(circle(45)), height(40))).
fan(open_transition(base(circle(40)), top(rectangle(60,30)), height(80),
                    shift(-20,10))).
fan(transition(base(rectangle(100,100)), top(circle(30)), height(60))).

test(fans, [forall(( fan(Term), member(T, [1,2]) )),
            true(Count == 0)]) :-
    plate(Term, [thickness(T)], D, outline_crossings(D, Count)).

test(no_room, error(geometry_error(true(no_relief(1, _, _))), _)) :-
    plate(box(size(100,60,3.9)),
          [removed(top),root(base),thickness(2),bend_radius(2),size(outside)],
          _, true).
test(not_a_relief, error(type_error(oneof([square,round,none]), oval), _)) :-
    plate(box(size(100,60,20)), [thickness(2),relief(oval)], _, true).

%   A mesh has each flat face as triangles; its plate is that of the faces.

meshed(box(size(100,60,20))).
meshed(pyramid(base(100,100), height(60))).
meshed(prism(outline([[0,0],[60,0],[60,20],[20,20],[20,50],[0,50]]),
             height(30))).
meshed(prism(outline([[0,0],[160,0],[160,200],[0,200]]),
             holes([[[20,20],[140,20],[140,180],[20,180]]]), height(40))).
meshed(sheet(points([[0,0,0],[60,0,0],[60,100,0],[0,100,0],[0,0,40],
                     [0,100,40]]),
             faces([[1,2,3,4],[1,4,6,5]]))).

test(faces_of_a_mesh, [forall(( meshed(Term), member(T, [1,2]) ))]) :-
    Options = [thickness(T)],
    plate(Term, Options, D1,
          ( segment(1, Kind, _),
            area(D1, Area1),
            sides(D1, Count1),
            triangles(Places, Corners) )),
    (   Kind == surface
    ->  Mesh = sheet(points(Places), faces(Corners))
    ;   Mesh = polyhedron(points(Places), faces(Corners))
    ),
    plate(Mesh, Options, D2,
          ( area(D2, Area2),
            sides(D2, Count2),
            outline_crossings(D2, Crossings),
            findall(P, ( from_p(D2, _, 1, P, _)
                       ; p(D2, P, _), \+ from_p(D2, P, _, _, _) ), Ps) )),
    assertion(near(Area2, Area1)),
    assertion(Count2 == Count1),
    assertion(Crossings == 0),
    length(Corners, N),
    numlist(1, N, All),
    msort(Ps, Sorted),
    assertion(Sorted == All).

%   triangles(Places, Corners): those of segment 1.

triangles(Places, Corners) :-
    findall(V-[X,Y,Z], v(1, V, X, Y, Z), Vs0),
    msort(Vs0, Vs),
    pairs_keys_values(Vs, Ids, Places),
    findall([I,J,K],
            ( t(1, _, _, A, B, C),
              nth1(I, Ids, A), nth1(J, Ids, B), nth1(K, Ids, C) ),
            Corners).

%   A shop that has no square punch.
test(decided, Count == Round) :-
    Options = [removed(top),root(base),thickness(2)],
    plate(box(size(100,60,20)), [relief(round)|Options], D1, sides(D1, Round)),
    tmp_file_stream(File, Out, [extension(pl)]),
    format(Out, 'corner_relief(_, _, round).~n', []),
    close(Out),
    new_world(World),
    in_world(World,
             ( use_rules(File),
               add_primitive(box(size(100,60,20)), S),
               complete_segments,
               unfold(S, Options, D),
               sides(D, Count) )),
    delete_file(File).

sides(D, Count) :-
    aggregate_all(count, e(D, _, _, _, _), Count).

:- end_tests(corner_relief).
