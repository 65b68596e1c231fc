/* Buffers of a shaded picture, parallel and central, against rays that know
   each solid in closed form, and share nothing with slices: depths, normals,
   and what is seen. */
% covers: depth_buffer
:- module(test_buffer_rays, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_buffer)).
:- use_module(rules(shading/shading_scene)).
:- use_module(shaded_model).

%   solid(Segment, Steps, Term, Shape): Term, and what the rays know of it.

solid(1, [translate(-3,2,0)], sphere(radius(1.2)), ball(1.2)).
solid(2, [rotate(x,50),translate(0,2,0)],
      cylinder(radius(0.8),height(2)), tapered(0.8,0.8,2)).
solid(3, [rotate(x,-60),rotate(z,20),translate(3,2,0)],
      cone(radius(1.1),top(0.4),height(1.8)), tapered(1.1,0.4,1.8)).
solid(4, [rotate(x,35),translate(-3,-2,0)],
      torus(radius(1),tube(0.4)), ring(1,0.4)).
solid(5, [rotate(z,30),rotate(x,40),translate(0,-2,0)],
      box(size(1.2,1.6,1)), boxes([b([-0.6,-0.8,0],[0.6,0.8,1])])).
solid(6, [rotate(y,30),translate(2.2,-3,0)],
      prism(outline([[0,0],[2,0],[2,0.7],[0.7,0.7],[0.7,2],[0,2]]),
            height(0.8)),
      boxes([b([0,0,0],[2,0.7,0.8]),b([0,0,0],[0.7,2,0.8])])).

model(Text) :-
    findall(Fact,
            ( solid(S, Steps, Term, _),
              format(string(Fact), "segment(~d, solid, at(~w, ~w)).~n",
                     [S,Steps,Term]) ),
            Facts),
    atomics_to_string(Facts, Text).

size(64, 48).
window(b(-5.0,-3.75,5.0,3.75)).

view(view(250.0,35.0,14.0,_), 14.0).


                /*******************************
                *             RAYS             *
                *******************************/

%   ray(Eye, X, Y, Ray): through a place of the picture, in dots; T along it is
%   a depth, and one more than Back.

ray(eye(Kind,Rho,Nearest,[R,U,A]), Column, Row, ray(O,D,Back)) :-
    size(Width, _),
    window(b(X1,_,X2,Y2)),
    Scale is Width/(X2-X1),
    X is X1+Column/Scale,
    Y is Y2-Row/Scale,
    (   Kind == parallel
    ->  Back = 50,
        sum([X-R,Y-U,-50-A], O),
        D = A
    ;   Back = 0,
        Far is -Rho,
        sum([Far-A], O),
        X0 is X/Nearest, Y0 is Y/Nearest,
        sum([X0-R,Y0-U,1-A], D)
    ).

sum(Parts, V) :-
    foldl(added, Parts, [0.0,0.0,0.0], V).

added(F-V, S0, S) :-
    maplist(plus_times(F), V, S0, S).

plus_times(F, A, B, C) :-
    C is F*A+B.

part(R, A, B) :-
    B is A/R.

dot(A, B, D) :-
    foldl(product_added, A, B, 0.0, D).

product_added(A, B, S0, S) :-
    S is S0+A*B.

turned(Axis, Angle, [X,Y,Z], V) :-
    C is cos(Angle*pi/180), S is sin(Angle*pi/180),
    (   Axis == x
    ->  A is C*Y-S*Z, B is S*Y+C*Z, V = [X,A,B]
    ;   Axis == y
    ->  A is C*X+S*Z, B is C*Z-S*X, V = [A,Y,B]
    ;   A is C*X-S*Y, B is S*X+C*Y, V = [A,B,Z]
    ).

%   undone(Step, Ray0, Ray): before Step.

undone(translate(X,Y,Z), O0-D, O-D) :-
    sum([1-O0,-1-[X,Y,Z]], O).
undone(rotate(Axis,Angle), O0-D0, O-D) :-
    Back is -Angle,
    turned(Axis, Back, O0, O),
    turned(Axis, Back, D0, D).

done(translate(_,_,_), N, N).
done(rotate(Axis,Angle), N0, N) :-
    turned(Axis, Angle, N0, N).

%   hit(Ray, T, Segment, Face, Normal): the nearest one.

hit(ray(O,D,_), T, S, Face, N) :-
    findall(hit(T1,S1,Face1,N1),
            ( solid(S1, Steps, _, Shape),
              reverse(Steps, Back),
              foldl(undone, Back, O-D, O1-D1),
              met(Shape, O1, D1, T1, Face1, N0),
              foldl(done, Steps, N0, N1) ),
            Hits),
    sort(Hits, [hit(T,S,Face,N)|_]).

%   met(Shape, O, D, T, Face, Normal): first.

met(Shape, O, D, T, Face, N) :-
    findall(m(T1,F1,N1), meets(Shape, O, D, T1, F1, N1), All),
    sort(All, [m(T,Face,N)|_]).

