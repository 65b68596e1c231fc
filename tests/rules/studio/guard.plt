:- module(test_guard, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(yall)).
:- use_module(rules(studio/guard)).

% covers: guard

:- begin_tests(guard).

secrets(Secrets) :-
    findall(Secret, ( between(1, 64, _), new_secret(Secret) ), Secrets).

test(secret, Lengths == [32]) :-
    secrets(Secrets),
    findall(Length, ( member(Secret, Secrets), string_length(Secret, Length) ),
            Lengths0),
    sort(Lengths0, Lengths).

test(digits, Others == []) :-
    secrets(Secrets),
    findall(C, ( member(Secret, Secrets), string_chars(Secret, Cs),
                 member(C, Cs), \+ char_type(C, xdigit(_)) ), Others).

test(differ) :-
    secrets(Secrets),
    sort(Secrets, Unique),
    length(Unique, 64).

test(same) :-
    new_secret(Secret),
    same_secret(Secret, Secret).

test(prefix, fail) :-
    new_secret(Secret),
    sub_string(Secret, 0, 31, _, Part),
    same_secret(Part, Secret).

test(last, fail) :-
    same_secret("00000000000000000000000000000001",
                "00000000000000000000000000000000").

test(atom, fail) :-
    new_secret(Secret),
    atom_string(Atom, Secret),
    same_secret(Atom, Secret).

test(not_same, fail) :-
    new_secret(One),
    new_secret(Other),
    same_secret(One, Other).


% --- addresses ---------------------------------------------------------------

front(front('127.0.0.1',8080,'/w',true)).
everywhere(front('0.0.0.0',80,'/w',true)).

:- meta_predicate behind(+, 0), truth(0, -).

behind(URL, Goal) :-
    setup_call_cleanup(behind_begun(URL), Goal, behind_begun(none)).

truth(Goal, Truth) :-
    ( call(Goal) -> Truth = yes ; Truth = no ).

test(host, [ forall(member(Front-Request-Truth,
       [ here-[host('127.0.0.1'),port(8080)]-yes,
         here-[host(localhost),port(8080)]-yes,
         here-[host('127.0.0.1'),port(8081)]-no,
         here-[host('127.0.0.1')]-no,
         here-[host('127.0.0.2'),port(8080)]-no,
         here-[host('evil.example'),port(8080)]-no,
         here-[]-no,
         here-[host(localhost),host(localhost),port(8080)]-no,
         here-[host(localhost),port(8080),request_uri('/a')]-yes,
         here-[host(localhost),port(8080),request_uri('http://evil/a')]-no,
         there-[host('192.168.0.7')]-yes, there-[host(localhost)]-yes,
         there-[host('0.0.0.0')]-yes,
         there-[host('evil.example')]-no, there-[host('1.2.3')]-no,
         there-[host('1.2.3.256')]-no, there-[host('1.2.3.255')]-yes,
         there-[host('1.2.3.0004')]-no, there-[host('1.2.3.')]-no,
         there-[host('1.2.3.x4')]-no, there-[host('1.2.3.4.5')]-no ])),
             true(Found == Truth) ]) :-
    (   Front == here
    ->  front(Of)
    ;   everywhere(Of)
    ),
    truth(host_allowed(Request, Of), Found).
test(host_behind, [ forall(member(URL-Request-Truth,
       [ 'https://site.example/a/'-[host('site.example'),port(443)]-yes,
         'https://site.example/a/'-[host('SITE.example')]-yes,
         'https://site.example/a/'-[host('site.example'),port(444)]-no,
         'https://other.example/'-[host('site.example')]-no,
         'http://site.example'-[host('site.example')]-yes,
         'http://site.example:99/'-[host('site.example'),port(99)]-yes,
         'http://Site.example:99/'-[host('site.example')]-yes,
         'http://site.example:99/'-[host('site.example'),port(98)]-no,
         'http://site.example'-[host('127.0.0.1'),port(8080)]-yes ])),
                    true(Found == Truth) ]) :-
    front(Of),
    behind(URL, truth(host_allowed(Request, Of), Found)).
