/* The front of the studio: what it answers, to whom. A browser that does all of
   it is in tests/studio. */
:- module(test_front, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(studio/front), []).
:- use_module(rules(studio/page_file)).

:- meta_predicate truth(0, -), with_front(+, +, 0), printed(0, -).

truth(Goal, Truth) :-
    ( call(Goal) -> Truth = yes ; Truth = no ).

%   with_front(Token, Code, Goal): Goal, while the front has that secret and
%   that code of a class, or none.

with_front(Token, Code, Goal) :-
    setup_call_cleanup(
        ( assertz(sg_front:front_(front('127.0.0.1',8080,'/w',true), Token,
                                  none)),
          ( Code == none -> true ; assertz(sg_front:class_code(Code)) ) ),
        Goal,
        ( retractall(sg_front:front_(_, _, _)),
          retractall(sg_front:class_code(_)) )).

%   printed(Goal, Text): what it prints, in octets.

printed(Goal, Text) :-
    tmp_file(printed, File),
    current_output(Before),
    setup_call_cleanup(
        ( open(File, write, Out, [encoding(utf8)]), set_output(Out) ),
        Goal,
        ( set_output(Before), close(Out) )),
    setup_call_cleanup(open(File, read, In, [encoding(octet)]),
                       read_string(In, _, Text),
                       close(In)),
    delete_file(File).

%   answer(Request, Status, Lines, Body): of the front.

answer(Request, Status, Lines, Body) :-
    printed(sg_front:answered(Request), Text),
    sub_string(Text, B, _, _, "\n\n"),
    !,
    sub_string(Text, 0, B, _, Head),
    From is B+2,
    sub_string(Text, From, _, 0, Body),
    split_string(Head, "\n", "", [First|Lines]),
    string_concat("Status: ", StatusText, First),
    number_string(Status, StatusText).

request(Method, Path, More, [ method(Method), path(Path), host('127.0.0.1'),
                              port(8080)|More ]).

status(Method, Path, More, Status) :-
    request(Method, Path, More, Request),
    with_front("t", none, answer(Request, Status, _, _)).

%   taken(Octets, Length, More, Result): a file of that length is sent.

taken(Text, Length, More, Status-Kept) :-
    tmp_file(upload, File),
    tmp_file_stream(Sent, Out, [encoding(utf8)]),
    write(Out, Text),
    close(Out),
    setup_call_cleanup(
        open(Sent, read, In),
        printed(( catch(sg_front:uploaded([input(In),
                                           content_length(Length)|More], File),
                        _, fail)
                ->  true
                ;   write("Status: 0\n")
                ), Said),
        ( close(In), delete_file(Sent) )),
    split_string(Said, "\n", "", [First|_]),
    string_concat("Status: ", StatusText, First),
    number_string(Status, StatusText),
    (   exists_file(File)
    ->  read_file_to_string(File, Kept, []),
        delete_file(File)
    ;   Kept = none
    ),
    atom_concat(File, '.part', Part),
    catch(delete_file(Part), error(_, _), true).

:- begin_tests(front).

test(gzip, [ forall(member(Given-Truth,
       [ 'gzip'-yes, 'deflate, gzip, br'-yes, 'gzip;q=0.5'-yes,
         'gzip;q=0'-no, 'gzip; q=0.0'-no, 'gzip ; q = 1'-yes, 'br'-no,
         'xgzip'-no, ''-no, 'gzip;level=3'-yes, 'br;q=0,gzip'-yes ])),
             true(Found == Truth) ]) :-
    truth(sg_front:takes_gzip([accept_encoding(Given)]), Found).
test(no_coding, fail) :-
    sg_front:takes_gzip([]).

test(status, [ forall(member(Method-Path-More-Status,
       [ get-(/)-[]-200, head-(/)-[]-200, get-'/main.js'-[]-200,
         get-'/nothing'-[]-404, head-'/nothing'-[]-404, post-(/)-[]-405,
         put-'/main.js'-[]-405, delete-'/nothing'-[]-405,
         get-'/ws'-[]-403, get-'/ws'-[origin('http://evil')]-403,
         get-'/ws'-[origin('http://127.0.0.1:8080')]-400,
         get-'/x/none'-[]-404,
         post-'/up/none'-[]-403,
         post-'/up/none'-[origin('http://localhost:8080')]-404,
         get-'/up/none'-[]-404 ])),
               true(Found == Status) ]) :-
    status(Method, Path, More, Found).
test(other_host, Status == 400) :-
    with_front("t", none,
               answer([method(get),path(/),host(evil),port(8080)], Status, _,
                      _)).
test(full, [ setup(forall(between(1, 40, N),
                          assertz(sg_front:open_socket(N)))),
             cleanup(retractall(sg_front:open_socket(_))),
             true(Status == 503) ]) :-
    status(get, '/ws', [origin('http://127.0.0.1:8080'),upgrade(websocket)],
           Status).
