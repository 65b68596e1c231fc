:- module(sg_openscad_en,
          [ openscad_en//1,             % +What
            openscad_names//1,          % +Names
            openscad_value/2            % +Value, -Text
          ]).
/** <module> What is wrong with an OpenSCAD .csg file, in English.

openscad_ko.pl has the same heads in Korean (tests/rules/model/openscad.plt).
*/

%!  openscad_names(+Names)// is det.
%
%   Names on a line of their own, in every language.

openscad_names(Names) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ nl, '  ~w'-[Text] ].

%!  openscad_en(+What)// is det.
%
%   The message for model_error(openscad(What)).

openscad_en(expected(Wanted, Found)) -->
    { wanted_en(Wanted, Word),
      found_en(Found, Text)
    },
    [ 'here stands ~w, where ~w should come'-[Text, Word], nl,
      '  A .csg file is what `openscad -o FILE.csg` writes; a .scad file has \c
       to go through it first.' ].
openscad_en(open_string) -->
    [ 'the string that begins here does not end', nl,
      '  Write a " behind it.' ].
openscad_en(open_comment) -->
    [ 'the comment that begins here does not end', nl,
      '  Write */ behind it.' ].
openscad_en(strange(Character)) -->
    [ 'the character ~q means nothing here'-[Character], nl,
      '  A .csg file is what `openscad -o FILE.csg` writes; a .scad file has \c
       to go through it first.' ].
openscad_en(unsupported(Name, Names)) -->
    [ '~w is not read; these are'-[Name] ],
    openscad_names(Names),
    [ nl, '  Let OpenSCAD work it out: `openscad -o FILE.stl`, and use the \c
           mesh.' ].
openscad_en(unknown(Name, Names)) -->
    [ 'there is no ~w; these are read'-[Name] ],
    openscad_names(Names),
    [ nl, '  A .scad file has to go through `openscad -o FILE.csg` first.' ].
openscad_en(missing(Name, Argument)) -->
    { argument_en(Argument, Word) },
    [ '~w needs ~w'-[Name, Word], nl,
      '  Write the file with OpenSCAD, or add it.' ].
openscad_en(argument(Name, Argument, Value, Type)) -->
    { argument_en(Argument, Word),
      value_type_en(Type, Wanted),
      openscad_value(Value, Text)
    },
    [ '~w of ~w is ~w; it should be ~w'-[Word, Name, Text, Wanted], nl,
      '  Correct the value.' ].
openscad_en(unknown_argument(Name, Argument, Names)) -->
    { argument_en(Argument, Word) },
    [ '~w has ~w, which is not read; these are'-[Name, Word] ],
    openscad_names(Names),
    [ nl, '  A .scad file has to go through `openscad -o FILE.csg` first.' ].
openscad_en(childless(Name)) -->
    [ '~w has something below it'-[Name], nl,
      '  Put it beside it, under a group().' ].
openscad_en(no_point(Name, I)) -->
    [ 'the ~w has the point ~d, which is not there'-[Name, I], nl,
      '  Points are counted from 0.' ].
openscad_en(flat) -->
    [ 'the model is flat: a drawing in the plane, no solid', nl,
      '  Put it under a linear_extrude() or a rotate_extrude().' ].
openscad_en(mixed(Name)) -->
    [ 'solids and flat figures under one ~w'-[Name], nl,
      '  Extrude the flat ones, or take them away.' ].
openscad_en(flat_extrusion(Name)) -->
    [ '~w of a solid; it takes flat figures'-[Name], nl,
      '  Give it square(), circle() or polygon().' ].
openscad_en(across_axis(X1, X2)) -->
    [ 'what is to be turned is on both sides of the axis: from x = ~w to ~w'-
          [X1, X2], nl,
      '  Move it to one side, or cut it off there.' ].
openscad_en(nothing) -->
    [ 'there is nothing in the model', nl,
      '  Empty groups, sizes of 0 and what has * or % before it count for \c
       nothing.' ].

wanted_en(name, 'the name of a node') :- !.
wanted_en(body, '; or {') :- !.
wanted_en(value, 'a value') :- !.
wanted_en(Sign, Sign).

found_en(end, 'the end of the file') :- !.
found_en(Found, Text) :-
    openscad_value(Found, Text).

argument_en(N, Word) :-
    (   integer(N)
    ->  format(atom(Word), 'argument ~d', [N])
    ;   Word = N
    ).

%!  openscad_value(+Value, -Text) is det.
%
%   Text shows Value, not all of a long one; in every language.

openscad_value(Value, Text) :-
    format(string(Text0), '~p', [Value]),
    (   string_length(Text0, Length),
        Length > 60
    ->  sub_string(Text0, 0, 60, _, Text1),
        string_concat(Text1, '...', Text)
    ;   Text = Text0
    ).

value_type_en(number, 'a number').
value_type_en(count, 'a number').
value_type_en(flag, 'true or false').
value_type_en(size2, 'a number or [X, Y]').
value_type_en(size3, 'a number or [X, Y, Z]').
value_type_en(factors, 'a factor from 0, or [X, Y]').
value_type_en(points2, 'a list of points [X, Y]').
value_type_en(points3, 'a list of points [X, Y, Z]').
value_type_en(faces, 'a list of lists of numbers of points').
value_type_en(matrix, 'four rows of four numbers, the last [0, 0, 0, 1]').
