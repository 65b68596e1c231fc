:- module(sg_test_edit_script,
          [ script/3,                   % +Threads, +Seed, -Wrong
            exported/1,                 % -All
            unfit/1,                    % ?PI
            asked/1,                    % -Goal
            documented_words/3,         % +Name, +Arity, -Words
            argument/2,                 % +Word, -Value
            with_files/2                % +Goal0, -Goal
          ]).
/** <module> Random edits of random worlds, and random questions about them.

A script makes a world (primitives, soups, a mesh file, trees, cut worlds,
patterns, pictures), edits it as no user would, inside transactions and outside,
and asks what sanggwan.pl exports with arguments that could be meant. It is run
for what must not happen: the end of the process, work without end, an error of
the rules themselves, a world that is not whole.

edit_fuzz.plt runs scripts in processes of their own.
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(thread)).
:- use_module(rules(sanggwan)).
:- use_module(rules(rows)).
:- use_module(rules(spans)).
:- use_module(rules(topology)).
:- use_module(rules(topics), [offered/2]).
:- use_module(rules(store), [column_domain/3]).  % not for users
:- use_module(tests('rules/soup')).
:- use_module(tests('rules/whole_world')).

%!  script(+Threads:integer, +Seed:integer, -Wrong:list) is det.
%
%   Wrong is the list of what was wrong in the script of this Seed. Each of two
%   Threads or more runs a script in the same world, at the same time.

script(1, Seed, Wrong) :-
    !,
    soup(Seed, Soup), % seeds the random numbers
    new_world(World),
    in_world(World, scene(Soup, Wrong)).
script(Threads, Seed, Wrong) :-
    soup(Seed, Soup),
    new_world(World),
    findall(sg_test_edit_script:quiet_scene(World, Soup, Own, _),
            ( between(1, Threads, I),
              Own is 1000*Seed+I ),
            Goals),
    concurrent(Threads, Goals, []),
    findall(W,
            ( member(_:quiet_scene(_, _, _, Ws), Goals),
              member(W, Ws),
              W \= dangles(_, _) ),
            Wrong1),
    in_world(World, findall(dangles(Row, Missing), dangling(Row, Missing),
                            Wrong2)),
    append(Wrong1, Wrong2, Wrong).

%   quiet_scene(World, Soup, Seed, Wrong): what a thread does. Random numbers
%   are a thread's own, so it has a seed of its own, and the same script each
%   time; what the others do meanwhile may differ.

quiet_scene(World, Soup, Seed, Wrong) :-
    set_random(seed(Seed)),
    setup_call_cleanup(
        ( open_null_stream(Null),
          set_output(Null) ),
        in_world(World, scene(Soup, Wrong)),
        close(Null)).

scene(Soup, Wrong) :-
    retractall(known(_, _)),
    random_between(1, 3, N),
    findall(x, ( between(1, N, _), made(Soup) ), _),
    random_between(1, 4, M),
    findall(W,
            ( between(1, M, _),
              round(Ws),
              member(W, Ws) ),
            Wrong).

%   round(Wrong): some edits, then some questions.

round(Wrong) :-
    random_between(1, 3, N),
    findall(W, ( between(1, N, _), change(Ws), member(W, Ws) ), Wrong1),
    random_between(0, 3, M),
    findall(W, ( between(1, M, _), question(Ws), member(W, Ws) ), Wrong2),
    findall(dangles(Row, Missing), dangling(Row, Missing), Wrong3),
    append([Wrong1, Wrong2, Wrong3], Wrong).

one_of(List, Member) :-
    length(List, N),
    N > 0,
    I is random(N),
    nth0(I, List, Member).

%   attempt(Goal, Wrong): Goal once; whether it is true does not matter.

:- meta_predicate attempt(0, -).

attempt(Goal, Wrong) :-
    (   getenv('EDIT_SAY', _)
    ->  thread_self(Me),
        format(user_error, '~w:  ~q~n', [Me,Goal])
    ;   true
    ),
    catch(( ignore(once(Goal)), Error = none ), Error, true),
    (   strip_module(Goal, _, Plain),
        is_wrong(Error)
    ->  Wrong = [raised(Plain, Error)]
    ;   Wrong = []
    ).

%   is_wrong(Error): no user should see it.

is_wrong(error(existence_error(procedure, Module:_), _)) :-
    Module \== sg_test_edit_script.
is_wrong(error(existence_error(procedure, Name/_), _)) :-
    atom(Name).
is_wrong(error(system_error(_), _)).
is_wrong(error(resource_error(_), Context)) :-
    is_dict(Context, stack_overflow).
is_wrong(error(assertion_failed(_), _)).
is_wrong(assertion_failed(_)).
is_wrong(unwind(_)).


                /*******************************
                *            MODELS            *
                *******************************/

