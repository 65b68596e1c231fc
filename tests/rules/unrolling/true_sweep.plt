/* Branches that are tangent to the side of their header, or nearly so, against
   the closed form of where two cylinders meet, or a cylinder and a sphere or a
   cone: rules/unrolling/true_sweep.pl, true_pipe.pl.
   TRUE_SWEEP_RANDOM=N: how many random scenes. */
% covers: true_pipe
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unrolling/true_table)).
:- use_module(tests('rules/sample')).

:- begin_tests(true_sweep).

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

/* The header lies along x, and is of radius R. The branch begins at the
   header's axis, Off beside it, leans by Lean degrees and is of radius B; on
   one side its generator at 90 is R - B - Off, the gap, within the header's. A
   scene is pipes(R, B, Lean, Off, Long-Branch), Long and Branch how long they
   are: of the sides of their walls that touch. */

%   scene_terms(Pipes, Drawn, Counts, Terms): Drawn is of their radii.

scene_terms(pipes(ball(R), B, _, Off, _-Branch), _, N1-N2,
            [ sphere(radius(R), facets(N1)),
              at([translate(0,Off,0)],
                 cylinder(radius(B), height(Branch), facets(N2))) ]) :-
    !.
scene_terms(pipes(cone(R, Slope), B, _, Off, Long-Branch), _, N1-N2,
            [ at([rotate(y,90),translate(X,0,0)],
                 cone(radius(R1), top(R2), height(Long), facets(N1))),
              at([translate(0,Off,0)],
                 cylinder(radius(B), height(Branch), facets(N2))) ]) :-
    !,
    X is -Long/2,
    R1 is R + Slope*X,
    R2 is R - Slope*X.
scene_terms(pipes(_, _, Lean, Off, Long-Branch), R-B, N1-N2,
            [ at([rotate(y,90),translate(X,0,0)],
                 cylinder(radius(R), height(Long), facets(N1))),
              at([rotate(y,Lean),translate(0,Off,0)],
                 cylinder(radius(B), height(Branch), facets(N2))) ]) :-
    X is -Long/2.

lengths(R, Lean, Long-Branch) :-
    A is Lean*pi/180,
    Branch is 3.0*R/cos(A),
    Long is 6.0*R + 2.0*Branch*sin(A).

%   removed(Which, Pipes, Radians, Froms): what the other pipe takes of the
%   generator there: from-to along the axis, none or one. Products, so that
%   nothing cancels.

removed(branch, Pipes, T, Removed) :-
    Pipes = pipes(Header, B, _, Off, _),
    compound(Header),
    !,
    header_square(Header, B, Off, T, Square),
    (   Square > 0
    ->  Z is sqrt(Square),
        Removed = [0.0-Z]
    ;   Removed = []
    ).
removed(branch, Pipes, T, Removed) :-
    Pipes = pipes(R, B, Lean, Off, _-Branch),
    gap(R, B, Off, Gap),
    Half is (T - pi/2)/2,
    Within is Gap + 2*B*sin(Half)**2,           % R - y
    Beyond is 2*B*cos(Half)**2 + 2*(R-B) - Gap, % R + y
    (   Within > 0,
        Beyond > 0
    ->  Z is sqrt(Within*Beyond),
        A is Lean*pi/180,
        Shift is B*tan(A)*cos(T),
        Low is max(0.0, Shift - Z/cos(A)),
        High is min(Branch, Shift + Z/cos(A)),
        ( High > Low -> Removed = [Low-High] ; Removed = [] )
    ;   Removed = []
    ).
removed(header, Pipes, T, Removed) :-
    Pipes = pipes(R, B, Lean, Off, Long-_),
    gap(R, B, Off, Gap),
    Half is (T - pi/2)/2,
    Within is 2*R*sin(Half)**2 - Gap,           % B - (y - Off)
    Beyond is 2*R*cos(Half)**2 - 2*(R-B) + Gap, % B + (y - Off)
    A is Lean*pi/180,
    Z is -R*cos(T),
    (   Within > 0,
        Beyond > 0
    ->  E is sqrt(Within*Beyond),
        Low0 is (Z*sin(A) - E)/cos(A),
        High0 is (Z*sin(A) + E)/cos(A),
        (   Lean =:= 0
        ->  ( Z >= 0 -> Low = Low0 ; Low = High0 )
        ;   Low is max(Low0, -Z*cos(A)/sin(A))
        ),
        (   High0 > Low
        ->  From is Low + Long/2,
            To is High0 + Long/2,
            Removed = [From-To]
        ;   Removed = []
        )
    ;   Removed = []
    ).

