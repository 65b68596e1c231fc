/* Tori seen from their side, however they lie in the picture, and thin ones:
   both walls end in one place there, so the discriminant of their quartic
   touches 0 and does not change its sign, or is 0 but for rounding. */
% covers: ring_slice, shading_ring
:- module(test_ring_sides, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(rules(shading/shading_scene)).
:- use_module(shaded_model).

:- begin_tests(ring_sides).

torus_text(Steps, Tube, View, Text) :-
    View = view(Theta,Phi),
    format(string(Text),
           "segment(1, solid, at(~q, torus(radius(3),tube(~q)))). \c
            view(~q,~q,0).", [Steps,Tube,Theta,Phi]).

%   The size of what is seen in units of the model; 10 dots are one, 4 lines a
%   dot.
area(Steps, Tube, View, Area) :-
    torus_text(Steps, Tube, View, Text),
    in_model(Text,
             ( shaded_scene_of([size(90-90),window(b(-4.5,-4.5,4.5,4.5))],
                               Scene),
               aggregate_all(sum(X2-X1),
                             ( line(Scene, 360, 0, 360, _, Spans),
                               member(span(X1,X2,_,_,_), Spans) ),
                             Sum) )),
    Area is Sum/256/4/100.

%   line(Scene, Lines, From, To, I, Spans): of Lines in 90 dots those from From
%   on.
line(Scene, Lines, From, To, I, Spans) :-
    scene_handle(Scene, Handle),
    Last is To-1,
    between(From, Last, I),
    Y is (I+0.5)*90/Lines,
    shading_spans(Handle, Y, Spans).

% A strip as long as the circle in the middle is wide, and two halves of a disc.
test(from_the_side, Wrong == []) :-
    findall(Turn-Theta-Tube-Area,
            ( member(Tube, [0.9,0.3,0.03,0.003]),
              member(Turn, [rotate(y,90),rotate(x,90),rotate(axis(1,2,0),90)]),
              member(Theta, [240,137,300,17.3]),
              area([Turn], Tube, view(Theta,0), Area),
              Right is 4*3*Tube + pi*Tube**2,
              abs(Area-Right) > 0.003 ),
            Wrong).
test(nearly_from_the_side, Wrong == []) :-
    findall(Off-Area,
            ( member(Off, [1.0e-3,1.0e-5,1.0e-7,1.0e-9]),
              Angle is 90+Off,
              area([rotate(y,Angle)], 0.3, view(240,0), Area),
              Right is 4*3*0.3 + pi*0.3**2,
              abs(Area-Right) > 0.002 ),
            Wrong).
test(mirrored, Wrong == []) :-
    findall(Axis-Area,
            ( member(Axis, [x,y,z]),
              area([mirror(Axis),rotate(y,90),translate(0.3,-0.4,0.5)], 0.4,
                   view(200,180), Area),
              Right is 4*3*0.4 + pi*0.4**2,
              abs(Area-Right) > 0.002 ),
            Wrong).

% So large that a thin tube fills the picture, each line goes through it once.
test(thin_and_large, Wrong == []) :-
    findall(Tube-Phi-I-Width,
            ( member(Tube, [0.1,0.001,0.0001]),
              member(Phi, [0,60]),
              torus_text([], Tube, view(300,Phi), Text),
              X1 is 3-3*Tube, X2 is 3+3*Tube, Y1 is -3*Tube, Y2 is 3*Tube,
              in_model(Text,
                       ( shaded_scene_of([size(90-90),window(b(X1,Y1,X2,Y2))],
                                         Scene),
                         findall(I-Width,
                                 ( line(Scene, 101, 48, 53, I, Spans),
                                   aggregate_all(sum(B-A),
                                                 member(span(A,B,_,_,_),
                                                        Spans),
                                                 Sum),
                                   Width is Sum/256 ),
                                 Widths) )),
              member(I-Width, Widths),
              abs(Width-30) > 0.6 ),
            Wrong).

% An outline without a dent: a line is as wide as its neighbours on the average,
% or wider. One line goes through the edge of the hole so nearly that chords of
% the discriminant come no nearer to where it ends.
test(no_line_is_torn, Torn == []) :-
    torus_text([scale(1,1,2),rotate(y,90)], 0.75, view(40,90), Text),
    in_model(Text,
             ( shaded_scene_of([size(320-240)], Scene),
               scene_handle(Scene, Handle),
               findall(Width,
                       ( between(0, 959, I),
                         Y is (I+0.5)/4,
                         shading_spans(Handle, Y, Spans),
                         extent(Spans, Width) ),
                       Widths) )),
    findall(A-B-C,
            ( append(_, [A,B,C|_], Widths), A > 0, C > 0, 2*B < A+C-4 ), Torn).

extent([], 0).
extent([First|Spans], Width) :-
    last([First|Spans], Last),
    First = span(X1,_,_,_,_),
    Last = span(_,X2,_,_,_),
    Width is X2-X1.

% Two tori about one centre, one the other one enlarged, are two.
test(enlarged, true(abs(Area - 4*pi*2*0.5) < 0.003)) :-
    Text = "segment(1, solid, difference([torus(radius(2),tube(0.5)),
                at([scale(2,2,2)], torus(radius(2),tube(0.5)))])).
            view(300, 0, 0).",
    in_model(Text,
             ( shaded_scene_of([size(90-90),window(b(-4.5,-4.5,4.5,4.5))],
                               Scene),
               aggregate_all(sum(X2-X1),
                             ( line(Scene, 360, 0, 360, _, Spans),
                               member(span(X1,X2,_,_,_), Spans) ),
                             Sum) )),
    Area is Sum/256/4/100.

:- end_tests(ring_sides).
