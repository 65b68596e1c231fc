:- module(sg_batch_merge,
          [ reports_merged/2            % +Files, +Outputs
          ]).
:- use_module(batch_html, [sheet_pages/3]).
:- use_module(batch_junit, [junit_written/3]).
:- use_module(batch_report, [json_text/2, outcome/1]).
:- use_module('../json_value', [json_value/2]).
:- use_module('../output', [writing/3]).
:- use_module('../plain', [plain_text/2]).
:- use_module('../text_file', [with_text/4]).
:- use_module(library(apply), [foldl/4, maplist/2]).
:- use_module(library(lists), [append/3, member/2, nth1/3, reverse/2]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(readutil), [read_line_to_string/2]).
:- use_module(library(utf8), [utf8_codes/3]).
/** <module> Reports of batches become one.

Of all lines only their places are kept in memory; each is read again when it is
written. If a job is in several reports, the last one counts.
*/

%!  reports_merged(+Files, +Outputs) is det.
%
%   Write what is in the reports Files, lines of JSON, to each of Outputs. Its
%   ending says how: `.json`, all lines in one object; `.xml`, as JUnit has it,
%   for programs that show the state of a build; `.html`, pages of pictures. The
%   jobs are in the order of their manifests.
%
%   @error usage_error(ending(File, Endings)); model_error(cannot_read(Why)),
%   model_error(manifest(no_report)) with location(File, Line, 0)

reports_merged(Files, Outputs) :-
    maplist(known_ending, Outputs),
    foldl(report_places, Files, [], Places0),
    last_places(Places0, Places),
    counted(Places, Counts),
    forall(member(Output, Outputs), merged(Output, Places, Counts)).

known_ending(Output) :-
    (   ending(Output, _)
    ->  true
    ;   throw(error(usage_error(ending(Output, [json,xml,html])), _))
    ).

ending(Output, Ending) :-
    file_name_extension(_, Ending, Output),
    memberchk(Ending, [json,xml,html]).

merged(Output, Places, Counts) :-
    ending(Output, Ending),
    merged(Ending, Output, Places, Counts).

merged(json, Output, Places, Counts) :-
    writing(Output, text, sg_batch_merge:json_written(Places, Counts)).
merged(xml, Output, Places, Counts) :-
    writing(Output, text,
            junit_written(sg_batch_merge:result_of(Places), Counts)).
merged(html, Output, Places, Counts) :-
    sheet_pages(Output, sg_batch_merge:result_of(Places), Counts).

%   report_places(File, Places0, Places): Key-place(File, Offset, Head, Outcome)
%   of each line in File, the last one first. Key is Manifest-Number, Head
%   head(Manifest, Folder). Lines are read as octets: the last one may be cut
%   off inside a letter.

report_places(File, Places0, Places) :-
    with_text(lines, File, text(_, Path, _), true),
    (   Path == File
    ->  true
    ;   cannot_read(File, io)           % lines are read again by their places
    ),
    catch(open(File, read, In, [encoding(octet)]), error(Formal, _),
          cannot_read(File, Formal)),
    call_cleanup(lines_places(In, File, head('', '.'), 0, Places0, Places),
                 close(In)).

cannot_read(File, Formal) :-
    (   Formal = existence_error(_, _)
    ->  Why = missing
    ;   Formal = permission_error(_, _, _)
    ->  Why = permission
    ;   Why = io
    ),
    throw(error(model_error(cannot_read(Why)), location(File, 0, 0))).

lines_places(In, File, Head, Line0, Places0, Places) :-
    byte_count(In, Offset),
    read_line_to_string(In, Text),
    Line is Line0+1,
    (   Text == end_of_file
    ->  Places = Places0
    ;   job_line(Text, Number, Outcome)
    ->  Head = head(Manifest, _),
        lines_places(In, File, Head, Line,
                     [(Manifest-Number)-place(File, Offset, Head, Outcome)|
                      Places0],
                     Places)
    ;   other_line(Text, Head, Head1)
    ->  lines_places(In, File, Head1, Line, Places0, Places)
    ;   sub_string(Text, 0, _, _, "{\""),
        at_end_of_stream(In)            % its batch was killed
    ->  print_message(warning, sanggwan(batch(cut_line(File, Line)))),
        Places = Places0
    ;   throw(error(model_error(manifest(no_report)),
                    location(File, Line, 0)))
    ).

