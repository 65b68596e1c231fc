:- module(sg_dxf_colour,
          [ dxf_colour/2                % +RGB, -Number
          ]).
:- use_module(library(lists), [nth0/3]).
/** <module> The numbers of colours in DXF.

DXF R12 knows 255 colours by their number, as pens: 1 to 9 have names, 10 to
249 are 24 hues in five degrees of brightness, each pure and half as pure, and
the rest is grey.
*/

%!  dxf_colour(+RGB, -Number) is det.
%
%   Number is the colour nearest to RGB. Black and white are 7: CAD programs
%   draw it in whichever of them can be seen.

dxf_colour(rgb(0,0,0), 7) :-
    !.
dxf_colour(rgb(255,255,255), 7) :-
    !.
dxf_colour(RGB, Number) :-
    findall(Way-Number0,
            ( known_colour(Number0, Other),
              way(RGB, Other, Way)
            ),
            Ways),
    msort(Ways, [_-Number|_]).

way(rgb(R1,G1,B1), rgb(R2,G2,B2), Way) :-
    Way is (R1-R2)**2 + (G1-G2)**2 + (B1-B2)**2.

known_colour(1, rgb(255,0,0)).
known_colour(2, rgb(255,255,0)).
known_colour(3, rgb(0,255,0)).
known_colour(4, rgb(0,255,255)).
known_colour(5, rgb(0,0,255)).
known_colour(6, rgb(255,0,255)).
known_colour(8, rgb(128,128,128)).
known_colour(9, rgb(192,192,192)).
known_colour(Number, RGB) :-
    between(10, 249, Number),
    Hue is 15*(Number//10-1),
    Step is Number mod 10,
    Place is Step//2,
    nth0(Place, [255,165,127,76,38], Bright),
    Pure is 1.0/(1 + Step mod 2),
    hue_rgb(Hue, Bright, Pure, RGB).
known_colour(Number, rgb(N,N,N)) :-
    between(250, 255, Number),
    N is 51*(Number-250).

%   Red, green and blue each have their place on the circle of hues.

hue_rgb(Hue, Bright, Pure, rgb(R,G,B)) :-
    part(Hue, 0, Bright, Pure, R),
    part(Hue, 120, Bright, Pure, G),
    part(Hue, 240, Bright, Pure, B).

part(Hue, Place, Bright, Pure, Part) :-
    Way0 is abs(Hue-Place),
    Way is min(Way0, 360-Way0),
    Share is max(0.0, min(1.0, (120-Way)/60.0)),
    Part is round(Bright*(1-Pure*(1-Share))).
