/* Nesting of parts on sheets, for bench/nesting.

       bench/nesting.pl

   Jobs of a workshop, made by a generator with a fixed start: discs, rings,
   rectangles, brackets, gussets, sectors, saddle templates, frames with parts
   that fit into their holes. For each prints: parts, the sum of their areas,
   sheets and the share of the sheets that is used (the last one counted as far
   as it is used), by our nesting and by shelves of bounding boxes, and seconds.
   Then how seconds grow with the number of parts, where there are so many that
   one order is tried: the power of the number that they are between two rows.
*/
:- use_module('../rules/sanggwan').
:- use_module('../rules/pattern/pattern_nest').
:- use_module('../rules/pattern/pattern_outline').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Words),
    (   Words == []
    ->  Sizes = [800,1600,3200,6400]
    ;   maplist(atom_number, Words, Sizes)
    ),
    format("~w~t~16|~w~t~8+~w~t~10+~w~t~8+~w~t~8+~w~t~8+~w~t~8+~w~n",
           [job,parts,area,sheets,used,shelves,used,seconds]),
    forall(job(Name, Paper, Gap, Outlines),
           reported(Name, Paper, Gap, Outlines)),
    format("~n~w~t~8+~w~t~8+~w~t~8+~w~t~10+~w~n",
           [parts,sheets,used,seconds,growth]),
    foldl(grown, Sizes, none, _).

%   grown(N, Before, Now): Before and Now are N-Seconds.

grown(N, Before, N-Seconds) :-
    set_random(seed(N)),
    parts(N, 60, 500, Parts),
    findall(A, ( member(_-Loops, Parts), part_area(Loops, A) ), As),
    sum_list(As, Area),
    statistics(cputime, T0),
    nested(Parts, room(2000,1000,5), nested(_,Places)),
    statistics(cputime, T1),
    Seconds is T1-T0,
    list_to_assoc(Parts, ByName),
    used(ByName, Places, 2000-1000, Sheets, UsedArea),
    Share is 100*Area/UsedArea,
    (   Before = N0-Seconds0
    ->  Power is log(Seconds/Seconds0)/log(N/N0),
        format(atom(Growth), "n^~2f", [Power])
    ;   Growth = ''
    ),
    format("~d~t~8+~d~t~8+~1f %~t~8+~2f~t~10+~w~n",
           [N,Sheets,Share,Seconds,Growth]).

reported(Name, W-H, Gap, Outlines) :-
    length(Outlines, Count),
    findall(A, ( member(_-Loops, Outlines), part_area(Loops, A) ), As),
    sum_list(As, Area),
    statistics(cputime, T0),
    nested(Outlines, room(W,H,Gap), nested(_,Places)),
    statistics(cputime, T1),
    Seconds is T1-T0,
    list_to_assoc(Outlines, ByName),
    used(ByName, Places, W-H, Sheets, UsedArea),
    Share is 100*Area/UsedArea,
    shelves(Outlines, W-H, Gap, Sheets2, UsedArea2),
    Share2 is 100*Area/UsedArea2,
    format("~w~t~16|~d~t~8+~2f~t~10+~d~t~8+~1f %~t~8+~d~t~8+~1f %~t~8+~2f~n",
           [Name,Count,Area/1.0e6,Sheets,Share,Sheets2,Share2,Seconds]).

part_area(Loops, Area) :-
    findall(A, ( member(Loop, Loops), loop_area(Loop, A) ), As),
    sum_list(As, Area).

%   used(ByName, Places, W-H, Sheets, Area): full sheets and the part of the
%   last one below its highest, or left of its farthest point, whichever is
%   less.

used(ByName, Places, W-H, Sheets, Area) :-
    findall(I, member(_-place(I,_,_,_), Places), Is),
    max_list(Is, Sheets),
    findall(X-Y,
            ( member(Name-place(Sheets,Degrees,DX,DY), Places),
              get_assoc(Name, ByName, Loops),
              member(Loop, Loops),
              member(X0-Y0, Loop),
              A is Degrees*pi/180,
              X is X0*cos(A)-Y0*sin(A)+DX,
              Y is X0*sin(A)+Y0*cos(A)+DY ),
            Points),
    findall(X, member(X-_, Points), Xs),
    findall(Y, member(_-Y, Points), Ys),
    max_list(Xs, Right),
    max_list(Ys, Top),
    Area is (Sheets-1)*W*H + min(Right*H, Top*W).

%   Bounding boxes, lying, on shelves, the highest first, each on the first
%   shelf with room.

shelves(Outlines, W-H, Gap, Sheets, Area) :-
    findall(Less-box(BW,BH),
            ( member(_-Loops, Outlines),
              append(Loops, Points),
              least_box(Points, _, BW, BH),
              Less is -BH ),
            Boxes0),
    keysort(Boxes0, Boxes1),
    findall(Box, member(_-Box, Boxes1), Boxes),
    foldl(shelved(W, H, Gap), Boxes, [], Shelves),
    last_sheet(Shelves, Sheets, Top),
    Area is ((Sheets-1)*H + Top)*W.

