:- module(sg_environment,
          [ environment/2,              % +Name, -Value
            state_folder/1              % -Folder
          ]).
/** <module> What the environment of the process says.
*/

%!  environment(+Name, -Value:atom) is semidet.
%
%   Value is that of the environment variable Name. Fails if there is none, it
%   is empty, or its octets are no text in UTF-8.

environment(Name, Value) :-
    catch(getenv(Name, Value), error(_, _), fail),
    Value \== ''.

%!  state_folder(-Folder) is semidet.
%
%   Folder is where programs keep what is to be there when they start again:
%   XDG_STATE_HOME, or `.local/state` in HOME.

state_folder(Folder) :-
    (   environment('XDG_STATE_HOME', Folder0)
    ->  Folder = Folder0
    ;   environment('HOME', Home),
        atom_concat(Home, '/.local/state', Folder)
    ).