made(Soup) :-
    one_of([ soup, primitives, primitives, primitives, tree, tree, mesh, file,
             curve, by_hand, rooms ], Kind),
    catch(ignore(made(Kind, Soup)), _, true),
    one_of([ true, true, penetrate, complete_segments, picture, evaluate,
             develop(1, _), unfold(1, _), set_view(front), regions_made(1, _),
             regions_made(22, _) ],
           Goal),
    catch(ignore(once(Goal)), _, true).

made(soup, Soup) :-
    soup_facts(Soup, Facts),
    maplist([F]>>catch(assert_fact(F), _, true), Facts).
made(primitives, _) :-
    random_between(1, 3, N),
    findall(S, ( between(1, N, _), solid(T), add_primitive(T, S) ), _).
made(curve, _) :-
    add_primitive(line(from(-3, 0.25, 0.5), to(3, 0.25, 0.75)), _).
made(tree, _) :-
    random_between(2, 3, N),
    findall(S, ( between(1, N, _), solid(T), add_primitive(T, S) ), Ss),
    random_permutation(Ss, [A,B|_]),
    one_of([union, intersection, difference, split, join, glue, glue], Name),
    Node =.. [Name,[A,B]],
    N1 is N+20,
    facts_transaction(assert_fact(segment(N1, solid, Node))),
    evaluate.
%   Boxes beside each other and through each other, glued: walls that two rooms
%   have in common, and their regions.
made(rooms, _) :-
    random_between(2, 4, N),
    findall(S,
            ( between(1, N, I),
              one_of([0, 0.5, 1, 2], Y),
              X is I*2,
              one_of([box(size(2,2,2)), box(size(2.5,1,2))], Box),
              add_primitive(at([translate(X,Y,0)], Box), S) ),
            Ss),
    one_of([solid, cells], Kind),
    facts_transaction(assert_fact(segment(22, Kind, glue(Ss)))),
    evaluate,
    regions_made(22, _).
made(mesh, Soup) :-
    soup_obj(Soup, Text),
    with_text(obj, Text, File, read_mesh(File, _)).
made(file, _) :-
    one_of([ "segment(1,solid,box(size(2,2,2))).\n\c
              segment(2,solid,at([translate(1,1,1)],cylinder(radius(1),\c
              height(2),facets(8)))).\nsegment(3,solid,difference([1,2])).\n",
             "v(1,1,0,0,0).\nv(1,2,1,0,0).\nv(1,3,0,1,0).\np(1,1,[1,2,3]).\n",
             "segment(1,surface,x).\nv(1,1,0,0,0).\nv(1,2,4,0,0).\n\c
              v(1,3,4,4,0).\nv(1,4,0,4,0).\np(1,1,[1,2,3,4]).\n\c
              view(30,60,9).\nunfolding(1,root(1)).\n",
             "param(w,2).\nparam(h,1.5*param(w)).\n\c
              segment(1,solid,box(size(param(w),param(h),2))).\n\c
              segment(2,solid,at([translate(1,0,1)],cylinder(radius(1),\c
              height(param(h)),facets(8)))).\n\c
              projection(parallel).\nlight(1,strength(2)).\n\c
              look(1,colour(rgb(9,99,199))).\ntitle_block(name,'x').\n",
             "segment(1,solid,box(size(2,2,2))).\n\c
              segment(2,solid,at([translate(2,0,0)],box(size(2,1,2)))).\n\c
              segment(22,cells,glue([1,2])).\ngluing(22,only(faces)).\n" ],
           Text),
    with_text(pl, Text, File, load_model(File)).
made(by_hand, _) :-
    forall(member(V-X-Y-Z, [1-0-0-0, 2-2-0-0, 3-0-2-0, 4-0-0-2]),
           assert_fact(v(7, V, X, Y, Z))),
    forall(nth1(E, [1-3,3-2,2-1, 1-2,2-4,4-1, 2-3,3-4,4-2, 3-1,1-4,4-3], A-B),
           assert_fact(e(7, E, A, B, 1))),
    forall(between(1, 4, P),
           ( A is 3*P-2, B is A+1, C is A+2,
             assert_fact(p(7, P, [A,B,C])) )),
    assert_fact(segment(7, solid, by_hand)).

solid(at(Steps, Solid)) :-
    steps(Steps),
    one_of([ box(size(2,2,2)), box(size(1,2,3)), box(size(1,1,1)),
             cylinder(radius(1), height(2), facets(6)),
             cone(radius(1), height(2), facets(5)),
             sphere(radius(1), facets(6)),
             pyramid(radius(1), height(2), sides(4)),
             hollow_cylinder(radius(1), thickness(0.25), height(2), facets(5)),
             torus(radius(2), tube(0.5), facets(4)) ],
           Solid).

steps([translate(X,Y,Z)|Turn]) :-
    maplist([C]>>( random_between(-4, 4, I), C is I/4.0 ), [X,Y,Z]),
    one_of([ [], [], [rotate(z,30)], [rotate(x,45)], [scale(0.5)] ], Turn).

:- meta_predicate with_text(+, +, -, 0).

with_text(Extension, Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8),extension(Extension)]),
          write(Out, Text),
          close(Out) ),
        call(Goal),
        catch(delete_file(File), _, true)).


                /*******************************
                *             EDITS            *
                *******************************/

