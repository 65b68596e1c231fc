:- use_module(rules(picture/role)).

:- begin_tests(role).

role(Look, Role) :-
    edge_role(1, 1, Look, 30, Role).

test(penetration, R == penetration) :-
    role(look(4,1,1,1,1,90.0,false,true,true,false,false), R).
test(curve, R == curve) :-
    role(look(0,0,0,0,0,0.0,false,false,false,false,false), R).
test(border, R == border) :-
    role(look(1,1,0,1,0,0.0,false,false,false,false,false), R).
test(outline, R == outline) :-
    role(look(2,1,1,2,0,90.0,false,true,false,false,false), R).
test(outline_edge_on, R == outline) :-
    role(look(2,1,0,0,1,90.0,false,true,false,false,false), R).
test(outline_smooth, R == outline) :-
    role(look(2,1,1,0,2,5.0,false,true,false,false,false), R).
test(crease, R == crease) :-
    role(look(2,2,0,1,1,90.0,false,true,false,false,false), R).
test(crease_behind, R == crease) :-
    role(look(2,0,2,1,1,31.0,false,true,false,false,false), R).
test(smooth, R == smooth) :-
    role(look(2,2,0,1,1,29.0,false,true,false,false,false), R).
test(prism_12, R == smooth) :-
    role(look(2,2,0,1,1,30.00000000001,false,true,false,false,false), R).
test(edge, R == crease) :-
    role(look(2,2,0,1,1,0.02,true,true,false,false,false), R).
test(edge_of_outline, R == outline) :-
    role(look(2,1,1,0,2,0.02,true,true,false,false,false), R).
test(mesh, R == mesh) :-
    role(look(2,2,0,1,1,1.0e-6,false,true,false,false,false), R).
test(mesh_edge_on, R == mesh) :-
    role(look(2,0,0,0,0,0.0,false,true,false,false,false), R).
test(three_faces, R == crease) :-
    role(look(3,2,1,2,1,100.0,false,false,false,false,false), R).
test(other_crease, R == crease) :-
    edge_role(1, 1, look(2,2,0,1,1,29.0,false,true,false,false,false), 20, R).

test(ranks, all(R == [0,1,2,3,4,5,6,7])) :-
    role_rank(_, R).
test(feature, all(R == [penetration,outline,crease,border,curve,section])) :-
    role_drawn(feature, R).
test(only_penetration, all(R == [penetration])) :-
    role_drawn(penetration, R).

:- end_tests(role).