test(not_behind_any_more, Found == no) :-
    front(Of),
    behind('http://site.example', true),
    truth(host_allowed([host('site.example')], Of), Found).
test(bad_proxy, [ forall(member(URL, [ 'ftp://a', 'site.example', 'http://',
                                       'http:///a', 'http://a b/', 'http://a:x',
                                       'http://a:1.5', 'http://a:1:2',
                                       'http://\u00e9.fr', 'http://a@b' ])),
                  error(usage_error(behind(URL)), _) ]) :-
    behind_begun(URL).
test(origin, [ forall(member(Front-Request-Truth,
       [ here-[origin('http://127.0.0.1:8080')]-yes,
         here-[origin('http://localhost:8080')]-yes,
         here-[origin('http://127.0.0.1')]-no,
         here-[origin('http://127.0.0.1:80800')]-no,
         here-[origin('https://127.0.0.1:8080')]-no,
         here-[origin('http://evil:8080')]-no,
         here-[origin(null)]-no, here-[]-no,
         here-[origin('http://localhost:8080'),
               origin('http://localhost:8080')]-no,
         there-[origin('http://localhost')]-yes,
         there-[origin('http://localhost:80')]-yes,
         there-[origin('http://10.0.0.1')]-yes,
         there-[origin('http://a.b')]-no ])),
               true(Found == Truth) ]) :-
    (   Front == here
    ->  front(Of)
    ;   everywhere(Of)
    ),
    truth(origin_allowed(Request, Of), Found).
test(origin_behind, Found == [yes,no,no]) :-
    front(Of),
    behind('https://Site.example:99/x',
           findall(Truth,
                   ( member(Origin, [ 'https://site.example:99',
                                      'https://site.example',
                                      'http://site.example:99' ]),
                     truth(origin_allowed([origin(Origin)], Of), Truth) ),
                   Found)).
test(loopback, Found == [yes,yes,yes,no,no,no,no]) :-
    findall(Truth,
            ( member(Address, [ localhost, '127.0.0.1', '127.9.9.9',
                                '128.0.0.1', '0.0.0.0', '127.0.0.1.evil.com',
                                '127.evil.com' ]),
              truth(is_loopback(Address), Truth) ),
            Found).
test(frames, [ forall(member(URL-Frames,
                             [ none-'\'none\'', 'https://a.b'-'https://a.b',
                               'http://A.b:7/'-'http://a.b:7' ])),
               true(Found == Frames) ]) :-
    setup_call_cleanup(embed_begun(URL),
                       security_header('Content-Security-Policy', Policy),
                       embed_begun(none)),
    once(( sub_atom(Policy, B, _, _, 'frame-ancestors '),
           From is B+16,
           sub_atom(Policy, From, _, 0, Found) )).
test(bad_frames, [ forall(member(URL, ['https://a.b/c','ftp://a','a.b'])),
                   error(usage_error(embed(URL)), _) ]) :-
    embed_begun(URL).
test(headers, Names == [ 'Cache-Control', 'Content-Security-Policy',
                         'Cross-Origin-Opener-Policy',
                         'Cross-Origin-Resource-Policy', 'Referrer-Policy',
                         'X-Content-Type-Options' ]) :-
    findall(Name, security_header(Name, _), Names0),
    sort(Names0, Names).
test(policy, [ forall(member(Part, [ 'default-src \'none\';',
                                     'script-src \'self\';',
                                     'base-uri \'none\';',
                                     'form-action \'none\';' ])) ]) :-
    security_header('Content-Security-Policy', Policy),
    once(sub_atom(Policy, _, _, _, Part)).
test(pupil, Found == [yes,yes,no,no,no,no,no]) :-
    findall(Truth,
            ( member(Secret, [ "0123456789abcdef0123456789abcdef",
                               "0123456789ABCDEF0123456789abcdef",
                               "0123456789abcdef0123456789abcde",
                               "0123456789abcdef0123456789abcdef0",
                               "0123456789abcdeg0123456789abcdef",
                               "\u06600123456789abcdef0123456789abcde",
                               '0123456789abcdef0123456789abcdef' ]),
              truth(pupil_secret(Secret), Truth) ),
            Found).

