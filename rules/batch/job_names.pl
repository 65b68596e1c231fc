:- module(sg_job_names,
          [ jobs_checked/3              % +Manifest, +Show, -Count
          ]).
:- use_module(job_name, [stem_path/3]).
:- use_module(job_words, [output_file/3]).
:- use_module(manifest, [manifest_job/3]).
:- use_module('../kernel', [atomic_scratch/3, atomic_drop/1]).
:- use_module('../model/model_text', [place_error/2]).
:- use_module('../progress', [line_cleared/0, progress_line/1]).
:- use_module(library(lists), [member/2]).
:- use_module(library(process), [process_create/3]).
:- use_module(library(readutil), [read_line_to_string/2]).
/** <module> A manifest is checked whole before its first job.

No two jobs may have one name, or write one file. The names go to a file and are
sorted there, so a million of them need no memory.
*/

%!  jobs_checked(+Manifest, +Show:boolean, -Count) is det.
%
%   Count jobs are in Manifest, and nothing is wrong with any. If Show is
%   `true`, a terminal shows how many have been looked at; elsewhere that is
%   told after 2, 4, 8, ... seconds.
%
%   @error as manifest_job/3; model_error(manifest(What)) with What twice(Name,
%   Older, Path), both Name and Older make the file Path; folder_too(Name,
%   Path), Path is a folder as well; `no_jobs`

jobs_checked(Manifest, Show, Count) :-
    setup_call_cleanup(
        atomic_scratch('.txt', Id, File),
        ( names_written(File, Manifest, Show, Count, Lines),
          sorting_told(Show, Count, Lines),
          (   repeated(File, Lines, Path)
          ->  twice_error(Manifest, Path)
          ;   true
          ) ),
        atomic_drop(Id)),
    (   Count =:= 0
    ->  no_jobs(Manifest)
    ;   true
    ).

no_jobs(Manifest) :-
    arg(1, Manifest, Name),
    throw(error(model_error(manifest(no_jobs)), location(Name, 0, 0))).

names_written(File, Manifest, Show, Count, Lines) :-
    get_time(Start),
    State = counts(0, 0, told(Start, 2)),
    retractall(folder(_)),
    setup_call_cleanup(
        open(File, write, Out, [encoding(utf8)]),
        forall(manifest_job(Manifest, true, Job),
               names_of(Job, Out, Show, State)),
        ( close(Out),
          line_cleared )),
    State = counts(Count, Lines, _).

names_of(Job, Out, Show, State) :-
    forall(path_of(Job, Path),
           ( format(Out, '~w~n', [Path]),
             folders_noted(Path),
             raised(2, State) )),
    raised(1, State),
    count_shown(Show, State).

%   Folders in the names of files; they have no `%`, so they are few.

:- dynamic folder/1.

folders_noted(Path) :-
    (   sub_atom(Path, Before, 1, _, /),
        sub_atom(Path, 0, Before, _, Folder),
        \+ folder(Folder),
        assertz(folder(Folder)),
        fail
    ;   true
    ).

%   count_shown(Show, State): every so many jobs, how many have been looked at.

count_shown(true, State) :-
    State = counts(Count, _, told(Start, Seconds)),
    Count mod 1000 =:= 0,
    !,
    Notice = sanggwan(batch(looked_at(Count))),
    (   stream_property(user_error, tty(true))
    ->  progress_line(Notice)
    ;   get_time(Now),
        Now-Start >= Seconds
    ->  print_message(informational, Notice),
        Seconds1 is 2*Seconds,
        nb_setarg(3, State, told(Start, Seconds1))
    ;   true
    ).
count_shown(_, _).

raised(Place, State) :-
    arg(Place, State, N0),
    N is N0+1,
    nb_setarg(Place, State, N).

%   path_of(Job, Path) is nondet: a file of Job, or its stem, with which others
%   begin.

path_of(job(_, _, Stem, _, _, _, _, _), Path) :-
    atom_concat('%', Stem, Path).       % no file is called so
path_of(job(_, _, Stem, _, _, Options, _, _), Path) :-
    member(Option, Options),
    output_file(Option, _, Pattern),
    stem_path(Pattern, Stem, Path).

%   few(Lines): so many are sorted here.

few(Lines) :-
    Lines =< 20_000.

repeated(File, Lines, Path) :-
    few(Lines),
    !,
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        read_string(In, _, Text),
        close(In)),
    split_string(Text, "\n", "", All),
    msort(All, Sorted),
    (   twice(Sorted, Path)
    ->  true
    ;   member(Path, Sorted),
        is_folder(Path)
    ->  true
    ).
repeated(File, _, Path) :-
    file_directory_name(File, Folder),
    setup_call_cleanup(
        process_create(path(sort), ['-S', '64M', '-T', Folder, '--', File],
                       [ stdout(pipe(Out, [encoding(utf8)])),
                         environment(['LC_ALL'='C']) ]),
        twice_in(Out, "", Path),
        close(Out, [force(true)])).

%   sorting_told(Show, Count, Lines): of what takes long.

sorting_told(Show, Count, Lines) :-
    (   Show == true,
        Lines > 2_000_000
    ->  print_message(informational, sanggwan(batch(sorted(Count))))
    ;   true
    ).

twice([Path,Path|_], Path) :-
    Path \== "",
    !.
twice([_|Paths], Path) :-
    twice(Paths, Path).

twice_in(Out, Before, Path) :-
    read_line_to_string(Out, Line),
    Line \== end_of_file,
    (   ( Line == Before ; is_folder(Line) )
    ->  Path = Line
    ;   twice_in(Out, Line, Path)
    ).

is_folder(Line) :-
    folder(_),
    atom_string(Path, Line),
    folder(Path).

%   twice_error(Manifest, Path): the jobs that make it are looked up again.

twice_error(Manifest, Path0) :-
    atom_string(Path, Path0),
    folder(Path),
    !,
    manifest_job(Manifest, false, Job),
    path_of(Job, Path),
    !,
    Job = job(_, Name, _, _, _, _, _, Place),
    job_error(Place, folder_too(Name, Path)).
twice_error(Manifest, Path0) :-
    atom_string(Path, Path0),
    State = first(none),
    manifest_job(Manifest, false, Job),
    path_of(Job, Path),
    Job = job(_, Name, _, _, _, _, _, Place),
    arg(1, State, First),
    (   First == none
    ->  nb_setarg(1, State, found(Name)),
        fail
    ;   First = found(Older)
    ),
    !,
    (   atom_concat('%', Stem, Path)
    ->  Both = Stem
    ;   Both = Path
    ),
    job_error(Place, twice(Name, Older, Both)).

job_error(line(File, Line), What) :-
    !,
    throw(error(model_error(manifest(What)), location(File, Line, 1))).
job_error(Place, What) :-
    place_error(Place, manifest(What)).
