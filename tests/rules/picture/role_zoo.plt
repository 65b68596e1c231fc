:- module(test_role_zoo, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg_roots), [with_operand_lines/2]).
:- use_module(rules(model/model)).
:- use_module(rules(store)).
:- use_module(rules(command/verbs), []).
:- use_module(rules(picture/view)).

/* Roles of the lines of models of every kind: bodies flush with each other,
   raw and united, lines inside coplanar faces, open surfaces, curves. The
   lengths of penetration lines, borders and curves are found by hand, in the
   model, whatever the view; what the other lines are follows again from the
   normals of their faces. */

%   model(Name, Text, Penetration, Border, Curve)

model(flush, "segment(1,solid,box(size(2,2,2))).
              segment(2,solid,at([translate(2,0,0)],box(size(2,2,2)))).",
      8.0, 0, 0).
model(flush_united, "segment(1,solid,box(size(2,2,2))).
              segment(2,solid,at([translate(2,0,0)],box(size(2,2,2)))).
              segment(3,solid,union([1,2])).",
      0, 0, 0).
model(step, "segment(1,solid,box(size(2,2,2))).
             segment(2,solid,at([translate(2,0,0)],box(size(2,2,1)))).",
      6.0, 0, 0).
model(step_united, "segment(1,solid,box(size(2,2,2))).
             segment(2,solid,at([translate(2,0,0)],box(size(2,2,1)))).
             segment(3,solid,union([1,2])).",
      2.0, 0, 0).
model(tower, "segment(1,solid,box(size(4,4,1))).
              segment(2,solid,at([translate(0,0,1)],box(size(1,1,1)))).",
      4.0, 0, 0).
model(tower_united, "segment(1,solid,box(size(4,4,1))).
              segment(2,solid,at([translate(0,0,1)],box(size(1,1,1)))).
              segment(3,solid,union([1,2])).",
      4.0, 0, 0).
model(flush_inside, "segment(1,solid,box(size(2,2,2))).
              segment(2,solid,at([translate(1,0,0)],box(size(2,2,1)))).",
      14.0, 0, 0).
model(flush_inside_united, "segment(1,solid,box(size(2,2,2))).
              segment(2,solid,at([translate(1,0,0)],box(size(2,2,1)))).
              segment(3,solid,union([1,2])).",
      2.0, 0, 0).
model(through, "segment(1,solid,box(size(4,4,2))).
                segment(2,solid,at([translate(0,0,-1)],box(size(1,1,4)))).",
      8.0, 0, 0).
model(hole, "segment(1,solid,box(size(4,4,2))).
             segment(2,solid,at([translate(0,0,-1)],box(size(1,1,4)))).
             segment(3,solid,difference([1,2])).",
      8.0, 0, 0).
model(round_hole, "segment(1,solid,box(size(4,4,2))).
             segment(2,solid,at([translate(0,0,-1)],
                                cylinder(radius(1),height(4),facets(24)))).
             segment(3,solid,difference([1,2])).",
      Rims, 0, 0) :-
    Rims is 96*sin(pi/24).
model(common, "segment(1,solid,box(size(2,2,2))).
               segment(2,solid,at([translate(1,1,1)],box(size(2,2,2)))).
               segment(3,solid,intersection([1,2])).",
      6.0, 0, 0).
model(coplanar, "segment(1,surface,sheet).
        v(1,1,0.0,0.0,0.0). v(1,2,2.0,0.0,0.0).
        v(1,3,2.0,2.0,0.0). v(1,4,0.0,2.0,0.0).
        e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,4,1). e(1,4,4,1,1).
        p(1,1,[1,2,3,4]).
        segment(2,surface,sheet).
        v(2,1,1.0,1.0,0.0). v(2,2,3.0,1.0,0.0).
        v(2,3,3.0,3.0,0.0). v(2,4,1.0,3.0,0.0).
        e(2,1,1,2,1). e(2,2,2,3,1). e(2,3,3,4,1). e(2,4,4,1,1).
        p(2,1,[1,2,3,4]).",
      4.0, 12.0, 0).
model(sheet_through, "segment(1,solid,box(size(2,2,2))).
        segment(2,surface,sheet).
        v(2,1,-2.0,-2.0,1.0). v(2,2,2.0,-2.0,1.0).
        v(2,3,2.0,2.0,1.0). v(2,4,-2.0,2.0,1.0).
        e(2,1,1,2,1). e(2,2,2,3,1). e(2,3,3,4,1). e(2,4,4,1,1).
        p(2,1,[1,2,3,4]).",
      8.0, 16.0, 0).
