/* The files of the page: by name, and where they never change. */
:- module(test_page_file, []).
:- use_module(library(filesex)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(zlib)).
:- use_module(rules(message/studio_words), [studio_word/3]).
:- use_module(rules(studio/page_file)).

web(Name, Octets) :-
    absolute_file_name(sanggwan(web), Folder, [file_type(directory)]),
    directory_files(Folder, Names),
    member(Name, Names),
    \+ sub_atom(Name, 0, _, _, '.'),
    Name \== 'index.html',
    directory_file_path(Folder, Name, File),
    exists_file(File),
    setup_call_cleanup(open(File, read, In, [type(binary)]),
                       read_string(In, _, Octets),
                       close(In)).

folder(Folder) :-
    page_file(/, plain, _, Page),
    once(sub_string(Page, Before, _, _, "/main.js\"")),
    sub_string(Page, 0, Before, _, Start),
    split_string(Start, "\"", "", Parts),
    last(Parts, Folder).

:- begin_tests(page_file).

test(each, forall(web(Name, _))) :-
    once(web(Name, Octets)),
    folder(Folder),
    findall(Text,
            ( member(In, ["",Folder]),
              ( In == "" -> atom_concat(/, Name, Path)
              ; atomic_list_concat([/,In,/,Name], Path) ),
              page_file(Path, plain, Type, Text),
              assertion(typed(Name, Type)) ),
            Found),
    Found == [Octets,Octets].
test(stays, Found == [yes,no,no]) :-
    folder(Folder),
    format(atom(There), "/~w/main.js", [Folder]),
    findall(Truth, ( member(Path, [There,'/main.js',/]),
                     ( page_file_stays(Path) -> Truth = yes ; Truth = no ) ),
            Found).
test(none, [ forall(member(Path, [ '/main.jsx', '/../main.js', 'main.js',
                                   '/other/main.js', '', '//main.js' ])),
             fail ]) :-
    page_file(Path, plain, _, _).
test(page_is_nowhere_else, fail) :-
    folder(Folder),
    format(atom(There), "/~w/index.html", [Folder]),
    page_file(There, plain, _, _).
test(page, Type == 'text/html') :-
    page_file(/, plain, Type, Page),
    page_file('/index.html', plain, Type, Page),
    \+ sub_string(Page, _, _, _, "=\"./").
test(packed, [ forall(member(Path, [/,'/main.js','/words.json'])),
               true(Plain == Unpacked) ]) :-
    page_file(Path, plain, Type, Plain),
    page_file(Path, gzip, Type, Packed),
    string_length(Packed, Less),
    string_length(Plain, More),
    assertion(Less < More),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary)]),
        ( format(Out, "~s", [Packed]),
          close(Out),
          setup_call_cleanup(gzopen(File, read, In, [type(binary)]),
                             read_string(In, _, Unpacked),
                             close(In)) ),
        delete_file(File)).
test(words, [true(N == All)]) :-
    page_file('/words.json', plain, 'application/json', Text),
    string_codes(Text, Octets),
    phrase_from_octets(Octets, Json),
    atom_json_dict(Json, Dict, []),
    dict_pairs(Dict, _, Pairs),
    length(Pairs, N),
    aggregate_all(count, studio_word(_, _, _), All),
    forall(member(Key-[En,Ko], Pairs),
           ( studio_word(Key, En0, Ko0),
             atom_string(En0, En),
             atom_string(Ko0, Ko) )).

:- end_tests(page_file).

typed(Name, Type) :-
    file_name_extension(_, Ending, Name),
    memberchk(Ending-Type, [js-'text/javascript', css-'text/css',
                            svg-'image/svg+xml', json-'application/json']).

%   phrase_from_octets(Octets, Text): UTF-8.

phrase_from_octets(Octets, Text) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary)]),
        ( format(Out, "~s", [Octets]),
          close(Out),
          read_file_to_string(File, Text, [encoding(utf8)]) ),
        delete_file(File)).
