:- module(sg_line_change,
          [ changed_lines/4             % +Before, +After, +Head, -Reply
          ]).
:- use_module('../picture/contour', [line_ends/4]).
:- use_module('../store', [drawn/7]).
:- use_module(port, [with_picture/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Which lines of a picture came, went, or changed, from one world to
another: what other rules do to it.
*/

%!  changed_lines(+Before, +After, +Head:dict, -Reply:dict) is det.
%
%   Reply tells the pictures of two worlds apart, seen as Head says of the
%   request `view`. Lines are known by their names; one whose role, visible
%   parts or place is another one has changed.

changed_lines(Before, After, Head,
              _{came:Came, went:Went, changed:Changed,
                count:_{came:N1, went:N2, changed:N3}}) :-
    picture_lines(Before, Head, Old),
    picture_lines(After, Head, New),
    compared(Old, New, Came, Went, Changed),
    length(Came, N1),
    length(Went, N2),
    length(Changed, N3).

%   picture_lines(World, Head, Lines): (S-E)-Parts, in order.

picture_lines(World, Head, Lines) :-
    with_picture(World, Head,
                 findall((S-E)-part(From, To, Visibility, Role, Start, End),
                         ( drawn(_, S, E, From, To, Visibility, Role),
                           line_ends(S, E, Start, End) ),
                         Parts0)),
    sort(Parts0, Parts),
    group_pairs_by_key(Parts, Lines).

compared([], New, Came, [], []) :-
    !,
    names(New, Came).
compared(Old, [], [], Went, []) :-
    !,
    names(Old, Went).
compared([Line1-Parts1|Old], [Line2-Parts2|New], Came, Went, Changed) :-
    compare(Order, Line1, Line2),
    (   Order = (=)
    ->  (   Parts1 == Parts2
        ->  Changed = Changed1
        ;   name(Line1, Name),
            Changed = [Name|Changed1]
        ),
        compared(Old, New, Came, Went, Changed1)
    ;   Order = (<)
    ->  name(Line1, Name),
        Went = [Name|Went1],
        compared(Old, [Line2-Parts2|New], Came, Went1, Changed)
    ;   name(Line2, Name),
        Came = [Name|Came1],
        compared([Line1-Parts1|Old], New, Came1, Went, Changed)
    ).

names(Lines, Names) :-
    findall(Name, ( member(Line-_, Lines), name(Line, Name) ), Names).

name(S-E, Name) :-
    format(string(Name), "s~de~d", [S,E]).
