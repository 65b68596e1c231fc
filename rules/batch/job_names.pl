:- module(sg_job_names,
          [ jobs_checked/2              % +Manifest, -Count
          ]).
:- use_module(job_name, [stem_path/3]).
:- use_module(job_words, [output_option/1]).
:- use_module(manifest, [manifest_job/3]).
:- use_module('../kernel', [atomic_scratch/3, atomic_drop/1]).
:- use_module('../model/model_text', [place_error/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(process), [process_create/3]).
:- use_module(library(readutil), [read_line_to_string/2]).
/** <module> A manifest is checked whole before its first job.

No two jobs may have one name, or write one file. The names go to a file and are
sorted there, so a million of them need no memory.
*/

%!  jobs_checked(+Manifest, -Count) is det.
%
%   Count jobs are in Manifest, and nothing is wrong with any.
%
%   @error as manifest_job/3; model_error(manifest(What)) with What twice(Name,
%   Older, Path), both Name and Older make the file Path; `no_jobs`

jobs_checked(Manifest, Count) :-
    setup_call_cleanup(
        atomic_scratch('.txt', Id, File),
        ( names_written(File, Manifest, Count, Lines),
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

names_written(File, Manifest, Count, Lines) :-
    State = counts(0, 0),
    setup_call_cleanup(
        open(File, write, Out, [encoding(utf8)]),
        forall(manifest_job(Manifest, true, Job),
               names_of(Job, Out, State)),
        close(Out)),
    State = counts(Count, Lines).

names_of(Job, Out, State) :-
    forall(path_of(Job, Path),
           ( format(Out, '~w~n', [Path]),
             raised(2, State) )),
    raised(1, State).

raised(Place, State) :-
    arg(Place, State, N0),
    N is N0+1,
    nb_setarg(Place, State, N).

%   path_of(Job, Path) is nondet: a file of Job, or its stem, with which others
%   begin.

path_of(job(_, _, Stem, _, _, _, _, _), Stem).
path_of(job(_, _, Stem, _, _, Options, _, _), Path) :-
    member(Name-Pattern, Options),
    output_option(Name),
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
    twice(Sorted, Path).
repeated(File, _, Path) :-
    file_directory_name(File, Folder),
    setup_call_cleanup(
        process_create(path(sort), ['-S', '64M', '-T', Folder, '--', File],
                       [ stdout(pipe(Out, [encoding(utf8)])),
                         environment(['LC_ALL'='C']) ]),
        ( read_line_to_string(Out, First),
          twice_in(Out, First, Path) ),
        close(Out, [force(true)])).

twice([Path,Path|_], Path) :-
    Path \== "",
    !.
twice([_|Paths], Path) :-
    twice(Paths, Path).

twice_in(Out, Before, Path) :-
    read_line_to_string(Out, Line),
    Line \== end_of_file,
    (   Line == Before
    ->  Path = Line
    ;   twice_in(Out, Line, Path)
    ).

%   twice_error(Manifest, Path): the jobs that make it are looked up again.

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
    job_error(Place, twice(Name, Older, Path)).

job_error(line(File, Line), What) :-
    !,
    throw(error(model_error(manifest(What)), location(File, Line, 1))).
job_error(Place, What) :-
    place_error(Place, manifest(What)).
