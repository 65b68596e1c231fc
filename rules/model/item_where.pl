:- module(sg_item_where,
          [ text_noted/2,               % +File, +Shift
            error_placed/2              % +Error0, -Error
          ]).
:- use_module(model_plain, [with_plain_facts/3, plain_taken/3]).
:- use_module(model_text, [next_term/3, place_location/3]).
:- use_module(shifted, [shifted/3]).
:- use_module('../kernel', [world_number/1]).
:- use_module('../text_file', [with_text/4]).
/** <module> Where a fact stands that names something which is not there.

What look/2, gluing/2 and unfolding/2 name is asked for when it is used, long
after the file was read. Only then, for the message, the file is looked through
again.
*/

%   text_read(World, File, Shift): of the world that this thread read last.

:- thread_local text_read/3.

%!  text_noted(+File, +Shift) is det.
%
%   The model file File was read into the current world, its numbers shifted by
%   Shift as of shifted/3.

text_noted(File, Shift) :-
    world_number(World),
    forall(( text_read(Other, _, _), Other \== World ),
           retractall(text_read(Other, _, _))),
    assertz(text_read(World, File, Shift)).

%!  error_placed(+Error0, -Error) is det.
%
%   Error is Error0, with location(File, Line, Column) if it is of a fact in a
%   model file and has no place yet.

error_placed(Error0, Error) :-
    (   nonvar(Error0),
        Error0 = error(Formal, Context),
        \+ ( nonvar(Context), Context = location(_, _, _) ),
        nonvar(Formal),
        names_fact(Formal, Fact),
        text_read(_, File, Shift),
        catch(fact_place(File, Shift, Fact, Location), error(_, _), fail)
    ->  Error = error(Formal, Location)
    ;   Error = Error0
    ).

%   names_fact(Formal, Fact): the error is of the Fact, of its second argument.

names_fact(model_error(look(no_face(S, Face, _))), look(S, face(Face, _))).
names_fact(model_error(unfold(S, Wish, _)), unfolding(S, Wish)).
names_fact(geometry_error(part_glue(wish(S, Wish))), gluing(S, Wish)).

fact_place(File, Shift, Fact, Location) :-
    with_text(facts, File, Text,
              with_plain_facts(Text, Facts,
                               fact_found(Text, Facts, Shift, Fact, Place))),
    place_location(Place, 2, Location).

fact_found(Text, Facts, Shift, Fact, Place) :-
    plain_taken(Facts, Text, Shift),
    next_term(Text, Term, Place0),
    Term \== end_of_file,
    (   callable(Term),
        shifted(Shift, Term, Row),
        \+ Row \= Fact
    ->  Place = Place0
    ;   fact_found(Text, Facts, Shift, Fact, Place)
    ).
