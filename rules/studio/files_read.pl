:- module(sg_files_read,
          [ files_read/2                % :Goal, -Files
          ]).
:- use_module(library(lists), [member/2]).
:- use_module(library(prolog_wrap), [wrap_predicate/4, unwrap_predicate/2]).
/** <module> Which files users' code reads: goals and rule files may open any.
*/

:- meta_predicate files_read(0, -).

:- dynamic opened/2.                    % File, Mode

%!  files_read(:Goal, -Files) is semidet.
%
%   Call Goal once. Files are the regular files, in order, that were opened to
%   be read meanwhile, and not written, without those of Prolog itself.

files_read(Goal, Files) :-
    retractall(opened(_, _)),
    setup_call_cleanup(watched, once(Goal), unwatched),
    findall(File, file_read(File), Files0),
    retractall(opened(_, _)),
    sort(Files0, Files).

watched :-
    wrap_predicate(system:open(File4, Mode4, _, _), sg_files_read, Opened4,
                   ( sg_files_read:noted(File4, Mode4), Opened4 )),
    wrap_predicate(system:open(File3, Mode3, _), sg_files_read, Opened3,
                   ( sg_files_read:noted(File3, Mode3), Opened3 )),
    wrap_predicate(system:see(File), sg_files_read, Seen,
                   ( sg_files_read:noted(File, read), Seen )),
    wrap_predicate(system:tell(Told), sg_files_read, Tells,
                   ( sg_files_read:noted(Told, write), Tells )).

unwatched :-
    forall(member(PI, [open/4, open/3, see/1, tell/1]),
           unwrap_predicate(system:PI, sg_files_read)).

:- public noted/2.

noted(File0, Mode) :-
    (   ( atom(File0) ; string(File0) ),
        atom(Mode),
        catch(absolute_file_name(File0, File), error(_, _), fail),
        \+ opened(File, Mode)
    ->  assertz(opened(File, Mode))
    ;   true
    ).

file_read(File) :-
    opened(File, read),
    \+ ( opened(File, Mode), Mode \== read ),
    \+ of_prolog(File),
    exists_file(File).

of_prolog(File) :-
    (   current_prolog_flag(home, Home),
        atom_concat(Home, /, Folder)
    ;   member(Folder, ['/proc/', '/dev/', '/sys/'])
    ),
    sub_atom(File, 0, _, _, Folder),
    !.