change(Wrong) :-
    one_of([ bare, bare, bare, transaction, transaction, transaction, nested,
             undone, asked, asked, snapshot, cascade, undo, redo ],
           Kind),
    changed(Kind, Wrong).

changed(bare, Wrong) :-
    edit(Edit),
    attempt(Edit, Wrong).
changed(transaction, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(maplist(tried, Edits)), Wrong).
changed(nested, Wrong) :-
    edits(Edits1),
    edits(Edits2),
    one_of([true, fail], End),
    attempt(facts_transaction(
                ( maplist(tried, Edits1),
                  ignore(facts_transaction(( maplist(tried, Edits2), End ))) )),
            Wrong).
changed(undone, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(( maplist(tried, Edits), fail )), Wrong).
changed(asked, Wrong) :-
    edits(Edits),
    asked(Question),
    one_of([true, fail], End),
    attempt(facts_transaction(( maplist(tried, Edits), tried(Question), End )),
            Wrong).
changed(snapshot, Wrong) :-
    edits(Edits),
    asked(Question),
    attempt(facts_snapshot(( maplist(tried, Edits), tried(Question) )), Wrong).
changed(cascade, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(maplist(tried, Edits), [cascade(true)]), Wrong).
changed(undo, Wrong) :-
    attempt(facts_undo, Wrong).
changed(redo, Wrong) :-
    attempt(facts_redo, Wrong).

%   tried(Goal): errors of a user are none here.

tried(Goal) :-
    (   getenv('EDIT_SAY', _)
    ->  thread_self(Me),
        format(user_error, '~w:    ~q~n', [Me,Goal])
    ;   true
    ),
    catch(( ignore(once(Goal)), Error = none ), Error, true),
    (   is_wrong(Error)
    ->  throw(Error)
    ;   true
    ).

edits(Edits) :-
    random_between(1, 4, N),
    findall(Edit, ( between(1, N, _), edit(Edit) ), Edits).

edit(Edit) :-
    one_of([ retract, retract, retract, retract_all, of_segment, all, add, add,
             replace, replace, copy ],
           Kind),
    relation_at_hand(Name, Arity),
    functor(Fact, Name, Arity),
    edit(Kind, Fact, Edit),
    !.
edit(true).

%   Mostly the rows that a user writes.

relation_at_hand(Name, Arity) :-
    (   maybe(0.6)
    ->  one_of([v/5, e/5, p/3, segment/3], Name/Arity)
    ;   findall(N/A,
                ( relation(N, A, _), functor(F, N, A), \+ \+ call(F) ),
                All),
        one_of(All, Name/Arity)
    ).

