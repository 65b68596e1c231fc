:- module(sg_pattern_file,
          [ write_pattern/4,            % +File, +Ds, +Options, -Files
            numbered_files/3            % +Items, +File, -Files
          ]).
:- use_module('../drawing/drawing', [write_drawing/2]).
:- use_module(fold_file, [write_fold/3]).
:- use_module('../drawing/ink', [inked/3]).
:- use_module('../output', [files_together/1, writing/3]).
:- use_module(pattern_drawing, [pattern_drawing/3]).
:- use_module('../drawing/pdf', [write_pdf_pages/3]).
:- use_module('../store', [e/5, joint/6, origin/3, segment/3]).
:- use_module(library(apply), [convlist/3, maplist/3]).
:- use_module(library(assoc), [list_to_assoc/2]).
:- use_module(library(lists), [member/2, nth1/3]).
:- use_module(library(option), [select_option/3]).
/** <module> Patterns in files.

A PDF has a page for each sheet. Other formats have a file for each, PATTERN-1,
PATTERN-2, if there are several. FOLD has no sheets.
*/

%!  write_pattern(+File, +Ds, +Options, -Files) is det.
%
%   Write the patterns Ds to File in the format that its ending names: those of
%   write_drawing/2, or `fold`. Files are those that were written. Options are
%   those of pattern_drawing/3, of write_drawing/2 (style, dashes, title), and
%   of write_fold/3; drawings(Drawings) are those of pattern_drawing/3, if they
%   have been made.

write_pattern(File, Ds, Options0, Files) :-
    (   select_option(drawings(Drawings), Options0, Options)
    ->  true
    ;   Options = Options0
    ),
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    (   Format == fold
    ->  write_fold(File, Ds, Options),
        Files = [File]
    ;   ( var(Drawings) -> pattern_drawing(Ds, Options, Drawings) ; true ),
        format_written(Format, File, Ds, Drawings, Options, Files)
    ).

format_written(pdf, File, _, Drawings, Options, [File]) :-
    Drawings = [_,_|_],
    !,
    maplist(inked_by(Options), Drawings, Inkeds),
    writing(File, text, pages_written(Inkeds, Options)).
format_written(_, File, Ds, Drawings, Options, Files) :-
    edge_joints(Ds, Joints),
    convlist(smooth_outline, Ds, Smooth),
    numbered_files(Drawings, File, Files),
    files_together(maplist(drawing_written([ joints(Joints), order(kept),
                                             smooth(Smooth) | Options
                                           ]),
                           Drawings, Files)).

%   smooth_outline(D, Smooth): Smooth as write_dxf/3 has it; of a pattern of
%   flat facets its reliefs, whose edges are none of what was unfolded.

smooth_outline(D, Smooth) :-
    (   is_smooth(D)
    ->  Smooth = D
    ;   segment(D, pattern, development(S)),
        findall(E, relief_edge(D, S, E), Es0),
        sort(Es0, Es),
        Es \== [],
        Smooth = D-Es
    ).

relief_edge(D, S, E) :-
    e(D, E, _, _, 1),
    \+ e(S, E, _, _, _),
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _).

%   is_smooth(D): rims and holes of pattern D were made of true curves: what is
%   round was unrolled, of D or of the part that it is the rest of.

is_smooth(D) :-
    (   segment(D, pattern, true_development(_, _))
    ->  true
    ;   segment(D, pattern, development(T)),
        segment(_, pattern, true_development(T, _))
    ->  true
    ;   once(origin(D, e(_), e(_)))
    ).

drawing_written(Options, Drawing, File) :-
    write_drawing(File, [drawing(Drawing)|Options]).

inked_by(Options, Drawing, Inked) :-
    inked(Drawing, Options, Inked).

pages_written(Inkeds, Options, Out) :-
    write_pdf_pages(Out, Inkeds, Options).

%   An assoc of D-E to the number of the joint of edge E.

edge_joints(Ds, Joints) :-
    findall((D-E)-J,
            ( member(D, Ds),
              joint(D, J, E1, E2, _, _),
              member(E, [E1,E2])
            ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Joints).

%!  numbered_files(+Items:list, +File, -Files:list) is det.
%
%   Files are the names for Items: File for one alone; of several BASE-1.ENDING,
%   BASE-2.ENDING, ... if File is BASE.ENDING.

numbered_files([_], File, [File]) :-
    !.
numbered_files(Items, File, Files) :-
    file_name_extension(Base, Ending, File),
    findall(Name,
            ( nth1(I, Items, _),
              format(atom(Numbered), '~w-~d', [Base,I]),
              file_name_extension(Numbered, Ending, Name)
            ),
            Files).