gap(R, B, Off, Gap) :-
    Gap is float(rational(R) - rational(B) - rational(Off)).

%   header_square(Header, B, Off, T, Square): of how far above its middle the
%   branch's generator leaves Header, a ball or cone.

header_square(ball(R), B, Off, T, Square) :-
    gap(R, B, Off, Gap),
    Square is Gap*(R+B+Off) + 4*B*Off*sin((T - pi/2)/2)**2.
header_square(cone(R, Slope), B, Off, T, Square) :-
    Wide is B*sqrt(1 + Slope**2),
    Least0 is R - Off - Wide,
    ( abs(Least0) < 1.0e-12*R -> Least = 0.0 ; Least = Least0 ),
    Middle is atan2(1, -Slope),
    Within is Least + 2*Wide*sin((T-Middle)/2)**2,
    Beyond is R + Off + B*sin(T) + Slope*B*cos(T),
    Square is Within*Beyond.

header_radius(Header, R) :-
    (   number(Header)
    ->  R = Header
    ;   arg(1, Header, R)
    ).

height(branch, pipes(_, _, _, _, _-H), H).
height(header, pipes(_, _, _, _, H-_), H).

%   ends(Which, Pipes, T, Ends): of what is left, along the axis.

ends(Which, Pipes, T, Ends) :-
    height(Which, Pipes, H),
    removed(Which, Pipes, T, Removed),
    (   Removed = [A-B]
    ->  findall(E,
                ( member(P-Q, [0.0-A,B-H]), Q > P, member(E, [P,Q]) ),
                Ends)
    ;   Ends = [0.0,H]
    ).

size(branch, pipes(_, B, _, _, _), B).
size(header, pipes(R, _, _, _, _), R).

%   right(Which, Pipes, Seam, D): all that the pattern D says is so.

right(Which, Pipes, Layer, Seam, D) :-
    size(Which, Pipes, Radius0),
    Radius is Radius0 + Layer,
    height(Which, Pipes, Height),
    findall(Y, ( e(D, E, V, _, 1), border(D, E), v(D, V, _, Y, _) ), Ys),
    max_list(Ys, Top),
    Base is Top-Height,
    all_corners_right(Which, Pipes, Radius, Seam, Base, D),
    all_rows_right(Which, Pipes, Base, D),
    all_reached(Which, Pipes, Radius, Seam, Base, D),
    forall(p(D, P, _), once(t(D, P, _, _, _, _))).

border(D, E) :-
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _).

all_corners_right(Which, Pipes, Radius, Seam, Base, D) :-
    forall(( e(D, E, V, _, 1), border(D, E), v(D, V, X, Y0, _) ),
           ( Y is Y0-Base,
             T is Seam*pi/180 + X/Radius,
             told(on_border(Which, Pipes, T, Y), corner(Which, X, Y)) )).

told(Goal, What) :-
    (   call(Goal)
    ->  true
    ;   format(user_error, "~q~n", [What]),
        fail
    ).

%   on_border(Which, Pipes, T, Y): the curve goes through a box round T-Y that
%   is as small as wanted.

on_border(Which, Pipes, T, Y) :-
    Pipes = pipes(Header, _, _, _, _),
    header_radius(Header, R),
    near_border(1.0e-9*R, Which, Pipes, T, Y).

near_border(Near, Which, Pipes, T, Y) :-
    size(Which, Pipes, Radius),
    Off is Near/Radius,
    findall(Ends,
            ( member(F, [-1.0,-0.5,0.0,0.5,1.0]), T1 is T + F*Off,
              ends(Which, Pipes, T1, Ends) ),
            Lists),
    (   member(Ends, Lists),
        member(E, Ends),
        abs(Y-E) =< Near
    ->  true
    ;   member(Ends1, Lists),
        member(Ends2, Lists),
        within_change(Ends1, Ends2, Near, Y)
    ->  true
    ).

%   Between two generators the ends go from one to the other; of a tip, or
%   where the generator is one side of a hole, all between two ends is border.

within_change(Ends1, Ends2, Near, Y) :-
    (   same_length(Ends1, Ends2)
    ->  nth1(I, Ends1, E1),
        nth1(I, Ends2, E2)
    ;   append(_, [E1,E2|_], Ends1)
    ;   append(_, [E1,E2|_], Ends2)
    ),
    Y >= min(E1, E2) - Near,
    Y =< max(E1, E2) + Near.

