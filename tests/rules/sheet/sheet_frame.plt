/* The frame of a sheet and its title block: against ISO 5457 and ISO 7200. */
% covers: sheet_paper, sheet_words
:- encoding(utf8).
:- module(test_sheet_frame, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(plunit)).
:- use_module(library(yall)).
:- use_module(rules(sheet/sheet_frame)).
:- use_module(rules(sheet/sheet_paper)).
:- use_module(rules(sheet/sheet_words)).

facts([ language-en, angle-third, scale-"1:2", paper-"A3", name-"Plate" ]).

marks(Width, Height, Marks) :-
    facts(Facts),
    frame(Width, Height, Facts, Marks, _).

%   lines(Marks, Role, Segments): straight pieces.

pieces(Marks, Role, Pieces) :-
    findall(A-B, ( member(line(Role,Points), Marks),
                   append(_, [A,B|_], Points) ), Pieces).

texts(Marks, Texts) :-
    findall(Text-(X-Y), member(text(X,Y,_,_,Text), Marks), Texts).

%   border_texts(Marks, Height, Side, Texts): what stands along a side.

along(Marks, top, Texts) :-
    findall(X-Text, ( member(text(X,Y,2.5,middle,Text), Marks), Y < 10 ), Ts),
    sorted(Ts, Texts).
along(Marks, left, Texts) :-
    findall(Y-Text, ( member(text(X,Y,2.5,middle,Text), Marks), X < 20 ), Ts),
    sorted(Ts, Texts).

sorted(Ts0, Texts) :-
    keysort(Ts0, Ts),
    findall(Text, member(_-Text, Ts), Texts).

words(Facts, Texts) :-
    frame(420, 297, Facts, Marks, _),
    findall(Text-High, member(text(_,_,High,_,Text), Marks), Texts).

:- begin_tests(sheet_frame).

test(room, Room == room(rect(26.0,16.0,404.0,281.0),[rect(224.0,245.0,410.0,
                                                          287.0)])) :-
    facts(Facts),
    frame(420, 297, Facts, _, Room).
test(bare, Room == room(rect(10.0,10.0,410.0,287.0),[])) :-
    bare_room(420, 297, Room).
test(frame_and_grid, Boxes == [[20.0-10.0,410.0-10.0,410.0-287.0,20.0-287.0,
                                20.0-10.0],
                               [15.0-5.0,415.0-5.0,415.0-292.0,15.0-292.0,
                                15.0-5.0]]) :-
    marks(420, 297, [line(frame,Frame),line(field,Grid)|_]),
    Boxes = [Frame,Grid].
%   Five millimetres to either side of the frame; the lower one does not go into
%   the title block.
test(centring, [ forall(member(W-H-Low, [420-297-282.0,210-297-287.0])),
                 true(Lines == [[MX-5.0,MX-15.0],[MX-Low,MX-B],
                                [15.0-MY,25.0-MY],[R1-MY,R2-MY]]) ]) :-
    marks(W, H, [_,_,A,B0,C,D|_]),
    maplist([line(frame,Points),Points]>>true, [A,B0,C,D], Lines0),
    maplist([Points0,Points]>>maplist([X0-Y0,X-Y]>>( X is X0*1.0, Y is Y0*1.0 ),
                                      Points0, Points), Lines0, Lines),
    MX is W/2.0,
    MY is H/2.0,
    B is H-5.0,
    R1 is W-15.0,
    R2 is W-5.0.
%   ISO 5457: so many fields of 50 mm.
test(fields, [ forall(member(Paper-Longer-Shorter,
                             ['A0'-24-16,'A1'-16-12,'A2'-12-8,'A3'-8-6,
                              'A4'-6-4])) ]) :-
    paper_size(Paper, Long, Short),
    marks(Long, Short, Marks),
    along(Marks, top, Numbers),
    numlist(1, Longer, Ns),
    maplist([N,T]>>number_string(N, T), Ns, Numbers),
    along(Marks, left, Letters),
    length(Letters, Shorter),
    atom_codes('ABCDEFGHJKLMNPQRSTUVWXYZ', Codes),
    length(Own, Shorter),
    once(append(Own, _, Codes)),
    maplist([C,T]>>( char_code(Ch, C), atom_string(Ch, T) ), Own, Letters),
    !.
test(divisions, Xs == [60.0,110.0,160.0,210.0,260.0,310.0,360.0]) :-
    marks(420, 297, Marks),
    findall(X, ( member(line(field,[X0-5.0,X0-10.0]), Marks), X is X0*1.0 ),
            Xs).

