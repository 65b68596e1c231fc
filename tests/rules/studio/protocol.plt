:- encoding(utf8).
:- module(test_protocol, []).
:- use_module(library(memfile)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(studio/protocol)).

/* Frames are written and read again; what is no frame is told, and never takes
   the reader out of step.
*/

% octets(Goal, Octets): what call(Goal, Out) writes.
octets(Goal, Octets) :-
    setup_call_cleanup(
        new_memory_file(File),
        ( setup_call_cleanup(
              open_memory_file(File, write, Out, [encoding(octet)]),
              call(Goal, Out),
              close(Out)),
          memory_file_to_string(File, Octets, octet)
        ),
        free_memory_file(File)).

written(Head, Body, Out) :-
    frame_write(Out, Head, Body).

% all_read(Octets, Kind, Results): until the end; at most one error an octet.
all_read(Octets, Kind, Results) :-
    setup_call_cleanup(
        new_memory_file(File),
        ( setup_call_cleanup(
              open_memory_file(File, write, Out, [encoding(octet)]),
              format(Out, "~s", [Octets]),
              close(Out)),
          setup_call_cleanup(
              open_memory_file(File, read, In, [encoding(octet)]),
              read_on(In, Kind, Results),
              close(In))
        ),
        free_memory_file(File)).

read_on(In, Kind, Results) :-
    catch(frame_read(In, Kind, Head, Body), Error, true),
    (   nonvar(Error)
    ->  (   Error = error(frame_error(Why), _)
        ->  true
        ;   throw(Error)
        ),
        Results = [Why|Results1],
        read_on(In, Kind, Results1)
    ;   Head == end_of_file
    ->  Results = []
    ;   Results = [Head-Body|Results1],
        read_on(In, Kind, Results1)
    ).

% framed(Json, Body, Octets): Json are octets.
framed(Json, Body, Octets) :-
    string_length(Json, H),
    string_length(Body, B),
    N is 4+H+B,
    sized(N, Size),
    sized(H, HeadSize),
    atomics_to_string([Size,HeadSize,Json,Body], Octets).

sized(N, Size) :-
    A is N>>24 /\ 255, B is N>>16 /\ 255, C is N>>8 /\ 255, D is N /\ 255,
    string_codes(Size, [A,B,C,D]).

%   nested(Depth, Kind, Json): an object with brackets in one another, so deep.

nested(Depth, Kind, Json) :-
    Inner is Depth-1,
    brackets(Inner, Kind, Value),
    format(string(Json), "{\"a\":~w}", [Value]).

brackets(0, _, 1) :-
    !.
brackets(N, Kind, Json) :-
    N1 is N-1,
    brackets(N1, Kind, Inner),
    (   ( Kind == dicts ; Kind == both, N mod 2 =:= 0 )
    ->  format(string(Json), "{\"b\":~w}", [Inner])
    ;   format(string(Json), "[~w]", [Inner])
    ).

read_one(Json, Truth) :-
    framed(Json, "", Octets),
    all_read(Octets, request, [Result]),
    (   Result = _-_
    ->  Truth = yes
    ;   assertion(Result == too_deep(32)),
        Truth = no
    ).

:- begin_tests(protocol).

test(round_trip, true(Results =@= [Head-Body, _{}-""])) :-
    Head = _{id:1, argv:["draw", "상관.pl", "\U0001F600\u202e"], n:1.5},
    string_codes(Body, [0,255,10,13,0]),
    octets(written(Head, Body), One),
    octets(written(_{}, ""), Two),
    string_concat(One, Two, Octets),
    all_read(Octets, request, Results).
% The head is UTF-8, but what people would not see is escaped.
test(head_octets, Codes == Wanted) :-
    octets(written(_{a:"각\u202e"}, "x"), Octets),
    string_codes(Octets, [_,_,_,_,_,_,_,_|Codes]),
    string_codes("{\"a\":\"\xea\\xb0\\x81\\\u202e\"}x", Wanted).
test(empty, true(Results =@= [])) :-
    all_read("", request, Results).
