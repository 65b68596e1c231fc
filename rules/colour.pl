:- module(sg_colour,
          [ colour_name/2,              % ?Name, ?RGB
            colour_rgb/2                % +Colour, -RGB
          ]).
/** <module> Colours: of lines, and of shaded solids.
*/

%!  colour_name(?Name, ?RGB) is nondet.
%
%   The colours that have names.

colour_name(black,   rgb(0,0,0)).
colour_name(white,   rgb(255,255,255)).
colour_name(grey,    rgb(128,128,128)).
colour_name(red,     rgb(170,0,0)).
colour_name(green,   rgb(0,110,40)).
colour_name(blue,    rgb(0,60,170)).
colour_name(cyan,    rgb(0,130,150)).
colour_name(magenta, rgb(150,0,120)).
colour_name(yellow,  rgb(250,210,0)).
colour_name(orange,  rgb(220,110,0)).
colour_name(brown,   rgb(110,60,20)).

%!  colour_rgb(+Colour, -RGB) is semidet.
%
%   True when Colour is a name or rgb(R,G,B), and RGB is it in bytes.

colour_rgb(rgb(R,G,B), RGB) =>
    byte(R),
    byte(G),
    byte(B),
    RGB = rgb(R,G,B).
colour_rgb(Name, RGB) =>
    atom(Name),
    colour_name(Name, RGB).

byte(N) :-
    integer(N),
    N >= 0,
    N =< 255.
