:- module(sg_look_en,
          [ look_en//1,                 % +What
            expected_look_en//1,        % +Expected
            expected_light_en//1        % +Expected
          ]).
:- use_module('../colour', [colour_name/2]).
:- use_module(library(apply), [maplist/3]).
/** <module> What is wrong with looks and lights, in English.

look_ko.pl has the same heads in Korean (tests/rules/model/look_file.plt).
*/

%!  look_en(+What)// is det.
%
%   The message for model_error(look(What)).

look_en(no_segment(S)) -->
    [ 'there is no segment ~w that could look like this'-[S], nl,
      '  Correct the number, or leave the fact out.' ].
look_en(twice(S, Slot)) -->
    [ 'segment ~w has a second ~w'-[S, Slot], nl,
      '  Remove one of the two facts look/2.' ].
look_en(light_twice(N, Slot)) -->
    [ 'light ~w has a second ~w'-[N, Slot], nl,
      '  Remove one of the two facts light/2.' ].
look_en(everywhere) -->
    [ 'light 0 comes from everywhere and has no direction', nl,
      '  Give this light a number from 1 to 8, or write \c
       light(0, strength(F)).' ].
look_en(no_way(N)) -->
    [ 'light ~w has no direction'-[N], nl,
      '  Add light(~w, picture(X, Y, Z)) or light(~w, direction(X, Y, Z)).'-
      [N, N] ].
look_en(no_face(S, Face, Names)) -->
    { maplist(term_to_atom, Names, Atoms),
      atomic_list_concat(Atoms, ', ', All)
    },
    [ 'segment ~w has no face ~w'-[S, Face], nl ],
    (   { Names == [] }
    ->  [ '  Its faces have no names: write look(~w, Property).'-[S] ]
    ;   [ '  Write one of its faces: ~w.'-[All] ]
    ).
look_en(only(Name, Arity)) -->
    [ 'a file for --look has no facts ~w/~w'-[Name, Arity], nl,
      '  Write look(Segment, Property) and light(N, Property).' ].

%!  expected_look_en(+Expected)// is det.
%!  expected_light_en(+Expected)// is det.
%
%   What should stand there, see look_expected/2.

expected_look_en(opacity) -->
    !,
    [ 'opacity(A), A a number from 0 (clear) to 1 (opaque)' ].
expected_look_en(shine) -->
    !,
    [ 'shine(F, N), F a number from 0 to 1, N a whole number from 1 to 1000' ].
expected_look_en(colour) -->
    !,
    { findall(Name, colour_name(Name, _), Names),
      atomic_list_concat(Names, ', ', All)
    },
    [ 'colour(C), where C is rgb(R, G, B), whole numbers from 0 to 255, or \c
       one of', nl, '  ~w.'-[All] ].
expected_look_en(_) -->
    [ 'colour(C), opacity(A), shine(F, N), or for a face alone \c
       face(Face, Property) with one of these' ].

expected_light_en(strength) -->
    [ 'strength(F), F a number from 0 to 10' ].
expected_light_en(way) -->
    [ 'a direction of three numbers that are not all 0' ].
expected_light_en(any) -->
    [ 'picture(X, Y, Z) (from there in the picture: right, up, towards the \c
       eye), direction(X, Y, Z) (this way in the model) or strength(F)' ].
expected_light_en(colour) -->
    expected_light_en(any).
expected_light_en(opacity) -->
    expected_light_en(any).
expected_light_en(shine) -->
    expected_light_en(any).
