:- module(test_dash, []).
:- use_module(library(plunit)).
:- use_module(rules(sheet/dash)).
:- use_module(rules(sheet/stroke)).
:- use_module(tests('rules/sample')).

hidden(Points, Start, End, stroke(hidden,outline,1,[],Points,Start,End)).

line_length(Points, Length) :-
    hidden(Points, joint, joint, Stroke),
    stroke_length(Stroke, Length).

% N points, one near the next.
random_points(0, _, []) :-
    !.
random_points(N, X0-Y0, [X-Y|Points]) :-
    random_between(-3000, 3000, DX),
    random_between(1, 3000, DY),
    X is X0+DX,
    Y is Y0+DY,
    N1 is N-1,
    random_points(N1, X-Y, Points).

random_stroke(Seed, Stroke) :-
    set_random(seed(Seed)),
    random_between(2, 30, N),
    random_points(N, 0-0, Points),
    random_member(Start, [joint,cut]),
    random_member(End, [joint,cut]),
    hidden(Points, Start, End, Stroke).

near(A, B, Most) :-
    abs(A-B) =< Most.

:- begin_tests(dash).

test(one_short, true(Dashes == [[0-0,100-0]])) :-
    hidden([0-0,100-0], joint, joint, Stroke),
    stroke_dashes(Stroke, [3000,900], Dashes).
test(three, true(Dashes == [ [0-0,3000-0], [3900-0,6900-0],
                             [7800-0,10800-0] ])) :-
    hidden([0-0,10800-0], joint, joint, Stroke),
    stroke_dashes(Stroke, [3000,900], Dashes).
test(gap_where_it_goes_on, true(Dashes == [ [900-0,3900-0],
                                            [4800-0,7800-0] ])) :-
    hidden([0-0,8700-0], cut, cut, Stroke),
    stroke_dashes(Stroke, [3000,900], Dashes).
test(round_a_joint, true(Dashes == [ [0-0,2000-0,2000-1000],
                                     [2000-1900,2000-4900] ])) :-
    hidden([0-0,2000-0,2000-4900], joint, joint, Stroke),
    stroke_dashes(Stroke, [3000,900], Dashes).
test(many_small_pieces, true(N == 3)) :-
    findall(X-0, ( between(0, 108, I), X is 100*I ), Points),
    hidden(Points, joint, joint, Stroke),
    stroke_dashes(Stroke, [3000,900], Dashes),
    length(Dashes, N).
test(ring, true((Dash =:= 3000, Gap =:= 900))) :-
    hidden([0-0,7800-0,0-0], ring, ring, Stroke),
    stroke_runs(Stroke, [3000,900], [Dash,Gap], _).
test(random, [forall(numbered(40, 100, Seed)), true]) :-
    random_stroke(Seed, Stroke),
    Stroke = stroke(_, _, _, _, Points, Start, End),
    Points = [First|_],
    last(Points, Last),
    stroke_runs(Stroke, [3000,900], [Dash,Gap], _),
    stroke_dashes(Stroke, [3000,900], Dashes),
    Dashes = [[From|_]|_],
    last(Dashes, LastDash),
    last(LastDash, To),
    ( Start == joint -> From == First ; From \== First ),
    ( End == joint -> To == Last ; To \== Last ),
    length(Dashes, N),
    maplist(line_length, Dashes, Lengths),
    sum_list(Lengths, Sum),
    near(Sum, N*Dash, 3*N),
    stroke_length(Stroke, Length),
    ( Start-End == joint-joint -> Gaps is N-1
    ; Start-End == cut-cut -> Gaps is N+1
    ; Gaps = N
    ),
    near(Length, N*Dash+Gaps*Gap, 2*N).

% A chain of long dashes and dots: a long dash at both ends, dots between.
test(chain, true(Dashes == [ [0-0,6000-0], [6750-0,7250-0],
                             [8000-0,14000-0] ])) :-
    hidden([0-0,14000-0], joint, joint, Stroke),
    stroke_dashes(Stroke, [6000,750,500,750], Dashes).
test(chain_cut, true(Fitted-Offset == [6000,750,500,750]-7250)) :-
    hidden([0-0,14750-0], cut, joint, Stroke),
    stroke_runs(Stroke, [6000,750,500,750], Fitted, Offset).
test(offset, [forall(member(Start-Offset, [joint-0, cut-3000, ring-0])),
              true(Found == Offset)]) :-
    ( Start == ring -> Length = 7800 ; Start == cut -> Length = 7800
    ; Length = 6900
    ),
    hidden([0-0,Length-0], Start, joint, Stroke),
    stroke_runs(Stroke, [3000,900], _, Found).

:- end_tests(dash).
