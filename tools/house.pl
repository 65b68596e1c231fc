/* The house as the tree has it: a drawing of its layers, a list of its files.

       swipl -f none tools/house.pl -- drawing docs/architecture.svg
       swipl -f none tools/house.pl -- files build/docs/files.md
       swipl -f none tools/house.pl -- check docs/architecture.svg

   The list takes what each file says of itself in its first lines: `<module>`
   of rules, `X.h -- ...` of C. A file of C that says nothing is told of by the
   header of its name. `check` fails for a file without such a line, for a door
   that no test of C calls, for a drawing that is not the one that would be
   made, and for what stands at the top of the tree by accident.
*/
:- module(sg_house, []).
:- use_module(folders).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(readutil)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [What,File]),
    made(What, File).

made(drawing, File) :-
    drawing_text(Text),
    write_text(File, Text).
made(files, File) :-
    findall(Path-Line, source_line(Path, Line), Lines),
    with_output_to(string(Text), file_list(Lines)),
    write_text(File, Text).
made(check, File) :-
    findall(Fault, fault(File, Fault), Faults),
    forall(member(Fault, Faults), format(user_error, "~w~n", [Fault])),
    (   Faults == []
    ->  true
    ;   halt(1)
    ).

write_text(File, Text) :-
    file_directory_name(File, Folder),
    make_directory_path(Folder),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       write(Out, Text),
                       close(Out)).

fault(_, Fault) :-
    source(Path),
    \+ source_line(Path, _),
    format(atom(Fault), "~w: its first lines do not say what it is", [Path]).
fault(File, Fault) :-
    drawing_text(Text),
    \+ ( exists_file(File),
         read_file_to_string(File, Text, [encoding(utf8)]) ),
    format(atom(Fault), "~w: not as the tree is; make docs", [File]).
fault(_, Fault) :-
    expand_file_name('*', Paths),
    member(Name, Paths),
    \+ at_top(Name),
    format(atom(Fault), "~w: nothing of this name stands at the top", [Name]).
fault(_, Fault) :-
    texts_of(['tests/c_kernels/*.[ch]','tests/c_kernels/*/*.[ch]'], Tests),
    untested_door(Tests, Door),
    format(atom(Fault), "~w: no test in tests/c_kernels calls it", [Door]).
fault(_, Fault) :-
    member(Top, [rules,c_kernels]),
    atom_concat(Top, '/*', Pattern),
    expand_file_name(Pattern, Paths),
    member(Path, Paths),
    exists_directory(Path),
    file_base_name(Path, Name),
    Name \== kernel,
    \+ folder(Top, Name, _),
    format(atom(Fault), "~w: not in tools/folders.pl", [Path]).

%   What stands at the top: the folders of source, `build`, the program, and
%   the documents.
at_top(Name) :-
    memberchk(Name, [engine,rules,facts,c_kernels,tests,'Makefile',bench,docs,
                     tools,web,build,sanggwan,'LICENSE',
                     'compile_commands.json']).
at_top(Name) :-
    file_name_extension(_, md, Name).


%   untested_door(Tests, Door): the row layer has the function Door, and no test
%   without Prolog names it.

untested_door(Tests, Door) :-
    texts_of(['c_kernels/*/*_rows.c'], Rows),
    split_string(Rows, "\n", "", Lines),
    member(Line, Lines),
    string_concat("sg_door_", _, Line),
    split_string(Line, "(", "", [Door|_]),
    string_concat(Door, "(", Call),
    \+ sub_string(Tests, _, _, _, Call).

texts_of(Patterns, Text) :-
    maplist(expand_file_name, Patterns, Files0),
    append(Files0, Files),
    maplist([File,Part]>>read_file_to_string(File, Part, [encoding(utf8)]),
            Files, Parts),
    atomics_to_string(Parts, Text).


                /*******************************
                *          THE FILES           *
                *******************************/

source(Path) :-
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl', 'engine/*.[ch]',
                     'engine/*.def', 'c_kernels/*.[ch]', 'c_kernels/*.def',
                     'c_kernels/*/*.[ch]']),
    expand_file_name(Pattern, Paths),
    member(Path, Paths).

