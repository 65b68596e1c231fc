:- module(sg_region_name,
          [ region_named/3,             % +S, +Name, -R
            region_name/3,              % +S, +R, -Name
            is_region_name/1            % @Name
          ]).
:- use_module('../store', [region/3, from_r/4]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [nth1/3]).
/** <module> Lasting names of the regions of a glue.

The number of a region is that of one evaluation; what it is inside stays when
other operands change:

    R                     the number, as it is now
    region(Operands)      the only region that is inside these operands, and no
                          others: region([1,3]); region([]) is a void
    region(Operands, K)   where there are several, the K-th of them by number

The outside has no such name.
*/

%!  is_region_name(@Name) is semidet.
%
%   Name has the form of one.

is_region_name(Name) :-
    integer(Name),
    !.
is_region_name(Name) :-
    compound(Name),
    (   Name = region(Operands)
    ->  true
    ;   Name = region(Operands, K),
        integer(K),
        K > 0
    ),
    is_list(Operands),
    maplist(integer, Operands).

%!  region_named(+S, +Name, -R) is semidet.
%
%   R is the region of segment S that has this Name. Fails if there is none, or
%   if there are several.

region_named(S, Name, R) :-
    (   integer(Name)
    ->  R = Name,
        once(region(S, R, _))
    ;   Name = region(Operands)
    ->  regions_inside(S, Operands, [R])
    ;   Name = region(Operands, K),
        regions_inside(S, Operands, Rs),
        nth1(K, Rs, R)
    ).

regions_inside(S, Operands0, Rs) :-
    sort(Operands0, Operands),
    findall(R, ( region(S, R, Role),
                 Role \== outside,
                 inside(S, R, Operands) ),
            Rs0),
    sort(Rs0, Rs).

inside(S, R, Operands) :-
    findall(S0, from_r(S, R, S0, _), Operands0),
    sort(Operands0, Operands).

%!  region_name(+S, +R, -Name) is semidet.
%
%   Name is the lasting name of the region R of segment S, that which has no
%   number if that will do. Fails for the outside.

region_name(S, R, Name) :-
    once(region(S, R, Role)),
    Role \== outside,
    inside(S, R, Operands),
    regions_inside(S, Operands, Rs),
    (   Rs == [R]
    ->  Name = region(Operands)
    ;   nth1(K, Rs, R),
        Name = region(Operands, K)
    ),
    !.
