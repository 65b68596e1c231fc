:- module(test_self_cut, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(rules(command/check)).
:- use_module(rules(model/integrity)).
:- use_module(rules(kernel), [self_meetings/2]).
:- use_module(rules(model/mesh)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(command/report)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/penetration/oracle')).
:- use_module(tests('rules/shells')).

/* Self-penetration: every kind once, by hand; random soups of triangles on a
   coarse grid against the oracle's rational arithmetic, pair by pair; and what
   must not be found. */

%   soup(+Points, +Faces, :Goal): in a world with one surface, its corners at
%   the points X-Y-Z.

:- meta_predicate soup(+, +, 0).

soup(Points, Faces, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, soup)),
               forall(nth1(V, Points, X-Y-Z), assert_fact(v(1, V, X, Y, Z))),
               foldl(face, Faces, 1-1, _),
               complete_segments,
               Goal )).

face(Vs, P-E0, P1-E) :-
    Vs = [V|Rest],
    append(Rest, [V], Nexts),
    foldl(edge, Vs, Nexts, Es, E0, E),
    assert_fact(p(1, P, Es)),
    P1 is P+1.

edge(A, B, E, E, E1) :-
    assert_fact(e(1, E, A, B, 1)),
    E1 is E+1.

meetings(Points, Faces, Found) :-
    soup(Points, Faces,
         ( self_meetings(1000000, [self(1, _, Meetings)]),
           findall(Kind-P1-P2, member(meeting(Kind, P1, P2, _, _, _), Meetings),
                   Found) )).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(no_area(_, _, _)), warning, _).

%   copied_shells(-Shells): some boxes and tetrahedra, each so often, in any
%   order.

copied_shells(Shells) :-
    random_between(1, 3, N),
    findall(Shell,
            ( between(1, N, _),
              copied_shell(One),
              random_between(1, 9, Copies),
              between(1, Copies, _),
              Shell = One ),
            Shells0),
    random_permutation(Shells0, Shells).

