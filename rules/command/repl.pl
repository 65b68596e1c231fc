:- module(sg_repl,
          [ repl/0,
            repl/1                      % -Status
          ]).
:- use_module(library(prolog_wrap), [wrap_predicate/4]).
:- use_module(help, [short_answers/0]).
:- use_module('../studio/query', [query/2, read_goal/3]).
:- use_module('../about', [said_about/2]).
:- use_module('../limits', [term_of_text/3, text_beyond/5]).
:- use_module('../primitive/primitive_rows', [goal_commas_told/1]).
:- use_module('../status', [error_status/2]).
:- use_module('../store', [segment/3]).
/** <module> The Prolog top level with a model loaded.

On a terminal it is Prolog's own, with line editing and completion. Otherwise
goals are read from standard input, one after the other, and all their answers
printed as tables; what is said of a goal begins with its line.
Ctrl-C stops the goal, not the session; the transaction it
was in is taken back.
*/

%!  repl is det.
%
%   Read goals and answer them until the input ends or `halt.`

repl :-
    repl(_).

%!  repl(-Status) is det.
%
%   As repl/0. Status is the exit status of the first error of a goal that was
%   not typed on a terminal, 0 if there was none: the goals after it are asked
%   all the same.

repl(0) :-
    stream_property(user_input, tty(true)),
    !,
    print_message(informational, sanggwan(greeting)),
    forall(segment(S, Kind, Name),
           print_message(informational, sanggwan(segment(S, Kind, Name)))),
    short_answers,
    set_prolog_flag(readline, true),
    wrap_predicate('$toplevel':read_query_line(_, Text), sg_repl, Read,
                   ( Read,
                     sg_repl:looked_through(Text) )),
    catch('$toplevel':setup_readline, error(_, _), true),
    on_signal(int, Old, sg_repl:stopped),
    setup_call_cleanup(true, query_loop, on_signal(int, _, Old)).
repl(Status) :-
    State = state(1, 0),
    repeat,
    next_line(State),
    arg(1, State, Line),
    said_about(line(Line),
               catch(next_goal(State, Next), Error,
                     ( unless_unread(Error, State),
                       Next = goal ))),
    Next == end_of_file,
    !,
    arg(2, State, Status).

%   State is state(Line, Status): the line of standard input that is read, and
%   what repl/1 returns. (Prolog's own count of lines counts prompts too.)

lines_passed(State, N) :-
    arg(1, State, Line0),
    Line is Line0+N,
    nb_setarg(1, State, Line).

%   next_line(State): up to the line in which the next goal begins.

next_line(State) :-
    peek_char(user_input, Char),
    (   Char == '%'
    ->  skip(user_input, '\n'),
        lines_passed(State, 1),
        next_line(State)
    ;   Char == (/),
        peek_string(user_input, 2, "/*")
    ->  get_char(user_input, _),
        get_char(user_input, _),
        comment_passed(State, ' '),
        next_line(State)
    ;   Char \== end_of_file,
        char_type(Char, space)
    ->  get_char(user_input, _),
        (   Char == '\n'
        ->  lines_passed(State, 1)
        ;   true
        ),
        next_line(State)
    ;   true
    ).

%   comment_passed(State, Last): to the end of a comment; Last is what was read
%   of it last.

comment_passed(State, Last) :-
    get_char(user_input, Char),
    (   Char == end_of_file
    ->  true
    ;   Last == (*),
        Char == (/)
    ->  true
    ;   Char == '\n'
    ->  lines_passed(State, 1),
        comment_passed(State, Char)
    ;   comment_passed(State, Char)
    ).

%   unless_unread(Error, State): print Error and go on, unless nobody reads on.

unless_unread(Error, _) :-
    Error = error(io_error(write, _), _),
    !,
    throw(Error).
unless_unread(Error, State) :-
    print_message(error, Error),
    (   Error = error(_, _),            % no Ctrl-C
        arg(2, State, 0)
    ->  error_status(Error, Status),
        nb_setarg(2, State, Status)
    ;   true
    ).

:- public stopped/1.

stopped(Signal) :-
    throw(sanggwan_interrupt(Signal)).

%   looked_through(Text): true unless Text is too much for a goal; then that is
%   said, and Prolog reads the next one. Commas that may stand for a decimal
%   point are told; what cannot be read, Prolog tells.

:- public looked_through/1.

looked_through(Text) :-
    (   atom_string(Text, String),
        text_beyond(program, String, What, _, _)
    ->  print_message(error, error(usage_error(bad_goal('', What)), _)),
        fail
    ;   catch(term_of_text(Text, Goal, []), error(_, _), Goal = true),
        goal_commas_told(Goal)
    ).

%   query_loop: Prolog's own, begun again after an error. (prolog/0 would give
%   the keyboard to the debugger.)

query_loop :-
    repeat,
    catch('$query_loop', Error, ( print_message(error, Error), fail )),
    !.

%   The text of a goal is looked through before it is read (limits.pl).

next_goal(State, Next) :-
    goal_text(State, Text),
    (   Text == end_of_file
    ->  Next = end_of_file
    ;   Next = goal,
        read_goal(Text, Goal, Bindings),
        goal_commas_told(Goal),
        (   query(user:Goal, [bindings(Bindings)])
        ->  true
        ;   print_message(informational, sanggwan(no_answer))
        )
    ).

%   goal_text(State, Text): up to its full stop, and what ends that.

goal_text(State, Text) :-
    '$raw_read'(user_input, Text),
    atomic_list_concat(Lines, '\n', Text),
    length(Lines, N0),
    (   line_position(user_input, 0)
    ->  N = N0
    ;   N is N0-1
    ),
    lines_passed(State, N).