% --- requests ----------------------------------------------------------------

allowed(Head, Allowed) :-
    allowed(true, Head, Allowed).

allowed(Owner, Head, Allowed) :-
    catch(request_allowed(front('127.0.0.1',8080,'/w',Owner), Head, Dict),
          error(request_error(Allowed), _), true),
    (   is_dict(Dict)
    ->  dict_pairs(Dict, _, Allowed)
    ;   true
    ).

test(not_offered, [ forall(member(Do, ["hello","run","cd","",null,5])),
                    Allowed == not_offered(Do) ]) :-
    allowed(_{do:Do}, Allowed).
test(without_do, Allowed == not_offered("")) :-
    allowed(_{}, Allowed).
test(keys, Allowed == [at-3,do-"undo",progress-true]) :-
    allowed(_{do:"undo", at:3, progress:true, journal:"/etc/x", id:1,
              owner:true}, Allowed).
%   What each may say, and nothing else.
test(each_key, [ forall(member(Do-Keys,
       [ "next"-[of], "explain"-[item,lang,options], "select"-[keep,names],
         "sheet"-[options,pens], "shaded"-[options], "fold"-[options,segment],
         "unfold"-[options,segment,sheet], "edit"-[set],
         "cut"-[edge,keep,segment], "question"-[goal,name], "text"-[],
         "tree"-[], "redo"-[], "reload"-[look], "complete"-[text],
         "help"-[of], "stop"-[of],
         "view"-[before,crease,explode,format,hidden,lines,margin,port,
                 projection,scale,section,segments,size,up,view],
         "ask"-[crease,format,goal,hidden,lines,margin,projection,scale,
                segments,size,up,view] ])),
                 true(Found == Keys) ]) :-
    All = [ argv,before,crease,edge,explode,file,force,format,goal,hidden,item,
            journal,keep,lang,lines,look,margin,memory_mb,name,names,of,options,
            pens,port,projection,rules,scale,section,segment,segments,set,
            sheet,size,text,up,upload,view ],
    findall(Key-[], member(Key, All), Pairs),
    dict_pairs(Head, _, [do-Do|Pairs]),
    allowed(Head, Allowed),
    findall(Key, ( member(Key-_, Allowed), Key \== do ), Found).
test(options, [ forall(member(Options-Truth,
       [ []-yes, ["--view","20,70"]-yes, ["--view=20,70"]-yes,
         ["--scale","-2"]-yes, ["--json"]-yes, ["--no-frame","--json"]-yes,
         ["--json","x"]-no, ["x"]-no, ["--view","a","b"]-no,
         ["--view=1","b"]-no, ["--rules","r"]-no, ["-o","a"]-no,
         ["--output=a"]-no, ["--view","a.pl"]-no, ["--view=a.obj"]-no,
         ["--view","a/b"]-no, ["--view=a/b"]-no, ["--view=a=b"]-no,
         ["--view","a\u0000"]-no, [view]-no, "--json"-no, [5]-no,
         ["--style","x"]-no, ["--title-block","x"]-no, ["--set","a=1"]-no,
         ["--title","A part"]-yes, ["--see-through","1"]-yes ])),
                true(Found == Truth) ]) :-
    allowed(_{do:"sheet", options:Options}, Allowed),
    (   Allowed = [_|_]
    ->  Found = yes
    ;   assertion(Allowed == bad_key(options, offered)),
        Found = no
    ).
test(exports, [ forall(member(Argv-What,
       [ ["draw","--view","front"]-yes, ["unfold"]-yes, ["convert"]-yes,
         ["render"]-yes, ["check"]-bad_key(argv, export),
         []-bad_key(argv, export), "draw"-bad_key(argv, export),
         ["draw","a.pl"]-bad_key(options, offered) ])),
                true(Found == What) ]) :-
    allowed(_{do:"export", argv:Argv}, Allowed),
    ( Allowed = [_|_] -> Found = yes ; Found = Allowed ).