copied_shell(at([Turn,translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist([N]>>random_between(1, 3, N), [A,B,C]),
    maplist([N]>>random_between(0, 2, N), [X,Y,Z]),
    random_member(Turn, [rotate(x,0),rotate(x,90),rotate(z,20)]).

%   shells_on_one_polygon(-Shells): pyramids up and down, boxes and prisms, many
%   of which have their floors or roofs in common.

shells_on_one_polygon(Shells) :-
    random_between(4, 16, N),
    length(Shells, N),
    maplist(shell_on_one_polygon, Shells).

shell_on_one_polygon(at([Turn,translate(0,0,Z)], Shell)) :-
    random_member(Z, [0,0,0,2]),
    random_member(Turn, [rotate(z,0),rotate(z,0),rotate(x,180)]),
    random_between(1, 4, H),
    random_member(Shell, [ cone(radius(1), height(H), facets(4)),
                           cone(radius(1), height(H), facets(4)),
                           cylinder(radius(1), height(H), facets(4)),
                           box(size(1,1,H)) ]).

%   counted_as_all(-N): N meetings are counted, and the first of each kind
%   listed, as when all are listed.

counted_as_all(N) :-
    self_meetings(1000000, [self(1, Counts, All)]),
    forall(member(Few, [0,1,3]),
           ( self_meetings(Few, [self(1, Counts, Listed)]),
             findall(Meeting, first_of_kind(Few, All, Meeting), Wanted0),
             msort(Wanted0, Wanted),
             msort(Listed, Wanted) )),
    pairs_values(Counts, Ns),
    sum_list(Ns, N).

first_of_kind(Few, All, Meeting) :-
    member(Kind, [self_penetration,self_overlap,self_touching]),
    findall(M, ( member(M, All), arg(1, M, Kind) ), Ms),
    nth1(I, Ms, Meeting),
    I =< Few.

/* - - - the oracle - - - */

%   oracle_kind(+Faces, +Points, +P1, +P2, -Kind): what two triangles have in
%   common beyond the corners and the edge they share; fails if nothing.

oracle_kind(Points, Face1, Face2, Kind) :-
    maplist(corner(Points), Face1, C1),
    maplist(corner(Points), Face2, C2),
    T1 =.. [tri|C1],
    T2 =.. [tri|C2],
    triangles_common(T1, T2, Common, Pieces0),
    Pieces0 \== [],
    intersection(C1, C2, Shared),
    (   Common == coplanar
    ->  oracle_coplanar(T1, T2, C1, C2, Shared, Pieces0, Kind)
    ;   Pieces0 = [P-Q],
        oracle_crossing(T1, T2, C1, C2, Shared, P-Q, Kind)
    ).

corner(Points, V, p(X,Y,Z)) :-
    nth1(V, Points, X-Y-Z).

oracle_crossing(_, _, C1, C2, Shared, P-Q, Kind) :-
    \+ explained(Shared, P-Q),
    (   P \== Q,
        \+ on_a_side(C1, P-Q),
        \+ on_a_side(C2, P-Q)
    ->  Kind = self_penetration
    ;   Kind = self_touching
    ).

explained([P], P-P).
explained([A,B], P-Q) :-
    msort([A,B], [P,Q]).

on_a_side([A,B,C], P-Q) :-
    member(U-W, [A-B,B-C,C-A]),
    on_line(U, W, P),
    on_line(U, W, Q),
    !.

on_line(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    0 =:= (Y2-Y1)*(Z-Z1)-(Z2-Z1)*(Y-Y1),
    0 =:= (Z2-Z1)*(X-X1)-(X2-X1)*(Z-Z1),
    0 =:= (X2-X1)*(Y-Y1)-(Y2-Y1)*(X-X1).

%   In one plane: the ends of what is common span an area, a line or a point.

oracle_coplanar(_, _, _, _, Shared, Pieces, Kind) :-
    findall(P, ( member(A-B, Pieces), member(P, [A,B]) ), Ps0),
    sort(Ps0, Ps),
    (   Ps = [P,Q,R|More],
        member(Far, [R|More]),
        \+ on_line(P, Q, Far)
    ->  Kind = self_overlap
    ;   last(Ps, Last),
        Ps = [First|_],
        \+ explained(Shared, First-Last),
        Kind = self_touching
    ).

random_soup(Seed, Points, Faces) :-
    set_random(seed(Seed)),
    N is 5+random(5),
    length(Points0, N),
    maplist(grid_point(Seed), Points0),
    sort(Points0, Points),
    length(Points, M),
    K is 4+random(4),
    length(Faces0, K),
    maplist(random_face(M), Faces0),
    include(has_area(Points), Faces0, Faces).

grid_point(Seed, X-Y-Z) :-
    X is random(4),
    Y is random(4),
    (   Seed mod 3 =:= 0
    ->  Z = 0
    ;   Z is random(3)
    ).

random_face(N, [A,B,C]) :-
    A is 1+random(N),
    B is 1+random(N),
    C is 1+random(N).

has_area(Points, Face) :-
    maplist(corner(Points), Face, [A,B,C]),
    A \== B, B \== C, C \== A,
    \+ on_line(A, B, C).

%   An edge in a face whose triangles are on both sides of it goes through; the
%   oracle sees one pair at a time, so these are left out.

agrees(Points, Faces, Tally0, Tally) :-
    meetings(Points, Faces, Found),
    findall(Kind-P1-P2,
            ( nth1(P1, Faces, F1), nth1(P2, Faces, F2), P1 < P2,
              oracle_kind(Points, F1, F2, Kind) ),
            Expected0),
    maplist(kind_of_pair, Found, Pairs),
    maplist(kind_of_pair, Expected0, Pairs0),
    msort(Pairs, Sorted),
    msort(Pairs0, Sorted),
    forall(( member(Kind-P-Q, Expected0), \+ memberchk(Kind-P-Q, Found) ),
           ( Kind == self_touching, memberchk(self_penetration-P-Q, Found) )),
    foldl(counted, Expected0, Tally0, Tally).

kind_of_pair(_-P-Q, P-Q).

counted(Kind-_-_, Tally0, Tally) :-
    selectchk(Kind-N, Tally0, Rest),
    N1 is N+1,
    Tally = [Kind-N1|Rest].

:- begin_tests(self_cut).

test(nothing, Ms == []) :-
    meetings([0-0-0, 1-0-0, 0-1-0, 0-0-1],
             [[1,3,2], [1,2,4], [2,3,4], [3,1,4]], Ms).
test(through, Ms == [self_penetration-1-2]) :-
    meetings([0-0-0, 3-0-0, 0-3-0, 1-1-(-1), 1-1-1, 5-5-0],
             [[1,2,3], [4,5,6]], Ms).
test(a_corner_touches_a_face, Ms == [self_touching-1-2]) :-
    meetings([0-0-0, 3-0-0, 0-3-0, 1-1-0, 1-1-1, 5-5-1],
             [[1,2,3], [4,5,6]], Ms).
test(an_edge_touches_a_face, Ms == [self_touching-1-2]) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 1-1-0, 2-1-0, 1-1-1],
             [[1,2,3], [4,5,6]], Ms).
test(an_edge_in_a_face_with_sheets_on_both_sides,
     Ms == [self_penetration-1-2, self_penetration-1-3]) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 1-1-0, 2-1-0, 1-1-1, 1-1-(-1)],
             [[1,2,3], [4,5,6], [5,4,7]], Ms).
test(folded_over, Ms == [self_overlap-1-2]) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 1-1-0], [[1,2,3], [2,1,4]], Ms).
test(folded_at_a_corner, Ms == [self_overlap-1-2]) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 2-1-0, 1-2-0], [[1,2,3], [1,4,5]], Ms).
test(one_face_twice, Ms == [self_overlap-1-2]) :-
    meetings([0-0-0, 4-0-0, 0-4-0], [[1,2,3], [1,2,3]], Ms).
