:- module(sg_surface_ramp,
          [ ramp/3,                     % +Look, +Tone, -Colour
            look_ramp/2,                % +Look, -Ramp
            ramp_step/3                 % +Ramp, +K, -Light
          ]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../kernel', [srgb_light/2]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [nth0/3]).
/** <module> Which colour a tone has (CB-8).

    lambert     the colour's light times the tone
    gooch       from a cold tint of the colour to a warm one
    cel(N)      N flat steps of lambert
    zebra(N)    N dark stripes: lines on which they lie are isophotes
    flat        the colour
    xray        the colour, darker where it is seen edge-on

@see A. Gooch, B. Gooch, P. Shirley, E. Cohen, A non-photorealistic lighting
model for automatic technical illustration, SIGGRAPH 1998
*/

:- decision(ramp/3, "Which colour a tone of a look has").

%!  ramp(+Look, +Tone, -Colour) is semidet.
%
%   True when Tone, 0 to 1, of Look, as for tone/3, is seen in Colour: rgb(R,
%   G, B) in bytes, a name of colour.pl, or light(R, G, B), linear, whole
%   numbers from 0 to 65535. A decision, asked of 1,025 tones of each look.

ramp(Look, Tone, Colour) :-
    memberchk(shade(Shade), Look),
    memberchk(colour(Colour0), Look),
    colour_light(Colour0, Light),
    shaded(Shade, Tone, Light, Colour).

shaded(lambert, Tone, Light, Colour) :-
    light_times(Tone, Light, Colour).
shaded(flat, _, Light, Light).
shaded(xray, Tone, Light, Colour) :-
    Factor is 1 - 0.85*Tone*Tone,
    light_times(Factor, Light, Colour).
shaded(cel(N), Tone, Light, Colour) :-
    Step is (min(floor(Tone*N), N-1) + 1) / N,
    light_times(Step, Light, Colour).
shaded(zebra(N), Tone, Light, Colour) :-
    (   truncate(min(Tone, 0.999999)*2*N) mod 2 =:= 0
    ->  light_times(0.12, Light, Colour)
    ;   Colour = Light
    ).
shaded(gooch, Tone, light(R,G,B), light(R1,G1,B1)) :-
    gooch(Tone, R, 0, 23592, R1),
    gooch(Tone, G, 0, 19660, G1),
    gooch(Tone, B, 26214, 0, B1).

%   Cold: 0.35 of the colour and blue; warm: 0.64 of it and yellow.

gooch(Tone, Light, Cold, Warm, Out) :-
    Out is min(65535, round((1-Tone)*(0.35*Light+Cold)
                            + Tone*(0.64*Light+Warm))).

light_times(Factor, light(R0,G0,B0), light(R,G,B)) :-
    R is round(Factor*R0),
    G is round(Factor*G0),
    B is round(Factor*B0).

%   colour_light(Colour, Light): fails of what is no colour.

colour_light(light(R,G,B), Light) :-
    !,
    maplist(kept_light, [R,G,B], [R1,G1,B1]),
    Light = light(R1,G1,B1).
colour_light(Colour, light(R,G,B)) :-
    ( atom(Colour) ; Colour = rgb(_,_,_), ground(Colour) ),
    colour_rgb(Colour, rgb(R0,G0,B0)),
    !,
    maplist(srgb_light, [R0,G0,B0], [R,G,B]).

kept_light(X0, X) :-
    number(X0),
    X is max(0, min(65535, round(X0))).

%!  look_ramp(+Look, -Ramp) is det.
%
%   Ramp is that of image_shade/5. A tone for which a rule has no colour is
%   black.

look_ramp(Look, [First,Last]) :-
    decision_is_default(ramp/3),
    memberchk(shade(Shade), Look),
    memberchk(Shade, [lambert,flat]),   % straight
    !,
    ramp_light(Look, 0.0, First),
    ramp_light(Look, 1.0, Last).
look_ramp(Look, Ramp) :-
    findall(Light,
            ( between(0, 1024, K), Tone is K/1024.0,
              ramp_light(Look, Tone, Light) ),
            Ramp).

%!  ramp_step(+Ramp, +K, -Light) is det.
%
%   Light is that of the tone K/1024 on Ramp.

ramp_step([light(R0,G0,B0),light(R1,G1,B1)], K, light(R,G,B)) :-
    !,
    maplist(between_lights(K), [R0,G0,B0], [R1,G1,B1], [R,G,B]).
ramp_step(Ramp, K, Light) :-
    nth0(K, Ramp, Light).

between_lights(K, A, B, C) :-
    C is (A*(1024-K) + B*K + 512) // 1024.

ramp_light(Look, Tone, Light) :-
    (   ramp(Look, Tone, Colour),
        nonvar(Colour),
        colour_light(Colour, Light0)
    ->  Light = Light0
    ;   Light = light(0,0,0)
    ).
