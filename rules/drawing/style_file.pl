:- module(sg_style_file,
          [ style_rows/2,               % +Style, -Rows
            restyled/6,                 % +Rows, +Visib, +Role, +S, +Old, -New
            rows_paper/2,               % +Rows, -Colour
            segment_in_vain/2,          % +Rows, -Segment
            penetration_in_vain/3       % +Rows, +Ss, -Segment
          ]).
:- use_module('../model/model_text',
              [next_term/3, no_fact/2, place_error/2, place_error/3]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../text_file', [with_text/4]).
:- use_module('../store', [segment/3]).
:- use_module(style,
              [ line_type/3, layer_name/1, line_style/4, style_role/1 ]).
:- use_module('../decision', [default/1]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [last/2, member/2]).
/** <module> Style files: how lines look, as facts.

A style file is data, read as model files are: an error has its place. It says
which properties of the style of lines (style.pl) are others:

    line(Visibility, Role, Segment, Properties).
    paper(Colour).

Visibility, Role and Segment may be `any`. Segment is a number, or the name of
a segment or of the primitive it is made from. Properties is a list of
width(Mm), colour(C), colour(Screen,Print), dashes(D), pen(N), layer(Name),
`none` (not drawn) and `shown` (drawn after all). Later facts win.

Each error is model_error(style(What)) with its place; What is fact(Name,
Arity), visibility(V), role(R), segment(S), property(P), properties(L) or
colour(C).
*/

%!  style_rows(+Style, -Rows) is det.
%
%   Rows are the facts of the style file Style, a name; or Style itself, if it
%   is the rows of one already.

style_rows(Rows, Rows) :-
    is_list(Rows),
    !.
style_rows(File, Rows) :-
    with_text(facts, File, Text, text_rows(Text, Rows)).

text_rows(Text, Rows) :-
    next_term(Text, Term, Place),
    (   Term == end_of_file
    ->  Rows = []
    ;   checked_row(Term, Place),
        Rows = [Term|Rows1],
        text_rows(Text, Rows1)
    ).

checked_row(Term, Place) :-
    nonvar(Term),
    row_parts(Term, Parts),
    !,
    forall(member(N-Part, Parts),
           (   part_fault(Part, What)
           ->  place_error(Place, N, style(What))
           ;   true
           )).
checked_row(Term, Place) :-
    no_fact(Term, What),
    (   memberchk(What, [no_fact(_),directive(_),rule(_)])
    ->  place_error(Place, What)
    ;   functor(Term, Name, Arity),
        place_error(Place, style(fact(Name,Arity)))
    ).

%   row_parts(Row, Parts): what is to be checked of its arguments.

row_parts(line(Visibility,Role,Segment,Properties),
          [ 1-visibility(Visibility), 2-role(Role), 3-segment(Segment),
            4-properties(Properties) ]).
row_parts(paper(Colour), [1-colour(Colour)]).

part_fault(properties(Properties), What) =>
    (   ground(Properties),
        is_list(Properties)
    ->  member(Property, Properties),
        \+ is_property(Property),
        property_fault(Property, What)
    ;   What = properties(Properties)
    ).
part_fault(Part, What) =>
    \+ part_is_right(Part),
    What = Part.

%   property_fault(Property, What): of a colour it is said which there are.

property_fault(Property, What) :-
    (   compound(Property),
        compound_name_arguments(Property, colour, Colours),
        length(Colours, N),
        N =< 2,
        member(Colour, Colours),
        \+ is_colour(Colour)
    ->  What = colour(Colour)
    ;   What = property(Property)
    ).

part_is_right(visibility(Visibility)) :-
    nonvar(Visibility),
    memberchk(Visibility, [visible,hidden,any]).
part_is_right(role(Role)) :-
    atom(Role),
    (   Role == any
    ;   style_role(Role)
    ),
    !.
part_is_right(segment(Segment)) :-
    ground(Segment).
part_is_right(colour(Colour)) :-
    is_colour(Colour).

is_property(width(Width)) :-
    number(Width),
    Width > 0,
    Width =< 100.
is_property(colour(Colour)) :-
    is_colour(Colour).
is_property(colour(Screen,Print)) :-
    is_colour(Screen),
    is_colour(Print).
is_property(dashes(Dashes)) :-
    is_dashes(Dashes).
is_property(pen(Pen)) :-
    integer(Pen),
    Pen >= 1,
    Pen =< 255.
is_property(layer(Layer)) :-
    layer_name(Layer).
is_property(none).
is_property(shown).

is_colour(Colour) :-
    nonvar(Colour),
    ( atom(Colour) ; Colour = rgb(_,_,_) ),
    colour_rgb(Colour, _),
    !.

is_dashes(solid) :-
    !.
is_dashes(Type) :-
    atom(Type),
    !,
    line_type(Type, 1, _),
    !.
is_dashes(Runs) :-
    is_list(Runs),
    length(Runs, N),
    N > 0,
    N mod 2 =:= 0,
    forall(member(Run, Runs), ( number(Run), Run > 0, Run =< 1000 )).

%!  restyled(+Rows, +Visibility, +Role, +Segment, +Style0, -Style) is det.
%
%   Style is Style0, of such a line, with the properties that Rows change.

restyled(Rows, Visibility, Role, S, Style0, Style) :-
    foldl(row_applied(line(Visibility,Role,S)), Rows, Style0, Style).

row_applied(Line, Row, Style0, Style) :-
    (   row_matches(Row, Line, Properties)
    ->  foldl(property_set(Line), Properties, Style0, Style)
    ;   Style = Style0
    ).

row_matches(line(Visibility0,Role0,S0,Properties), line(Visibility,Role,S),
            Properties) :-
    is_or_any(Visibility0, Visibility),
    is_or_any(Role0, Role),
    (   is_or_any(S0, S)
    ->  true
    ;   segment_is_called(S, S0)
    ).

is_or_any(any, _) :-
    !.
is_or_any(Value, Value).

%!  segment_in_vain(+Rows, -Segment) is nondet.
%
%   True when Rows have a line for Segment, a number or a name, and no segment
%   of the model has it. 0 is what is on the sheet but not of the model.

segment_in_vain(Rows, Segment) :-
    member(line(_,_,Segment,_), Rows),
    Segment \== any,
    Segment \== 0,
    \+ segment(Segment, _, _),
    \+ segment_is_called(_, Segment).

%!  penetration_in_vain(+Rows, +Ss, -Segment) is nondet.
%
%   True when Rows have a line for the penetration lines of Segment, which the
%   model has, and it is none of Ss, the segments as whose lines some are
%   drawn.

penetration_in_vain(Rows, Ss, Segment) :-
    member(line(_,penetration,Segment,_), Rows),
    Segment \== any,
    \+ segment_in_vain([line(any,any,Segment,[])], Segment),
    \+ ( member(S, Ss), ( S == Segment ; segment_is_called(S, Segment) ) ).

segment_is_called(S, Name) :-
    segment(S, _, Term),
    term_is_called(Term, Name).

%   A name, or the functor of what the segment is made from.

term_is_called(Name, Name) :-
    !.
term_is_called(named(Name,_), Name) :-
    !.
term_is_called(named(_,Term), Name) :-
    !,
    term_is_called(Term, Name).
term_is_called(at(_,Term), Name) :-
    !,
    term_is_called(Term, Name).
term_is_called(Term, Name) :-
    atom(Name),
    compound(Term),
    compound_name_arity(Term, Name, _).

property_set(_, none, _, none) :-
    !.
property_set(line(Visibility,Role,S), Property, none, Style) :-
    !,
    once(default(line_style(Visibility, Role, S, Style0))),
    (   Property == shown
    ->  Style = Style0
    ;   Style = none
    ).
property_set(_, Property, Style0, Style) :-
    property_changed(Property, Style0, Style).

property_changed(shown, Style, Style).
property_changed(width(W), style(_,C,D,P,L), style(W,C,D,P,L)).
property_changed(colour(C), style(W,_,D,P,L), style(W,C,D,P,L)).
property_changed(colour(A,B), style(W,_,D,P,L), style(W,colour(A,B),D,P,L)).
property_changed(dashes(D), style(W,C,_,P,L), style(W,C,D,P,L)).
property_changed(pen(P), style(W,C,D,_,L), style(W,C,D,P,L)).
property_changed(layer(L), style(W,C,D,P,_), style(W,C,D,P,L)).

%!  rows_paper(+Rows, -Colour) is semidet.
%
%   True when Rows say that the paper has this Colour.

rows_paper(Rows, Colour) :-
    findall(Colour0, member(paper(Colour0), Rows), Colours),
    last(Colours, Colour).
