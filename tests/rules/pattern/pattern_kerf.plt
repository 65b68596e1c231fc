:- module(test_pattern_kerf, []).
% covers: pattern_yield
:- use_module(library(aggregate)).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(pattern/pattern_yield)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

/* Outlines that allow for the kerf, against closed forms of their areas. */

drawn(Term, Options, Drawings) :-
    new_world(World),
    in_world(World, ( add_primitive(Term, S), complete_segments,
                      develop(S, D),
                      pattern_drawing([D], Options, Drawings) )).

area(Term, Options, Area) :-
    drawn(Term, Options, Drawings),
    pattern_yield(Drawings, Yield),
    Area = Yield.piece_area.

%   The sides that are cut are those of edge E, 0 if of none.

side_of(Drawings, E, [A,B]) :-
    member(drawing(_,Views), Drawings),
    member(view(_,Strokes,_), Views),
    member(stroke(_,cut,_,Es,Points,ring,_), Strokes),
    nth1(I, Es, E),
    nth1(I, Points, A),
    I1 is I+1,
    nth1(I1, Points, B).

%   The rings that are cut, by how many corners they have.

corners(Drawings, Ns) :-
    findall(N,
            ( member(drawing(_,Views), Drawings),
              member(view(_,Strokes,_), Views),
              member(stroke(_,cut,_,Es,Points,ring,_), Strokes),
              length(Points, N1), N is N1-1, length(Es, N) ),
            Ns).

:- begin_tests(pattern_kerf).

% Square corners: the area grows by the outline times half of the kerf, and for
% each of four corners more outwards than inwards by its square.
test(cube, [forall(member(K, [0,0.2,1,3])), true(abs(Area-Wanted) < 0.1)]) :-
    area(box(size(20,20,20)), [kerf(K)], Area),
    Wanted is 6*400 + 14*20*K/2 + 4*(K/2)**2.
% A hole grows smaller.
test(hole, true(abs(With-Without-Wanted) < 0.1)) :-
    Prism = prism(outline([[0,0],[40,0],[40,40],[0,40]]),
                  holes([[[10,10],[20,10],[20,20],[10,20]]]), height(5)),
    area(Prism, [kerf(0)], Without),
    area(Prism, [kerf(1)], With),
    drawn(Prism, [kerf(0)], Drawings),
    perimeter(Drawings, Length, Turns),
    Wanted is Length*0.5 + Turns*0.25.
% A point sharper than 29 degrees is cut off half a kerf before it.
test(sharp, Ns-Cut == [4]-1) :-
    drawn(sheet(points([[0,0,0],[100,-5,0],[100,5,0]]), faces([[1,2,3]])),
          [kerf(2)], Drawings),
    corners(Drawings, Ns),
    aggregate_all(count, side_of(Drawings, 0, _), Cut).
% A step of 0.03 mm between sides that are not parallel goes: the beam is too
% wide for it; the rest is as without it, but for less than the step.
test(step, true(abs(Area-Wanted) < 40*0.03 + 0.1)) :-
    area(sheet(points([ [0,0,0],[40,0,0],[40,30,0],[20,20,0],[20.0,20.03,0],
                        [0,30,0] ]),
               faces([[1,2,3,4,5,6]])), [kerf(0.4)], Area),
    area(sheet(points([[0,0,0],[40,0,0],[40,30,0],[20,20.015,0],[0,30,0]]),
               faces([[1,2,3,4,5]])), [kerf(0.4)], Wanted).
test(too_wide, error(usage_error(pattern(kerf(12,_))))) :-
    drawn(prism(outline([[0,0],[40,0],[40,40],[0,40]]),
                holes([[[10,10],[20,10],[20,20],[10,20]]]), height(5)),
          [kerf(12)], _).
test(slot_too_narrow, error(usage_error(pattern(kerf(3,_))))) :-
    drawn(prism(outline([[0,0],[40,0],[40,40],[21,40],[21,10],[19,10],[19,40],
                         [0,40]]), height(5)),
          [kerf(3),numbers(false)], _).
test(yield, true(abs(Yield-2400/(297*210)) < 1.0e-9)) :-
    drawn(box(size(20,20,20)), [page('A4-landscape')], Drawings),
    pattern_yield(Drawings, Measures),
    Yield = Measures.yield.

%   perimeter(Drawings, Length, Turns): of all rings; corners outwards less
%   those inwards.

perimeter(Drawings, Length, Turns) :-
    findall(L-4,
            ( member(drawing(_,Views), Drawings),
              member(view(_,Strokes,_), Views),
              member(stroke(_,cut,_,_,Points,ring,_), Strokes),
              ring_length(Points, L) ),
            Rings),
    findall(L, member(L-_, Rings), Ls),
    sum_list(Ls, Length),
    length(Rings, N),
    holes(Drawings, Holes),
    Turns is 4*(N-2*Holes).

holes(Drawings, N) :-
    drawn_rings(Drawings, Rings),
    findall(x, ( member(Ring, Rings), signed(Ring, A), A > 0 ), Xs),
    length(Xs, N).

drawn_rings(Drawings, Rings) :-
    findall(Points,
            ( member(drawing(_,Views), Drawings),
              member(view(_,Strokes,_), Views),
              member(stroke(_,cut,_,_,Points,ring,_), Strokes) ),
            Rings).

signed([_], 0).
signed([XA-YA,XB-YB|Points], Area) :-
    signed([XB-YB|Points], Area1),
    Area is Area1 + XA*YB - XB*YA.

ring_length([_], 0).
ring_length([XA-YA,XB-YB|Points], Length) :-
    ring_length([XB-YB|Points], Length1),
    Length is Length1 + sqrt((XB-XA)**2 + (YB-YA)**2)/1000.

:- end_tests(pattern_kerf).
