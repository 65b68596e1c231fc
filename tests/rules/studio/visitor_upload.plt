/* Files that pages send: a ticket is for one file, once, for a while. */
:- module(test_visitor_upload, []).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(studio/visitor_upload)).

%   with_visitor(Goal): call(Goal, Visitor), whose folder is empty and goes
%   away.

:- meta_predicate with_visitor(1).

with_visitor(Goal) :-
    tmp_file(state, State),
    make_directory(State),
    ( getenv('XDG_STATE_HOME', Old) -> true ; Old = none ),
    setup_call_cleanup(
        setenv('XDG_STATE_HOME', State),
        call(Goal, 'pupil abc'),
        ( ( Old == none -> unsetenv('XDG_STATE_HOME')
          ; setenv('XDG_STATE_HOME', Old) ),
          catch(delete_directory_and_contents(State), error(_, _), true) )).

sent(Visitor, Name) :-
    upload_ticket(Visitor, _{name:Name}, Ticket),
    upload_taken(Ticket, File),
    setup_call_cleanup(open(File, write, Out), true, close(Out)).

once_each(Visitor) :-
    upload_ticket(Visitor, _{name:"a.pl"}, Ticket1),
    upload_ticket(Visitor, _{name:"b.pl"}, Ticket2),
    assertion(Ticket1 \== Ticket2),
    upload_taken(Ticket2, File2),
    upload_taken(Ticket1, File1),
    assertion(( file_base_name(File1, 'a.pl'), file_base_name(File2, 'b.pl') )),
    file_directory_name(File1, Folder),
    visitor_folder(Visitor, Folder1),
    assertion(same_file(Folder, Folder1)),
    assertion(\+ upload_taken(Ticket1, _)),
    assertion(\+ upload_taken("no ticket", _)).

late(Visitor) :-
    upload_ticket(Visitor, _{name:"a.pl"}, Ticket),
    retract(sg_visitor_upload:upload_(Ticket, File, Until)),
    get_time(Now),
    assertion(( Until > Now+50, Until =< Now+60 )),
    Past is Now-1,
    assertz(sg_visitor_upload:upload_(Ticket, File, Past)),
    assertion(\+ upload_taken(Ticket, _)),
    assertion(\+ sg_visitor_upload:upload_(Ticket, _, _)).

many(Names-More-Again, Visitor) :-
    forall(between(1, 20, N),
           ( format(string(Name), "f~|~`0t~d~2+.pl", [N]),
             sent(Visitor, Name) )),
    uploads(Visitor, Names),
    catch(( upload_ticket(Visitor, _{name:"more.pl"}, _), More = none ),
          error(request_error(More), _), true),
    catch(( upload_ticket(Visitor, _{name:"f07.pl"}, _), Again = none ),
          error(request_error(Again), _), true).

apart(Own, Visitor) :-
    sent(Visitor, "a.pl"),
    findall(Names,
            ( member(V, [Visitor,'pupil xyz',owner]), uploads(V, Names) ),
            Own).

:- begin_tests(visitor_upload).

test(once) :-
    with_visitor(once_each).
test(late) :-
    with_visitor(late).
test(many, N-First-More-Again
           == 20-"f01.pl"-too_many_uploads(20)-none) :-
    with_visitor(many(Names-More-Again)),
    length(Names, N),
    Names = [First|_].
test(apart, Own == [["a.pl"],[],[]]) :-
    with_visitor(apart(Own)).

:- end_tests(visitor_upload).
