:- encoding(utf8).
:- module(test_manifest, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(generator)).
:- use_module(rules(batch/job_name)).
:- use_module(rules(batch/job_names)).
:- use_module(rules(batch/manifest)).
:- use_module(rules(command/arguments)).
:- use_module(rules(command/usage)).

% jobs(+Text, +Ending, -Jobs): of a manifest in a file of its own, Name-Options.
jobs(Text, Ending, Jobs) :-
    with_file(Text, Ending, File,
              findall(Name-Options,
                      with_jobs(File, Name, Options),
                      Jobs)).

with_jobs(File, Name, Options) :-
    sg_manifest_tools(Tools),
    with_manifest(File, Tools, Manifest,
                  ( jobs_checked(Manifest, false, _),
                    findall(N-O, manifest_job(Manifest, false,
                                              job(_, N, _, _, _, O, _, _)),
                            All) )),
    member(Name-Options, All).

sg_manifest_tools(tools(sg_usage:job_options, sg_arguments:parsed_arguments,
                        [])).

with_file(Text, Ending, File, Goal) :-
    tmp_file_stream(Path, Out, [encoding(utf8), extension(Ending)]),
    write(Out, Text),
    close(Out),
    File = Path,
    call_cleanup(Goal, delete_file(Path)).

names(Text, Names) :-
    jobs(Text, pl, Jobs),
    findall(Name, member(Name-_, Jobs), Names).

cube(File) :-
    absolute_file_name('facts/cube.pl', File).

% fault(+Text, -What): what is wrong with a manifest.
fault(Text, What) :-
    catch(( jobs(Text, pl, _), What = none ),
          error(model_error(manifest(What)), location(_, _, _)), true).

% fault_place(+Text, -What): with its line and column.
fault_place(Text, What/(Line-Column)) :-
    catch(( jobs(Text, pl, _), What = none ),
          error(model_error(manifest(What)), location(_, Line, Column)), true).

template(Head, Generators, Text) :-
    cube(Cube),
    format(string(Text), "job(~w, check, ['~w'], []) @ ~w.",
           [Head, Cube, Generators]).

% row_text(-Text, -Ending, -Values): of a table with the columns n and r.
row_text("n,r\na,30.5\n\"b,c\",4\n", csv, [30.5-a, 4-'b,c']).
row_text("n;r\na;30,5\nb;-4,25\n\"c;d\";7\n", csv,
         [30.5-a, -4.25-b, 7-'c;d']).
row_text("n;r\n1,2,3;1e3\n1,x;2\n", csv, [1.0e3-'1,2,3', 2-'1,x']).
row_text("n\tr\na;b\t2,5\n", tsv, ['2,5'-'a;b']).

place_of(Manifest, Kind, Place) :-
    fault_place(Manifest, What/Place),
    functor(What, Kind, _).

:- begin_tests(manifest).

test(ranges, true(Names == ['a(2)', 'a(3)', 'a(4)'])) :-
    template('a(R)', 'R in 2..4', Text),
    names(Text, Names).
test(empty_range, true(What == no_jobs)) :-
    template('a(R)', 'R in 2..1', Text),
    fault(Text, What).
test(later_uses_earlier,
     true(Names == ['a(1,1)', 'a(2,1)', 'a(2,2)', 'a(3,1)', 'a(3,2)',
                    'a(3,3)'])) :-
    template('a(R, S)', 'R in 1..3, S in 1..R', Text),
    names(Text, Names).
% Steps of decimals are exact: 0.1 and 0.2 make 0.3, to the last digit.
test(decimals, true(Values == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7])) :-
    findall(V, generated([in(V, between(0.1, 0.7, 0.1))], '.'), Values).
test(decimals_whole, true(Values == [0, 0.5, 1, 1.5])) :-
    findall(V, generated([in(V, between(0, 1.5, 0.5))], '.'), Values).
% Semicolons are between the fields where commas are decimal points.
test(rows, true(Rows == Wanted)) :-
    findall(Text-Ending-Values,
            row_text(Text, Ending, Values), Wanted),
    findall(Text-Ending-Values,
            ( row_text(Text, Ending, _),
              with_file(Text, Ending, File,
                        findall(R-N,
                                generated([in([R, N], rows(File, [r, n]))],
                                          '.'),
                                Values)) ),
            Rows).
test(members, true(Names == ['a(b)', 'a(3)', 'a(\'X y\')'])) :-
    template('a(R)', '(R in [b, 3, \'X y\'])', Text),
    names(Text, Names).
test(no_generator, true(What == generator('member(R, [1, 2])'))) :-
    template('a(R)', 'member(R, [1, 2])', Text),
    fault(Text, What).
test(two_of_one_name, true(What == twice('a(1)', 'a(1)', 'a-1'))) :-
    template('a(R)', 'R in 1..3, _ in 1..2', Text),
    fault(Text, What).
test(two_of_one_file, true(What == twice('\'a-1\'', 'a(1)', 'a-1'))) :-
    template('a(R)', 'R in 1..3', Text0),
    cube(Cube),
    format(string(Text), "~w job('a-1', check, ['~w'], []).", [Text0, Cube]),
    fault(Text, What).
