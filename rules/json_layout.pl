:- module(sg_json_layout,
          [ json_laid_out/3             % +Out, +Value, +Width
          ]).
:- use_module(library(http/json), [json_write_dict/3]).
/** <module> JSON for people: in lines, the same with every SWI-Prolog.

How json_write_dict/3 breaks lines and where it puts spaces differs between
versions of its library; files that are kept must not. What fits is on one
line, else each pair or item has its own, two columns to the right; eight of
them are a tab.
*/

%!  json_laid_out(+Out, +Value, +Width) is det.
%
%   Write Value, of dicts, lists, texts, numbers, `true`, `false` and `null`, to
%   the stream Out, which stands at the beginning of a line, in lines of about
%   Width characters, or, if that is `inf`, in one line.

json_laid_out(Out, Value, Width) :-
    laid_out(Value, Out, Width, 0).

%   laid_out(Value, Out, Width, Indent)

laid_out(Value, Out, Width, Indent) :-
    parts(Value, Open, Close, Items),
    !,
    (   ( Width == inf ; wide(Value, Width, Indent, _) )
    ->  in_line(Value, Out)
    ;   write(Out, Open),
        Inner is Indent+2,
        items_in_lines(Items, Open, Out, Width, Inner),
        new_line(Out, Indent),
        write(Out, Close)
    ).
laid_out(Value, Out, _, _) :-
    scalar_written(Value, Out).

scalar_written(Value, Out) :-
    json_write_dict(Out, Value, [width(0)]).

%   parts(Value, Open, Close, Items): Items are Name-Value if Open is `{`.

parts(Value, '{', '}', Pairs) :-
    is_dict(Value),
    !,
    dict_pairs(Value, _, Pairs).
parts(Value, '[', ']', Value) :-
    is_list(Value).

%   item_value(Open, Item, Name, Value): Name is `none` if Open is `[`.

item_value('{', Name-Value, Name, Value).
item_value('[', Value, none, Value).

items_in_lines([], _, _, _, _).
items_in_lines([Item|Items], Open, Out, Width, Indent) :-
    item_value(Open, Item, Name, Value),
    new_line(Out, Indent),
    (   Open == '{'
    ->  name_written(Out, Name),
        compound_apart(Value, Out)
    ;   true
    ),
    laid_out(Value, Out, Width, Indent),
    (   Items == []
    ->  true
    ;   write(Out, ',')
    ),
    items_in_lines(Items, Open, Out, Width, Indent).

in_line(Value, Out) :-
    (   parts(Value, Open, Close, Items)
    ->  write(Out, Open),
        items_in_line(Items, Open, Out),
        write(Out, Close)
    ;   scalar_written(Value, Out)
    ).

items_in_line([], _, _).
items_in_line([Item|Items], Open, Out) :-
    item_value(Open, Item, Name, Value),
    (   Open == '{'
    ->  name_written(Out, Name)
    ;   true
    ),
    compound_apart(Value, Out),
    in_line(Value, Out),
    (   Items \== []
    ->  write(Out, ', ')
    ;   Open == '['
    ->  write(Out, ' ')
    ;   true
    ),
    items_in_line(Items, Open, Out).

name_written(Out, Name) :-
    atom_string(Name, Text),
    scalar_written(Text, Out),
    write(Out, ':').

compound_apart(Value, Out) :-
    (   parts(Value, _, _, _)
    ->  write(Out, ' ')
    ;   true
    ).

new_line(Out, Indent) :-
    Tabs is Indent//8,
    Spaces is Indent mod 8,
    format(Out, "~n~*c~*c", [Tabs,0'\t,Spaces,0' ]).

%   wide(Value, Width, Length0, Length): so long is a line with Value behind
%   Length0 characters; fails if that is more than Width.

wide(Value, Width, Length0, Length) :-
    (   parts(Value, Open, _, Items)
    ->  Length1 is Length0+2,
        Length1 =< Width,
        items_wide(Items, Open, Width, Length1, Length)
    ;   scalar_length(Value, Own),
        Length is Length0+Own,
        Length =< Width
    ).

items_wide([], _, _, Length, Length).
items_wide([Item|Items], Open, Width, Length0, Length) :-
    item_value(Open, Item, Name, Value),
    (   Open == '{'
    ->  atom_length(Name, Own),
        Length1 is Length0+Own+4
    ;   Length1 = Length0
    ),
    wide(Value, Width, Length1, Length2),
    (   Items == []
    ->  Length = Length2
    ;   Length3 is Length2+2,
        items_wide(Items, Open, Width, Length3, Length)
    ).

scalar_length(Value, Length) :-
    write_length(Value, Own, []),
    (   ( number(Value) ; memberchk(Value, [true,false,null]) )
    ->  Length = Own
    ;   Length is Own+2
    ).
