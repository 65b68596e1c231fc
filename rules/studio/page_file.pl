:- module(sg_page_file,
          [ page_file/4,                % +Path, +Coding, -Type, -Octets
            page_file_stays/1,          % +Path
            page_files_expected/0
          ]).
:- use_module('../message/studio_words', [studio_word/3]).
:- use_module('../part', [carried_file/2]).
:- use_module('../plain', [plain_json/2]).
:- use_module(front_socket, [called/2]).
:- use_module(protocol, [text_octets/2]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(memfile),
              [ new_memory_file/1, free_memory_file/1, open_memory_file/4,
                memory_file_to_string/3
              ]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> The files of the studio's page: web/, which the program carries.

Each is served by its name, and also below a folder whose name is made of what
is in all of them. What has a name there never changes, so a browser keeps it.
The page itself, which has one name, says that folder.
*/

% page_folder(Folder): the folder that never changes; all files are there.
% page_octets(Name, Type, Plain, Packed): Packed is in the gzip format.
:- dynamic page_folder/1, page_octets/4.

%!  page_file(+Path, +Coding, -Type, -Octets:string) is semidet.
%
%   Path, as in an address, is a file of the page of this media Type. Octets
%   are its text in UTF-8, as it is, if Coding is `plain`, or in the gzip
%   format, if Coding is `gzip`.

page_file(Path, Coding, Type, Octets) :-
    with_mutex(sg_page_file, ( page_folder(_) -> true ; files_made )),
    path_name(Path, Name),
    page_octets(Name, Type, Plain, Packed),
    (   Coding == plain
    ->  Octets = Plain
    ;   Octets = Packed
    ).

%!  page_files_expected is det.
%
%   Somebody will ask for the files: they are made meanwhile, in a thread.

page_files_expected :-
    thread_create(catch(page_file(/, plain, _, _), _, true), _,
                  [detached(true)]).

%!  page_file_stays(+Path) is semidet.
%
%   What page_file/4 has at Path is there, and the same, in any program that has
%   something at Path.

page_file_stays(Path) :-
    path_parts(Path, [_,_]).

path_name(Path, Name) :-
    path_parts(Path, Parts),
    (   Parts = ['']
    ->  Name = 'index.html'
    ;   Parts = [Name]
    ->  true
    ;   page_folder(Folder),
        Parts = [Folder,Name],
        Name \== 'index.html'           % it says where the others are
    ).

path_parts(Path, Parts) :-
    atom_concat(/, Inner, Path),
    atomic_list_concat(Parts, /, Inner).

%   files_made: octets of all files are made once.

files_made :-
    findall(file(Name, Type, Text),
            ( served(Name, Type), file_text(Name, Text) ),
            Files0),
    page_words(Words),
    Files = [file('words.json', 'application/json', Words)|Files0],
    folder_of(Files, Folder),
    forall(member(file(Name, Type, Text0), Files),
           ( text_within(Name, Folder, Text0, Text),
             text_octets(Text, Plain),
             packed(Plain, Packed),
             assertz(page_octets(Name, Type, Plain, Packed)) )),
    assertz(page_folder(Folder)).

folder_of(Files, Folder) :-
    findall(Text, member(file(_, _, Text), Files), Texts),
    atomics_to_string(Texts, Whole),
    sha_hash(Whole, Hash, [algorithm(sha256),encoding(utf8)]),
    hash_atom(Hash, Hex),
    sub_atom(Hex, 0, 16, _, Folder).

%   text_within(Name, Folder, Text0, Text): what the page names as ./file is in
%   Folder.

text_within('index.html', Folder, Text0, Text) :-
    !,
    atomic_list_concat(Parts, '="./', Text0),
    format(atom(Between), '="~w/', [Folder]),
    atomic_list_concat(Parts, Between, Text).
text_within(_, _, Text, Text).

packed(Octets, Packed) :-
    setup_call_cleanup(
        new_memory_file(Memory),
        ( setup_call_cleanup(
              open_memory_file(Memory, write, Out, [encoding(octet)]),
              written_packed(Out, Octets),
              close(Out)),
          memory_file_to_string(Memory, Packed, octet)
        ),
        free_memory_file(Memory)).

written_packed(Out, Octets) :-
    setup_call_cleanup(
        called(zlib, zopen(Out, Zip, [ format(gzip), level(9),
                                       close_parent(false) ])),
        ( set_stream(Zip, encoding(octet)),
          format(Zip, "~s", [Octets]) ),
        close(Zip)).

file_text(Name, Text) :-
    (   atom_concat('web/', Name, Carried),
        carried_file(Carried, Stream)
    ->  set_stream(Stream, encoding(utf8)),
        call_cleanup(read_string(Stream, _, Text), close(Stream))
    ;   beside(Folder),
        atomic_list_concat([Folder,/,Name], File),
        read_file_to_string(File, Text, [encoding(utf8)])
    ).

%   beside(Folder): where the files are when no program carries them.

beside(Folder) :-
    module_property(sg_page_file, file(File)),
    file_directory_name(File, Studio),
    atom_concat(Studio, '/../../web', Folder).

served('index.html', 'text/html').
served('studio.css', 'text/css').
served('icon.svg', 'image/svg+xml').
served(Name, 'text/javascript') :-
    script(Script),
    atom_concat(Script, '.js', Name).

script(main).
script(dom).
script(wire).
script(words).
script(link).
script(picture).
script(nearest).
script(space).
script(sight).
script(pointing).
script(port).
script(ports).
script(bar).
script(commands).
script(menus).
script(turning).
script(find).
script(handles).
script(tree).
script(panels).
script(editor).
script(kinds).
script(fold).
script(pens).
script(keep).
script(kept).
script(files).
script(problems).
script(half).
script(ghost).
script(taught).
script(why).

%   page_words(Text): the words of the page in both languages, as JSON: {Key:
%   [English, Korean]}.

page_words(Text) :-
    findall(Key-[En,Ko], studio_word(Key, En, Ko), Pairs),
    dict_pairs(Words, _, Pairs),
    with_output_to(string(Text),
                   plain_json(current_output,
                              json_write_dict(current_output,
                                              Words, [width(0)]))).