root(A, B, C, T) :-                % A TT + 2 B T + C = 0
    Square is B*B-A*C,
    Square >= 0,
    member(Sign, [-1,1]),
    T is (-B+Sign*sqrt(Square))/A.

meets(ball(R), O, D, T, side, N) :-
    dot(D, D, A), dot(O, D, B), dot(O, O, C0),
    C is C0-R*R,
    root(A, B, C, T),
    T > 0,
    sum([1-O,T-D], P),
    maplist(part(R), P, N).
meets(tapered(R1,R2,H), [OX,OY,OZ], [DX,DY,DZ], T, side, N) :-
    K is (R2-R1)/H,
    R0 is R1+K*OZ, RD is K*DZ,
    A is DX*DX+DY*DY-RD*RD,
    B is OX*DX+OY*DY-R0*RD,
    C is OX*OX+OY*OY-R0*R0,
    root(A, B, C, T),
    Z is OZ+T*DZ,
    Z > 0, Z < H,
    R is R1+K*Z,
    Long is sqrt(1+K*K),
    NX is (OX+T*DX)/R/Long, NY is (OY+T*DY)/R/Long, NZ is -K/Long,
    N = [NX,NY,NZ].
meets(tapered(R1,R2,H), [OX,OY,OZ], [DX,DY,DZ], T, Face, [0.0,0.0,Up]) :-
    member(c(Face,Z,R,Up), [c(base,0,R1,-1.0),c(top,H,R2,1.0)]),
    T is (Z-OZ)/DZ,
    (OX+T*DX)^2+(OY+T*DY)^2 < R*R.
meets(boxes(Boxes), O, D, T, N, N) :-
    member(b(Low,High), Boxes),
    member(I, [1,2,3]),
    member(Side-Sign, [Low-(-1.0),High-1.0]),
    nth1(I, Side, At), nth1(I, O, OI), nth1(I, D, DI),
    Sign*DI < 0,                   % it is entered there
    T is (At-OI)/DI,
    sum([1-O,T-D], P),
    forall(( nth1(J, P, PJ), J =\= I ),
           ( nth1(J, Low, LJ), nth1(J, High, HJ), PJ > LJ, PJ < HJ )),
    findall(V, ( member(J, [1,2,3]), ( J =:= I -> V = Sign ; V = 0.0 ) ), N).
meets(ring(R,Tube), O, D, T, side, N) :-
    dot(O, D, OD), dot(D, D, DD),
    Middle is -OD/DD,              % where it is nearest to the centre
    Most is R+Tube,
    sum([1-O,Middle-D], P0),
    dot(P0, P0, Off),
    Off < Most*Most,
    Reach is sqrt((Most*Most-Off)/DD),
    From is Middle-Reach,
    Step is Reach/150,
    between(1, 300, I),
    High is From+I*Step,
    into_ring(R, Tube, O, D, High, In),
    In < 0,
    !,
    Low is High-Step,
    halved(40, R, Tube, O, D, Low, High, T),
    sum([1-O,T-D], [X,Y,Z]),
    Out is 1-R/sqrt(X*X+Y*Y),
    maplist(part(Tube), [X*Out,Y*Out,Z], N).

into_ring(R, Tube, O, D, T, In) :-
    sum([1-O,T-D], [X,Y,Z]),
    In is (sqrt(X*X+Y*Y)-R)^2+Z*Z-Tube*Tube.

halved(0, _, _, _, _, _, T, T) :-
    !.
halved(I, R, Tube, O, D, Low, High, T) :-
    M is (Low+High)/2,
    I1 is I-1,
    into_ring(R, Tube, O, D, M, In),
    (   In < 0
    ->  halved(I1, R, Tube, O, D, Low, M, T)
    ;   halved(I1, R, Tube, O, D, M, High, T)
    ).


                /*******************************
                *           BUFFERS            *
                *******************************/

%   buffers(Kind, Eye, Depths, Normals, Rows): the first two are compounds of
%   floats by rows from below.

buffers(Kind, eye(Kind,Rho,Nearest,Axes), Depths, Normals, Rows) :-
    model(Text),
    size(Width, Height),
    window(Window),
    in_model(Text,
             ( shaded_model([1,2,3,4,5,6], Model),
               view(View, Rho),
               View = view(Theta,Phi,_,Kind),
               shaded_eye(Model, View, Eye),
               Eye = eye(_,_,_,_,Nearest),
               view_matrix(Theta, Phi, Matrix),
               maplist(axis, Matrix, Axes),
               shaded_picture(Model, Eye,
                              [size(Width-Height),window(Window)], Scene),
               maplist(buffer(Scene), [depth,normal,id],
                       [DepthCodes,NormalCodes,RowCodes]) )),
    floats(DepthCodes, Depths),
    floats(NormalCodes, Normals),
    string_codes(RowText, RowCodes),
    split_string(RowText, "\n", "", [_|Lines]),
    findall(row(Y,X1,X2,Root),
            ( member(Line, Lines),
              split_string(Line, ",", "", [Y0,X10,X20,Root0|_]),
              maplist(text_number, [Y0,X10,X20,Root0], [Y,X1,X2,Root]) ),
            Rows).