% More names than are sorted in memory.
test(two_of_one_name_of_many, true(What == twice(b, b, b))) :-
    template('a(R)', 'R in 1..20000', Text0),
    cube(Cube),
    format(string(Text), "job(b, check, ['~w'], []). ~w \c
           job(b, check, ['~w'], []).", [Cube, Text0, Cube]),
    fault(Text, What).
test(many, true(N == 20000)) :-
    template('a(R)', 'R in 1..20000', Text),
    jobs(Text, pl, Jobs),
    length(Jobs, N).
%   What is wrong is said where it stands: in the argument, or in the fact.
test(places, [ forall(member(Text-Kind-Place,
       [ "job([], check, [\"~w\"], [])."-name-(1-5),
         "\n job('!', check, [\"~w\"], [])."-name-(2-6),
         "job(a, chek, [\"~w\"], [])."-verb-(1-8),
         "job(a, check, \"~w\", [])."-files-(1-15),
         "job(a, check, ['-x'], [])."-files-(1-15),
         "job(a, check, [''], [])."-files-(1-15),
         "job(a, check, [\"~w\"], [time_limit(0)])."-limit-(1-25),
         "defaults([time_limit(0)])."-limit-(1-10),
         "defaults([colour(red)])."-no_default-(1-10),
         "job(a, check, [\"~w\"])."-fact-(1-1) ])),
               true(Found == Place) ]) :-
    ( sub_string(Text, _, _, _, "~w") -> Files = ['c.pl'] ; Files = [] ),
    format(string(Manifest), Text, Files),
    place_of(Manifest, Kind, Found).
test(defaults,
     true(Jobs == [ a-[json-true], b-[output-'%.svg', view-front],
                    c-[output-'%.svg', view-left],
                    d-[output-'%.svg', view-top] ])) :-
    cube(Cube),
    format(string(Text),
           "defaults([json, view(front)]). job(a, check, ['~w'], []). \c
            defaults([output('%.svg')]). job(b, draw, ['~w'], []). \c
            defaults([view(top)]). job(c, draw, ['~w'], [view(left)]). \c
            job(d, draw, ['~w'], []).", [Cube, Cube, Cube, Cube]),
    jobs(Text, pl, Jobs).
test(line_of_json, true(Line-Column == 3-1)) :-
    cube(Cube),
    format(string(Text),
           '{"defaults":{"json":true}}~n~n\c
            {"job":"b","verb":"repair","files":["~w"]}~n', [Cube]),
    catch(jobs(Text, jsonl, _),
          error(model_error(manifest(verb(repair, _, _))),
                location(_, Line, Column)), true).
test(json_is_as_facts, true(A == B)) :-
    cube(Cube),
    format(string(Facts),
           "job(t, draw, ['~w'], [view(30, 60), no_frame, output('%.svg'), \c
            output('x/%.pdf'), set(r, 3)]).", [Cube]),
    format(string(Json),
           '{"job":"t","verb":"draw","files":["~w"],"options":{\c
            "view":"30,60","no-frame":true,"output":["%.svg","x/%.pdf"],\c
            "set":{"r":3}}}~n', [Cube]),
    jobs(Facts, pl, A),
    jobs(Json, jsonl, B).

% Each job is in exactly one shard, and shards are of like sizes.
test(shards, [forall(member(N, [1, 2, 3, 7, 64])), true(Least*2 > Most)]) :-
    findall(I,
            ( between(1, 6400, K),
              format(atom(Name), 'hole(~d)', [K]),
              aggregate_all(count, ( between(1, N, I0),
                                     in_shard(Name, I0, N) ), 1),
              between(1, N, I),
              in_shard(Name, I, N) ),
            Is),
    msort(Is, Sorted),
    clumped_lengths(Sorted, Lengths),
    min_list(Lengths, Least),
    max_list(Lengths, Most).

clumped_lengths([], []).
clumped_lengths([I|Is], [N|Ns]) :-
    partition(==(I), Is, Same, Rest),
    length([I|Same], N),
    clumped_lengths(Rest, Ns).

% Names of files: no folder, no option, nothing hidden, whatever a name is.
test(stems, true(Bad == [])) :-
    set_random(seed(7)),
    findall(Text-Stem,
            ( between(1, 2000, _),
              random_between(0, 12, Length),
              length(Codes, Length),
              maplist(random_code, Codes),
              atom_codes(Text, Codes),
              file_stem(Text, Stem),
              \+ safe(Stem) ),
            Bad).

random_code(Code) :-
    random_member(Code, `abzAZ019 ()[],./\\-_~'"%*\u00e9\uac00\n\t:=`).

safe(Stem) :-
    atom_codes(Stem, Codes),
    Codes = [First|_],
    \+ memberchk(First, `.-`),
    forall(member(C, Codes),
           ( code_type(C, alnum) ; memberchk(C, `._-`) )).

test(no_stem, [forall(member(Name, ['', '()', '---', ' ', '.'])), fail]) :-
    file_stem(Name, _).
test(long_stem, [fail]) :-
    format(atom(Name), '~`가t~61|', []),
    file_stem(Name, _).

test(unbound, true(What == unbound('S'))) :-
    template('a(R, S)', 'R in 1..2', Text),
    fault(Text, What).

:- end_tests(manifest).