%   source_line(?Path, -Line): what the file says of itself. A .c file of the
%   name of a header is that header's.

source_line(Path, Line) :-
    source(Path),
    own_line(Path, Line).
source_line(Path, Line) :-
    source(Path),
    \+ own_line(Path, _),
    file_name_extension(Base, c, Path),
    file_name_extension(Base, h, Header),
    exists_file(Header),
    own_line(Header, _),
    file_base_name(Header, Name),
    atomic_list_concat(['see ', Name], Line).

own_line(Path, Line) :-
    read_file_to_string(Path, Text, [encoding(utf8)]),
    (   file_name_extension(_, pl, Path)
    ->  Mark = "<module>"
    ;   Mark = " -- "
    ),
    sub_string(Text, Before, _, After, Mark),
    !,
    Before < 4000,
    sub_string(Text, _, After, 0, Rest),
    first_sentence(Rest, Line).

%   first_sentence(Text, Line): to the first full stop at the end of a word, the
%   end of the comment, or an empty line; comment marks are left out.

first_sentence(Text, Line) :-
    findall(Before, ( member(End, [". ", ".\n", "*/", "\n\n", "\n *\n"]),
                      sub_string(Text, Before, _, _, End) ), Ends),
    min_list(Ends, Length),
    sub_string(Text, 0, Length, _, Sentence0),
    split_string(Sentence0, "\n", " \t*", Parts),
    exclude(==(""), Parts, Words),
    atomic_list_concat(Words, ' ', Line).

file_list(Lines) :-
    format("# The files~n~nMade by tools/house.pl from their first lines.~n"),
    forall(listed_folder(Folder, What),
           ( format("~n## ~w/: ~w~n~n", [Folder, What]),
             forall(( member(Path-Line, Lines),
                      file_directory_name(Path, Folder) ),
                    ( file_base_name(Path, Name),
                      format("- `~w`: ~w~n", [Name, Line])
                    ))
           )).

listed_folder(engine, 'the store, the program, what hosts call').
listed_folder(Folder, What) :-
    member(Top-Beside, [ rules-'what every rule may stand on, the facade',
                         c_kernels-'what every kernel may stand on, the glue'
                       ]),
    (   Folder = Top,
        What = Beside
    ;   Top == rules,
        Folder = 'rules/kernel',
        What = 'the doors, by topic'
    ;   folder(Top, Name, What),
        directory_file_path(Top, Name, Folder)
    ).


                /*******************************
                *         THE DRAWING          *
                *******************************/

%   layer(Name, Where, What, Top): from the top down. Top: whose folders stand
%   in it, or none.

layer('program and hosts', 'engine/main.c, sanggwan.h, rules/command/cli.pl',
      'verbs, options, exit codes; questions from C', none).
layer('rules', 'rules/TOPIC/X.pl',
      'decisions: what is true, over ids; one topic, one module', rules).
layer('doors', 'rules/store.pl, rules/kernel/TOPIC.pl, c_kernels/doors.def',
      'every foreign predicate, declared where it is documented; glue is made',
      none).
layer('rows', 'c_kernels/TOPIC/X_rows.c, call.h',
      'reads views of a version, writes rows in bulk; knows no Prolog', none).
layer('kernels', 'c_kernels/TOPIC/X.c',
      'geometry on arrays: joins of all rows, exact signs; no store, no Prolog',
      c_kernels).
layer('store', 'engine/relations.def, store.c',
      'columns, versions, transactions, indexes; no geometry', none).

width(900).
chips_in_a_row(4).

drawing_text(Text) :-
    with_output_to(string(Text), drawing).

