:- module(sg_true_touch,
          [ touches_told/4              % +S, +Part, +Surface, +Options
          ]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../kernel', [surface_value/4]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module('../store', [segment/3]).
:- use_module('../vector', [cross_product/3, dot_product/3, difference/3]).
:- use_module(true_parts, [facet_chord/3, surface_radius/2]).
:- use_module(true_sweep, [nearly_touched/3]).
:- use_module(library(lists), [member/2]).
/** <module> Sides that nearly touch where facets decide how they meet.

What true_sweep.pl has no closed form for is cut in facets. Where the sides are
nearer to touching than their facets are to them, these may give one loop for
two. A warning says so: the pattern may be off there by more than the chord
tolerance.
*/

:- set_prolog_flag(optimise, true).

%!  touches_told(+S, +Part, +Surface, +Options) is det.
%
%   Warn if Part of the trimmed segment S, of Surface, nearly touches what trims
%   it, by facets. Of Options: chord(Tolerance).

touches_told(S, Leaf/_, Surface, Options) :-
    segment(S, _, trimmed(Leaf, _, Others)),
    by_facets(Surface, Others, Other, OtherSurface),
    facet_chord(Options, Surface, Chord1),
    facet_chord(Options, OtherSurface, Chord2),
    Within is Chord1+Chord2,
    touch_within(Surface, OtherSurface, Within),
    !,
    part_named(S, Named),
    part_named(Other, By),
    print_message(warning, sanggwan(unfold(nearly_touching(Named, By)))).
touches_told(_, _, _, _).

by_facets(Surface, Others, Other, OtherSurface) :-
    functor(Surface, Kind, _),
    memberchk(Kind, [cylinder,cone]),
    (   member(Other, Others),
        OtherSurface = torus(_, _, _, _, _),
        placed_surface(Other, _, OtherSurface)
    ;   nearly_touched(Surface, Others, Other-OtherSurface)
    ).

%   touch_within(Surface, Other, Within) is semidet: where their normals are
%   parallel, the one is within that of the other: so it is where they touch,
%   moved along the normal. From each place of a grid where the sine between
%   the normals is least.

touch_within(Surface, Other, Within) :-
    reach(Surface, Other, From, To, N),
    findall(Row,
            ( between(0, 120, I),
              T is 3.0*I,
              findall(Sine,
                      ( between(0, N, J),
                        H is From + (To-From)*J/N,
                        normal_sine(Surface, Other, T, H, Sine) ),
                      Sines),
              Row =.. [row|Sines] ),
            Rows0),
    Rows =.. [rows|Rows0],
    StepH is (To-From)/N,
    between(2, 120, I),
    between(1, N, J0),
    J is J0+1,
    least_there(Rows, I, J),
    T0 is 3.0*(I-1),
    H0 is From + StepH*J0,
    least_near(40, Surface, Other, T0-H0, 1.5-StepH, T-H),
    H > 0.0,
    H < 1.0,
    surface_point(Surface, T, H, Point),
    surface_value(Other, Point, Off, _),
    abs(Off) =< Within,
    !.

%   reach(Surface, Other, From, To, N): the generators of Surface are near Other
%   from H = From to To; N steps are a third of the radius of a tube, or less.

reach(Surface, Other, From, To, N) :-
    Surface =.. [_,C,_,_,vector(WX,WY,WZ)|_],
    Other =.. [_,C2|_],
    W = p(WX,WY,WZ),
    as_point(C, P),
    as_point(C2, P2),
    difference(P2, P, To2),
    dot_product(W, W, Square),
    dot_product(W, To2, Along),
    surface_radius(Surface, R1),
    bounding_radius(Other, R2, Tube),
    Length is sqrt(Square),
    Middle is Along/Square,
    Half is (R1+R2)/Length,
    From is max(0.0, Middle-Half),
    To is min(1.0, Middle+Half),
    To > From,
    N is min(200, max(8, ceiling((To-From)*Length*3.0/Tube))).

as_point(point(X,Y,Z), p(X,Y,Z)).

bounding_radius(Other, Bounding, Tube) :-
    surface_radius(Other, R),
    (   Other = torus(_, _, _, _, K)
    ->  Tube is R*K,
        Bounding is R + Tube
    ;   Other = sphere(_, _, _, _)
    ->  Tube = R,
        Bounding = R
    ;   Other =.. [_,_,_,_,vector(X,Y,Z)|_],
        Tube = R,
        Bounding is R + sqrt(X*X + Y*Y + Z*Z)
    ).

%   normal_sine(Surface, Other, T, H, Sine): its square.

normal_sine(Surface, Other, T, H, Sine) :-
    surface_point(Surface, T, H, Point),
    (   surface_value(Surface, Point, _, N1),
        surface_value(Other, Point, _, N2)
    ->  cross_product(N1, N2, Across),
        dot_product(Across, Across, Sine)
    ;   Sine = 1.0
    ).

least_there(Rows, I, J) :-
    arg(I, Rows, Row),
    arg(J, Row, Sine),
    Sine < 0.25,
    \+ ( member(DI-DJ, [(-1)-0, 1-0, 0-(-1), 0-1]),
         I1 is I+DI,
         J1 is J+DJ,
         arg(I1, Rows, Row1),
         arg(J1, Row1, Sine1),
         Sine1 < Sine ).

%   least_near(Steps, Surface, Other, T0-H0, StepT-StepH, T-H)

least_near(0, _, _, T-H, _, T-H) :-
    !.
least_near(Steps0, Surface, Other, T0-H0, StepT0-StepH0, Place) :-
    Steps is Steps0-1,
    normal_sine(Surface, Other, T0, H0, Sine0),
    findall(Sine-(T-H),
            ( member(DT-DH, [(-1)-0, 1-0, 0-(-1), 0-1]),
              T is T0 + DT*StepT0,
              H is H0 + DH*StepH0,
              normal_sine(Surface, Other, T, H, Sine) ),
            Sines),
    msort(Sines, [Sine1-(T1-H1)|_]),
    (   Sine1 < Sine0
    ->  least_near(Steps, Surface, Other, T1-H1, StepT0-StepH0, Place)
    ;   StepT is StepT0/2.0,
        StepH is StepH0/2.0,
        least_near(Steps, Surface, Other, T0-H0, StepT-StepH, Place)
    ).