edit(retract, Fact, Edit) :-
    row(Fact),
    one_of([ retract_fact(Fact), retract_fact(Fact), retractall_facts(Fact),
             retract_fact(Fact, [cascade(true)]) ],
           Edit).
edit(retract_all, Fact, forall(retract_fact(Fact), true)) :-
    same_relation(Fact, Row),
    row(Row),
    arg(1, Row, S),
    arg(1, Fact, S).
edit(of_segment, Fact, retractall_facts(Fact)) :-
    maybe(0.5),
    same_relation(Fact, Row),
    row(Row),
    arg(1, Row, S),
    arg(1, Fact, S).
edit(all, Fact, retractall_facts(Fact)) :-
    maybe(0.1).
edit(add, Fact, assert_fact(Fact)) :-
    plausible(Fact).
edit(replace, Fact, ( retract_fact(Fact), assert_fact(New) )) :-
    row(Fact),
    altered(Fact, New).
edit(copy, Fact, assert_fact(New)) :-
    row(Fact),
    altered(Fact, New).

same_relation(Fact, Row) :-
    functor(Fact, Name, Arity),
    functor(Row, Name, Arity).

%   row(Fact): Fact becomes a row of its relation.

row(Fact) :-
    findall(Fact, limited(Fact), Rows),
    one_of(Rows, Fact).

limited(Fact) :-
    functor(Fact, Name, Arity),
    functor(Any, Name, Arity),
    (   random(5) =\= 0
    ->  Any = Fact,
        call_few(Any)
    ;   call(Any),
        Any = Fact
    ).

call_few(Goal) :-
    State = count(0),
    call(Goal),
    arg(1, State, N0),
    N is N0+1,
    nb_setarg(1, State, N),
    ( N >= 40 -> ! ; true ).

%   altered(Fact, New): one or two of its values are others.

altered(Fact, New) :-
    Fact =.. [Name|Values],
    length(Values, Arity),
    I is random(Arity),
    J is random(Arity),
    findall(Value,
            ( nth0(K, Values, Old),
              (   ( K =:= I ; K =:= J )
              ->  value(Name, K, Value)
              ;   Value = Old
              ) ),
            News),
    New =.. [Name|News].

plausible(Fact) :-
    Fact =.. [Name|Values],
    length(Values, Arity),
    Last is Arity-1,
    findall(Value, ( between(0, Last, K), value(Name, K, Value) ), Values).

value(Name, K, Value) :-
    (   column_domain(Name, K, Domain),
        maybe(0.95)
    ->  one_of(Domain, Value)
    ;   relation_column(Name, K, _, Type, _),
        typed(Type, Value)
    ).

typed(int, Value) :-
    one_of([1,1,1,2,2,3,4,5,6,7,8,9,12,20,21,24,40,1000,0,-1,-2,2147483647,
            -2147483647,-2147483648,4294967297],
           Value).
typed(float, Value) :-
    one_of([0.0, 0.0, 1.0, 1.0, -1.0, 0.5, 2, 3.25, 1.0e-300, 1.0e-9, 1.0e89,
            -1.0e9, 0.1, 45, 30],
           Value).
typed(list, Value) :-
    random_between(0, 5, N),
    findall(I, ( between(1, N, _), typed(int, I) ), Value).
typed(atom, Value) :-
    one_of([solid, surface, curve, visible, x], Value).
typed(term, Value) :-
    one_of([ x, v(1), e(1), e(2), p(1), v(9), node(1), surfaces, 1.5, "text",
             union([1,2]), difference([1,2]), box(size(1,1,1)), lpi(1,2,3),
             lpi(e(1),s(2),t(3)), ll(e(1),e(2)), tpi(p(1),p(2),p(3)), root(1),
             cut(1), cut([1,2]), keep(2), order([2,1]), removed(1), f(f(f(x))),
             at([translate(1,0,0)], 1), [1,2,3] ],
           Value).


                /*******************************
                *           QUESTIONS          *
                *******************************/

question(Wrong) :-
    asked(Goal),
    attempt(Goal, Wrong),
    remembered(Goal).

%   remembered(Goal): the values in Goal are known by the words of its
%   arguments, so that later questions are asked about what earlier ones
%   answered: disks, scenes, facets, of this world or of it before an edit.

:- thread_local known/2.

