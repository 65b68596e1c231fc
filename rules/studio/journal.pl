:- module(sg_journal,
          [ journal_begun/6,            % +Path, +File, +Digest, +Text, +Steps,
                                        % -Journal
            journal_line/2,             % +Journal, +Step
            journal_steps/3,            % +Path, +Digest, -Steps
            journal_whole/3,            % +Path, -Text, -Steps
            summed_line/3,              % +At, +Step, -Line
            line_step/4,                % ?Form, +At, +Line, -Step
            other_end/2,                % +At, +Line
            damaged_step/1,             % -Step
            journal_gone/1,             % +Path
            journal_closed/1            % +Journal
          ]).
:- use_module('../kernel', [atomic_sync/1, atomic_sync_folder/1]).
:- use_module(document_content, [text_digest/2]).
:- use_module(library(http/json), [json_read_dict/2, json_write_dict/3]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(filesex), [make_directory_path/1]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
/** <module> The journal of a document: what was changed since its file was
saved.

Each change is a line, which is on the disk before anybody is told that the
change was made. So nothing is lost when the process is killed, or the machine
loses its power. A last line that is not complete was told to nobody.

Behind the object of a line stands a space and its sum, of what the line holds
and of where it begins: a line that was changed, or moved by another one, is
damaged. The journal of an older version, `"journal":1`, has no sums.

Whole lines that are missing at the end leave a journal that is sound. So a file
beside it, PATH.end, holds how many octets were on the disk when the last change
was told. It is written after each line and asked to be on the disk by nobody:
when the machine loses its power it may say less than there is, never more.
*/

:- dynamic begun/3.                     % Journal, Path, Digest: of its text

%!  journal_begun(+Path, +File, +Digest, +Text, +Steps, -Journal) is det.
%
%   Path is a new journal of File, which holds Text with this Digest; it begins
%   with Steps. An old one is there until all of that is on the disk.

journal_begun(Path, File, Digest, Text, Steps, Journal) :-
    file_directory_name(Path, Folder),
    catch(make_directory_path(Folder), error(_, _), true),
    atom_concat(Path, '.new', New),
    open(New, write, Journal, [encoding(utf8), newline(posix)]),
    atom_string(File, Name),
    catch(( journal_lines(Journal, [_{ journal:2, file:Name, digest:Digest,
                                       text:Text }|Steps]),
            end_forgotten(Path),
            rename_file(New, Path),
            atomic_sync_folder(Path)
          ),
          Error,
          ( journal_closed(Journal),
            catch(delete_file(New), error(_, _), true),
            throw(Error)
          )),
    assertz(begun(Journal, Path, Digest)),
    end_remembered(Journal).

%!  journal_line(+Journal, +Step:dict) is det.
%
%   Step stands in the Journal, on the disk; `none` is no journal, and
%   failed(Journal, Error) one of which that was not so.

journal_line(none, _) :-
    !.
journal_line(failed(_, Error), _) :-
    throw(Error).
journal_line(Journal, Step) :-
    journal_lines(Journal, [Step]),
    end_remembered(Journal).

journal_lines(Journal, Steps) :-
    forall(member(Step, Steps), line_written(Journal, Step)),
    atomic_sync(Journal).

line_written(Journal, Step) :-
    byte_count(Journal, At),
    summed_line(At, Step, Line),
    format(Journal, "~s~n", [Line]).

%!  summed_line(+At:integer, +Step:dict, -Line:string) is det.
%
%   Line holds Step and its sum; it begins At so many octets of its file, or At
%   is 0 wherever it does.

summed_line(At, Step, Line) :-
    step_object(Step, Object),
    line_sum(At, Object, Sum),
    format(string(Line), "~s ~s", [Object,Sum]).

step_object(Step, Object) :-
    with_output_to(string(Object),
                   json_write_dict(current_output, Step, [width(0)])).

%   line_sum(At, Object, Sum): of a line that begins At so many octets.

line_sum(At, Object, Sum) :-
    format(string(Text), "~d ~s", [At,Object]),
    text_digest(Text, Digest),
    sum_length(Length),
    sub_string(Digest, 0, Length, _, Sum).

sum_length(16).

%   end_remembered(Journal): all that it holds is on the disk. Who cannot write
%   that loses no change.

end_remembered(Journal) :-
    begun(Journal, Path, Digest),
    byte_count(Journal, Octets),
    summed_line(0, _{digest:Digest, octets:Octets}, Line),
    end_path(Path, End),
    catch(setup_call_cleanup(
              open(End, write, Out, [encoding(utf8), newline(posix)]),
              format(Out, "~s~n", [Line]),
              close(Out)),
          error(_, _), true).

end_forgotten(Path) :-
    end_path(Path, End),
    catch(delete_file(End), error(_, _), true).

end_path(Path, End) :-
    atom_concat(Path, '.end', End).

%   end_missing(Path, Head): the journal in Path, with this first line, was
%   longer when a change was told.

end_missing(Path, Head) :-
    end_path(Path, End),
    catch(read_file_to_string(End, Text, [encoding(utf8)]), error(_, _), fail),
    string_concat(Line, "\n", Text),
    line_step(2, 0, Line, Told),
    get_dict(digest, Told, Digest),
    get_dict(digest, Head, Digest),
    get_dict(octets, Told, Octets),
    size_file(Path, Size),
    Size < Octets.

%!  journal_gone(+Path) is det.
%
%   There is no journal in Path any more.

journal_gone(Path) :-
    catch(delete_file(Path), error(_, _), true),
    end_forgotten(Path).

%!  journal_closed(+Journal) is det.

journal_closed(none) :-
    !.
journal_closed(failed(Journal, _)) :-
    !,
    journal_closed(Journal).
journal_closed(Journal) :-
    retractall(begun(Journal, _, _)),
    catch(close(Journal, [force(true)]), error(_, _), true).

%!  journal_steps(+Path, +Digest, -Steps) is semidet.
%
%   Path is a journal. Steps are the changes of the text with this Digest, a
%   list of dicts, the first one first; `other` if its changes are of another
%   text.
%   A last line that is not complete is left out; one that holds no dict is
%   damaged_step/1, and so is what is missing at the end. Fails if Path is no
%   journal.
%
%   A line says that the text is about to be saved; who is killed then leaves
%   the file either as it was before or as it is saved. It has the rules that
%   the text follows, for the file has none.

journal_steps(Path, Digest, Steps) :-
    exists_file(Path),
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8)]),
        ( head(In, Form, Head),
          get_dict(digest, Head, First),
          all_steps(In, Form, Path, Head, Steps0)
        ),
        close(In)),
    (   append(_, [Saved|Behind], Steps0),
        get_dict(digest, Saved, Digest),
        \+ ( member(Later, Behind), get_dict(digest, Later, Digest) )
    ->  exclude(is_save, Behind, Steps1),
        (   get_dict(rules, Saved, Rules)
        ->  Steps = [_{do:"rules", rules:Rules}|Steps1]
        ;   Steps = Steps1
        )
    ;   First == Digest
    ->  exclude(is_save, Steps0, Steps)
    ;   Steps0 == []
    ->  Steps = []
    ;   Steps = other
    ).

