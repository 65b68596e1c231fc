:- module(sg_text_edit,
          [ number_place/5,             % +Text, +Which, -From, -To, -Number
            number_replaced/5           % +Text, +From, +To, +Number, -New
          ]).
:- use_module(library(lists), [nth1/3]).
/** <module> A number of a model, and where it stands in the text of the model.

The text of a model file is the truth: who changes a size changes the number
there, and comments and layout stay.
*/

%!  number_place(+Text, +Which, -From:integer, -To:integer, -Number) is det.
%
%   The characters of Text behind From and up to To are Number. Which is
%
%     - segment(S, Path): in the term of segment S; Path is a list of the
%       numbers of arguments, or of members of a list, from 1, outermost first
%     - param(Name): the default of the parameter Name
%
%   @error request_error(edit(Why)): no_fact(Which), no_path(Path),
%   no_number(Path)

number_place(Text, Which, From, To, Number) :-
    setup_call_cleanup(
        open_string(Text, In),
        fact_read(In, Which, Term, Position),
        close(In)),
    which_path(Which, Fact, Path),
    (   at_path([Fact|Path], Term, Position, Found, Where)
    ->  true
    ;   edit_error(no_path(Path))
    ),
    (   number(Found),
        Where = From0-To0
    ->  From = From0,
        To = To0,
        Number = Found
    ;   edit_error(no_number(Path))
    ).

edit_error(Why) :-
    throw(error(request_error(edit(Why)), _)).

which_path(segment(_, Path), 3, Path).
which_path(param(_), 2, []).

fact_read(In, Which, Term, Position) :-
    read_term(In, Term0, [ module(sg_model_syntax), cycles(false),
                           dotlists(false), var_prefix(false),
                           subterm_positions(Position0) ]),
    (   Term0 == end_of_file
    ->  edit_error(no_fact(Which))
    ;   is_fact(Which, Term0)
    ->  Term = Term0,
        Position = Position0
    ;   fact_read(In, Which, Term, Position)
    ).

is_fact(segment(S, _), segment(S0, _, _)) :-
    S0 == S.
is_fact(param(Name), param(Name0, _)) :-
    Name0 == Name.

%   at_path(Path, Term, Position, Found, Where)

at_path(Path, Term, parentheses_term_position(_, _, Position), Found, Where) :-
    !,
    at_path(Path, Term, Position, Found, Where).
at_path([], Found, Where, Found, Where).
at_path([I|Path], Term, Position, Found, Where) :-
    (   Position = term_position(_, _, _, _, Positions)
    ->  arg(I, Term, Inner)
    ;   Position = list_position(_, _, Positions, _)
    ->  nth1(I, Term, Inner)
    ),
    nth1(I, Positions, InnerPosition),
    !,
    at_path(Path, Inner, InnerPosition, Found, Where).

%!  number_replaced(+Text, +From, +To, +Number, -New:string) is det.
%
%   New is Text with Number in the place of the characters behind From up to To.

number_replaced(Text, From, To, Number, New) :-
    sub_string(Text, 0, From, _, Before),
    sub_string(Text, To, _, 0, After),
    format(string(Digits), "~w", [Number]),
    (   Number < 0,
        sub_string(Before, _, 1, 0, Last),
        string_code(1, Last, Code),
        code_type(Code, prolog_symbol)
    ->  Space = " "
    ;   Space = ""
    ),
    atomics_to_string([Before,Space,Digits,After], New).
