:- module(sg_look_file,
          [ looks_added/2,              % +Looks, +Lights
            look_file_added/2           % +File, -InVain
          ]).
:- use_module(look_term, [is_look/1, look_expected/2, property_slot/2]).
:- use_module(model_text,
              [next_term/3, checked_fact/3, place_error/2, place_error/3]).
:- use_module('../csg/csg_term', [plain_name/2]).
:- use_module('../store',
              [ look/2, light/2, segment/3, assert_fact/1, retract_fact/1,
                retractall_facts/1, facts_transaction/1
              ]).
:- use_module('../text_file', [with_text/4]).
:- use_module(library(apply), [maplist/2, partition/4]).
:- use_module(library(lists), [member/2]).
/** <module> How a model looks: look/2 and light/2 of files.

They stand in a model, or in a file of their own. What a segment has twice, or
what no segment has, is an error; the lights of a file replace those of the
world. In a file of their own a segment may be named as in its segment/3, and
what it says of a segment replaces what the model says.

Errors, model_error(look(What)) with their place:

    no_segment(S)   twice(S, Slot)   light_twice(N, Slot)
    everywhere      no_way(N)        only(Name, Arity)
*/

%!  looks_added(+Looks, +Lights) is det.
%
%   The rows of a file, each later(Row, Place), are in the world.

looks_added(Looks, Lights) :-
    maplist(look_added, Looks),
    lights_added(Lights).

look_added(later(look(S, Property), Place)) :-
    known_segment(S, Place),
    property_slot(Property, Slot),
    (   look(S, Other),
        property_slot(Other, Slot)
    ->  place_error(Place, look(twice(S, Slot)))
    ;   assert_fact(look(S, Property))
    ).

known_segment(S, Place) :-
    (   segment(S, _, _)
    ->  true
    ;   place_error(Place, 1, look(no_segment(S)))
    ).

lights_added([]) :-
    !.
lights_added(Lights) :-
    retractall_facts(light(_, _)),
    maplist(light_added, Lights),
    maplist(light_has_way, Lights).

light_added(later(light(N, Property), Place)) :-
    property_slot(Property, Slot),
    (   N =:= 0,
        Slot \== strength
    ->  place_error(Place, 2, look(everywhere))
    ;   light(N, Other),
        property_slot(Other, Slot)
    ->  place_error(Place, look(light_twice(N, Slot)))
    ;   assert_fact(light(N, Property))
    ).

%   The first light has a way of its own (rules/shading/tone.pl).

light_has_way(later(light(N, _), Place)) :-
    (   N =< 1
    ->  true
    ;   light(N, Property),
        property_slot(Property, direction)
    ->  true
    ;   place_error(Place, look(no_way(N)))
    ).

%!  look_file_added(+File, -InVain:list) is det.
%
%   What File says holds in the current world. InVain are the names in it that
%   no segment has. One transaction.
%
%   @error error(model_error(What), location(File, Line, Column)): as in
%   model_text.pl; look(What)

look_file_added(File, InVain) :-
    with_text(facts, File, Text, sg_look_file:facts_read(Text, Facts)),
    partition([later(Fact, _)]>>functor(Fact, light, _), Facts, Lights, Looks0),
    findall(Name,
            ( member(later(look(Name, _), _), Looks0), atom(Name),
              \+ segment_called(Name, _) ),
            InVain0),
    sort(InVain0, InVain),
    findall(later(look(S, Property), Place),
            ( member(later(look(Name, Property), Place), Looks0),
              looked_at(Name, S) ),
            Looks),
    facts_transaction(sg_look_file:looks_replaced(Looks, Lights)).

looks_replaced(Looks, Lights) :-
    forall(( member(later(look(S, Property), _), Looks),
             property_slot(Property, Slot),
             look(S, Other),
             property_slot(Other, Slot) ),
           retract_fact(look(S, Other))),
    looks_added(Looks, Lights).

looked_at(Name, S) :-
    (   integer(Name)
    ->  S = Name
    ;   segment_called(Name, S)
    ).

segment_called(Name, S) :-
    segment(S, _, Term),
    plain_name(Term, Name).

facts_read(Text, Facts) :-
    next_term(Text, Term, Place),
    (   Term == end_of_file
    ->  Facts = []
    ;   look_fact(Term, Place, Fact),
        Facts = [later(Fact, Place)|Facts1],
        facts_read(Text, Facts1)
    ).

look_fact(Term, Place, Fact) :-
    (   nonvar(Term),
        Term = look(Name, Property),
        atom(Name)
    ->  (   is_look(Property)
        ->  Fact = Term
        ;   look_expected(Property, Expected),
            place_error(Place, 2,
                        value(look, 'Property', Property, look(Expected)))
        )
    ;   checked_fact(Term, Place, Fact),
        functor(Term, Name, Arity),
        (   memberchk(Name, [look,light])
        ->  true
        ;   place_error(Place, look(only(Name, Arity)))
        )
    ).
