/* Where operands of a tree are tangent their surfaces go on in each other, and
   there is no line; where they cross there is one, also along a generator:
   rules/picture/role.pl, operand_line.pl, c_kernels/picture/scene_lines.c. */
% covers: operand_line
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg_roots),
              [operand_lines/1, roots_alone/0, with_operand_lines/2]).
:- use_module(rules(picture/operand_line)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(store)).

:- begin_tests(tangent_line).

:- meta_predicate in_tree(+, 0).

in_tree(Tree, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, Tree)),
               evaluate,
               operand_lines(Lines),
               roots_alone,
               set_view(300, 60, 0),
               with_operand_lines(Lines,
                                  ( picture, call(Goal) )) )).

%   penetration(Edges): From-To of the edges drawn as penetration lines, the
%   ends in order.

penetration(Edges) :-
    findall(S-E, drawn(_, S, E, _, _, _, penetration), Drawn0),
    sort(Drawn0, Drawn),
    findall(Edge,
            ( member(S-E, Drawn),
              e(S, E, A, B, _),
              v(S, A, X1, Y1, Z1),
              v(S, B, X2, Y2, Z2),
              sort([p(X1,Y1,Z1),p(X2,Y2,Z2)], Edge) ),
            Edges).

edges_length(Edges, Length) :-
    aggregate_all(sum(L),
                  ( member([p(X1,Y1,Z1),p(X2,Y2,Z2)], Edges),
                    L is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2) ),
                  Length).

capsule(union([ cylinder(radius(1), height(3)),
                sphere(radius(1)),
                at([translate(0,0,3)], sphere(radius(1))) ])).

placed(Tree, Tree).
placed(Tree, at([mirror(x),rotate(x,33),translate(4,-7,0.1)], Tree)).
placed(Tree, at([scale(3,-3,3)], Tree)).
placed(Tree, union([Tree,at([translate(20,0,0)], box(size(1,1,1)))])).

test(capsule, [ forall(( capsule(Capsule), placed(Capsule, Tree) )),
                Edges == [] ]) :-
    in_tree(Tree, penetration(Edges)).

%   Its outline is one ring: no piece ends where the ball begins.

test(capsule_outline, Ends == []) :-
    capsule(Capsule),
    in_tree(Capsule,
            findall(V,
                    ( outline_end(V),
                      aggregate_all(count, outline_end(V), N),
                      N mod 2 =:= 1 ),
                    Ends)).

outline_end(V) :-
    drawn(_, S, E, _, _, visible, outline),
    e(S, E, A, B, _),
    member(V, [A,B]).

%   A torus on a cylinder that it is tangent to, as a fillet; a cone on the ball
%   that it is tangent to.

test(fillet, Edges == []) :-
    in_tree(union([ cylinder(radius(2), height(5)),
                    at([translate(0,0,5)], torus(radius(1.5), tube(0.5))),
                    at([translate(0,0,5)], cylinder(radius(1.5),
                                                    height(0.5))) ]),
            ( penetration(Edges0),
              exclude_top(Edges0, Edges) )).

%   The flat top of the torus is tangent to that of the inner cylinder.

exclude_top(Edges0, Edges) :-
    findall(Edge,
            ( member(Edge, Edges0),
              Edge = [p(X,Y,_),_],
              sqrt(X*X + Y*Y) > 1.6 ),
            Edges).

%   The inlet of a cyclone: a side of the duct is tangent to the barrel.

test(inlet, true(abs(Length-Right) < 1.0e-9)) :-
    inlet(Tree),
    in_tree(Tree,
            ( penetration(Edges),
              edges_length(Edges, Length) )),
    aggregate_all(sum(L), chord_above(L), Arc),
    Right is 2.0 + 2.0*Arc.             % the inner side, and two arcs

%   chord_above(Length): of the 40 of the barrel, of what is above y = 1, up to
%   x = 0.

chord_above(Length) :-
    between(3, 9, I),
    corner(I, X0, Y0),
    J is I+1,
    corner(J, X2, Y2),
    Part is max(0.0, (1.0-Y0)/(Y2-Y0)),
    Length is (1.0-Part)*sqrt((X2-X0)**2 + (Y2-Y0)**2).

corner(I, X, Y) :-
    X is 2.0*cos(I*pi/20.0),
    Y is 2.0*sin(I*pi/20.0).

inlet(union([ cylinder(radius(2), height(4)),
              at([translate(4,1.5,1)], box(size(8,1,2))) ])).

%   What crosses along generators is not tangent.

test(parallel_pipes, Length =:= 6.0) :-
    in_tree(union([ cylinder(radius(2), height(3)),
                    at([translate(2.5,0,0)],
                       cylinder(radius(2), height(3))) ]),
            ( penetration(Edges),
              edges_length(Edges, Length0),
              Length is round(Length0*1.0e6)/1.0e6 )).

%   Nor a ball that is a little larger, or a cone as narrow as its pipe.

test(nearly, [ forall(member(Term, [ at([translate(0,0,3)],
                                        sphere(radius(1.02))),
                                     at([translate(0,0,3)],
                                        cone(radius(1), top(0.95),
                                             height(2))) ])),
               true(N >= 40) ]) :-
    in_tree(union([cylinder(radius(1), height(3)),Term]),
            ( penetration(Edges), length(Edges, N) )).

%   One pipe in another one, turned by a little: between their facets is none.

test(one_in_another, Edges == []) :-
    in_tree(union([ cylinder(radius(1), height(3)),
                    at([translate(0,0,2),rotate(z,5)],
                       cylinder(radius(1), height(3))) ]),
            ( penetration(Edges0),
              findall(Edge,
                      ( member(Edge, Edges0),
                        Edge = [p(_,_,Z1),p(_,_,Z2)],
                        abs(Z1-Z2) > 0.01 ),
                      Edges) )).

%   Segments are bodies of their own: where they touch is a line.

test(segments, N =:= 40) :-
    new_world(World),
    in_world(World,
             ( add_primitive(cylinder(radius(1), height(3)), _),
               add_primitive(at([translate(0,0,3)], sphere(radius(1))), _),
               complete_segments,
               penetrate,
               set_view(300, 60, 0),
               picture,
               penetration(Edges),
               length(Edges, N) )).

%   Numbered points are on the lines that are drawn.

test(crossing, [ forall(member(Which-None, [capsule-true,inlet-false])),
                 true ]) :-
    once(tree(Which, Tree)),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, Tree)),
               evaluate,
               operand_lines(Lines0),
               roots_alone,
               set_view(300, 60, 0),
               with_operand_lines(Lines0, picture),
               crossing_lines(Lines0, Lines),
               length(Lines0, N0),
               length(Lines, N),
               assertion(N < N0),
               (   None == true
               ->  assertion(Lines == [])
               ;   with_operand_lines(Lines, penetration(Edges)),
                   length(Edges, Count),
                   assertion(N == Count)
               ) )).

tree(capsule, Tree) :- capsule(Tree).
tree(inlet, Tree) :- inlet(Tree).

%   The rules say the same as the kernel.

test(rule, [ forall(( capsule(Tree) ; inlet(Tree) )), ByRule == ByKernel ]) :-
    in_tree(Tree,
            ( lines(ByKernel),
              picture([method(rule)]),
              lines(ByRule) )).

lines(Lines) :-
    findall(E-Visibility-Role, drawn(_, _, E, _, _, Visibility, Role), Lines0),
    msort(Lines0, Lines).

:- end_tests(tangent_line).
