:- module(test_centre_line, []).
:- use_module(library(plunit)).
:- use_module(rules(csg/csg_roots), [roots_alone/0]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(sheet/centre_line)).
:- use_module(rules(sheet/sheet_view),
              [view_axes/4, view_centres/3, view_named/2]).
:- use_module(rules(store)).
:- use_module(tests('rules/sheet/sheet_of'), [sheet_of/3]).

% Straight lines, their ends in order and rounded to 1e-6; others as
% curve(N, End) of N points.
seen_centres(Term, Name, Seen) :-
    with_model(Term, centres(Name, Lines)),
    findall(Line, ( member(Line0, Lines), plain(Line0, Line) ), Seen0),
    msort(Seen0, Seen).

centres(Name, Lines) :-
    view_named(Name, View),
    view_axes(View, Right, Up, Away),
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    centre_lines(axes(Right,Up,Away), Ss, Lines).

:- meta_predicate with_model(+, 0).

with_model(Term, Goal) :-
    model_file(Term, File),
    new_world(World),
    in_world(World, ( load_model(File), roots_alone, once(Goal) )).

model_file(Term, File) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    format(Out, '~q.~n', [segment(1, solid, Term)]),
    close(Out).

plain(centre([P0,Q0],joint), line(P,Q)) :-
    !,
    maplist(near, [P0,Q0], Ends0),
    msort(Ends0, [P,Q]).
plain(centre(Points,End), curve(N,End)) :-
    length(Points, N).

near(X0-Y0, X-Y) :-
    X is round(X0*1 000 000)/1 000 000 + 0.0,
    Y is round(Y0*1 000 000)/1 000 000 + 0.0.

holes(Angles, D, Term) :-
    findall(at([translate(D,0,-1),rotate(z,Angle)],
               cylinder(radius(1),height(4),facets(16))),
            member(Angle, Angles), Holes),
    Term = difference([cylinder(radius(9),height(2),facets(32))|Holes]).

:- begin_tests(centre_line).

test(axis, Seen == [line(0.0-0.0,0.0-5.0)]) :-
    seen_centres(cylinder(radius(2),height(5),facets(12)), front, Seen).
test(cross, Seen == [line(-2.0-0.0,2.0-0.0),line(0.0-(-2.0),0.0-2.0)]) :-
    seen_centres(cylinder(radius(2),height(5),facets(12)), top, Seen).
test(ellipse, Seen == [line(-3.0-0.0,3.0-0.0),line(0.0-(-1.0),0.0-1.0)]) :-
    seen_centres(cylinder(radius(3.0,1.0),height(5),facets(12)), top, Seen).
test(cone, Seen == [line(-2.0-0.0,2.0-0.0),line(0.0-(-2.0),0.0-2.0)]) :-
    seen_centres(cone(radius(1),top(2),height(5),facets(12)), top, Seen).
test(sphere, Seen == [line(-2.0-2.0,2.0-2.0),line(0.0-0.0,0.0-4.0)]) :-
    seen_centres(at([translate(0,0,2)], sphere(radius(2),facets(12))), right,
                 Seen).

% A nut is a prism.
test(nut, Seen == []) :-
    seen_centres(cylinder(radius(2),height(5),facets(6)), top, Seen).

% What leans is seen as a line from all sides; its ends are those of its axis.
test(leaning, [forall(between(1, 60, _))]) :-
    maplist([A]>>(A is random_float*160+10), [AX,AY,AZ]),
    maplist([D]>>(D is random_float*100-50), [DX,DY,DZ]),
    Place = [rotate(x,AX),rotate(y,AY),rotate(z,AZ),translate(DX,DY,DZ)],
    Term = at(Place, cylinder(radius(2),height(5),facets(12))),
    Ends = at(Place, line(from(0,0,0),to(0,0,5))),
    random_member(Name, [front,top,right,left,back,bottom]),
    seen_centres(Term, Name, Seen),
    model_ends(Ends, Name, P, Q),
    maplist(near, [P,Q], Line0),
    msort(Line0, Line),
    Seen = [line(A1,A2)],
    maplist(same_place, [A1,A2], Line).

same_place(X1-Y1, X2-Y2) :-
    abs(X1-X2) < 1.0e-5,
    abs(Y1-Y2) < 1.0e-5.

model_ends(Term, Name, P, Q) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    format(Out, '~q.~n', [segment(1, curve, Term)]),
    close(Out),
    new_world(World),
    in_world(World,
             ( load_model(File),
               view_named(Name, View),
               view_axes(View, Right, Up, _),
               findall(X-Y, ( v(1, _, A, B, C),
                              along(Right, A, B, C, X),
                              along(Up, A, B, C, Y) ), [P,Q]) )).

along([A1,A2,A3], X, Y, Z, At) :-
    At is A1*X + A2*Y + A3*Z.

% Bore, collar and cone on one axis are one line.
test(coaxial, Seen == [line(0.0-0.0,0.0-9.0)]) :-
    seen_centres(difference(
                     [ union([ cylinder(radius(4),height(3),facets(12)),
                               at([translate(0,0,3)],
                                  cylinder(radius(2),height(2),facets(12))),
                               at([translate(0,0,5)],
                                  cone(radius(2),height(4),facets(12))) ]),
                       at([translate(0,0,-1)],
                          cylinder(radius(1),height(3),facets(12))) ]),
                 front, Seen).

