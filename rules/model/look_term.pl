:- module(sg_look_term,
          [ is_look/1,                  % @Property
            is_light/1,                 % @Property
            look_expected/2,            % @Property, -Expected
            property_slot/2             % +Property, -Slot
          ]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module(library(apply), [maplist/2]).
/** <module> The properties that look/2 and light/2 may have.

    look(S, colour(C))           C a name of colour.pl, or rgb(R,G,B)
    look(S, opacity(A))          0, clear, to 1, opaque
    look(S, shine(F,N))          white light that it throws back: F, 0 to 1, as
                                 strong as a light, and the higher N, 1 to 1000,
                                 the sharper
    look(S, face(F, Property))   one of these, of the faces F alone, as in
                                 face_of/3; curved(Part) is a curved face
    light(N, picture(X,Y,Z))     it comes from there in the picture: X to the
                                 right, Y up, Z towards the eye
    light(N, direction(X,Y,Z))   it goes this way, in the model
    light(N, strength(F))        0 to 10
*/

%!  is_look(@Property) is semidet.
%
%   True when Property is one of look/2.

is_look(Property) :-
    ground(Property),
    look_holds(Property),
    !.

look_holds(colour(Colour)) :-
    ( atom(Colour) ; Colour = rgb(_,_,_) ),
    colour_rgb(Colour, _).
look_holds(opacity(A)) :-
    part(A).
look_holds(shine(F,N)) :-
    part(F),
    integer(N),
    N >= 1,
    N =< 1000.

look_holds(face(Face, Property)) :-
    callable(Face),
    Property \= face(_, _),
    look_holds(Property).

part(X) :-
    number(X),
    X >= 0,
    X =< 1.

%!  is_light(@Property) is semidet.
%
%   True when Property is one of light/2.

is_light(Property) :-
    ground(Property),
    (   Property = strength(F)
    ->  number(F),
        F >= 0,
        F =< 10
    ;   way(Property, Numbers),
        maplist(coordinate, Numbers),
        \+ maplist(=:=(0), Numbers)
    ).

way(picture(X,Y,Z), [X,Y,Z]).
way(direction(X,Y,Z), [X,Y,Z]).

coordinate(X) :-
    number(X),
    X =< 1.0e90,
    X >= -1.0e90.

%!  look_expected(@Property, -Expected) is det.
%
%   Expected says in a message what should stand where Property stands:
%   `colour`, `opacity`, `shine`, `strength`, `way` or `any`.

look_expected(Property, Expected) :-
    nonvar(Property),
    expected(Property, Expected0),
    !,
    Expected = Expected0.
look_expected(_, any).

expected(colour(_), colour).
expected(opacity(_), opacity).
expected(shine(_,_), shine).
expected(face(_,Property), Expected) :-
    nonvar(Property),
    expected(Property, Expected).
expected(strength(_), strength).
expected(Property, way) :-
    way(Property, _).

%!  property_slot(+Property, -Slot) is det.
%
%   Of the properties with one Slot a segment, or a light, has one.

property_slot(Property, Slot) :-
    (   way(Property, _)
    ->  Slot = direction
    ;   Property = face(Face,Own)
    ->  Slot = face(Face,OwnSlot),
        property_slot(Own, OwnSlot)
    ;   functor(Property, Slot, _)
    ).
