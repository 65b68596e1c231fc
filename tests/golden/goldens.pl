:- module(test_goldens,
          [ golden/2,                   % ?Name, ?Words
            golden_file/2,              % +Name, -File
            golden_drawn/2,             % +Name, +File
            left_over/1                 % -File
          ]).
:- use_module(rules(command/cli), [sanggwan/2]).
:- use_module(library(filesex), [directory_file_path/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> Golden drawings: what `sanggwan draw` gave when somebody looked.

NAME.svg is the drawing of `sanggwan draw WORDS`, or of `sanggwan unfold` if
WORDS begin with that. Every line drawing of the gallery is one, docs/gallery/;
those listed here stand in tests/golden/. Shaded pictures are held to numbers
instead: their bytes are those of a library that packs (tests/rules/shading,
tests/cli/render.sh). tests/rules/drawing/golden.plt compares the bytes; `make
bless` (tools/bless.pl) writes them anew. LOOK at what changed before you commit
it.
*/

%!  golden(?Name, ?Words) is nondet.
%
%   The arguments of `sanggwan draw` for each golden drawing.

golden(Name, Words) :-
    setup_call_cleanup(
        ( absolute_file_name(sanggwan('docs/gallery/pictures.pl'), File),
          open(File, read, In, [encoding(utf8)])
        ),
        findall(Name0-Words0, picture(In, Name0, Words0), Pictures),
        close(In)),
    member(Name-Words, Pictures),
    Words \= [render|_].
golden(Name, Words) :-
    own_golden(Name, Words).

picture(In, Name, Words) :-
    repeat,
    read_term(In, Term, []),
    (   Term == end_of_file
    ->  !,
        fail
    ;   Term = picture(Name, _, _, Words)
    ).

own_golden(cube, ['facts/cube.pl', '--view', iso]).
own_golden(cube_front, ['facts/cube.pl', '--view', front]).
own_golden(cube_central, ['facts/cube.pl', '--view', '300,60,4',
                          '--projection', central]).
own_golden(hollow_block, ['facts/hollow_block.pl']).
own_golden(cutaway, ['facts/pipe_tee.pl', '--cutaway', y, '--hidden', removed]).
own_golden(two_cubes, ['facts/two_cubes.pl']).
own_golden(two_cubes_removed, ['facts/two_cubes.pl', '--hidden', removed,
                               '--size', '100x70']).
own_golden(wire_and_roof, ['facts/wire_and_roof.pl']).
own_golden(fig13_lines, ['facts/figures/fig13.pl', '--lines', penetration]).
own_golden(fig13_all, ['facts/figures/fig13.pl', '--lines', all]).
own_golden(fig13_top, ['facts/figures/fig13.pl', '--view', top]).

%!  golden_file(+Name, -File) is det.
%
%   Where the golden drawing is kept, whether there is one or not.

golden_file(Name, File) :-
    (   own_golden(Name, _)
    ->  Folder = 'tests/golden'
    ;   Folder = 'docs/gallery'
    ),
    format(atom(Path), '~w/~w.svg', [Folder,Name]),
    absolute_file_name(sanggwan(Path), File).

%!  left_over(-File) is nondet.
%
%   File is in tests/golden/ and no golden drawing.

left_over(File) :-
    absolute_file_name(sanggwan('tests/golden'), Folder),
    directory_files(Folder, Files),
    member(Base, Files),
    file_name_extension(Name, svg, Base),
    \+ own_golden(Name, _),
    directory_file_path(Folder, Base, File).

%!  golden_drawn(+Name, +File) is semidet.
%
%   Draw Name to File. Fails if the program ends with another status than 0.

golden_drawn(Name, File) :-
    once(golden(Name, Words0)),
    (   Words0 = [unfold|Words]
    ->  Verb = unfold
    ;   Words = Words0,
        Verb = draw
    ),
    append([Verb,'-q'|Words], ['-o',File], Arguments),
    with_output_to(string(_), sanggwan(Arguments, 0)).
