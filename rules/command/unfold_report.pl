:- encoding(utf8).
:- module(sg_unfold_report,
          [ unfold_measures/3,          % +Ds, +Options, -Measures
            unfold_report/2,            % +Options, +Measures
            pattern_measures/3          % +Parts, +D, -Measures
          ]).
:- use_module('../csg/placed_surface', [asked_once/1, kept_answer/4]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../development/development_record', [development_measures/2]).
:- use_module('../kernel', [census/1]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../language', [language/1]).
:- use_module('../plain', [plain_json/2, plain_text/2]).
:- use_module('../pattern/plate_words', [material_word/3]).
:- use_module('../pattern/pattern_yield', [pattern_yield/2]).
:- use_module('../pattern/pattern_title', [pattern_title/2]).
:- use_module(report, [counted/4]).
:- use_module('../development/seam_measure', [pattern_area/2, seam_drawn/3]).
:- use_module('../store', [segment/3, v/5, p/3, origin/3, from_p/5, piece/3]).
:- use_module('../solid/trimmed', [part_named/2, trimmed_from/2]).
:- use_module('../unrolling/true_sphere', [sphere_part_polygon/3]).
:- use_module('../unrolling/true_parts', [polygon_drawn/4]).
:- use_module('../unfolding/unfold', [pattern_of/2]).
:- use_module('../unfolding/unfold_how', [how_wished/3]).
:- use_module('../pattern/pattern_plate', [plate_measures/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(option), [option/2]).
/** <module> What is said of patterns: their pieces, seams, sheet and area.
*/

%!  unfold_measures(+Ds:list, +Options:list, -Measures:list) is det.
%
%   Measures are dicts, those of each of the patterns Ds.

unfold_measures(Ds, Options, All) :-
    census(Parts),
    asked_once(maplist(pattern_measures(Parts), Ds, All0)),
    maplist(measured_if_bent(Options), All0, All1),
    maplist(with_yield(Options), All1, All).

%!  unfold_report(+Options:list, +Measures:list) is det.
%
%   Print Measures to current output, as text in the language of the messages,
%   or with json(true) as JSON.

unfold_report(Options, All) :-
    (   option(json(true), Options)
    ->  plain_json(current_output,
                   json_laid_out(current_output, All, 78)),
        nl
    ;   language(Language),
        maplist(print_pattern(Language), All)
    ).

%   with_yield(Options, M0, M): that of all sheets together.

with_yield(Options, M0, M) :-
    (   option(drawings(Drawings), Options),
        \+ option(tile(true), Options)
    ->  pattern_yield(Drawings, Yield),
        M = M0.put(Yield)
    ;   M = M0
    ).

measured_if_bent(Options0, M0, M) :-
    how_wished(M0.segment, Options0, Options),
    (   option(thickness(T), Options),
        T > 0
    ->  measured_again(M0, M1),
        plate_measures(M1.pattern, M1.pattern_area, Options, Plate),
        M = M1.put(Plate)
    ;   M = M0
    ).

%   measured_again(M0, M): bends have taken off what they need.

measured_again(M0, M) :-
    pattern_area(M0.pattern, Area),
    seam_drawn(M0.pattern, Seam, Longest),
    M = M0.put(_{pattern_area:Area, seam:Seam, longest:Longest, bound:null,
                  bound_by:null}).

%!  pattern_measures(+Parts, +D, -Measures:dict) is det.
%
%   Measures of pattern D, with Parts of census/1:
%
%     - segment, name      what was to be unfolded
%     - part               that, or what was trimmed of it
%     - pattern            D
%     - polygons, pieces   how many there are in it
%     - removed            how many polygons of the part are not
%     - objective          what was to be small: seam, pieces, longest, area; or
%                          `rules`, if a rule file says how to join
%     - seam, bound, bound_by, longest  development_measures/2; of a pattern
%                          that was not made by develop/3, or is bent, no
%                          bound, and the rest by seam_drawn/3
%     - width, height      of the sheet that the pieces lie on, side by side
%     - area, pattern_area         of the part and of the pattern
%
%   Lengths and areas are in model units.

pattern_measures(Parts, D, Measures) :-
    pattern_of(D, T),
    part_named(T, S),
    pattern_title(D, Name),
    memberchk(part(T, Counts, _, Area, _, _, _, _), Parts),
    arg(4, Counts, PartPolygons),
    aggregate_all(count, p(D, _, _), Polygons),
    aggregate_all(r(min(X), max(X), min(Y), max(Y)), v(D, _, X, Y, _),
                  r(X1, X2, Y1, Y2)),
    Width is X2-X1,
    Height is Y2-Y1,
    removed(D, T, PartPolygons, Polygons, Removed),
    seam_measures(D, Pieces, Seam, Bound, By, Longest, PatternArea),
    objective(D, Objective),
    Measures = _{segment:S, name:Name, part:T, pattern:D, polygons:Polygons,
                 pieces:Pieces, removed:Removed, objective:Objective,
                 seam:Seam, bound:Bound, bound_by:By, longest:Longest,
                 width:Width, height:Height, area:Area,
                 pattern_area:PatternArea}.

seam_measures(D, Pieces, Seam, Bound, By, Longest, Area) :-
    origin(D, node(D), _),
    !,
    development_measures(D, Measures),
    _{pieces:Pieces, seam:Seam, bound:Bound, bound_by:By, longest:Longest,
      area:Area} :< Measures.
seam_measures(D, Pieces, Seam, null, null, Longest, Area) :-
    aggregate_all(max(K), piece(D, _, K), Pieces),
    seam_drawn(D, Seam, Longest),
    pattern_area(D, Area).

%   objective(D, Objective): what was to be small, or `rules` where a rule file
%   has said how to join.

objective(D, Objective) :-
    (   \+ ( decision_is_default(join_order/3),
             decision_is_default(may_join/2) )
    ->  Objective = rules
    ;   origin(D, node(D), laid(Options, _, _, _)),
        option(minimize(Objective0), Options)
    ->  Objective = Objective0
    ;   Objective = seam
    ).

%   removed(D, T, PartPolygons, Polygons, Removed): how many of T are not in D;
%   of a part in fine facets, how many that are drawn.

removed(D, T, PartPolygons, Polygons, Removed) :-
    (   is_finer(T)
    ->  findall(P0, polygon_left(D, T, P0), Left0),
        sort(Left0, Left),
        length(Left, Count),
        kept_answer(drawn_polygons, T, all, All),
        Removed is All-Count
    ;   from_p(D, _, _, _, _)
    ->  aggregate_all(count, ( p(T, P, _), \+ left_in(D, P) ), Removed)
    ;   Removed is PartPolygons-Polygons
    ).

%   drawn_polygons(T, all, Count): so many polygons have what T is made of.

drawn_polygons(T, all, Count) :-
    findall(P0, ( p(T, P, _), polygon_drawn(T, P, _, P0) ), Ps0),
    sort(Ps0, Ps),
    length(Ps, Count).

is_finer(T) :-
    trimmed_from(T, S1),
    origin(S1, p(_), p(_)),
    !.

%   polygon_left(D, T, P0) is nondet: of what is drawn P0 is in pattern D; a
%   gore or zone stands for many.

polygon_left(D, T, P0) :-
    segment(D, _, true_development(_, Part)),
    sphere_part_polygon(T, Part, P),
    polygon_drawn(T, P, _, P0).
polygon_left(D, T, P0) :-
    p(D, P, _),
    (   from_p(D, P, T, P1, _)
    ->  true
    ;   P1 = P
    ),
    polygon_drawn(T, P1, _, P0).

%   left_in(D, P): polygon P is in D, or its triangles are.

left_in(D, P) :-
    (   p(D, P, _)
    ->  true
    ;   from_p(D, _, _, P, _)
    ->  true
    ).


                /*******************************
                *             TEXT             *
                *******************************/

print_pattern(Language, M) :-
    counted(Language, polygon, M.polygons, Polygons),
    pieces(Language, M.pieces, Pieces),
    plain_text(M.name, Name),
    say(Language, pattern, [M.segment, Name, Polygons, Pieces]),
    atom_concat('objective ', M.objective, Objective),
    say(Language, Objective, []),
    say(Language, seam, [M.seam]),
    (   number(M.bound),
        M.bound > 0
    ->  atom_concat('bound ', M.bound_by, Key),
        say(Language, Key, [M.bound])
    ;   true
    ),
    say(Language, weld, [M.longest]),
    say(Language, sheet, [M.width, M.height]),
    say(Language, area, [M.pattern_area]),
    (   M.removed =:= 0
    ->  say(Language, all, [M.area])
    ;   counted(Language, polygon, M.removed, Removed),
        say(Language, without, [M.area, Removed])
    ),
    (   get_dict(weight, M, Weight)
    ->  material_word(Language, M.material, Material),
        say(Language, weight, [Weight, Material])
    ;   true
    ).

pieces(ko, N, Text) :-
    !,
    format(string(Text), '조각 ~D개', [N]).
pieces(_, 1, "1 piece") :-
    !.
pieces(_, N, Text) :-
    format(string(Text), '~D pieces', [N]).

say(Language, Key, Arguments) :-
    (   text(Language, Key, Format)
    ->  true
    ;   text(en, Key, Format)
    ),
    format(Format, Arguments).

text(en, pattern, "segment ~d: ~w, ~s in ~s~n").
text(en, 'objective seam', "  objective    a short seam~n").
text(en, 'objective pieces', "  objective    few pieces~n").
text(en, 'objective longest', "  objective    no long weld~n").
text(en, 'objective area', "  objective    a small sheet~n").
text(en, 'objective rules', "  objective    as the rule file says~n").
text(en, seam, "  seam         ~6g").
text(en, 'bound tree', " (at least ~6g)").
text(en, 'bound forest', " (at least ~6g, as a forest)").
text(en, 'bound moats', " (at least ~6g, by moats)").
text(en, weld, ", the longest weld ~6g~n").
text(en, sheet, "  sheet        ~6g x ~6g~n").
text(en, area, "  area         ~6g").
text(en, all, " of ~6g~n").
text(en, without, " of ~6g, without ~s~n").
text(en, weight, "  weight       ~4g kg of ~w~n").
text(ko, pattern, "세그먼트 ~d: ~w, ~s, ~s~n").
text(ko, 'objective seam', "  목표         짧은 접합선~n").
text(ko, 'objective pieces', "  목표         적은 조각~n").
text(ko, 'objective longest', "  목표         긴 용접선이 없음~n").
text(ko, 'objective area', "  목표         작은 판재~n").
text(ko, 'objective rules', "  목표         규칙 파일대로~n").
text(ko, seam, "  접합선       ~6g").
text(ko, 'bound tree', " (하한 ~6g)").
text(ko, 'bound forest', " (하한 ~6g, 숲)").
text(ko, 'bound moats', " (하한 ~6g, 해자)").
text(ko, weld, ", 가장 긴 용접선 ~6g~n").
text(ko, sheet, "  판재         ~6g x ~6g~n").
text(ko, area, "  넓이         ~6g").
text(ko, all, " / ~6g~n").
text(ko, without, " / ~6g, ~s 제외~n").
text(ko, weight, "  무게         ~4g kg (~w)~n").
