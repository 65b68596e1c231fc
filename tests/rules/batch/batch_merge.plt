/* Reports that become one: which lines count, in what order, and what is no
   line of a report. What a line says of a job, to the letter.
   covers: batch_report */
:- module(test_batch_merge, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(batch/batch_merge)).
:- use_module(rules(batch/batch_report)).

:- dynamic heard/1.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(batch(Message)), warning, _) :-
    assertz(test_batch_merge:heard(Message)).

%   merged(Texts, Ending, Text): of reports that have these Texts, a.jsonl,
%   b.jsonl, ...

merged(Texts, Ending, Text) :-
    tmp_file(reports, Folder),
    make_directory(Folder),
    setup_call_cleanup(
        true,
        ( retractall(heard(_)),
          foldl(written(Folder), Texts, Files, 0'a, _),
          file_name_extension(all, Ending, Name),
          directory_file_path(Folder, Name, All),
          reports_merged(Files, [All]),
          read_file_to_string(All, Text, [encoding(utf8)]) ),
        delete_directory_and_contents(Folder)).

written(Folder, Lines, File, Letter, Next) :-
    Next is Letter+1,
    format(atom(Name), '~c.jsonl', [Letter]),
    directory_file_path(Folder, Name, File),
    atomic_list_concat(Lines, '\n', Text),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       format(Out, '~w~n', [Text]),
                       close(Out)).

batch('{"batch":"m.pl","folder":"out"}').
batch(Name, Line) :-
    format(atom(Line), '{"batch":"~w.pl","folder":"out"}', [Name]).

line(N, Outcome, Line) :-
    (   Outcome == failed
    ->  Error = '{"words":{"en":"no"}}'
    ;   Error = null
    ),
    format(atom(Line),
           '{"job":"j~d","number":~d,"status":0,"outcome":"~w","seconds":0.5,\c
            "files":["f"],"said":[],"error":~w}', [N,N,Outcome,Error]).

atom_to_json(Text0, Name) :-
    atom_string(Text, Text0),
    atom_json_dict(Text, Read, []),
    atom_string(Name, Read).

%   names(Text, Names): the jobs of Text, a report, with their outcomes.

names(Text, Names) :-
    split_string(Text, "\n", "", [_|Lines]),
    findall(Job-Outcome,
            ( member(Line, Lines),
              after(Line, "\"job\":\"", Job),
              after(Line, "\"outcome\":\"", Outcome) ),
            Names).

after(Line, Key, Value) :-
    sub_string(Line, _, _, After, Key),
    !,
    sub_string(Line, _, After, 0, Rest),
    split_string(Rest, "\"", "", [Value|_]).

%   damaged(Line): it begins and ends as a line does, but a part is missing or
%   of another kind.

damaged(Line) :-
    line(1, failed, Whole),
    member(Part-Other, [ '"seconds":0.5'-'"seconds":"0.5"',
                         '"seconds":0.5,'-'',
                         '"files":["f"]'-'"files":[1]',
                         '"files":["f"]'-'"files":"f"',
                         '"said":[]'-'"said":{}', '"status":0,'-'',
                         ',"error":{"words":{"en":"no"}}'-'',
                         '{"en":"no"}'-'"no"', '{"en":"no"}'-'{"en":1}',
                         '"job":"j1"'-'"job":1',
                         '"status":0,'-'"status":0,,' ]),
    atomic_list_concat([Before,After], Part, Whole),
    atomic_list_concat([Before,Other,After], Line).

:- begin_tests(batch_merge).

