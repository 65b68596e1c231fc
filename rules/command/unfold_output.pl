:- module(sg_unfold_output,
          [ laid_flat_told/2,           % +Options, +Ds
            no_bends_told/2,            % +Options, +Ds
            tables_written/2,           % +Options, +Ds
            sheets_once/4,              % +Options0, +Ds, +Outputs, -Options
            sheets_laid/3,              % +Options0, +Ds, -Options
            on_sheets/1,                % +Format
            written_to/3,               % +Options, +Ds, +Output
            is_drawing/1,               % +Format
            drawing_options/2           % +Options, -DrawingOptions
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../development/bend', [doubly_curved/3, named_segment/2]).
:- use_module('../model/mesh', [write_mesh/3]).
:- use_module('../model/model', [save_model/1]).
:- use_module('../output', [when_written/1]).
:- use_module('../pattern/pattern_drawing', [pattern_drawing/3]).
:- use_module('../pattern/pattern_file', [numbered_files/3, write_pattern/4]).
:- use_module('../development/seam_measure', [pattern_area/2]).
:- use_module('../pattern/pattern_plate', [has_bends/1, plate_measures/4]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module(sheet_options, [scale_option/2]).
:- use_module('../sheet/sheet_paper', [unit_millimetres/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [segment/3, unfolding/2, retractall_facts/1, facts_snapshot/1]).
:- use_module('../drawing/style_file', [style_rows/2]).
:- use_module('../unfolding/unfold', [pattern_of/2]).
:- use_module('../unrolling/true_sphere', [sphere_part_polygon/3]).
:- use_module('../unrolling/true_table', [write_true_lengths/3]).
:- use_module('../unfolding/unfold_how', [how_wished/3]).
:- use_module(verb_output, [no_file/1, output_written/2, usage_error/1]).
:- use_module(unfold_names, [trims/1]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> What the verb unfold writes: sheets, tables, models.
*/

%!  laid_flat_told(+Options:list, +Ds:list) is det.
%
%   Warn of what --true did not unroll though it is round, or that it has
%   unrolled nothing.

laid_flat_told(Options, Ds) :-
    findall(flat(S, Kind, N),
            ( option(true(true), Options),
              member(D, Ds),
              \+ segment(D, _, true_development(_, _)),
              aggregate_all(bag(Kind), doubly_curved(D, _, Kind), Kinds0),
              msort(Kinds0, Kinds),
              clumped(Kinds, Kind, N),
              named_segment(D, S) ),
            Flat),
    forall(member(flat(S, Kind, N), Flat),
           print_message(warning,
                         sanggwan(unfold(not_developable(S, Kind, N))))),
    (   option(true(true), Options),
        Flat == [],
        \+ ( member(D, Ds), segment(D, _, true_development(_, _)) )
    ->  print_message(warning, sanggwan(unfold(nothing_unrolled)))
    ;   member(Name-Option, [gores-'--gores',zones-'--zones']),
        Given =.. [Name,_],
        option(Given, Options),
        \+ ( member(D, Ds), is_of_sphere(D) )
    ->  print_message(warning, sanggwan(unfold(no_sphere(Option))))
    ;   true
    ).

is_of_sphere(D) :-
    segment(D, _, true_development(T, Part)),
    once(sphere_part_polygon(T, Part, _)).

%!  no_bends_told(+Options:list, +Ds:list) is det.
%
%   Warn of options of bends where no pattern has one. With a material --bends
%   has a table all the same, of the weight.

no_bends_told(Options, Ds) :-
    (   option(thickness(_), Options),
        \+ ( member(D, Ds), has_bends(D) )
    ->  forall(( bend_option(Options, Name),
                 Given =.. [Name,_],
                 option(Given, Options) ),
               ( atom_concat('--', Name, Option),
                 print_message(warning, sanggwan(unfold(no_bend(Option)))) ))
    ;   true
    ).

bend_option(_, 'bend-radius').
bend_option(_, relief).
bend_option(Options, bends) :-
    option(bends(true), Options),
    \+ option(material(_), Options).

%   clumped(Kinds, Kind, N) is nondet: N of the sorted Kinds are Kind.

clumped(Kinds, Kind, N) :-
    sort(Kinds, Each),
    member(Kind, Each),
    aggregate_all(count, member(Kind, Kinds), N).

%!  tables_written(+Options:list, +Ds:list) is det.
%
%   Write the tables of true lengths that --table wants; of several patterns
%   that have generators FILE.csv becomes FILE-1.csv, FILE-2.csv, ...

tables_written(Options, Ds) :-
    (   option(table(File), Options)
    ->  findall(D, ( member(D, Ds), segment(D, _, true_development(_, _)) ),
                Trues),
        option(unit(Unit), Options, mm),
        (   Trues == []
        ->  print_message(warning, sanggwan(unfold(no_table(File))))
        ;   File == (-)
        ->  forall(member(D, Trues), table_written(Unit, D, File))
        ;   numbered_files(Trues, File, Files),
            maplist(table_written(Unit), Trues, Files)
        )
    ;   true
    ).

table_written(Unit, D, File) :-
    output_written(sg_unfold_output:table_output(Unit, D), output(File, csv)).

table_output(Unit, D, File) :-
    stage(write, write_true_lengths(D, File, [unit(Unit)])).

%!  sheets_once(+Options0:list, +Ds:list, +Outputs:list, -Options:list) is det.
%
%   Several drawings have the same sheets; they are laid out once, with what
%   there is to say of them, and are among Options then.

sheets_once(Options0, Ds, Outputs, Options) :-
    (   \+ option(drawings(_), Options0),
        findall(File,
                ( member(output(File,Format), Outputs), on_sheets(Format) ),
                [_,_|_])
    ->  sheets_laid(Options0, Ds, Options)
    ;   Options = Options0
    ).

%!  sheets_laid(+Options0:list, +Ds:list, -Options:list) is det.
%
%   Options are Options0 with the sheets of Ds.

sheets_laid(Options, Ds, [drawings(Drawings)|Options]) :-
    sheet_options(Options, Ds, DrawingOptions),
    stage(write, pattern_drawing(Ds, DrawingOptions, Drawings)).

%!  on_sheets(+Format) is semidet.
%
%   True when what is written in Format stands on sheets.

on_sheets(Format) :-
    is_drawing(Format),
    Format \== fold.

%!  written_to(+Options:list, +Ds:list, +Output) is det.
%
%   Write Ds to Output, output(File, Format); a drawing may take several files.

written_to(Options, Ds, Output) :-
    Output = output(File, Format),
    (   is_drawing(Format),
        \+ no_file(File)
    ->  drawn(Options, Ds, File, Files),
        forall(member(Name, Files),
               when_written(print_message(informational,
                                          sanggwan(wrote(Name)))))
    ;   output_written(sg_unfold_output:pattern_output(Options, Ds), Output)
    ).

%!  is_drawing(+Format) is semidet.
%
%   True when Format is none of models.

is_drawing(Format) :-
    \+ memberchk(Format, [pl,obj,off]).

drawn(Options, Ds, File, Files) :-
    sheet_options(Options, Ds, DrawingOptions),
    stage(write, write_pattern(File, Ds, DrawingOptions, Files)).

%   sheet_options(Options, Ds, DrawingOptions): with --bends also the measures
%   of what of Ds is of plate.

sheet_options(Options, Ds, DrawingOptions) :-
    drawing_options(Options, DrawingOptions0),
    (   option(bends(true), Options)
    ->  findall(D-Plate, plate_of(Options, Ds, D, Plate), Plates),
        DrawingOptions = [plates(Plates)|DrawingOptions0]
    ;   DrawingOptions = DrawingOptions0
    ).

plate_of(Options0, Ds, D, Plate) :-
    member(D, Ds),
    pattern_of(D, T),
    part_named(T, S),
    how_wished(S, Options0, Options),
    option(thickness(Thickness), Options),
    Thickness > 0,
    pattern_area(D, Area),
    plate_measures(D, Area, Options, Plate0),
    option(unit(Unit), Options, mm),
    unit_millimetres(Unit, Millimetres),
    Plate = Plate0.put(millimetres, Millimetres).

%   pattern_output(Options, Ds, File): of the several sheets of a drawing,
%   standard output can have the first only.

pattern_output(Options, Ds, File) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    (   Format == pl
    ->  facts_snapshot(( parts_alone(Options, Ds), save_model(File) ))
    ;   memberchk(Format, [obj,off])
    ->  stage(write, write_mesh(File, Ds, [format(Format)]))
    ;   drawn(Options, Ds, File, Files),
        (   Files = [_]
        ->  true
        ;   length(Files, N),
            usage_error(unfold(several_sheets(N)))
        )
    ).

%!  drawing_options(+Options:list, -DrawingOptions:list) is det.
%
%   DrawingOptions are those of Options that pattern_drawing/3 and
%   write_drawing/2 have.
%
%   @error usage_error(pattern(scale(Text)))

drawing_options(Options, DrawingOptions) :-
    findall(Option, drawing_option(Options, Option), DrawingOptions).

drawing_option(Options, Option) :-
    member(Name,
           [ page,tile,overlap,margin,gap,tabs,numbers,angles,inside,grid,
             dashes,height,up,pages,fit,kerf
           ]),
    Option =.. [Name,_],
    option(Option, Options).
drawing_option(Options, fold_threshold(Degrees)) :-
    option('fold-threshold'(Degrees), Options).
drawing_option(Options, table(Lengths)) :-
    option(lengths(Lengths), Options).
drawing_option(Options, lap(Width)) :-
    option(lap(Width), Options).
drawing_option(Options, lock(Width)) :-
    option('lock-seam'(Width), Options).
drawing_option(Options, tab_sides(On)) :-
    option('tab-sides'(On), Options).
drawing_option(Options, open_slits(Open)) :-
    option('open-slits'(Open), Options).
drawing_option(Options, names(Names)) :-
    option(names(How), Options),
    (   How == numbers
    ->  Names = true
    ;   Names = How
    ).
drawing_option(Options, scale(Scale)) :-
    option(scale(_), Options),
    (   catch(scale_option(Options, Scale0),
              error(usage_error(sheet(scale(_))), _),
              fail)
    ->  Scale = Scale0
    ;   option(scale(Text), Options),
        usage_error(pattern(scale(Text)))
    ).
drawing_option(Options, unit(Unit)) :-
    \+ option(scale(_), Options),       % which says it
    option(unit(Unit), Options).
drawing_option(Options, drawings(Drawings)) :-
    option(drawings(Drawings), Options).
drawing_option(Options, style(Rows)) :-
    option(style(File), Options),
    style_rows(File, Rows).
drawing_option(Options, dots(Dots)) :-
    option(dpi(DotsPerInch), Options),
    Dots is DotsPerInch/25.4.

%   parts_alone(Options, Ds): with --trim, what was unfolded and its patterns,
%   without what they were trimmed of; else all stays, with its lines.

parts_alone(Options, Ds) :-
    (   trims(Options)
    ->  findall(S, ( member(D, Ds), pattern_of(D, S) ), Ss),
        append(Ss, Ds, Stay),
        forall(( segment(S, _, _), \+ memberchk(S, Stay) ), drop_segment(S)),
        forall(( unfolding(S, _), \+ memberchk(S, Stay) ),
               retractall_facts(unfolding(S, _)))
    ;   true
    ).

drop_segment(S) :-
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).
