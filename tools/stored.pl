/* stored.pl -- a saved state with nothing in it compressed, and the files that
   the program carries with it.

       swipl -f none tools/stored.pl -- Compressed Stored File...

   The program reads its state at every start; qsave_program/2 has no option for
   this. It reads a File, when it wants it, as res://File; Prolog itself saves
   such files in a state without autoloading alone.
*/

:- use_module(library(lists), [member/2]).
:- use_module(library(main), [main/0]).
:- use_module(library(zip),
              [ zip_close/1, zip_open/4, zipper_goto/2, zipper_members/2,
                zipper_open_current/3, zipper_open_new_file_in_zip/4
              ]).

:- initialization(main, main).

main([Compressed,Stored|Files]) :-
    setup_call_cleanup(
        zip_open(Compressed, read, From, []),
        setup_call_cleanup(
            zip_open(Stored, write, To, []),
            ( zipper_members(From, Members),
              forall(member(Member, Members), stored(Member, From, To)),
              forall(member(File, Files), carried(File, To))
            ),
            zip_close(To)),
        zip_close(From)).

stored(Member, From, To) :-
    zipper_goto(From, file(Member)),
    setup_call_cleanup(
        zipper_open_current(From, In, [type(binary)]),
        put(Member, In, To),
        close(In)).

carried(File, To) :-
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        put(File, In, To),
        close(In)).

put(Member, In, To) :-
    setup_call_cleanup(
        zipper_open_new_file_in_zip(To, Member, Out,
                                    [type(binary),method(store)]),
        copy_stream_data(In, Out),
        close(Out)).
