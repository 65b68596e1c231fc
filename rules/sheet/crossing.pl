:- module(sg_crossing,
          [ strokes_crossed/2           % +Strokes0, -Strokes
          ]).
:- use_module('../kernel', [stroke_crossings/2]).
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

%!  strokes_crossed(+Strokes0, -Strokes) is det.
%
%   Strokes are Strokes0 (stroke.pl), in order, with marks where one crosses
%   another one, or itself, or ends on it (stroke_crossings/2). Those that
%   nothing crosses, and all of more than 3,000 pieces, stay as they are.

strokes_crossed(Strokes0, Strokes) :-
    most_pieces(Most),
    (   few_pieces(Strokes0, Most),
        stroke_crossings(Strokes0, Marks),
        Marks = [_|_]
    ->  group_pairs_by_key(Marks, Groups),
        marked(Strokes0, 1, Groups, Strokes)
    ;   Strokes = Strokes0
    ).

%   few_pieces(Strokes, Left): nothing is copied, for there may be millions.

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
