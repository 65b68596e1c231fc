/* stored.pl -- a saved state with nothing in it compressed.

       swipl -f none tools/stored.pl -- Compressed Stored

   The program reads its state at every start; qsave_program/2 has no option for
   this.
*/

:- use_module(library(lists), [member/2]).
:- use_module(library(main), [main/0]).
:- use_module(library(zip),
              [ zip_close/1, zip_open/4, zipper_goto/2, zipper_members/2,
                zipper_open_current/3, zipper_open_new_file_in_zip/4
              ]).

:- initialization(main, main).

main([Compressed, Stored]) :-
    setup_call_cleanup(
        zip_open(Compressed, read, From, []),
        setup_call_cleanup(
            zip_open(Stored, write, To, []),
            ( zipper_members(From, Members),
              forall(member(Member, Members), stored(Member, From, To))
            ),
            zip_close(To)),
        zip_close(From)).

stored(Member, From, To) :-
    zipper_goto(From, file(Member)),
    setup_call_cleanup(
        zipper_open_current(From, In, [type(binary)]),
        setup_call_cleanup(
            zipper_open_new_file_in_zip(To, Member, Out,
                                        [type(binary),method(store)]),
            copy_stream_data(In, Out),
            close(Out)),
        close(In)).
