:- module(test_true_picture, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(pure_input)).
:- use_module(library(random)).
:- use_module(rules(csg/csg_roots), [operand_lines/1, with_operand_lines/2]).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('rules/sample'), [numbered/3]).

/* Drawings of random solids against their true surfaces. tests/surface_checker
   shares nothing with the engine; it is told what the leaves are in numbers.

   With many facets every line that is drawn is where what is seen, or what lies
   behind it, changes, and every change has its line. With few facets lines are
   chords; but outlines still run on the surface. */

%   leaf(Kind, N, Term, Numbers, Reach): a random primitive of N facets, as the
%   checker has it, and how far it reaches from its origin.

leaf(box, _, box(size(A,B,C)), 0-[A,B,C], Reach) :-
    maplist(random_length(0.6, 2.6), [A,B,C]),
    Reach is sqrt(A*A/4 + B*B/4 + C*C).
leaf(ball, N, sphere(radius(R), facets(N), bands(M)), 1-[R], R) :-
    M is N//2,
    random_length(0.6, 1.4, R).
leaf(ring, N, torus(radius(R), tube(T), facets(N), sides(M)), 2-[R,T], Reach) :-
    M is N//2,
    random_length(0.8, 1.5, R),
    random_length(0.25, 0.6, T),
    Reach is R+T.
leaf(cylinder, N, cylinder(radius(R), height(H), facets(N)),
     3-[0,0,R,0,R,H,0,H], Reach) :-
    random_length(0.3, 1.2, R),
    random_length(0.8, 3, H),
    Reach is sqrt(R*R + H*H).
leaf(cone, N, cone(radius(R), height(H), facets(N)), 3-[0,0,R,0,0,H], Reach) :-
    random_length(0.5, 1.4, R),
    random_length(0.8, 3, H),
    Reach is max(R, H).
leaf(turned, N, turning(outline([[0,0],[A,0],[B,Z1],[C,Z2],[0,Z2]]), facets(N)),
     3-[0,0,A,0,B,Z1,C,Z2,0,Z2], Reach) :-
    maplist(random_length(0.3, 1.3), [A,B,C]),
    random_length(0.3, 0.9, Z1),
    random_length(0.3, 0.9, More),
    Z2 is Z1+More,
    Reach is sqrt(1.3*1.3 + Z2*Z2).

random_length(Low, High, X) :-
    random(Low, High, X0),
    X is round(X0*100)/100.0.

%   A random primitive, placed: as a term, and as a line for the checker.

placed_leaf(N, Term, told(Kind,Rows,T,Numbers), Reach) :-
    random_member(Name, [box,ball,ring,ring,cylinder,cone,turned]),
    leaf(Name, N, Primitive, Kind-Numbers, Reach0),
    random_member(A, [0,30,45,60,90,123.4]),
    random_member(B, [0,30,45,60,90,217.9]),
    maplist(random_length(-0.9, 0.9), [X,Y,Z]),
    T = [X,Y,Z],
    Term = at([rotate(x,A), rotate(z,B), translate(X,Y,Z)], Primitive),
    placing_rows(A, B, Rows),
    Reach is Reach0 + sqrt(X*X + Y*Y + Z*Z).

%   The rows of the inverse of a turn about x, then about z.

placing_rows(A, B, [CB,SB,0.0, SC,CC,SA, SS,CS,CA]) :-
    CA is cos(A*pi/180),
    SA is sin(A*pi/180),
    CB is cos(B*pi/180),
    SB is sin(B*pi/180),
    SC is -SB*CA,
    CC is CB*CA,
    SS is SB*SA,
    CS is -CB*SA.

%   random_solid(N, Seed, Term, Told, How, Reach).

random_solid(N, Seed, Term, Told, How, Reach) :-
    set_random(seed(Seed)),
    random_member(Count, [2,2,2,3]),
    length(Terms, Count),
    maplist(placed_leaf(N), Terms, Told, Reaches),
    max_list(Reaches, Reach),
    random_member(Operation-How,
                  [union-0, difference-2, difference-2, intersection-1]),
    Term =.. [Operation,Terms].

random_eye(Theta, Phi) :-
    random(0.0, 360.0, Theta),
    random(5.0, 175.0, Phi).

% A plane may leave nothing of what lies in common.
pictured(Term, Theta, Phi) :-
    assert_fact(segment(1, solid, Term)),
    evaluate,
    complete_segments,
    set_view(Theta, Phi, 0),
    operand_lines(Lines),
    with_operand_lines(Lines, picture([segments([1])])).

%   For the checker: what the model is, the eye, and the lines.

