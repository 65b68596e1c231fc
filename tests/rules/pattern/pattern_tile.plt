:- module(test_pattern_tile, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(pattern/pattern_tile)).

% A sheet of 500 x 400 mm on A4: 190 x 268 mm are free, pages overlap by 10: at
% 0, 180 and 360 from the left, 0 and 258 from above.
tiles(Strokes, Pages) :-
    tiled([page('A4')],
          drawing(sheet(500000,400000,1),[view(piece,Strokes,[])]), [], Pages).

line(Points, stroke(visible,cut,2,[],Points,joint,joint)).

place('page-A1', 0-0).
place('page-B1', 180000-0).
place('page-C1', 360000-0).
place('page-A2', 0-258000).
place('page-B2', 180000-258000).
place('page-C2', 360000-258000).

% Parts of lines, where they are on the sheet.
part(Pages, Name, P, Q) :-
    member(drawing(_,Views), Pages),
    member(view(Name,_,_), Views),
    place(Name, Left-Top),
    member(view(piece,Strokes,_), Views),
    member(stroke(_,_,_,_,Points,_,_), Strokes),
    append(_, [XA-YA,XB-YB|_], Points),
    maplist(moved(Left-Top), [XA-YA,XB-YB], [P,Q]).

moved(Left-Top, X0-Y0, X-Y) :-
    X is X0-10000+Left,
    Y is Y0-10000+Top.

:- begin_tests(pattern_tile).

test(whole, [ Parts == ['page-A1'-(50000-60000)-(70000-80000)] ]) :-
    line([50000-60000,70000-80000], Line),
    tiles([Line], Pages),
    findall(Name-P-Q, part(Pages, Name, P, Q), Parts).
% In the overlap on both.
test(twice, [ Names == ['page-A1','page-B1'] ]) :-
    line([183000-60000,187000-80000], Line),
    tiles([Line], Pages),
    findall(Name, part(Pages, Name, _, _), Names).
test(level, [ Parts == [ 'page-A1'-(20000-100000)-(190000-100000),
                         'page-B1'-(180000-100000)-(370000-100000),
                         'page-C1'-(360000-100000)-(480000-100000) ] ]) :-
    line([20000-100000,480000-100000], Line),
    tiles([Line], Pages),
    findall(Name-P-Q, part(Pages, Name, P, Q), Parts).
test(up, [ Parts == [ 'page-A1'-(20000-268000)-(20000-10000),
                      'page-A2'-(20000-390000)-(20000-258000) ] ]) :-
    line([20000-390000,20000-10000], Line),
    tiles([Line], Pages),
    findall(Name-P-Q, part(Pages, Name, P, Q), Parts).
% Askew, from and to any side: each part lies on the line, within its page, and
% together they are all of it.
test(askew, [ forall(member(A-B, [ (10000-20000)-(490000-380000),
                                   (490000-30000)-(15000-395000),
                                   (250000-390000)-(260000-5000) ])) ]) :-
    line([A,B], Line),
    tiles([Line], Pages),
    findall(From-To,
            ( part(Pages, Name, P, Q),
              assertion(on_page(Name, P)),
              assertion(on_page(Name, Q)),
              share(A, B, P, From),
              share(A, B, Q, To)
            ),
            Parts0),
    assertion(forall(member(From-To, Parts0), From < To)),
    msort(Parts0, Parts),
    assertion(all_of(Parts, 0.0)).
% A line with a corner beyond the page comes back on it.
test(out_and_in, [ N == 2 ]) :-
    line([100000-100000,250000-110000,100000-120000], Line),
    tiles([Line], Pages),
    findall(x, part(Pages, 'page-A1', _, _), Xs),
    length(Xs, N).
test(empty_pages_are_left_out, [ Names == ['page-C2'] ]) :-
    line([400000-300000,410000-310000], Line),
    tiles([Line], Pages),
    findall(Name, ( member(drawing(_,Views), Pages),
                    member(view(Name,_,_), Views), place(Name, _) ), Names).
% Marks are in one place of the sheet on all pages that have them.
test(marks, [ true(Marks \== []) ]) :-
    line([10000-10000,490000-390000], Line),
    line([490000-10000,10000-390000], Other),
    tiles([Line,Other], Pages),
    findall(X-Y, cross(Pages, 'page-A1', X-Y), Marks),
    findall(X-Y, ( place(Name, _), Name \== 'page-A1',
                   cross(Pages, Name, X-Y) ), Others),
    % those in the overlap with B1 or A2
    forall(( member(X-Y, Marks), ( X > 180000, Y < 258000 ; Y > 258000 ) ),
           assertion(memberchk(X-Y, Others))).

:- end_tests(pattern_tile).

on_page(Name, X-Y) :-
    place(Name, Left-Top),
    X >= Left, X =< Left+190000,
    Y >= Top, Y =< Top+268000.

% How far along from A to B a point is; it lies on that line.
share(XA-YA, XB-YB, X-Y, Share) :-
    DX is XB-XA,
    DY is YB-YA,
    Share is ((X-XA)*DX + (Y-YA)*DY)/float(DX*DX + DY*DY),
    assertion(abs((X-XA)*DY - (Y-YA)*DX) =< 2*sqrt(DX*DX + DY*DY)).

all_of([], At) :-
    At > 1-1.0e-5.
all_of([From-To|Parts], At) :-
    From =< At+1.0e-5,
    At1 is max(At, To),
    all_of(Parts, At1).

% The middles of the crosses of a page, on the sheet.
cross(Pages, Name, X-Y) :-
    member(drawing(_,Views), Pages),
    member(view(Name,Strokes,_), Views),
    place(Name, Left-Top),
    member(stroke(_,crop,_,_,[X1-Y1,X2-Y1],_,_), Strokes),
    6000 =:= abs(X2-X1),
    X0 is (X1+X2)//2,
    moved(Left-Top, X0-Y1, X-Y).
