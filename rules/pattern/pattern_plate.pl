:- encoding(utf8).
:- module(sg_pattern_plate,
          [ plate_measures/4,           % +D, +Area, +Options, -Measures
            material/2,                 % ?Name, -Density
            has_bends/1,                % +D
            bend_numbers/2,             % +Plate, -Numbers
            bend_table/4                % +Plate, +Options, -Marks, -Size
          ]).
:- use_module('../language', [result_language/1]).
:- use_module('../sheet/sheet_paper', [unit_millimetres/2]).
:- use_module('../store', [e/5, edge_polygon/3, joint/6, t/6, v/5]).
:- use_module('../unrolling/true_table', [table_marks/4]).
:- use_module(plate_words,
              [ bends_title/2, direction_word/3, material_word/3,
                plate_column/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [append/3, member/2, nth1/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> What a workshop asks of a pattern in plate: its bends, its weight.
*/

%!  material(?Name, -Density) is nondet.
%
%   Density, in kg/m3, is what is usually reckoned with for Name.

material(steel,     7850).
material(stainless, 7900).
material(aluminium, 2700).
material(copper,    8960).
material(brass,     8500).
material(zinc,      7140).
material(titanium,  4510).

%!  plate_measures(+D, +Area, +Options, -Measures:dict) is det.
%
%   Measures are of pattern D, of Area, in plate of thickness(T):
%
%     - thickness   T
%     - bends       a dict for each fold that bends by more than half a degree,
%                   in the order of their numbers: fold, edge, polygons (two),
%                   length, angle in degrees, direction (`down`: away from who
%                   sees the pattern from outside; or `up`), radius inside, and
%                   sequence: as which, from 1, it is bent
%     - weight      with material(Name), in kg; unit(U) says what one is
%
%   Flanges are bent from the outside in: those that hang farthest, by bends,
%   from the largest face of their piece go first; else by their numbers.
%
%   Options are those of the verb, or as of how_wished/3. Lengths are in units
%   of the model.

plate_measures(D, Area, Options, Measures) :-
    option(thickness(T), Options),
    radius(Options, T, Radius),
    findall(Bend, bend(D, Radius, Bend), Bends0),
    in_sequence(D, Bends0, Bends),
    (   option(material(Name), Options)
    ->  material(Name, Density),
        option(unit(Unit), Options, mm),
        unit_millimetres(Unit, Millimetres),
        Weight is Area*T*Density*(Millimetres/1000)**3,
        Measures = _{thickness:T, bends:Bends, material:Name, weight:Weight}
    ;   Measures = _{thickness:T, bends:Bends}
    ).

radius(Options, T, Radius) :-
    (   option('bend-radius'(Radius0), Options)
    ->  Radius = Radius0
    ;   option(bend_radius(Radius), Options, T)
    ).

%!  has_bends(+D) is semidet.
%
%   True when pattern D has a fold that bends by more than half a degree.

has_bends(D) :-
    bend(D, 0, _),
    !.

bend(D, Radius, _{fold:J, edge:E1, polygons:[P1,P2], length:Length,
                  angle:Degrees, direction:Direction, radius:Radius}) :-
    joint(D, J, E1, E2, fold, Angle),
    abs(Angle) > 0.5,
    Degrees is abs(Angle),
    (   Angle > 0
    ->  Direction = down
    ;   Direction = up
    ),
    edge_polygon(D, E1, P1),
    edge_polygon(D, E2, P2),
    e(D, E1, A, B, _),
    v(D, A, XA, YA, _),
    v(D, B, XB, YB, _),
    Length is sqrt((XB-XA)**2 + (YB-YA)**2).


                /*******************************
                *           SEQUENCE           *
                *******************************/

in_sequence(D, Bends0, Bends) :-
    fold_depths(D, Depths),
    findall(rank(Before,J)-J,
            ( member(Bend, Bends0),
              J = Bend.fold,
              get_assoc(J, Depths, Depth),
              Before is -Depth ),
            Ranked0),
    msort(Ranked0, Ranked),
    pairs_values(Ranked, Js),
    findall(J-N, nth1(N, Js, J), Numbered),
    list_to_assoc(Numbered, Sequence),
    maplist(with_sequence(Sequence), Bends0, Bends).

with_sequence(Sequence, Bend0, Bend) :-
    get_assoc(Bend0.fold, Sequence, N),
    Bend = Bend0.put(sequence, N).

%   fold_depths(D, Depths): Depths is an assoc from each fold to how many folds
%   there are from the largest face of its piece to the farther one of its two.
%   Two faces may have several folds.

fold_depths(D, Depths) :-
    findall(P-fold(J,Q),
            ( joint(D, J, E1, E2, fold, _),
              edge_polygon(D, E1, P1),
              edge_polygon(D, E2, P2),
              ( P = P1, Q = P2 ; P = P2, Q = P1 ) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Folds),
    findall(Less-P,
            ( member(P-_, Groups), face_area(D, P, Area), Less is -Area ),
            Ranked0),
    keysort(Ranked0, Ranked),
    empty_assoc(None),
    foldl(from_face(Folds), Ranked, None-None, _-Depths).

face_area(D, P, Area) :-
    findall(Part, ( t(D, P, _, A, B, C), triangle(D, A, B, C, Part) ), Parts),
    foldl(plus_area, Parts, 0.0, Area).

plus_area(Part, Area0, Area) :-
    Area is Area0+Part.

triangle(D, A, B, C, Area) :-
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is abs((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   from_face(Folds, Face, Seen0-Depths0, Seen-Depths): breadth first, from the
%   largest face of each piece, which comes first.

from_face(Folds, _-P, Seen0-Depths0, Seen-Depths) :-
    (   get_assoc(P, Seen0, _)
    ->  Seen = Seen0,
        Depths = Depths0
    ;   put_assoc(P, Seen0, true, Seen1),
        spread([P-0], Folds, Seen1, Seen, Depths0, Depths)
    ).

spread([], _, Seen, Seen, Depths, Depths).
spread([P-N|Faces0], Folds, Seen0, Seen, Depths0, Depths) :-
    (   get_assoc(P, Folds, Own)
    ->  true
    ;   Own = []
    ),
    N1 is N+1,
    spread_over(Own, N1, New, Seen0, Seen1, Depths0, Depths1),
    append(Faces0, New, Faces),
    spread(Faces, Folds, Seen1, Seen, Depths1, Depths).

spread_over([], _, [], Seen, Seen, Depths, Depths).
spread_over([fold(J,Q)|Folds], N, New, Seen0, Seen, Depths0, Depths) :-
    (   get_assoc(Q, Seen0, _)
    ->  New = New1,
        Seen1 = Seen0,
        (   get_assoc(J, Depths0, _)
        ->  Depths1 = Depths0
        ;   put_assoc(J, Depths0, N, Depths1)
        )
    ;   New = [Q-N|New1],
        put_assoc(Q, Seen0, true, Seen1),
        put_assoc(J, Depths0, N, Depths1)
    ),
    spread_over(Folds, N, New1, Seen1, Seen, Depths1, Depths).


                /*******************************
                *            SHEET             *
                *******************************/

%!  bend_numbers(+Plate:dict, -Numbers) is det.
%
%   Numbers is an assoc from the folds that are bends of Plate, measures of
%   plate_measures/4, to as which they are bent; on sheets B1, B2, ...

bend_numbers(Plate, Numbers) :-
    findall(J-N,
            ( member(Bend, Plate.bends), J = Bend.fold, N = Bend.sequence ),
            Pairs),
    list_to_assoc(Pairs, Numbers).

%!  bend_table(+Plate:dict, +Options, -Marks, -Size) is semidet.
%
%   Marks and Size, as of table_marks/4, are the table of the bends of Plate, in
%   their sequence, with the weight in its title. Options are those of
%   table_marks/4. Lengths are true ones, in millimetres: of Plate, millimetres
%   says what a unit of the model is, if it is there. Without
%   bends the table has the weight alone; it fails if that is not known.

bend_table(Plate, Options, Marks, Size) :-
    Plate.bends == [],
    !,
    get_dict(weight, Plate, Weight),
    result_language(Language),
    millimetres(Plate, F),
    findall(Word,
            ( member(Column, [thickness,weight,material]),
              plate_column(Column, Language, Word) ),
            Columns),
    Thick is Plate.thickness*F,
    format(atom(Thickness), '~2f', [Thick]),
    format(atom(Weighs), '~4g', [Weight]),
    material_word(Language, Plate.material, Material),
    table_marks([Columns,[Thickness,Weighs,Material]], Options, Marks, Size).
bend_table(Plate, Options, Marks, Size) :-
    result_language(Language),
    millimetres(Plate, F),
    findall(N-Line,
            ( member(Bend, Plate.bends),
              N = Bend.sequence,
              bend_line(Language, F, Bend, Line) ),
            Numbered0),
    keysort(Numbered0, Numbered),
    pairs_values(Numbered, Lines),
    findall(Word, bend_column(Language, Word), Columns),
    option(title(Name), Options, ""),
    plate_title(Language, Name, Plate, Title),
    table_marks([Columns|Lines], [title(Title)|Options], Marks, Size).

millimetres(Plate, F) :-
    (   get_dict(millimetres, Plate, F)
    ->  true
    ;   F = 1
    ).

bend_line(Language, F, Bend, [Name,Degrees,Direction,Radius,Length]) :-
    format(atom(Name), 'B~d', [Bend.sequence]),
    format(atom(Degrees), '~1f°', [Bend.angle]),
    direction_word(Language, Bend.direction, Direction),
    Radius0 is Bend.radius*F,
    format(atom(Radius), '~2f', [Radius0]),
    Length0 is Bend.length*F,
    format(atom(Length), '~2f', [Length0]).

bend_column(Language, Word) :-
    member(Column, [bend,angle,direction,radius,length]),
    plate_column(Column, Language, Word).

plate_title(Language, Name, Plate, Title) :-
    (   get_dict(weight, Plate, Weight)
    ->  material_word(Language, Plate.material, Material),
        format(string(Weighs), '~4g kg, ~w', [Weight,Material])
    ;   Weighs = ""
    ),
    (   member("", [Name,Weighs])
    ->  string_concat(Name, Weighs, Title0)
    ;   format(string(Title0), '~s: ~s', [Name,Weighs])
    ),
    (   Title0 == ""
    ->  bends_title(Language, Title)
    ;   Title = Title0
    ).