axis(r(A,B,C), [A,B,C]).

text_number(Text, N) :-
    number_string(N, Text).

buffer(Scene, Kind, Codes) :-
    setup_call_cleanup(
        tmp_file_stream(octet, File, Out),
        ( write_buffer(Kind, Scene, Out),
          close(Out),
          read_file_to_codes(File, Codes, [encoding(octet)]) ),
        delete_file(File)).

floats(Codes, Floats) :-
    append(_, [0'-,0'1,0'.,0'0,0'\n|Bytes], Codes),
    !,
    float_list(Bytes, List),
    Floats =.. [floats|List].

float_list([], []).
float_list([A,B,C,D|Bytes], [F|Fs]) :-
    Bits is A + B<<8 + C<<16 + D<<24,
    float_of(Bits, F),
    float_list(Bytes, Fs).

float_of(Bits, F) :-
    Sign is 1 - 2*(Bits>>31),
    Exponent is (Bits>>23) /\ 255,
    Part is Bits /\ 0x7fffff,
    (   Exponent =:= 255
    ->  F = infinite
    ;   Exponent =:= 0
    ->  F is Sign * Part * 2.0** -149
    ;   F is Sign * (Part + 0x800000) * 2.0**(Exponent-150)
    ).

%   dot_seen(Eye, Column, Row, Seen): of a dot that shows one face all round its
%   middle.

dot_seen(Eye, Column, Row, Seen) :-
    findall(S-Face,
            ( member(DX-DY, [0.47-0.47,0.53-0.47,0.47-0.53,0.53-0.53]),
              X is Column+DX, Y is Row+DY,
              ray(Eye, X, Y, Ray),
              (   hit(Ray, _, S, Face, _)
              ->  true
              ;   S-Face = 0-none
              ) ),
            [One|Others]),
    forall(member(Other, Others), Other = One),
    X is Column+0.5, Y is Row+0.5,
    ray(Eye, X, Y, Ray),
    (   hit(Ray, T, S, _, N)
    ->  Ray = ray(_,_,Back),
        Depth is T-Back,
        Seen = seen(S,Depth,N)
    ;   Seen = nothing
    ).

%   dot_buffers(Column, Row, Depths, Normals, Rows, Seen)

dot_buffers(Column, Row, Depths, Normals, Rows, Seen) :-
    size(Width, Height),
    I is (Height-1-Row)*Width+Column,
    I1 is I+1, J is 3*I+1, J1 is J+1, J2 is J+2,
    arg(I1, Depths, Depth),
    arg(J, Normals, NX), arg(J1, Normals, NY), arg(J2, Normals, NZ),
    Y is Row+0.5, X is Column+0.5,
    (   member(row(Y,X1,X2,Root), Rows),
        X1 =< X,
        X < X2
    ->  Seen = seen(Root,Depth,[NX,NY,NZ])
    ;   Seen = nothing(Depth,[NX,NY,NZ])
    ).

same(seen(S,Depth,N), seen(S,Depth1,N1)) :-
    abs(Depth-Depth1) < 2.0e-5,
    maplist(nearly, N, N1).
same(nothing, nothing(infinite,[X,Y,Z])) :-
    X =:= 0, Y =:= 0, Z =:= 0.

nearly(A, B) :-
    abs(A-B) < 1.0e-5.

is_right(dot(_,_,Seen,Said)) :-
    same(Seen, Said).

compared(Kind, Wrong, Segments) :-
    buffers(Kind, Eye, Depths, Normals, Rows),
    size(Width, Height),
    findall(dot(Column,Row,Seen,Said),
            ( between(1, Height, Row0), Row is Row0-1, Row mod 2 =:= 0,
              between(1, Width, Column0), Column is Column0-1,
              dot_seen(Eye, Column, Row, Seen),
              dot_buffers(Column, Row, Depths, Normals, Rows, Said) ),
            Dots),
    exclude(is_right, Dots, Wrong),
    findall(S, ( member(dot(_,_,seen(S,_,_),_), Dots) ), Ss),
    msort(Ss, Sorted),
    clumped_segments(Sorted, Segments).

clumped_segments(Sorted, Segments) :-
    findall(S, ( between(1, 6, S),
                 include(==(S), Sorted, Own),
                 length(Own, N),
                 N > 15 ),
            Segments).

:- begin_tests(buffer_rays).

test(parallel, Wrong-Segments == []-[1,2,3,4,5,6]) :-
    compared(parallel, Wrong, Segments).
test(central, Wrong-Segments == []-[1,2,3,4,5,6]) :-
    compared(central, Wrong, Segments).

:- end_tests(buffer_rays).
