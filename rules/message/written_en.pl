:- module(sg_written_en,
          [ written_en//1,              % +What
            unwritten_en//1             % +What
          ]).
/** <module> Messages about solids written to files, in English.

written_ko.pl has the same heads in Korean (tests/rules/model/solid_file.plt).
*/

%!  written_en(+What)// is det.
%
%   The notice written(File, What).

written_en(rounds(1)) -->
    [ 'as rounded it goes through itself or lies on itself; united with \c
       itself once, on a coarser grid' ].
written_en(rounds(N)) -->
    { N > 1 },
    [ 'as rounded it goes through itself or lies on itself; united with \c
       itself ~D times, on coarser grids'-[N] ].
written_en(empty) -->
    [ 'the solid is empty: a file without faces' ].
written_en(collapsed) -->
    [ 'the solid is thinner than the rounding of its coordinates: a file \c
       without faces', nl,
      '  Move it nearer to the origin, or write it in a format with doubles \c
       (.off, .ply).' ].

%!  unwritten_en(+What)// is det.
%
%   The fault written(faulty(S, Rounds, What)): no file was written.

unwritten_en(open(N)) -->
    [ 'it is open at ~D edges'-[N], nl,
      '  Only a closed boundary can be written as a solid; see check.' ].
unwritten_en(undivided(N)) -->
    [ '~D of its faces cannot be divided into triangles'-[N] ],
    instead_en(other_file).
unwritten_en(crossing(N)) -->
    [ 'sheets of it cross along ~D edges'-[N] ],
    instead_en(other_file).
unwritten_en(penetrates(N, meeting(_, X, Y, Z))) -->
    [ 'it goes through itself in ~D places, first near ~g ~g ~g'-[N,X,Y,Z] ],
    instead_en(other_file).
unwritten_en(touches(N, meeting(_, X, Y, Z))) -->
    [ 'it lies on itself along a line in ~D places, first near \c
       ~g ~g ~g'-[N,X,Y,Z] ],
    instead_en(other_file).

instead_en(other_file) -->
    [ nl,
      '  Write it as .pl, which keeps it as it is; for .stl, a format with \c
       doubles (.off, .ply) may do.' ].