remembered(Goal) :-
    functor(Goal, Name, Arity),
    exported(All),
    memberchk(Name/Arity, All),
    !,
    documented_words(Name, Arity, Words),
    Goal =.. [_|Values],
    forall(( nth1(I, Words, Word),
             nth1(I, Values, Value),
             ground(Value),
             term_size(Value, Size),
             Size < 1000 ),
           assertz(known(Word, Value))).
remembered(_).

%   rendered(Dots), regions_checked(Around): what the verbs render and cells ask
%   of the world, and what is round each of its edges, faces and vertices.

rendered(Dots) :-
    shading_scene(24-24, Scene),
    findall(X-Seen, ( member(X, [3.5,11.5,17.25]),
                      seen_at(Scene, X, 12.5, Seen) ), Dots),
    line_spans(Scene, 7.5, _),
    ignore(seen_layers(Scene, 11.5, 12.5, _)),
    ignore(seen_side(Scene, 11.5, 12.5, _, _)).

regions_checked(Around) :-
    findall(R-N, region_neighbour(_, R, N, _), Neighbours),
    findall(Pages, radial_cycle(_, _, _, Pages), Radial),
    findall(Vs, loop_cycle(_, _, _, Vs), Loops),
    findall(Items, disk(_, _, _, Items), Disks),
    Around = [Neighbours,Radial,Loops,Disks].

%!  asked(-Goal) is det.
%
%   Goal is a call of something that the facade exports.

asked(Goal) :-
    (   maybe(0.35)
    ->  one_of([ picture, picture, penetrate, evaluate, complete_segments,
                 findall(D, model_defect(D), _), draw(file(svg)),
                 develop(1, _), unfold(1, _), chains(_), project_world,
                 write_mesh(1, file(stl)), write_solid(1, file(obj)),
                 save_model(file(pl)), boolean(union([1,2]), 90),
                 boolean(difference([1,2]), 91), trimmed(1, [2], outside, _),
                 operand_faults(1, _), repaired(1, _),
                 winding(1, point(0,0,0), _),
                 faces_merged(1, _), show, penetration_chains(_),
                 hidden_by(_, _, _, _, _, _), explain(line(1)),
                 true_development(1, _, [], _), write_lines(file(csv)),
                 regions_made(1, _), regions_made(22, _), unglue(22),
                 glue_report(22, _), boolean(glue([1,2]), 96),
                 rendered(_), regions_checked(_) ],
               Goal0)
    ;   exported(All),
        one_of(All, Name/Arity),
        functor(Goal0, Name, Arity),
        documented_words(Name, Arity, Words),
        documented_modes(Name, Arity, Modes),
        Goal0 =.. [_|Arguments],
        (   maybe(0.3)
        ->  Open = 1
        ;   Open = 0.7
        ),
        maplist(moded_argument(Open), Modes, Words, Arguments)
    ),
    with_files(Goal0, Goal1),
    Goal = Goal1.

:- dynamic exported_/1.

%!  exported(-All:list) is det.
%
%   Name/Arity of all that users may call and a test can.

exported(All) :-
    exported_(All),
    !.
exported(All) :-
    findall(PI, offered(PI, _), Exports),
    exclude(unfit, Exports, All0),
    msort(All0, All),
    assertz(exported_(All)).

%!  unfit(?PI) is nondet.
%
%   It waits for somebody, or changes what is of the process.

unfit(repl/0).
unfit(use_rules/1).

%!  documented_words(+Name, +Arity, -Words:list(atom)) is det.
%
%   Words are the names of its arguments in its documentation, without what
%   stands around them.

documented_words(Name, Arity, Words) :-
    documented_head(Name, Arity, Head),
    !,
    Head =.. [_|Arguments],
    maplist(argument_word, Arguments, Words).
documented_words(Name, Arity, Words) :-
    relation(Name, Arity, _),
    !,
    findall(Word, relation_column(Name, _, Word, _, _), Words).
documented_words(_, Arity, Words) :-
    length(Words, Arity),
    maplist(=('X'), Words).

%   documented_modes(Name, Arity, Modes): each is `in` or `open`.

documented_modes(Name, Arity, Modes) :-
    documented_head(Name, Arity, Head),
    !,
    Head =.. [_|Arguments],
    maplist(argument_mode, Arguments, Modes).
