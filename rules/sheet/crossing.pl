:- module(sg_crossing,
          [ strokes_crossed/2           % +Strokess, -Strokes
          ]).
:- use_module('../kernel', [stroke_crossings/2]).
:- use_module(stroke, [all_strokes/2]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Where dashed lines cross.

Hidden lines meet in dashes where they cross, as ISO 128 wants it. So a stroke
that others cross knows where: its End is crossed(End0, Marks, Length), Marks
being how far from its start along it, Length how long it is; dash.pl fits its
dashes to that.
*/

:- set_prolog_flag(optimise, true).

%   More pieces than that stay as they are: who would look at each crossing?

most_pieces(3000).

%!  strokes_crossed(+Strokess, -Strokes) is det.
%
%   Strokes are Strokess (stroke.pl), in order, with marks where one crosses
%   another one, or itself, or ends on it (stroke_crossings/2), and one by one.
%   If nothing crosses, and if they have more than 3,000 pieces, all stay as
%   they are.

strokes_crossed(Strokess, Strokes) :-
    most_pieces(Most),
    (   few_strokes(Strokess, Most),
        all_strokes(Strokess, Strokes0),
        few_pieces(Strokes0, Most),
        stroke_crossings(Strokes0, Marks),
        Marks = [_|_]
    ->  group_pairs_by_key(Marks, Groups),
        marked(Strokes0, 1, Groups, Strokes)
    ;   Strokes = Strokess
    ).

%   few_strokes(Strokess, Left), few_pieces(Strokes, Left): there may be
%   millions.

few_strokes([], _).
few_strokes([Strokes|Strokess], Left0) :-
    (   Strokes = strokes(_, _, _, _, From, To)
    ->  Left is Left0 - (To-From+1)
    ;   Left is Left0 - 1
    ),
    Left >= 0,
    few_strokes(Strokess, Left).

few_pieces([], _).
few_pieces([stroke(_,_,_,_,Points,_,_)|Strokes], Left0) :-
    length(Points, N),
    Left is Left0 + 1 - N,
    Left >= 0,
    few_pieces(Strokes, Left).

%   marked(Strokes0, K, Groups, Strokes): of each stroke from the K-th on.

marked([], _, _, []).
marked([Stroke0|Strokes0], K, Groups0, [Stroke|Strokes]) :-
    (   Groups0 = [K-Marks|Groups]
    ->  stroke_marked(Stroke0, Marks, Stroke)
    ;   Groups = Groups0,
        Stroke = Stroke0
    ),
    K1 is K+1,
    marked(Strokes0, K1, Groups, Strokes).

stroke_marked(stroke(V,Role,S,Es,[P|Points],Start,End), Marks,
              stroke(V,Role,S,Es,[P|Points],Start,crossed(End,Marks,Length))) :-
    foldl(farther, Points, P-0.0, _-Length).

farther(X2-Y2, (X1-Y1)-Far0, (X2-Y2)-Far) :-
    Far is Far0 + sqrt((X2-X1)**2 + (Y2-Y1)**2).
