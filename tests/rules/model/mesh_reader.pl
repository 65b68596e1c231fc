:- module(mesh_reader,
          [ read_faces/3,               % +Format, +Codes, -Faces
            as_float32/2                % +Double, -Single
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
/* Readers of mesh files, for tests: they share nothing with the product.

   Faces are lists of X-Y-Z, as the file has them; Format is stl, stl_binary,
   off, obj, ply or ply_binary. What is not as it says throws wrong(_).
*/

must(Goal, What) :-
    (   call(Goal)
    ->  true
    ;   throw(wrong(What))
    ).

:- meta_predicate must(0, +).

read_faces(stl_binary, Codes, Faces) :-
    length(Header, 80),
    append(Header, [A,B,C,D|Bytes], Codes),
    \+ append(`solid`, _, Header),
    N is A + B<<8 + C<<16 + D<<24,
    length(Bytes, Length),
    must(Length =:= 50*N, length(N, Length)),
    stl_facets(N, Bytes, Faces).
read_faces(stl, Codes, Faces) :-
    rows(Codes, [["solid"|_]|Rows]),
    text_facets(Rows, Faces).
read_faces(off, Codes, Faces) :-
    rows(Codes, Rows0),
    exclude([["#"|_]]>>true, Rows0, [["OFF"],[V0,F0,_]|Rows]),
    maplist(number_string, [V,F], [V0,F0]),
    split(V, Rows, Vs, Fs),
    length(Fs, F),
    maplist(point, Vs, Points),
    maplist(numbered(Points, 0), Fs, Faces).
read_faces(obj, Codes, Faces) :-
    rows(Codes, Rows),
    findall(Point, ( member(["v"|Vs], Rows), point(Vs, Point) ), Points),
    findall(Face, ( member(["f"|Is], Rows), corners(Points, 1, Is, Face) ),
            Faces).
read_faces(ply, Codes, Faces) :-
    ply_header(Codes, "ascii", V, F, _, Body),
    rows(Body, Rows),
    split(V, Rows, Vs, Fs),
    length(Fs, F),
    maplist(point, Vs, Points),
    maplist(numbered(Points, 0), Fs, Faces).
read_faces(ply_binary, Codes, Faces) :-
    ply_header(Codes, "binary_little_endian", V, F, Bits, Body),
    binary_points(V, Bits, Body, Points, Rest),
    binary_faces(F, Points, Rest, Faces).

rows(Codes, Rows) :-
    string_codes(Text, Codes),
    split_string(Text, "\n", "\r", Lines),
    findall(Words, ( member(Line, Lines),
                     split_string(Line, " ", " ", Words),
                     Words \== [""] ),
            Rows).

split(N, List, Front, Back) :-
    must(( length(Front, N), append(Front, Back, List) ), too_short(N)).

point([X0,Y0,Z0|_], X-Y-Z) :-
    maplist(number_of, [X0,Y0,Z0], [X,Y,Z]).

number_of(Text, Number) :-
    must(( number_string(Number0, Text), Number is float(Number0) ),
         no_number(Text)).

numbered(Points, Base, [N0|Is], Face) :-
    number_string(N, N0),
    must(length(Is, N), corners(N, Is)),
    corners(Points, Base, Is, Face).

corners(Points, Base, Is, Face) :-
    findall(Point,
            ( member(I0, Is),
              must(( number_string(I, I0), nth(Base, I, Points, Point) ),
                   no_vertex(I0)) ),
            Face).

nth(0, I, Points, Point) :-
    nth0(I, Points, Point).
nth(1, I, Points, Point) :-
    nth1(I, Points, Point).

text_facets([["endsolid"|_]|Rest], Faces) :-
    !,
    (   Rest = [["solid"|_]|Rows]
    ->  text_facets(Rows, Faces)
    ;   Rest == [],
        Faces = []
    ).
text_facets([ ["facet","normal"|Normal], ["outer","loop"], ["vertex"|A],
              ["vertex"|B], ["vertex"|C], ["endloop"], ["endfacet"]
            | Rows ],
            [[P,Q,R]|Faces]) :-
    point(Normal, N),
    maplist(point, [A,B,C], [P,Q,R]),
    must(normal_of(N, [P,Q,R]), normal(N)),
    text_facets(Rows, Faces).

%   A normal is 0 or along that of the triangle.

normal_of(0.0-0.0-0.0, _) :-
    !.
normal_of(X-Y-Z, [A,B,C]) :-
    cross(A, B, C, U-V-W),
    Long is sqrt(U*U+V*V+W*W)*sqrt(X*X+Y*Y+Z*Z),
    X*U+Y*V+Z*W > 0.99*Long.

cross(X-Y-Z, X1-Y1-Z1, X2-Y2-Z2, U-V-W) :-
    U is (Y1-Y)*(Z2-Z)-(Z1-Z)*(Y2-Y),
    V is (Z1-Z)*(X2-X)-(X1-X)*(Z2-Z),
    W is (X1-X)*(Y2-Y)-(Y1-Y)*(X2-X).

stl_facets(0, [], []) :-
    !.
stl_facets(N, Bytes0, [[P,Q,R]|Faces]) :-
    floats(12, Bytes0, [X,Y,Z|Xs], [0,0|Bytes]),
    points(Xs, [P,Q,R]),
    must(normal_of(X-Y-Z, [P,Q,R]), normal(X-Y-Z)),
    N1 is N-1,
    stl_facets(N1, Bytes, Faces).

points([], []).
points([X,Y,Z|Xs], [X-Y-Z|Points]) :-
    points(Xs, Points).

floats(0, Bytes, [], Bytes) :-
    !.
floats(N, [A,B,C,D|Bytes0], [X|Xs], Bytes) :-
    Bits is A + B<<8 + C<<16 + D<<24,
    real(Bits, 8, 23, X),
    N1 is N-1,
    floats(N1, Bytes0, Xs, Bytes).

%   real(Bits, E, M, X): of IEEE 754, E bits of exponent and M of mantissa.

real(Bits, E, M, X) :-
    Sign is 1-2*((Bits >> (E+M)) /\ 1),
    Exponent is (Bits >> M) /\ (1<<E - 1),
    Fraction is Bits /\ (1<<M - 1),
    (   Exponent =:= 0
    ->  X is float(Sign*Fraction * 2 rdiv (2**(M + 1<<(E-1) - 1)))
    ;   Shift is Exponent - (1<<(E-1) - 1) - M,
        Whole is Sign*(Fraction + 1<<M),
        (   Shift >= 0
        ->  X is float(Whole << Shift)
        ;   Under is -Shift,
            X is float(Whole rdiv (1<<Under))
        )
    ).

ply_header(Codes, Format, V, F, Bits, Body) :-
    append(Header, Body0, Codes),
    append(_, `end_header\n`, Header),
    !,
    Body = Body0,
    rows(Header, [["ply"],["format",Format,"1.0"]|Rows0]),
    exclude([["comment"|_]]>>true, Rows0, Rows),
    Rows = [ ["element","vertex",V0], ["property",Type,"x"],
             ["property",Type,"y"], ["property",Type,"z"],
             ["element","face",F0],
             ["property","list",Counted,"int",_],
             ["end_header"] ],
    maplist(number_string, [V,F], [V0,F0]),
    memberchk(Type-Bits, ["double"-64,"float"-32]),
    Counted == "uint".

binary_points(0, _, Bytes, [], Bytes) :-
    !.
binary_points(N, Bits, Bytes0, [X-Y-Z|Points], Bytes) :-
    foldl(binary_number(Bits), [X,Y,Z], Bytes0, Bytes1),
    N1 is N-1,
    binary_points(N1, Bits, Bytes1, Points, Bytes).

binary_number(64, X, [A,B,C,D,E,F,G,H|Bytes], Bytes) :-
    Bits is A + B<<8 + C<<16 + D<<24 + E<<32 + F<<40 + G<<48 +
            H<<56,
    real(Bits, 11, 52, X).
binary_number(32, X, Bytes0, Bytes) :-
    floats(1, Bytes0, [X], Bytes).

binary_faces(0, _, [], []) :-
    !.
binary_faces(F, Points, [A0,B0,C0,D0|Bytes0], [Face|Faces]) :-
    N is A0 + B0<<8 + C0<<16 + D0<<24,
    length(Face, N),
    foldl([Point,[A,B,C,D|Bytes],Bytes]>>
              ( I is A + B<<8 + C<<16 + D<<24,
                must(nth0(I, Points, Point), no_vertex(I)) ),
          Face, Bytes0, Bytes1),
    F1 is F-1,
    binary_faces(F1, Points, Bytes1, Faces).

%   The nearest number of 24 bits; halves are not met by what is tested.

as_float32(X, Single) :-
    (   X =:= 0.0
    ->  Single = 0.0
    ;   Exponent is floor(log(abs(X))/log(2))-23,
        (   Exponent >= 0
        ->  Unit is 1<<Exponent
        ;   Unit is 1 rdiv (1<<(-Exponent))
        ),
        Single is float(round(rational(X)/Unit)*Unit)
    ).