all_rows_right(Which, Pipes, Base, D) :-
    Pipes = pipes(Header, _, _, _, _),
    header_radius(Header, R),
    true_length_rows(D, Rows),
    findall(Degrees, member(row(_, Degrees, _, _, _, _, _, _, _), Rows), All0),
    sort(All0, All),
    forall(member(Degrees, All),
           ( findall(E,
                     ( member(row(_, Degrees, _, From, To, _, _, _, _), Rows),
                       member(E0, [From,To]), E is E0-Base ),
                     Es0),
             sort(Es0, Es),
             T is Degrees*pi/180,
             told(forall(member(E, Es),
                         near_border(1.0e-9*R, Which, Pipes, T, E)),
                  row(Which, Degrees, Es)) )).

%   all_reached(...): from each point of the true border it is not far to the
%   outline.

all_reached(Which, Pipes, Radius, Seam, Base, D) :-
    findall(s(X1,Y1,X2,Y2),
            ( e(D, E, V, W, 1), border(D, E),
              v(D, V, X1, Y01, _), v(D, W, X2, Y02, _),
              Y1 is Y01-Base, Y2 is Y02-Base ),
            Sides),
    height(Which, Pipes, Height),
    Far is 2.0e-4*max(Height, 2*pi*Radius),
    forall(( between(-60, 60, I),
             T0 is pi/2 + sign(I)*10**(-7 + 7*abs(I)/60.0)*pi,
             T is T0 - 2*pi*floor((T0 - Seam*pi/180)/(2*pi)),
             ends(Which, Pipes, T, Ends),
             member(Y, Ends) ),
           ( X is (T - Seam*pi/180)*Radius,
             told(( member(Side, Sides), reaches(Side, X, Y, Far) ),
                  missed(Which, X, Y)) )).

reaches(s(X1,Y1,X2,Y2), X, Y, Far) :-
    abs(X - (X1+X2)/2) =< abs(X1-X2)/2 + Far,
    abs(Y - (Y1+Y2)/2) =< abs(Y1-Y2)/2 + Far,
    Long is (X2-X1)**2 + (Y2-Y1)**2,
    (   Long > 0
    ->  F is max(0.0, min(1.0, ((X-X1)*(X2-X1) + (Y-Y1)*(Y2-Y1))/Long))
    ;   F = 0.0
    ),
    (X1 + F*(X2-X1) - X)**2 + (Y1 + F*(Y2-Y1) - Y)**2 =< Far*Far.

which(header, 1).
which(branch, 2).

%   checked(Pipes, Drawn, Counts, Which, Layer, Seam, Options): Layer is how far
%   outside of what touches that is which keeps its length.

checked(Pipes, Drawn, Counts, Which, Layer, Seam, Options) :-
    scene_terms(Pipes, Drawn, Counts, Terms),
    which(Which, S),
    in_scene(Terms,
             ( true_patterns(S, wanted(none,[],[],[]),
                             [trim(outside),seam(Seam),generators(72)
                             |Options],
                             Ds),
               once(( member(D, Ds),
                      segment(D, pattern, true_development(_, _)) )),
               right(Which, Pipes, Layer, Seam, D) )).

near_pipes(pipes(R, B, Lean, Off, Lengths), Counts, Gap) :-
    member(pipe(R, B, Lean, Counts),
           [ pipe(100.0, 40.0, 0, 40-40), pipe(100.0, 40.0, 30, 40-40),
             pipe(50.0, 20.0, 0, 24-12), pipe(100.0, 100.0, 0, 24-24),
             pipe(100.0, 60.0, 45, 20-20), pipe(57.15, 5.715, 0, 12-37) ]),
    member(Gap, [0, 1.0e-9, -1.0e-9, 1.0e-6, -1.0e-6, 1.0e-4, -1.0e-4, 1.0e-3,
                 -1.0e-3, 0.01, -0.01, 0.1, -0.1, 1.0, -1.0]),
    Off is R-B-Gap,
    lengths(R, Lean, Lengths).

test(near, [forall(sampled([Gap,Counts,Which],
                           ( near_pipes(Pipes, Counts, Gap),
                             which(Which, _) ))),
            true(Gap-Which == Gap-Which)]) :-
    Pipes = pipes(R, B, _, _, _),
    checked(Pipes, R-B, Counts, Which, 0.0, 17.0, []).

%   A ball or cone as the header.

round_header(pipes(Header, B, 0, Off, 400-300), N1-N2, Header, Gap) :-
    member(B-(N1-N2), [20.0-(24-24),33.3-(7-37)]),
    member(Gap, [0, 1.0e-9, -1.0e-9, 1.0e-4, -1.0e-4, 0.01, -1.0]),
    (   Header = ball(100.0),
        Off is 100.0-B-Gap
    ;   member(Slope, [0.1,-0.3]),
        Header = cone(100.0, Slope),
        Off is 100.0 - B*sqrt(1 + Slope**2) - Gap
    ).