%   The lines of the block part it into its fields: the outline is whole, and no
%   text stands on a line.
test(block, Outline == [230.0-251.0,410.0-251.0,410.0-287.0,230.0-287.0,
                        230.0-251.0]) :-
    marks(420, 297, Marks),
    findall(Points, member(line(frame,Points), Marks), All),
    last(All, Outline).
test(labels, [ forall(member(Language, [en,ko])) ]) :-
    words([language-Language,angle-first], Texts),
    forall(sheet_word(Item, Language, Word),
           ( findall(x, member(Word-1.8, Texts), Found),
             assertion(Item-Found == Item-[x]) )),
    aggregate_all(count, sheet_word(_, Language, _), 12).
test(label_given, true) :-
    words([language-en,angle-first,label(name)-"What"], Texts),
    memberchk("What"-1.8, Texts),
    \+ memberchk("Name"-_, Texts).
test(values, Highs == [3.5-9,5.0-2]) :-
    findall(Item-"x",
            member(Item, [ drawn_by,date,company,name,checked_by,material,scale,
                           paper,number,revision,sheet ]), Pairs),
    words([language-en,angle-first|Pairs], Texts),
    findall(High, member("x"-High, Texts), Highs0),
    msort(Highs0, Highs1),
    clumped(Highs1, Highs).
test(empty_value, true) :-
    words([language-en,angle-first,name-""], Texts),
    \+ memberchk(""-_, Texts).
%   Each text stands within its field.
test(within, [ forall(member(Item-box(X1,Y1,X2,Y2),
       [ drawn_by-box(0,0,45,9), date-box(45,0,80,9), checked_by-box(0,9,45,18),
         material-box(45,9,80,18), company-box(0,18,80,36),
         name-box(80,0,180,18), scale-box(80,18,105,27),
         paper-box(80,27,105,36), number-box(130,18,180,27),
         revision-box(130,27,155,36), sheet-box(155,27,180,36) ])) ]) :-
    frame(420, 297, [language-en,angle-first,Item-"x y z"], Marks, _),
    memberchk(text(X,Y,High,middle,"x y z"), Marks),
    !,
    Middle is 230+(X1+X2)/2,
    abs(X-Middle) < 1.0e-9,
    Y-High > 251+Y1+2.8,
    Y < 251+Y2,
    once(sheet_word(Item, en, Word)),
    memberchk(text(LX,LY,1.8,start,Word), Marks),
    LX > 230+X1,
    LX < 230+X2,
    LY-1.8 > 251+Y1,
    LY < 251+Y1+4.
%   Where two fields meet there is a line, from side to side.
test(parted, [ forall(member(X-Y1-Y2, [45-0-9,45-9-18,80-0-18,80-18-36,
                                       105-18-27,130-18-36,155-27-36])) ]) :-
    marks(420, 297, Marks),
    pieces(Marks, field, Pieces),
    A is 230+X,
    B1 is 251+Y1,
    B2 is 251+Y2,
    findall(Low-High,
            ( member((P-Low0)-(Q-High0), Pieces), P =:= A, Q =:= A,
              Low0 >= B1-1.0e-9, High0 =< B2+1.0e-9,
              Low is Low0*1.0, High is High0*1.0 ), Parts),
    aggregate_all(sum(L), ( member(Low-High, Parts), L is High-Low ), Sum),
    abs(Sum-(Y2-Y1)) < 1.0e-9.
test(parted_below, [ forall(member(Y-X1-X2, [9-0-80,18-0-180,27-80-105,
                                             27-130-180])) ]) :-
    marks(420, 297, Marks),
    pieces(Marks, field, Pieces),
    B is 251+Y,
    A1 is 230+X1,
    A2 is 230+X2,
    aggregate_all(sum(L), ( member((Left-P)-(Right-Q), Pieces), P =:= B,
                            Q =:= B, Left >= A1-1.0e-9, Right =< A2+1.0e-9,
                            L is Right-Left ), Sum),
    abs(Sum-(X2-X1)) < 1.0e-9.