documented_modes(_, Arity, Modes) :-
    length(Modes, Arity),
    maplist(=(open), Modes).

argument_mode(Argument, Mode) :-
    (   compound(Argument),
        functor(Argument, Sign, _),
        memberchk(Sign, [?,-,!])
    ->  Mode = open
    ;   Mode = in
    ).

%   moded_argument(Open, Mode, Word, Value): what may be an answer is mostly
%   left open, or hardly a question had one.

moded_argument(Open, Mode, _, _) :-
    Mode \== in,
    maybe(Open),
    !.
moded_argument(_, _, Word, Value) :-
    argument(Word, Value).

:- dynamic heads_read/0, head_of/3.

:- op(200, fy, sg_test_modes:(?)).
:- op(200, fy, sg_test_modes:(:)).
:- op(200, fy, sg_test_modes:(@)).
:- op(200, fy, sg_test_modes:(!)).

documented_head(Name, Arity, Head) :-
    (   heads_read
    ->  true
    ;   forall(source_heads(N, A, H), assertz(head_of(N, A, H))),
        assertz(heads_read)
    ),
    head_of(Name, Arity, Head).

source_heads(Name, Arity, Head) :-
    absolute_file_name(rules('.'), Root, [file_type(directory)]),
    member(Pattern, ['/*.pl', '/*/*.pl']),
    atom_concat(Root, Pattern, Wild),
    expand_file_name(Wild, Files),
    member(File, Files),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    string_concat("%!  ", Rest, Line),
    sub_string(Rest, Before, _, _, ") is "),
    End is Before+1,
    sub_string(Rest, 0, End, _, HeadText),
    catch(term_string(Head, HeadText,
                      [variable_names(Names),module(sg_test_modes)]), _,
          fail),
    maplist([N=N]>>true, Names),
    functor(Head, Name, Arity).

argument_word(Argument, Word) :-
    (   atom(Argument)
    ->  Word = Argument
    ;   Argument =.. [_,Inner|_]
    ->  argument_word(Inner, Word)
    ;   Word = 'X'
    ).

%!  argument(+Word, -Value) is det.
%
%   Value is a random one for an argument that is called Word.

argument(Word, Value) :-
    (   maybe(0.15)
    ->  any_value(Value)
    ;   maybe(0.4),
        findall(Known, known(Word, Known), All),
        one_of(All, Value)
    ->  true
    ;   worded(Word, Value)
    ->  true
    ;   maybe(0.5)
    ->  true
    ;   any_value(Value)
    ).

worded(Word, Value) :-
    memberchk(Word, ['S','S1','S2','Segment','D','N','Solid','S0']),
    one_of([_, 1, 1, 1, 2, 2, 3, 7, 22, 9], Value).
worded(Word, Value) :-
    memberchk(Word, ['V','V1','V2','E','E1','E2','P','P1','P2','T','C','L',
                     'A','B','HalfEdge','Facet','Vertex','Line']),
    one_of([_, _, 1, 2, 3, 5, 8, 12, h(1,1), f(1,1), s(1)-1, 1-1, v(1,1)],
           Value).
worded(Word, Value) :-
    memberchk(Word, ['Ss','Segments','Leaves','Lines','Others','Es','Ps']),
    one_of([_, [1], [1,2], [2,1], [], [1,2,3], all, [9]], Value).
worded('Pairs', Value) :-
    one_of([[1-2], [], [1-2,1-3], [1-9]], Value).
worded('Options', Value) :-
    one_of([[], [], [], [lines(all)], [crease(30)], [segments([1])],
            [views([front])], [thickness(0.1)], [tolerance(0.001)], [x]],
           Value).
worded(Word, Value) :-
    memberchk(Word, ['File','Output']),
    one_of([file(svg), file(pl), file(obj), file(stl), file(csv), file(off),
            file(pdf), file(png), file(csg)],
           Value).
worded('Input', Value) :-
    one_of([file(pl), file(obj), file(stl), file(off)], Value).
worded('Expression', Value) :-
    one_of([union([1,2]), difference([1,2]), intersection([1,2]), 1,
            union([1,difference([2,3])]), split([1,2])],
           Value).