test(rules, [ forall(member(Owner-Head-Allowed,
       [ true-_{do:"rules",keep:true}-[do-"rules",keep-true,owner-true],
         true-_{do:"rules",try:"x."}-[do-"rules",owner-true,try-"x."],
         true-_{do:"rules",keep:false}-[do-"rules",keep-false],
         false-_{do:"rules",keep:true}-owner_alone(rules),
         false-_{do:"rules",try:""}-owner_alone(rules),
         false-_{do:"rules"}-[do-"rules"] ])),
              true(Found == Allowed) ]) :-
    allowed(Owner, Head, Found).
test(pupils_save, Allowed == owner_alone(save)) :-
    allowed(pupil("x"), _{do:"save"}, Allowed).

% --- files -------------------------------------------------------------------

test(upload, [ forall(member(Name-Truth,
       [ "a.pl"-yes, "a b+c_1-2.obj"-yes, "A.STL"-yes, ".pl"-no, "a"-no,
         "a.txt"-no, "a/b.pl"-no, "../b.pl"-no, "-a.pl"-no, " a.pl"-no,
         "a\u0000.pl"-no, "a;b.pl"-no, ""-no, 'a.pl'-no ])),
               true(Found == Truth) ]) :-
    named(Name, Found).
test(upload_length, Found == [yes,no]) :-
    findall(Truth,
            ( member(N, [97,98]),
              length(Codes, N),
              maplist(=(0'a), Codes),
              format(string(Name), "~s.pl", [Codes]),
              named(Name, Truth) ),
            Found).

named(Name, Truth) :-
    catch(( upload_name(Name), Truth = yes ),
          error(request_error(bad_key(name, upload)), _), Truth = no).

%   A folder with a file, a folder, and links within it and out of it.
with_folder(Goal) :-
    tmp_file(guard, Top),
    atom_concat(Top, '/w', Folder),
    atom_concat(Top, '/out.pl', Out),
    setup_call_cleanup(
        ( make_directory_path(Folder),
          atom_concat(Folder, '/in', In),
          make_directory(In),
          touched(Out),
          atom_concat(In, '/b.pl', B),
          touched(B),
          forall(member(Link-To, [ 'l.pl'-'in/b.pl', 'o.pl'-Out, i-in,
                                   up-'..' ]),
                 ( atomic_list_concat([Folder,/,Link], Path),
                   link_file(To, Path, symbolic) )) ),
        call(Goal, Folder),
        delete_directory_and_contents(Top)).

touched(File) :-
    setup_call_cleanup(open(File, write, Out), true, close(Out)).

told(Name, Found, Folder) :-
    catch(file_allowed(Folder, Name, Found),
          error(request_error(outside(Name)), _), Found = no).

absolute(Found, Folder) :-
    findall(Path,
            ( member(Name, ['in/b.pl','../out.pl']),
              atomic_list_concat([Folder,/,Name], File),
              atom_string(File, Text),
              told(Text, Path, Folder) ),
            Found).

test(file, [ forall(member(Name-Path,
       [ "a.pl"-"a.pl", "in/b.pl"-"in/b.pl", "in/../in/b.pl"-"in/b.pl",
         "l.pl"-"in/b.pl", "i/b.pl"-"in/b.pl", "up/w/in/b.pl"-"in/b.pl",
         "o.pl"-no, "../out.pl"-no, "up/out.pl"-no, "/etc/a.pl"-no,
         "in/b.txt"-no, "a\u0000.pl"-no, ""-no ])),
             true(Found == Path) ]) :-
    with_folder(told(Name, Found)).
test(absolute_file, Found == ["in/b.pl",no]) :-
    with_folder(absolute(Found)).
%   One whose name begins as that of the folder does is outside.
test(neighbour, Found == no) :-
    with_folder([Folder]>>( atom_concat(Folder, 'x.pl', File),
                            atom_string(File, Name),
                            told(Name, Found0, Folder),
                            nb_setval(test_guard_found, Found0) )),
    nb_getval(test_guard_found, Found).

:- end_tests(guard).