%   job_line(Text, Number, Outcome): quotes in names have a backslash, so what
%   is looked for is no part of a name.

job_line(Text, Number, Outcome) :-
    sub_string(Text, 0, _, _, "{\"job\":"),
    sub_string(Text, _, 1, 0, "}"),
    text_after(Text, "\"number\":", ",", NumberText),
    number_string(Number, NumberText),
    text_after(Text, "\"outcome\":\"", "\"", OutcomeText),
    atom_string(Outcome, OutcomeText),
    outcome(Outcome),
    !.

text_after(Text, Key, End, Value) :-
    sub_string(Text, _, _, After, Key),
    !,
    sub_string(Text, _, After, 0, Rest),
    sub_string(Rest, Before, _, _, End),
    !,
    sub_string(Rest, 0, Before, _, Value).

other_line(Octets, Head0, Head) :-
    string_codes(Octets, Bytes),
    phrase(utf8_codes(Codes), Bytes),
    string_codes(Text, Codes),
    json_value(Text, Dict),
    is_dict(Dict),
    (   get_dict(batch, Dict, Manifest0),
        get_dict(folder, Dict, Folder0)
    ->  atom_string(Manifest, Manifest0),
        atom_string(Folder, Folder0),
        Head = head(Manifest, Folder)
    ;   get_dict(summary, Dict, _)
    ->  Head = Head0
    ).

%   last_places(Places0, Places): one a job, in order; Places0 has the last one
%   first.

last_places(Places0, Places) :-
    sort(1, @<, Places0, Sorted),       % keeps the first of equal keys
    pairs_values(Sorted, Places).

counted(Places, Counts) :-
    findall(Outcome-N,
            ( outcome(Outcome),
              findall(1, member(place(_, _, _, Outcome), Places), Ones),
              length(Ones, N) ),
            Counts).

%   place_text(Places, Text, Place) is nondet: the lines, in order.

place_text(Places, Text, Place) :-
    Place = place(File, Offset, _, _),
    member(Place, Places),
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        ( seek(In, Offset, bof, _),
          read_line_to_string(In, Text) ),
        close(In)).

%!  result_of(+Places, -Dict, -Head) is nondet.
%
%   Dict is what a line says, Head head(Manifest, Folder) of its batch.

:- public result_of/3.

result_of(Places, Dict, Head) :-
    result_text(Places, _, Dict, Head).

result_text(Places, Text, Dict, Head) :-
    place_text(Places, Text, place(File, _, Head, _)),
    (   json_value(Text, Dict),
        is_line(Dict)
    ->  true
    ;   throw(error(model_error(manifest(no_report)), location(File, 0, 0)))
    ).

%   result_line(Places, Line) is nondet: the text of a line, as it is if it has
%   nothing that is not seen.

result_line(Places, Line) :-
    result_text(Places, Text, Dict, _),
    (   plain_text(Text, Text)
    ->  Line = Text
    ;   json_text(Dict, Line)
    ).

is_line(Line) :-
    is_dict(Line),
    get_dict(job, Line, Job),
    string(Job),
    get_dict(seconds, Line, Seconds),
    number(Seconds),
    get_dict(files, Line, Files),
    is_list(Files),
    maplist(string, Files),
    get_dict(said, Line, Said),
    is_list(Said),
    get_dict(outcome, Line, Outcome),
    (   memberchk(Outcome, ["done", "cached"])
    ->  true
    ;   string(Outcome),
        get_dict(status, Line, _),
        get_dict(error, Line, Error),
        is_error(Error)
    ).

%   is_error(Error): what is not done says why, if it knows.

is_error(Error) :-
    (   is_dict(Error),
        get_dict(words, Error, Words)
    ->  is_dict(Words),
        forall(get_dict(_, Words, Text), string(Text))
    ;   true
    ).

%   json_written(Places, Counts, Out)

:- public json_written/3.

json_written(Places, Counts, Out) :-
    length(Places, N),
    dict_pairs(Dict, _, Counts),
    json_text(Dict, CountsText),
    format(Out, '{"jobs":~d,"outcomes":~w,"results":[', [N, CountsText]),
    State = first(true),
    forall(result_line(Places, Text),
           ( (   arg(1, State, true)
             ->  nb_setarg(1, State, false)
             ;   write(Out, ',')
             ),
             format(Out, '~n~w', [Text]) )),
    format(Out, '~n]}~n', []).
