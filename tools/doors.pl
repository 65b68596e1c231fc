/* Makes the glue between Prolog and C from the modes in rules/kernel/ and the
   types in c_kernels/doors.def, which says how both are written:

       swipl -f none tools/doors.pl -- FOLDER

   writes FOLDER/doors.c and, for each module, FOLDER/doors/TOPIC.h. A file that
   would not change is left alone.
*/
:- module(sg_doors, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(doors_declared).
:- use_module(doors_header).
:- use_module(doors_glue).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Folder|_]),
    read_types('c_kernels/doors.def'),
    expand_file_name('rules/kernel/*.pl', Files),
    maplist(topic_doors, Files, Topics),
    directory_file_path(Folder, doors, Headers),
    make_directory_path(Headers),
    forall(member(Topic, Topics), write_header(Headers, Topic)),
    directory_file_path(Folder, 'doors.c', Glue),
    write_if_new(Glue, glue(Topics)).

write_header(Folder, topic(Topic,Doors)) :-
    file_name_extension(Topic, h, Base),
    directory_file_path(Folder, Base, File),
    write_if_new(File, header(Topic, Doors)).

%   write_if_new(File, Goal): File is what Goal prints.

write_if_new(File, Goal) :-
    with_output_to(string(Text), Goal),
    (   exists_file(File),
        read_file_to_string(File, Text, [])
    ->  true
    ;   setup_call_cleanup(open(File, write, Out),
                           write(Out, Text),
                           close(Out))
    ).
