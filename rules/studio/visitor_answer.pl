:- module(sg_visitor_answer,
          [ class_begun/2,              % +File, +Model
            class_file/1,               % -File
            class_opens/1,              % +Path
            class_request/4,            % +Who, +Do, +Head, -Reply
            class_pupil/2,              % +Who, -Pupil
            answers_recorded/2          % +Who, +Reply
          ]).
:- use_module('../environment', [state_folder/1]).
:- use_module('../kernel', [atomic_sync/1, atomic_sync_folder/1]).
:- use_module('../output', [writing/3]).
:- use_module(document_journal, [damaged_path/2]).
:- use_module(journal, [line_step/4, summed_line/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(filesex), [copy_file/2, make_directory_path/1]).
:- use_module(library(lists), [member/2]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> The book of a class: who is in it, and what each answered.

Each line of its file is on the disk before a pupil hears that an answer was
right: nothing is lost when the program is killed, and the next start has it. A
line has a sum, so what is not as it was written is noticed (journal.pl); those
of older versions have none. Such a line is said once: the book is kept as it
was, beside it, and goes on without that line.
The secret of a pupil is not in it, only a digest.
*/

% book_(File, Stream): of the problems in File. pupil_(Digest, Name, Turn): Turn
% others came before. done_(Digest, Problem, Number, Tries, Answers, Right,
% Shown): Right is a list of true and false, of the last try; Shown is true if
% the answer was shown before all was right.
% model_(Model): the model that is given beside the problems.
:- dynamic book_/2, pupil_/3, done_/7, model_/1.

%!  class_begun(+File, +Model) is det.
%
%   The class has the problems of File, an absolute path, or none, if File is
%   `none`, and beside them Model, or no model, if it is `none`. What was
%   answered before, to these, is there again.

class_begun(File, Model) :-
    retractall(model_(_)),
    assertz(model_(Model)),
    retractall(book_(_, _)),
    retractall(pupil_(_, _, _)),
    retractall(done_(_, _, _, _, _, _, _)),
    (   File == none
    ->  true
    ;   book_path(File, Path),
        (   exists_file(Path)
        ->  book_taken(Path),
            open(Path, append, Stream, [encoding(utf8), newline(posix)])
        ;   file_directory_name(Path, Folder),
            make_directory_path(Folder),
            open(Path, write, Stream, [encoding(utf8), newline(posix)]),
            atomic_sync_folder(Path)
        ),
        assertz(book_(File, Stream))
    ).

%   book_path(File, Path): one for each file of problems.

book_path(File, Path) :-
    state_folder(State),
    digest(File, Digest),
    sub_atom(Digest, 0, 16, _, Short),
    file_base_name(File, Base),
    format(atom(Path), "~w/sanggwan/class/~w-~w.answers", [State, Base, Short]).

digest(Text, Digest) :-
    sha_hash(Text, Hash, [algorithm(sha256), encoding(utf8)]),
    hash_atom(Hash, Digest).

%!  class_file(-File) is semidet.
%
%   The class has the problems of File.

class_file(File) :-
    book_(File, _).

%!  class_opens(+Path) is semidet.
%
%   A pupil may open the model Path. In a class with problems that is the one
%   beside them alone: those of the problems have the answers.

class_opens(Path) :-
    (   book_(_, _)
    ->  model_(Model),
        Model \== none,
        same_file(Path, Model)
    ;   true
    ).

book_taken(Path) :-
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8)]),
        lines_taken(In, Lines, 0, Damaged),
        close(In)),
    (   Damaged =:= 0
    ->  true
    ;   damaged_path(Path, Kept),
        copy_file(Path, Kept),
        writing(Path, text, sg_visitor_answer:lines_written(Lines)),
        print_message(warning,
                      sanggwan(studio(book_damaged(Path, Damaged, Kept))))
    ).

%   lines_taken(In, Lines, Damaged0, Damaged): Lines are those that are as they
%   were written. The last one may lack its newline: that is half of one.

lines_taken(In, Lines, Damaged0, Damaged) :-
    read_string(In, "\n", "", End, Line),
    (   Line == "",
        End =:= -1
    ->  Lines = [],
        Damaged = Damaged0
    ;   End =:= 0'\n,
        once(line_step(_, 0, Line, Row)),
        line_taken(Row)
    ->  Lines = [Line|Lines1],
        lines_taken(In, Lines1, Damaged0, Damaged)
    ;   Damaged1 is Damaged0+1,
        lines_taken(In, Lines, Damaged1, Damaged)
    ).

:- public lines_written/2.

lines_written(Lines, Out) :-
    forall(member(Line, Lines), format(Out, "~s~n", [Line])).

line_taken(Row) :-
    get_dict(pupil, Row, Pupil),
    string(Pupil),
    atom_string(Digest, Pupil),
    (   get_dict(name, Row, Name0)
    ->  pupil_name(Name0, Name),
        pupil_taken(Digest, Name, Row)
    ;   _{problem:Problem, number:Number, answers:Answers, right:Right,
          shown:Shown} :< Row,
        atomic(Problem),
        integer(Number),
        is_list(Answers),
        is_list(Right),
        maplist(is_truth, [Shown|Right]),
        answers_taken(Digest, Problem, Number, Answers, Right, Shown)
    ).