%!  journal_whole(+Path, -Text, -Steps) is semidet.
%
%   Path is a journal that began with Text; Steps are all changes since,
%   whatever the file holds.

journal_whole(Path, Text, Steps) :-
    exists_file(Path),
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8)]),
        ( head(In, Form, Head),
          get_dict(text, Head, Text),
          string(Text),
          all_steps(In, Form, Path, Head, Steps0)
        ),
        close(In)),
    exclude(is_save, Steps0, Steps).

is_save(Step) :-
    get_dict(do, Step, "save"),
    get_dict(digest, Step, _).

%   head(In, Form, Head) is semidet: the first line, of a journal of this Form.

head(In, Form, Head) :-
    read_string(In, "\n", "", 0'\n, Line),
    line_step(Form, 0, Line, Head),
    get_dict(journal, Head, Form),
    !.

all_steps(In, Form, Path, Head, Steps) :-
    steps(In, Form, Steps0),
    (   end_missing(Path, Head)
    ->  damaged_step(Step),
        append(Steps0, [Step], Steps)
    ;   Steps = Steps0
    ).

steps(In, Form, Steps) :-
    (   step(In, Form, Step)
    ->  Steps = [Step|Steps1],
        steps(In, Form, Steps1)
    ;   Steps = []
    ).

%   step(In, Form, Step): fails at the end, and at what is no complete line: one
%   that lacks its newline alone was told to nobody either. One that has
%   something else for its newline was.

step(In, Form, Step) :-
    byte_count(In, At),
    read_string(In, "\n", "", End, Line),
    (   End =:= -1
    ->  Form =:= 2,
        other_end(At, Line),
        damaged_step(Step)
    ;   End =:= 0'\n,                  % not 0, which ends strings, too
        line_step(Form, At, Line, Step0)
    ->  Step = Step0
    ;   damaged_step(Step)
    ).

%!  line_step(?Form, +At, +Line, -Step:dict) is nondet.
%
%   Line, which begins At so many octets, as of summed_line/3, holds Step. Form
%   is 2, or 1 without a sum.

line_step(2, At, Line, Step) :-
    sum_length(Length),
    sub_string(Line, Before, Length, 0, Sum),
    Before > 0,
    Before1 is Before-1,
    sub_string(Line, Before1, 1, _, " "),
    sub_string(Line, 0, Before1, _, Object),
    line_sum(At, Object, Sum),
    object_step(Object, Step).
line_step(1, _, Line, Step) :-
    sub_string(Line, _, 1, 0, "}"),
    object_step(Line, Step).

%!  other_end(+At, +Line) is semidet.
%
%   The last line of a file, of Form 2, has something else for its newline: half
%   a character is read as two.

other_end(At, Line) :-
    member(Length, [1,2]),
    sub_string(Line, 0, _, Length, Before),
    line_step(2, At, Before, _),
    !.

object_step(Object, Step) :-
    sub_string(Object, 0, _, _, "{"),
    catch(setup_call_cleanup(
              open_string(Object, Text),
              json_read_dict(Text, Step),
              close(Text)),
          error(_, _), fail),
    is_dict(Step),
    (   sub_string(Object, _, _, _, "\\u")
    ->  catch(step_object(Step, _), error(_, _), fail) % half a character?
    ;   true
    ).

%!  damaged_step(-Step:dict) is det.
%
%   Step stands for a line that says nothing which could be done.

damaged_step(_{do:"damaged"}).
