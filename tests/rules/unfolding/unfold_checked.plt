:- module(test_unfold_checked, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(filesex), [directory_file_path/3]).
:- use_module(rules(model/mesh), [read_mesh/2]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unfolding/unfold)).
:- use_module(tests('rules/pattern_measured')).
:- use_module(tests('rules/pattern_checked')).

/* Parts that go through each other anyhow, each trimmed by the others and laid
flat: what is outside and what is inside together is the part, and the patterns
pass the independent checker. UNFOLD_RANDOM=N: how many scenes of a
kind, 12 unless told. */

:- multifile user:message_hook/3.

user:message_hook(sanggwan(unfold(_)), informational, _).
user:message_hook(sanggwan(development(_, in_triangles(_))), warning, _).
user:message_hook(sanggwan(development(_, border(_, _))), warning, _).

scenes(N) :-
    (   getenv('UNFOLD_RANDOM', Text),
        atom_number(Text, N)
    ->  true
    ;   N = 12
    ).

scene(Kind, Seed, Terms) :-
    scenes(N),
    member(Kind, [pipes,three,cones,boxes,equal,square]),
    between(1, N, Seed),
    set_random(seed(Seed)),
    scene(Kind, Terms).

% Pipes whose axes pass each other within the radii, at any angle.
scene(pipes, [A, B]) :-
    pipe(A),
    pipe(B).
scene(three, [A, B, C]) :-
    maplist(pipe, [A,B,C]).
scene(cones, [A, B]) :-
    maplist(small, [R,Top,X,Y]),
    placed(cone(radius(R), top(Top), height(6), facets(14), shift(X, Y)), A),
    pipe(B).
scene(boxes, [A, B]) :-
    maplist(small, [X,Y,Z]),
    placed(box(size(X, Y, Z)), A),
    placed(box(size(Y, 2, 3)), B).
scene(equal, [A, B]) :-                 % axes meet: edges in one place
    random_member(D, [90, 60, 45, 30]),
    random_member(N, [12, 16, 40]),
    Pipe = at([translate(0, 0, -6)],
              cylinder(radius(1.5), height(12), facets(N))),
    random_turn(Turn),
    A = at([Turn], Pipe),
    B = at([rotate(y, D), Turn], Pipe).
scene(square, [A, B]) :-                % faces that lie in one plane
    random_member(D, [0, 90, 45]),
    A = box(size(4, 4, 2)),
    B = at([rotate(z, D), translate(1, 1, 0)], box(size(2, 3, 3))).

pipe(Pipe) :-
    small(R),
    random_between(8, 24, N),
    placed(at([translate(0, 0, -6)],
              cylinder(radius(R), height(12), facets(N))),
           Pipe).

small(X) :-
    random(F),
    X is 0.5+2*F.

placed(Term, at([Turn, translate(X, Y, Z)], Term)) :-
    random_turn(Turn),
    maplist(off, [X,Y,Z]).

off(X) :-
    random(F),
    X is F-0.5.

random_turn(rotate(axis(X, Y, Z), Degrees)) :-
    maplist(off, [X,Y,Z0]),
    Z is Z0+1,
    random(F),
    Degrees is 360*F.

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               once(Goal) )).

% trimmed_to(+S, +Side, -T): T is `nothing` if nothing is left.
trimmed_to(S, Side, T) :-
    findall(Other, ( segment(Other, solid, Term), Term \= trimmed(_, _, _),
                     Other \== S ),
            Others),
    catch(trimmed(S, Others, Side, T),
          error(geometry_error(trim(nothing_left(_, _))), _),
          T = nothing).

area(nothing, 0.0) :-
    !.
area(S, Area) :-
    aggregate_all(sum(A), ( t(S, _, _, V1, V2, V3),
                            triangle_area(S, V1, V2, V3, A) ),
                  Area).

triangle_area(S, V1, V2, V3, Area) :-
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    v(S, V3, X3, Y3, Z3),
    X is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    Y is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    Z is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
    Area is sqrt(X*X + Y*Y + Z*Z)/2.

segment_numbers(Ss) :-
    findall(S, segment(S, solid, _), Ss).

sides_make_the_part :-
    segment_numbers(Ss),
    forall(member(S, Ss),
           ( trimmed_to(S, outside, T1),
             trimmed_to(S, inside, T2),
             maplist(area, [S,T1,T2], [A,A1,A2]),
             A12 is A1+A2,
             abs(A-A12) =< 1.0e-9*A )).

