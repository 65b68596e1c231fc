:- module(sg_pattern_strip,
          [ seam_runs/3,                % +Width, +Pieces, -Runs
            strip_form/5                % +Points, +Width, +Least, -Strip, -Area
          ]).
:- use_module('../near', [is_straight/2]).
:- use_module(pattern_number, [seam_strands/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), 
              [append/3, last/2, max_list/2, member/2, reverse/2]).
/** <module> Tabs along curves: short seams that follow each other share one.

The facets of a curve are too short for tabs of their own. As long as they turn
little, some of them together have one, a strip

    strip(Outline, Cells)

that stands on all of them: Outline is the way round it, from the first point of
the curve to the last, Cells are what it covers, convex or nearly.
*/

:- set_prolog_flag(optimise, true).

% What a strip may turn along its curve, in degrees: more would not lie flat.
most_turn(25.0).

% Seams that are shorter than so many widths share a tab; a strip is so many
% widths long, or less.
short(0.9).
long(2.5).

%!  seam_runs(+Width, +Pieces, -Runs) is det.
%
%   Runs are lists of two or more seams k(Name,J,Which)-Partner that follow each
%   other along the piece of the first (pattern_number.pl), on the other side
%   their partners: they share a tab if tabs are to be Width wide.

seam_runs(Width, Pieces, Runs) :-
    seam_strands(Pieces, Strands),
    findall(Key-Length, side_length(Pieces, Key, Length, _), Lengths0),
    sort(1, @<, Lengths0, Lengths1),
    list_to_assoc(Lengths1, Lengths),
    findall(Key-Way, side_length(Pieces, Key, _, Way), Ways0),
    sort(1, @<, Ways0, Ways1),
    list_to_assoc(Ways1, Ways),
    findall(Run,
            ( member(Strand, Strands),
              Strand = [_,_|_],
              strand_run(Strand, Width, Lengths, Ways, Run)
            ),
            Runs).

side_length(Pieces, k(Name,J,Which), Length, Way) :-
    member(piece(Name,_,Sides), Pieces),
    member(side(_,_,_-(XA-YA),_-(XB-YB),seam(J,_,Which)), Sides),
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Way is atan2(YB-YA, XB-XA).

%   The short seams of a strand, as many together as make about the same length.

strand_run(Strand, Width, Lengths, Ways, Run) :-
    short(Short),
    Most is Short*Width,
    short_part(Strand, Lengths, Most, Part),
    Part = [_,_|_],
    foldl(length_added(Lengths), Part, 0.0, All),
    long(Long),
    Target is All/ceiling(All/(Long*Width)),
    even_runs(Part, Target, Lengths, Ways, Runs0),
    none_alone(Runs0, Runs),
    member(Run, Runs),
    Run = [_,_|_].

length_added(Lengths, Key-_, Sum0, Sum) :-
    get_assoc(Key, Lengths, Length),
    Sum is Sum0+Length.

short_part(Strand, Lengths, Most, Part) :-
    long_skipped(Strand, Lengths, Most, Rest),
    short_taken(Rest, Lengths, Most, Part0, Rest1),
    Part0 \== [],
    (   Part = Part0
    ;   short_part(Rest1, Lengths, Most, Part)
    ).

long_skipped([Key-Partner|Strand], Lengths, Most, Rest) :-
    get_assoc(Key, Lengths, Length),
    (   Length < Most
    ->  Rest = [Key-Partner|Strand]
    ;   long_skipped(Strand, Lengths, Most, Rest)
    ).

short_taken([Key-Partner|Strand], Lengths, Most, [Key-Partner|Part], Rest) :-
    get_assoc(Key, Lengths, Length),
    Length < Most,
    !,
    short_taken(Strand, Lengths, Most, Part, Rest).
short_taken(Rest, _, _, [], Rest).

even_runs([], _, _, _, []) :-
    !.
even_runs([Seam|Seams], Target, Lengths, Ways, [[Seam|Run]|Runs]) :-
    Seam = Key-_,
    get_assoc(Key, Lengths, Length),
    get_assoc(Key, Ways, Way),
    run_on(Seams, Target, Length, Way, Lengths, Ways, Run, Rest),
    even_runs(Rest, Target, Lengths, Ways, Runs).

%   One seam at the end is taken along by the run before it.

none_alone([Run0,[Seam]], [Run]) :-
    !,
    append(Run0, [Seam], Run).
none_alone([Run|Runs0], [Run|Runs]) :-
    none_alone(Runs0, Runs).
none_alone([], []).