%   The symbol: third angle has the circles on the left of the cone, first angle
%   on the right; the narrow end is as high as the small circle.
test(symbol, [ forall(member(Angle-Side, [first-right,third-left])),
               true(Found-Radii == Side-[1.75,3.5]) ]) :-
    frame(420, 297, [language-en,angle-Angle], Marks, _),
    findall(Points, member(line(symbol,Points), Marks), [Cone|Circles]),
    maplist([X-_,X]>>true, Cone, Xs),
    sum_list(Xs, Sum),
    length(Xs, N),
    Middle is Sum/N,
    findall(R-X0,
            ( member(Circle, Circles),
              findall(X, member(X-_, Circle), Own),
              min_list(Own, Low),
              max_list(Own, High),
              R is round((High-Low)*500)/1000.0,
              X0 is (Low+High)/2 ),
            Rs0),
    keysort(Rs0, Rs),
    findall(R, member(R-_, Rs), Radii),
    ( Rs = [_-At|_], At > Middle -> Found = right ; Found = left ),
    findall(At1-Y, member(At1-Y, Cone), Corners0),
    sort(Corners0, Corners),
    group_pairs_by_key(Corners, [_-[N1,N2],_-[W1,W2]]),
    abs(N2-N1-3.5) < 1.0e-9,
    abs(W2-W1-7) < 1.0e-9.
test(within_the_field) :-
    frame(420, 297, [language-en,angle-first], Marks, _),
    forall(( member(line(Role,Points), Marks), memberchk(Role, [symbol,axis]),
             member(X-Y, Points) ),
           ( X > 335, X < 360, Y > 269, Y < 287 )).

%   Long texts: as high as there is room, then without their end.
test(long, [ forall(member(N-Code-Wanted, [19-0'x-5.0,22-0'x-Small,
                                           14-0xad00-Korean])),
             true(abs(High-Wanted) < 1.0e-9) ]) :-
    Small is 97/(22*0.9),
    Korean is 97/(14*1.42),
    length(Codes, N),
    maplist(=(Code), Codes),
    string_codes(Text, Codes),
    words([language-en,angle-first,name-Text], Texts),
    memberchk(Text-High, Texts).
test(too_long, Found == [107-whole,108-cut]) :-
    findall(N-How,
            ( member(N, [107,108]),
              length(Codes, N),
              maplist(=(0'x), Codes),
              string_codes(Text, Codes),
              words([language-en,angle-first,name-Text], Texts),
              (   memberchk(Text-High, Texts)
              ->  How = whole,
                  assertion(High >= 1.0)
              ;   How = cut,
                  once(( member(Part-1.0, Texts),
                         string_concat(Start, "...", Part) )),
                  string_length(Start, Kept),
                  assertion(( Kept*0.9+2.7 =< 97, (Kept+1)*0.9+2.7 > 97 ))
              ) ),
            Found).

test(papers, [ forall(member(Text-W-H,
       [ a4-210-297, 'A4'-210-297, 'a4-landscape'-297-210, a3-420-297,
         'A3-Portrait'-297-420, a0-1189-841, 'A1'-841-594, a2-594-420 ])),
               true(Found == W-H) ]) :-
    paper(Text, W0, H0),
    Found = W0-H0.
test(no_paper, [ forall(member(Text, [a5,b4,'a4-up','a4-landscape-portrait',
                                      ''])),
                 fail ]) :-
    paper(Text, _, _).
test(paper_names, Names == ['A4','A4','A0','210x148','297.5x210']) :-
    findall(Name, ( member(W-H, [210-297,297-210,1189-841,210-148,297.5-210]),
                    paper_name(W, H, Name) ), Names).
test(scales) :-
    findall(Factor, ( standard_scale(Scale), scale_factor(Scale, Factor) ),
            Factors),
    length(Factors, 55),
    Factors = [Most|_],
    last(Factors, Least),
    Most =:= 1.0e9,
    Least =:= 1.0e-9,
    sort(0, @>, Factors, Factors),
    forall(append(_, [A,B|_], Factors),
           ( R is A/B, ( abs(R-2) < 1.0e-9 ; abs(R-2.5) < 1.0e-9 ) )),
    forall(standard_scale(N:M), ( memberchk(1, [N,M]), integer(N),
                                  integer(M) )).
test(units, Units == [cm-10.0,inch-25.4,m-1000.0,mm-1.0]) :-
    findall(Unit-Mm, unit_millimetres(Unit, Mm), Units0),
    sort(Units0, Units).
test(pupil, [ forall(member(Language, [en,ko])) ]) :-
    findall(Word, ( member(Field, [class,name,number,date]),
                    pupil_word(Field, Language, Word) ), Words),
    sort(Words, Sorted),
    length(Sorted, 4),
    forall(member(Word, Words), \+ memberchk(Word, ["class","name","number",
                                                    "date"])).
test(other_field, Word == "teacher") :-
    pupil_word(teacher, ko, Word).

:- end_tests(sheet_frame).
