:- module(sg_about,
          [ said_about/2,               % +Name, :Goal
            about/1                     % -Name
          ]).
/** <module> What notices and warnings are about.

A command that makes many things says of which one it is that it has something
to say: spoken.pl puts the name before the message.
*/

:- meta_predicate said_about(+, 0).

:- thread_local
    name/1.

%!  said_about(+Name, :Goal) is semidet.
%
%   Call Goal once; what it says meanwhile is about Name. Of a Name line(N), a
%   line of standard input, errors are told too.

said_about(Name, Goal) :-
    setup_call_cleanup(asserta(name(Name), Ref), once(Goal), erase(Ref)).

%!  about(-Name) is semidet.
%
%   What is said now is about Name.

about(Name) :-
    name(Name),
    !.
