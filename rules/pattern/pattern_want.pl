:- encoding(utf8).
:- module(sg_pattern_want,
          [ wanted_texts/4              % +Options, +Numbers, +Placed, -Wanted
          ]).
:- use_module('../near', [is_straight/2, below_zero/2, same_direction/2]).
:- use_module(pattern_face, [first_of/3]).
:- use_module(pattern_number, [reads_turned/1]).
:- use_module(pattern_plate, [bend_numbers/2]).
:- use_module(pattern_title, [piece_title/3]).
:- use_module('../development/polygon_name', [polygon_name/3]).
:- use_module('../language', [language/1]).
:- use_module('../store', [origin/3, segment/3]).
:- use_module('../unrolling/true_elbow', [throat_and_heel/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/2, member/2]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> What is to be written on a piece of a pattern.
*/

%!  wanted_texts(+Options, +Numbers, +Placed, -Wanted) is det.
%
%   Wanted, as of written/5 (pattern_text.pl), are the texts of the piece Placed
%   (pattern_drawing.pl): numbers of seams first, then of generators, the name
%   of the piece, quarter turns, names of faces, and angles, as Options say;
%   Numbers are those of seam_numbers/2.

wanted_texts(Options, Numbers, Placed, Wanted) :-
    findall(Length-Want, seam_text(Placed, Options, Numbers, Length, Want),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Seams),
    generator_texts(Placed, Generators),
    findall(Want, face_or_angle_text(Placed, Options, Want), Others),
    findall(Want, title_text(Placed, Options, Want), Titles),
    findall(Want, quarter_text(Placed, Want), Quarters),
    append([Seams,Generators,Titles,Quarters,Others], Wanted).

%   seam_text(Placed, Options, Numbers, Length, Want): Length is that of the
%   longest place. Short ones, which leave less choice, come first.

seam_text(placed(Name,_,_,Lines,Sides), Options, Numbers, Longest,
          want(number,Name,Text,[4.0,3.2,2.5,2.0,1.6,1.3],
               first_of([beside(Places),beside(Tabs),
                         over_folds(beside(Places))]))) :-
    option(numbers(true), Options, true),
    get_assoc(Name, Numbers, Wanted),
    findall((J-Which)-place(E,A,B),
            member(side(E,_,_-A,_-B,seam(J,_,Which)), Sides),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Placed),
    folds_by_edge(Lines, Folds),
    member(N-Seams, Wanted),
    first_of(12, Seams, Some),
    findall(Place, ( member(Seam, Some), get_assoc(Seam, Placed, Place) ),
            Sided),
    findall(A-B, member(place(_,A,B), Sided), Places),
    aggregate_all(max(Length), ( member(A-B, Places), length_of(A, B, Length) ),
                  Longest),
    findall(Tab, ( member(Place, Sided), tab_at(Place, Folds, Tab) ), Tabs),
    option(partner_sheets(Sheets), Options, none),
    partner_text(N, Name, Sheets, Text).

length_of(XA-YA, XB-YB, Length) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2).

%   partner_text(N, Name, Sheets, Text): with the number of the sheet that the
%   partner is on, if that is another one and there is room.

partner_text(N, Name, Sheets, Text) :-
    number_text(N, Short),
    (   Sheets \== none,
        get_assoc(N-Name, Sheets, Sheet)
    ->  format(string(Long), '~d p~d', [N,Sheet]),
        Text = either(Long, Short)
    ;   Text = Short
    ).

%   title_text(Placed, Options, Want): the name of the piece, over generators.

title_text(placed(Name,Faces,_,_,_), Options,
           want(face_name,Name,Title,[6.0,4.5,3.2,2.5,2.0],
                first_of([within(Shapes),
                          over_lines(within_any(Shapes))]))) :-
    option(titles(Titles), Options, []),
    piece_title(Titles, Name, Title),
    findall(Shape, ( member(face(_,Own), Faces), member(Shape, Own) ), Shapes).

%   generator_texts(Placed, Wanted): all of a piece have the same Shapes, which
%   are not copied for each.

generator_texts(placed(Name,Faces,_,_,Sides), Wanted) :-
    findall(generator(N,A,B),
            member(side(_,_,_-A,_-B,generator(N)), Sides),
            Generators),
    (   Generators == []
    ->  Wanted = []
    ;   findall(Shape,
                ( member(face(_,Own), Faces), member(Shape, Own) ),
                Shapes),
        maplist(generator_text(Name, Shapes), Generators, Wanted)
    ).

%   quarter_text(Placed, Want) is nondet: the generators at quarter turns have
%   their degrees along them; of an elbow the throat and the heel say that they
%   are, wherever they are.

quarter_text(placed(Name,Faces,_,_,Sides),
             want(generator_number,Name,Text,[3.2,2.5,2.0,1.6],
                  middle_of(Places,Shapes))) :-
    Name = name(D, _, _),
    once(( member(side(E0,_,_,_,generator(_)), Sides),
           origin(D, e(E0), _) )),
    quarters(D, Quarters),
    elbow_words(D, Words),
    findall(Degrees, ( member(Degrees, Quarters)
                     ; member(Degrees-_, Words),
                       \+ ( member(Quarter, Quarters),
                            same_direction(Degrees, Quarter) ) ),
            Wanted),
    findall(Shape, ( member(face(_,Own), Faces), member(Shape, Own) ), Shapes),
    member(Direction, Wanted),
    findall(A-B,
            ( member(side(E,_,_-A,_-B,generator(_)), Sides),
              once(origin(D, e(E), generator(_, Degrees, _, _, _))),
              same_direction(Degrees, Direction) ),
            Places),
    Places \== [],
    quarter_words(Words, Quarters, Direction, Text).

