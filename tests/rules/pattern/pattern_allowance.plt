:- module(test_pattern_allowance, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/3]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(pattern/pattern_yield)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

/* Allowances of lap and lock seams, against closed forms of their areas. */

drawn(Term, Removed, Options, Drawings) :-
    new_world(World),
    in_world(World, ( add_primitive(Term, S), complete_segments,
                      develop(S, [removed(Removed)], D),
                      pattern_drawing([D], Options, Drawings) )).

grown(Term, Removed, Options, Grown) :-
    drawn(Term, Removed, [numbers(false)|Options], With),
    drawn(Term, Removed, [numbers(false)], Without),
    pattern_yield(With, Yield1),
    pattern_yield(Without, Yield0),
    Grown is Yield1.piece_area - Yield0.piece_area.

pipe(prism(outline([[0,0],[30,0],[30,20],[0,20]]), height(50))).

folds(Drawings, Role, N) :-
    findall(x,
            ( member(drawing(_,Views), Drawings),
              member(view(_,Strokes,_), Views),
              member(stroke(_,Role,_,_,_,_,_), Strokes) ),
            Xs),
    length(Xs, N).

:- dynamic told/1.

:- begin_tests(pattern_allowance).

% An open duct has one seam of 50: a strip of 8, or one and a half pockets
% twice.
test(lap, true(abs(Grown-8*50) < 0.1)) :-
    pipe(Pipe),
    grown(Pipe, [1,2], [lap(8)], Grown).
test(lock, true(abs(Grown-3*6*50) < 0.1)) :-
    pipe(Pipe),
    grown(Pipe, [1,2], [lock(6)], Grown).
test(none, Grown =:= 0.0) :-
    pipe(Pipe),
    grown(Pipe, [1,2], [lap(0)], Grown).
% A tray of 60 x 40 x 30 without its top has four seams of 30, in corners:
% strips of 9 on both sides that meet at 45 degrees.
test(tray, true(abs(Grown-8*(30*9-9*9/2)) < 0.1)) :-
    grown(box(size(60,40,30)), [2], [lock(6)], Grown).
% One edge is folded up, the other down; the seams of the tray bend down too.
test(folds, Up-Down == 4-16) :-
    drawn(box(size(60,40,30)), [2], [lock(6)], Drawings),
    folds(Drawings, fold_up, Up),
    folds(Drawings, fold_down, Down).
% Of a seam too short for two notches.
test(no_room, Told == [lock]) :-
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(pattern(What)), _, _) :-
                     What = without_tab(_,4,_,_,Seam,_),
                     assertz(test_pattern_allowance:told(Seam))), Ref),
        drawn(box(size(60,40,8)), [2], [lock(40)], _),
        erase(Ref)),
    findall(Seam, retract(test_pattern_allowance:told(Seam)), Told).

:- end_tests(pattern_allowance).
