/* Draws the pictures of the gallery and writes its page.

       swipl -p foreign=build tools/gallery.pl [-- PROGRAM]

   Run in the project's root. docs/gallery/pictures.pl lists the pictures;
   each is drawn by the very command that the page shows under it. Of problem
   sheets all is kept but the patterns; the page shows the first variant.
   PROGRAM is ./sanggwan unless given. Exits 1 if a picture could not be drawn.
*/
:- module(sg_gallery, []).
:- use_module(library(http/html_write)).
:- use_module(library(process)).
:- use_module('../rules/output', [writing/3]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Argv),
    (   Argv = [Program|_]
    ->  true
    ;   Program = './sanggwan'
    ),
    pictures(Pictures),
    findall(Name, ( member(Picture, Pictures),
                    arg(1, Picture, Name),
                    \+ drawn(Program, Picture) ),
            Failed),
    page(Pictures),
    length(Pictures, N),
    (   Failed == []
    ->  format("~d pictures: see docs/gallery/index.html~n", [N]),
        format("one of them live: ./sanggwan serve facts/pipe_tee.pl~n")
    ;   format(user_error, "not drawn: ~w~n", [Failed]),
        halt(1)
    ).

pictures(Pictures) :-
    setup_call_cleanup(
        open('docs/gallery/pictures.pl', read, In, [encoding(utf8)]),
        terms(In, Pictures),
        close(In)).

terms(In, Terms) :-
    read_term(In, Term, []),
    (   Term == end_of_file
    ->  Terms = []
    ;   Terms = [Term|Terms1],
        terms(In, Terms1)
    ).

file(sheets(Name,_,_,_,_), File) :-
    !,
    format(atom(File), 'docs/gallery/~w', [Name]).
file(Picture, File) :-
    file_name(Picture, Name),
    atom_concat('docs/gallery/', Name, File).

file_name(scan_line(Name,_,_,_,_), File) :-
    file_name_extension(Name, svg, File).
file_name(picture(Name,_,_,Words), File) :-
    (   Words = [render|_]
    ->  Ending = png
    ;   Ending = svg
    ),
    file_name_extension(Name, Ending, File).

words(Picture, Words) :-
    Picture = sheets(_, _, _, Words0, _),
    !,
    file(Picture, File),
    append([problems|Words0], ['-o',File], Words).
words(Picture, [render|Words]) :-
    Picture = scan_line(_, _, _, Words0, Y),
    !,
    file(Picture, File),
    format(atom(Text), '~w=~w', [Y,File]),
    append(Words0, ['--scan-line',Text], Words).
words(Picture, Words) :-
    Picture = picture(_, _, _, Words0),
    (   ( Words0 = [unfold|_] ; Words0 = [render|_] )
    ->  Words1 = Words0
    ;   Words1 = [draw|Words0]
    ),
    file(Picture, File),
    append(Words1, ['-o',File], Words).

drawn(Program, Picture) :-
    words(Picture, Words),
    append(Words, ['-q'], Quiet),
    process_create(Program, Quiet, [process(Process), stdout(null)]),
    process_wait(Process, exit(0)),
    forall(left_over(Picture, File), delete_file(File)).

%   left_over(Picture, File): File was made with problem sheets, and is a
%   pattern: these are four fifths of all octets.

left_over(Picture, File) :-
    Picture = sheets(_, _, _, _, _),
    file(Picture, Folder),
    exists_directory(Folder),
    directory_files(Folder, Locals),
    member(Local, Locals),
    sub_atom(Local, _, _, _, '-development-'),
    directory_file_path(Folder, Local, File).

page(Pictures) :-
    writing('docs/gallery/index.html', text, page_written(Pictures)).

