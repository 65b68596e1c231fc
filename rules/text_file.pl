:- module(sg_text_file,
          [ with_text/4,                % +Kind, +File, -Text, :Goal
            with_text_again/3,          % +Path, -Stream, :Goal
            with_bytes/3                % +File, -Stream, :Goal
          ]).
:- use_module(kernel, [atomic_scratch/3, endless_file/1, text_copied/8]).
:- use_module(limits, [limit_value/2, text_beyond/5, text_limits/1]).
/** <module> Files of text, looked through before they are read.
*/

:- meta_predicate
    with_text(+, +, -, 0),
    with_text_again(+, -, 0),
    with_bytes(+, -, 0).

%!  with_text(+Kind, +File, -Text, :Goal) is semidet.
%
%   Call Goal once, with Text open: text(Name, Path, Stream), Name that of
%   File for messages. It breaks no limit (limits.pl) of texts of this Kind:
%   `facts`, `program`, `json`, `lines` of JSON, or `csg`, of which csg_nodes/4
%   finds that.
%   What can be read once only, as `-`, standard input, or a pipe, is copied
%   to a temporary file, Path then, that vanishes with Text: it is looked
%   through first, and places in it are found again. It is looked through as it
%   comes, so what breaks a limit early is not copied to its end. Of a Kind
%   facts(Check), call(Check, Text) is called of its first million octets, with
%   a Text of these: it may raise an error.
%
%   @error model_error(cannot_read(Why)), model_error(limit(Name, Most)), with
%   location(Name, Line, Column)

with_text(Kind0, File, Text, Goal) :-
    kind_check(Kind0, Kind, Check),
    size_limit(Kind, Limit),
    % It may wait for input, and a setup hears no signal.
    text_opened(File, Limit, Kind-Check, Text),
    Text = text(Name, Path, Stream),
    setup_call_cleanup(
        asserta(decoding(Stream, Name)),
        ( no_limit_broken(Kind, Limit, Text),
          once(Goal)
        ),
        closed(Name, Path, Stream)).

kind_check(Kind0, Kind, Check) :-
    (   Kind0 = facts(Check)
    ->  Kind = facts
    ;   Kind = Kind0,
        Check = none
    ).

%!  with_text_again(+Path, -Stream, :Goal) is semidet.
%
%   Call Goal once, with Stream on the Path of a text that is open already: what
%   was warned of is not told twice.

with_text_again(Path, Stream, Goal) :-
    setup_call_cleanup(
        open(Path, read, Stream, [encoding(utf8)]),
        ( asserta(decoding(Stream, warned)),
          once(Goal)
        ),
        closed(Path, Path, Stream)).

%!  with_bytes(+File, -Stream, :Goal) is semidet.
%
%   Call Goal once, with Stream on the octets of File, from their beginning.
%   What can be read once only is copied first, and has the limit of a text.
%
%   @error as with_text/4

with_bytes(File, Stream, Goal) :-
    limit_value(text, Most),
    Limit = limit(text, Most),
    text_opened(File, Limit, octets-none, text(Name, Path, Stream)),
    setup_call_cleanup(
        set_stream(Stream, type(binary)),
        ( set_stream(Stream, record_position(false)),
          (   Name == Path
          ->  true
          ;   size_file(Path, Size),
              Size > Most
          ->  throw(error(model_error(Limit), location(Name, 0, 0)))
          ;   true
          ),
          once(Goal)
        ),
        closed(Name, Path, Stream)).

size_limit(Kind, limit(Name, Most)) :-
    (   memberchk(Kind, [csg,json])
    ->  Name = file
    ;   Name = text
    ),
    limit_value(Name, Most).

no_limit_broken(Kind, Limit, text(Name, Path, Stream)) :-
    (   arg(2, Limit, Most),
        size_file(Path, Size),
        Size > Most
    ->  throw(error(model_error(Limit), location(Name, 0, 0)))
    ;   Kind \== csg,
        Name == Path,                   % else it was when it was copied
        catch(text_beyond(Kind, Stream, What, Line, Column),
              error(io_error(read, From), Context),
              cannot_read(Name, error(io_error(read, From), Context)))
    ->  throw(error(model_error(What), location(Name, Line, Column)))
    ;   true
    ).