%   Each character of a name comes back, on one line.
test(characters, true(Wrong == [])) :-
    findall(Code,
            ( between(1, 400, Code),
              atom_codes(Name, [0'a,Code]),
              json_text(Name, Text),
              \+ ( atom_to_json(Text, Read),
                   Read == Name,
                   \+ sub_string(Text, _, _, _, "\n") ) ),
            Wrong).
test(values, Texts == ["null","[]","\"null\"","[\"a\", 1 ]","{\"b\":true}"]) :-
    maplist([Value,Text]>>( json_text(Value, Text0),
                            format(string(Text), "~w", [Text0]) ),
            [null,[],"null",["a",1],_{b:true}], Texts).
test(numbers_of_a_line, Text == Wanted) :-
    line_text(job(7, 'a"b', _, draw, _, _, _, _),
              result(done, 0, k1, usage(1.23456, 0, 512), [f,'g"'], '[]', null),
              Text0),
    format(string(Text), "~w", [Text0]),
    Wanted = "{\"job\":\"a\\\"b\",\"number\":7,\"verb\":\"draw\",\c
              \"status\":0,\"outcome\":\"done\",\"key\":\"k1\",\c
              \"seconds\":1.235,\"cpu\":0.000,\"rss_kb\":512,\c
              \"files\":[\"f\",\"g\\\"\"],\"said\":[],\"error\":null}".

test(whole, [true(Lines-Counts == [First,Second,"]}",""]-[2,1,0,1,0,0])]) :-
    batch(Batch),
    line(1, done, Line1),
    line(2, failed, Line2),
    atom_concat(Line1, ',', Line),
    maplist(atom_string, [Line,Line2], [First,Second]),
    merged([[Batch,Line1,Line2]], json, Text),
    split_string(Text, "\n", "", [_|Lines]),
    atom_json_dict(Text, Dict, []),
    findall(Count,
            (   get_dict(jobs, Dict, Count)
            ;   get_dict(outcomes, Dict, Outcomes),
                member(Outcome, [done,cached,failed,timeout,killed]),
                get_dict(Outcome, Outcomes, Count)
            ),
            Counts).
test(last_counts,
     [true(Names == ["j1"-"done","j2"-"cached","j3"-"timeout"])]) :-
    batch(Batch),
    maplist([N-Outcome,Line]>>line(N, Outcome, Line),
            [3-timeout,1-failed,2-failed,1-done,2-cached], [C,A1,B1,A2,B2]),
    merged([[Batch,C,A1,B1], [Batch,'{"summary":1}',A2,B2]], json, Text),
    names(Text, Names).
test(manifests_apart,
     [true(Names == ["j2"-"killed","j1"-"done","j1"-"failed"])]) :-
    maplist(batch, [b,a], [B,A]),
    line(1, done, Done),
    line(1, failed, Failed),
    line(2, killed, Killed),
    merged([[B,Done], [A,Killed], ['{"batch":"c.pl","folder":"x"}',Failed]],
           json, Text),
    names(Text, Names).
test(cut_off, [true(Names-Messages == ["j1"-"done"]-[3])]) :-
    batch(Batch),
    line(1, done, Line),
    merged([[Batch,Line,'{"job":"j2","numb']], json, Text),
    names(Text, Names),
    findall(At, heard(cut_line(_, At)), Messages).
test(no_report, [ forall(member(Lines-At, [ [x]-1, [Batch,'[1]',Line]-2,
                                            [Batch,'{"job":"j2"',Line]-2,
                                            [Batch,'{}',Line]-2 ])),
                  throws(error(model_error(manifest(no_report)),
                               location(_,At,0))) ]) :-
    batch(Batch),
    line(1, done, Line),
    merged([Lines], json, _).
test(damaged, [ forall(damaged(Damaged)),
                throws(error(model_error(manifest(no_report)),
                             location(_,0,0))) ]) :-
    batch(Batch),
    merged([[Batch,Damaged]], json, _).
test(missing, [throws(error(model_error(cannot_read(missing)), _))]) :-
    reports_merged(['no_such.jsonl'], ['x.json']).
test(ending,
     [ throws(error(usage_error(ending('x.pdf', [json,xml,html])), _)) ]) :-
    reports_merged([], ['x.json','x.pdf']).
test(line, [true(Text == '{"job":"a \\"b\\"","number":7,"verb":"draw",\c
"status":3,"outcome":"failed","key":"k","seconds":1.235,"cpu":0.000,\c
"rss_kb":12,\c
"files":["a.svg","b\\\\c"],"said":[],"error":null}')]) :-
    line_text(job(7,'a "b"',none,draw,none,none,none,none),
              result(failed,3,k,usage(1.2346,0,12),['a.svg','b\\c'],'[]',null),
              Text).

:- end_tests(batch_merge).
