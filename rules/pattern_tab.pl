:- module(sg_pattern_tab,
          [ tabs/4,                     % +Width, +Pieces, -Tabs, -Butt
            tab_shape/4                 % +Width, +Length, -Shape, -Area
          ]).
:- use_module(kernel, [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module(decision, [decision/2, default/1]).
:- autoload(library(apply), [foldl/4, maplist/2, maplist/3]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(lists), [last/2, member/2]).
:- autoload(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> Tabs: what the two sides of a seam are glued with.

One side of a seam gets a tab, a trapezoid that stands on it. Of both sides and
of the forms of tab_shape/4 the largest is taken that lies on no face and on no
other tab of its piece; where none is, the seam is a butt joint.
*/

:- set_prolog_flag(optimise, true).

% How deep a tab may lie in a face, in millimetres: far below what a knife can
% do, far above what numbers are rounded by.
touching(1.0e-6).

%!  tabs(+Width, +Pieces, -Tabs, -Butt) is det.
%
%   Tabs are tab(D,E,A,B)-Points: on side E from vertex A to vertex B, at most
%   Width deep; Points are its corners in the order of the outline. Butt lists
%   the seams D-J that have none.

tabs(Width, Pieces, Tabs, Butt) :-
    maplist(piece_shapes(Width), Pieces, Named),
    list_to_assoc(Named, Shapes),
    findall(Seam-(Name-Side), seam_side(Pieces, Seam, Name, Side), Sides0),
    keysort(Sides0, Sides),
    group_pairs_by_key(Sides, Seams0),
    maplist(seam_rank, Seams0, Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Seams),
    foldl(seam_tab(Width, Shapes), Seams, Tabs-Butt, []-[]).

seam_side(Pieces, D-J, Name, Side) :-
    member(piece(Name,_,Sides), Pieces),
    Name = name(D, _, _),
    member(Side, Sides),
    Side = side(_, _, _, _, seam(J,_,_)).

%   Long seams choose first, for they hold the most.

seam_rank(Seam-Sides, Rank-(Seam-Sides)) :-
    Sides = [_-Side|_],
    side_length(Side, Length),
    Rank is -round(Length*1000).

side_length(side(_,_,_-(XA-YA),_-(XB-YB),_), Length) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2).

piece_shapes(Width, piece(Name,Faces,_), Name-Shapes) :-
    Cell is max(Width, 0.1),
    findall(Shape,
            ( member(face(_,Corners), Faces), member(Shape, Corners) ),
            Solid),
    shapes_cell(Solid, Cell, Side),
    shapes_open(Side, Shapes),
    forall(member(Corners, Solid),
           ( maplist(corner_point, Corners, Points),
             shapes_add(Shapes, Points)
           )).

corner_point(_-Point, Point).

%   About as large as a face, so that none is in too many cells.

shapes_cell(Solid, Least, Cell) :-
    foldl(wider, Solid, 0-0.0, N-Sum),
    Cell is max(Least, Sum/max(1, N)).

wider([_-(XA-YA),_-(XB-YB)|_], N0-Sum0, N-Sum) :-
    N is N0+1,
    Sum is Sum0 + max(abs(XB-XA), abs(YB-YA)).

seam_tab(Width, Shapes, (D-J)-Sides, Tabs0-Butt0, Tabs-Butt) :-
    (   best_tab(Width, Shapes, Sides, Name, Side, Points)
    ->  get_assoc(Name, Shapes, Own),
        shapes_add(Own, Points),
        Side = side(E, _, A-_, B-_, _),
        Tabs0 = [tab(D,E,A,B)-Points|Tabs],
        Butt0 = Butt
    ;   Tabs0 = Tabs,
        Butt0 = [D-J|Butt]
    ).

%   The largest form that is free; on the first side if on both.

best_tab(Width, Shapes, [Name1-Side1|Sides], Name, Side, Points) :-
    side_length(Side1, Length),
    findall(Less-Shape,
            ( tab_shape(Width, Length, Shape, Area), Less is -Area ),
            Forms0),
    keysort(Forms0, Forms),
    member(_-Shape, Forms),
    member(Name-Side, [Name1-Side1|Sides]),
    room_shape(Shape, Room),
    tab_points(Side, Room, Needed),
    get_assoc(Name, Shapes, Own),
    touching(Tolerance),
    shapes_free(Own, Needed, Tolerance),
    !,
    tab_points(Side, Shape, Points).

%   A tab needs a little more room than it takes: a knife has to go between it
%   and what is beside it, and its line is to be no one else's.

room_shape(tab(In1,Run1,In2,Run2,Deep), tab(In1,More1,In2,More2,More)) :-
    More1 is 0.85*Run1,
    More2 is 0.85*Run2,
    More is 1.05*Deep.

%   tab_points(Side, tab(In1,Run1,In2,Run2,Deep), Points): in the order of the
%   outline; the face is on the left of Side, the tab on its right.

tab_points(side(_,_,_-A,_-B,_), tab(In1,Run1,In2,Run2,Deep), Points) :-
    A = XA-YA,
    B = XB-YB,
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    Low is In1+Run1,
    High is Length-In2-Run2,
    Base is Length-In2,
    maplist(tab_point(A, U, V), [In1-0.0,Low-Deep,High-Deep,Base-0.0],
            Points0),
    ends_kept(In1, In2, A, B, Points0, Points).

%   The ends of the seam itself are copied, not computed.

ends_kept(In1, In2, A, B, [P1,P2,P3,P4], [Q1,P2,P3,Q4]) :-
    (   In1 =:= 0
    ->  Q1 = A
    ;   Q1 = P1
    ),
    (   In2 =:= 0
    ->  Q4 = B
    ;   Q4 = P4
    ).

tab_point(X0-Y0, U, V, Along-Deep, X-Y) :-
    X is X0 + Along*U + Deep*V,
    Y is Y0 + Along*V - Deep*U.

:- decision(tab_shape/4, "The forms that a tab may have").

%!  tab_shape(+Width, +Length, -Shape, -Area) is nondet.
%
%   True when a seam of Length may have a tab of this Shape, at most Width deep:
%   tab(In1,Run1,In2,Run2,Deep) begins In1 from the start of the seam and ends
%   In2 from its end, is Deep, and its upper corners stand Run1 and Run2 farther
%   in. The largest that has room is taken. A decision.

tab_shape(Width, Length, tab(In1,Run1,In2,Run2,Deep), Area) :-
    member(Part, [1.0,0.75,0.55,0.4,0.25]),
    Deep is min(Width, 0.45*Length)*Part,
    Deep >= min(1.0, Width/3),          % what can still be glued
    member(Slope1-Slope2, [ 1-1, 1.8-1.8, 3.5-3.5, 1-3.5, 3.5-1,
                            1-7, 7-1 ]),
    Run1 is Deep*Slope1,
    Run2 is Deep*Slope2,
    member(In-Out, [0-0, 0.15-0, 0-0.15, 0.15-0.15, 0.4-0, 0-0.4, 0.3-0.3]),
    In1 is In*Length,
    In2 is Out*Length,
    Base is Length-In1-In2,
    Top is Base-Run1-Run2,
    Top >= 0.1*Length,
    Area is (Base+Top)/2*Deep.