% Half round has one, a rounded corner none.
test(half, Seen == [line(0.0-0.0,0.0-5.0)]) :-
    seen_centres(intersection([ cylinder(radius(2),height(5),facets(16)),
                                at([translate(0,2,0)], box(size(4,4,5))) ]),
                 front, Seen).
test(quarter, Seen == []) :-
    seen_centres(intersection([ cylinder(radius(2),height(5),facets(16)),
                                at([translate(2,2,0)], box(size(4,4,5))) ]),
                 front, Seen).

test(torus_above, Seen == [ line(-4.0-0.0,4.0-0.0),line(0.0-(-4.0),0.0-4.0),
                            curve(121,ring) ]) :-
    seen_centres(torus(radius(3),tube(1),facets(16),sides(12)), top, Seen0),
    partition([curve(_,_)]>>true, Seen0, Curves, Lines),
    append(Lines, Curves, Seen).
test(torus_front, Seen == [line(-4.0-0.0,4.0-0.0),line(0.0-(-1.0),0.0-1.0)]) :-
    seen_centres(torus(radius(3),tube(1),facets(16),sides(12)), front, Seen).
% The bend of a pipe: an arc, a line from the side.
test(bend, Seen == [curve(31,joint)]) :-
    bend(Bend),
    seen_centres(Bend, top, Seen).
test(bend_beside, Seen == [line(0.0-0.0,3.0-0.0)]) :-
    bend(Bend),
    seen_centres(Bend, front, Seen).

bend(intersection([ torus(radius(3),tube(1),facets(16),sides(12)),
                    at([translate(5,5,-5)], box(size(10,10,10))) ])).

% Six holes in even steps: their circle, a line towards its middle each, and
% the cross of the plate.
test(pitch, Curves-N == [curve(121,ring)]-6) :-
    holes([0,60,120,180,240,300], 6, Term),
    seen_centres(Term, top, Seen),
    partition([curve(_,_)]>>true, Seen, Curves, Lines),
    length(Lines, N),                   % two of six lie on the cross
    memberchk(line(-9.0-0.0,9.0-0.0), Lines),
    memberchk(line(2.5-4.330127,3.5-6.062178), Lines).
% Elsewhere it is the same.
test(pitch_elsewhere, Curves-N == [curve(121,ring)]-6) :-
    holes([15,75,135,195,255,315], 6, Term),
    seen_centres(at([translate(20,-7,3)], Term), top, Seen),
    partition([curve(_,_)]>>true, Seen, Curves, Lines0),
    exclude([Line]>>memberchk(Line, [ line(11.0-(-7.0),29.0-(-7.0)),
                                      line(20.0-(-16.0),20.0-2.0) ]),
            Lines0, Lines),
    length(Lines, N).
test(uneven, Curves-N == []-8) :-
    holes([10,60,130], 6, Term),
    seen_centres(Term, top, Seen),
    partition([curve(_,_)]>>true, Seen, Curves, Lines),
    length(Lines, N).

test(which_views, Names == [front,top]) :-
    with_model(cylinder(radius(2),height(5),facets(12)),
               findall(Name,
                       ( member(Name, [front,top,isometric]),
                         view_named(Name, View),
                         view_centres(View, [lines(feature)], [_|_]) ),
                       Names)).
test(which_lines, How == [feature]) :-
    with_model(cylinder(radius(2),height(5),facets(12)),
               findall(Lines,
                       ( member(Lines, [feature,all,penetration]),
                         view_named(front, View),
                         view_centres(View, [lines(Lines)], [_|_]) ),
                       How)).

% On paper they reach 3 mm beyond, as whole lines, whose style has the dashes.
test(beyond, Lines == [[0-11000,0-0]]) :-
    model_file(cylinder(radius(2),height(5),facets(12)), File),
    sheet_of(File, [sheet(a4),views(front),scale('1:1')], drawing(_,Views)),
    memberchk(view(centre_lines,Strokes,[]), Views),
    findall([0-Low,0-0],
            ( member(stroke(visible,centre_line,0,[],[X-Y1,X-Y2],joint,joint),
                     Strokes),
              Low is abs(Y2-Y1) ),
            Lines).
% Where the plane of a section is shown there is a chain line already; the
% section, half a pipe, has its own.
test(section, N == 1) :-
    model_file(hollow_cylinder(radius(2),inner(1),height(5),facets(12)), File),
    sheet_of(File, [sheet(a4),views(top),section([y])], drawing(_,Views)),
    memberchk(view(centre_lines,Strokes,[]), Views),
    memberchk(view(top,Top,_), Views),
    findall(X, ( member(stroke(_,_,1,_,Ps,_,_), Top), member(X-_, Ps) ), Xs),
    sumlist(Xs, Sum),
    length(Xs, Count),
    Middle is Sum/Count,
    \+ ( member(stroke(_,_,_,_,[XA-Y,XB-Y],_,_), Strokes),
         min(XA,XB) < Middle, Middle < max(XA,XB) ),
    length(Strokes, Two),
    N is Two-1.

:- end_tests(centre_line).