drawing :-
    findall(Layer, ( layer(Name, Where, What, Top),
                     Layer = layer(Name, Where, What, Top) ), Layers),
    foldl(layer_place, Layers, Placed, 10, Bottom),
    width(Width),
    Height is Bottom - 10,
    format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ~d ~d\" \c
            font-family=\"sans-serif\" font-size=\"13\">~n", [Width, Height]),
    format("<!-- Made by tools/house.pl. -->~n"),
    format("<rect width=\"~d\" height=\"~d\" fill=\"white\"/>~n",
           [Width, Height]),
    forall(member(Place, Placed), layer_drawn(Place)),
    arrows(Placed),
    format("</svg>~n").

layer_place(Layer, place(Layer,Y,Height), Y, Below) :-
    Layer = layer(_,_,_,Top),
    folders(Top, Names),
    length(Names, N),
    chips_in_a_row(In),
    Rows is (N + In - 1) // In,
    Height is 56 + 42*Rows,
    Below is Y + Height + 26.

layer_drawn(place(layer(Name,Where,What,Top),Y,Height)) :-
    width(Width),
    Inner is Width - 40,
    format("<rect x=\"10\" y=\"~d\" width=\"~d\" height=\"~d\" rx=\"4\" \c
            fill=\"#f4f4f0\" stroke=\"#444\"/>~n", [Y, Inner, Height]),
    Y1 is Y + 22,
    format("<text x=\"22\" y=\"~d\" font-weight=\"bold\">~w</text>~n",
           [Y1, Name]),
    format("<text x=\"190\" y=\"~d\" font-family=\"monospace\">~w</text>~n",
           [Y1, Where]),
    Y2 is Y + 42,
    format("<text x=\"190\" y=\"~d\">~w</text>~n", [Y2, What]),
    findall(Folder-About, folder(Top, Folder, About), Folders),
    Y3 is Y + 52,
    forall(nth0(I, Folders, Folder), chip(I, Folder, Y3)).

chip(I, Folder-About, Y0) :-
    width(Width),
    chips_in_a_row(In),
    Wide is (Width - 56) // In,
    X is 20 + (I mod In)*Wide,
    Y is Y0 + (I // In)*42,
    Inner is Wide - 6,
    format("<rect x=\"~d\" y=\"~d\" width=\"~d\" height=\"36\" fill=\"white\" \c
            stroke=\"#aaa\"/>~n", [X, Y, Inner]),
    X1 is X + 6,
    Y1 is Y + 15,
    Y2 is Y + 30,
    format("<text x=\"~d\" y=\"~d\" font-family=\"monospace\">~w</text>~n",
           [X1, Y1, Folder]),
    format("<text x=\"~d\" y=\"~d\" font-size=\"11\">~w</text>~n",
           [X1, Y2, About]).

%   Calls go down: from each layer to the next, and beside the kernels, which
%   know no store, to the store.

arrows(Placed) :-
    width(Width),
    X is Width // 2,
    forall(( append(_, [Upper,Lower|_], Placed),
             place_of(Lower, Name, To, _),
             Name \== store
           ),
           ( place_of(Upper, _, Y, Height),
             From is Y + Height,
             Neck is To - 8,
             Left is X - 5,
             Right is X + 5,
             format("<path d=\"M~d ~dV~d\" stroke=\"#444\"/>\c
                     <path d=\"M~d ~dH~dL~d ~dz\" fill=\"#444\"/>~n",
                    [X, From, Neck, Left, Neck, Right, X, To])
           )),
    member(Store, Placed),
    place_of(Store, store, Top, Deep),
    !,
    End is Top + Deep//2,
    Edge is Width - 30,
    Lane is Width - 10,
    Neck is Edge + 8,
    Above is End - 5,
    Below is End + 5,
    forall(( member(Name, [doors,rows]),
             member(Upper, Placed),
             place_of(Upper, Name, Y, Height)
           ),
           ( From is Y + Height//2,
             format("<path d=\"M~d ~dH~dV~dH~d\" fill=\"none\" \c
                     stroke=\"#444\"/>~n",
                    [Edge, From, Lane, End, Neck])
           )),
    format("<path d=\"M~d ~dV~dL~d ~dz\" fill=\"#444\"/>~n",
           [Neck, Above, Below, Edge, End]).

place_of(place(layer(Name,_,_,_),Y,Height), Name, Y, Height).