worded('Goal', Value) :-
    one_of([true, facts_undo, retract_fact(v(1,1,_,_,_)), v(1,_,_,_,_),
            picture, may_cut(1, 2), may_hide(1, 2), owner(1, [1,2], _)],
           Value).
worded('World', World) :-
    new_world(World).
worded('Fact', Value) :-
    one_of([v(1,1,0,0,0), e(1,1,1,2,1), p(1,1,[1,2,3]), v(_,_,_,_,_),
            line(_,_,_,_,_,_,_,_,_), segment(9,solid,x)],
           Value).
worded(Word, Value) :-
    memberchk(Word, ['Primitive','Term']),
    solid(Value).
worded('Item', Value) :-
    one_of([line(1), vertex(1,1), hidden(s1e1), edge(1,1), piece(1,1),
            seam(1,1), pair(1,1,2,1), _],
           Value).
worded(Word, Value) :-
    memberchk(Word, ['X','Y','Z','Theta','Phi','Rho','From','To']),
    typed(float, Value).
worded(Word, Value) :-
    memberchk(Word, ['Point','Eye']),
    one_of([point(0,0,0), point(0.5,0.5,0.5), point(9,9,9), p(0,0,0), _],
           Value).
worded('Size', Value) :-
    one_of([16-16, 1-1, 9-24], Value).
worded('Scene', Scene) :-
    catch(shading_scene(16-12, Scene), error(_, _), fail).
worded('Files', Value) :-
    one_of([file(pl), [file(pl)], [file(obj)], [file(pl),file(obj)], []],
           Value).
worded('Kind', Value) :-
    one_of([parallel, central, solid, surface, curve, cells, edge, face],
           Value).
worded('Name', Value) :-
    one_of([front, top, iso, w, h, x, facets, depth, nodes, v, segment, _],
           Value).
worded('Relation', Value) :-
    one_of([v, e, p, t, segment, line], Value).
worded('Operation', Value) :-
    P = p(0.5,0.5,0.5),
    one_of([make(_), kill(_)], Value),
    arg(1, Value, What),
    one_of([ vertex(_,P), spur(_,1,_,P), wire(_,1,2), split(1,2,_,P),
             face(_,[[1,2,3]]), face(_,[[1,2,3,4]]), chord(1,1,3,_) ],
           What).
worded(Word, Value) :-
    memberchk(Word, ['Item1','Item2','Items']),
    one_of([v(1), v(2), e(1), e(3), p(1), p(2), [v(1),e(1)], _], Value).
worded('What', Value) :-
    one_of([[], [smooth(2)], shade, lines, all, x, _], Value).
worded('Side', Value) :-
    one_of([inside, outside, below, above, _], Value).
worded(Word, Value) :-
    memberchk(Word, ['I','J','K','R','R1','R2','F','F1','F2','Most','Row',
                     'Number','Depth','Id']),
    one_of([1, 1, 2, 3, 5, 0, 100000, _], Value).
worded(Word, Value) :-
    memberchk(Word, ['X1','X2','Y1','Y2','Nx','Ny','Nz','Length','Angle',
                     'Value']),
    typed(float, Value).
worded('View', Value) :-
    one_of([front, top, right, isometric, view(30,60,9), _], Value).

any_value(Value) :-
    one_of([ _, _, _, 1, 2, 0, -1, 3, 2147483648, 1.5, [], [1], [1,2], [_],
             [1|_], [_|_], a,
             front, solid, "text", v(1), e(1), p(1), 1-2, box(size(1,1,1)),
             p(0,0,0), union([1,2]), inf, true, all, [1-2] ],
           Value).

%!  with_files(+Goal0, -Goal) is det.
%
%   file(Extension) becomes a name in a folder for scratch, EDIT_SCRATCH.

with_files(Goal0, Goal) :-
    (   compound(Goal0)
    ->  Goal0 =.. [Name|Arguments0],
        maplist(with_file, Arguments0, Arguments),
        Goal =.. [Name|Arguments]
    ;   Goal = Goal0
    ).

with_file(Argument, File) :-
    (   is_list(Argument)
    ->  maplist(with_file, Argument, File)
    ;   nonvar(Argument),
        Argument = file(Extension)
    ->  getenv('EDIT_SCRATCH', Folder),
        format(atom(File), '~w/scratch.~w', [Folder, Extension])
    ;   File = Argument
    ).
