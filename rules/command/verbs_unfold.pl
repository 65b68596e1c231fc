:- module(sg_verbs_unfold,
          [ unfold_run/3,               % +Files, +Options, -Status
            world_patterns/3,           % +Options, -Ds, -DrawingOptions
            roots_apart/1,              % +Options
            patterns_given/1,           % +Options
            pattern_wanted/3            % +Item, +Options, -Wanted
          ]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../csg/placed_surface', [asked_once/1]).
:- use_module('../development/bend', [doubly_curved/3, named_segment/2]).
:- use_module('../development/leaf_face', [roots_alone_named/0]).
:- use_module('../gluing/exploded', [cells_parted/0, faces_once/0]).
:- use_module('../limits', [term_of_text/3]).
:- use_module('../model/mesh', [write_mesh/3]).
:- use_module('../model/model', [load_model/2, save_model/1]).
:- use_module('../model/model_text',
              [next_fact/3, place_error/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module('../output', [when_written/1]).
:- use_module('../pattern/pattern_drawing', [pattern_drawing/3]).
:- use_module('../pattern/pattern_file', [numbered_files/3, write_pattern/4]).
:- use_module('../development/seam_measure', [pattern_area/2]).
:- use_module('../pattern/pattern_plate', [plate_measures/4]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module('../pattern/pattern_paper', [paper_checked/1]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../development/polygon_name',
              [polygons_named/3, segment_title/2, segments_named/2]).
:- use_module(sheet_options, [scale_option/2]).
:- use_module(solid_verbs, [empty_roots_warned/0]).
:- use_module('../sheet/sheet_paper', [unit_millimetres/2]).
:- use_module('../solid/simplify', [simplified_roots/1]).
:- use_module('../space_limit', [with_stack_for/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ p/3, segment/3, unfolding/2, retractall_facts/1,
                facts_snapshot/1
              ]).
:- use_module('../drawing/style_file', [style_rows/2]).
:- use_module('../unfolding/unfold',
              [ unfoldable/1, pattern_of/2, wishes/3, wanted_of/3,
                unfolded_part/4
              ]).
:- use_module('../unrolling/true_sphere', [sphere_part_polygon/3]).
:- use_module('../unrolling/true_table', [write_true_lengths/3]).
:- use_module(unfold_options, [options_together/1]).
:- use_module(unfold_report, [unfold_report/2]).
:- use_module('../unfolding/unfold_mirror', [mirrored_pattern/2]).
:- use_module('../unfolding/unfold_how', [how_wished/3, how_wished_of_any/2]).
:- use_module('../unfolding/unfold_true', [true_patterns/4]).
:- use_module('../unfolding/unfold_whole', [pattern_whole/1]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, may_be_written/1, no_model_replaced/2,
                no_file/1, output_written/2, usage_error/1
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [include/3, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The verb unfold.

Every solid and surface of the model becomes a pattern. First, all that is
wanted is looked up in the model as the user wrote it; then the segments cut
each other, so that the patterns have the penetration lines, or each is trimmed
by the others; then they are laid flat.
*/

%!  unfold_run(+Files, +Options, -Status) is det.
%
%   As verb_run/4.

unfold_run(Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    outputs(Options,
            [ svg,pdf,eps,ps,png,dxf,hpgl,json,fold,pl,obj,off ],
            Outputs),
    drawing_options(Options, DrawingOptions),
    paper_checked(DrawingOptions),
    table_output(Options, Tables),
    append(Outputs, Tables, All),
    no_model_replaced(Files, All),
    flag_wishes(Options, Flags),
    load_model(Files, Options),
    options_together(Options),
    empty_roots_warned,
    roots_apart(Options),
    asked_once(patterns_reported(Files, Options, Flags, All, Ds, Options0)),
    laid_flat_told(Options0, Ds),
    tables_written(Options0, Ds),
    with_sheet_stack(Ds,
                     ( sheets_once(Options0, Ds, Outputs, Options1),
                       maplist(written_to(Options1, Ds), Outputs) )).

:- meta_predicate with_sheet_stack(+, 0).

%   with_sheet_stack(Ds, Goal): what a polygon of Ds takes on the stacks while
%   sheets are laid out and written.

with_sheet_stack(Ds, Goal) :-
    aggregate_all(count, ( member(D, Ds), p(D, _, _) ), Polygons),
    sheet_octets(Octets),
    with_stack_for(Polygons, Octets, Goal).

%   sheet_octets(Octets): that is less than before.

sheet_octets(40000).

%   patterns_reported(Files, Options0, Flags, Outputs, Ds, Options): a report as
%   JSON has the yield of the sheets, which are laid out for it, and are among
%   Options then.

patterns_reported(Files, Options0, Flags, Outputs, Ds, Options) :-
    catch(patterns(Options0, Flags, Ds),
          error(model_error(unfold(S, Wish, What)), Location),
          in_file(Files, S, Wish, What, Location)),
    (   option(json(true), Options0),
        member(output(_, Format), Outputs),
        is_drawing(Format),
        on_sheets(Format)
    ->  with_sheet_stack(Ds, sheets_laid(Options0, Ds, Options))
    ;   Options = Options0
    ),
    reported(Ds, Options, Outputs).

%!  world_patterns(+Options:list, -Ds:list, -DrawingOptions:list) is det.
%
%   Ds are the patterns of the model in the current world, which has them then;
%   DrawingOptions are those of pattern_drawing/3 among Options.

world_patterns(Options, Ds, DrawingOptions) :-
    drawing_options(Options, DrawingOptions),
    paper_checked(DrawingOptions),
    flag_wishes(Options, Flags),
    options_together(Options),
    empty_roots_warned,
    roots_apart(Options),
    asked_once(sg_verbs_unfold:patterns(Options, Flags, Ds)).

%!  roots_apart(+Options:list) is det.
%
%   Only roots are unfolded, with faces(N) made simple; what is glued each face
%   once, or with cells(true) each cell as a solid. With --true what they
%   are made of stays, as it tells which smooth surfaces their facets stand for.

roots_apart(Options) :-
    (   option(faces(Faces), Options)
    ->  simplified_roots(Faces)
    ;   option(true(true), Options)
    ->  true
    ;   how_wished_of_any(true_lengths, _)
    ->  true
    ;   roots_alone_named,
        (   option(cells(true), Options)
        ->  cells_parted
        ;   segment(_, cells, _)
        ->  faces_once
        ;   true
        )
    ).

%   table_output(Options, Tables): Tables is a list of what --table says.

table_output(Options, Tables) :-
    (   option(table(File0), Options)
    ->  outputs([output([File0])], [csv], Tables)
    ;   Tables = []
    ).

%   reported(Ds, Options, Outputs): on standard error if standard output is for
%   what is written.

reported(Ds, Options, Outputs) :-
    (   memberchk(output(-, _), Outputs)
    ->  current_output(Out),
        setup_call_cleanup(
            set_output(user_error),
            unfold_report(Ds, Options),
            set_output(Out))
    ;   unfold_report(Ds, Options)
    ).

%   patterns(Options, Flags, Ds): Ds are the patterns of all that is to be
%   unfolded, in order. Flags are the wishes among Options.

patterns(Options, Flags, Ds) :-
    known_wishes,
    chosen(Options, Flags, Ss),
    flags_met(Ss, Flags),
    maplist(all_wanted(Ss, Flags), Ss, Wanteds),
    (   trims(Options)
    ->  true
    ;   option(lines(false), Options)
    ->  true
    ;   penetrate(all, Options)
    ),
    develop_options(Options, DevelopOptions),
    trimming(Options, All),
    maplist(patterns_or_none(Ss, All, DevelopOptions), Ss, Wanteds, Dss),
    append(Dss, Ds0),
    mirrored_too(Options, Ds0, Ds),
    (   Ds == []
    ->  throw(error(geometry_error(unfold(all_trimmed_away)), _))
    ;   maplist(pattern_whole, Ds)
    ).

%   mirrored_too(Options, Ds0, Ds): with --mirror each of Ds0 and its mirror
%   image.

mirrored_too(Options, Ds0, Ds) :-
    (   option(mirror(true), Options)
    ->  findall(Pair,
                ( member(D, Ds0),
                  mirrored_pattern(D, M),
                  member(Pair, [D,M]) ),
                Ds)
    ;   Ds = Ds0
    ).

%   trims(Options): these, or the model, say that something is trimmed.

trims(Options) :-
    (   option(trim(_), Options)
    ->  true
    ;   how_wished_of_any(trim, _)
    ->  true
    ).

%!  patterns_given(+Options:list) is semidet.
%
%   True when the model has patterns, and the Options of the command line ask
%   for no others.

patterns_given(Options) :-
    flag_wishes(Options, []),
    develop_options(Options, []),
    once(segment(_, pattern, _)).

%!  pattern_wanted(+Item, +Options:list, -Wanted:list) is det.
%
%   Wanted are the options of explanation/3 for Item, a seam, a fold or a piece
%   of a pattern, that the Options of the command line and the model ask for; to
%   be called before lines change the segments.

pattern_wanted(Item, Options, [wanted(Pairs)|How]) :-
    flag_wishes(Options, Flags),
    known_wishes,
    (   item_segment(Item, S)
    ->  Ss = [S]
    ;   chosen(Options, Flags, Ss)
    ),
    findall(S-Wanted,
            ( member(S, Ss), all_wanted(Ss, Flags, S, Wanted) ),
            Pairs),
    develop_options(Options, How0),
    trimming(Options, All),
    How = [by(All)|How0].

item_segment(Item, S) :-
    Item =.. [_,S0,_],
    nonvar(S0),
    (   pattern_of(S0, S1)
    ->  S = S1
    ;   S = S0
    ),
    unfoldable(S).

%   trimming(Options, All): what parts are trimmed by.

trimming(Options, All) :-
    (   option(by(Text), Options)
    ->  flag_terms('--by', Text, Names),
        findall(S, unfoldable(S), Known),
        findall(S, ( member(Name, Names), only_named(Name, Known, S) ), All0),
        sort(All0, All)
    ;   findall(S, unfoldable(S), All)
    ).

%   patterns_or_none(Ss, All, Options, S, Wanted, Ds): of several parts Ss, one
%   of which nothing is left has no pattern.

patterns_or_none(Ss, All, Options, S, Wanted, Ds) :-
    catch(patterns_of(All, Options, S, Wanted, Ds),
          error(geometry_error(trim(nothing_left(S, Side))), Context),
          (   Ss = [_]
          ->  throw(error(geometry_error(trim(nothing_left(S, Side))),
                          Context))
          ;   print_message(warning, sanggwan(trim(nothing_left(S, Side)))),
              Ds = []
          )).

%   all_wanted(Ss, Flags, S, Wanted): of several parts Ss, those that have a
%   polygon of that name.

all_wanted(Ss, Flags0, S, Wanted) :-
    (   Ss = [_]
    ->  Flags = Flags0
    ;   include(is_met(S), Flags0, Flags)
    ),
    wishes(S, Flags, Wishes),
    wanted_of(S, Wishes, Wanted).

%   patterns_of(All, Options, S, Wanted, Ds): several, if they are true ones.

patterns_of(All, Options0, S, Wanted, Ds) :-
    findall(Other, ( member(Other, All), Other \== S ), Others),
    how_wished(S, [by(Others)|Options0], Options),
    (   option(true(true), Options)
    ->  true_patterns(S, Wanted, Options, Ds)
    ;   unfolded_part(S, Wanted, Options, D),
        Ds = [D]
    ).

develop_options(Options, Develop) :-
    findall(Option, develop_option(Options, Option), Develop).

develop_option(Options, seam(Degrees)) :-
    option(seam(Text), Options),
    (   decimal_number(Text, Degrees)
    ->  true
    ;   usage_error(bad_value('--seam', Text, 'DEGREES'))
    ).
develop_option(Options, Option) :-
    develop_flag(Flag, Name),
    Given =.. [Flag,Value],
    option(Given, Options),
    Option =.. [Name,Value].

develop_flag(trim, trim).
develop_flag(minimize, minimize).
develop_flag(effort, effort).
develop_flag(tolerance, tolerance).
develop_flag(true, true).
develop_flag(generators, generators).
develop_flag(half, half).
develop_flag(gores, gores).
develop_flag(zones, zones).
develop_flag(chord, chord).
develop_flag(thickness, thickness).
develop_flag(size, size).
develop_flag(kfactor, k_factor).
develop_flag('bend-radius', bend_radius).
develop_flag(relief, relief).
develop_flag('set-in', set_in).
develop_flag('other-thickness', other_thickness).

%   known_wishes: every unfolding/2 is of a segment that is there.

known_wishes :-
    (   unfolding(S, Wish),
        \+ segment(S, _, _)
    ->  throw(error(model_error(unfold(S, Wish, no_segment)), _))
    ;   true
    ).

%   chosen(Options, Flags, Ss): what is to be unfolded.

chosen(Options, Flags, Ss) :-
    findall(S, unfoldable(S), All),
    (   option(only(Text), Options)
    ->  flag_terms('--only', Text, Names),
        findall(S, ( member(Name, Names), only_named(Name, All, S) ), Ss0),
        sort(Ss0, Ss)
    ;   Ss = All
    ),
    (   Ss == []
    ->  throw(error(geometry_error(unfold(nothing_to_unfold)), _))
    ;   Ss = [_,_|_],
        member(Flag, Flags),
        \+ of_any(Flag)
    ->  functor(Flag, Name, _),
        flag_option(Name, Option),
        usage_error(unfold(which_segment(Option, Ss)))
    ;   true
    ).

%   of_any(Flag): what it says may hold of several segments, by a name.

of_any(removed(Name)) :-
    \+ integer(Name).

is_met(S, removed(Name)) :-
    \+ polygons_named(S, Name, []).

%   flags_met(Ss, Flags): of several parts Ss, one at least has what a flag
%   names.

flags_met(Ss, Flags) :-
    (   Ss = [S,_|_],
        member(Flag, Flags),
        \+ ( member(Other, Ss), is_met(Other, Flag) )
    ->  all_wanted([S], [Flag], S, _)   % says what there is
    ;   true
    ).

only_named(Name, All, S) :-
    segments_named(Name, Ss),
    (   Ss == []
    ->  findall(S1-Title, ( member(S1, All), segment_title(S1, Title) ), Known),
        usage_error(unfold(no_segment(Name, Known)))
    ;   member(S, Ss),
        (   memberchk(S, All)
        ->  true
        ;   segment(S, Kind, _),
            throw(error(geometry_error(unfold(kind(S, Kind))), _))
        )
    ).


                /*******************************
                *            WISHES            *
                *******************************/

%   flag_wishes(Options, Flags): root(P), cut(E) ... as unfold_wish.pl has them.

flag_wishes(Options, Flags) :-
    findall(Wishes, option_wishes(Options, Wishes), Lists),
    append(Lists, Flags).

option_wishes(Options, [root(Name)]) :-
    option(root(Text), Options),
    flag_terms('--root', Text, Names),
    (   Names = [Name]
    ->  true
    ;   usage_error(unfold(no_term('--root', Text)))
    ).
option_wishes(Options, Wishes) :-
    member(Name, [cut,keep,removed]),
    flag_option(Name, Option),
    option_texts(Name, Options, Texts),
    member(Text, Texts),
    flag_terms(Option, Text, Terms),
    findall(Wish, ( member(Term, Terms), Wish =.. [Name,Term] ), Wishes).
option_wishes(Options, [order(Names)]) :-
    option(order(Texts), Options),
    member(Text, Texts),
    flag_terms('--order', Text, Names).

option_texts(Name, Options, Texts) :-
    (   Name == removed
    ->  option(remove(Texts), Options)
    ;   Option =.. [Name,Texts],
        option(Option, Options)
    ).

flag_option(root, '--root').
flag_option(cut, '--cut').
flag_option(keep, '--keep').
flag_option(order, '--order').
flag_option(removed, '--remove').

%   flag_terms(Option, Text, Terms): names with commas between them; one with a
%   capital needs no quotes, for there are no variables.

flag_terms(Option, Text, Terms) :-
    format(string(List), '[~w]', [Text]),
    (   catch(term_of_text(List, Terms0,
                          [ module(sg_model_syntax), cycles(false),
                            dotlists(false), variable_names(Names)
                          ]),
              error(_, _), fail),
        is_list(Terms0),
        Terms0 = [_|_],
        maplist(named_as_written, Names),
        ground(Terms0)
    ->  Terms = Terms0
    ;   memberchk(Option, ['--only','--by'])
    ->  usage_error(unfold(no_names(Option, Text)))
    ;   usage_error(unfold(no_term(Option, Text)))
    ).

named_as_written(Name=Name).

%   in_file(Files, S, Wish, What, Location): the error, with the place of the
%   fact.

in_file(Files, S, Wish, What, Location) :-
    Error = unfold(S, Wish, What),
    (   var(Location),
        wish_place(Files, S, Wish, Place)
    ->  place_error(Place, 2, Error)
    ;   throw(error(model_error(Error), Location))
    ).

%   wish_place(Files, S, Wish, Place): of the last fact that says so of S; or of
%   any segment, for those of a second file have numbers of their own there.

wish_place(Files, S, Wish, Place) :-
    findall(S1-Place1,
            ( member(File, Files), file_wish_place(File, Wish, S1, Place1) ),
            Places),
    Places \== [],
    (   findall(Place1, member(S-Place1, Places), Own),
        last(Own, Place)
    ->  true
    ;   last(Places, _-Place)
    ).

%   file_wish_place(File, Wish, S, Place) is nondet.

file_wish_place(File, Wish, S, Place) :-
    file_name_extension(_, pl, File),
    exists_file(File),
    with_text(facts, File, Text, wish_places(Text, Wish, Places)),
    member(S-Place, Places).

wish_places(Text, Wish, Places) :-
    next_fact(Text, Fact, Place),
    (   Fact == end_of_file
    ->  Places = []
    ;   Fact = unfolding(S, Said),
        Said == Wish
    ->  Places = [S-Place|Places1],
        wish_places(Text, Wish, Places1)
    ;   wish_places(Text, Wish, Places)
    ).


                /*******************************
                *            OUTPUT            *
                *******************************/

%   laid_flat_told(Options, Ds): what --true did not unroll though it is round,
%   or that it has unrolled nothing.

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

%   clumped(Kinds, Kind, N) is nondet: N of the sorted Kinds are Kind.

clumped(Kinds, Kind, N) :-
    sort(Kinds, Each),
    member(Kind, Each),
    aggregate_all(count, member(Kind, Kinds), N).

%   tables_written(Options, Ds): of true lengths; of several patterns that have
%   generators FILE.csv becomes FILE-1.csv, FILE-2.csv, ...

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
    output_written(sg_verbs_unfold:table_output(Unit, D), output(File, csv)).

table_output(Unit, D, File) :-
    stage(write, write_true_lengths(D, File, [unit(Unit)])).

%   sheets_once(Options0, Ds, Outputs, Options): several drawings have the same
%   sheets; they are laid out once, with what there is to say of them.

sheets_once(Options0, Ds, Outputs, Options) :-
    (   \+ option(drawings(_), Options0),
        findall(File,
                ( member(output(File,Format), Outputs), on_sheets(Format) ),
                [_,_|_])
    ->  sheets_laid(Options0, Ds, Options)
    ;   Options = Options0
    ).

sheets_laid(Options, Ds, [drawings(Drawings)|Options]) :-
    sheet_options(Options, Ds, DrawingOptions),
    stage(write, pattern_drawing(Ds, DrawingOptions, Drawings)).

on_sheets(Format) :-
    is_drawing(Format),
    Format \== fold.

%   written_to(Options, Ds, Output): a drawing may take several files.

written_to(Options, Ds, Output) :-
    Output = output(File, Format),
    (   is_drawing(Format),
        \+ no_file(File)
    ->  drawn(Options, Ds, File, Files),
        forall(member(Name, Files),
               when_written(print_message(informational,
                                          sanggwan(wrote(Name)))))
    ;   output_written(sg_verbs_unfold:pattern_output(Options, Ds), Output)
    ).

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

%   drawing_options(Options, DrawingOptions): as pattern_drawing/3 and
%   write_drawing/2 have them.

drawing_options(Options, DrawingOptions) :-
    findall(Option, drawing_option(Options, Option), DrawingOptions).

drawing_option(Options, Option) :-
    member(Name,
           [ page,tile,overlap,margin,gap,tabs,numbers,angles,inside,grid,
             dashes,height,pages,fit,kerf
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