closed(Name, Path, Stream) :-
    retractall(decoding(Stream, _)),
    close(Stream),
    (   Name == Path
    ->  true
    ;   delete_file(Path)
    ).

text_opened(-, Limit, Check, text('<stdin>', Copy, Stream)) :-
    !,
    has_an_end('<stdin>', '/dev/stdin'),
    set_stream(user_input, type(binary)),
    copied(user_input, '<stdin>', Limit, Check, Copy, Stream).
text_opened(File, Limit, Check, Text) :-
    has_an_end(File, File),
    catch(open(File, read, In, [encoding(utf8)]), Error,
          cannot_read(File, Error)),
    (   exists_file(File)
    ->  Text = text(File, File, In)
    ;   Text = text(File, Copy, Stream),
        set_stream(In, encoding(octet)),
        call_cleanup(copied(In, File, Limit, Check, Copy, Stream), close(In))
    ).

has_an_end(Name, File) :-
    (   catch(endless_file(File), error(_, _), fail)
    ->  throw(error(model_error(cannot_read(device)), location(Name, 0, 0)))
    ;   true
    ).

%   copied(In, Name, Limit, Kind-Check, Copy, Stream): no more than shows that
%   it is too large, or otherwise wrong.

copied(In, Name, limit(_, Most), Kind-Check, Copy, Stream) :-
    Enough is Most+1,
    atomic_scratch('.pl', _, Copy),
    set_stream(In, record_position(false)), % octets, not lines
    catch(setup_call_cleanup(
              open(Copy, write, Out, [type(binary)]),
              all_copied(Kind-Check, In, Out, Enough, Name, Copy),
              close(Out)),
          Error,
          ( delete_file(Copy),
            not_copied(Name, Error) )),
    open(Copy, read, Stream, [encoding(utf8)]).

all_copied(Kind-Check, In, Out, Enough, Name, Copy) :-
    First is min(Enough, 1_000_000),
    part_copied(Kind, "", In, Out, First, Name, Copied),
    Left is Enough-First,
    (   Copied =:= First,
        Left > 0
    ->  with_text_again(
            Copy, Begun,
            ( (   Check == none
              ->  true
              ;   call(Check, text(Name, Copy, Begun))
              ),
              part_copied(Kind, Begun, In, Out, Left, Name, _)
            ))
    ;   true
    ).

part_copied(Kind0, Begun, In, Out, Most, Name, Copied) :-
    (   Kind0 == csg
    ->  Kind = octets
    ;   Kind = Kind0
    ),
    text_limits(Limits),
    text_copied(Kind, Begun, In, Out, Limits, Most, Copied,
                fault(What, Line, Column)),
    (   What == none
    ->  true
    ;   limit_value(What, Limit),
        throw(error(model_error(limit(What, Limit)),
                    location(Name, Line, Column)))
    ).

not_copied(Name, error(Formal, Context)) :-
    Formal \= model_error(_),
    !,
    cannot_read(Name, error(Formal, Context)).
not_copied(_, Error) :-
    throw(Error).

%   Prolog warns of every fact with bytes that are no UTF-8, again when it is
%   read once more, and names temporary files. Of all that becomes one warning
%   of ours.

:- thread_local decoding/2.             % Stream, File

:- multifile user:message_hook/3.

user:message_hook(io_warning(Stream, _), warning, _) :-
    sg_text_file:undecoded(Stream).

:- public undecoded/1.

undecoded(Stream) :-
    retract(decoding(Stream, File)),
    !,
    asserta(decoding(Stream, warned)),
    (   File == warned
    ->  true
    ;   line_count(Stream, Line),
        print_message(warning, sanggwan(not_utf8(File, Line)))
    ).

cannot_read(File, error(Formal, _)) :-
    !,
    (   Formal = representation_error(max_symbolic_links)
    ->  Why = links
    ;   Formal = representation_error(max_path_length)
    ->  Why = long_name
    ;   exists_directory(File)
    ->  Why = directory
    ;   Formal = existence_error(_, _)
    ->  Why = missing
    ;   Formal = permission_error(_, _, _)
    ->  Why = permission
    ;   Formal = io_error(_, _)
    ->  Why = io
    ;   Why = Formal
    ),
    throw(error(model_error(cannot_read(Why)), location(File, 0, 0))).
cannot_read(_, Ball) :-
    throw(Ball).
