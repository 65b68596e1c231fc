:- module(sg_shading_words,
          [ shade_named/3,              % +Text, +Others, -Shade
            up_matrix/2                 % +Options, -Matrix
          ]).
:- use_module('../csg/csg_matrix', [identity_matrix/1]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(option), [option/3]).
/** <module> What options of `render` and `draw` say of shading.
*/

%!  shade_named(+Text, +Others, -Shade) is det.
%
%   Shade (surface_ramp.pl), or one of Others, is what Text of --shade says.
%
%   @error usage_error(bad_value('--shade', Text, Form))

shade_named(Text, Others, Shade) :-
    (   memberchk(Text, [lambert,gooch,flat,xray|Others])
    ->  Shade = Text
    ;   split_string(Text, "=()", "=()", [Name|Number]),
        atom_string(Kind, Name),
        steps(Kind, Usual),
        steps_number(Number, Usual, N)
    ->  Shade =.. [Kind,N]
    ;   Known = 'lambert, gooch, flat, xray, cel=N, zebra=N (N: 2..64)',
        atomic_list_concat([Known|Others], ', ', Form),
        usage_error(bad_value('--shade', Text, Form))
    ).

steps_number([Text|_], _, N) :-
    Text \== "",
    !,
    catch(number_string(N, Text), error(_, _), fail),
    integer(N),
    N >= 2,
    N =< 64.
steps_number([], N, N).

steps(cel, 4).
steps(zebra, 16).

%!  up_matrix(+Options, -Matrix) is det.
%
%   Matrix places what turn_up/1 turns for the option --up.

up_matrix(Options, Matrix) :-
    option(up(Axis), Options, z),
    up_rows(Axis, Matrix).

up_rows(z, Matrix) :-
    identity_matrix(Matrix).
up_rows(y, [[1,0,0,0], [0,0,-1,0], [0,1,0,0]]).
up_rows(x, [[0,0,-1,0], [0,1,0,0], [1,0,0,0]]).
