:- module(sg_batch_report,
          [ line_text/3,                % +Job, +Result, -Text
            report_line/2,              % +Out, +Text
            json_text/2,                % +Value, -Text
            outcome/1                   % ?Outcome
          ]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../plain', [plain_json/2]).
/** <module> The report of a batch: lines of JSON, one a job.
*/

%!  outcome(?Outcome) is nondet.
%
%   What may become of a job, as lines and summaries call it.

outcome(done).
outcome(cached).
outcome(failed).
outcome(timeout).
outcome(killed).

%!  line_text(+Job, +Result, -Text) is det.
%
%   Text is the line of Job. Result is result(Outcome, Status, Key,
%   usage(Seconds, Cpu, Kilobytes), Files, Said, Error); Said and Error are
%   texts of JSON.

line_text(job(Number, Name, _, Verb, _, _, _, _),
          result(Outcome, Status, Key, usage(Seconds, Cpu, Kilobytes), Files,
                 Said, Error),
          Text) :-
    json_text(Name, NameText),
    files_text(Files, FilesText),
    thousandths(Seconds, SecondsText),
    thousandths(Cpu, CpuText),
    atomic_list_concat(
        [ '{"job":', NameText, ',"number":', Number, ',"verb":"', Verb,
          '","status":', Status, ',"outcome":"', Outcome, '","key":"', Key,
          '","seconds":', SecondsText, ',"cpu":', CpuText, ',"rss_kb":',
          Kilobytes, ',"files":', FilesText, ',"said":', Said, ',"error":',
          Error, '}' ],
        Text).

thousandths(Seconds, Text) :-
    (   Seconds == 0
    ->  Text = '0.000'
    ;   format(atom(Text), '~3f', [Seconds])
    ).

files_text([], '[]') :-
    !.
files_text([File|Files], Text) :-
    json_text(File, First),
    files_rest(Files, Rest),
    atomic_list_concat(['[', First|Rest], Text).

files_rest([], [']']).
files_rest([File|Files], [',', Text|Rest]) :-
    json_text(File, Text),
    files_rest(Files, Rest).

%!  report_line(+Out, +Text) is det.
%
%   Text is the next line of the report Out, for who reads along.

report_line(Out, Text) :-
    write(Out, Text),
    nl(Out),
    flush_output(Out).

%!  json_text(+Value, -Text) is det.
%
%   Text is Value, an atom or what json_laid_out/3 takes, as JSON in one line.

json_text(Value, Text) :-
    (   atom(Value),
        Value \== null,
        plain_name(Value)
    ->  atomic_list_concat(['"', Value, '"'], Text)
    ;   (   atom(Value),
            Value \== null
        ->  atom_string(Value, Value1)
        ;   Value1 = Value
        ),
        with_output_to(
            string(Text),
            plain_json(current_output,
                       json_laid_out(current_output, Value1, inf)))
    ).

plain_name(Name) :-
    atom_codes(Name, Codes0),
    sort(Codes0, Codes),                % few are different
    plain_codes(Codes).

plain_codes([]).
plain_codes([C|Cs]) :-
    C >= 32,
    C < 127,
    C =\= 0'",
    C =\= 0'\\,
    plain_codes(Cs).
