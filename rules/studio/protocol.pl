:- module(sg_protocol,
          [ frame_read/4,               % +In, +Kind, -Head, -Body
            frame_write/3,              % +Out, +Head, +Body
            octets_text/2,              % +Octets, -Text
            text_octets/2               % +Text, -Octets
          ]).
:- use_module('../json_value', [json_value/2]).
:- use_module('../plain', [plain_json/2]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(memfile),
              [ new_memory_file/1, free_memory_file/1, open_memory_file/4,
                memory_file_to_string/3
              ]).
/** <module> Frames: what a session and those who ask it send each other.

A frame is octets, both ways the same:

    4 octets    N, how many follow; the most significant octet comes first
    4 octets    H, how long the head is
    H octets    the head, a JSON object in UTF-8
    N-4-H       the body, any octets, often none

docs/protocol.md says what the heads hold.
*/

%   largest(Kind, N): the largest N of a frame. deepest(Depth): objects and
%   lists of the head of a request in one another.

largest(request, 1_048_576).
largest(reply, 64_000_000).

deepest(32).

%!  frame_read(+In, +Kind, -Head, -Body) is det.
%
%   The next frame of In, a stream of octets: Head is a dict, its texts
%   strings, and Body a string of octets. At the end of In both are
%   `end_of_file`. Kind is `request`, which anybody may have written, or
%   `reply`, which a session wrote: that may be larger, and its head is not
%   looked through.
%
%   What is wrong with a frame is raised; then all of it has been read, and In
%   stands where the next frame begins, or at its end.
%
%   @error error(frame_error(Why), _): `truncated`, too_large(N), short(N),
%   head_too_long(H), `not_utf8`, `not_json`, `not_an_object`, too_deep(Most)

frame_read(In, Kind, Head, Body) :-
    largest(Kind, Most),
    octets_read(In, Most, Json, Body),
    (   Json == end_of_file
    ->  Head = end_of_file
    ;   recoded(Json, octet, utf8, Text),
        (   Kind == request
        ->  looked_through(Json, Text)
        ;   true
        ),
        head_of(Text, Head)
    ).

octets_read(In, Most, Json, Body) :-
    read_string(In, 4, Size),
    (   Size == ""
    ->  Json = end_of_file,
        Body = end_of_file
    ;   number_of_octets(Size, N),
        (   N > Most
        ->  passed_over(In, N),
            frame_error(too_large(N))
        ;   read_string(In, N, Octets),
            string_length(Octets, N)
        ->  frame_parts(N, Octets, Json, Body)
        ;   frame_error(truncated)
        )
    ).

frame_error(Why) :-
    throw(error(frame_error(Why), _)).

number_of_octets(Octets, N) :-
    (   string_codes(Octets, [A,B,C,D])
    ->  N is A<<24 \/ B<<16 \/ C<<8 \/ D
    ;   frame_error(truncated)
    ).

%   passed_over(In, N): N octets that are not kept.

passed_over(In, N) :-
    setup_call_cleanup(
        open_null_stream(Null),
        ( set_stream(Null, encoding(octet)),
          copy_stream_data(In, Null, N)
        ),
        close(Null)).

frame_parts(N, Octets, Json, Body) :-
    (   N < 4
    ->  frame_error(short(N))
    ;   sub_string(Octets, 0, 4, _, Size),
        number_of_octets(Size, H),
        Rest is N-4-H,
        (   Rest < 0
        ->  frame_error(head_too_long(H))
        ;   sub_string(Octets, 4, H, _, Json),
            sub_string(Octets, _, Rest, 0, Body)
        )
    ).

%   utf8_checked(Octets, Text): what is no UTF-8 does not become the same octets
%   again.

utf8_checked(Octets, Text) :-
    (   text_octets(Text, Octets),
        string_codes(Text, Codes0),
        sort(Codes0, Codes),            % few are different
        \+ ( member(Code, Codes), no_character(Code) )
    ->  true
    ;   frame_error(not_utf8)
    ).

looked_through(Octets, Text) :-
    utf8_checked(Octets, Text),
    deepest(Most),
    (   few_brackets(Text, Most)
    ->  true
    ;   string_codes(Text, Codes),
        within(Codes, 0, Most)
    ->  true
    ;   frame_error(too_deep(Most))
    ).

head_of(Text, Head) :-
    (   json_value(Text, Head0)
    ->  true
    ;   frame_error(not_json)
    ),
    (   is_dict(Head0)
    ->  Head = Head0
    ;   frame_error(not_an_object)
    ).

no_character(Code) :-
    Code >= 0xd800,
    (   Code =< 0xdfff
    ->  true
    ;   Code > 0x10ffff
    ).

%   few_brackets(Text, Most): there are no more than Most to begin something.

few_brackets(Text, Most) :-
    split_string(Text, "{[", "", Parts),
    length(Parts, N),
    N-1 =< Most.

%   within(Codes, Depth, Most): brackets that are no part of a text are no
%   deeper than Most.

within([], _, _).
within([Code|Codes], Depth, Most) :-
    (   Code =:= 0'"
    ->  behind_text(Codes, Rest),
        within(Rest, Depth, Most)
    ;   ( Code =:= 0'{ ; Code =:= 0'[ )
    ->  Depth < Most,
        Depth1 is Depth+1,
        within(Codes, Depth1, Most)
    ;   ( Code =:= 0'} ; Code =:= 0'] )
    ->  Depth1 is Depth-1,
        within(Codes, Depth1, Most)
    ;   within(Codes, Depth, Most)
    ).

behind_text([], []).
behind_text([Code|Codes], Rest) :-
    (   Code =:= 0'"
    ->  Rest = Codes
    ;   Code =:= 0'\\,
        Codes = [_|Codes1]
    ->  behind_text(Codes1, Rest)
    ;   behind_text(Codes, Rest)
    ).

%!  frame_write(+Out, +Head:dict, +Body) is det.
%
%   Write a frame to Out, a stream of octets, and flush it. Body is text of
%   octets. What people would not see in the texts of Head is escaped.

frame_write(Out, Head, Body) :-
    with_output_to(string(Text),
                   plain_json(current_output,
                              json_write_dict(current_output, Head,
                                              [width(0)]))),
    text_octets(Text, Json),
    string_length(Json, H),
    string_length(Body, B),
    N is 4+H+B,
    octets_of_number(N, Size),
    octets_of_number(H, HeadSize),
    format(Out, "~s~s~s~s", [Size, HeadSize, Json, Body]),
    flush_output(Out).

octets_of_number(N, [A,B,C,D]) :-
    A is N>>24,
    B is N>>16 /\ 255,
    C is N>>8 /\ 255,
    D is N /\ 255.

%!  octets_text(+Octets, -Text:string) is det.
%
%   Text is what the text of octets Octets is in UTF-8.
%
%   @error frame_error(not_utf8)

octets_text(Octets, Text) :-
    recoded(Octets, octet, utf8, Text),
    utf8_checked(Octets, Text).

%!  text_octets(+Text, -Octets:string) is det.
%
%   Octets is Text in UTF-8, a text of octets.

text_octets(Text, Octets) :-
    recoded(Text, utf8, octet, Octets).

recoded(From, Written, Read, To) :-
    setup_call_cleanup(
        new_memory_file(Memory),
        ( setup_call_cleanup(
              open_memory_file(Memory, write, Out, [encoding(Written)]),
              format(Out, "~s", [From]),
              close(Out)),
          memory_file_to_string(Memory, To, Read)
        ),
        free_memory_file(Memory)).