%   shelf(Sheet, Bottom, Height, Used), the newest first.

shelved(W, _, Gap, box(BW,BH), Shelves0, Shelves) :-
    append(Newer, [shelf(S,Bottom,Height,Used)|Older], Shelves0),
    Used+Gap+BW =< W,
    BH =< Height,
    \+ ( member(shelf(_,_,H2,U2), Older), U2+Gap+BW =< W, BH =< H2 ),
    !,
    Used1 is Used+Gap+BW,
    append(Newer, [shelf(S,Bottom,Height,Used1)|Older], Shelves).
shelved(_, H, Gap, box(BW,BH), Shelves, [shelf(S,Bottom,BH,BW)|Shelves]) :-
    (   Shelves = [shelf(S0,Bottom0,Height0,_)|_]
    ->  Top is Bottom0+Height0+Gap,
        (   Top+BH =< H
        ->  S = S0, Bottom = Top
        ;   S is S0+1, Bottom = 0
        )
    ;   S = 1,
        Bottom = 0
    ).

last_sheet([shelf(Sheet,Bottom,Height,_)|_], Sheet, Top) :-
    Top is Bottom+Height.

                /*******************************
                *            JOBS              *
                *******************************/

job(workshop_30, 2000-1000, 5, Parts) :-
    set_random(seed(30)),
    parts(30, 60, 500, Parts).
job(workshop_100, 2000-1000, 5, Parts) :-
    set_random(seed(100)),
    parts(100, 60, 500, Parts).
job(small_100, 2000-1000, 5, Parts) :-
    set_random(seed(7)),
    parts(100, 30, 150, Parts).
job(mixed_60, 2000-1000, 5, Parts) :-
    set_random(seed(60)),
    parts(10, 400, 900, Large),
    parts(50, 30, 200, Small0),
    findall((s-N)-L, member(N-L, Small0), Small),
    append(Large, Small, Parts).
job(triangles_40, 2000-1000, 5, Parts) :-
    set_random(seed(40)),
    findall(I-[Loop],
            ( between(1, 40, I), random(A0), random(B0), random(C0),
              A is 100+300*A0, B is 100+300*B0, C is A*C0,
              Loop = [0.0-0.0,A-0.0,C-B] ),
            Parts).
job(rings_and_discs, 2000-1000, 5, Parts) :-
    findall((ring-I)-[Outer,Inner],
            ( between(1, 12, I), R is 120+12*I,
              circle(R, 48, 1, Outer), R2 is 0.8*R, circle(R2, 48, -1, Inner) ),
            Rings),
    findall((disc-I)-[Loop],
            ( between(1, 24, I), R is 40+6*I, circle(R, 48, 1, Loop) ), Discs),
    append(Rings, Discs, Parts).
job(saddles_12, 2000-1000, 5, Parts) :-
    findall(I-[Loop],
            ( between(1, 12, I), R is 20+5*I, saddle(R, Loop) ), Parts).

parts(N, Least, Most, Parts) :-
    findall(I-Loops,
            ( between(1, N, I),
              random(U),
              Size is Least+(Most-Least)*U*U,
              Kind is I mod 8,
              part(Kind, Size, Loops) ),
            Parts).

part(0, S, [Loop]) :- R is S/2, circle(R, 40, 1, Loop).
part(1, S, [Outer,Inner]) :-
    R is S/2, circle(R, 40, 1, Outer), R2 is 0.7*R, circle(R2, 40, -1, Inner).
part(2, S, [[0.0-0.0,S-0.0,S-H,0.0-H]]) :-
    random(U), H is S*(0.2+0.8*U).
part(3, S, [[0.0-0.0,S-0.0,S-T,T-T,T-H,0.0-H]]) :-
    random(U), H is S*(0.5+0.5*U), T is 0.25*S.
part(4, S, [[0.0-0.0,S-0.0,0.0-H]]) :-
    random(U), H is S*(0.3+0.7*U).
part(5, S, [Loop]) :-
    findall(X-Y, ( between(0, 20, I), A is I*0.08, X is S*cos(A),
                   Y is S*sin(A) ), Arc),
    findall(X-Y, ( between(0, 20, J), I is 20-J, A is I*0.08,
                   X is 0.55*S*cos(A), Y is 0.55*S*sin(A) ), Back),
    append(Arc, Back, Loop).
part(6, S, [Loop]) :- R is S/6.3, saddle(R, Loop).
part(7, S, [[0.0-0.0,S-0.0,S-S,0.0-S],[A-A,A-B,B-B,B-A]]) :-
    A is 0.12*S, B is 0.88*S.

circle(R, N, Way, Loop) :-
    findall(X-Y, ( between(1, N, I), A is Way*2*pi*I/N, X is R*cos(A),
                   Y is R*sin(A) ), Loop).

saddle(R, Loop) :-
    findall(X-Y, ( between(0, 48, I), A is 2*pi*I/48, X is R*A,
                   Y is 0.8*R*(1-cos(2*A))/2 ), Low),
    W is 2*pi*R,
    H is 3*R,
    append(Low, [W-H,0.0-H], Loop).
