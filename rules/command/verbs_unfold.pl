:- module(sg_verbs_unfold,
          [ unfold_run/3,               % +Files, +Options, -Status
            world_patterns/3,           % +Options, -Ds, -DrawingOptions
            roots_apart/1,              % +Options
            patterns_given/1,           % +Options
            pattern_wanted/3            % +Item, +Options, -Wanted
          ]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../csg/placed_surface', [asked_once/1]).
:- use_module('../development/leaf_face', [roots_alone_named/0]).
:- use_module('../gluing/exploded', [cells_parted/0, faces_once/0]).
:- use_module('../model/model', [load_model/2]).
:- use_module('../pattern/pattern_paper', [paper_checked/1]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../development/polygon_name',
              [polygons_named/3, segment_title/2, segments_named/2]).
:- use_module(solid_verbs, [empty_roots_warned/0]).
:- use_module('../solid/simplify', [simplified_roots/1]).
:- use_module('../space_limit', [with_stack_for/3]).
:- use_module('../store', [p/3, segment/3, unfolding/2]).
:- use_module('../unfolding/unfold',
              [ unfoldable/1, pattern_of/2, wishes/3, wanted_of/3,
                unfolded_part/4
              ]).
:- use_module(unfold_options, [options_together/1]).
:- use_module(unfold_report, [unfold_measures/3, unfold_report/2]).
:- use_module('../unfolding/unfold_mirror', [mirrored_pattern/2]).
:- use_module('../unfolding/unfold_how', [how_wished/3, how_wished_of_any/2]).
:- use_module('../unfolding/unfold_true', [true_patterns/4]).
:- use_module('../unfolding/unfold_whole', [pattern_whole/1]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, no_model_replaced/2, reported/2,
                summary_sent_told/2, usage_error/1
              ]).
:- use_module(unfold_names,
              [ trims/1, flag_wishes/2, flag_option/2, flag_terms/3,
                in_file/5
              ]).
:- use_module(unfold_output,
              [ laid_flat_told/2, no_bends_told/2, tables_written/2,
                sheets_once/4, sheets_laid/3, on_sheets/1, written_to/3,
                is_drawing/1, drawing_options/2
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [include/3, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, member/2]).
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
    asked_once(unfolded(Files, Options, Flags, All, Outputs)).

unfolded(Files, Options, Flags, All, Outputs) :-
    patterns_reported(Files, Options, Flags, All, Ds, Options0),
    summary_sent_told(All, [svg,pdf,eps,ps,png,dxf,hpgl,fold,pl,obj,off]),
    laid_flat_told(Options0, Ds),
    no_bends_told(Options0, Ds),
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
    unfold_measures(Ds, Options, Measures),
    reported(Outputs, sg_unfold_report:unfold_report(Options, Measures)).

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
