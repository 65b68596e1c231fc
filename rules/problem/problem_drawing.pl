:- module(sg_problem_drawing,
          [ question_drawing/2,         % +Request, -Drawing
            answer_drawing/4            % +Request, +Generators, +Points,
                                        % -Drawing
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../near', [is_on_surface/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../sheet/sheet_plan', [seen_drawing/3]).
:- use_module('../sheet/sheet_view', [view_axes/4, view_seen/5]).
:- use_module('../store',
              [segment/3, unfolding/2, facts_snapshot/1, retractall_facts/1]).
:- use_module('../vector', [dot_product/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2]).
/** <module> What a pupil gets, and what the teacher has.

The question shows each body as if it were alone: where another one hides it, or
where a line ends at another one, would tell where they meet. The answer shows
the bodies as they are, with what was to be constructed: the points, numbered,
the generators they lie on and the lines from view to view, all of them light.
*/

%!  question_drawing(+Request, -Drawing) is det.
%
%   Drawing shows the segments of the world, which have not been cut. Request as
%   in sheet_plan.pl, and mark(Texts): a list of X-Y-Height-Text on the sheet,
%   in millimetres, y down.

question_drawing(Request, Drawing) :-
    option(views(Views), Request),
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    maplist(seen_apart(Ss), Views, Seens),
    seen_drawing([construction([])|Request], Seens, Drawing).

seen_apart(Ss, View, seen(View,Parts,[])) :-
    findall(Own,
            ( member(S, Ss),
              facts_snapshot(sg_problem_drawing:seen_alone(S, Ss, View, Own)) ),
            Lists),
    append(Lists, Parts).

seen_alone(S, Ss, View, Parts) :-
    forall(( member(Other, Ss), Other \== S ), dropped(Other)),
    view_seen(View, [], true, [], seen(_,Parts,_)).

dropped(S) :-
    retractall_facts(unfolding(S, _)),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

%!  answer_drawing(+Request, +Generators, +Points, -Drawing) is det.
%
%   Drawing shows them with the lines in which they meet, and construction lines
%   of problem_point.pl.

answer_drawing(Request, Generators, Points, Drawing) :-
    option(views(Views), Request),
    facts_snapshot(( penetrate(all, []),
                     maplist(seen_whole, Views, Seens) )),
    findall(Item, construction(Views, Generators, Points, Item), Items),
    seen_drawing([construction(Items)|Request], Seens, Drawing).

seen_whole(View, Seen) :-
    view_seen(View, [], true, [], Seen).

%   construction(Views, Generators, Points, Item) is nondet: see seen_drawing/3.

construction(Views, Generators, Points, line(Name, [P,Q])) :-
    member(View, Views),
    square(View, Name),
    member(generator(_, T, From, To), Generators),
    once(member(point(_, _, T, _), Points)),
    projected(View, From, P),
    projected(View, To, Q).
construction(Views, _, Points, between(Name1, P, Name2, Q)) :-
    append(_, [View1|Others], Views),
    square(View1, Name1),
    Name1 == front,
    member(View2, Others),
    square(View2, Name2),
    member(point(_, _, _, Place), Points),
    projected(View1, Place, P),
    projected(View2, Place, Q).
construction(Views, _, Points, dot(Name, P, Text)) :-
    member(View, Views),
    square(View, Name),
    member(point(_, _, _, Place), Points),
    projected(View, Place, P),
    findall(I,
            ( member(point(I, _, _, Other), Points),
              projected(View, Other, Q),
              in_one_place(P, Q) ),
            Is),
    Is = [_|_],
    first_there(Points, View, P, Place),
    atomic_list_concat(Is, ',', Text).

square(view(Name, _, _, side), Name).

projected(View, Place, X-Y) :-
    view_axes(View, [A1,A2,A3], [B1,B2,B3], _),
    dot_product(p(A1,A2,A3), Place, X),
    dot_product(p(B1,B2,B3), Place, Y).

in_one_place(X1-Y1, X2-Y2) :-
    is_on_surface(abs(X1-X2) + abs(Y1-Y2), 1.0+abs(X1)+abs(Y1)).

%   first_there(Points, View, P, Place): of those seen in one place, one is
%   drawn.

first_there(Points, View, P, Place) :-
    member(point(_, _, _, First), Points),
    projected(View, First, Q),
    in_one_place(P, Q),
    !,
    First == Place.