page_written(Pictures, Out) :-
    style(Style),
    phrase(page([ meta(charset='utf-8'),
                  meta([ name=viewport,
                         content='width=device-width, initial-scale=1' ]),
                  title('Sanggwan: the gallery'),
                  style(Style)
                ],
                [ h1('Sanggwan: the figures of 1988'),
                  p([ 'The penetration figures of H.-C. Chae, ',
                      em('Drawing of Penetrating Lines Using \c
                          Personal Computer'),
                      ', KSME Journal 12(1), 1988, and some others, each \c
                       drawn by the command under it. Penetration lines are \c
                       red on the screen, black on paper; hidden lines \c
                       are dashed.' ]),
                  main(\figures(Pictures))
                ]),
           Tokens),
    print_html(Out, Tokens),
    nl(Out).

figures([]) -->
    [].
figures([Picture|Pictures]) -->
    { Picture = sheets(Name, Title, Caption, _, Numbers),
      !,
      words(Picture, Words),
      atomic_list_concat(['./sanggwan'|Words], ' ', Command)
    },
    html(figure([id(Name), class(pairs)],
                [ figcaption([ strong(Title), ' ', Caption ]),
                  pre(code(Command)),
                  div(\pairs(Name, Numbers))
                ])),
    figures(Pictures).
figures([Picture|Pictures]) -->
    { arg(1, Picture, Name),
      arg(2, Picture, Title),
      arg(3, Picture, Caption),
      file_name(Picture, File),
      atomic_list_concat([Title,Caption], ': ', Alt),
      words(Picture, Words),
      atomic_list_concat(['./sanggwan'|Words], ' ', Command)
    },
    html(figure(id(Name),
                [ a(href(File), img([src(File), alt(Alt)])),
                  figcaption([ strong(Title), ' ', Caption ]),
                  pre(code(Command))
                ])),
    figures(Pictures).

%   pairs(Folder, Problems)//: question and answer of the first variant beside
%   each other, links to those of the others under them.

pairs(_, []) -->
    [].
pairs(Folder, [Problem|Problems]) -->
    { findall(a(href(File), img([src(File), alt(Alt)])),
              ( sheet_file(Folder, Problem, 1, Kind, File),
                atomic_list_concat([Problem,', ',Kind], Alt) ),
              Both),
      findall(Part,
              ( between(2, 4, Variant),
                sheet_file(Folder, Problem, Variant, Kind, File),
                format(atom(Text), '~w ~d, ~w', [Problem,Variant,Kind]),
                member(Part, [a(href(File), Text),' ']) ),
              Others)
    },
    html(Both),
    html(p(Others)),
    pairs(Folder, Problems).

sheet_file(Folder, Problem, Variant, Kind, File) :-
    member(Kind, [question,answer]),
    format(atom(File), '~w/~w-~d-~w.svg', [Folder,Problem,Variant,Kind]).

style('
body { font: 16px/1.5 Georgia, "Noto Serif", serif; color: #111;
       background: #fff; max-width: 72rem; margin: 2rem auto;
       padding: 0 1rem }
h1 { font-size: 1.6rem; font-weight: normal }
main { display: grid; gap: 2.5rem 2rem;
       grid-template-columns:
         repeat(auto-fit, minmax(min(30rem, 100%), 1fr)) }
figure { margin: 0; break-inside: avoid }
.pairs { grid-column: 1 / -1 }
.pairs div { display: grid; gap: 1rem; grid-template-columns: 1fr 1fr;
             margin-top: 1rem }
.pairs p { grid-column: 1 / -1; margin: 0 0 1rem; font-size: .8rem }
img { width: 100%; border: 1px solid #ddd }
figcaption { margin: .5rem 0 }
pre { margin: 0; padding: .4rem .6rem; background: #f4f4f4;
      white-space: pre-wrap; font-size: .8rem }
@media print {
  body { margin: 0; max-width: none; font-size: 11pt }
  main { grid-template-columns: 1fr 1fr; gap: 8mm }
  img { border: none }
  pre { background: none; padding: 0 }
}
').