% patterns_written(+Name, +Side, +Out)
patterns_written(Name, Side, Out) :-
    segment_numbers(Ss),
    forall(( member(S, Ss), trimmed_to(S, Side, T), T \== nothing ),
           one_written(Name, T, Out)).

one_written(Name, T, Out) :-
    unfold(T, D),
    pattern_measured(D, M),
    get_dict(seam, M, Seam),
    get_dict(pieces, M, Pieces),
    format(atom(Title), '~w-~d', [Name,T]),
    write_pattern(Out, Title, D, [reported(Seam,Pieces)]).

:- meta_predicate faults(1, -).

faults(Write, Faults) :-
    patterns_checked(Write, Results),
    findall(Name-Fault,
            ( member(R, Results),
              get_dict(name, R, Name),
              bad_pattern(R, 1.0e-12, Fault) ),
            Faults).

all_trimmed(Kind, Out) :-
    forall(scene(Kind, Seed, Terms),
           ( format(atom(Name), '~w-~d', [Kind,Seed]),
             in_scene(Terms,
                      forall(member(Side, [outside,inside]),
                             patterns_written(Name, Side, Out))) )).

all_penetrated(Kind, Out) :-
    forall(scene(Kind, Seed, Terms),
           penetrated_written(Kind, Seed, Terms, Out)).

penetrated_written(Kind, Seed, Terms, Out) :-
    format(atom(Name), '~w-lines-~d', [Kind,Seed]),
    in_scene(Terms,
             ( penetrate,
               segment_numbers(Ss),
               forall(member(S, Ss), one_written(Name, S, Out)) )).

% Sides of a ten thousandth of the polygons that they are of.
short_sides(Out) :-
    forall(member(Kind-Seed, [pipes-51,boxes-124]),
           ( set_random(seed(Seed)),
             scene(Kind, Terms),
             penetrated_written(Kind, Seed, Terms, Out) )).

:- meta_predicate mesh_laid(+, 1).

%   mesh_laid(+Name, :Goal): call(Goal, D) with the pattern of a mesh of
%   ../shared/data whose borders were attached, while they are.

mesh_laid(Name, Goal) :-
    mesh_file(Name, File),
    in_scene([],
             facts_snapshot(
                 ( read_mesh(File, [S]),
                   complete_segments,
                   wanted_of(S, [], Wanted),
                   part_laid(S, Wanted, [], D),
                   call(Goal, D) ))).

mesh_file(Name, File) :-
    absolute_file_name(sanggwan('../shared/data/meshes'), Folder),
    directory_file_path(Folder, Name, File),
    (   exists_file(File)
    ->  true
    ;   print_message(informational, format("skipped: ~w", [File])),
        fail
    ).

mesh_faults(Name, Faults) :-
    patterns_checked(mesh_written(Name), Results),
    findall(Fault, ( member(R, Results), bad_pattern(R, 1.0e-12, Fault) ),
            Faults).

mesh_written(Name, Out) :-
    mesh_laid(Name, test_unfold_checked:laid_written(Name, Out)).

laid_written(Name, Out, D) :-
    pattern_measured(D, M),
    write_pattern(Out, Name, D, [reported(M.seam,M.pieces)]).

:- begin_tests(unfold_checked).

% Of faces that lie on each other one stays, on either side: not so `square`.
test(sides, [ forall(( scene(Kind, _, Terms), Kind \== square )), true ]) :-
    in_scene(Terms, sides_make_the_part).
test(trimmed, [ forall(member(Kind, [pipes,three,cones,boxes,equal,square])),
                Faults == [] ]) :-
    faults(all_trimmed(Kind), Faults).
test(penetrated, [ forall(member(Kind, [pipes,cones,boxes,equal,square])),
                   Faults == [] ]) :-
    faults(all_penetrated(Kind), Faults).
% Patches with vertices of their own along their borders: these are one in the
% pattern, and no edge is lost.
test(attached, [ forall(( member(Name, ['teapot.obj','beetle.obj']),
                          mesh_file(Name, _) )),
                 Faults == [] ]) :-
    mesh_faults(Name, Faults).
test(short_sides, Faults == []) :-
    faults(short_sides, Faults).

:- end_tests(unfold_checked).