%   quarters(D, Quarters): those at which D has generators; one alone is chance.

quarters(D, Quarters) :-
    findall(Quarter,
            ( member(Quarter, [0,90,180,270]),
              once(( origin(D, e(_), generator(_, Degrees, _, _, _)),
                     same_direction(Degrees, Quarter) )) ),
            Quarters0),
    (   Quarters0 = [_,_|_]
    ->  Quarters = Quarters0
    ;   Quarters = []
    ).

%   elbow_words(D, Words): Degrees-Word of the throat and the heel, if any.

elbow_words(D, Words) :-
    (   throat_and_heel(D, Throat, Heel)
    ->  language(Language),
        elbow_word(throat, Language, Word1),
        elbow_word(heel, Language, Word2),
        Words = [Throat-Word1,Heel-Word2]
    ;   Words = []
    ).

quarter_words(Words, Quarters, Direction, Text) :-
    (   member(Degrees-Word, Words),
        same_direction(Degrees, Direction)
    ->  (   memberchk(Direction, Quarters)
        ->  format(string(Long), '~d° ~w', [Direction,Word]),
            format(string(Short), '~d°', [Direction]),
            Text = either(Long, Short)
        ;   atom_string(Word, Text)
        )
    ;   format(string(Text), '~d°', [Direction])
    ).

elbow_word(throat, en, throat).
elbow_word(heel,   en, heel).
elbow_word(throat, ko, '안쪽(목)').
elbow_word(heel,   ko, '바깥쪽(등)').

generator_text(Name, Shapes, generator(N,A,B),
               want(generator_number,Name,Text,[2.5,2.0,1.6],
                    end_of(A,B,Shapes))) :-
    number_text(N, Text).

face_or_angle_text(placed(Name,Faces,_,_,_), Options,
                   want(face_name,Name,Text,[6.0,4.5,3.2,2.5,2.0],
                        within(Shapes))) :-
    option(names(What), Options, false),
    \+ memberchk(What, [false,pieces]),
    Name = name(D, _, _),
    member(face(P,Shapes), Faces),
    face_text(What, D, P, Text).
face_or_angle_text(placed(Name,_,_,_,Sides), Options,
                   want(angle,Name,Text,[3.2,2.5,2.0,1.6],
                        over_lines(along(A,B)))) :-
    option(plates(Plates), Options, []),
    Name = name(D, _, _),
    memberchk(D-Plate, Plates),
    bend_numbers(Plate, Numbers),
    member(side(_,_,_-A,_-B,fold(J,_,1)), Sides),
    get_assoc(J, Numbers, N),
    format(string(Text), 'B~d', [N]).
face_or_angle_text(placed(Name,_,_,_,Sides), Options,
                   want(angle,Name,Text,[2.5,2.0,1.6],along(A,B))) :-
    option(angles(true), Options, false),
    option(fold_threshold(Threshold), Options, 0.5),
    member(side(_,_,_-A,_-B,fold(_,Angle,1)), Sides),
    abs(Angle) > Threshold,
    angle_text(Angle, Text).

%   folds_by_edge(Lines, Folds): Folds is an assoc from edges to the lines Q-P
%   along which something may be folded there.

folds_by_edge(Lines, Folds) :-
    findall(E-(Q-P),
            ( member(line(Role,E,Q,P), Lines),
              memberchk(Role, [fold_down,fold_up,mark])
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Folds).

%   tab_at(Place, Folds, Tab) is nondet: Tab is P-Q where a tab is folded at a
%   part Q-P of the side Place, so the tab is on the left of it.

tab_at(place(E,XA-YA,XB-YB), Folds, (X-Y)-(XQ-YQ)) :-
    get_assoc(E, Folds, Own),
    DX is XB-XA,
    DY is YB-YA,
    Square is DX*DX + DY*DY,
    member((XQ-YQ)-(X-Y), Own),
    is_straight(DX*(Y-YA) - DY*(X-XA), Square),
    is_straight(DX*(YQ-YA) - DY*(XQ-XA), Square),
    \+ below_zero(DX*(XQ-XA) + DY*(YQ-YA), Square),
    \+ below_zero(DX*(XB-X) + DY*(YB-Y), Square),
    DX*(X-XQ) + DY*(Y-YQ) > 0.

number_text(N, Text) :-
    number_string(N, String),
    (   reads_turned(N)
    ->  Text = underlined(String)
    ;   Text = String
    ).

%   In whole degrees, or tenths if that is needed.

angle_text(Angle, Text) :-
    Tenths is round(abs(Angle)*10),
    (   Tenths mod 10 =:= 0
    ->  Degrees is Tenths//10,
        format(string(Text), '~d°', [Degrees])
    ;   format(string(Text), '~1d°', [Tenths])
    ).

%   What the face is of its primitive, or of that of a leaf (polygon_name/3), if
%   words are wanted and there are any.

face_text(words, D, P, Text) :-
    segment(D, _, Term),
    ( Term = development(S) ; Term = true_development(S, _) ),
    integer(S),
    polygon_name(S, P, What),
    What \== P,
    face_words(What, Text),
    !.
face_text(_, _, P, Text) :-
    number_text(P, Text).

face_words(Leaf/What, Text) :-
    !,
    face_words(What, Text0),
    format(string(Text), '~w/~s', [Leaf,Text0]).
face_words(What, Text) :-
    atom(What),
    !,
    atom_string(What, Text).
face_words(What, Text) :-
    compound(What),
    What =.. [Name,I],
    integer(I),
    format(string(Text), '~w ~d', [Name,I]).
