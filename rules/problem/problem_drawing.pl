:- module(sg_problem_drawing,
          [ question_drawing/3,         % +Request, +Letters, -Drawing
            answer_drawing/6            % +Request, +Generators, +Planes,
                                        % +Points, +Letters, -Drawing
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../near', [is_on_surface/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../sheet/sheet_plan', [seen_drawing/3]).
:- use_module('../sheet/sheet_view',
              [view_axes/4, view_centres/3, view_seen/4]).
:- use_module('../store',
              [segment/3, unfolding/2, facts_snapshot/1, retractall_facts/1]).
:- use_module('../vector', [dot_product/3]).
:- use_module(library(apply), [exclude/3, maplist/3, partition/4]).
:- use_module(library(lists),
              [append/2, append/3, last/2, list_to_set/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> What a pupil gets, and what the teacher has.

The question shows each body as if it were alone: where another one hides it, or
where a line ends at another one, would tell where they meet. The answer shows
the bodies as they are, with what was to be constructed: the points, numbered,
the generators they lie on and the lines from view to view, all of them light.
*/

%!  question_drawing(+Request, +Letters, -Drawing) is det.
%
%   Drawing shows the segments of the world, which have not been cut: each as if
%   it were alone, but as they meet in the views that the option met(Names) of
%   Request names. Request as for seen_drawing/3, with language(_); Letters is a
%   list of letter(Text, P, Names): point P, p(X,Y,Z), is so marked in the views
%   Names, or in `all`.

question_drawing(Request, Letters, Drawing) :-
    option(views(Views), Request),
    seen_views(Request, Seens),
    findall(Text-P-Names, member(letter(Text,P,Names), Letters), Marks),
    dots(Views, Marks, Dots),
    seen_drawing([construction(Dots)|Request], Seens, Drawing).

%   seen_views(Request, Seens): what each view shows.

seen_views(Request, Seens) :-
    option(views(Views), Request),
    option(met(Met), Request, []),
    option(picture(Picture), Request),
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    partition(named_in(Met), Views, Whole, Apart),
    maplist(seen_apart(Ss, Picture), Apart, SeenApart),
    (   Whole == []
    ->  SeenWhole = []
    ;   facts_snapshot(( penetrate(all, []),
                         maplist(seen_whole(Picture), Whole, SeenWhole) ))
    ),
    append(SeenApart, SeenWhole, Unordered),
    maplist(seen_of(Unordered), Views, Seens).

named_in(Names, view(Name,_,_,_)) :-
    memberchk(Name, Names).

seen_of(Seens, View, Seen) :-
    Seen = seen(View,_,_,_),
    memberchk(Seen, Seens).

seen_apart(Ss, Picture, View, seen(View,Parts,[],Centres)) :-
    view_centres(View, Picture, Centres),
    findall(Own,
            ( member(S, Ss),
              facts_snapshot(sg_problem_drawing:seen_alone(S, Ss, Picture,
                                                           View, Own)) ),
            Lists),
    append(Lists, Parts).

seen_alone(S, Ss, Picture, View, Parts) :-
    forall(( member(Other, Ss), Other \== S ), dropped(Other)),
    view_seen(View, [], Picture, seen(_,Parts,_,_)).

dropped(S) :-
    retractall_facts(unfolding(S, _)),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

%!  answer_drawing(+Request, +Generators, +Planes, +Points, +Letters,
%!                 -Drawing) is det.
%
%   Drawing shows them as question_drawing/3 does, and construction lines of
%   problem_point.pl and problem_plane.pl.

answer_drawing(Request, Generators, Planes, Points, Letters, Drawing) :-
    option(views(Views), Request),
    seen_views(Request, Seens),
    findall(Item,
            ( construction(Views, Generators, Points, Item)
            ; plane_line(Views, Planes, Item)
            ),
            Items0),
    findall(Text-P-all,
            ( member(letter(Text,P,_), Letters)
            ; member(point(Text,_,_,P), Points)
            ),
            Marks),
    dots(Views, Marks, Dots),
    exclude(along_centre(Seens), Items0, Items1),
    append(Items1, Dots, Items),
    seen_drawing([construction(Items)|Request], Seens, Drawing).

%   along_centre(Seens, Item): a light line is not seen on a centre line, and
%   would fill its gaps.

along_centre(Seens, line(Name, [P,Q])) :-
    member(seen(view(Name,_,_,_),_,_,Centres), Seens),
    member(centre([A,B],joint), Centres),
    (   lies_on(P-Q, A-B)
    ;   lies_on(A-B, P-Q)
    ),
    !.

seen_whole(Picture, View, Seen) :-
    view_seen(View, [], Picture, Seen).

%   construction(Views, Generators, Points, Item) is nondet: generators, and
%   lines from view to view; see seen_drawing/3.

construction(Views, Generators, _, line(Name, [P,Q])) :-
    member(View, Views),
    square(View, Name),
    member(generator(_, _, From, To), Generators),
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
%   plane_line(Views, Planes, Item) is nondet: a plane is seen as a line, or
%   what it cuts is seen as it is.

plane_line(Views, Planes, line(Name, Points)) :-
    member(View, Views),
    square(View, Name),
    member(plane(Axis, _, Sections), Planes),
    unit_vector(Axis, Normal),
    projected(View, Normal, Seen),
    (   in_one_place(Seen, 0.0-0.0)
    ->  member(Section, Sections),
        maplist(projected(View), Section, Points)
    ;   Seen = U0-V0,
        U is abs(V0),
        V is abs(U0),
        findall(At-P,
                ( member(Section, Sections),
                  member(Place, Section),
                  projected(View, Place, P),
                  P = X-Y,
                  At is X*U + Y*V ),
                Ends0),
        keysort(Ends0, Ends),
        Ends = [_-(XA-YA)|_],
        last(Ends, _-(XB-YB)),
        plane_beyond(By),
        XP is XA-By*U, YP is YA-By*V,
        XQ is XB+By*U, YQ is YB+By*V,
        Points = [XP-YP,XQ-YQ]
    ).

%   plane_beyond(By): so far beyond what it cuts a plane is drawn.

plane_beyond(5.0).

unit_vector(x, p(1.0,0.0,0.0)).
unit_vector(y, p(0.0,1.0,0.0)).
unit_vector(z, p(0.0,0.0,1.0)).

square(view(Name, _, _, side), Name).

projected(View, Place, X-Y) :-
    view_axes(View, [A1,A2,A3], [B1,B2,B3], _),
    dot_product(p(A1,A2,A3), Place, X),
    dot_product(p(B1,B2,B3), Place, Y).

in_one_place(X1-Y1, X2-Y2) :-
    is_on_surface(abs(X1-X2) + abs(Y1-Y2), 1.0+abs(X1)+abs(Y1)).

%   dots(Views, Marks, Dots): Marks are Text-P-Names; of those that are seen in
%   one place of a view, one dot has all texts.

dots(Views, Marks, Dots) :-
    findall(dot(Name, Q, Text),
            ( member(View, Views),
              square(View, Name),
              findall(Own-Q0,
                      ( member(Own-P-Names, Marks),
                        marked_in(Name, Names),
                        projected(View, P, Q0) ),
                      Seen),
              one_place(Seen, Q, Texts),
              atomic_list_concat(Texts, ',', Text) ),
            Dots).

marked_in(Name, Names) :-
    (   Names == all
    ->  true
    ;   memberchk(Name, Names)
    ).

one_place(Seen, Q, Texts) :-
    append(Before, [_-Q|_], Seen),
    \+ ( member(_-Other, Before), in_one_place(Other, Q) ),
    findall(Text, ( member(Text-Other, Seen), in_one_place(Other, Q) ),
            Texts0),
    list_to_set(Texts0, Texts).

%   lies_on(P-Q, A-B): both ends lie on the line from A to B.

lies_on(P-Q, Line) :-
    on_line(P, Line),
    on_line(Q, Line).

on_line(X-Y, (X1-Y1)-(X2-Y2)) :-
    DX is X2-X1,
    DY is Y2-Y1,
    Length is sqrt(DX*DX + DY*DY),
    Length > 0.0,
    Size is 1.0 + abs(X) + abs(Y),
    is_on_surface(((X-X1)*DY - (Y-Y1)*DX)/Length, Size),
    Along is ((X-X1)*DX + (Y-Y1)*DY)/Length,
    ( Along >= 0.0 ; is_on_surface(Along, Size) ),
    ( Along =< Length ; is_on_surface(Along-Length, Size) ),
    !.
