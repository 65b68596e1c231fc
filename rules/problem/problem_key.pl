:- module(sg_problem_key,
          [ problem_key/8,              % +Number, +Settings, +Items, +Chains,
                                        % +Points, +Measures, +Patterns, -Key
            pattern_key/2,              % +D, -Part
            loop_count/2                % +Chains, -Loops
          ]).
:- use_module('../development/seam_measure', [pattern_area/2]).
:- use_module('../store', [segment/3]).
:- use_module('../unrolling/true_table', [true_length_rows/2]).
:- use_module(problem_item, [measure_unit/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> The key of a problem: what was asked, and what is true.

Nothing here is typed: all numbers are asked of the model.
*/

%!  pattern_key(+D, -Part) is det.
%
%   Part, a dict, has the area and the generators of pattern D.

pattern_key(D, _{area:Area, generators:Generators}) :-
    pattern_area(D, Area0),
    rounded(Area0, Area),
    (   segment(D, _, true_development(_, _)),
        true_length_rows(D, Rows)
    ->  findall(_{number:I, degrees:Degrees, length:Length},
                ( member(row(I,Degrees0,_,_,_,Length0,_,_,_), Rows),
                  maplist(rounded, [Degrees0,Length0], [Degrees,Length]) ),
                Generators)
    ;   Generators = []
    ).

%!  loop_count(+Chains, -Loops) is det.
%
%   Loops is how many of Chains (problem_loop.pl) close.

loop_count(Chains, Loops) :-
    aggregate_all(count, member(chain(_, _, closed, _), Chains), Loops).

%!  problem_key(+Number, +Settings, +Items, +Chains, +Points, +Measures,
%!              +Patterns, -Key) is det.
%
%   Key is a dict. Chains are those of problem_loop.pl; Points are
%   Points-Planes, those of problem_point.pl and of problem_plane.pl; Measures
%   is a list of Measure-Value, in units of the model; Patterns are dicts with
%   the parts of pattern_key/2.

problem_key(Number, Settings, Items, Chains, Points-Planes, Measures, Patterns,
            _{number:Number, parameters:Parameters, asked:Asked, loops:Loops,
              open_lines:Open, points:PointsOut, planes:PlanesOut,
              measures:MeasuresOut, developments:Patterns}) :-
    findall(Name-Value, member(Name=Value, Settings), Pairs),
    dict_pairs(Parameters, _, Pairs),
    findall(Text,
            ( member(ask(What), Items), format(atom(Text), '~w', [What]) ),
            Asked),
    loop_count(Chains, Loops),
    aggregate_all(count, member(chain(_, _, open, _), Chains), Open),
    findall(_{measure:Text, value:Value, unit:Unit, tolerance:Tolerance},
            ( member(ask(measure(Measure, Unit, Tolerance)), Items),
              memberchk(Measure-Value0, Measures),
              measure_unit(Unit, _, Size, _),
              rounded(Value0/Size, Value),
              format(atom(Text), '~w', [Measure]) ),
            MeasuresOut),
    findall(_{across:Axis, at:At},
            ( member(plane(Axis, At0, _), Planes), rounded(At0, At) ),
            PlanesOut),
    findall(_{number:I, loop:Loop, degrees:Degrees, x:X, y:Y, z:Z},
            ( member(point(I,Loop,T,p(X0,Y0,Z0)), Points),
              (   T == none
              ->  Degrees = null
              ;   Degrees = T
              ),
              maplist(rounded, [X0,Y0,Z0], [X,Y,Z]) ),
            PointsOut).

%   rounded(Number, Rounded): to a millionth.

rounded(Number, Rounded) :-
    Rounded is round(Number*1.0e6)/1.0e6 + 0.0.
