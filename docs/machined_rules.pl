/* What a tool made is orange, the rest as always; the light comes from the eye
   and from above, in five steps:

       sanggwan render facts/pipe_tee.pl --rules docs/machined_rules.pl -o tee.png
*/

:- use_module(library(lists), [member/2]).

surface_look(_, S, _, [colour(orange)]) :-
    machined(S).

machined(S) :-
    node(_, difference, [_|Tools], _),
    member(Tool, Tools),
    below(Tool, S).

below(S, S).
below(N, S) :-
    node(N, _, Children, _),
    member(Child, Children),
    integer(Child),
    below(Child, S).

tone(_, vector(_, Up, Towards), Tone) :-
    Tone is 0.6*Towards + 0.4*max(0, Up).

ramp(Look, Tone, Colour) :-
    Step is ceiling(5*Tone)/5,
    default(ramp(Look, Step, Colour)).
