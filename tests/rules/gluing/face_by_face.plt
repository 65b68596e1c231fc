/* Boxes glued face by face, in any order, in place and turned at random, when
   rounding has bent their faces: in each state between there are the cells that
   there are, and in the end it is what it is in any other order.
   covers: face_glue, regions_order, regions_point, regions_walk */
:- module(test_face_by_face, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/cells_edit), [place_of/3]).
:- use_module(rules(gluing/regions)).
:- use_module(rules(near), [same_part/2]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(solid/part_glue)).
:- use_module(rules(store)).
:- use_module(rules(vector)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/sample), [numbered/3]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   boxes(Name, Boxes, Volumes, Counts): as a glue of them has them; `room` has
%   a void in it.

boxes(grid, Boxes, Volumes, [27,54,36,36,1,9,9,0]) :-
    findall([1,1,1]-[X,Y,Z],
            ( member(X, [0,1]), member(Y, [0,1]), member(Z, [0,1]) ), Boxes),
    length(Volumes, 8),
    maplist(=(1), Volumes).
boxes(bricks,
      [ [2,1,1]-[0,0,0],[2,1,1]-[2,0,0],[2,1,1]-[-1,0,1],[2,1,1]-[1,0,1],
        [2,1,1]-[3,0,1],[4,2,1]-[0,1,0] ],
      [2,2,2,2,2,8], [32,58,33,33,1,7,7,0]).
boxes(stairs,
      [[3,3,1]-[0,0,0],[2,2,1]-[0,0,1],[1,1,1]-[0,0,2],[1,1,1]-[2,0,1]],
      [1,1,4,9], [27,46,24,24,1,5,5,0]).
boxes(room,
      [ [5,5,1]-[-1,-1,-1],[5,5,1]-[-1,-1,3],[1,5,3]-[-1,-1,0],
        [1,5,3]-[3,-1,0],[3,1,3]-[0,-1,0],[3,1,3]-[0,3,0] ],
      [9,9,15,15,25,25], [32,60,36,36,1,8,8,0]).

%   made(Name, Turned): the first, and the others with vertices of their own.

made(Name, Turned) :-
    boxes(Name, Boxes, _, _),
    maplist(box_faces, Boxes, Lists0),
    append(Lists0, Faces0),
    (   Turned == true
    ->  turned_faces(Faces0, Faces)
    ;   Faces = Faces0
    ),
    maplist(same_length, Lists0, Lists),
    append(Lists, Faces),
    Lists = [First|Others],
    made_soup(First, []),
    regions_made(1, _),
    maplist(faces_added, Others),
    complete_segments.

%   glued(Wanted): until no two faces can be glued.

glued(Wanted) :-
    findall(P-Q, facing(P, Q), Pairs0),
    random_permutation(Pairs0, Pairs),
    (   member(P-Q, Pairs),
        are_glued(P, Q)
    ->  volumes(Volumes),
        (   Volumes == Wanted
        ;   append(Wanted, [27], Volumes)
        ),
        !,
        glued(Wanted)
    ;   true
    ).

are_glued(P, Q) :-
    catch(glue_faces(1, P, Q, _),
          error(geometry_error(part_glue(not_glued(_, _, _, apart))), _),
          fail).

%   volumes(Volumes): of cells, in thousandths or nearer.

volumes(Volumes) :-
    regions_report(1, Report),
    \+ law_fault(Report, _, _),
    findall(Volume,
            ( member(Region, Report.regions), Region.role == cell,
              Volume is round(Region.volume*1000)/1000 ),
            Volumes0),
    msort(Volumes0, Volumes).

%   facing(P, Q): they lie in one plane within rounding, and look at each other.

facing(P, Q) :-
    p(1, P, _),
    p(1, Q, _),
    P < Q,
    plane_of(P, N1, O1),
    plane_of(Q, N2, O2),
    dot_product(N1, N2, Dot),
    same_part(Dot, -1),
    same_part(O1, -O2).

plane_of(P, N, Off) :-
    once(t(1, P, _, A, B, C)),
    maplist(place_of(1), [A,B,C], [PA,PB,PC]),
    difference(PB, PA, U),
    difference(PC, PA, W),
    cross_product(U, W, N0),
    dot_product(N0, N0, Square),
    By is 1/sqrt(float(Square)),
    scaled(By, N0, N),
    dot_product(N, PA, Off).

%   That faces were there twice is said.

:- dynamic quiet/0.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(operand(repaired(duplicate,6), 1)), warning, _) :-
    test_face_by_face:quiet.

:- begin_tests(face_by_face,
               [ setup(assertz(test_face_by_face:quiet)),
                 cleanup(retractall(test_face_by_face:quiet))
               ]).

test(any_order, [ forall(( member(Name, [grid,bricks,stairs,room]),
                           member(Turned, [false,true]),
                           numbered(3, 40, Seed) )),
                  Counts == Wanted ]) :-
    boxes(Name, _, Volumes, Wanted),
    set_random(seed(Seed)),
    in_new_world(( made(Name, Turned),
                   glued(Volumes),
                   regions_report(1, Report),
                   report_counts(Report, Counts) )).

%   Boxes all round one, each with faces of its own, read as they are: what
%   lies on each other with one border is there once, also where rounding has
%   bent it.

test(round_one, [ forall(numbered(6, 40, Seed)),
                  Cells-Counts == [9,9,9,9,9,9,27]-[32,60,36,36,1,8,8,0] ]) :-
    Boxes = [ [3,3,3]-[0,0,0],
              [3,3,1]-[0,0,3],[3,3,1]-[0,0,-1],[1,3,3]-[3,0,0],
              [1,3,3]-[-1,0,0],[3,1,3]-[0,3,0],[3,1,3]-[0,-1,0] ],
    maplist(box_faces, Boxes, Lists),
    append(Lists, Faces0),
    set_random(seed(Seed)),
    turned_faces(Faces0, Faces),
    in_new_world(( made_soup([], []),
                   faces_added(Faces),
                   regions_made(1, Report),
                   volumes(Cells),
                   report_counts(Report, Counts) )).

%   The tip of a pyramid is glued into a face; then that is glued to another
%   one, and cut by it. The tip stays in a piece.

test(point_loop,
     Before-After == [21,32,17,18,2,4,5,0]-[21,32,17,19,1,4,4,0]) :-
    box_faces([4,4,1]-[0,0,0], Plate),
    Tip = [1,1,1],
    Round = [[0,0,3],[0,2,3],[2,2,3],[2,0,3],[0,0,3]],
    findall([[Tip,A,B]], append(_, [A,B|_], Round), Sides),
    Round = [_|Base],
    box_faces([1,1,1]-[2,2,1], Box),
    in_new_world(( made_soup(Plate, []),
                   regions_made(1, _),
                   faces_added([[Base]|Sides]),
                   faces_added(Box),
                   vertex_at(Tip, V),
                   glue_mixed(1, v(V), p(2), _),
                   regions_report(1, Report0),
                   report_counts(Report0, Before),
                   once(( facing(2, Q), are_glued(2, Q) )),
                   once(lies_in(1, v(V), p(_))),
                   regions_report(1, Report),
                   report_counts(Report, After) )).

:- end_tests(face_by_face).
