:- module(sg_page_file,
          [ page_file/3,                % +Path, -Type, -Text
            page_words/1                % -Text
          ]).
:- use_module('../message/studio_words', [studio_word/3]).
:- use_module('../part', [carried_file/2]).
:- use_module('../plain', [plain_json/2]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(readutil), [read_file_to_string/3]).
/** <module> The files of the studio's page: web/, which the program carries.
*/

%!  page_file(+Path, -Type, -Text:string) is semidet.
%
%   Path, as in an address, is a file of the page: Text, of this media Type.

page_file(Path, Type, Text) :-
    served(Path, Name, Type),
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

served(/, 'index.html', 'text/html').
served('/index.html', 'index.html', 'text/html').
served('/studio.css', 'studio.css', 'text/css').
served('/icon.svg', 'icon.svg', 'image/svg+xml').
served(Path, Name, 'text/javascript') :-
    script(Script),
    atom_concat(Script, '.js', Name),
    atom_concat(/, Name, Path).

script(main).
script(dom).
script(wire).
script(words).
script(picture).
script(ports).
script(turning).
script(find).
script(handles).
script(tree).
script(panels).
script(kinds).
script(fold).
script(pens).
script(keep).
script(kept).
script(files).
script(problems).

%!  page_words(-Text:string) is det.
%
%   The words of the page in both languages, as JSON: {Key: [English, Korean]}.

page_words(Text) :-
    findall(Key-[En,Ko], studio_word(Key, En, Ko), Pairs),
    dict_pairs(Words, _, Pairs),
    with_output_to(string(Text),
                   plain_json(current_output,
                              json_write_dict(current_output,
                                              Words, [width(0)]))).
