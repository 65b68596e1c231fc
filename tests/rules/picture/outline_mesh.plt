:- module(test_outline_mesh, []).
:- use_module(library(plunit)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(picture/sew), [borders_sewn/1]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/picture/outline_checked')).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).

/* The outermost outline of meshes is drawn, and visible: wherever the triangles
that are seen end, on a picture of 1000 dots, a visible line is within 2.5 dots,
but for a run of dots no longer than is said here.

    OUTLINE_VIEWS=all       from all sides, not from a few
    OUTLINE_VIEWS=N         from N random sides
*/

most_bare('suzanne.obj', 3).
most_bare('cow.obj', 3).
most_bare('beetle.obj', 3).
most_bare('teapot.obj', 0).

from(Theta, Phi) :-
    (   getenv('OUTLINE_VIEWS', Text),
        atom_number(Text, N)
    ->  set_random(seed(88)),
        between(1, N, _),
        Theta is random(3600)/10,
        Phi is random(1800)/10
    ;   getenv('OUTLINE_VIEWS', all)
    ->  (   member(Theta, [0,33,77,120,200,270,300,341]),
            member(Phi, [20,65,90,110])
        ;   member(Theta, [10,50,63,100,153,180,233,260,333]),
            member(Phi, [10,45,65,80,100,130])
        )
    ;   member(Theta-Phi, [33-65, 63-80, 300-65, 200-110, 333-10])
    ).

mesh(Name, File) :-
    most_bare(Name, _),
    atom_concat('../shared/data/meshes/', Name, Path),
    absolute_file_name(sanggwan(Path), File, []),
    exists_file(File).

no_meshes :-
    \+ mesh(_, _),
    format("outline_mesh: skipped: no ../shared/data/meshes~n").

seen(File, Pictures) :-
    in_new_world(( load_model(File),
                   findall(S, segment(S, _, _), Ss),
                   complete_segments(Ss),
                   borders_sewn(_),
                   forall(from(Theta, Phi),
                          ( set_view(Theta, Phi, 0),
                            picture([]),
                            format(atom(Name), "~w,~w", [Theta,Phi]),
                            add_outline(Pictures, Name) )) )).

:- begin_tests(outline_mesh).

test(none, condition(no_meshes)) :-
    true.
test(covered, [ forall(mesh(Name, File)), Bad == [] ]) :-
    open_outlines(Pictures),
    seen(File, Pictures),
    check_outlines(Pictures, Results),
    Results = [_|_],
    most_bare(Name, Most),
    findall(View-Run, ( member(outline(View,_,_,Run,_,_), Results),
                        Run > Most ),
            Bad).

% A boss on a plate, with fillets of eight facets, as a mesh: seen so that flats
% are nearly edge-on.
test(fillets, Bad == []) :-
    open_outlines(Pictures),
    in_new_world(( boss(Boss),
                   add_primitive(Boss, S),
                   retractall_facts(segment(S, _, _)),
                   assert_fact(segment(S, solid, mesh)),
                   complete_segments([S]),
                   forall(member(Phi, [89,89.4,89.7,89.9,90,90.05,90.2,90.6,
                                       91]),
                          ( set_view(10, Phi, 0),
                            picture([]),
                            format(atom(Name), "~w", [Phi]),
                            add_outline(Pictures, Name) )) )),
    check_outlines(Pictures, Results),
    length(Results, 9),
    findall(View-Run, ( member(outline(View,_,_,Run,_,_), Results), Run > 1 ),
            Bad).

boss(turning(outline(Points), facets(48))) :-
    findall([X,Z],
            ( member(X-Z, [0-0, 5-0, 5-0.5])
            ; between(0, 8, K), X is 1.5-0.5*sin(K*pi/16),
              Z is 1-0.5*cos(K*pi/16)
            ; between(0, 8, K), X is 0.7+0.3*cos(K*pi/16),
              Z is 2+0.3*sin(K*pi/16)
            ; X-Z = 0-2.3
            ),
            Points).

:- end_tests(outline_mesh).