test(round_header, [forall(sampled([Header,Gap],
                                   round_header(Pipes, Counts, Header, Gap))),
                    true(Pipes == Pipes)]) :-
    checked(Pipes, none, Counts, branch, 0.0, 17.0, []).

%   The cone's own pattern: how far the ends of its generators are from the
%   apex.

test(cone_header, [forall(sampled([Header,Gap],
                                  ( Header = cone(_, _),
                                    round_header(Pipes, Counts, Header,
                                                 Gap) ))),
                   true(Pipes == Pipes)]) :-
    scene_terms(Pipes, none, Counts, Terms),
    in_scene(Terms,
             ( true_patterns(1, wanted(none,[],[],[]),
                             [trim(outside),seam(17.0),generators(72)], Ds),
               member(D, Ds),
               segment(D, pattern, true_development(_, _)),
               !,
               true_length_rows(D, Rows),
               findall(T-(A-B),
                       ( member(row(_, T, _, A, B, _, _, _, _), Rows) ),
                       All),
               length(All, Count),
               Count >= 72,
               forall(( member(T, All), T = Degrees-_ ),
                      ( findall(P, member(Degrees-P, All), Found0),
                        sort(Found0, Found),
                        cone_ends(Pipes, Degrees, Ends0),
                        msort(Ends0, Ends),
                        told(maplist(ends_alike, Found, Ends),
                             row(Degrees, Found, Ends)) )) )).

ends_alike(A0-B0, A-B) :-
    abs(min(A0, B0) - min(A, B)) < 1.0e-6,
    abs(max(A0, B0) - max(A, B)) < 1.0e-6.

cone_ends(pipes(cone(R, Slope), B, _, Off, Long-_), Degrees, Ends) :-
    T is Degrees*pi/180,
    S is sin(T),
    % x^2 + (R*S + Slope*S*x - Off)^2 = B^2
    QA is 1 + Slope**2*S**2,
    QB is Slope*S*(R*S - Off),
    QC is (R*S - Off)**2 - B**2,
    D is QB*QB - QA*QC,
    Low is -Long/2,
    High is Long/2,
    (   D > 0,
        cos(T) < 0
    ->  X1 is (-QB - sqrt(D))/QA,
        X2 is (-QB + sqrt(D))/QA,
        Spans = [Low-X1,X2-High]
    ;   Spans = [Low-High]
    ),
    findall(E1-E2,
            ( member(A-C, Spans),
              E1 is abs(A + R/Slope)*sqrt(1+Slope**2),
              E2 is abs(C + R/Slope)*sqrt(1+Slope**2) ),
            Ends).

scenes(Most, N) :-
    (   getenv('TRUE_SWEEP_RANDOM', Text),
        atom_number(Text, N)
    ->  true
    ;   N = Most
    ).

%   Touching sides of walls: the branch set on the header, or set in.

random_scene(N, scene(Pipes, R0-B0, Counts, Which, Layer, Seam, Options)) :-
    set_random(seed(N)),
    random_between(20, 200, R1),
    R0 is float(R1),
    random(0.05, 1.0, Part),
    B0 is round(10*Part*R0)/10.0,
    random_member(Lean, [0,0,15,30,45,60]),
    random_between(6, 50, N1),
    random_between(6, 50, N2),
    Counts = N1-N2,
    random_member(Which, [header,branch]),
    random(-9.0, 0.0, Power),
    random_member(Sign, [1,-1]),
    Gap is Sign*10**Power*min(R0-B0/2, B0),
    random(0.0, 360.0, Seam),
    (   R0 - B0 > 0.1*R0,
        maybe
    ->  random(0.01, 0.08, Wall),
        T is round(100*Wall*B0)/100.0,
        random_member(In, [true,false]),
        Options = [thickness(T),set_in(In)],
        ( In == true -> Half is -T/2 ; Half is T/2 )
    ;   Options = [],
        Half = 0.0
    ),
    R is R0+Half,
    B is B0-Half,
    ( Which == branch -> Layer is Half ; Layer is -Half ),
    Off is R-B-Gap,
    lengths(R, Lean, Lengths),
    Pipes = pipes(R, B, Lean, Off, Lengths).

test(random, [forall(( scenes(16, Most), between(1, Most, N) )),
              true(N == N)]) :-
    random_scene(N, scene(Pipes, Drawn, Counts, Which, Layer, Seam, Options)),
    checked(Pipes, Drawn, Counts, Which, Layer, Seam, Options).

:- end_tests(true_sweep).
