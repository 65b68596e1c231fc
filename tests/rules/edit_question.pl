:- module(sg_test_edit_question,
          [ question/1,                 % -Wrong
            forget_answers/0,
            exported/1,                 % -All
            unfit/1,                    % ?PI
            asked/1,                    % -Goal
            rendered/1,                 % -Dots
            regions_checked/1,          % -Around
            documented_words/3,         % +Name, +Arity, -Words
            argument/2,                 % +Word, -Value
            with_files/2                % +Goal0, -Goal
          ]).
/** <module> Random questions: calls of what sanggwan.pl exports, with arguments
that could be meant, by their names in the documentation.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(sanggwan)).
:- use_module(rules(rows)).
:- use_module(rules(spans)).
:- use_module(rules(topology)).
:- use_module(rules(topics), [offered/2]).
:- use_module(tests('rules/edit_attempt')).
:- use_module(tests('rules/edit_value')).

%!  question(-Wrong:list) is det.

question(Wrong) :-
    asked(Goal),
    attempt(Goal, Wrong),
    remembered(Goal).

%   remembered(Goal): the values in Goal are known by the words of its
%   arguments, so that later questions are asked about what earlier ones
%   answered: disks, scenes, facets, of this world or of it before an edit.

:- thread_local known/2.

%!  forget_answers is det.

forget_answers :-
    retractall(known(_, _)).

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