run_on([Seam|Seams], Target, So, First, Lengths, Ways, [Seam|Run], Rest) :-
    Seam = Key-_,
    get_assoc(Key, Lengths, Length),
    get_assoc(Key, Ways, Way),
    So+Length/2 =< Target,
    most_turn(Most),
    cos(Way-First) >= cos(Most*pi/180),
    !,
    Longer is So+Length,
    run_on(Seams, Target, Longer, First, Lengths, Ways, Run, Rest).
run_on(Rest, _, _, _, _, _, [], Rest).


                /*******************************
                *            A STRIP           *
                *******************************/

%!  strip_form(+Points, +Width, +Least, -Strip, -Area) is nondet.
%
%   Strip is one that may stand on the right of the line through Points, X-Y,
%   largest first; at most Width deep and at least Least. Its needed room is
%   larger by what a knife needs.

strip_form(Points, Width, Least, strip(Outline,Cells), Area) :-
    Points = [First|_],
    last(Points, Last),
    chord(First, Last, Chord),
    maplist(seen_along(Chord), Points, Seen),
    Chord = chord(_, _, _, Length),
    findall(H, member(_-H, Seen), Hs),
    max_list([0.0|Hs], Sagitta),
    member(Part, [1.0,0.75,0.55,0.4]),
    Deep is Sagitta + min(Width, 0.45*Length)*Part,
    Deep-Sagitta >= Least,
    member(Slope, [1,2]),
    Length-2*Slope*Deep >= 0.1*Length,
    strip_outline(Slope, Deep, Length, Seen, Along),
    maplist(seen_from(Chord), Along, Outline0),
    ends_copied(Outline0, First, Last, Outline),
    Needed is Sagitta + 1.05*(Deep-Sagitta),
    Steep is 0.85*Slope,
    strip_cells(Steep, Needed, Sagitta, Length, Seen, Cells0),
    maplist(maplist(seen_from(Chord)), Cells0, Cells),
    Area is (Deep-Sagitta)*(Length-Slope*Deep).

chord(XA-YA, XB-YB, chord(XA-YA,U,V,Length)) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Length > 0,
    U is (XB-XA)/Length,
    V is (YB-YA)/Length.

%   Along-Deep, as in pattern_trim.pl.

seen_along(chord(X0-Y0,U,V,_), X-Y, Along-Deep) :-
    Along is (X-X0)*U + (Y-Y0)*V,
    Deep is (X-X0)*V - (Y-Y0)*U.

seen_from(chord(X0-Y0,U,V,_), Along-Deep, X-Y) :-
    X is X0 + Along*U + Deep*V,
    Y is Y0 + Along*V - Deep*U.

%   The top has a point for each corner of the curve, so that each of its seams
%   has its own part of the outline.

strip_outline(Slope, Deep, Length, Seen, [0.0-0.0,Low-Deep|Top]) :-
    Low is Slope*Deep,
    High is Length-Low,
    Seen = [_|Inner0],
    top_points(Inner0, Seen, Low, High, Length, Deep, Top,
               [High-Deep,Length-0.0]).

top_points([_], _, _, _, _, _, Top, Top) :-
    !.
top_points([Along-_|Inner], Seen, Low, High, Length, Deep, [X-Deep|Top0],
           Top) :-
    X is Low + max(0.0, min(1.0, Along/Length))*(High-Low),
    top_points(Inner, Seen, Low, High, Length, Deep, Top0, Top).

ends_copied([_|Points0], First, Last, [First|Points]) :-
    reverse(Points0, [_|Back]),
    reverse([Last|Back], Points).

%   What lies between the curve and the level of its highest point, seam by
%   seam, and what is above that.

strip_cells(Slope, Deep, Sagitta, Length, Seen, [Above|Cells]) :-
    Low is Slope*Sagitta,
    High is Length-Low,
    Low1 is Slope*Deep,
    High1 is Length-Low1,
    Above = [Low-Sagitta,Low1-Deep,High1-Deep,High-Sagitta],
    cells_below(Seen, Low, High, Sagitta, Cells).

cells_below([_], _, _, _, []) :-
    !.
cells_below([A-DA,B-DB|Seen], Low, High, Sagitta, Cells) :-
    A1 is max(Low, min(High, A)),
    B1 is max(Low, min(High, B)),
    (   \+ is_straight(max(0.0, Sagitta-min(DA, DB)), 1.0)
    ->  Cells = [[A-DA,A1-Sagitta,B1-Sagitta,B-DB]|Cells1]
    ;   Cells = Cells1
    ),
    cells_below([B-DB|Seen], Low, High, Sagitta, Cells1).