is_truth(true).
is_truth(false).

pupil_taken(Digest, Name, Row) :-
    get_dict(turn, Row, Turn0),
    integer(Turn0),
    (   retract(pupil_(Digest, _, Turn))
    ->  true
    ;   Turn = Turn0
    ),
    assertz(pupil_(Digest, Name, Turn)).

answers_taken(Digest, Problem, Number, Answers, Right, Shown) :-
    (   retract(done_(Digest, Problem, _, Tries0, Before, Right0, Shown0))
    ->  true
    ;   Tries0 = 0,
        Before = Answers,
        Right0 = [],
        Shown0 = false
    ),
    (   all_true(Right0)
    ->  assertz(done_(Digest, Problem, Number, Tries0, Before, Right0, Shown0))
    ;   Tries is Tries0+1,
        ( Shown0 == true -> Shown1 = true ; Shown1 = Shown ),
        assertz(done_(Digest, Problem, Number, Tries, Answers, Right, Shown1))
    ).

all_true([R|Rs]) :-
    \+ ( member(Other, [R|Rs]), Other \== true ).

%   written(Row): it is on the disk, and then known.

written(Row) :-
    with_mutex(sg_visitor_answer,
        ( book_(_, Stream),
          summed_line(0, Row, Line),
          format(Stream, "~s~n", [Line]),
          atomic_sync(Stream),
          line_taken(Row) )).

%!  class_request(+Who, +Do:string, +Head:dict, -Reply:dict) is semidet.
%
%   Reply is that of the front itself to the request Head of a page of Who, a
%   visitor: `join`, with a name, or `class`, for the owner alone: who has done
%   what. Fails if Do is none of them.
%
%   @error request_error(no_class), request_error(owner_alone(class)),
%   request_error(bad_key(name, pupil))

class_request(Who, "join", Head, _{do:"join", name:Name}) :-
    in_class,
    (   get_dict(name, Head, Name0),
        pupil_name(Name0, Name)
    ->  true
    ;   request_error(bad_key(name, pupil))
    ),
    digest(Who, Digest),
    with_mutex(sg_visitor_answer_turn,
        ( (   pupil_(Digest, _, Turn)
          ->  true
          ;   predicate_property(pupil_(_, _, _), number_of_clauses(Turn))
          ),
          atom_string(Digest, Text),
          written(_{pupil:Text, name:Name, turn:Turn}) )).
class_request(Who, "class", _, _{do:"class", pupils:Pupils}) :-
    in_class,
    (   Who == owner
    ->  true
    ;   request_error(owner_alone(class))
    ),
    class_book(Pupils).

%   pupil_name(Text, Name) is semidet: Name is what one may be called.

pupil_name(Text, Name) :-
    string(Text),
    string_length(Text, Length),
    Length =< 60,
    normalize_space(string(Name), Text),
    Name \== "",
    \+ ( string_code(_, Name, Code), code_type(Code, cntrl) ).

class_book(Pupils) :-
    findall(Turn-_{name:Name, done:Done},
            ( pupil_(Digest, Name, Turn),
              done_of(Digest, Done) ),
            Pupils0),
    keysort(Pupils0, Pupils1),
    findall(Pupil, member(_-Pupil, Pupils1), Pupils).

in_class :-
    (   book_(_, _)
    ->  true
    ;   request_error(no_class)
    ).

%!  class_pupil(+Who, -Pupil:dict) is semidet.
%
%   The visitor Who is in the class: Pupil has `name`, `turn` and `done`.

class_pupil(Who, _{name:Name, turn:Turn, done:Done}) :-
    digest(Who, Digest),
    pupil_(Digest, Name, Turn),
    done_of(Digest, Done).

%   done_of(Digest, Done): what that pupil did, of each problem.

done_of(Digest, Done) :-
    findall(_{ problem:Problem, number:Number, tries:Tries, answers:Answers,
               right:Right, shown:Shown },
            done_(Digest, Problem, Number, Tries, Answers, Right, Shown),
            Done).

%!  answers_recorded(+Who, +Reply:dict) is semidet.
%
%   Reply is what a session says of a problem, asked by the visitor Who. What
%   was answered stands in the book; fails if there is nothing to record.

answers_recorded(Who, Reply) :-
    Who \== owner,
    get_dict(checked, Reply, Checked),
    digest(Who, Digest),
    pupil_(Digest, _, _),
    findall(Right, ( member(One, Checked), Right = One.right ), Rights),
    findall(Given, ( member(One, Checked), Given = One.given ), Answers),
    ( all_true(Rights) -> Shown = false
    ; Reply.shows == "answer" -> Shown = true
    ; Shown = false
    ),
    get_time(Now),
    Time is integer(Now),
    atom_string(Digest, Text),
    written(_{ pupil:Text, problem:Reply.problem, number:Reply.number,
               answers:Answers, right:Rights, shown:Shown, time:Time }).