test(through_a_neighbour, Ms == [self_penetration-1-2]) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 2-1-(-1), 2-1-1], [[1,2,3], [1,4,5]], Ms).
test(vertices_in_one_place_are_one, Ms == []) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 0-0-0, 4-0-0, 0-0-4],
             [[1,2,3], [5,4,6]], Ms).
test(no_area_no_meeting, Ms == []) :-
    meetings([0-0-0, 4-0-0, 0-4-0, 1-1-(-1), 1-1-0, 1-1-1],
             [[1,2,3], [4,5,6]], Ms).
test(grid_soups_are_as_the_oracle_says, Enough == true) :-
    numlist(1, 900, Seeds),
    foldl([Seed,T0,T]>>( random_soup(Seed, Points, Faces),
                         (   agrees(Points, Faces, T0, T)
                         ->  true
                         ;   format(user_error, "seed ~d~n", [Seed]),
                             fail
                         ) ),
          Seeds,
          [self_penetration-0, self_overlap-0, self_touching-0], Tally),
    (   forall(member(_-N, Tally), N > 200)
    ->  Enough = true
    ;   Enough = Tally
    ).

%   Quadrangles turned by any angle are no longer flat in doubles.

test(turned_boxes_have_none, Bad == []) :-
    findall(Angle-Ms,
            ( between(1, 60, I),
              Angle is I*5.9,
              new_world(World),
              in_world(World,
                       ( add_primitive(at([rotate(x,Angle), rotate(z,33.3)],
                                          box(size(3,2,1))), _),
                         complete_segments,
                         self_meetings(9, [self(_, _, Ms)]) )),
              Ms \== [] ),
            Bad).

%   Penetrated polygons have rounded vertices along lines that were straight.

test(penetrated_boxes_have_none, Bad == []) :-
    findall(Angle-Ms,
            ( between(1, 40, I),
              Angle is I*8.7,
              new_world(World),
              in_world(World,
                       ( add_primitive(at([rotate(x,Angle), rotate(z,33.3)],
                                          box(size(3,2,1))), _),
                         add_primitive(at([rotate(y,Angle), translate(0.3,0,0)],
                                          cylinder(radius(0.7), height(3),
                                                   facets(9))), _),
                         complete_segments,
                         penetrate,
                         self_meetings(9, Selves) )),
              member(self(_, _, Ms), Selves),
              Ms \== [] ),
            Bad).

%   Of equal shells a few are asked about: what they count and list is that of
%   all, and some are left out.

test(equal_shells_count_as_all_do, true(Most > 60)) :-
    numlist(1, 40, Seeds),
    foldl([Seed,M0,M]>>( set_random(seed(Seed)),
                         copied_shells(Shells),
                         one_segment(Shells, counted_as_all(N)),
                         M is max(M0, N) ),
          Seeds, 0, Most).

%   The same of equal polygons of shells that are not equal.

test(equal_polygons_count_as_all_do, true(Most > 60)) :-
    numlist(1, 40, Seeds),
    foldl([Seed,M0,M]>>( set_random(seed(Seed)),
                         shells_on_one_polygon(Shells),
                         one_segment(Shells, counted_as_all(N)),
                         M is max(M0, N) ),
          Seeds, 0, Most).
test(many_pyramids_on_one_square, N == 4950) :-
    findall(Pyramid,
            ( between(1, 100, I), H is 1+I/8,
              Pyramid = cone(radius(1), height(H), facets(4)) ),
            Pyramids),
    one_segment(Pyramids,
                ( self_meetings(3, [self(1, Counts, Listed)]),
                  Counts = [self_overlap-N],
                  length(Listed, 3) )).

test(defects, Ds == [self_penetration(1, 1, 2)]) :-
    soup([0-0-0, 3-0-0, 0-3-0, 1-1-(-1), 1-1-1, 5-5-0], [[1,2,3], [4,5,6]],
         findall(self_penetration(S, P, Q),
                 model_defect(self_penetration(S, P, Q)), Ds)).
test(report, F-K-Ps-At == 1-self_penetration-[1,2]-true) :-
    soup([0-0-0, 3-0-0, 0-3-0, 1-1-(-1), 1-1-1, 5-5-0], [[1,2,3], [4,5,6]],
         ( check_report(Report),
           report_faults(Report, F),
           Report.segments = [Segment],
           Segment.meetings = [Meeting],
           K = Meeting.kind,
           Ps = Meeting.polygons,
           Meeting.at = [X,Y,Z],
           ( abs(Z) =< 1.0e-9, X >= 1, Y >= 1 -> At = true ; At = [X,Y,Z] ),
           with_output_to(string(Text), print_report(text, Report)) )),
    once(sub_string(Text, _, _, _, "self_penetration: polygons 1 and 2")).

:- end_tests(self_cut).