test(headers, [ forall(member(Line,
       [ "Content-type: text/html; charset=UTF-8", "Vary: Accept-Encoding",
         "Cache-Control: no-cache", "X-Content-Type-Options: nosniff" ])) ]) :-
    request(get, /, [], Request),
    with_front("t", none, answer(Request, 200, Lines, Body)),
    memberchk(Line, Lines),
    \+ memberchk("Content-Encoding: gzip", Lines),
    page_file(/, plain, _, Body).
test(packed) :-
    request(get, '/main.js', [accept_encoding(gzip)], Request),
    with_front("t", none, answer(Request, 200, Lines, _)),
    memberchk("Content-Encoding: gzip", Lines).
test(kept) :-
    page_file(/, plain, _, Page),
    once(sub_string(Page, Before, _, _, "/main.js\"")),
    sub_string(Page, 0, Before, _, Start),
    split_string(Start, "\"", "", Parts),
    last(Parts, Folder),
    format(atom(Path), "/~w/main.js", [Folder]),
    request(get, Path, [], Request),
    with_front("t", none, answer(Request, 200, Lines, _)),
    findall(Line, ( member(Line, Lines),
                    sub_string(Line, 0, _, _, "Cache-Control") ),
            ["Cache-Control: max-age=31536000, immutable"]).

test(upload, [ forall(member(Text-Length-More-Wanted,
       [ "abc"-3-[]-(200-"abc"), "abcde"-3-[]-(200-"abc"), ""-0-[]-(200-""),
         "abc"-5-[]-(0-none),
         "abc"-3-[transfer_encoding(chunked)]-(411-none),
         "abc"-20 000 001-[]-(413-none) ])),
               true(Found == Wanted) ]) :-
    taken(Text, Length, More, Found).
test(largest_upload, Status == 0) :-    % as large as may be, but there is less
    taken("abc", 20 000 000, [], Status-_).
test(length_unknown, Line == "Status: 411") :-
    with_output_to(string(Said), sg_front:uploaded([], '/no/file')),
    split_string(Said, "\n", "", [Line|_]).

test(place, [ forall(member(Options-Class-Behind-Truth,
       [ []-false-none-yes, [host('127.0.0.1')]-false-none-yes,
         [host(localhost)]-false-none-yes,
         [host('0.0.0.0')]-false-none-no, [host('0.0.0.0')]-true-none-yes,
         [host('0.0.0.0')]-false-'http://a/'-yes,
         [socket('/s')]-false-none-no, [socket('/s')]-true-none-no,
         [socket('/s')]-false-'http://a/'-yes,
         [socket('/s'),port(1)]-false-'http://a/'-no,
         [socket('/s'),host(localhost)]-false-'http://a/'-no ])),
              true(Found == Truth) ]) :-
    catch(( truth(sg_front:place_checked(Options, Class, Behind), Found) ),
          error(usage_error(_), _), Found = no).
test(addresses, [ forall(member(Behind-Host-Port-Page,
       [ none-'127.0.0.1'-80-'http://127.0.0.1:80/',
         none-'0.0.0.0'-8080-'http://localhost:8080/',
         'https://a/b'-x-1-'https://a/b/', 'https://a/'-x-1-'https://a/' ])),
                  true(Found == Page) ]) :-
    sg_front:page_address(Behind, Host, Port, Found).
test(class_code, Lines == ["http://a/",10]) :-
    with_output_to(string(Text), sg_front:class_opened(true, 'http://a/')),
    sg_front:class_code(Code),
    retractall(sg_front:class_code(_)),
    split_string(Text, "#\n", "", [Page,Printed,""]),
    assertion(Printed == Code),
    string_length(Code, Length),
    Lines = [Page,Length].

pupil("0123456789abcdef0123456789abcdef").

test(joins, [ forall(member(Given-Head-Who,
       [ "token"-_{}-owner, "code"-_{}-nobody, "other"-_{}-nobody,
         "code"-_{pupil:"0123"}-nobody,
         "code"-_{pupil:"0123456789abcdef0123456789abcdef"}
               -'pupil 0123456789abcdef0123456789abcdef',
         "token"-_{pupil:"0123456789abcdef0123456789abcdef"}-owner,
         5-_{}-nobody ])),
              true(Found == Who) ]) :-
    with_front("token", "code",
               ( sg_front:joins(Given, "token", Head, front(h,1,'/w',true),
                                Found0, Own)
               ->  Found = Found0,
                   ( Found == owner -> Own == front(h,1,'/w',true)
                   ; Own = front(h,1,'/w',pupil(Pupil)), pupil(Pupil) )
               ;   Found = nobody )).
test(joins_no_class, fail) :-
    pupil(Pupil),
    sg_front:joins("code", "token", _{pupil:Pupil}, front(h,1,'/w',true), _, _).

test(shows, Shows == [all,null]) :-
    with_front("t", "c", sg_front:may_show(owner, Shows1)),
    with_front("t", none, sg_front:may_show(owner, Shows2)),
    Shows = [Shows1,Shows2].
test(json, Found == [yes,no,no]) :-
    findall(Truth, ( member(Text, ["{\"a\":1}", "[1]", "{"]),
                     truth(sg_front:json_dict(Text, _), Truth) ), Found).

:- end_tests(front).