test(head_alone, true(Results =@= [truncated])) :-
    all_read("\x00\\x00\", request, Results).
test(too_short, true(Results =@= [short(3), _{}-""])) :-
    framed("{}", "", Good),
    string_concat("\x00\\x00\\x00\\x03\abc", Good, Octets),
    all_read(Octets, request, Results).
test(head_beyond, true(Results =@= [head_too_long(9), _{}-""])) :-
    framed("{}", "", Good),
    string_concat("\x00\\x00\\x00\\x06\\x00\\x00\\x00\\x09\{}", Good, Octets),
    all_read(Octets, request, Results).
% A frame that is too large is passed over; a reply may be that large.
test(too_large, true(Results =@= [too_large(N), _{}-""])) :-
    length(Codes, 1_048_571),
    maplist(=(0'x), Codes),
    string_codes(Body, Codes),
    framed("{}", Body, Large),
    N is 1_048_571+6,
    framed("{}", "", Good),
    string_concat(Large, Good, Octets),
    all_read(Octets, request, Results).
test(largest, Length == 1_048_570) :-
    length(Codes, 1_048_570),
    maplist(=(0'x), Codes),
    string_codes(Body, Codes),
    framed("{}", Body, Large),
    all_read(Large, request, [_-Read]),
    string_length(Read, Length).
test(reply_may_be_larger, Length == 2_000_000) :-
    length(Codes, 2_000_000),
    maplist(=(0'x), Codes),
    string_codes(Body, Codes),
    framed("{}", Body, Large),
    all_read(Large, reply, [_-Read]),
    string_length(Read, Length).
test(bad_head, forall(member(Json-Why,
                             [ "{"-not_json, ""-not_json, "{} {}"-not_json,
                               "{\"a\":1e999}"-not_json,
                               "{\"a\":1,\"a\":2}"-not_json,
                               "[1]"-not_an_object, "1"-not_an_object,
                               "\"x\""-not_an_object,
                               "{\"a\":\"\xff\\"}"-not_utf8,
                               "{\"a\":\"\xc0\\x80\\"}"-not_utf8,
                               "{\"a\":\"\xf4\\x90\\x80\\x80\\"}"-not_utf8,
                               "{\"a\":\"\xe2\\x82\\"}"-not_utf8,
                               "{\"a\":\"\xed\\xa0\\x80\\"}"-not_utf8
                             ]))) :-
    framed(Json, "body", Octets),
    framed("{}", "", Good),
    string_concat(Octets, Good, Both),
    all_read(Both, request, Results),
    Results =@= [Why, _{}-""].
test(deep, true(Results =@= [too_deep(32)])) :-
    length(Open, 100_000),
    maplist(=(0'[), Open),
    format(string(Json), "{\"a\":~s", [Open]),
    framed(Json, "", Octets),
    all_read(Octets, request, Results).
%   As deep as may be, and one more, of either bracket; beside one another there
%   may be any number.
test(depth, [ forall(( member(Kind, [lists,dicts,both]),
                       member(Depth-Truth, [31-yes,32-yes,33-no]) )),
              true(Found == Truth) ]) :-
    nested(Depth, Kind, Json),
    read_one(Json, Found).
test(siblings, Found == [yes,yes,no]) :-
    findall(Truth,
            ( member(Deep, [1,30,31]),
              nested(Deep, both, One),
              length(Ones, 40),
              maplist(=(One), Ones),
              atomic_list_concat(Ones, ',', Inner),
              format(string(Json), "{\"a\":[~w]}", [Inner]),
              read_one(Json, Truth) ),
            Found).
test(brackets_in_texts, true(Results =@= [_{a:Text}-""])) :-
    length(Open, 1000),
    maplist(=(0'[), Open),
    format(string(Text), "\"\\~s", [Open]),
    format(string(Json), "{\"a\":\"\\\"\\\\~s\"}", [Open]),
    framed(Json, "", Octets),
    all_read(Octets, request, Results).

% Random damage: every frame before it is read as it was, nothing else than
% frame_error is raised, and reading comes to its end.
test(damaged, forall(between(1, 300, Seed))) :-
    set_random(seed(Seed)),
    findall(Octets,
            ( between(1, 6, I),
              octets(written(_{id:I, do:"run", argv:["check","각.pl"]}, "body"),
                     Octets) ),
            Frames),
    atomics_to_string(Frames, Whole),
    string_codes(Whole, Codes0),
    length(Codes0, Length),
    random_between(1, Length, At),
    random_member(How, [cut, changed, doubled]),
    damaged(How, At, Codes0, Codes),
    string_codes(Damaged, Codes),
    all_read(Damaged, request, Results),
    Frames = [Frame|_],
    string_length(Frame, FrameLength),
    Before is (At-1)//FrameLength,
    forall(between(1, Before, I),
           ( nth1(I, Results, Head-_), Head.id == I )).

damaged(cut, At, Codes0, Codes) :-
    length(Codes, At),
    append(Codes, _, Codes0).
damaged(changed, At, Codes0, Codes) :-
    random_between(0, 255, New),
    nth1(At, Codes0, _, Rest),
    nth1(At, Codes, New, Rest).
damaged(doubled, At, Codes0, Codes) :-
    nth1(At, Codes0, Code),
    nth1(At, Codes, Code, Codes0).

:- end_tests(protocol).
