:- module(sg_bisection,
          [ bisection/5                 % +Steps, :Holds, +Low, +High, -Largest
          ]).
/** <module> The largest number of which something holds, by bisection.
*/

:- meta_predicate bisection(+, 1, +, +, -).

%!  bisection(+Steps, :Holds, +Low, +High, -Largest) is det.
%
%   Largest is the largest number from Low on of which call(Holds, Number) is
%   true, less than (High-Low)/2^Steps below it. Holds is true of Low, not of
%   High, and changes once between them.

bisection(0, _, Low, _, Low) :-
    !.
bisection(Steps, Holds, Low, High, Largest) :-
    Middle is (Low+High)/2,
    Steps1 is Steps-1,
    (   call(Holds, Middle)
    ->  bisection(Steps1, Holds, Middle, High, Largest)
    ;   bisection(Steps1, Holds, Low, Middle, Largest)
    ).
