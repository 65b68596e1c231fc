:- encoding(utf8).
/* Texts looked through before they are read: never thought less deep than
   Prolog reads them, whatever is in them; in every reader of texts. */
:- module(test_text_limits, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(studio/query), [read_goal/3]).
:- use_module(rules(drawing/style_file), [style_rows/2]).
:- use_module(rules(limits)).
:- use_module(rules(model/cityjson), [read_cityjson/2]).
:- use_module(rules(model/model_file), [read_model/3]).
:- use_module(rules(sheet/title_block), [title_block_read/2]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

% What texts are made of: what begins or ends something, and what looks so.

piece(Piece) :-
    member(Piece,
           [ '(', ')', '(', ')', 'f(', '[', '{', ']', '}', ',', 'a', 'b', '1',
             '0', '-', '- ', '+', ' ', '\n', '\'', '\'', '"', '`', '\\', '/',
             '*', '/*', '*/', '%', '%\n', '0\'', '0\'a', '0\'\\n', '0\'\'\'',
             '0\'\\x41\\', '0\'(', '\'\'', '\\\'', '\\x41\\', '\\x41', '.',
             '. ', '1.5', '1e5', '1.0e5', '16\'FF', '2\'1', 'x0\'', 'X', '_',
             '|', ':-', 'is ', 'dynamic ', 'é', '　', '→', '\\+', '!', ';',
             '$', '@', '1_000', '1 000', '0x1F', '0b1', '1r3', '10\'a',
             '\'/*\'', '+/*', '0\'\\\\', '\\\\', '0.', 'a.' ]).

random_text(Pieces, Text) :-
    random_between(1, 12, Length),
    length(Some, Length),
    maplist(random_of(Pieces), Some),
    atomic_list_concat(Some, Middle),
    random_member(Before-After, [''-'', ''-'', 'f('-')', '['-',a]']),
    format(string(Text), "~w~w~w .\n", [Before, Middle, After]).

random_of(Pieces, Piece) :-
    random_member(Piece, Pieces).

term_depth(Term, 1) :-
    \+ compound(Term),
    !.
term_depth(Term, Depth) :-
    (   Term = [_|_]
    ->  list_parts(Term, Parts)
    ;   compound_name_arguments(Term, _, Parts)
    ),
    maplist(term_depth, Parts, Depths),
    max_list([0|Depths], Within),
    Depth is Within+1.

list_parts(List, Parts) :-
    (   nonvar(List),
        List = [Part|List1]
    ->  Parts = [Part|Parts1],
        list_parts(List1, Parts1)
    ;   Parts = [List]
    ).

%   deepest(Text, Deepest): of the terms that Prolog reads from it to its end.

deepest(Text, Deepest) :-
    setup_call_cleanup(
        open_string(Text, Stream),
        ( deepest(Stream, 0, Deepest), Deepest > 0 ),
        close(Stream)).

deepest(Stream, Deepest0, Deepest) :-
    catch(read_term(Stream, Term,
                    [ module(sg_model_syntax), cycles(false),
                      dotlists(false), var_prefix(false),
                      syntax_errors(error)
                    ]), error(_, _), fail),
    (   Term == end_of_file
    ->  Deepest = Deepest0
    ;   term_depth(Term, Depth),
        Deepest1 is max(Deepest0, Depth),
        deepest(Stream, Deepest1, Deepest)
    ).

thought_deeper(Text, Depth) :-
    Depth1 is Depth-1,
    (   Depth1 =:= 0
    ->  true
    ;   sg_kernel_file:text_fault(facts, Text,
                                  limits(Depth1, 9, 999, 999, 9999, 9), _)
    ).

% The cases that are read count; most random texts are not.

cases(N) :-
    (   getenv('TEXT_CASES', Text)
    ->  atom_number(Text, N)
    ;   N = 20000
    ).

:- multifile user:message_hook/3.

user:message_hook(_, warning, _) :-
    test_text_limits:fuzzing.

:- dynamic fuzzing/0.

:- begin_tests(text_limits,
               [ setup(asserta(test_text_limits:fuzzing)),
                 cleanup(retractall(test_text_limits:fuzzing))
               ]).

test(never_less_deep_than_read, Wrong == []) :-
    set_random(seed(20261122)),
    cases(N),
    findall(Piece, piece(Piece), Pieces),
    findall(Text-Found,
            ( between(1, N, _),
              random_text(Pieces, Text),
              deepest(Text, Depth),
              (   thought_deeper(Text, Depth)
              ->  Found = fine
              ;   Found = Depth
              )
            ), Read),
    length(Read, Count),
    format(user_error, "~ncounted: ~D of ~D random texts were read~n",
           [Count, N]),
    exclude(fine, Read, Wrong),
    assertion(Count > N // 50).

fine(_-fine).

% Every reader of texts, every limit.

beyond(depth, Text) :-
    repeated(`[`, 200, Opening),
    repeated(`]`, 200, Closing),
    format(string(Text), "p(1, 1, ~s1~s).~n", [Opening, Closing]).
beyond(depth, Text) :-
    repeated(`- `, 200, Signs),
    format(string(Text), "v(1, 1, ~s1, 0, 0).~n", [Signs]).
beyond(depth, Text) :-
    repeated(`f(`, 200, Opening),
    repeated(`)`, 200, Closing),
    format(string(Text), "title_block(name, ~sa~s).~n", [Opening, Closing]).
beyond(digits, Text) :-
    repeated(`9`, 2001, Digits),
    format(string(Text), "v(1, 1, ~s, 0, 0).~n", [Digits]).
beyond(name, Text) :-
    repeated(`n`, 65537, Letters),
    format(string(Text), "segment(1, solid, '~s').~n", [Letters]).
beyond(name, Text) :-
    repeated(`\\n`, 40000, Escapes),
    format(string(Text), "segment(1, solid, \"~s\").~n", [Escapes]).

repeated(Codes, N, All) :-
    findall(Codes, between(1, N, _), Lists),
    append(Lists, All).

with_text(Ending, Text, Goal, File) :-
    tmp_file_stream(File, Stream, [encoding(utf8), extension(Ending)]),
    format(Stream, "~s", [Text]),
    close(Stream),
    call_cleanup(once(Goal), delete_file(File)).

reader(File, in_new_world(read_model(File, [], _))).
reader(File, style_rows(File, _)).
reader(File, title_block_read(File, _)).
reader(File, in_new_world(use_rules(File))).

%   json_beyond(Name, Text): of CityJSON.

json_beyond(Name, Text) :-
    member(Name-Before-Codes-N-After,
           [ depth-""-`[`-200-"", depth-"{\"x\":"-`[{"a":`-100-"",
             depth-"// \"\n"-`[`-200-"", digits-"["-`9`-2001-"]",
             name-"[\""-`n`-65537-"\"]" ]),
    repeated(Codes, N, Many),
    format(string(Text), "~s~s~s", [Before,Many,After]).

test(every_reader, Wrong == []) :-
    findall(Name-Reader,
            ( beyond(Name, Text),
              reader(File, Reader),
              \+ ( Reader = in_new_world(use_rules(_)),
                   \+ sub_string(Text, _, _, _, "[["),
                   \+ sub_string(Text, _, _, _, "f(f(") ),
              with_text(pl, Text, refusal(Reader, What), File),
              What \= limit(Name, _)
            ), Wrong).
test(cityjson, Wrong == []) :-
    findall(Name-What,
            ( json_beyond(Name, Text),
              with_text(json, Text,
                        refusal(in_new_world(read_cityjson(File, [])), What),
                        File),
              What \= limit(Name, _)
            ), Wrong).
test(goals, Wrong == []) :-
    findall(Name,
            ( beyond(Name, Fact),
              \+ sub_string(Fact, _, _, _, "- -"),
              sub_string(Fact, 0, _, 2, Text),
              catch(( read_goal(Text, _, _), What = read ),
                    error(usage_error(bad_goal(_, What)), _), true),
              What \= limit(Name, _)
            ), Wrong).

refusal(Goal, What) :-
    catch(( Goal, What = read ),
          error(model_error(What), location(_, _, _)), true).

test(a_limit_can_be_raised,
     [ cleanup(set_limit(digits, 2000)), true(What \= limit(_, _)) ]) :-
    set_limit(digits, 3000),
    once(beyond(digits, Text)),
    with_text(pl, Text, refusal(in_new_world(read_model(File, [], _)), What),
              File).
test(a_limit_has_a_name, error(domain_error(limit, nothing), _)) :-
    set_limit(nothing, 3).
test(a_limit_is_positive, error(type_error(_, 0), _)) :-
    set_limit(depth, 0).

:- end_tests(text_limits).