tell_model(Out, Told, How, Theta, Phi, Reach, Near) :-
    forall(member(told(Kind,Rows,T,Numbers), Told),
           ( length(Numbers, N),
             format(Out, "leaf ~w", [Kind]),
             forall(( member(List, [Rows,T,[N],Numbers]), member(X, List) ),
                    format(Out, " ~w", [X])),
             nl(Out) )),
    St is sin(Theta*pi/180),
    Ct is cos(Theta*pi/180),
    Sp is sin(Phi*pi/180),
    Cp is cos(Phi*pi/180),
    UX is -Cp*Ct,
    UY is -Cp*St,
    EX is Sp*Ct,
    EY is Sp*St,
    WX is -St,
    format(Out, "tree ~w~neye ~w ~w 0 ~w ~w ~w ~w ~w ~w~n",
           [How,WX,Ct,UX,UY,Sp,EX,EY,Cp]),
    format(Out, "round 0 0 0 ~w~nnear ~w~n", [Reach,Near]).

tell_lines(Out, Name) :-
    forall(( drawn(_, S, E, From, To, Visibility, Role),
             line_ends(S, E, X0-Y0, X1-Y1) ),
           ( flag_of(Visibility, visible, V),
             flag_of(Role, outline, O),
             X2 is X0 + From*(X1-X0),
             Y2 is Y0 + From*(Y1-Y0),
             X3 is X0 + To*(X1-X0),
             Y3 is Y0 + To*(Y1-Y0),
             format(Out, "l ~w ~w ~15g ~15g ~15g ~15g~n",
                    [V,O,X2,Y2,X3,Y3]) )),
    format(Out, "end ~w~n", [Name]).

flag_of(What, What, 1) :-
    !.
flag_of(_, _, 0).

%   checked(Tell, Results): Results are result(Name, Length, False, Outline,
%   Missing) of the pictures that Tell tells of.

:- meta_predicate checked(1, -).

checked(Tell, Results) :-
    setup_call_cleanup(tmp_file_stream(File, Out, [encoding(utf8)]),
                       call(Tell, Out), close(Out)),
    absolute_file_name(foreign('tests/surface_checker'), Program,
                       [access(execute)]),
    setup_call_cleanup(
        process_create(Program, [file(File)],
                       [stdout(pipe(Told)), process(Process)]),
        phrase_from_stream(results(Results), Told),
        ( close(Told), process_wait(Process, exit(0)), delete_file(File) )).

results([result(Name,Length,False,Outline,Missing)|Results]) -->
    string_without(`:\n`, Codes),
    ": length=", number(Length),
    " false=", number(False),
    " outline=", number(Outline),
    " missing=", integer(Missing),
    string_without(`\n`, _), "\n",
    !,
    { atom_codes(Name, Codes) },
    results(Results).
results([]) -->
    [].

%   Pictures of random solids with N facets a turn, lines to within Near of
%   their size.

tell_random(N, Few, All, Near, Out) :-
    forall(numbered(Few, All, Seed),
           in_new_world(( random_solid(N, Seed, Term, Told, How, Reach),
                          random_eye(Theta, Phi),
                          pictured(Term, Theta, Phi),
                          tell_model(Out, Told, How, Theta, Phi, Reach, Near),
                          tell_lines(Out, Seed) ))).

%   Grooves: a ring is cut out of a block. There the surface bends towards the
%   line of sight, and many of its facets are cut.

groove(N, Theta, Phi) :-
    member(N, [24,40]),
    member(Theta-Phi, [165.7-74, 300-65, 20-110]).

tell_grooves(Out) :-
    forall(groove(N, Theta, Phi),
           in_new_world(( grooved_block(N, Term, Told, Near),
                          pictured(Term, Theta, Phi),
                          tell_model(Out, Told, 2, Theta, Phi, 4, Near),
                          tell_lines(Out, N-Theta) ))).

%   Near is half of what a chord is below the ring, at most.

grooved_block(N, difference([Block,Ring]), Told, Near) :-
    M is N//2,
    Ring = at([translate(-0.7,-0.3,1.1)],
              torus(radius(1.2), tube(0.4), facets(N), sides(M))),
    Block = at([rotate(z,30)], box(size(1.8,2.3,1.1))),
    placing_rows(0, 0, Straight),
    placing_rows(0, 30, Turned),
    Told = [ told(0, Turned, [0,0,0], [1.8,2.3,1.1]),
             told(2, Straight, [-0.7,-0.3,1.1], [1.2,0.4]) ],
    Near is 0.5*(1.6*(1-cos(pi/N)) + 0.4*(1-cos(pi/M))).

:- begin_tests(true_picture).

test(many_facets, Wrong == []) :-
    checked(tell_random(120, 4, 40, 0.004), Results),
    Results = [_|_],
    findall(Result,
            ( member(Result, Results),
              Result = result(_,Length,False,_,Missing),
              ( Missing > 0 ; False > 0.004*Length ) ),
            Wrong).
test(outlines_of_few_facets, Wrong == []) :-
    checked(tell_grooves, Results),
    length(Results, 6),
    findall(Result,
            ( member(Result, Results),
              Result = result(_,Length,_,Outline,_),
              Outline > 0.005*Length ),
            Wrong).

:- end_tests(true_picture).
