:- module(sg_pixel_colour,
          [ pixel_colour/4,             % +X, +Y, +Parts, -Colour
            pixels_decided/3            % :Row, +Background, +Image
          ]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../decision', [decision/2]).
:- use_module('../kernel',
              [image_dot/4, image_row/3, image_size/3, light_srgb/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
/** <module> Which colour a dot of a shaded picture has (CB-8).

The kernel adds up what the faces in a dot send. Where a rule decides, it is
asked of each dot instead, and the kernel says what is in it.
*/

:- decision(pixel_colour/4, "Which colour a dot of a shaded picture has").

%!  pixel_colour(+X, +Y, +Parts:list, -Colour) is semidet.
%
%   True when the dot X of row Y, counted from 0 from the upper left, has this
%   Colour: rgb(R,G,B) in bytes, a name of colour.pl, or light(R,G,B), linear.
%   Parts are part(R, S, Face, Share, light(R,G,B)): Share of the dot, 0 to 1,
%   shows this Face, as in face_of/3, of segment S (0: of none), a leaf of root
%   R, and that face sends that light there; the background, if it shows, comes
%   last, as part(0, 0, background, Share, Light). A decision; by default, and
%   where a rule has no answer, the sum. Rules make a picture slow.

pixel_colour(_, _, Parts, light(R,G,B)) :-
    foldl(part_added, Parts, light(0.0,0.0,0.0), Sum),
    Sum = light(R0,G0,B0),
    maplist(whole_light, [R0,G0,B0], [R,G,B]).

part_added(part(_,_,_,Share,light(R1,G1,B1)), light(R0,G0,B0), light(R,G,B)) :-
    R is R0 + Share*R1,
    G is G0 + Share*G1,
    B is B0 + Share*B1.

whole_light(X0, X) :-
    X is max(0, min(65535, round(X0))).

%!  pixels_decided(:Row, +Background, +Image) is det.
%
%   Each dot of Image gets the colour that pixel_colour/4 says; where it says
%   none, it stays. call(Row, Y, Parts) has the parts of row Y as
%   dot(X, Part), by X, what shows the Background, a light(R,G,B), apart.

:- meta_predicate pixels_decided(2, +, +).

pixels_decided(Row, Background, Image) :-
    image_size(Image, Width, Height),
    Last is Height-1,
    forall(between(0, Last, Y),
           ( call(Row, Y, Parts),
             row_dots(0, Width, Y, Parts, Background, Image, Dots),
             image_row(Image, Y, Dots) )).

row_dots(Width, Width, _, _, _, _, []) :-
    !.
row_dots(X, Width, Y, Parts0, Background, Image, [Dot|Dots]) :-
    own_parts(Parts0, X, 1.0, Background, Own, Parts),
    (   pixel_colour(X, Y, Own, Colour),
        colour_dot(Colour, Dot0)
    ->  Dot = Dot0
    ;   image_dot(Image, X, Y, [R,G,B]),
        Dot = rgb(R,G,B)
    ),
    X1 is X+1,
    row_dots(X1, Width, Y, Parts, Background, Image, Dots).

%   own_parts(Parts0, X, Left, Background, Own, Parts): those of dot X; what is
%   Left is the background.

own_parts([dot(X,Part)|Parts0], X, Left0, Background, [Part|Own], Parts) :-
    !,
    arg(4, Part, Share),
    Left is Left0-Share,
    own_parts(Parts0, X, Left, Background, Own, Parts).
own_parts(Parts, _, Left, Background, Own, Parts) :-
    (   Left > 2.0** -20
    ->  Own = [part(0,0,background,Left,Background)]
    ;   Own = []
    ).

colour_dot(Colour, Dot) :-
    nonvar(Colour),
    (   Colour = light(_,_,_)
    ->  Colour =.. [_|Lights],
        maplist(light_srgb, Lights, Bytes),
        Dot =.. [rgb|Bytes]
    ;   ( atom(Colour) ; Colour = rgb(_,_,_), ground(Colour) ),
        colour_rgb(Colour, Dot)
    ).