model(wire, "segment(1,solid,box(size(2,2,2))).
        segment(2,curve,wire).
        v(2,1,-2.0,0.0,1.0). v(2,2,2.0,0.0,1.0). v(2,3,2.0,3.0,1.0).
        e(2,1,1,2,1). e(2,2,2,3,1).",
      0, 0, 7.0).

%   in_picture(Text, View, Goal): of all lines, of roots alone.

:- meta_predicate in_picture(+, +, 0).

in_picture(Text, View, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
          write(Out, Text),
          close(Out) ),
        ( new_world(World),
          in_world(World,
                   ( load_model(File),
                     sg_verbs:picture_made([], [View], [lines(all)], Lines),
                     with_operand_lines(Lines, Goal) )) ),
        delete_file(File)).

%   role_length(Role, Length): in the model.

role_length(Role, Length) :-
    aggregate_all(sum(L), ( drawn(_, S, E, From, To, _, Role),
                            edge_length(S, E, L0),
                            L is (To-From)*L0 ),
                  Length).

edge_length(S, E, Length) :-
    e(S, E, V1, V2, _),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    Length is sqrt((X2-X1)**2+(Y2-Y1)**2+(Z2-Z1)**2).

near(A, B) :-
    abs(A-B) < 1.0e-6.

%   wrong_role(Theta, Phi, Fault): a drawn line whose role is not what its faces
%   say, seen from far away.

wrong_role(Theta, Phi, S-E-Role-Wanted) :-
    eye(Theta, Phi, Eye),
    drawn(_, S, E, _, _, _, Role),
    findall(Side-Normal, ( edge_face(S, E, P), face_normal(S, P, Normal),
                           side(Normal, Eye, Side) ), Faces),
    wanted_role(S, E, Faces, Wanted),
    Role \== Wanted.

wanted_role(S, E, _, penetration) :-
    e(S, E, A, B, _),
    (   line(_, S, _, A, B, _, _, _, _)
    ;   line(_, S, _, B, A, _, _, _, _)
    ;   line(_, _, _, _, _, S, _, A, B)
    ;   line(_, _, _, _, _, S, _, B, A)
    ),
    !.
wanted_role(_, _, [], curve) :-
    !.
wanted_role(_, _, [_], border) :-
    !.
wanted_role(_, _, [Side1-N1,Side2-N2], Role) :-
    (   Side1 =\= Side2
    ->  Role = outline
    ;   dot(N1, N2, Cosine),
        (   Cosine < cos(30.0001*pi/180)
        ->  Role = crease
        ;   Cosine < cos(0.01*pi/180)
        ->  Role = smooth
        ;   Role = mesh
        )
    ).

edge_face(S, E, P) :-
    edge_polygon(S, E, P).
edge_face(S, E, P) :-
    e(S, E, V1, V2, _),
    e(S, Twin, V2, V1, _),
    edge_polygon(S, Twin, P).

face_normal(S, P, n(A,B,C)) :-
    plane(S, P, A0, B0, C0, _),
    Length is sqrt(A0*A0+B0*B0+C0*C0),
    A is A0/Length, B is B0/Length, C is C0/Length.

eye(Theta, Phi, n(X,Y,Z)) :-
    T is Theta*pi/180,
    P is Phi*pi/180,
    X is sin(P)*cos(T), Y is sin(P)*sin(T), Z is cos(P).

side(Normal, Eye, Side) :-
    dot(Normal, Eye, Cosine),
    Side is sign(Cosine).

dot(n(A,B,C), n(D,E,F), Dot) :-
    Dot is A*D+B*E+C*F.

view(297.3, 61.7).
view(123.4, 80.2).
view(17.0, 141.0).

:- begin_tests(role_zoo).

test(lengths, [forall(( model(_, Text, Penetration, Border, Curve),
                        view(Theta, Phi) ))]) :-
    in_picture(Text, set_view(Theta, Phi, 0),
               ( role_length(penetration, P), role_length(border, B),
                 role_length(curve, C) )),
    maplist(near, [P,B,C], [Penetration,Border,Curve]).
test(roles, [forall(( model(Name, Text, _, _, _), view(Theta, Phi) ))]) :-
    in_picture(Text, set_view(Theta, Phi, 0),
               findall(Fault, wrong_role(Theta, Phi, Fault), Faults)),
    assertion(Name-Faults == Name-[]).

:- end_tests(role_zoo).
