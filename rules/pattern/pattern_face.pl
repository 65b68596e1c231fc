:- module(sg_pattern_face,
          [ text_faces/2,               % +Wanted, -Faced
            face_point/2,               % +Face, +Point
            upright_way/3,              % +U0, +V0, -Way
            first_of/3                  % +N, +List, -First
          ]).
:- use_module('../near', [points_left/2, tolerance/2]).
:- use_module('../kernel', [shape_at/3, shape_map_open/3]).
:- use_module(library(apply), [foldl/4, foldl/5]).
:- use_module(library(lists), [last/2, member/2, sum_list/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Faces of a pattern, as texts look for room in them.

    face(Map, Middles, Way)

is made once of the shapes of a face, however many texts ask: Map says what is
in it, Middles are where a name may have its middle, and Way, U-V, is along its
longest side.
*/

:- set_prolog_flag(optimise, true).

%!  text_faces(+Wanted, -Faced) is det.
%
%   Faced are Wanted, of written/5 (pattern_text.pl), with faces for shapes.
%   Texts one after another that have the same shapes share one.

text_faces(Wanted, Faced) :-
    foldl(text_faced, Wanted, Faced, none, _).

text_faced(want(Role,D,Text,Heights,Place0), want(Role,D,Text,Heights,Place),
           Last0, Last) :-
    place_faced(Place0, Place, Last0, Last).

place_faced(first_of(Places0), Place, Last0, Last) =>
    Place = first_of(Places),
    foldl(place_faced, Places0, Places, Last0, Last).
place_faced(over_folds(Place0), Place1, Last0, Last) =>
    Place1 = over_folds(Place),
    place_faced(Place0, Place, Last0, Last).
place_faced(over_lines(Place0), Place1, Last0, Last) =>
    Place1 = over_lines(Place),
    place_faced(Place0, Place, Last0, Last).
place_faced(end_of(A,B,Shapes), Place, Last0, Last) =>
    Place = end_of(A,B,Face),
    shapes_face(Shapes, Face, Last0, Last).
place_faced(middle_of(Places,Shapes), Place, Last0, Last) =>
    Place = middle_of(Places,Face),
    shapes_face(Shapes, Face, Last0, Last).
place_faced(within(Shapes), Place, Last0, Last) =>
    Place = within(Face),
    shapes_face(Shapes, Face, Last0, Last).
place_faced(within_any(Shapes), Place, Last0, Last) =>
    Place = within_any(Face),
    shapes_face(Shapes, Face, Last0, Last).
place_faced(Place0, Place, Last0, Last) =>
    Place = Place0,
    Last = Last0.

shapes_face(Shapes, Face, Last0, Last) :-
    (   Last0 = Shapes0-Face0,
        Shapes0 == Shapes
    ->  Face = Face0,
        Last = Last0
    ;   tolerance(paper, Near),
        shape_map_open(Shapes, Near, Map),
        face_middles(Shapes, Middles),
        face_way(Shapes, Way),
        Face = face(Map, Middles, Way),
        Last = Shapes-Face
    ).

%!  face_point(+Face, +Point) is semidet.
%
%   True when Point, X-Y, lies in Face, or on its border, or as good as.

face_point(face(Map,_,_), Point) :-
    shape_at(Map, Point, _).

%   Where a name may have its middle: in the middle of the face, then in that of
%   its larger triangles.

face_middles(Shapes, Middles) :-
    findall(Less-(Area-Middle),
            ( member(Shape, Shapes),
              shape_middle(Shape, Area, Middle),
              Less is -Area
            ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Sized),
    foldl(weighed, Sized, w(0.0,0.0,0.0), w(X0,Y0,All)),
    first_of(6, Sized, Some),
    findall(M, member(_-M, Some), Own),
    (   All > 0
    ->  X is X0/All,
        Y is Y0/All,
        Middles = [X-Y|Own]
    ;   Middles = Own
    ).

weighed(Area-(X-Y), w(X0,Y0,A0), w(X1,Y1,A1)) :-
    X1 is X0+Area*X,
    Y1 is Y0+Area*Y,
    A1 is A0+Area.

shape_middle([XA-YA,XB-YB,XC-YC|More], Area, X-Y) :-
    Area is abs((XB-XA)*(YC-YA) - (XC-XA)*(YB-YA))/2,
    (   More == []
    ->  X is (XA+XB+XC)/3,
        Y is (YA+YB+YC)/3
    ;   findall(X1, member(X1-_, [XA-YA,XB-YB,XC-YC|More]), Xs),
        findall(Y1, member(_-Y1, [XA-YA,XB-YB,XC-YC|More]), Ys),
        length(Xs, N),
        sum_list(Xs, SumX),
        sum_list(Ys, SumY),
        X is SumX/N,
        Y is SumY/N
    ).

%   The direction of the longest side of its triangles, read from below or from
%   the right.

face_way(Shapes, Way) :-
    foldl(longest_side, Shapes, side(0.0,1.0,0.0), side(Square,DX,DY)),
    (   Square > 0.0
    ->  Length is sqrt(Square),
        U is DX/Length,
        V is DY/Length,
        upright_way(U, V, Way)
    ;   Way = 1.0-0.0
    ).

longest_side(Shape, Side0, Side) :-
    last(Shape, Last),
    longest_side(Shape, Last, Side0, Side).

%   longest_side(Points, Before, Side0, Side): of those that are as long as each
%   other, the last one.

longest_side([], _, Side, Side).
longest_side([XB-YB|Points], XA-YA, Side0, Side) :-
    DX is XB-XA,
    DY is YB-YA,
    Square is DX*DX+DY*DY,
    (   arg(1, Side0, Square0),
        Square < Square0
    ->  Side1 = Side0
    ;   Side1 = side(Square,DX,DY)
    ),
    longest_side(Points, XB-YB, Side1, Side).

%!  upright_way(+U0, +V0, -Way) is det.
%
%   Way, U-V, is U0, V0, turned round if it is not read from below or from the
%   right.

upright_way(U0, V0, U-V) :-
    (   points_left(U0, V0)
    ->  U is -U0,
        V is -V0
    ;   U is U0,
        V is V0
    ).

%!  first_of(+N, +List, -First:list) is det.
%
%   First are the first N of List, or all if it has no more.

first_of(N, List, First) :-
    (   N > 0,
        List = [X|Xs]
    ->  First = [X|Rest],
        N1 is N-1,
        first_of(N1, Xs, Rest)
    ;   First = []
    ).
