:- module(sg_text_edit,
          [ number_place/5,             % +Text, +Which, -From, -To, -Number
            text_replaced/5,            % +Text, +From, +To, +With, -New
            text_change/5,              % +Text, +New, -From, -To, -With
            fact_place/6                % +Text, +Wanted, -From, -To, -With,
                                        % -Fact
          ]).
:- use_module('../limits', [term_of_text/3]).
:- use_module(library(lists), [member/2, nth1/3]).
/** <module> Numbers, wishes and questions of a model, and where they stand in
its text.

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

%!  text_replaced(+Text, +From, +To, +With, -New:string) is det.
%
%   New is Text with With, a number or a text, in the place of the characters
%   behind From up to To.

text_replaced(Text, From, To, With, New) :-
    sub_string(Text, 0, From, _, Before),
    sub_string(Text, To, _, 0, After),
    format(string(Written), "~w", [With]),
    (   number(With),
        With < 0,
        sub_string(Before, _, 1, 0, Last),
        string_code(1, Last, Code),
        code_type(Code, prolog_symbol)
    ->  Space = " "
    ;   Space = ""
    ),
    atomics_to_string([Before,Space,Written,After], New).

%!  text_change(+Text, +New, -From:integer, -To:integer, -With:string) is det.
%
%   With in the place of the characters of Text behind From up to To makes New.
%   What both begin with stays, and what both end with.

text_change(Text, New, From, To, With) :-
    string_length(Text, Length),
    string_length(New, NewLength),
    Shorter is min(Length, NewLength),
    most(same_begin(Text, New), Shorter, From),
    Rest is Shorter-From,
    most(same_end(Text, New), Rest, After),
    To is Length-After,
    sub_string(New, From, _, After, With).

same_begin(Text, New, N) :-
    sub_string(Text, 0, N, _, Begin),
    sub_string(New, 0, N, _, Begin).

same_end(Text, New, N) :-
    sub_string(Text, _, N, 0, End),
    sub_string(New, _, N, 0, End).

%   most(Goal, Most, N): the largest N up to Most for which Goal is true; it is
%   true of all smaller ones.

most(Goal, Most, N) :-
    most(Goal, 0, Most, N).

most(_, N, N, N) :-
    !.
most(Goal, Least, Most, N) :-
    Middle is (Least+Most+1)//2,
    (   call(Goal, Middle)
    ->  most(Goal, Middle, Most, N)
    ;   Below is Middle-1,
        most(Goal, Least, Below, N)
    ).

%!  fact_place(+Text, +Wanted, -From:integer, -To:integer, -With, -Fact) is det.
%
%   With in the place of the characters of Text behind From up to To makes Text
%   say what is Wanted:
%
%     - wish(S, Name, Edge): Name is `cut`, `keep`, or `none`, Edge a number or
%       the text of a name (polygon_name.pl)
%     - question(Name, Goal): texts; Goal `none` takes it away
%
%   Fact is the text of the fact that is there then, "" if there is none.
%
%   @error request_error(edit(Why)): no_edge(Text), no_wish(S, Edge),
%   no_question(Name)

fact_place(Text, Wanted, From, To, With, Fact) :-
    wanted_fact(Wanted, New, Same, Missing),
    (   New == none
    ->  Fact = ""
    ;   format(string(Fact), "~W",
               [ New,
                 [quoted(true), spacing(next_argument), numbervars(false)] ])
    ),
    (   setup_call_cleanup(
            open_string(Text, In),
            fact_found(In, Same, Start, End, Behind),
            close(In))
    ->  From = Start,
        (   New == none
        ->  behind_stop(Text, Behind, To)
        ;   To = End
        ),
        With = Fact
    ;   New == none
    ->  edit_error(Missing)
    ;   string_length(Text, From),
        To = From,
        (   ( From =:= 0 ; sub_string(Text, _, 1, 0, "\n") )
        ->  Before = ""
        ;   Before = "\n"
        ),
        atomics_to_string([Before,Fact,".\n"], With)
    ).

%   wanted_fact(Wanted, New, Same, Missing): New, or `none`, takes the place of
%   a fact that is one of Same; Missing says that there is none.

wanted_fact(wish(S, Name, Edge0), New,
            [unfolding(S, cut(Edge)),unfolding(S, keep(Edge))],
            no_wish(S, Edge)) :-
    edge_term(Edge0, Edge),
    (   Name == none
    ->  New = none
    ;   Wish =.. [Name,Edge],
        New = unfolding(S, Wish)
    ).
wanted_fact(question(Name, Goal), New,
            [question(NameAtom, _),question(NameText, _)],
            no_question(NameAtom)) :-
    atom_string(NameAtom, Name),
    atom_string(Name, NameText),
    (   Goal == none
    ->  New = none
    ;   atom_string(GoalAtom, Goal),
        New = question(NameAtom, GoalAtom)
    ).

edge_term(Edge, Edge) :-
    integer(Edge),
    !.
edge_term(Text, Edge) :-
    (   catch(term_of_text(Text, Edge0,
                           [ module(sg_model_syntax), cycles(false),
                             dotlists(false) ]),
              error(syntax_error(_), _), fail),
        ground(Edge0)
    ->  Edge = Edge0
    ;   edit_error(no_edge(Text))
    ).

%   fact_found(In, Same, From, To, Behind) is semidet: the first fact that is
%   one of Same, and where its full stop has been read.

fact_found(In, Same, From, To, Behind) :-
    read_term(In, Term, [ module(sg_model_syntax), cycles(false),
                          dotlists(false), var_prefix(false),
                          subterm_positions(Position) ]),
    Term \== end_of_file,
    (   member(One, Same),
        subsumes_term(One, Term)
    ->  arg(1, Position, From),
        arg(2, Position, To),
        character_count(In, Behind)
    ;   fact_found(In, Same, From, To, Behind)
    ).

%   behind_stop(Text, Behind, To): the line ends with the fact, if nothing else
%   follows on it.

behind_stop(Text, Behind0, To) :-
    Last is Behind0-1,
    sub_string(Text, Last, 1, _, Char),
    (   Char == "."
    ->  Behind = Behind0
    ;   Behind = Last
    ),
    (   sub_string(Text, Behind, 1, _, "\n")
    ->  To is Behind+1
    ;   To = Behind
    ).
