:- module(test_dash, []).
:- use_module(library(plunit)).
:- use_module(rules(dash)).
:- use_module(rules(stroke)).

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
    stroke_dashes(Stroke, Dashes).
test(three, true(Dashes == [ [0-0,3000-0], [3900-0,6900-0],
                             [7800-0,10800-0] ])) :-
    hidden([0-0,10800-0], joint, joint, Stroke),
    stroke_dashes(Stroke, Dashes).
test(gap_where_it_goes_on, true(Dashes == [ [900-0,3900-0],
                                            [4800-0,7800-0] ])) :-
    hidden([0-0,8700-0], cut, cut, Stroke),
    stroke_dashes(Stroke, Dashes).
test(round_a_joint, true(Dashes == [ [0-0,2000-0,2000-1000],
                                     [2000-1900,2000-4900] ])) :-
    hidden([0-0,2000-0,2000-4900], joint, joint, Stroke),
    stroke_dashes(Stroke, Dashes).
test(many_small_pieces, true(N == 3)) :-
    findall(X-0, ( between(0, 108, I), X is 100*I ), Points),
    hidden(Points, joint, joint, Stroke),
    stroke_dashes(Stroke, Dashes),
    length(Dashes, N).
test(ring, true((Dash =:= 3000, Gap =:= 900))) :-
    hidden([0-0,7800-0,0-0], ring, ring, Stroke),
    stroke_dash(Stroke, Dash, Gap).
test(random, [forall(between(1, 100, Seed)), true]) :-
    random_stroke(Seed, Stroke),
    Stroke = stroke(_, _, _, _, Points, Start, End),
    Points = [First|_],
    last(Points, Last),
    stroke_dash(Stroke, Dash, Gap),
    stroke_dashes(Stroke, Dashes),
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

:- end_tests(dash).
