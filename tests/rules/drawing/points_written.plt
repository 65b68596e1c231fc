:- encoding(utf8).
:- module(test_points_written, []).
% covers: points_text_rows
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(kernel), [points_text/2, points_written/4,
                              thousandths_text/2]).

/* Points that a kernel writes to a stream are what format/3 would write there:
   whatever encodes the stream, buffers it, watches it or counts its lines. */

%   file(Options, Goal, Codes): the octets of a file that Goal writes.

file(Options, Goal, Codes) :-
    tmp_file_stream(File, Made, [encoding(binary)]),
    close(Made),
    setup_call_cleanup(open(File, write, Out, Options),
                       call(Goal, Out), close(Out)),
    setup_call_cleanup(open(File, read, In, [type(binary)]),
                       read_stream_to_codes(In, Codes), close(In)),
    delete_file(File).

written(Text, Out) :-
    points_written(Out, Text, [1-2,-12340-1005], '"/>\n').

formatted(Text, Out) :-
    format(Out, '~w0.001,0.002 -12.34,1.005"/>~n', [Text]).

text('<p d="').
text('').
text("a\tstring\n").
text('그림 é 😀').

stream([encoding(utf8)]).
stream([encoding(utf8),newline(dos)]).
stream([encoding(utf8),buffer(line)]).
stream([encoding(utf8),buffer(false)]).
stream([encoding(utf16le)]).
stream([type(binary)]).

%   after(Goal, Place, Out): where the stream is after Goal and more.

after(Goal, place(Line, Column, Count, Octets), Out) :-
    format(Out, 'ab', []),
    call(Goal, Out),
    points_written(Out, cd, [5-6], ''),
    line_count(Out, Line),
    line_position(Out, Column),
    character_count(Out, Count),
    byte_count(Out, Octets).

:- begin_tests(points_written).

test(as_format, forall(( text(Text), stream(Options),
                         \+ ( Options == [type(binary)],
                              Text == '그림 é 😀' ) ))) :-
    file(Options, written(Text), Codes),
    file(Options, formatted(Text), Wanted),
    assertion(Codes == Wanted).

test(into_a_string, forall(text(Text))) :-
    with_output_to(string(S), ( current_output(Out), written(Text, Out) )),
    with_output_to(string(W), ( current_output(Out1), formatted(Text, Out1) )),
    assertion(S == W).

% The stream's buffer fills in the middle of a text, many times.
test(longer_than_the_buffer) :-
    numlist(1, 5000, Ns),
    findall(N-N, member(N, Ns), Points),
    points_text(Points, Text),
    file([encoding(utf8)], [Out]>>points_written(Out, 'M', Points, 'Z'), Codes),
    string_codes(String, Codes),
    string_concat("M", Text, First),
    assertion(string_concat(First, "Z", String)).

test(where_the_stream_is, forall(text(Text))) :-
    file([encoding(utf8)], after(written(Text), P), _),
    file([encoding(utf8)], after(formatted(Text), Q), _),
    assertion(P == Q).

test(numbers, S == "0 -0.001 12.34 1") :-
    thousandths_text([0,-1,12340,1000], S).
test(no_numbers, S == "") :-
    thousandths_text([], S).

test(no_output, error(permission_error(output, stream, _))) :-
    points_written(user_input, '', [], '').
test(not_in_that_encoding, error(io_error(write, _))) :-
    file([encoding(iso_latin_1)], written('그림'), _).
test(full, [ condition(access_file('/dev/full', write)),
             error(io_error(write, _)) ]) :-
    numlist(1, 5000, Ns),
    findall(N-N, member(N, Ns), Points),
    setup_call_cleanup(open('/dev/full', write, Out, [encoding(utf8)]),
                       points_written(Out, '', Points, ''),
                       catch(close(Out), _, true)).

:- end_tests(points_written).
