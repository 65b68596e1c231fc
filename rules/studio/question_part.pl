:- module(sg_question_part,
          [ unsafe_part/2,              % +Goal, -Part
            data_error/2                % +Error0, -Error
          ]).
:- use_module(library(occurs), [sub_term/2]).
/** <module> What library(sandbox) lets strangers call, and we do not.

library(sandbox) follows what a goal calls. Some of what it holds safe is not
safe here. A goal M:G is called in the module M, where it finds what is no
export, and where it may add facts; use_module/1 runs the directives of a file;
a message format(Format, Arguments) calls what Format says with `~@`.
So none of these may stand in the goal of a stranger, at no depth, and not as an
atom either, because a goal can be put together: call(use_module, file).
*/

%!  unsafe_part(+Goal, -Part) is semidet.
%
%   Part is the first part of Goal that a stranger may not name.

unsafe_part(Goal, Part) :-
    sub_term(Part, Goal),
    callable(Part),
    (   compound(Part)
    ->  compound_name_arity(Part, Name, _)
    ;   Name = Part
    ),
    atom(Name),
    unsafe_name(Name),
    !.

unsafe_name(Name) :-
    (   unsafe(Name)
    ->  true
    ;   sub_atom(Name, 0, _, _, $)      % what belongs to Prolog itself
    ).

unsafe(:).
unsafe(@).
unsafe(use_module).
unsafe(load_files).
unsafe(ensure_loaded).
unsafe(consult).
unsafe(print_message).
unsafe(print_message_lines).
unsafe(message_to_string).
unsafe(message_to_codes).
unsafe(set_prolog_flag).
unsafe(set_prolog_stack).
unsafe(nb_setval).
unsafe(nb_linkval).
unsafe(abolish_all_tables).

%!  data_error(+Error0, -Error) is det.
%
%   Error is what a goal of a stranger raised; if words of it could call what
%   they like, request_error(thrown(Text)): Text is Error0 as it is written.

data_error(Error0, Error) :-
    (   sub_term(Part, Error0),
        words(Part, Text),
        sub_string(Text, Before, _, _, "~"),
        sub_string(Text, At, _, _, "@"),
        At > Before
    ->  format(string(Written), "~W",
               [Error0, [quoted(true), max_depth(12), portray(false)]]),
        Error = error(request_error(thrown(Written)), _)
    ;   Error = Error0
    ).

%   words(Part, Text): the forms that a format may have.

words(Part, Text) :-
    (   atom(Part)
    ->  atom_string(Part, Text)
    ;   string(Part)
    ->  Text = Part
    ;   is_list(Part),
        catch(text_to_string(Part, Text), error(_, _), fail)
    ).
