:- module(sg_guard,
          [ host_allowed/2,             % +Request, +Front
            origin_allowed/2,           % +Request, +Front
            behind_begun/1,             % +URL
            embed_begun/1,              % +URL
            is_loopback/1,              % +Address
            same_secret/2,              % +Given, +Token
            new_secret/1,               % -Token
            pupil_secret/1,             % +Secret
            request_allowed/3,          % +Front, +Head, -Allowed
            upload_name/1,              % +Name
            upload_folder/2,            % +Owner, -Folder
            journal_folder/2,           % +Whose, -Folder
            file_allowed/3,             % +Folder, +Name, -Path
            security_header/2           % ?Name, ?Value
          ]).
:- use_module('../environment', [state_folder/1]).
:- use_module('../model/model', [model_format/2]).
:- use_module(visitor_answer, [class_file/1, class_opens/1, class_pupil/2]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> What a visitor of the studio may do.

A page of another site can send requests to a server on the same machine. So the
front answers only requests that name it by an address of its own, opens sockets
only for its own page, and listens only to those who know a secret, which is
made when the front starts and is in the address that it prints. What these ask
of a session is looked through here, word by word: what is not listed does not
get there.
*/


                /*******************************
                *          ADDRESSES           *
                *******************************/

% behind_(Place, Origin): a proxy has the page of this front at Place, host and
% port, and Origin is that of pages there. embed_(Origin): pages of it show this
% one.
:- dynamic behind_/2, embed_/1.

%!  behind_begun(+URL) is det.
%
%   A proxy sends what is asked of URL, as http://host/path/, to this front; or
%   no proxy does, if URL is `none`.
%
%   @error usage_error(behind(URL))

behind_begun(URL) :-
    retractall(behind_(_, _)),
    (   URL == none
    ->  true
    ;   page_origin(URL, Place, Origin, _)
    ->  assertz(behind_(Place, Origin))
    ;   throw(error(usage_error(behind(URL)), _))
    ).

%   page_origin(URL, Place, Origin, Path) is semidet: of a page; Path are the
%   names after the host.

page_origin(URL, Host-Given, Origin, Path) :-
    member(Scheme-Port, ['https://'-443,'http://'-80]),
    atom_concat(Scheme, Rest, URL),
    !,
    atomic_list_concat([Place0|Path], /, Rest),
    place_of(Place0, Port, Host, Given),
    atom_codes(Host, Codes),
    Codes \== [],
    forall(member(Code, Codes),
           ( Code < 128, ( code_type(Code, csym) ; memberchk(Code, `.-`) ) )),
    downcase_atom(Place0, Place),
    atom_concat(Scheme, Place, Origin).

%!  embed_begun(+URL) is det.
%
%   Pages of the origin URL, as https://host, may show this one in a frame; none
%   may, if URL is `none`.
%
%   @error usage_error(embed(URL))

embed_begun(URL) :-
    retractall(embed_(_)),
    (   URL == none
    ->  true
    ;   page_origin(URL, _, Origin, Path),
        memberchk(Path, [[],['']])
    ->  assertz(embed_(Origin))
    ;   throw(error(usage_error(embed(URL)), _))
    ).

%   place_of(Place, Usual, Host, Port)

place_of(Place, Usual, Host, Port) :-
    (   atomic_list_concat([Host0,Text], :, Place)
    ->  atom_number(Text, Port),
        integer(Port)
    ;   Host0 = Place,
        Port = Usual
    ),
    downcase_atom(Host0, Host).

%!  host_allowed(+Request, +Front) is semidet.
%
%   The HTTP request Request says, once, that it is for Front, front(Bound,
%   Port, _, _): a name of this machine that no one else can give a meaning
%   to. A whole address where the path stands would say it a second time.

host_allowed(Request, front(Bound,Port,_,_)) :-
    forall(member(request_uri(Path), Request), sub_atom(Path, 0, _, _, /)),
    findall(Host-Given, host_given(Request, Host, Given), [Name-Asked]),
    (   Asked == Port,
        host_name(Bound, Name)
    ->  true
    ;   downcase_atom(Name, Lower),
        behind_(Lower-Given, _),
        memberchk(Asked, [Given,80])    % a host without a port is read as 80
    ).

host_given(Request, Host, Port) :-
    member(host(Host), Request),
    (   memberchk(port(Port0), Request)
    ->  Port = Port0
    ;   Port = 80
    ).

host_name(_, '127.0.0.1').
host_name(_, localhost).
host_name(Bound, Bound) :-
    Bound \== '0.0.0.0'.
host_name('0.0.0.0', Name) :-
    is_address(Name).

%   is_address(Name): four numbers. Who owns a name may point it anywhere; who
%   writes an address may not.

is_address(Name) :-
    atomic_list_concat(Parts, '.', Name),
    Parts = [_,_,_,_],
    maplist(is_octet, Parts).

is_octet(Part) :-
    atom_length(Part, Length),
    Length =< 3,
    atom_codes(Part, Codes),
    Codes \== [],
    forall(member(Code, Codes), ( Code >= 0'0, Code =< 0'9 )),
    number_codes(N, Codes),
    N =< 255.

%!  origin_allowed(+Request, +Front) is semidet.
%
%   The page that sends Request is the page of Front.

origin_allowed(Request, front(Bound,Port,_,_)) :-
    findall(Origin, member(origin(Origin), Request), [Origin]),
    (   behind_(_, Origin)
    ->  true
    ;   own_origin(Origin, Bound, Port)
    ).

own_origin(Origin, Bound, Port) :-
    atom_concat('http://', Place, Origin),
    (   atomic_list_concat([Name,PortText], :, Place)
    ->  atom_number(PortText, Port)
    ;   Name = Place,
        Port == 80
    ),
    once(host_name(Bound, Name)).

%!  is_loopback(+Address) is semidet.
%
%   What Address, the text of one, reaches is this machine.

is_loopback(localhost).
is_loopback(Address) :-
    is_address(Address),
    atom_concat('127.', _, Address).


                /*******************************
                *            SECRET            *
                *******************************/

%!  new_secret(-Token:string) is det.
%
%   128 bits that nobody can guess.

new_secret(Token) :-
    setup_call_cleanup(
        open('/dev/urandom', read, In, [type(binary), buffer(false)]),
        ( length(Octets, 16),
          maplist(get_byte(In), Octets)
        ),
        close(In)),
    findall(Text, ( member(Octet, Octets),
                    format(atom(Text), "~|~`0t~16r~2+", [Octet]) ),
            Texts),
    atomics_to_string(Texts, Token).

%!  same_secret(+Given, +Token) is semidet.
%
%   The time this takes says nothing of where they differ.

same_secret(Given, Token) :-
    string(Given),
    string_length(Token, Length),
    string_length(Given, Length),
    string_codes(Given, Codes1),
    string_codes(Token, Codes2),
    differences(Codes1, Codes2, 0, Difference),
    Difference =:= 0.

differences([], [], Difference, Difference).
differences([A|As], [B|Bs], Difference0, Difference) :-
    Difference1 is Difference0 \/ (A xor B),
    differences(As, Bs, Difference1, Difference).

%!  pupil_secret(+Secret) is semidet.
%
%   Secret is a string as the page of a pupil makes one: 128 bits, in 32 digits.

pupil_secret(Secret) :-
    string(Secret),
    string_length(Secret, 32),
    string_codes(Secret, Codes),
    forall(member(Code, Codes),
           ( code_type(Code, xdigit(_)), Code < 128 )).

%!  security_header(?Name, ?Value) is nondet.
%
%   Every reply has these: the page runs nothing but its own files, speaks with
%   nobody else, and stands in no frame of another that may not embed it.

security_header('Content-Security-Policy', Policy) :-
    ( embed_(Frames) -> true ; Frames = '\'none\'' ),
    atom_concat('default-src \'none\'; script-src \'self\'; \c
        style-src \'self\'; img-src \'self\' blob:; \c
        connect-src \'self\'; base-uri \'none\'; form-action \'none\'; \c
        frame-ancestors ', Frames, Policy).
security_header('X-Content-Type-Options', nosniff).
security_header('Referrer-Policy', 'no-referrer').
security_header('Cross-Origin-Resource-Policy', 'same-origin').
security_header('Cross-Origin-Opener-Policy', 'same-origin').
security_header('Cache-Control', 'no-cache').


                /*******************************
                *           REQUESTS           *
                *******************************/

%!  request_allowed(+Front, +Head:dict, -Allowed:dict) is det.
%
%   Allowed is what the session is asked when a visitor of Front sends Head:
%   keys that are not listed are left out, and those that only the front may say
%   are the front's. Front is front(_, _, Folder, Owner); Owner is true if
%   visitors may run code.
%
%   @error request_error(not_offered(Do)), request_error(outside(File)),
%   request_error(answers_inside(File)),
%   request_error(owner_alone(rules)), request_error(bad_key(options, offered))

request_allowed(Front, Head, Allowed) :-
    (   get_dict(do, Head, Do),
        string(Do),
        keys(Do, Keys)
    ->  true
    ;   ( get_dict(do, Head, Do) ; Do = "" )
    ->  request_error(not_offered(Do))
    ),
    findall(Key-Value,
            ( member(Key, [do,at,progress|Keys]),
              get_dict(Key, Head, Value) ),
            Pairs),
    dict_pairs(Allowed0, _, Pairs),
    looked_through(Do, Front, Allowed0, Allowed).

%   keys(Do, Keys): what a request may say.

keys("open",     [file,replay,upload]).
keys("view",     [port,section,explode,before|Keys]) :-
    view_keys(Keys).
keys("sheet",    [options,pens]).
keys("shaded",   [options]).
keys("ask",      [goal|Keys]) :-
    view_keys(Keys).
keys("next",     [of]).
keys("explain",  [item,options,lang]).
keys("export",   [argv,lang]).
keys("select",   [names,keep]).
keys("unfold",   [segment,options,sheet]).
keys("fold",     [segment,options]).
keys("edit",     [set]).
keys("cut",      [segment,edge,keep]).
keys("question", [name,goal]).
keys("text",     []).
keys("tree",     []).
keys("problems", []).
keys("problem",  [problem,number,answers,show,lang]).
keys("undo",     []).
keys("redo",     []).
keys("rules",    [try,keep|Keys]) :-
    view_keys(Keys).
keys("reload",   [look]).
keys("save",     [file,force]).
keys("complete", [text]).
keys("help",     [of]).
keys("stop",     [of]).

view_keys([ format,view,projection,lines,hidden,up,crease,size,scale,margin,
            segments ]).

looked_through("open", front(_,_,_,Owner), Head0, Head) :-
    get_dict(upload, Head0, true),
    !,
    name_of(Head0, Name),
    upload_name(Name),
    upload_folder(Owner, Folder),
    file_allowed(Folder, Name, Path0),
    atomic_list_concat([Folder,/,Path0], Path),
    journal_of(Owner, Path, Journal, Code),
    Head = Head0.put(_{file:Path, journal:Journal, owner:Code}).
looked_through("open", front(_,_,Folder,Owner), Head0, Head) :-
    !,
    name_of(Head0, Name),
    file_allowed(Folder, Name, Path),
    absolute_file_name(Path, Absolute, [relative_to(Folder)]),
    (   Owner = pupil(_),
        \+ class_opens(Absolute)
    ->  request_error(answers_inside(Name))
    ;   true
    ),
    journal_of(Owner, Absolute, Journal, Code),
    Head = Head0.put(_{file:Path, journal:Journal, owner:Code}).
looked_through("save", front(_,_,_,pupil(_)), _, _) :-
    !,
    request_error(owner_alone(save)).
looked_through("save", front(_,_,Folder,_), Head0, Head) :-
    get_dict(file, Head0, _),
    !,
    name_of(Head0, Name),
    (   file_name_extension(_, pl, Name)
    ->  true
    ;   request_error(bad_key(file, file))
    ),
    file_allowed(Folder, Name, Path),
    Head = Head0.put(file, Path).
looked_through("rules", front(_,_,_,Owner), Head0, Head) :-
    ( get_dict(keep, Head0, true) ; get_dict(try, Head0, _) ),
    !,
    (   Owner == true
    ->  Head = Head0.put(owner, true)
    ;   request_error(owner_alone(rules))
    ).
looked_through(Do, front(_,_,_,Owner), Head0, Head) :-
    memberchk(Do, ["problems","problem"]),
    !,
    (   class_file(File)
    ->  true
    ;   request_error(no_class)
    ),
    atom_string(File, Name),
    (   Owner = pupil(Secret)
    ->  atom_concat('pupil ', Secret, Who),
        (   class_pupil(Who, Pupil)
        ->  true
        ;   Do == "problems"
        ->  Pupil = _{}
        ;   request_error(not_in_class)
        ),
        ( del_dict(number, Head0, _, Head1) -> true ; Head1 = Head0 ),
        (   get_dict(name, Pupil, Called)
        ->  Head2 = Head1.put(_{pupil:Called, turn:Pupil.turn})
        ;   Head2 = Head1
        )
    ;   Head2 = Head0
    ),
    Head = Head2.put(file, Name).
looked_through("export", _, Head, Head) :-
    !,
    (   get_dict(argv, Head, [Verb|Options]),
        memberchk(Verb, ["draw","unfold","convert","render"])
    ->  options_allowed(Options)
    ;   request_error(bad_key(argv, export))
    ).
looked_through(_, _, Head, Head) :-
    (   get_dict(options, Head, Options)
    ->  options_allowed(Options)
    ;   true
    ).

%   journal_of(Owner, Path, Journal, Code): the journal of a document; Code is
%   true if it may hold rules. That of a pupil is his own, in a name that is not
%   his secret.

journal_of(pupil(Secret), Path, Journal, false) :-
    !,
    journal_folder(pupil, Folder),
    file_base_name(Path, Base),
    format(string(Of), "~w ~w", [Secret,Path]),
    sha_hash(Of, Hash, [algorithm(sha256), encoding(utf8)]),
    hash_atom(Hash, Digest),
    sub_atom(Digest, 0, 16, _, Short),
    format(string(Journal), "~w/~w-~w.journal", [Folder, Base, Short]).
journal_of(Owner, _, true, Owner).

name_of(Head, Name) :-
    (   get_dict(file, Head, Name),
        string(Name)
    ->  true
    ;   request_error(bad_key(file, file))
    ).

%   options_allowed(Options): none reads or writes a file, and each word that is
%   no option is the value of the one before it: else it would be a model.

options_allowed(Options) :-
    (   is_list(Options),
        forall(member(Option, Options), option_allowed(Option)),
        \+ ( append(Before, [Word|_], Options),
             \+ is_option(Word),
             \+ ( append(_, [Option], Before), awaits_value(Option) ) )
    ->  true
    ;   request_error(bad_key(options, offered))
    ).

is_option(Word) :-
    string_concat("-", _, Word),
    \+ number_string(_, Word).

awaits_value(Option) :-
    is_option(Option),
    \+ sub_string(Option, _, _, _, "="),
    \+ memberchk(Option, ["--json","--no-frame"]).

option_allowed(Option) :-
    string(Option),
    (   is_option(Option)
    ->  split_string(Option, "=", "", [Name|Value]),
        offered(Names),
        memberchk(Name, Names),
        ( Value == [] -> true ; Value = [Text], word_allowed(Text) )
    ;   word_allowed(Option)
    ).

%   word_allowed(Word): the value of an option. A folder has no place in one,
%   nor has the name of a model.

word_allowed(Word) :-
    \+ model_format(Word, _),
    \+ sub_string(Word, _, _, _, "/"),
    \+ sub_string(Word, _, _, _, "\u0000").

offered([ "--view","--projection","--lines","--hidden","--crease","--up",
          "--scale","--sheet","--size","--margin","--views","--angle",
          "--unit","--format","--json","--only","--tabs","--paper","--cut",
          "--keep","--language","--eye","--target","--title","--part",
          "--section","--explode","--shade","--colours","--background",
          "--smooth","--palette","--direction","--no-frame","--dashes",
          "--png","--dpi","--segment","--see-through","--light","--window",
          "--cutaway" ]).


                /*******************************
                *            FILES             *
                *******************************/

%!  upload_name(+Name:string) is det.
%
%   A file that a page sends may be called Name: that of a model, without a
%   folder.
%
%   @error request_error(bad_key(name, upload))

upload_name(Name) :-
    (   string(Name),
        string_length(Name, Length),
        Length =< 100,
        model_format(Name, _),
        string_codes(Name, [First|Codes]),
        forall(member(Code, [First|Codes]),
               ( code_type(Code, csym) ; memberchk(Code, `-.+ `) )),
        \+ memberchk(First, `.- `)
    ->  true
    ;   request_error(bad_key(name, upload))
    ).

%!  upload_folder(+Owner, -Folder) is det.
%
%   Folder has what the owner, or a pupil, pupil(Secret), sent: beside the
%   journals, so it is there after the program was killed.

upload_folder(Owner, Folder) :-
    ( Owner = pupil(Secret) -> Of = Secret ; Of = owner ),
    journal_folder(owner, State),
    sha_hash(Of, Hash, [algorithm(sha256), encoding(utf8)]),
    hash_atom(Hash, Digest),
    sub_atom(Digest, 0, 16, _, Short),
    atomic_list_concat([State,'/uploads/',Short], Folder).

%!  journal_folder(+Whose, -Folder) is det.
%
%   Folder has the journals of the owner, or those of pupils.

journal_folder(owner, Folder) :-
    state_folder(State),
    atom_concat(State, '/sanggwan', Folder).
journal_folder(pupil, Folder) :-
    journal_folder(owner, State),
    atom_concat(State, '/class', Folder).

%!  file_allowed(+Folder, +Name, -Path) is det.
%
%   Path, from Folder on, is the file Name of Folder, or of a folder in it,
%   whatever is linked to what.
%
%   @error request_error(outside(Name))

file_allowed(Folder, Name, Path) :-
    real_path(Folder, Root),
    (   \+ sub_string(Name, _, _, _, "\u0000"),
        name_path(Folder, Name, Path0),
        catch(real_path(Path0, Real), error(_, _), fail),
        atom_concat(Root, Rest, Real),
        ( Root == (/) -> Local = Rest ; atom_concat(/, Local, Rest) ),
        model_format(Real, _)
    ->  atom_string(Local, Path)
    ;   request_error(outside(Name))
    ).

name_path(Folder, Name, Path) :-
    (   string_concat("/", _, Name)
    ->  atom_string(Path, Name)
    ;   atomic_list_concat([Folder,/,Name], Path)
    ).

%   real_path(Path, Real): without links; what is not there yet may be the last
%   name alone.

real_path(Path, Real) :-
    absolute_file_name(Path, Absolute),
    atomic_list_concat([_|Names], /, Absolute),
    real_path(Names, '', 40, Real).

real_path([], Real0, _, Real) :-
    (   Real0 == ''
    ->  Real = (/)
    ;   Real = Real0
    ).
real_path([Name|Names], Before, Links, Real) :-
    atomic_list_concat([Before,/,Name], Path),
    (   catch(read_link(Path, Link, _), error(_, _), fail)
    ->  Links > 0,
        Links1 is Links-1,
        link_path(Before, Link, Target),
        absolute_file_name(Target, Absolute),
        atomic_list_concat([_|Names1], /, Absolute),
        append(Names1, Names, Names2),
        real_path(Names2, '', Links1, Real)
    ;   real_path(Names, Path, Links, Real)
    ).

link_path(Before, Link, Target) :-
    (   sub_atom(Link, 0, 1, _, /)
    ->  Target = Link
    ;   atomic_list_concat([Before,/,Link], Target)
    ).
