:- module(sg_test_grown,
          [ grown/4,                    % ?Family, +N, -Shells, -Volume
            shells_solid/3,             % +Shells, -Points, -Faces
            grown_file/4                % +Family, +N, +File, -Volume
          ]).
/** <module> Families of solids in which what meets grows with their size.

Of each family there is a solid for every N, in which about N shells meet in one
vertex, along one edge or everywhere, or come near each other along all of
their length. A shell is shell(Points, Faces) as write_off/3 has them; vertices
of different shells are different, also where they are in one place.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(tests('rules/checked'), [write_off/3]).

%!  grown(?Family, +N, -Shells, -Volume) is nondet.
%
%   Volume is that of the union of Shells.

%   N wedges on one edge: between them as much is free.

grown(wedges, N, Shells, Volume) :-
    findall(Shell,
            ( between(1, N, I),
              A is 2*pi*I/N,
              B is A+pi/N,
              maplist(on_circle, [A,B], [P,Q]),
              prism([0.0-0.0,P,Q], 0.0, 1.0, Shell) ),
            Shells),
    Volume is N*sin(pi/N)/2.
%   The same box N times.
grown(identical, N, Shells, 1) :-
    length(Shells, N),
    prism([0.0-0.0,1.0-0.0,1.0-1.0,0.0-1.0], 0.0, 1.0, Shell),
    maplist(=(Shell), Shells).
%   N pyramids on one square, each in the next one.
grown(base, N, Shells, Volume) :-
    findall(Shell,
            ( between(1, N, I),
              Height is 1+0.01*I,
              cone([1.0-0.0,0.0-1.0,-1.0-0.0,0.0-(-1.0)], -1.0,
                   shell([_|Points], Faces)),
              Shell = shell([p(0.0,0.0,Height)|Points], Faces) ),
            Shells),
    Volume is 2*(2+0.01*N)/3.
%   Two pyramids on N corners each, with their apexes in one place.
grown(apexes, N, [Up,Down], Volume) :-
    findall(P, ( between(1, N, I), A is 2*pi*I/N, on_circle(A, P) ), Base),
    cone(Base, 1.0, Up),
    cone(Base, -1.0, Down),
    Volume is N*sin(2*pi/N)/3.
%   N parallel needles, along the diagonal of their boxes.
grown(needles, N, Shells, Volume) :-
    Across is ceiling(sqrt(N)),
    findall(Shell,
            ( between(1, N, I),
              X is (I mod Across)*0.015625,
              Y is (I//Across)*0.015625,
              needle(X, Y, 0.00390625, Shell) ),
            Shells),
    Volume is N*0.00390625**2*10/6.
%   N boxes on each other.
grown(stack, N, Shells, N) :-
    findall(Shell,
            ( between(1, N, I),
              Low is float(I), High is Low+1,
              prism([0.0-0.0,1.0-0.0,1.0-1.0,0.0-1.0], Low, High, Shell) ),
            Shells).
%   N boxes apart from each other.
grown(apart, N, Shells, N) :-
    Across is ceiling(N**(1/3)),
    findall(Shell,
            ( between(1, N, I),
              X is 2.0*(I mod Across), X1 is X+1,
              Y is 2.0*(I//Across mod Across), Y1 is Y+1,
              Z is 2.0*(I//(Across*Across)), Z1 is Z+1,
              prism([X-Y,X1-Y,X1-Y1,X-Y1], Z, Z1, Shell) ),
            Shells).
%   N boxes in a row.
grown(row, N, Shells, N) :-
    findall(Shell,
            ( between(1, N, I),
              X is 2.0*I, X1 is X+1,
              prism([X-0.0,X1-0.0,X1-1.0,X-1.0], 0.0, 1.0, Shell) ),
            Shells).
%   A comb of N teeth, one face with a corner for each.
grown(comb, N, [Shell], Volume) :-
    Last is 2.0*N+1,
    numlist(1, N, Is0),
    reverse(Is0, Is),
    foldl(tooth, Is, Corners, []),
    prism([1.0-(-1.0),Last-(-1.0),Last-0.0|Corners], 0.0, 1.0, Shell),
    Volume is 3.0*N.

%   A ball of about N triangles.
grown(ball, N, [shell([p(0.0,0.0,1.0),p(0.0,0.0,-1.0)|Points],Faces)],
      Volume) :-
    Bands is max(2, round(sqrt(N/4))),
    Round is 2*Bands,
    Last is Bands-1,
    findall(p(X,Y,Z),
            ( between(1, Last, I), between(1, Round, J),
              A is pi*I/Bands, B is 2*pi*J/Round,
              X is sin(A)*cos(B), Y is sin(A)*sin(B), Z is cos(A) ),
            Points),
    findall(Face, ball_face(Bands, Round, Face), Faces),
    findall(V, ball_volume(Bands, Round, V), Vs),
    sum_list(Vs, Volume).
%   N boxes along a diagonal, each over a quarter of the one before it, with
%   their floors in one plane.
grown(overlap, N, Shells, Volume) :-
    findall(Shell,
            ( between(1, N, I),
              A is 0.5*I, B is A+1,
              prism([A-A,B-A,B-B,A-B], 0.0, 1.0, Shell) ),
            Shells),
    Volume is N-0.25*(N-1).
%   N boxes, each in the one before it: every second is a hollow.
grown(nested, N, Shells, Volume) :-
    findall(Shell,
            ( between(1, N, I),
              A is float(N-I+1),
              B is -A,
              prism([B-B,A-B,A-A,B-A], B, A, shell(Ps, Fs0)),
              (   I mod 2 =:= 1
              ->  Fs = Fs0
              ;   maplist(reverse, Fs0, Fs)
              ),
              Shell = shell(Ps, Fs) ),
            Shells),
    findall(V,
            ( between(1, N, I), V is (2*I)**3*(-1)**(N-I) ),
            Vs),
    sum_list(Vs, Volume).
%   N rings on twelve corners in each other, apart.
grown(rings, N, Shells, Volume) :-
    findall(Shell, ( between(1, N, I), ring(I, I+0.5, Shell) ), Shells),
    findall(V,
            ( between(1, N, I), V is 6*sin(pi/6)*((I+0.5)**2-I**2) ),
            Vs),
    sum_list(Vs, Volume).
%   A sheet with N folds, as thick as they are high.
grown(folds, N, [Shell], Volume) :-
    numlist(0, N, Is),
    findall(X-Y, ( member(I, Is), X is float(I), Y is float(I mod 2) ), Low),
    reverse(Is, Back),
    findall(X-Y, ( member(I, Back), X is float(I), Y is I mod 2+1.0 ), High),
    append(Low, High, Outline),
    prism(Outline, 0.0, 1.0, Shell),
    Volume is float(N).

%   Vertices 1 and 2 are the poles.

ball_face(_, Round, [1,A,B]) :-
    ball_ring(Round, 1, _, A, B).
ball_face(Bands, Round, [2,B,A]) :-
    Last is Bands-1,
    ball_ring(Round, Last, _, A, B).
ball_face(Bands, Round, Face) :-
    Last is Bands-2,
    between(1, Last, I),
    I1 is I+1,
    ball_ring(Round, I, J, A, B),
    ball_ring(Round, I1, J, C, D),
    member(Face, [[A,C,D],[A,D,B]]).

ball_ring(Round, I, J, A, B) :-
    between(1, Round, J),
    A is 2+(I-1)*Round+J,
    B is 2+(I-1)*Round+J mod Round+1.

%   Of the pyramids from the middle to the rings: frusta between circles of
%   Round corners.

ball_volume(Bands, Round, V) :-
    between(1, Bands, I),
    A is pi*(I-1)/Bands,
    B is pi*I/Bands,
    Area is Round/2*sin(2*pi/Round),
    V is Area/3*(cos(A)-cos(B))*(sin(A)**2+sin(A)*sin(B)+sin(B)**2).

%   ring(Inner, Outer, Shell): twelve corners, one high.

ring(Inner, Outer, shell(Points, Faces)) :-
    findall(p(X,Y,Z),
            ( member(Z, [0.0,1.0]), member(R, [Inner,Outer]),
              between(0, 11, J),
              A is pi*J/6, X is R*cos(A), Y is R*sin(A) ),
            Points),
    findall(Face, ( between(0, 11, J), ring_face(J, Face) ), Faces).

%   Vertices are those of the floor, inside, then outside, and of the roof.

ring_face(J, Face) :-
    A is J+1, B is (J+1) mod 12+1,
    C is A+12, D is B+12,
    maplist(plus(24), [A,B,C,D], [A1,B1,C1,D1]),
    member(Face, [[A,B,D,C],[A1,C1,D1,B1],[C,D,D1,C1],[B,A,A1,B1]]).

tooth(I, [B-0.0,B-1.0,A-1.0,A-0.0|Corners], Rest) :-
    A is 2.0*I-0.5,
    B is 2.0*I+0.5,
    (   I =:= 1
    ->  Corners = [1.0-0.0|Rest]
    ;   Corners = Rest
    ).

on_circle(A, X-Y) :-
    X is cos(A),
    Y is sin(A).

%   prism(Outline, Low, High, Shell): Outline is counter-clockwise from above.

prism(Outline, Low, High, shell(Points, [Floor,Roof|Sides])) :-
    findall(p(X,Y,Low), member(X-Y, Outline), Lows),
    findall(p(X,Y,High), member(X-Y, Outline), Highs),
    append(Lows, Highs, Points),
    length(Outline, N),
    Last is 2*N,
    First is N+1,
    numlist(First, Last, Roof),
    numlist(1, N, Floor0),
    reverse(Floor0, Floor),
    findall([A,B,C,D],
            ( between(1, N, A), B is A mod N+1, C is B+N, D is A+N ),
            Sides).

%   cone(Base, Height, Shell): the apex is in the origin.

cone(Base, Z, shell([p(0.0,0.0,0.0)|Points], [End|Sides])) :-
    findall(p(X,Y,Z), member(X-Y, Base), Points),
    length(Base, N),
    Last is N+1,
    numlist(2, Last, Around),
    (   Z > 0
    ->  End = Around,
        findall([1,B,A], ( between(2, Last, A), B is (A-1) mod N+2 ), Sides)
    ;   reverse(Around, End),
        findall([1,A,B], ( between(2, Last, A), B is (A-1) mod N+2 ), Sides)
    ).

needle(X, Y, W, shell([p(X,Y,0.0),p(X1,Y,0.0),p(X,Y1,0.0),p(X2,Y2,10.0)],
                      [[1,3,2],[1,2,4],[2,3,4],[3,1,4]])) :-
    X1 is X+W,
    Y1 is Y+W,
    X2 is X+10,
    Y2 is Y+10.

%!  shells_solid(+Shells, -Points, -Faces) is det.
%
%   All shells as one mesh.

shells_solid(Shells, Points, Faces) :-
    findall(Ps, member(shell(Ps, _), Shells), Lists),
    append(Lists, Points),
    foldl(shell_faces, Shells, 0-Faces, _-[]).

shell_faces(shell(Points, Faces0), From-Faces, To-Rest) :-
    length(Points, N),
    To is From+N,
    maplist(maplist(plus(From)), Faces0, Faces1),
    append(Faces1, Rest, Faces).

%!  grown_file(+Family, +N, +File, -Volume) is det.
%
%   Write the solid of N to File, an OFF file.

grown_file(Family, N, File, Volume) :-
    once(grown(Family, N, Shells, Volume)),
    shells_solid(Shells, Points, Faces),
    write_off(File, Points, Faces).
